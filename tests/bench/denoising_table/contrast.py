"""How far clicks stand out of what lies between them, octave by octave."""
import numpy as np

OCTAVES_HZ = (250, 500, 1000, 2000, 4000, 8000)  # lower edges
WINDOW_S, BEFORE_S = .01, .002
VALLEY, PAUSE = .75, 2  # median gaps after the last click


def places(times, samples, rate):
    """Masks of the samples in click windows, in valleys between clicks, and in pauses of two gaps and more."""
    n = np.arange(samples) / rate
    gap = np.median(np.diff(times))
    last = np.searchsorted(times, n, side='right') - 1
    since = np.where(last >= 0, n - times[np.maximum(last, 0)], np.inf)
    until = np.append(times, np.inf)[last + 1] - n
    quiet = until > BEFORE_S
    return (since < min(WINDOW_S, gap / 2)), (since > VALLEY * gap) & (since < PAUSE * gap) & quiet, (since >= PAUSE * gap) & quiet


def octave(x, low_hz, rate):
    spectrum, f = np.fft.rfft(x), np.fft.rfftfreq(len(x), 1 / rate)
    spectrum[(f < low_hz) | (f >= 2 * low_hz)] = 0
    return np.fft.irfft(spectrum, len(x))


def contrast_db(x, rate, times):
    """Click windows over valleys and over pauses, dB an octave; NaN where there are no pauses or no such octave."""
    clicks, valleys, pauses = places(times, len(x), rate)
    rows = []
    for low in OCTAVES_HZ:
        power = octave(x, low, rate) ** 2
        here = [10 * np.log10(power[clicks].mean() / (power[m].mean() + 1e-20)) if m.sum() > .1 * rate else np.nan for m in (valleys, pauses)]
        rows.append(here if 1.9 * low < rate / 2 else [np.nan, np.nan])
    return np.array(rows).T


def gain_db(before, after, rate, times):
    """What denoising adds to the contrast: (valleys, pauses) x octaves."""
    return contrast_db(after, rate, times) - contrast_db(before, rate, times)
