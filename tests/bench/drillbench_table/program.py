"""Calls of the rigsound binary, and the files they read and write."""
import csv
import json
import os
import shutil
import subprocess
import warnings

import numpy as np
from scipy.io import wavfile


def wave_of(path):
    """Rate and one channel, full scale 1."""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        rate, x = wavfile.read(path)
    if x.dtype.kind == 'i':
        x = x / (np.iinfo(x.dtype).max + 1)
    return rate, x.astype(float) if x.ndim == 1 else x.mean(1)


def read_wave(path):
    rate, x = wave_of(path)
    assert rate == 48000, path
    return x


def write_wave(path, x):
    wavfile.write(path, 48000, x.astype(np.float32))


def read_csv(path_or_lines):
    lines = open(path_or_lines) if isinstance(path_or_lines, str) else path_or_lines
    return list(csv.DictReader(lines))


class Program:
    """One rigsound binary. Every call returns (stdout, user CPU seconds); a failing call raises unless `allowed`."""

    def __init__(self, binary):
        self.binary = binary

    def run(self, *arguments, allowed=(0,)):
        process = subprocess.Popen([self.binary, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        out, err = process.stdout.read(), process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode not in allowed:
            raise RuntimeError('%s\nended with %d\n%s' % (' '.join(map(str, arguments)), process.returncode, err))
        return out, usage.ru_utime

    def simulate(self, folder, clip, seconds, snrs=(), rate_factor=1):
        """Makes clip files; returns T_0, N_a, alpha_a and alpha_d of the truth."""
        arguments = ['simulate', '--out', folder, '--ids', clip, '--seconds', seconds, '--rate-factor', rate_factor]
        if snrs:
            arguments += ['--snr=' + ','.join('%g' % s for s in snrs)]
        out, _ = self.run(*arguments)
        return {k: float(v) for k, v in (word.split('=') for word in out.split()[1:])}

    def clicks(self, recording, *options):
        out, cpu = self.run('clicks', recording, '--jobs', 1, *options)
        rows = read_csv(out.splitlines())
        return np.array([float(r['time_s']) for r in rows]), np.array([float(r['amplitude']) for r in rows]), cpu

    def denoise(self, recording, output, *options):
        return self.run('denoise', recording, output, '--jobs', 1, *options)[1]

    def kernels(self):
        """Figures of nmf_bench, built beside the binary."""
        bench = os.path.normpath(os.path.join(os.path.dirname(self.binary), '..', 'tests', 'bench', 'nmf_bench'))
        if not os.path.exists(bench):
            raise SystemExit('%s: not built, expected beside the binary' % bench)
        return json.loads(subprocess.run([bench, '--json'], capture_output=True, text=True, check=True).stdout)

    def analyze(self, recording, sound_set, *options):
        """The one bank of `recording`: its folder and bank.json, or None when there is none."""
        shutil.rmtree(sound_set, ignore_errors=True)
        out, _ = self.run('analyze', recording, '--out', sound_set, '--jobs', 1, *options, allowed=(0, 1))
        if not out.strip():
            return None, None
        folder = os.path.join(sound_set, 'banks', out.split()[0])
        with open(os.path.join(folder, 'bank.json')) as file:
            return folder, json.load(file)

    def resynth(self, bank, output, seconds, seed, *options):
        """The sound and the times of its blows."""
        self.run('resynth', bank, output, '--seconds', seconds, '--seed', seed, '--impacts', output + '.csv', *options)
        return read_wave(output), np.array([float(r['time_s']) for r in read_csv(output + '.csv')])
