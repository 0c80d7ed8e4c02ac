"""Clips of 2 s whose kind is known: made here, by the simulator, and cut out of what packages hold."""
import collections
import glob
import os
import subprocess
import zlib

import numpy as np
from scipy.io import wavfile

from . import drills, others, packages

Clip = collections.namedtuple('Clip', 'path kind source drilling')

RATE, SECONDS = 48000, 2
SNRS = (-6, 0, 6)


def save(folder, clip, sound, rate=RATE):
    """A clip is found again by its file's name: KIND__SOURCE__NUMBER__drill or __other."""
    kind, source, number, drilling = clip
    path = os.path.join(folder, '%s__%s__%d__%s.wav' % (kind, source, number, 'drill' if drilling else 'other'))
    wavfile.write(path, rate, (.05 * sound / np.sqrt(np.mean(sound ** 2))).astype(np.float32))


def drillbench(folder, binary):
    """The clips of the bench, and their backgrounds; a clip is its own source at every level."""
    made = os.path.join(folder, 'drillbench')
    subprocess.run([binary, 'simulate', '--out', made, '--ids', '100-131', '--seconds', str(SECONDS),
                    '--snr=' + ','.join('%g' % snr for snr in SNRS)], check=True, capture_output=True)
    for path in glob.glob(os.path.join(made, 'c*.wav')):
        clip, what = os.path.basename(path)[:-4].split('_')
        name = {'bg': 'background', 'clean': 'drillbench, clean'}.get(what, 'drillbench at %s dB' % what)
        save(folder, (name, clip, 0, what != 'bg'), wavfile.read(path)[1].astype(float))


def situations(folder, binary):
    """Two windows of every situation the simulator records."""
    made = os.path.join(folder, 'situations')
    subprocess.run([binary, 'simulate', '--out', made, '--seed', '7'], check=True, capture_output=True)
    for path in glob.glob(os.path.join(made, '*_normal*.wav')) + glob.glob(os.path.join(made, '*feed*.wav')) + \
            glob.glob(os.path.join(made, '*rattling*.wav')):
        rate, sound = wavfile.read(path)
        for k in range(min(2, len(sound) // (SECONDS * rate))):
            save(folder, ('situation', os.path.basename(path)[:-4], k, True), sound[k * SECONDS * rate:][:SECONDS * rate].astype(float), rate)


def made_here(folder, seeds):
    for table, drilling in ((drills.KINDS, True), (others.KINDS, False)):
        for kind, make in table.items():
            for seed in range(seeds):
                stream = np.random.default_rng(zlib.crc32(('%s/%d' % (kind, seed)).encode()))
                save(folder, (kind, '%s %d' % (kind, seed), 0, drilling), make(stream))


def from_packages(folder, where):
    for kind, source, drilling, rate, sound in packages.sounds(where):
        length = SECONDS * rate
        if len(sound) < length:
            sound = np.tile(sound, length // len(sound) + 1)[:length]
        for k, start in enumerate(range(0, len(sound) - length + 1, 2 * length)[:2]):
            piece = sound[start:start + length]
            if np.sqrt(np.mean(piece ** 2)) > 1e-3:
                save(folder, (kind, source, k, drilling), piece, rate)


def clips(folder, binary, where, seeds):
    ready = os.path.join(folder, 'ready')
    if not os.path.exists(ready):
        os.makedirs(folder, exist_ok=True)
        drillbench(folder, binary)
        situations(folder, binary)
        made_here(folder, seeds)
        if where:
            from_packages(folder, where)
        open(ready, 'w').close()
    found = []
    for path in sorted(glob.glob(os.path.join(folder, '*__*__*__*.wav'))):
        kind, source, _, what = os.path.basename(path)[:-4].split('__')
        found.append(Clip(path, kind, source, what == 'drill'))
    return found
