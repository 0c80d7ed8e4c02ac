"""The best that a mask on the short-time spectrum can do with the truth at hand."""
import numpy as np
from scipy import signal

SHAPE = dict(window='hann', nperseg=512, noverlap=384)


def spectrum(x):
    return signal.stft(x, **SHAPE)[2]


def masked(mix, clean):
    """The ratio mask |S|^2 / (|S|^2 + |N|^2) of the true parts, on the mix."""
    S, N = np.abs(spectrum(clean)) ** 2, np.abs(spectrum(mix - clean)) ** 2
    return signal.istft(spectrum(mix) * S / (S + N + 1e-18), **SHAPE)[1][:len(mix)]
