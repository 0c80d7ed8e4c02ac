"""A small sound set, written from the description of its files and by nothing of rigsound."""
import json
import math
import pathlib
import struct

SITUATIONS = ('normal', 'underfeed', 'overfeed', 'closed_rattling', 'open_rattling')


def click(rate, frequency_hz):
    samples = [math.exp(-i / (0.004 * rate)) * math.sin(2 * math.pi * frequency_hz * i / rate)
               for i in range(int(0.03 * rate))]
    norm = math.sqrt(sum(x * x for x in samples))
    return [x / norm for x in samples]


def write_clicks(path, clicks, rate):
    starts = [sum(len(c) for c in clicks[:i]) for i in range(len(clicks))]
    cues = b''.join(struct.pack('<II4sIII', i + 1, s, b'data', 0, 0, s) for i, s in enumerate(starts))
    data = b''.join(struct.pack(f'<{len(c)}f', *c) for c in clicks)
    chunks = [(b'fmt ', struct.pack('<HHIIHH', 3, 1, rate, rate * 4, 4, 32)),
              (b'cue ', struct.pack('<I', len(clicks)) + cues), (b'data', data)]
    body = b'WAVE' + b''.join(name + struct.pack('<I', len(text)) + text for name, text in chunks)
    path.write_bytes(b'RIFF' + struct.pack('<I', len(body)) + body)


def write_bank(folder, rate, rate_hz, frequency_hz, **changes):
    folder.mkdir(parents=True)
    numbers = dict(format=1, sample_rate=rate, T0=rate / rate_hz, sigma_T=0.04 * rate / rate_hz, r_T=0.0, p_miss=0.0,
                   p_double=0.0, B=0.5, sigma_B=0.05, r_B=0.0, N_a=10, alpha_a=0.0, alpha_d=0.005, gain_db=0.0,
                   source_file='none', source_sha256='', settings='', tool_version='test')
    (folder / 'bank.json').write_text(json.dumps({**numbers, **changes}, indent=1))
    write_clicks(folder / 'clicks.wav', [click(rate, frequency_hz + 40 * i) for i in range(6)], rate)


def write_sound_set(folder, rate=48000):
    folder = pathlib.Path(folder)
    lines = ['format = 1']
    for i, situation in enumerate(SITUATIONS):
        write_bank(folder / 'banks' / situation, rate, 30 + 3 * i, 900 + 300 * i)
        lines += ['[[bank]]', f'name = "{situation}"', f'situation = "{situation}"']
    (folder / 'soundset.toml').write_text('\n'.join(lines) + '\n')
    return folder
