"""What sounds beside drilling: steady noise, falling stones, speech, gusts. Two seconds or more at 48 kHz, RMS 1."""
import numpy as np
from scipy.signal import butter, sosfilt

RATE = 48000


def rms_one(x):
    return x / np.sqrt(np.mean(x ** 2))


def coloured(draw, x):
    """A low-pass, a high-pass and four resonances at random places."""
    for kind, edges in (('low', (2500, 9000)), ('high', (60, 150))):
        x = sosfilt(butter(1, np.exp(draw.uniform(*np.log(edges))), kind, fs=RATE, output='sos'), x)
    for centre in np.exp(draw.uniform(np.log(250), np.log(8000), 4)):
        width = centre / draw.uniform(1, 5)
        band = butter(1, (centre - width / 3, centre + width / 3), 'band', fs=RATE, output='sos')
        x = x + draw.uniform(.6, 3) * sosfilt(band, x)
    return x


def steady(draw, samples):
    return rms_one(coloured(draw, draw.standard_normal(samples)))


def stones(draw, samples):
    """Six impacts a second at random times, each dying away within 20 to 60 ms, over steady noise."""
    x = np.zeros(samples + RATE)
    for at in draw.integers(0, samples, draw.poisson(6 * samples / RATE)):
        length = int(.3 * RATE)
        decay = np.exp(-np.arange(length) / (draw.uniform(.003, .009) * RATE))
        x[at:at + length] += draw.lognormal(0, .5) * decay * draw.standard_normal(length)
    return rms_one(rms_one(coloured(draw, x[:samples])) + steady(draw, samples))


def speech(draw, samples):
    """Four voiced syllables a second with a gliding pitch and three formants, over noise 8 dB below."""
    t = np.arange(samples) / RATE
    pitch = draw.uniform(100, 210) * (1 + .18 * np.sin(2 * np.pi * .7 * t + draw.uniform(0, 6)))
    phase = 2 * np.pi * np.cumsum(pitch) / RATE
    voice = sum(np.cos(h * phase) / h for h in range(1, 25))
    formants = [butter(1, (f / 1.12, f * 1.12), 'band', fs=RATE, output='sos') for f in (500 * draw.uniform(.8, 1.3), 1400 * draw.uniform(.7, 1.4), 2500)]
    voice = .1 * voice + sum(sosfilt(band, voice) for band in formants)
    syllable = np.clip(np.sin(2 * np.pi * draw.uniform(3.5, 4.5) * t + draw.uniform(0, 6)) + .3, 0, None)
    return rms_one(rms_one(voice * syllable) + .4 * steady(draw, samples))


def gusts(draw, samples):
    """Low-frequency wind that swells and fades within a second, over steady noise 10 dB below."""
    t = np.arange(samples) / RATE
    wind = sosfilt(butter(2, 70, fs=RATE, output='sos'), draw.standard_normal(samples))
    return rms_one(rms_one(wind * (1 + .8 * np.sin(2 * np.pi * draw.uniform(.4, .9) * t + draw.uniform(0, 6)))) + .3 * steady(draw, samples))


KINDS = {'steady': steady, 'stones': stones, 'speech': speech, 'gusts': gusts}
