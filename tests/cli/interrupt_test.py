#!/usr/bin/env python3
"""interrupt_test.py RIGSOUND ROOT: a signal in the midst of work leaves nothing half made. ROOT is the project."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

from folder_case import FolderCase
from sound_files import strikes, write_wav
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
PATIENCE_S = 60


def wait_for(condition, process):
    for _ in range(PATIENCE_S * 200):
        if condition():
            return
        assert process.poll() is None, 'it ended before it could be stopped'
        time.sleep(0.005)
    raise AssertionError('no sign of work')


class Interrupted(FolderCase):
    def setUp(self):
        super().setUp()
        self.temporary = self.folder / 'tmp'
        self.out = self.folder / 'out'
        self.temporary.mkdir()
        self.out.mkdir()

    def begin(self, *words, **more):
        return subprocess.Popen([RIGSOUND, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, 'TMPDIR': str(self.temporary)}, **more)

    def interrupted(self, number, *words):
        """Stops it when something unfinished lies about; says what is left."""
        process = self.begin(*words)
        wait_for(lambda: any(self.out.rglob('.*')) or any(self.temporary.iterdir()), process)
        process.send_signal(number)
        out, err = process.communicate(timeout=PATIENCE_S)
        self.assertEqual((process.returncode, out, err), (128 + number, b'', b''), words)
        self.assertEqual(list(self.temporary.iterdir()), [])
        return sorted(path.relative_to(self.out).as_posix() for path in self.out.rglob('*'))

    def recordings(self, count):
        """Short recordings that give banks: easy clips of the simulator."""
        clips = self.folder / 'clips'
        subprocess.run([RIGSOUND, 'simulate', '--ids', '103,112', '--seconds', '2', '--out', clips], check=True,
                       stdout=subprocess.DEVNULL)
        (self.folder / 'in').mkdir()
        for i in range(count):
            shutil.copy(clips / f'c{(103, 112)[i % 2]}_clean.wav', self.folder / f'in/r{i}.wav')
        return self.folder / 'in'

    def test_sound_that_is_being_made(self):
        write_sound_set(self.folder / 'set')
        rig = self.folder / 'rig.toml'
        rig.write_text('[sound]\nset = "set"\n')
        states = self.folder / 'states.csv'
        states.write_text('time_s,signal,value\n0,engine_rpm,1500\n3600,engine_rpm,0\n')
        kept = self.out / 'kept.wav'
        kept.write_text('old')
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            self.assertEqual(self.interrupted(number, 'render', rig, '--states', states, '--out', kept), ['kept.wav'])
            self.assertEqual(kept.read_text(), 'old')
        self.assertEqual(self.interrupted(signal.SIGINT, 'render', rig, '--states', states, '--out', '-'), ['kept.wav'])

    def test_recordings_that_are_being_simulated(self):
        (self.out / 'mine').mkdir()
        (self.out / 'mine/normal.txt').write_text('mine')
        self.assertEqual(self.interrupted(signal.SIGINT, 'simulate', '--out', self.out / 'mine', '--seconds', 60),
                         ['mine', 'mine/normal.txt'])
        self.assertEqual(self.interrupted(signal.SIGTERM, 'simulate', '--out', self.out / 'new', '--seconds', 60),
                         ['mine', 'mine/normal.txt'])

    def test_a_recording_that_is_being_denoised(self):
        recording = write_wav(self.folder / 'in.wav', [strikes(20)])
        self.assertEqual(self.interrupted(signal.SIGINT, 'denoise', recording, self.out / 'out.wav', '--dump', self.out / 'dump',
                                          '--jobs', 1), [])
        self.assertEqual(self.interrupted(signal.SIGINT, 'clicks', recording, '--dump', self.out / 'dump', '--jobs', 1), [])

    def test_a_batch_keeps_whole_banks_only_and_goes_on_later(self):
        recordings = self.recordings(6)
        words = ['analyze', recordings, '--out', self.out / 'set', '--no-denoise', '--jobs', 1]
        process = self.begin(*words)
        first = process.stdout.readline()  # told when it is done
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 130)
        self.assertTrue(first.startswith(b'r0 '))
        kept = {path.name for path in (self.out / 'set/banks').iterdir()}
        self.assertLess(kept, {f'r{i}' for i in range(6)})
        self.assertIn('r0', kept)
        self.assertEqual([path.name for path in self.out.rglob('.*')], [])
        self.assertFalse((self.out / 'set/soundset.toml').exists())
        again = subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True)
        self.assertEqual((again.returncode, len(again.stdout.splitlines())), (0, 6), again.stderr)
        self.assertEqual([path.name for path in self.out.rglob('.*')], [])

    def test_a_batch_that_is_stopped_before_its_first_bank_leaves_nothing(self):
        recording = write_wav(self.folder / 'in.wav', [strikes(60)])
        self.assertEqual(self.interrupted(signal.SIGINT, 'analyze', recording, '--out', self.out / 'set', '--jobs', 1), [])

    def test_a_reader_that_goes_stops_a_batch_and_leaves_nothing_half_made(self):
        recordings = self.recordings(4)
        process = self.begin('analyze', recordings, '--out', self.out / 'set', '--no-denoise', '--jobs', 1)
        process.stdout.readline()
        process.stdout.close()
        err = process.stderr.read()
        process.stderr.close()
        self.assertEqual((process.wait(timeout=PATIENCE_S), err), (-signal.SIGPIPE, b''))
        self.assertEqual([path.name for path in self.out.rglob('.*')], [])

    def test_whenever_it_comes_outputs_are_whole_or_absent(self):
        sound_set = write_sound_set(self.folder / 'set')
        rig = self.folder / 'rig.toml'
        rig.write_text('[sound]\nset = "set"\n')
        states = self.folder / 'states.csv'
        states.write_text('time_s,signal,value\n0,engine_rpm,1500\n20,engine_rpm,0\n')
        recording = write_wav(self.folder / 'in.wav', [strikes(20)])
        packed = self.folder / 'in.rigset'
        subprocess.run([RIGSOUND, 'pack', sound_set, packed], check=True, stdout=subprocess.DEVNULL)
        for name, words in (
                ('a.rigset', ['pack', sound_set, self.out / 'a.rigset']), ('a', ['unpack', packed, self.out / 'a']),
                ('m', ['merge', sound_set, '--out', self.out / 'm']),
                ('a.png', ['timeline', self.out / 'a.png', '--wav', recording, '--states', states]),
                ('a.html', ['contrast', rig, '--seconds', '4', '--runs', '2', '--report', self.out / 'a.html']),
                ('a.svg', ['tool', '--from', recording, '--length', '0.5', '--diameter', '0.025', '--plot', self.out / 'a.svg']),
                ('t', ['tool', '--length', '0.5', '--diameter', '0.025', '--out', self.out / 't']),
                ('b', ['background', '--formula', '--out', self.out / 'b']),
                ('a.flac', ['resynth', sound_set / 'banks/normal', self.out / 'a.flac', '--seconds', '300'])):
            for delay_s in (0.002, 0.01, 0.03, 0.1, 0.3):
                process = self.begin(*words)
                time.sleep(delay_s)
                process.send_signal(signal.SIGINT)
                process.communicate(timeout=PATIENCE_S)
                # Before it hears of signals the system's own way is as good.
                self.assertIn(process.returncode, (0, 130, -signal.SIGINT), words)
                self.assertEqual([path.name for path in self.folder.rglob('.*')], [], words)
                self.assertEqual(list(self.temporary.iterdir()), [], words)
                left = self.out / name
                if process.returncode == 0:
                    self.assertTrue(left.exists(), words)
                if left.is_file():
                    self.assertGreater(left.stat().st_size, 1000, words)
                shutil.rmtree(left) if left.is_dir() else left.unlink(missing_ok=True)

    def test_what_was_started_without_a_signal_stays_without_it(self):
        write_sound_set(self.folder / 'set')
        process = self.begin('resynth', self.folder / 'set/banks/normal', self.out / 'a.wav', '--seconds', '600',
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))  # as nohup does
        process.send_signal(signal.SIGHUP)
        process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 0)


unittest.main(argv=sys.argv[:1])
