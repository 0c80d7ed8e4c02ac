#!/usr/bin/env python3
"""outputs_test.py RIGSOUND ROOT: no verb writes over what it reads, by whatever name or link. ROOT is the project."""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from folder_case import FolderCase
from sound_files import strikes, write_wav
from sound_set import write_sound_set

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])


class Outputs(FolderCase):
    def setUp(self):
        super().setUp()
        at = self.folder
        self.set = write_sound_set(at / 'set')
        self.clicks = self.set / 'banks/normal/clicks.wav'
        self.dbc = shutil.copy(ROOT / 'config/dbc/rig.dbc', at / 'rig.dbc')
        self.rig = self.write('rig.toml', '[sound]\nset = "set"\n[[can]]\ninterface = "can0"\ndbc = "rig.dbc"\n'
                                          '[can.signals]\nengine_rpm = "EEC1.EngSpeed"\n')
        self.log = self.write('in.log', '(1.000000) can0 0CF00400#000000409C000000\n')
        self.states = self.write('states.csv', 'time_s,signal,value\n0,engine_rpm,800\n')
        self.sound = write_wav(at / 'in.wav', [strikes(0.6)])
        self.labels = self.write('in.txt', '0.0\t0.5\tnormal\n')
        self.track = self.write('rpm.csv', 'time_s,rpm\n0,800\n0.6,800\n')

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def contents(self):
        return {path: path.read_bytes() for path in self.folder.rglob('*') if path.is_file()}

    def refused(self, *words):
        before = self.contents()
        result = subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=120)
        self.assertEqual((result.returncode, result.stdout), (1, ''), (words, result.stderr))
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        self.assertIn(', expected ', result.stderr)
        self.assertEqual(self.contents(), before, words)

    def names_of(self, file, ending=None):
        """The file by its name, by a way around, through a symbolic link and by a hard link; links of that ending."""
        file = pathlib.Path(file)
        names = [file, file.parent / '..' / file.parent.name / file.name, self.folder / ('soft' + (ending or file.suffix)),
                 self.folder / ('hard' + (ending or file.suffix))]
        for name in names[2:]:
            name.unlink(missing_ok=True)
        names[2].symlink_to(file)
        os.link(file, names[3])
        return names

    def test_render(self):
        for read in (self.dbc, self.clicks, self.set / 'soundset.toml'):
            for name in self.names_of(read, '.wav')[2:]:
                self.refused('render', self.rig, '--log', self.log, '--out', name)
        for read in (self.rig, self.log, self.clicks):
            for name in self.names_of(read):
                self.refused('render', self.rig, '--log', self.log, '--out', name)
        self.refused('render', self.rig, '--states', self.states, '--out', self.states)

    def test_record_and_pack_and_contrast(self):
        for read in (self.rig, self.dbc, self.clicks):
            for name in self.names_of(read):
                self.refused('record', self.rig, '--out', name, '--seconds', 1)
                self.refused('pack', self.set, name, '--rig', self.rig)
                self.refused('contrast', self.rig, '--report', name)

    def test_denoise(self):
        for name in self.names_of(self.sound):
            self.refused('denoise', self.sound, name)
            self.refused('denoise', self.sound, self.folder / 'new.wav', '--noise', name)
        self.refused('denoise', self.sound, self.folder / 'new.wav', '--noise', self.folder / 'new.wav')
        self.refused('denoise', self.sound, self.folder / 'new.wav', '--dump', self.folder)
        self.refused('clicks', self.sound, '--dump', self.folder)

    def test_analyze(self):
        rig = ['--rig', self.rig, '--bus-log', self.log]
        for read in (self.sound, self.labels, self.set / 'soundset.toml', self.clicks):
            for name in self.names_of(read, '.html')[2:]:
                self.refused('analyze', self.sound, '--out', self.set, '--report', name)
        for read in (self.rig, self.dbc, self.log):
            for name in self.names_of(read, '.html')[2:]:
                self.refused('analyze', self.sound, '--out', self.set, *rig, '--report', name)
        other = self.write('other.html', '0.0\t0.5\tnormal\n')
        self.refused('analyze', self.sound, '--labels', other, '--out', self.set, '--report', other)
        # A bank takes the name of its recording, and with it the place of this one.
        shutil.copytree(self.set / 'banks/normal', self.set / 'banks/clicks')
        self.refused('analyze', self.set / 'banks/clicks/clicks.wav', '--out', self.set)

    def test_background(self):
        for read, words in ((self.sound, ['--rpm', 800]), (self.track, ['--rpm-track', self.track]),
                            (self.sound, ['--rpm', 800, '--start', self.sound]),
                            (self.clicks, ['--rpm', 800, '--stop', self.clicks]),
                            (self.track, ['--rpm', 800, '--clicks', self.track]),
                            (self.set / 'soundset.toml', ['--rpm', 800, '--out', self.set])):
            for name in self.names_of(read):
                self.refused('background', self.sound, *words, '--resynth', name)
                self.refused('background', self.sound, *words, '--resynth', self.folder / 'r.wav', '--plot', name)
        self.refused('background', self.sound, '--rpm', 800, '--resynth', self.track, '--resynth-track', self.track)
        same = self.folder / 'same.svg'
        self.refused('background', self.sound, '--rpm', 800, '--resynth', same, '--plot', same)
        start = self.set / 'backgrounds/diesel/start.wav'
        start.parent.mkdir(parents=True)
        shutil.copy(self.sound, start)
        self.refused('background', self.sound, '--rpm', 800, '--start', start, '--out', self.set, '--name', 'diesel')

    def test_tool_and_resynth_and_timeline(self):
        for name in self.names_of(self.sound):
            self.refused('tool', '--from', self.sound, '--plot', name)
            self.refused('timeline', self.picture(name), '--wav', self.sound, '--states', self.states)
        for name in self.names_of(self.set / 'soundset.toml'):
            self.refused('tool', '--length', 0.5, '--diameter', 0.025, '--out', self.set, '--plot', name)
            self.refused('tool', '--string', '--length', 3, '--diameter', 0.04, '--set', self.set, '--plot', name)
        for name in self.names_of(self.clicks):
            self.refused('resynth', self.clicks.parent, name, '--seconds', 1)
            self.refused('resynth', self.clicks.parent, self.folder / 'new.wav', '--seconds', 1, '--impacts', name)
        self.refused('resynth', self.clicks.parent, self.folder / 'n.wav', '--seconds', 1, '--impacts', self.folder / 'n.wav')

    def picture(self, sound):
        """A picture that is the sound, by a link that ends in .png."""
        link = self.folder / 'sound.png'
        link.unlink(missing_ok=True)
        link.symlink_to(sound)
        return link


unittest.main(argv=sys.argv[:1])
