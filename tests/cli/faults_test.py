#!/usr/bin/env python3
"""faults_test.py RIGSOUND RIGSOUNDD SHIM: whichever call on a file fails, what was there stays or the new is there, whole.

SHIM (`faults/failing_calls.cpp`) lets the n-th call of a kind fail, as SQLite tests itself. Each verb runs once to
count the calls, then once for every call, or for calls spread over them when there are many.
"""
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from sound_set import write_sound_set

RIGSOUND, RIGSOUNDD, SHIM = sys.argv[1:4]
KINDS = ('open', 'read', 'write', 'fsync', 'rename')
MOST_RUNS = 8  # of a kind and a verb


def snapshot(folder):
    """What every file below it holds, by its name."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()[:8] for path in sorted(folder.rglob('*')) if path.is_file()}


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_faults.'))
        self.addCleanup(shutil.rmtree, self.folder)
        self.start = self.folder / 'start'
        self.start.mkdir()
        write_sound_set(self.start / 'set')
        (self.start / 'rig.toml').write_text('[sound]\nset = "set"\n[[udp]]\naddress = "127.0.0.1:45123"\n')
        (self.start / 'states.csv').write_text('time_s,signal,value\n0,engine_rpm,1500\n0.1,feed_pressure_bar,90\n1,feed_pressure_bar,0\n')

    def run_once(self, words, kind, n):
        """(folder, exit code, standard error, calls)"""
        work = self.folder / 'work'
        shutil.rmtree(work, ignore_errors=True)
        shutil.copytree(self.start, work)
        count = self.folder / 'count'
        env = dict(os.environ, LD_PRELOAD=SHIM, RIGSOUND_FAULT=f'{work} {kind} {n}', RIGSOUND_FAULT_COUNT=str(count))
        result = subprocess.run([RIGSOUND, *words], cwd=work, env=env, capture_output=True, text=True, timeout=300)
        return work, result.returncode, result.stderr, int(count.read_text())

    def check_verb(self, *words, outputs):
        """`outputs`: files and folders of which each may be old or new, but whole."""
        work, code, stderr, _ = self.run_once(words, 'none', 0)
        self.assertEqual(code, 0, stderr)
        before, after = snapshot(self.start), snapshot(work)
        self.assertNotEqual(before, after)
        for kind in KINDS:
            calls = self.run_once(words, kind, 0)[3]
            step = max(1, -(-calls // MOST_RUNS))
            for n in range(1, calls + 1, step):
                with self.subTest(verb=words[0], kind=kind, n=n, calls=calls):
                    work, code, stderr, _ = self.run_once(words, kind, n)
                    if code != 0:
                        self.assertIn(code, (1, 3) if kind in ('open', 'read') else (3,), stderr)
                        self.assertEqual(stderr.count('\n'), 1, stderr)
                    now = snapshot(work)
                    for output in outputs:
                        old, new, found = (self.below(files, output) for files in (before, after, now))
                        self.assertIn(found, (old, new), f'{output} is neither old nor new')
                        if code == 0:
                            self.assertEqual(found, new, f'{output} is old and nobody said so')
                    self.assertLessEqual(set(now), set(before) | set(after), 'something is left behind')

    @staticmethod
    def below(files, output):
        return {name: text for name, text in files.items() if name == output or name.startswith(output + '/')}

    def test_pack(self):
        self.check_verb('pack', 'set', 'all.rigset', outputs=['all.rigset'])

    def test_pack_over_an_older_one(self):
        (self.start / 'all.rigset').write_bytes(b'old')
        self.check_verb('pack', 'set', 'all.rigset', outputs=['all.rigset'])

    def test_render(self):
        (self.start / 'out.wav').write_bytes(b'old')
        self.check_verb('render', 'rig.toml', '--states', 'states.csv', '--out', 'out.wav', outputs=['out.wav'])

    def test_tool(self):
        self.check_verb('tool', '--length', '0.5', '--diameter', '0.025', '--name', 'bar', '--out', 'set',
                        outputs=['set/tools/bar.json', 'set/soundset.toml'])

    def test_analyze(self):
        clips = self.folder / 'clips'
        subprocess.run([RIGSOUND, 'simulate', '--ids', '103', '--seconds', '1', '--out', clips], check=True, capture_output=True)
        shutil.copy(next(clips.rglob('*.wav')), self.start / 'in.wav')
        self.check_verb('analyze', 'in.wav', '--situation', 'normal', '--out', 'set', '--jobs', '1',
                        outputs=['set/banks/in', 'set/soundset.toml'])


class Session(unittest.TestCase):
    """What a run has told until its disk fails stays readable, and the sound goes on."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_faults.'))
        self.addCleanup(shutil.rmtree, self.folder)
        write_sound_set(self.folder / 'set')
        self.rig = self.folder / 'rig.toml'
        self.rig.write_text(f'[audio]\ndevice = "null"\nblock = 256\n[sound]\nset = "set"\n[control]\nsocket = "{self.folder}/c"\n')
        self.sessions = self.folder / 'sessions'

    def run_with(self, kind, n, **more):
        """Runs until the daemon has told something of what a user sets, and ends it."""
        shutil.rmtree(self.sessions, ignore_errors=True)
        env = dict(os.environ, LD_PRELOAD=SHIM, RIGSOUND_FAULT=f'{self.sessions} {kind} {n}', **more)
        daemon = subprocess.Popen([RIGSOUNDD, self.rig, '--manual', '--session', self.sessions], env=env, stderr=subprocess.PIPE)
        self.addCleanup(lambda: daemon.poll() is None and daemon.kill())
        for rpm in (800, 1500):
            deadline = time.monotonic() + 60
            while self.ctl('set', 'engine_rpm', rpm).returncode != 0:
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.02)
            blocks = self.blocks()
            while self.blocks() < blocks + 190:  # a second of sound, two chunks
                time.sleep(0.05)
        daemon.send_signal(signal.SIGTERM)
        said = daemon.communicate(timeout=60)[1].decode()
        self.assertEqual(daemon.returncode, 0, said)
        return said

    def ctl(self, *words):
        return subprocess.run([RIGSOUND, 'ctl', '--socket', self.folder / 'c', *map(str, words)], capture_output=True, text=True)

    def blocks(self):
        return json.loads(self.ctl('status', '--json').stdout)['audio']['blocks']

    def test_a_disk_that_does_not_answer(self):
        """Neither who asks nor who ends the daemon waits for it."""
        for kind, n in (('open', 1), ('write', 1), ('write', 3)):
            with self.subTest(kind=kind, n=n):
                said = self.run_with(kind, n, RIGSOUND_FAULT_HANGS='1')
                self.assertIn('the disk does not answer, the session is not ended', said)
                self.assertFalse((self.folder / 'c').exists())

    def test_a_disk_that_fails(self):
        for kind, n in (('open', 1), ('write', 1), ('write', 2), ('write', 4)):
            with self.subTest(kind=kind, n=n):
                self.assertIn('the sound goes on, this run is no longer recorded', self.run_with(kind, n))
                told = subprocess.run([RIGSOUND, 'decode', self.rig, '--session', self.sessions], capture_output=True, text=True)
                if n >= 3:
                    self.assertEqual(told.returncode, 0, told.stderr)
                    self.assertIn('engine_rpm,800', told.stdout)
                else:
                    self.assertEqual((told.returncode, told.stdout, told.stderr.count('\n')), (1, '', 1), told.stderr)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
