#!/usr/bin/env python3
"""progress_test.py RIGSOUND ROOT: what works for long says on a terminal how long it will take, and elsewhere nothing.

ROOT is the project.
"""
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_files import strikes, write_wav
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
BAR = re.compile(r'\r\[(#* *)\] (?:(\d+)/(\d+)|(\d+) %)  (\?|\d+ s|\d+ min \d\d s|\d+ h \d\d min) left')


def on_terminal(words):
    """Exit code, stdout, and what a terminal gets as stderr."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen([RIGSOUND, *map(str, words)], stdout=subprocess.PIPE, stderr=theirs)
    os.close(theirs)
    shown = b''
    while True:
        try:
            some = os.read(ours, 65536)
        except OSError:  # its only writer has gone
            break
        if not some:
            break
        shown += some
    os.close(ours)
    out = process.stdout.read()
    process.stdout.close()
    return process.wait(), out, shown.decode()


class Progress(FolderCase):
    def setUp(self):
        super().setUp()
        at = self.folder
        write_sound_set(at / 'set')
        self.rig = at / 'rig.toml'
        self.rig.write_text('[sound]\nset = "set"\n[[udp]]\naddress = "127.0.0.1:45217"\n')
        self.made = at / 'made'  # what a run may write
        self.states = at / 'states.csv'
        self.states.write_text('time_s,signal,value\n0,engine_rpm,1500\n90,engine_rpm,0\n')
        self.recording = write_wav(at / 'in.wav', [strikes(7)])
        self.log_rig = at / 'log.toml'
        self.log_rig.write_text(f'[sound]\nset = "set"\n[[can]]\ninterface = "can0"\ndbc = "{ROOT}/config/dbc/rig.dbc"\n'
                                '[can.signals]\nengine_rpm = "EEC1.EngSpeed"\n')

    def set_of_many_banks(self, count):
        many = self.folder / f'set_of_{count}'
        if not many.exists():
            shutil.copytree(self.folder / 'set', many)
            for i in range(count):
                shutil.copytree(many / 'banks/normal', many / f'banks/n{i}')
            entries = [f'[[bank]]\nname = "n{i}"\nsituation = "normal"\n' for i in range(count)]
            (many / 'soundset.toml').write_text((many / 'soundset.toml').read_text() + '\n' + '\n'.join(entries))
        return many

    def packed(self, sound_set):
        file = sound_set.with_suffix('.rigset')
        if not file.exists():
            subprocess.run([RIGSOUND, 'pack', sound_set, file], check=True, stdout=subprocess.DEVNULL)
        return file

    def verbs(self):
        """Words of work that takes some time, by a scale: more work where the machine is too fast to see a bar grow."""
        new, long_sound = self.folder / 'new', self.folder / 'long.wav'
        subprocess.run([RIGSOUND, 'resynth', self.folder / 'set/banks/normal', long_sound, '--seconds', '300'], check=True)
        return {
            'render': lambda _: ['render', self.rig, '--states', self.states, '--out', new.with_suffix('.wav')],
            'render of a log': lambda _: ['render', self.log_rig, '--log', ROOT / 'config/logs/shift.log', '--to', 90, '--out', new.with_suffix('.wav')],
            'resynth': lambda scale: ['resynth', self.folder / 'set/banks/normal', new.with_suffix('.wav'), '--seconds', 300 * scale],
            'simulate': lambda scale: ['simulate', '--ids', '100-123', '--seconds', scale, '--out', self.made],
            'clicks': lambda _: ['clicks', self.recording, '--jobs', 1],
            'denoise': lambda _: ['denoise', self.recording, new.with_suffix('.wav'), '--jobs', 1],
            'tool': lambda _: ['tool', '--from', self.recording, '--length', 0.5, '--diameter', 0.025],
            'background': lambda scale: ['background', '--formula', '--resynth', new.with_suffix('.wav'), '--seconds', 60 * scale],
            'contrast': lambda _: ['contrast', self.rig, '--seconds', 4, '--runs', 2],
            'bench': lambda scale: ['bench', '--seconds', 0.1 * scale],
            'pack': lambda scale: ['pack', self.set_of_many_banks(100 * scale), new.with_suffix('.rigset')],
            'unpack': lambda scale: ['unpack', self.packed(self.set_of_many_banks(20 * scale)), self.made],
            'merge': lambda scale: ['merge', self.set_of_many_banks(20 * scale), '--out', self.made],
            'timeline': lambda _: ['timeline', self.folder / 'a.png', '--wav', long_sound, '--states', self.states],
            'record': lambda _: ['record', self.rig, '--out', new.with_suffix('.pcap'), '--seconds', 1],
        }

    def test_a_bar_that_grows_and_goes_on_a_terminal_and_nothing_elsewhere(self):
        for name, words_of in self.verbs().items():
            for scale in (1, 5, 25):
                words = words_of(scale)
                shutil.rmtree(self.made, ignore_errors=True)
                code, out, shown = on_terminal(words)
                self.assertEqual(code, 0, (name, shown))
                bars = BAR.findall(shown)
                if len(bars) > 1 and len(bars[-1][0].rstrip()) > len(bars[0][0].rstrip()):
                    break
            self.assertGreater(len(bars), 1, (name, shown))
            lengths = [len(bar[0].rstrip()) for bar in bars]
            self.assertEqual(lengths, sorted(lengths), name)
            self.assertGreater(lengths[-1], lengths[0], name)
            self.assertTrue(all(len(bar[0]) == 40 for bar in bars), name)
            after = shown[shown.rindex(' left'):]
            self.assertRegex(after, r'\r {60,}\r', name)  # the line is free again
            if name in ('contrast', 'tool', 'denoise'):  # the slowest, and their bars are as the others'
                continue
            shutil.rmtree(self.made, ignore_errors=True)
            plain = subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300)
            self.assertEqual(plain.returncode, 0, plain.stderr)
            self.assertNotIn('left', plain.stderr, name)
            self.assertNotIn('\r', plain.stderr, name)

    def test_lines_of_banks_and_the_bar_do_not_mix_on_one_terminal(self):
        subprocess.run([RIGSOUND, 'simulate', '--ids', '103,112', '--seconds', '2', '--out', self.folder / 'clips'], check=True,
                       stdout=subprocess.DEVNULL)
        (self.folder / 'in').mkdir()
        for name in ('c103', 'c112'):
            shutil.copy(self.folder / f'clips/{name}_clean.wav', self.folder / f'in/{name}.wav')
        code, out, shown = on_terminal(['analyze', self.folder / 'in', '--out', self.folder / 'banks', '--no-denoise', '--jobs', 1])
        self.assertEqual((code, len(out.splitlines())), (0, 2), shown)
        self.assertIn('1/2', shown)


unittest.main(argv=sys.argv[:1])
