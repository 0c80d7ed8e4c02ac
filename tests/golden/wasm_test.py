#!/usr/bin/env python3
"""wasm_test.py BUILD RIGSOUND GOLDEN_SET EMXX: engine.wasm, built and played by node, sounds as the library does here."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, RIGSOUND, GOLDEN_SET, EMXX = sys.argv[1:5]
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / 'cli'))
from sound_set import write_sound_set   # noqa: E402

WASM = pathlib.Path(BUILD) / 'tools/library/wasm/engine.wasm'
MOST_BYTES = 400_000
IMPORTS = {'env.emscripten_notify_memory_growth', 'wasi_snapshot_preview1.proc_exit'}
RATE, BLOCK = 48000, 64
STATES = (   # second, signal, value
    (0, 'engine_rpm', 1500), (0.5, 'feed_pressure_bar', 40), (1.5, 'feed_pressure_bar', 90.25), (2, 'rod_count', 3),
    (3, 'feed_pressure_bar', 170), (4, 'percussion_pressure_bar', 120), (5, 'feed_pressure_bar', 0), (5.5, 'rattling', 2),
    (7, 'rattling', 0), (7, 'engine_load', 0.4), (8, 'master_gain_db', -6))


def run(*words):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=1200)
    if result.returncode:
        raise AssertionError(f'{words}: exit code {result.returncode}\n{result.stdout}{result.stderr}')
    return result.stdout


def played(*words):
    return json.loads(run('node', HERE / 'play_wasm.mjs', WASM, *words))


class Wasm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run('cmake', '--build', BUILD, '--target', 'engine_wasm')
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_wasm.'))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_it_is_small_and_asks_its_page_for_next_to_nothing(self):
        module = played()
        self.assertLessEqual(WASM.stat().st_size, MOST_BYTES)
        self.assertEqual({f'{i["module"]}.{i["name"]}' for i in module['imports']}, IMPORTS)
        exported = {e['name'] for e in module['exports']}
        shown = {line.split()[-1].split('@')[0] for line in run(
            'nm', '-D', '--defined-only', pathlib.Path(BUILD) / 'tools/library/librigsound.so').splitlines() if ' T ' in line}
        self.assertEqual({name for name in exported if name.startswith('rigsound_')}, shown - {'rigsound_open'})
        self.assertLessEqual({'memory', 'malloc', 'free', '_initialize'}, exported)

    def test_the_golden_minute(self):
        run(GOLDEN_SET, self.folder / 'golden.rigset', self.folder / 'golden.csv')
        said = played(self.folder / 'golden.rigset', self.folder / 'golden.csv', 60 * RATE // BLOCK)
        self.assertEqual(said['sha256'], (HERE / 'golden.sha256').read_text().strip())
        self.assertEqual(said['refused'], 'the packed sound set: is cut off or has grown since it was packed')
        self.assertEqual(said['version'], run(RIGSOUND, '--version').split()[-1])

    def same_as_rendered(self, set_rate):
        folder = self.folder / str(set_rate)
        write_sound_set(folder / 'set', set_rate)
        rig = folder / 'rig.toml'
        rig.write_text(f'[audio]\nrate = {RATE}\nblock = {BLOCK}\n[sound]\nset = "set"\nseed = 11\n')
        run(RIGSOUND, 'pack', folder / 'set', folder / 'demo.rigset', '--rig', rig)
        blocks = 9 * RATE // BLOCK
        last = (blocks - 1) * BLOCK / RATE
        (folder / 'states.csv').write_text('time_s,signal,value\n' + ''.join(
            f'{second},{signal},{value}\n' for second, signal, value in (*STATES, (f'{last:.6f}', 'master_gain_db', -6))))
        rendered = run(RIGSOUND, 'render', rig, '--states', folder / 'states.csv', '--out', folder / 'r.wav')
        (folder / 'changes.csv').write_text(''.join(
            f'{int(second * RATE / BLOCK)},set,{signal},0,{value}\n' for second, signal, value in STATES))
        said = played(folder / 'demo.rigset', folder / 'changes.csv', blocks)
        self.assertEqual(f'sha256 {said["sha256"]}', rendered.splitlines()[0])

    def test_a_packed_set_sounds_as_render_plays_it(self):
        self.same_as_rendered(RATE)

    def test_also_when_its_clicks_were_recorded_at_another_rate(self):
        self.same_as_rendered(44100)


if __name__ == '__main__':
    missing = [tool for tool in (EMXX, 'node') if not shutil.which(tool)]
    if missing:
        print(f'SKIPPED: golden_wasm: there is no {" and no ".join(missing)}'.replace('EMXX-NOTFOUND', 'em++'), flush=True)
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
