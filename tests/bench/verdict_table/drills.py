"""Percussive drills whose clicks, rooms and backgrounds are other than the simulator's."""
import os
import subprocess
import tempfile

import numpy as np
from scipy.io import wavfile
from scipy.signal import butter, fftconvolve, sosfilt

from .sounds import LENGTH, RATE, coloured, diesel, level, pulses, resonant, talk, times


def decaying(rate):
    n = np.arange(int(RATE * min(.4, 2.5 / rate)))
    return np.minimum(n / 40, 1) * 10 ** (-25 / 20 * np.maximum(n - 40, 0) * rate / RATE)


def swelling(rate):
    t = np.arange(int(RATE * min(.4, 2 / rate))) / RATE * rate / .07
    return t ** 2 * np.exp(-t) / (4 * np.exp(-2))


def two_decays(rate):
    n = np.arange(int(RATE * min(.4, 3 / rate))) * rate / RATE
    return 10 ** (-4.5 * n) + .25 * 10 ** (-.45 * n)


def any_rate(stream, low=14, high=48):
    return float(np.exp(stream.uniform(np.log(low), np.log(high))))


def struck(stream, rate, shape=decaying):
    return level(coloured(stream, pulses(stream, times(stream, rate), shape(rate))))


def before(stream, drilling, background, snr_db):
    return drilling + background * 10 ** (-snr_db / 20)


def plain(low, high, snr_db, shape=decaying):
    def make(stream):
        return before(stream, struck(stream, any_rate(stream, low, high), shape), diesel(stream), snr_db)
    return make


def modal(stream):
    rate = any_rate(stream, 14, 40)
    return before(stream, level(resonant(stream, times(stream, rate), 150, 900, 6 / rate)), diesel(stream), 0)


def in_a_room(seconds):
    def make(stream):
        n = np.arange(int(RATE * seconds))
        room = stream.standard_normal(len(n)) * 10 ** (-3 * n / len(n))
        room[:200] = 0
        room *= 1 / np.sqrt(np.sum(room ** 2))
        room[0] = 1
        return before(stream, level(fftconvolve(struck(stream, any_rate(stream)), room)[:LENGTH]), diesel(stream), 0)
    return make


def double(stream):
    first = times(stream, stream.uniform(7, 11))
    both = np.sort(np.concatenate([first, first + stream.uniform(.02, .03)]))
    return before(stream, level(coloured(stream, pulses(stream, both, decaying(30)))), diesel(stream), 6)


def gliding(stream):
    """Spinning up or down by a third to two thirds within the clip, irregular as ever."""
    rate = any_rate(stream, 20, 40) * (1 + stream.uniform(.15, .3) * stream.choice([-1, 1]) * np.linspace(-1, 1, LENGTH))
    at = np.flatnonzero(np.diff(np.floor(np.cumsum(rate) / RATE))) / RATE
    at = np.sort(at + .04 * stream.standard_normal(len(at)) / 30)
    return before(stream, level(coloured(stream, pulses(stream, at[(at > 0) & (at < 1.99)], decaying(30)))), diesel(stream), 6)


def burst(stream):
    at = times(stream, any_rate(stream, 20, 45))
    at = at[(at > .3) & (at < 1.3)]
    return before(stream, level(coloured(stream, pulses(stream, at, decaying(35)))), diesel(stream), 6)


def among_stones(stream):
    stones = pulses(stream, np.sort(stream.uniform(0, 2, 12)), decaying(40))
    return before(stream, struck(stream, any_rate(stream)), level(diesel(stream) + level(coloured(stream, stones))), 3)


def two_machines(stream):
    slow, ratio = any_rate(stream, 15, 30), stream.uniform(1.3, 1.8)
    both = struck(stream, slow) + 10 ** (-stream.uniform(0, 6) / 20) * struck(stream, slow * ratio)
    return before(stream, level(both), diesel(stream), 6)


def beside_talk(stream):
    return before(stream, struck(stream, any_rate(stream)), level(talk(stream) + .5 * diesel(stream)), 3)


def clipped(stream):
    x = plain(14, 48, 0)(stream)
    most = np.quantile(np.abs(x), .95)
    return np.clip(x, -most, most)


def dull(stream):
    return sosfilt(butter(8, 5000 / (RATE / 2), output='sos'), plain(14, 48, 0)(stream))


def coded(stream):
    """As an MP3 of few bits leaves it: what its bands hide, and all above 11 kHz, is gone."""
    with tempfile.TemporaryDirectory(prefix='verdict-') as folder:
        sound, mp3 = os.path.join(folder, 'sound.wav'), os.path.join(folder, 'sound.mp3')
        wavfile.write(sound, RATE, np.round(3000 * level(plain(14, 48, 0)(stream))).clip(-32767, 32767).astype(np.int16))
        subprocess.run(['lame', '--quiet', '-m', 'm', '-b', '64', sound, mp3], check=True)
        subprocess.run(['lame', '--quiet', '--decode', mp3, sound], check=True)
        return wavfile.read(sound)[1][:LENGTH].astype(float)


KINDS = {
    'drill 0 dB': plain(14, 48, 0), 'drill 6 dB': plain(14, 48, 6), 'breaker 3-8 Hz': plain(3.2, 8, 6),
    'drifter 60-120 Hz': plain(60, 118, 6), 'swelling clicks': plain(14, 40, 3, swelling), 'two decays': plain(14, 48, 0, two_decays),
    'modal 150-900 Hz': modal, 'cabin': in_a_room(.15), 'tunnel': in_a_room(1), 'double impacts': double, 'gliding': gliding, 'burst': burst,
    'stones': among_stones, 'talk': beside_talk, 'clipped': clipped, 'dull': dull, 'MP3': coded,
    'two machines': two_machines,
}
