#!/usr/bin/env python3
"""draw_timeline.py SOUND.wav STATES.csv OUT.png: waveform and spectrogram over what the machine did.

STATES.csv is what `rigsound decode` prints: time_s,signal,value at each change.
"""
import collections
import csv
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
import numpy as np

COLOURS = {'off': '#d0d0d0', 'idle': '#b8c4d0', 'underfeed': '#7fb3d5', 'normal': '#7dbb7d', 'overfeed': '#e07b6a',
           'closed rattling': '#c9a3d9', 'open rattling': '#8e5ea2'}


def read_float_wav(path):
    """Mono mix of a 32-bit float or 16-bit WAV, and its rate. The standard library refuses float WAVs."""
    data = open(path, 'rb').read()
    if data[:4] != b'RIFF':
        sys.exit(f'{path}: not a WAV file')
    at, kind = 12, None
    while at + 8 <= len(data):
        name, size = data[at:at + 4], int.from_bytes(data[at + 4:at + 8], 'little')
        body = data[at + 8:at + 8 + size]
        if name == b'fmt ':
            kind = int.from_bytes(body[0:2], 'little')
            channels, rate = int.from_bytes(body[2:4], 'little'), int.from_bytes(body[4:8], 'little')
            bits = int.from_bytes(body[14:16], 'little')
        if name == b'data':
            samples = np.frombuffer(body, '<f4') if bits == 32 else np.frombuffer(body, '<i2') / 32768
            return samples.reshape(-1, channels).mean(1), rate
        at += 8 + size + (size & 1)
    sys.exit(f'{path}: no samples')


def read_states(path):
    series = collections.defaultdict(list)
    with open(path, newline='', encoding='utf-8') as file:
        for row in csv.DictReader(file):
            series[row['signal']].append((float(row['time_s']), row['value']))
    return series


def steps(series, end, words=None):
    times = [t for t, _ in series] + [end]
    values = [words[v] if words else float(v) for _, v in series]
    return np.array(times), np.array(values + values[-1:])


def at(series, time, default):
    value = default
    for t, v in series:
        if t > time:
            break
        value = v
    return value


def situation(states, time, under, over):
    if float(at(states['engine_rpm'], time, 0)) < 50:
        return 'off'
    rattling = at(states['rattling'], time, 'none')
    if rattling != 'none':
        return rattling + ' rattling'
    feed = float(at(states['feed_pressure_bar'], time, 0))
    if at(states['percussion'], time, 'on' if feed > 15 else 'off') == 'off':
        return 'idle'
    return 'underfeed' if feed < under else 'overfeed' if feed > over else 'normal'


def spans(states, end, under, over, step=0.1):
    names = [situation(states, t, under, over) for t in np.arange(0, end, step)]
    start = 0
    for i in range(1, len(names) + 1):
        if i == len(names) or names[i] != names[start]:
            yield start * step, min(end, i * step), names[start]
            start = i


def main():
    if len(sys.argv) != 4:
        sys.exit('usage: draw_timeline.py SOUND.wav STATES.csv OUT.png')
    sound, rate = read_float_wav(sys.argv[1])
    states = read_states(sys.argv[2])
    end = len(sound) / rate
    figure, (machine, waveform, spectrum) = plt.subplots(
        3, 1, figsize=(16, 10), sharex=True, height_ratios=(1.1, 1, 2), constrained_layout=True)

    under, over = 60, 120
    for start, stop, name in spans(states, end, under, over):
        for axis in (machine, waveform):
            axis.axvspan(start, stop, color=COLOURS[name], alpha=0.55, lw=0)
        if stop - start > 1.5:
            machine.text((start + stop) / 2, 1.02, name.replace(' ', '\n'), ha='center', va='bottom', fontsize=9,
                         transform=machine.get_xaxis_transform())
    if states['feed_pressure_bar']:
        machine.step(*steps(states['feed_pressure_bar'], end), where='post', color='#a33', label='feed pressure, bar')
    machine.set_ylabel('feed pressure, bar')
    for threshold in (under, over):
        machine.axhline(threshold, color='#a33', lw=0.6, ls=':')
    if states['engine_rpm']:
        speed = machine.twinx()
        speed.step(*steps(states['engine_rpm'], end), where='post', color='#246', lw=1)
        speed.set_ylabel('engine, r/min', color='#246')

    hop = max(1, len(sound) // 4000)
    blocks = sound[:len(sound) // hop * hop].reshape(-1, hop)
    times = np.arange(len(blocks)) * hop / rate
    waveform.fill_between(times, blocks.min(1), blocks.max(1), color='#222', lw=0)
    waveform.set_ylabel('amplitude')
    waveform.set_ylim(-1, 1)
    with np.errstate(divide='ignore'):  # digital silence has no level
        spectrum.specgram(sound, NFFT=2048, Fs=rate, noverlap=1024, cmap='magma', vmin=-130, vmax=-35)
    spectrum.set_facecolor('black')
    spectrum.set_yscale('symlog', linthresh=1000)
    spectrum.set_ylim(0, 20000)
    spectrum.set_yticks([0, 250, 500, 1000, 2000, 5000, 10000, 20000], ['0', '250', '500', '1k', '2k', '5k', '10k', '20k'])
    spectrum.set_ylabel('frequency, Hz')
    spectrum.set_xlabel('time, s')
    spectrum.set_xlim(0, end)
    figure.savefig(sys.argv[3], dpi=100)


main()
