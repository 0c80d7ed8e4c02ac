#!/usr/bin/env python3
"""bounded_test.py RIGSOUND ROOT: hostile and huge inputs cost one line and little memory.

The files in `cases/` were found by attacking the readers; sessions are written here from the description of the format.
"""
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

from sound_files import diesel, drilling, write_long_wav
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
CASES = ROOT / 'tests/cli/cases'
MB = 1 << 20


def varint(value):
    text = b''
    while value >= 0x80:
        text += bytes([value & 0x7f | 0x80])
        value >>= 7
    return text + bytes([value])


def chunk(blocks, payload):
    checked = struct.pack('<Q', blocks) + payload
    return b'RGSC' + struct.pack('<II', len(payload), zlib.crc32(checked)) + checked


RIG_WORDS, BOOM_WORDS, PERCUSSION, RODS = 7, 19, 2, 4  # of session format 4; the latter two are places in a boom's
STATE_WORDS = RIG_WORDS + 4 * BOOM_WORDS


def change(step, words):
    """`words`: by their place in the state."""
    masks = [sum(1 << i % 64 for i in words if i // 64 == m) for m in range((STATE_WORDS + 63) // 64)]
    return varint(step) + b''.join(map(varint, masks)) + b''.join(struct.pack('<I', words[i]) for i in sorted(words))


def bits(value):
    return struct.unpack('<I', struct.pack('<f', value))[0]


HEADER = (b'rigsound-session 4\nprogram test\nfingerprint 0\nseed 1\nsample_rate 48000\nblock 64\nchannels 2\nformat FLOAT\n\n')
SILENCE = {1: bits(-1), 5: bits(1), **{RIG_WORDS + BOOM_WORDS * b + RODS: 1 for b in range(4)}}  # the rest is zero


class Bounded(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_bounded.'))
        self.addCleanup(shutil.rmtree, self.folder)
        self.rig = self.write('rig.toml', '[sound]\nset = "set"\n[[modbus]]\nrole = "client"\ntransport = "tcp"\n'
                              'address = "127.0.0.2:502"\nunit = 255\n[modbus.signals]\n'
                              'engine_rpm = { table = "holding", address = 0, type = "uint16" }\n'
                              'feed_pressure_bar = { table = "holding", address = 1, type = "uint16" }\n')
        write_sound_set(self.folder / 'set')

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content) if isinstance(content, bytes) else path.write_text(content)
        return path

    def run_verb(self, *words):
        """(exit code, standard error, peak memory in MB, which is that of this process when it was higher)"""
        with open(self.folder / 'stdout', 'wb') as out, open(self.folder / 'stderr', 'wb') as err:
            child = subprocess.Popen([RIGSOUND, *map(str, words)], stdout=out, stderr=err)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        return child.returncode, (self.folder / 'stderr').read_text(), usage.ru_maxrss / 1024

    def refused(self, *words, says, most_mb):
        code, stderr, memory = self.run_verb(*words)
        self.assertEqual((code, stderr.count('\n')), (1, 1), stderr[:2000])
        self.assertIn(says, stderr)
        self.assertLess(memory, most_mb)

    def good(self, *words, most_mb):
        code, stderr, memory = self.run_verb(*words)
        self.assertEqual(code, 0, stderr[:2000])
        self.assertLess(memory, most_mb)
        return stderr


class Json(Bounded):
    def setUp(self):
        super().setUp()
        index = self.folder / 'set/soundset.toml'
        index.write_text(index.read_text() + '[[background]]\nname = "diesel"\n')
        (self.folder / 'set/backgrounds/diesel').mkdir(parents=True)
        self.background = 'set/backgrounds/diesel/background.json'

    def test_brackets_without_end(self):
        self.write(self.background, '{"format": 1, "extra": ' + '[' * 200_000 + ']' * 200_000 + '}')
        self.refused('check', self.rig, says='brackets more than 32 levels deep', most_mb=100)

    def test_lists_without_end(self):
        for key, item in (('points', '{}'), ('oscillators', '{}')):
            self.write(self.background, json.dumps({'format': 1, 'sample_rate': 48000})[:-1] +
                       f', "{key}": [' + ','.join([item] * 20_000) + ']}')
            self.refused('check', self.rig, says='background.json', most_mb=100)

    def test_files_that_are_no_such_file(self):
        for name, most in ((self.background, 'model of at most 16 MiB'),
                           ('set/soundset.toml', 'soundset.toml of at most 1 MiB'), ('rig.toml', 'rig of at most 1 MiB')):
            keep = self.folder / name
            before = keep.read_bytes() if keep.exists() else b'{}'
            with open(self.write(name, before), 'ab') as more:
                for _ in range(17):
                    more.write(b' ' * MB)
            self.refused('check', self.rig, says=f'{keep.name}: is of 18 MiB, expected a {most}', most_mb=60)
            self.write(name, before)
        self.refused('check', '/dev/zero', says='/dev/zero: has more than 1 MiB, expected no more', most_mb=60)


class Sessions(Bounded):
    def session(self, *chunks):
        return self.write('s.rigsession', HEADER + b''.join(chunks))

    def test_those_of_an_older_version(self):
        for name in ('session_endless.rigsession', 'session_enum.rigsession'):
            self.refused('render', self.rig, '--session', CASES / name, '--out', self.folder / 'a.wav',
                         says='another version', most_mb=100)

    def test_blocks_without_end(self):
        file = self.session(chunk(1 << 62, change(0, SILENCE)))
        for verb in (['render', self.rig, '--session', file, '--out', self.folder / 'a.wav'],
                     ['decode', self.rig, '--session', file]):
            self.refused(*verb, says='chunk of block 4611686018427387904: is damaged', most_mb=100)

    def test_words_that_are_none(self):
        file = self.session(chunk(750, change(0, SILENCE) + change(10, {RIG_WORDS + PERCUSSION: 7})))
        self.refused('decode', self.rig, '--session', file,
                     says='state of block 10: boom 1: percussion: is 7, expected 0...1', most_mb=100)

    def test_a_long_one_is_read_in_pieces(self):
        """Changes of 20 ms, 8 MB of them; each was once held as a state of 360 bytes."""
        a_second = b''.join(change(15, {0: bits(1000.0 + i)}) for i in range(50))
        file = self.session(chunk(750, change(0, SILENCE) + a_second))
        with open(file, 'ab') as more:
            for second in range(2, 8 * MB // len(a_second)):
                more.write(chunk(750 * second, a_second))
        self.good('decode', self.rig, '--session', file, most_mb=60)


class Captures(Bounded):
    def test_a_clock_that_jumps(self):
        """53 years between two exchanges pass as those of any log do: the clock was set."""
        stderr = self.good('render', self.rig, '--log', CASES / 'timejump.pcap', '--out', self.folder / 'a.wav', most_mb=100)
        self.assertIn('the clock was set forward', stderr)
        self.assertLess((self.folder / 'a.wav').stat().st_size, MB)

    def test_stamps_beyond_any_clock(self):
        for verb in ('decode', 'render'):
            out = ['--out', self.folder / 'a.wav'] if verb == 'render' else []
            code, stderr, _ = self.run_verb(verb, self.rig, '--log', CASES / 'overflow.pcapng', *out)
            self.assertIn(code, (0, 1), stderr)
            self.assertLess(stderr.count('\n'), 9)


class Logs(Bounded):
    def setUp(self):
        super().setUp()
        self.log = self.folder / 'bus.log'
        with open(self.log, 'w') as log:
            for i in range(300_000):
                log.write(f'({1700000000 + i * 0.01:.6f}) can0 0CF00400#F07D{i % 250:02X}{i % 64:02X}1FFFFF85\n')

    def test_a_long_log_is_printed_as_it_is_read(self):
        self.good('decode', CASES / 'eec1.toml', '--log', self.log, most_mb=60)

    def test_who_has_read_enough_ends_it(self):
        child = subprocess.Popen([RIGSOUND, 'decode', CASES / 'eec1.toml', '--log', self.log], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE)
        self.assertEqual(child.stdout.readline(), b'time_s,signal,value\n')
        child.stdout.close()
        self.assertEqual(child.stderr.read(), b'')
        child.stderr.close()
        self.assertEqual(child.wait(timeout=60), -signal.SIGPIPE)


class Recordings(Bounded):
    """What a long recording takes is on the disk, not in memory."""
    LITTLE_MB = 12

    def peaks_mb(self, *words, second, lengths):
        peaks = []
        for seconds in lengths:
            file = write_long_wav(self.folder / f'of_{seconds}_s.wav', second, seconds)
            code, stderr, memory = self.run_verb(words[0], file, *words[1:])
            self.assertEqual(code, 0, stderr[:2000])
            peaks.append(memory)
            print(f'FIGURE {words[0]} of {seconds} s: {memory:.0f} MB', flush=True)
        return peaks

    def test_analyze(self):
        short, long = self.peaks_mb('analyze', '--situation', 'normal', '--no-denoise', '--out', self.folder / 'made',
                                    second=drilling(), lengths=(20, 80))
        self.assertLess(long, short + self.LITTLE_MB)
        self.assertLess(long, 80)

    def test_background(self):
        short, long = self.peaks_mb('background', '--rpm', 1440, '--out', self.folder / 'made', second=diesel(), lengths=(45, 110))
        self.assertLess(long, short + self.LITTLE_MB)
        self.assertLess(long, 150)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
