"""Sounds that pulse or hiss and are no percussive drilling."""
import numpy as np
from scipy.signal import butter, sosfilt

from .sounds import LENGTH, RATE, coloured, diesel, hiss, level, pulses, resonant, talk


def idling(stream):
    """Cylinders that differ and come round with every cycle. Of one or two, no figure tells them from a breaker."""
    cylinders, cycle_hz = stream.choice([3, 4, 6, 8, 10]), stream.uniform(5, 12)
    length = int(RATE * min(.2, 1.2 / (cycle_hz * cylinders)))
    n = np.arange(length)
    shape = np.minimum(n / (RATE * stream.uniform(.001, .006)), 1) * np.exp(-n / (length * stream.uniform(.1, .5)))
    body, alike = shape * stream.standard_normal(length), stream.uniform(.3, .9)
    firing = np.clip(1 + .35 * stream.standard_normal(cylinders), .2, None)
    y = np.zeros(LENGTH + length)
    for k in range(int(2 * cycle_hz * cylinders)):
        p = int((k / cylinders + .004 * stream.standard_normal()) / cycle_hz * RATE)
        if p >= 0:
            y[p:p + length] += firing[k % cylinders] * (alike * body + (1 - alike) * shape * stream.standard_normal(length))
    y = sosfilt(butter(1, stream.uniform(300, 2500) / (RATE / 2), output='sos'), y[:LENGTH])
    return level(level(y) + stream.uniform(.1, .6) * level(coloured(stream, stream.standard_normal(LENGTH))))


def creaking(stream):
    """Stick-slip: slips ever faster or slower that ring alike."""
    rate = stream.uniform(7, 20) * (1 + stream.uniform(.15, .4) * stream.choice([-1, 1]) * np.linspace(-1, 1, LENGTH))
    slips = np.flatnonzero(np.diff(np.floor(np.cumsum(rate) / RATE))) / RATE
    return level(level(resonant(stream, slips, 300, 4000, stream.uniform(.01, .06), 6)) + .05 * hiss(stream))


def rotary(stream):
    t = np.arange(LENGTH) / RATE
    turn = 2 * np.pi * stream.uniform(20, 60) * t
    whine = sum(np.sin(k * turn + k) / np.sqrt(k) for k in (1, 2, 7, 14, 23, 44))
    return level(whine + (1 + .6 * np.sin(turn)) * stream.standard_normal(LENGTH))


def rain_of_stones(stream):
    n = np.arange(int(.06 * RATE))
    return level(coloured(stream, pulses(stream, np.sort(stream.uniform(0, 1.95, stream.integers(15, 60))), np.exp(-n / 700), .6)) + .02 * hiss(stream))


def tune(stream):
    """Notes with decays on a beat."""
    t = np.arange(LENGTH) / RATE
    beat = stream.uniform(4, 9)
    note, age = np.floor(t * beat).astype(int), np.mod(t * beat, 1) / beat
    hz = 220 * 2 ** (stream.integers(0, 15, 24)[note] / 12)
    return level(sum(np.sin(2 * np.pi * k * np.cumsum(hz) / RATE) / k * np.exp(-6 * age * k ** .5) for k in range(1, 9)) + .003 * hiss(stream))


def humming(stream):
    """Harmonics of the mains, or of a fan or a saw, under some hiss."""
    t, hz = np.arange(LENGTH) / RATE, stream.uniform(30, 120)
    hum = sum(np.exp(.7 * stream.standard_normal()) / k ** stream.uniform(.3, 1) * np.sin(2 * np.pi * hz * k * t + stream.uniform(0, 6.28))
              for k in range(1, 30))
    return level(level(hum) + stream.uniform(.02, .3) * hiss(stream))


def vowel(stream):
    """A voice that hardly moves: a pulse of two formants at every period of 90 to 240 Hz."""
    t = np.arange(LENGTH) / RATE
    hz = stream.uniform(90, 240)
    phase = hz * t + stream.uniform(0, .02) * hz * np.sin(2 * np.pi * stream.uniform(2, 5) * t)
    age = np.mod(phase, 1) / hz
    formants = sum(a * np.exp(-d * age) * np.sin(2 * np.pi * f * age) for a, d, f in
                   ((1, stream.uniform(250, 500), stream.uniform(400, 800)), (.6, stream.uniform(400, 700), stream.uniform(1200, 2200))))
    return level(formants * np.maximum(0, .6 + np.sin(2 * np.pi * stream.uniform(1.5, 3) * t)) ** .5 + .005 * hiss(stream))


KINDS = {
    'noise': lambda stream: level(coloured(stream, stream.standard_normal(LENGTH))), 'diesel': diesel, 'voice': lambda stream: talk(stream) + .01 * hiss(stream),
    **{'idling %d' % k: idling for k in range(1, 7)}, 'creak 1': creaking, 'creak 2': creaking, 'rotary drill': rotary,
    'falling stones': rain_of_stones, 'tune': tune, 'hum 1': humming, 'hum 2': humming, **{'vowel %d' % k: vowel for k in range(1, 4)},
}
