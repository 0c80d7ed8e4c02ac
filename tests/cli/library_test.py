#!/usr/bin/env python3
"""library_test.py BUILD ROOT: librigsound as another program finds it, installed into a folder of its own.

The examples are built against what was installed and nothing else; what they play must be, sample for sample, what
`rigsound render --states` plays of the same states.
"""
import array
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from sound_set import write_sound_set

BUILD, ROOT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
EXAMPLES = ROOT / 'tools/library/examples'
STRICT = ['-Wall', '-Wextra', '-pedantic', '-Werror']


def run(*words, **more):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, **more)
    if result.returncode:
        raise AssertionError(f'{words}: exit code {result.returncode}\n{result.stdout}{result.stderr}')
    return result.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_library.'))
        cls.prefix = cls.folder / 'prefix'
        for component in ('programs', 'library', 'development'):
            run('cmake', '--install', BUILD, '--prefix', cls.prefix, '--component', component)
        cls.lib = next(cls.prefix.rglob('librigsound.so.1')).parent
        cls.env = {**os.environ, 'LD_LIBRARY_PATH': str(cls.lib), 'PKG_CONFIG_PATH': str(cls.lib / 'pkgconfig')}
        write_sound_set(cls.folder / 'set')
        cls.rig = cls.folder / 'rig.toml'
        cls.rig.write_text('[audio]\ndevice = "null"\n[sound]\nset = "set"\nseed = 7\n')

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def flags(self):
        return run('pkg-config', '--cflags', '--libs', 'rigsound', env=self.env).split()

    def built(self, source, *compiler):
        program = self.folder / pathlib.Path(source).stem
        run(*compiler, *STRICT, source, '-o', program, *self.flags(), env=self.env)
        return program

    def rendered(self):
        """sha256 of the ramp that the examples play, by the program."""
        blocks, rows, last = int(10 * 48000 / 64), ['time_s,signal,value', '0,engine_rpm,1500'], None
        for block in range(blocks):
            second = block * 64 / 48000
            feed = 40 + int(15 * second)
            if feed != last or block == blocks - 1:
                rows.append(f'{second:.6f},feed_pressure_bar,{feed}')
            last = feed
        states = self.folder / 'states.csv'
        states.write_text('\n'.join(rows) + '\n')
        said = run(self.prefix / 'bin/rigsound', 'render', self.rig, '--states', states, '--out', self.folder / 'r.wav')
        return said.split()[1]

    def test_c_and_python_and_the_program_play_the_same_samples(self):
        wanted = self.rendered()
        program = self.built(EXAMPLES / 'feed_ramp.c', 'cc', '-std=c99')
        run(program, self.rig, self.folder / 'c.wav', env=self.env)
        pcm = (self.folder / 'c.wav').read_bytes()[44:]
        self.assertEqual(hashlib.sha256(pcm).hexdigest(), wanted)
        run(sys.executable, EXAMPLES / 'feed_ramp.py', self.rig, self.folder / 'p.f32', env=self.env)
        self.assertEqual(hashlib.sha256((self.folder / 'p.f32').read_bytes()).hexdigest(), wanted)
        self.assertGreater(max(array.array('f', pcm)), 0.01)

    def test_a_packed_set_needs_no_rig_file_and_opens_from_memory(self):
        import ctypes
        packed = self.folder / 'demo.rigset'
        run(self.prefix / 'bin/rigsound', 'pack', self.folder / 'set', packed, '--rig', self.rig)
        run(sys.executable, EXAMPLES / 'feed_ramp.py', packed, self.folder / 'packed.f32', env=self.env)
        run(sys.executable, EXAMPLES / 'feed_ramp.py', self.rig, self.folder / 'plain.f32', env=self.env)
        plain = (self.folder / 'plain.f32').read_bytes()
        self.assertEqual((self.folder / 'packed.f32').read_bytes(), plain)
        library = ctypes.CDLL(str(self.lib / 'librigsound.so.1'))
        for name in ('rigsound_open_memory', 'rigsound_last_error'):
            getattr(library, name).restype = ctypes.c_void_p if name == 'rigsound_open_memory' else ctypes.c_char_p
        library.rigsound_seed.restype = ctypes.c_uint64
        library.rigsound_seed.argtypes = [ctypes.c_void_p]
        library.rigsound_open_memory.argtypes = [ctypes.c_char_p, ctypes.c_size_t]
        library.rigsound_last_error.argtypes = [ctypes.c_void_p]
        library.rigsound_close.argtypes = [ctypes.c_void_p]
        content = packed.read_bytes()
        rig = library.rigsound_open_memory(content, len(content))
        self.assertTrue(rig, library.rigsound_last_error(None))
        self.assertEqual(library.rigsound_seed(rig), 7)
        library.rigsound_latency.argtypes = [ctypes.c_void_p]
        self.assertEqual(library.rigsound_latency(rig), 96)  # 2 ms
        library.rigsound_close(rig)
        self.assertIsNone(library.rigsound_open_memory(content, len(content) - 1))
        self.assertIn(b'cut off', library.rigsound_last_error(None))

    def test_the_cpp_example_builds_and_its_keys_act(self):
        flags = run('pkg-config', '--cflags', '--libs', 'alsa').split()
        program = self.folder / 'six_sliders'
        run('c++', '-std=c++17', *STRICT, EXAMPLES / 'six_sliders.cpp', '-o', program, *self.flags(), *flags, '-pthread',
            env=self.env)
        said = run(program, self.rig, 'null', env=self.env, input='FFdx')
        self.assertIn('feed_pressure_bar 100', said)
        self.assertIn('decay_factor 0.9', said)

    def test_cmake_finds_the_package(self):
        source = self.folder / 'user'
        source.mkdir()
        (source / 'CMakeLists.txt').write_text(
            'cmake_minimum_required(VERSION 3.25)\nproject(user LANGUAGES C)\nfind_package(rigsound 0.1 REQUIRED)\n'
            'add_executable(user user.c)\ntarget_link_libraries(user rigsound::rigsound)\n')
        (source / 'user.c').write_text('#include <rigsound.h>\n#include <stdio.h>\n'
                                       'int main(void) { return puts(rigsound_version()) < 0; }\n')
        run('cmake', '-S', source, '-B', source / 'build', f'-DCMAKE_PREFIX_PATH={self.prefix}')
        run('cmake', '--build', source / 'build')
        version = re.search(r'VERSION ([0-9.]+)', (ROOT / 'CMakeLists.txt').read_text().split('project(')[1]).group(1)
        self.assertEqual(run(source / 'build/user', env=self.env).strip(), version)

    def test_the_library_shows_what_its_header_declares_and_nothing_else(self):
        header = (self.prefix / 'include/rigsound.h').read_text()
        declared = set(re.findall(r'RIGSOUND_API[^;]*?\b(rigsound_\w+)\(', header))
        shown = {line.split()[-1].split('@')[0] for line in
                 run('nm', '-D', '--defined-only', self.lib / 'librigsound.so.1').splitlines() if ' T ' in line or ' D ' in line}
        self.assertEqual(shown, declared)
        self.assertIn('librigsound.so.1', run('readelf', '-d', self.lib / 'librigsound.so.1'))

    def test_what_cannot_be_done_is_said(self):
        import ctypes
        library = ctypes.CDLL(str(self.lib / 'librigsound.so.1'))
        for name in ('rigsound_open', 'rigsound_signal_name'):
            getattr(library, name).restype = ctypes.c_void_p if name == 'rigsound_open' else ctypes.c_char_p
        library.rigsound_last_error.restype = ctypes.c_char_p
        library.rigsound_last_error.argtypes = [ctypes.c_void_p]
        library.rigsound_set.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_double]
        library.rigsound_control.argtypes = library.rigsound_set.argtypes
        library.rigsound_close.argtypes = [ctypes.c_void_p]
        self.assertIsNone(library.rigsound_open(b'/nowhere/rig.toml'))
        self.assertIn(b'/nowhere/rig.toml', library.rigsound_last_error(None))
        self.assertIsNone(library.rigsound_open(None))
        rig = library.rigsound_open(str(self.rig).encode())
        self.assertTrue(rig, library.rigsound_last_error(None))
        for call, words in (((b'feed_pressure', 0, 90), b"did you mean 'feed_pressure_bar'"),
                            ((b'feed_pressure_bar', 1, 90), b'boom: is 1, expected 0...0'),
                            ((b'feed_pressure_bar', 0, 400), b'feed_pressure_bar: is 400 bar, expected 0...300 bar'),
                            ((b'engine_rpm', 0, float('nan')), b'engine_rpm'), ((None, 0, 1), b'NULL')):
            self.assertEqual(library.rigsound_set(rig, *call), -1)
            self.assertIn(words, library.rigsound_last_error(rig))
        self.assertEqual(library.rigsound_control(rig, b'decay_factor', 0, 99), -1)
        self.assertIn(b'expected 0.25...10', library.rigsound_last_error(rig))
        self.assertEqual(library.rigsound_control(rig, b'decay_factor', 0, 2), 0)
        self.assertEqual(library.rigsound_set(rig, b'engine_load', 0, -1), 0)   # absent again
        names = []
        while library.rigsound_signal_name(len(names)):
            names.append(library.rigsound_signal_name(len(names)))
        self.assertIn(b'feed_pressure_bar', names)
        library.rigsound_close(rig)
        library.rigsound_close(None)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
