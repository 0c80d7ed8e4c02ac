"""Scores of DrillBench: denoising, click detection, synthesis. Signals are float arrays at 48 kHz, times are seconds."""
import numpy as np

RATE = 48000


# ---- denoising

def si_sdr_db(clean, estimate):
    """Scale-invariant signal-to-distortion ratio."""
    scale = np.dot(estimate, clean) / np.dot(clean, clean)
    target = scale * clean
    return 10 * np.log10(np.sum(target ** 2) / (np.sum((estimate - target) ** 2) + 1e-30))


# ---- clicks

def match(found, truth, tolerance):
    """Largest one-to-one matching of two sorted lists of times: pairs of indices."""
    pairs, i, j = [], 0, 0
    while i < len(found) and j < len(truth):
        distance = found[i] - truth[j]
        if abs(distance) <= tolerance:
            pairs.append((i, j))
            i, j = i + 1, j + 1
        elif distance < 0:
            i += 1
        else:
            j += 1
    return pairs


def f_measure(found, truth, tolerance):
    hits = len(match(found, truth, tolerance))
    precision, recall = hits / max(len(found), 1), hits / max(len(truth), 1)
    return 2 * precision * recall / max(precision + recall, 1e-9)


def best_offset(found, truth):
    """Constant offset within 12 ms that gives the best F at 2 ms, refined to the median of the matched errors."""
    offsets = sorted(np.arange(-48, 49) * 0.25e-3, key=abs)
    best = max(offsets, key=lambda o: round(f_measure(found - o, truth, 2e-3), 9))
    pairs = match(found - best, truth, 5e-3)
    return float(np.median([found[i] - truth[j] for i, j in pairs])) if pairs else best


def click_scores(found, amplitudes, truth, true_amplitudes):
    """F at 2 ms with and without a constant offset, median timing error (us) and median amplitude error (dB)."""
    if len(found) == 0:
        return dict(F2c=0.0, F2=0.0, timing_us=np.nan, amplitude_db=np.nan)
    offset = best_offset(found, truth)
    shifted = found - offset
    pairs = match(shifted, truth, 5e-3)
    timing = [abs(shifted[i] - truth[j]) for i, j in pairs]
    level = np.array([20 * np.log10(max(amplitudes[i], 1e-9) / true_amplitudes[j]) for i, j in pairs])
    return dict(F2c=f_measure(shifted, truth, 2e-3), F2=f_measure(found, truth, 2e-3),
                timing_us=1e6 * float(np.median(timing)) if timing else np.nan,
                amplitude_db=float(np.median(np.abs(level - np.median(level)))) if pairs else np.nan)


# ---- synthesis

def bands(power, frequency, centres, floor):
    edge = 2 ** (1 / 6)
    return np.array([10 * np.log10(power[(frequency >= c / edge) & (frequency < c * edge)].sum() + floor) for c in centres])


def third_octave_db(x, size=8192):
    """Long-time average spectrum, 62.5 Hz to 16 kHz."""
    window = np.hanning(size)
    starts = range(0, len(x) - size + 1, size // 2)
    power = sum(np.abs(np.fft.rfft(x[s:s + size] * window)) ** 2 for s in starts) / (len(starts) * np.sum(window ** 2))
    return bands(power, np.fft.rfftfreq(size, 1 / RATE), 1000 * 2.0 ** (np.arange(-12, 13) / 3), 1e-20)


def modulation_db(x, hop=48):
    """Spectrum of the 1 ms envelope over its mean, third-octave bands of 1 to 256 Hz."""
    n = len(x) // hop
    envelope = np.sqrt((x[:n * hop] ** 2).reshape(n, hop).mean(1))
    envelope = envelope / envelope.mean() - 1
    window = np.hanning(n)
    power = np.abs(np.fft.rfft(envelope * window)) ** 2 / np.sum(window ** 2) / n * 2
    return bands(power, np.fft.rfftfreq(n, hop / RATE), 2.0 ** (np.arange(25) / 3), 1e-7)


def crest_db(x):
    return 20 * np.log10(np.quantile(np.abs(x), .9999) / np.sqrt(np.mean(x ** 2)))


def gap_distance(truth, synthetic):
    """Wasserstein distance of the two gap distributions, per cent of the median gap."""
    q = np.linspace(.005, .995, 200)
    a, b = np.diff(truth), np.diff(synthetic)
    return 100 * float(np.mean(np.abs(np.quantile(a, q) - np.quantile(b, q)))) / float(np.median(a))


def audible(original, noise):
    """Bands from 200 Hz in which the drilling was at most 5 dB below the noise it was learned in."""
    return (third_octave_db(original) - third_octave_db(noise) >= -5) & (np.arange(25) >= 5)


def ltas_distance(original, synthetic, where=True):
    """Mean difference of the third-octave levels within 50 dB of the loudest, their mean taken away."""
    a, b = third_octave_db(original), third_octave_db(synthetic)
    difference = (b - a)[(a > a.max() - 50) & where]
    return float(np.mean(np.abs(difference - difference.mean())))


def synthesis_scores(original, synthetic):
    mod = modulation_db(original), modulation_db(synthetic)
    moving = mod[0] > mod[0].max() - 35
    return dict(level=abs(10 * np.log10(np.mean(synthetic ** 2) / np.mean(original ** 2))),
                ltas=ltas_distance(original, synthetic),
                mod=float(np.mean(np.abs(mod[1] - mod[0])[moving])),
                crest=abs(crest_db(synthetic) - crest_db(original)))
