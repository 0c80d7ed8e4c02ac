"""What drills and other sounds of the corpus are made of. 2 s at 48 kHz; `stream`: a numpy generator."""
import numpy as np
from scipy.signal import butter, iirpeak, lfilter, sosfilt

RATE, LENGTH = 48000, 96000


def level(x):
    """Of RMS 1."""
    return x / np.sqrt(np.mean(x ** 2))


def coloured(stream, x):
    """Through a high-pass, a low-pass and a few resonances drawn at random."""
    x = sosfilt(butter(1, np.exp(stream.uniform(np.log(2500), np.log(9000))) / (RATE / 2), output='sos'), x)
    x = sosfilt(butter(2, np.exp(stream.uniform(np.log(60), np.log(150))) / (RATE / 2), 'high', output='sos'), x)
    for _ in range(3):
        b, a = iirpeak(np.exp(stream.uniform(np.log(300), np.log(7000))), stream.uniform(1, 5), fs=RATE)
        x = x + stream.uniform(.5, 2) * lfilter(b, a, x)
    return x


def times(stream, rate, jitter=.04):
    """Of impacts, a renewal process."""
    gaps = np.maximum(.35, 1 + jitter * stream.standard_normal(int(2.5 * rate) + 4)) / rate
    at = stream.uniform(0, .5 / rate) + np.cumsum(gaps) - gaps[0]
    return at[at < 1.99]


def pulses(stream, at, shape, spread=.2):
    """Noise in the given envelope at each time, amplitudes drawn."""
    y = np.zeros(LENGTH + len(shape))
    for t in at:
        p = int(t * RATE)
        y[p:p + len(shape)] += max(.25, 1 + spread * stream.standard_normal()) * shape * stream.standard_normal(len(shape))
    return y[:LENGTH]


def resonant(stream, at, low_hz, high_hz, ring_s, modes=25):
    """Impacts on a body: each mode a resonator that rings for about ring_s (to -60 dB)."""
    hits = np.zeros(LENGTH)
    hits[(np.asarray(at) * RATE).astype(int)] = np.maximum(.25, 1 + .2 * stream.standard_normal(len(at)))
    y = np.zeros(LENGTH)
    for hz in np.exp(stream.uniform(np.log(low_hz), np.log(high_hz), modes)):
        pole = 10 ** (-3 / (RATE * ring_s * stream.uniform(.6, 1.4)))
        w = 2 * np.pi * hz / RATE
        y += 10 ** (stream.standard_normal() / 4) * lfilter([np.sin(w)], [1, -2 * pole * np.cos(w), pole ** 2], hits * (1 + .2 * stream.standard_normal(LENGTH)))
    return y


def hiss(stream):
    return level(sosfilt(butter(1, stream.uniform(500, 1500) / (RATE / 2), output='sos'), stream.standard_normal(LENGTH)))


def diesel(stream):
    """Half orders of a four-stroke six at a steady speed, hydraulics, a floor."""
    turn = 2 * np.pi * stream.uniform(1400, 2100) / 120 * np.arange(LENGTH) / RATE
    orders = sum(h ** -.8 * 10 ** (stream.standard_normal() / 4) * (3 if h % 6 == 0 else 1) * np.cos(h * turn + stream.uniform(0, 6.28))
                 for h in range(1, 120))
    return level(level(orders) + hiss(stream) + .06 * stream.standard_normal(LENGTH))


def talk(stream):
    """Voiced syllables, four a second."""
    t = np.arange(LENGTH) / RATE
    phase = 2 * np.pi * np.cumsum(stream.uniform(100, 180) * (1 + .2 * np.sin(2 * np.pi * .7 * t + stream.uniform(0, 6)))) / RATE
    voice = sum(np.cos(h * phase) / h for h in range(1, 25))
    for hz in (500, 1400, 2500):
        b, a = iirpeak(hz * stream.uniform(.8, 1.2), 4, fs=RATE)
        voice = voice + 3 * lfilter(b, a, voice)
    return level(voice * np.clip(np.sin(2 * np.pi * stream.uniform(3.5, 4.5) * t + stream.uniform(0, 6)) + .3, 0, None))
