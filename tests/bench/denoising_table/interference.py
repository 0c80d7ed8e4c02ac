"""What sounds beside drilling: steady noise, falling stones, speech, gusts. Two seconds or more at 48 kHz, RMS 1."""
import numpy as np
from scipy.signal import butter, sosfilt

from verdict_table.sounds import RATE, coloured, level


def steady(draw, samples):
    return level(coloured(draw, draw.standard_normal(samples)))


def stones(draw, samples):
    """Six impacts a second at random times, each dying away within 20 to 60 ms, over steady noise."""
    x = np.zeros(samples + RATE)
    for at in draw.integers(0, samples, draw.poisson(6 * samples / RATE)):
        length = int(.3 * RATE)
        decay = np.exp(-np.arange(length) / (draw.uniform(.003, .009) * RATE))
        x[at:at + length] += draw.lognormal(0, .5) * decay * draw.standard_normal(length)
    return level(level(coloured(draw, x[:samples])) + steady(draw, samples))


def speech(draw, samples):
    """Four voiced syllables a second with a gliding pitch and three formants, over noise 8 dB below."""
    t = np.arange(samples) / RATE
    pitch = draw.uniform(100, 210) * (1 + .18 * np.sin(2 * np.pi * .7 * t + draw.uniform(0, 6)))
    phase = 2 * np.pi * np.cumsum(pitch) / RATE
    voice = sum(np.cos(h * phase) / h for h in range(1, 25))
    formants = [butter(1, (f / 1.12, f * 1.12), 'band', fs=RATE, output='sos') for f in (500 * draw.uniform(.8, 1.3), 1400 * draw.uniform(.7, 1.4), 2500)]
    voice = .1 * voice + sum(sosfilt(band, voice) for band in formants)
    syllable = np.clip(np.sin(2 * np.pi * draw.uniform(3.5, 4.5) * t + draw.uniform(0, 6)) + .3, 0, None)
    return level(level(voice * syllable) + .4 * steady(draw, samples))


def gusts(draw, samples):
    """Low-frequency wind that swells and fades within a second, over steady noise 10 dB below."""
    t = np.arange(samples) / RATE
    wind = sosfilt(butter(2, 70, fs=RATE, output='sos'), draw.standard_normal(samples))
    return level(level(wind * (1 + .8 * np.sin(2 * np.pi * draw.uniform(.4, .9) * t + draw.uniform(0, 6)))) + .3 * steady(draw, samples))


KINDS = {'steady': steady, 'stones': stones, 'speech': speech, 'gusts': gusts}
