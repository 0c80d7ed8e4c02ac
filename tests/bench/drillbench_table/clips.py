"""What is measured on one clip. Every function runs in its own process and returns a flat dictionary."""
import os
import shutil
import tempfile

import numpy as np

from . import scores
from .program import read_csv, read_wave, write_wave

SNRS = (-6, 0, 6, 12)
BOUNCE = '2'


def is_regular(clip):
    """Without missed and double strikes or bounces."""
    return clip % 100 < 24


def has_one_decay(clip):
    """The regular noise-like clips: all their frequencies decay alike. In the modal ones every mode has its own
    decay, and no alpha_d is the true one."""
    row = clip % 100
    return is_regular(clip) and (row + row // 8) % 2 == 0


def ids_of(text):
    """'100-107,3' as numbers."""
    for word in text.split(','):
        low, _, high = word.partition('-')
        yield from range(int(low), int(high or low) + 1)


class Workplace:
    """A folder that goes away."""

    def __enter__(self):
        self.path = tempfile.mkdtemp(prefix='drillbench-')
        return lambda name: os.path.join(self.path, name)

    def __exit__(self, *_):
        shutil.rmtree(self.path, ignore_errors=True)


def truth_of(path):
    rows = [r for r in read_csv(path) if r['kind'] != BOUNCE]
    return np.array([float(r['time_s']) for r in rows]), np.array([float(r['amplitude']) for r in rows])


def detection(program, clip):
    """Denoising, clicks, envelope and the no-click rule on the 2 s clip."""
    result = {}
    with Workplace() as at:
        truth = program.simulate(at(''), clip, 2, SNRS)
        stem = at('c%03d' % clip)
        times, amplitudes = truth_of(stem + '_truth.csv')
        clean = read_wave(stem + '_clean.wav')
        for snr in SNRS + ('clean',):
            mix = '%s_%s.wav' % (stem, snr)
            found, strengths, cpu = program.clicks(mix, *(['--no-denoise'] if snr == 'clean' else []))
            here = scores.click_scores(found, strengths, times, amplitudes)
            here.update(found=len(found), cpu_s=cpu)
            bank = has_one_decay(clip) and program.analyze(mix, at('set'), '--clicks', 2, *(['--no-denoise'] if snr == 'clean' else []))[1]
            if bank:
                here['alpha_d'] = abs(bank['alpha_d'] / truth['alpha_d'] - 1)
                here['N_a'] = 2 ** abs(np.log2(max(bank['N_a'], 1) / truth['N_a']))
            if snr != 'clean':
                program.denoise(mix, at('out.wav'))
                here['si_sdri'] = scores.si_sdr_db(clean, read_wave(at('out.wav'))) - scores.si_sdr_db(clean, read_wave(mix))
            result.update({'%s@%s' % (k, snr): v for k, v in here.items()})
        result['false_alarm'] = len(program.clicks(stem + '_bg.wav')[0]) > 0
    return result


def resynthesis(program, clip):
    """8 s of synthesis from 2 s of analysis, at the recorded rate and at 0.7 and 1.4 of it, clean and denoised."""
    result = {}
    with Workplace() as at:
        stem = at('c%03d' % clip)
        for rate in (1, .7, 1.4):
            truth = program.simulate(at(''), clip, 8 * rate, (0, 6))
            write_wave(at('learn.wav'), read_wave(stem + '_clean.wav')[:96000])
            mixes = {snr: read_wave('%s_%d.wav' % (stem, snr))[:96000] for snr in (0, 6)}
            bank = program.analyze(at('learn.wav'), at('clean'), '--no-denoise')[0]
            if not bank:
                result.update({'%s@%g' % (k, rate): np.inf for k in ('level', 'ltas', 'mod', 'crest', 'gap')})
                continue
            program.simulate(at(''), clip, 8, (), rate)
            original, times = read_wave(stem + '_clean.wav'), truth_of(stem + '_truth.csv')[0]
            options = [] if rate == 1 else ['--rate', rate * 48000 / truth['T_0']]
            sound, blows = program.resynth(bank, at('out.wav'), 8, clip, *options)
            here = scores.synthesis_scores(original, sound)
            here['gap'] = scores.gap_distance(times, blows)
            result.update({'%s@%g' % (k, rate): v for k, v in here.items()})
            if rate != 1:
                continue
            for snr, mix in mixes.items():
                write_wave(at('learn.wav'), mix)
                bank = program.analyze(at('learn.wav'), at('noisy'))[0]
                if bank:
                    sound, noise = program.resynth(bank, at('out.wav'), 8, clip)[0], read_wave(stem + '_bg.wav')
                    heard = scores.audible(original, noise * 10 ** (-snr / 20))
                    result['ltas@%ddB' % snr] = scores.ltas_distance(original, sound, heard)
                    result['ltas_all@%ddB' % snr] = scores.ltas_distance(original, sound)
    return result
