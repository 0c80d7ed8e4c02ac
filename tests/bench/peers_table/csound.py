"""Csound: an orchestra and a score in one file."""
import math

from . import patch
from .click_files import click_files

PER_DECAY = math.log(1000)   # of 60 dB, in time constants


def clicks(files):
    tables = '\n'.join(f'gi{i} ftgen {i + 1}, 0, 0, -1, "{file}", 0, 0, 1' for i, file in enumerate(files))
    return tables, 'a1 loscil p4, 1, p5, 1, 0'


def modes():
    lines = ['aring = 0']
    for frequency_hz, decay_s in patch.MODES:
        lines += [f'am mode gadry, {frequency_hz:.3f}, {math.pi * frequency_hz * decay_s / PER_DECAY:.3f}', 'aring = aring + am']
    return lines


def orchestra(files, with_bar):
    tables, click = clicks(files)
    lines = [f'sr = {patch.RATE}', f'ksmps = {patch.BLOCK}', 'nchnls = 2', '0dbfs = 1', tables]
    if not with_bar:
        return lines + ['instr 1', click, f'a1 = a1 * {patch.MIDDLE}', 'outs a1, a1', 'endin']
    lines += ['gadry init 0', 'instr 1', click, 'gadry = gadry + a1', 'endin']
    return lines + ['instr 2', *modes(), f'aboth = (gadry + aring * {patch.RING / len(patch.MODES)}) * {patch.MIDDLE}', 'outs aboth, aboth',
                    'gadry = 0', 'endin']


def score(with_bar):
    lines = [f'i 1 {b.time_s:.6f} {patch.CLICK_S} {b.gain:.6f} {b.click + 1}' for b in patch.blows()]
    return ([f'i 2 0 {patch.SECONDS}'] if with_bar else []) + lines + [f'e {patch.SECONDS}']


def command(folder, out, with_bar):
    file = folder / f'csound{with_bar:d}.csd'
    text = ['<CsoundSynthesizer>', '<CsInstruments>', *orchestra(click_files(folder), with_bar), '</CsInstruments>',
            '<CsScore>', *score(with_bar), '</CsScore>', '</CsoundSynthesizer>']
    file.write_text('\n'.join(text) + '\n')
    return ['csound', '-d', '-m0', '-W', '-f', '-o', out, file]
