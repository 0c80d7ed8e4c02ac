"""The best that a mask on the short-time spectrum can do with the truth at hand."""
import numpy as np

WINDOW, HOP = 512, 128
HANN = np.hanning(WINDOW + 1)[:-1]


def stft(x):
    x = np.pad(x, WINDOW)
    at = np.arange(WINDOW)[None] + HOP * np.arange((len(x) - WINDOW) // HOP)[:, None]
    return np.fft.rfft(x[at] * HANN, axis=1)


def inverse(spectrum, samples):
    y = np.zeros(samples + 3 * WINDOW)
    weight = np.zeros_like(y)
    for k, frame in enumerate(np.fft.irfft(spectrum, WINDOW, axis=1)):
        y[k * HOP:k * HOP + WINDOW] += frame * HANN
        weight[k * HOP:k * HOP + WINDOW] += HANN ** 2
    return (y / np.maximum(weight, 1e-6))[WINDOW:WINDOW + samples]


def masked(mix, clean):
    """The ratio mask |S|^2 / (|S|^2 + |N|^2) of the true parts, on the mix."""
    S, N = np.abs(stft(clean)) ** 2, np.abs(stft(mix - clean)) ** 2
    return inverse(stft(mix) * S / (S + N + 1e-12), len(mix))
