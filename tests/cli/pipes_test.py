#!/usr/bin/env python3
"""pipes_test.py RIGSOUND ROOT: pipes, standard input and output, readers that go away, full disks. ROOT is the project."""
import hashlib
import os
import pathlib
import signal
import struct
import subprocess
import sys
import threading
import unittest

from folder_case import FolderCase
from sound_files import read_wav, strikes, write_wav
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
SHIFT = ROOT / 'config/logs/shift.log'


class Case(FolderCase):
    def setUp(self):
        super().setUp()
        write_sound_set(self.folder / 'set')
        self.rig = self.folder / 'rig.toml'
        self.rig.write_text('[sound]\nset = "set"\n')
        self.demo = ROOT / 'config/rigs/demo.toml'
        self.states = self.folder / 'states.csv'
        self.states.write_text('time_s,signal,value\n0,engine_rpm,1500\n0.1,feed_pressure_bar,90\n0.5,feed_pressure_bar,0\n')

    def run_verb(self, *words, **more):
        return subprocess.run([RIGSOUND, *map(str, words)], stderr=subprocess.PIPE, timeout=60,
                              **{'stdout': subprocess.PIPE, **more})

    def through_pipe(self, path, content):
        """A named pipe that holds what a file does, once."""
        pipe = self.folder / (path.name + '.pipe')
        os.mkfifo(pipe)
        threading.Thread(target=lambda: pipe.write_bytes(content), daemon=True).start()
        return pipe

    def left(self):
        return [path.name for path in self.folder.rglob('.*')]


class Reading(Case):
    def test_states_and_session_and_log_come_through_pipes(self):
        def sound(*source, **more):
            result = self.run_verb('render', self.rig, *source, '--out', self.folder / 'out.wav', **more)
            self.assertEqual(result.returncode, 0, result.stderr)
            return result.stdout.split()[1]
        whole = sound('--states', self.states)
        self.assertEqual(sound('--states', '-', input=self.states.read_bytes()), whole)
        self.assertEqual(sound('--states', self.through_pipe(self.states, self.states.read_bytes())), whole)
        told = self.run_verb('decode', self.demo, '--log', SHIFT).stdout
        self.assertEqual(self.run_verb('decode', self.demo, '--log', '-', input=SHIFT.read_bytes()).stdout, told)
        pipe = self.through_pipe(SHIFT, SHIFT.read_bytes())
        self.assertEqual(self.run_verb('decode', self.demo, '--log', pipe).stdout, told)

    def test_rigs_labels_and_tracks_come_through_pipes(self):
        rig = self.rig.read_text().replace('"set"', f'"{self.folder / "set"}"').encode()
        self.assertEqual(self.run_verb('check', '-', input=rig).stdout, self.run_verb('check', self.rig).stdout)
        self.assertEqual(self.run_verb('check', self.through_pipe(self.rig, rig)).returncode, 0)
        recording = write_wav(self.folder / 'in.wav', [strikes(1.5)])
        new = self.folder / 'new'
        result = self.run_verb('analyze', recording, '--labels', '-', '--out', new, input=b'0\t1\tnormla\n')
        self.assertIn(b"standard input:1: situation: 'normla' is none", result.stderr)
        for option, table in (('--rpm-track', b'time_s,rpm\n0,800\n1.5,80\n'), ('--clicks', b'time_s,amplitude\n1,1\n0,1\n')):
            speed = [] if option == '--rpm-track' else ['--rpm', '800']
            result = self.run_verb('background', recording, *speed, option, '-', '--out', new, input=table)
            self.assertRegex(result.stderr, rb'^(-: rpm: is 80 at|standard input:3: time_s: falls back)')

    def test_recordings_come_through_pipes_whole_and_with_sizes_nobody_knew(self):
        recording = write_wav(self.folder / 'in.wav', [strikes(1.5)], 44100)
        raw = recording.read_bytes()
        streamed = raw[:4] + struct.pack('<I', 0x7FFFFFFF) + raw[8:40] + struct.pack('<I', 0x7FFFFFFF) + raw[44:]
        found = self.run_verb('clicks', recording).stdout
        self.assertGreater(len(found.splitlines()), 20)
        self.assertEqual(self.run_verb('clicks', '-', input=raw).stdout, found)
        self.assertEqual(self.run_verb('clicks', '-', input=streamed).stdout, found)
        self.assertEqual(self.run_verb('clicks', self.through_pipe(recording, raw)).stdout, found)
        states = self.folder / 'picture.csv'
        states.write_text('time_s,signal,value\n0,engine_rpm,1500\n')
        result = self.run_verb('timeline', self.folder / 'a.png', '--wav', '-', '--states', states, input=raw)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_what_cannot_be_read_from_a_pipe_says_so(self):
        pipe = self.folder / 'in.pipe'
        os.mkfifo(pipe)
        for words in (['analyze', '-', '--out', self.folder / 'new'], ['analyze', pipe, '--out', self.folder / 'new']):
            result = self.run_verb(*words, input=b'')
            self.assertEqual(result.returncode, 1)
            self.assertIn(b'is a pipe, expected a file', result.stderr)
        self.assertFalse((self.folder / 'new').exists())
        pipe = self.folder / 'set.rigset'
        os.mkfifo(pipe)
        opened = os.open(pipe, os.O_RDWR)
        result = self.run_verb('unpack', pipe, self.folder / 'new')
        os.close(opened)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b'is no regular file, expected one on disk', result.stderr)


class Writing(Case):
    def test_a_wav_in_a_pipe_has_a_true_header_and_all_samples(self):
        out = self.folder / 'out.wav'
        said = self.run_verb('render', self.rig, '--states', self.states, '--out', out).stdout
        for name in ('-', '/dev/stdout'):
            result = self.run_verb('render', self.rig, '--states', self.states, '--out', name)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stdout, out.read_bytes())
            self.assertIn(said.split()[1], result.stderr)  # the figures step aside
        channels, rate, samples = read_wav(result.stdout)
        self.assertEqual(hashlib.sha256(struct.pack(f'<{len(samples)}f', *samples)).hexdigest().encode(), said.split()[1])
        bank = self.folder / 'set/banks/normal'
        self.run_verb('resynth', bank, out, '--seconds', 1)
        self.assertEqual(self.run_verb('resynth', bank, '-', '--seconds', 1).stdout, out.read_bytes())
        recording = write_wav(self.folder / 'in.wav', [strikes(0.6)])
        self.run_verb('denoise', recording, out)
        self.assertEqual(self.run_verb('denoise', recording, '-').stdout, out.read_bytes())
        self.assertEqual(self.run_verb('denoise', '-', '-', input=recording.read_bytes()).stdout, out.read_bytes())
        packed = self.folder / 'a.rigset'
        self.run_verb('pack', self.folder / 'set', packed)
        self.assertEqual(self.run_verb('pack', self.folder / 'set', '-').stdout, packed.read_bytes())
        self.assertEqual(self.left(), [])

    def test_a_redirected_stdout_keeps_its_name_and_what_stood_in_it(self):
        target = self.folder / 'log.bin'
        target.write_bytes(b'before')
        with open(target, 'ab') as out:
            self.run_verb('resynth', self.folder / 'set/banks/normal', '/dev/stdout', '--seconds', 1, stdout=out)
        self.assertEqual(target.read_bytes()[:6], b'before')
        read_wav(target.read_bytes()[6:])
        self.assertTrue(pathlib.Path('/dev/stdout').is_symlink())

    def test_figures_and_a_file_do_not_share_stdout(self):
        for words in (['tool', '--length', 0.5, '--diameter', 0.025, '--plot', '-'], ['contrast', self.rig, '--report', '-'],
                      ['analyze', self.rig, '--out', self.folder / 'new', '--report', '/dev/stdout']):
            result = self.run_verb(*words)
            self.assertEqual((result.returncode, result.stdout), (2, b''), words)
            self.assertIn(b'is standard output, which the figures take, expected a file', result.stderr)

    def test_a_reader_that_goes_ends_it_without_a_word(self):
        for words in (['decode', self.demo, '--log', SHIFT], ['render', self.rig, '--states', self.states, '--out', '-'],
                      ['tool', '--length', '0.5', '--diameter', '0.025']):
            read, write = os.pipe()
            os.close(read)
            result = self.run_verb(*words, stdout=write)
            os.close(write)
            self.assertEqual((result.returncode, result.stderr.decode()), (-signal.SIGPIPE, ''), words)
        self.assertEqual(self.left(), [])

    def test_a_full_disk_is_one_line_and_code_3(self):
        for words in (['decode', self.demo, '--log', SHIFT], ['tool', '--length', '0.5', '--diameter', '0.025'],
                      ['check', self.rig], ['simulate', '--ids', '100', '--seconds', '1', '--out', self.folder / 'sim']):
            with open('/dev/full', 'wb') as full:
                result = self.run_verb(*words, stdout=full)
            lines = result.stderr.decode().splitlines()
            self.assertEqual(result.returncode, 3, lines)
            self.assertEqual(lines[-1], 'standard output: cannot be written: No space left on device')
            self.assertEqual(sum('cannot' in line for line in lines), 1, lines)
        for words in (['render', self.rig, '--states', self.states, '--out', '/dev/full'],
                      ['resynth', self.folder / 'set/banks/normal', '/dev/full', '--seconds', 1]):
            result = self.run_verb(*words)
            self.assertEqual((result.returncode, result.stdout), (3, b''))
            self.assertEqual(result.stderr, b'/dev/full: cannot be written: No space left on device\n')

    def test_a_closed_stdout_gets_no_file_in_its_place(self):
        out = self.folder / 'out.wav'
        result = subprocess.run(['sh', '-c', 'exec "$@" >&-', 'sh', RIGSOUND, 'render', self.rig, '--states', self.states, '--out', out],
                                stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stderr.splitlines()[-1], b'standard output: cannot be written: Bad file descriptor')
        read_wav(out.read_bytes())


unittest.main(argv=sys.argv[:1])
