#!/usr/bin/env python3
"""batch_test.py RIGSOUND: `analyze` of many recordings, in shards, as a cluster calls it."""
import os
import re
import shutil
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_set import write_sound_set

RIGSOUND = sys.argv[1]


class Case(FolderCase):
    def run_verb(self, *words, **environment):
        slurm_free = {key: value for key, value in os.environ.items() if not key.startswith('SLURM_')}
        return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300,
                              env={**slurm_free, **environment})


class SlurmArray(Case):
    def setUp(self):
        super().setUp()
        self.recordings = self.folder / 'in'
        self.recordings.mkdir()
        for i in range(7):  # refused at once, by name: which shard took which is told without any analysis
            (self.recordings / f'r{i}.wav').write_text('no sound')

    def task(self, number, first, last, count, **more):
        array = {'ID': number, 'MIN': first, 'MAX': last, 'COUNT': count, **more}
        return self.run_verb('analyze', self.recordings, '--out', self.folder / 'set', '--shard', 'auto',
                             **{f'SLURM_ARRAY_TASK_{key}': str(value) for key, value in array.items()})

    def taken(self, result):
        self.assertEqual(result.returncode, 1, result.stderr)
        return re.findall(r'(r\d)\.wav', result.stderr)

    def test_every_recording_is_done_once_whatever_the_array_begins_with(self):
        all_of_them = [f'r{i}' for i in range(7)]
        for numbers in (range(0, 4), range(1, 5), range(7, 9), range(0, 8, 2), range(5, 6)):
            ends = (numbers[0], numbers[-1], len(numbers))
            taken = [self.taken(self.task(n, *ends, STEP=numbers.step)) for n in numbers]
            self.assertEqual(sorted(sum(taken, [])), all_of_them, numbers)
            self.assertLessEqual(max(map(len, taken)) - min(map(len, taken)), 1, numbers)
        self.assertEqual(self.taken(self.task(0, 0, 3, 4)), ['r0', 'r4'])  # an older Slurm says no step

    def test_an_array_with_holes_is_refused_and_so_is_none(self):
        for task in ((3, 3, 7, 2), (1, 1, 5, 3), (2, 1, 5, 3)):
            result = self.task(*task)
            self.assertEqual((result.returncode, result.stdout), (2, ''))
            self.assertIn('leaves numbers out, expected an array such as 0-3', result.stderr)
        result = self.task('x', 0, 3, 4)
        self.assertEqual(result.returncode, 2)
        self.assertIn("SLURM_ARRAY_TASK_ID is 'x', expected a whole number", result.stderr)
        result = self.run_verb('analyze', self.recordings, '--out', self.folder / 'set', '--shard', 'auto')
        self.assertEqual(result.returncode, 2)
        self.assertIn('--shard: auto: SLURM_ARRAY_TASK_ID is not set, expected a task of a Slurm array', result.stderr)


class Merge(Case):
    def shards(self):
        """One sound set in two halves, as two shards leave it: no half serves every situation."""
        whole = write_sound_set(self.folder / 'whole')
        text = (whole / 'soundset.toml').read_text()
        entries = re.findall(r'\[\[bank\]\]\nname = "(\w+)"\nsituation = "\w+"\n', text)
        halves = []
        for i, names in enumerate((entries[:2], entries[2:])):
            half = self.folder / f'half{i}'
            shutil.copytree(whole, half)
            lines = ['format = 1', '[[rock]]', f'name = "rock{i}"']
            for name in set(entries) - set(names):
                shutil.rmtree(half / 'banks' / name)
            for name in names:
                lines += ['[[bank]]', f'name = "{name}"', f'situation = "{name}"', f'rock = "rock{i}"']
            (half / 'soundset.toml').write_text('\n'.join(lines) + '\n')
            halves.append(half)
        return halves, entries

    def banks(self, sound_set):
        return {path.relative_to(sound_set): path.read_bytes() for path in (sound_set / 'banks').rglob('*') if path.is_file()}

    def test_two_halves_are_one_set_that_plays(self):
        halves, names = self.shards()
        out = self.folder / 'out'
        result = self.run_verb('merge', *halves, '--out', out)
        self.assertEqual((result.returncode, result.stdout), (0, f'{out} banks=5 tools=0 backgrounds=0 sets=2\n'), result.stderr)
        self.assertEqual(self.banks(out), {**self.banks(halves[0]), **self.banks(halves[1])})
        index = (out / 'soundset.toml').read_text()
        self.assertEqual(sorted(re.findall(r'^name = "([a-z_]+)"$', index, re.M)), sorted(names))
        self.assertEqual(re.findall(r'\[\[rock\]\]\nname = "(rock\d)"', index), ['rock0', 'rock1'])
        rig = self.folder / 'rig.toml'
        rig.write_text('[sound]\nset = "out"\n')
        self.assertEqual(self.run_verb('check', rig).returncode, 0)
        again = self.run_verb('merge', *halves, '--out', out)  # nothing new, nothing twice
        self.assertEqual((again.returncode, (out / 'soundset.toml').read_text()), (0, index), again.stderr)

    def test_what_is_there_stays(self):
        halves, _ = self.shards()
        out = self.folder / 'out'
        shutil.copytree(halves[0], out)
        text = '# mine\n' + (out / 'soundset.toml').read_text()
        (out / 'soundset.toml').write_text(text)
        (out / 'notes.txt').write_text('mine')
        before = self.banks(halves[1])
        self.assertEqual(self.run_verb('merge', halves[1], '--out', out).returncode, 0)
        self.assertTrue((out / 'soundset.toml').read_text().startswith(text))
        self.assertEqual((out / 'notes.txt').read_text(), 'mine')
        self.assertEqual(len({path.parts[1] for path in self.banks(out)}), 5)
        self.assertEqual(self.banks(halves[1]), before)

    def test_conflicts_are_one_line_and_nothing_is_written(self):
        halves, names = self.shards()
        other = self.folder / 'other'

        def changed(change):
            shutil.rmtree(other, ignore_errors=True)
            shutil.copytree(halves[0], other)
            change()
        index, bank = other / 'soundset.toml', other / 'banks' / names[0]
        replaced = lambda file, old, new: file.write_text(file.read_text().replace(old, new, 1))
        for change, part in (
                (lambda: replaced(bank / 'bank.json', '"N_a": 10', '"N_a": 11'), f'{bank}: differs from {halves[0] / "banks" / names[0]}'),
                (lambda: replaced(index, f'situation = "{names[0]}"', f'situation = "{names[0]}"\nrods = 3'),
                 f'{index}: bank: {names[0]} is described in another way'),
                (lambda: replaced(index, 'name = "rock0"', 'name = "rock0"\nstiffness = 5e8'), f'{index}: rock: rock0 is described in another way'),
                (lambda: (bank / 'clicks.wav').write_bytes(b''), 'clicks.wav: '),
                (lambda: shutil.rmtree(bank), f'{bank}: is no bank folder')):
            changed(change)
            for out, there in ((self.folder / 'new', False), (halves[1], True)):
                before = self.banks(halves[1])
                result = self.run_verb('merge', halves[0], other, '--out', out)
                self.assertEqual((result.returncode, result.stdout, result.stderr.count('\n')), (1, '', 1), result.stderr)
                self.assertIn(part, result.stderr)
                self.assertEqual((out.exists(), self.banks(halves[1])), (there, before))
        for words in ([halves[0], '--out', halves[0]], [self.folder / 'absent', '--out', self.folder / 'new']):
            result = self.run_verb('merge', *words)
            self.assertEqual((result.returncode, result.stderr.count('\n')), (1, 1), result.stderr)
        self.assertEqual([path.name for path in self.folder.rglob('.*')], [])


unittest.main(argv=sys.argv[:1])
