#!/usr/bin/env python3
"""bad_input_test.py RIGSOUND ROOT: what `decode`, `check` and `render` refuse, and with which line.

ROOT is the project.
"""
import shutil
import sys
import unittest

from rig_case import MINIMAL, ROOT, RigCase, run
from sound_set import write_bank, write_sound_set


class BadInput(RigCase):
    def setUp(self):
        super().setUp()
        self.text = MINIMAL.format(dbc=ROOT / 'config/dbc/rig.dbc', signal='EEC1.EngSpeed')
        self.rig = self.write('rig.toml', self.text)
        self.log = self.short_log(1)

    def test_missing_files(self):
        self.refused(['decode', 'no.toml', '--log', self.log], 'no.toml: cannot be opened')
        self.refused(['decode', self.rig, '--log', 'no.log'], 'no.log: cannot be opened')
        self.refused(['decode', self.folder, '--log', self.log], 'is a folder')

    def test_truncated_log(self):
        text = self.log.read_text()
        lines = text.count('\n')
        for cut in (2, 9, 20, 30, 40):
            log = self.write('cut.log', text[:-cut])
            self.refused(['decode', self.rig, '--log', log], f'cut.log:{lines}: the log ends in the middle of a frame')

    def test_log_without_frames(self):
        self.refused(['decode', self.rig, '--log', self.write('e.log', '')], 'holds no CAN frame')
        self.refused(['decode', self.rig, '--log', self.rig], 'holds no CAN frame')
        other = self.text.replace('can0', 'can7') + '[[can]]\ninterface = "can8"\ndbc = "%s"\n' % (ROOT / 'config/dbc/rig.dbc')
        self.refused(['decode', self.write('r.toml', other), '--log', self.log], 'has frames of can0 only, expected some of can7, can8')

    def test_rig_mistakes(self):
        for old, new, *parts in (
                ('interface', 'interfce', ':2: can.interfce: is not known here', "did you mean 'interface'?"),
                ('"can0"', 'can0', ':2: '),
                ('[[can]]', '[can', ':1: '),
                ('[[can]]', '[audio]\nrate = 0\n[[can]]', ':2: audio.rate: is 0 Hz, expected', '32000'),
                ('[[can]]', '[audio]\nrate = "fast"\n[[can]]', ':2: audio.rate: is text, expected a number'),
                ('[[can]]', '[audio]\nblock = 65\n[[can]]', ':2: audio.block: is 65 frames, expected 32...8192 frames, a multiple of 32'),
                ('[[can]]', '[audoi]\nblock = 64\n[[can]]', ':1: audoi: is not known here', "did you mean 'audio'?"),
                ('[[can]]', '[scene]\nunderfeed_bar = 130\n[[can]]', ':2: scene.underfeed_bar: is 130 bar, expected at most overfeed_bar'),
                ('engine_rpm', 'engine_rmp', ':5: can.signals.engine_rmp: is no machine signal', "did you mean 'engine_rpm'?"),
                ('EEC1.', 'EEC7.', ":5: can.signals.engine_rpm: there is no message 'EEC7'", "did you mean 'EEC1'?"),
                ('EngSpeed', 'EngSped', ":5: can.signals.engine_rpm: there is no signal 'EngSped'", "did you mean 'EngSpeed'?"),
                ('EEC1.EngSpeed', 'EngSpeed', 'has no dot'),
                ('rig.dbc', 'gone.dbc', ':3: can.dbc: there is no file'),
                ('"EEC1.EngSpeed"', '"EEC1.EngSpeed"\n[safety]\nengine_rpm = "idel"', ':7: safety.engine_rpm: "idel" is not known, expected one of hold, idle, mute')):
            rig = self.write('bad.toml', self.text.replace(old, new, 1))
            self.refused(['decode', rig, '--log', self.log], rig, *parts)

    def test_dbc_mistakes(self):
        dbc = (ROOT / 'config/dbc/rig.dbc').read_text(encoding='utf-8')
        rig = self.write('r.toml', self.text.replace(str(ROOT / 'config/dbc/rig.dbc'), 'bad.dbc'))
        self.write('bad.dbc', dbc.replace('24|16@1+', '24|16@2+'))
        self.refused(['decode', rig, '--log', self.log], 'bad.dbc:15: SG_: ', 'expected a byte order')
        self.write('bad.dbc', dbc.replace('24|16@1+', '56|16@1+'))
        self.refused(['decode', rig, '--log', self.log], 'bad.dbc:15: EEC1.EngSpeed: does not fit into the 8 bytes')
        self.write('bad.dbc', 'hello')
        self.refused(['decode', rig, '--log', self.log], 'bad.dbc: holds no message')
        self.write('bad.dbc', dbc[:-20])  # the last section is about DRILL1, which this rig does not use
        self.assertEqual(run('decode', rig, '--log', self.log).returncode, 0)
        rig = self.write('r.toml', self.text.replace(str(ROOT / 'config/dbc/rig.dbc'), 'bad.dbc').replace('EEC1.EngSpeed', 'DRILL1.FeedPressure'))
        self.refused(['decode', rig, '--log', self.log], 'can.signals.engine_rpm: DRILL1 cannot be read: ', 'bad.dbc:')

    def test_sound_set_mistakes(self):
        rig = self.demo_rig()
        out = self.folder / 'out.wav'
        words = ['render', rig, '--log', self.log, '--out', out]
        self.refused(words, ':17: sound.set: there is no folder')
        self.refused(['render', self.rig, '--log', self.log, '--out', out], 'sound.set: is missing')
        set_folder = write_sound_set(self.folder / 'set')
        (set_folder / 'banks/overfeed/clicks.wav').write_bytes(b'')
        self.refused(words, 'banks/overfeed/clicks.wav: ')
        shutil.rmtree(set_folder / 'banks/overfeed')
        write_bank(set_folder / 'banks/overfeed', 48000, 30, 900, T0=float('nan'))
        self.refused(words, 'banks/overfeed/bank.json:4: is not valid JSON here')
        shutil.rmtree(set_folder / 'banks/overfeed')
        self.refused(words, 'soundset.toml:9: bank.name: there is no folder')

    def test_truncated_log_leaves_no_sound(self):
        write_sound_set(self.folder / 'set')
        log = self.write('cut.log', self.log.read_text()[:-9])
        out = self.write('out.wav', 'old')
        self.refused(['render', self.demo_rig(), '--log', log, '--out', out], 'the log ends in the middle')
        self.assertEqual(out.read_text(), 'old')

    def test_wrong_usage_and_machine_failures(self):
        self.assertEqual(run('decode').returncode, 2)
        self.assertEqual(run('render', self.rig, '--log', self.log).returncode, 2)
        self.assertEqual(run('check', self.rig, '--colour').returncode, 2)
        write_sound_set(self.folder / 'set')
        result = run('render', self.demo_rig(), '--log', self.log, '--out', '/nonexistent/folder/a.wav')
        self.assertEqual(result.returncode, 3, result.stderr)

    def test_help_shows_an_example(self):
        for verb in ('decode', 'check', 'render'):
            result = run(verb, '--help')
            self.assertEqual(result.returncode, 0)
            self.assertIn(f'Example: rigsound {verb} ', result.stdout)


class Check(RigCase):
    def test_demo_rig(self):
        write_sound_set(self.folder / 'set', 44100)
        result = run('check', self.demo_rig())
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.splitlines()[0], 'ok')
        for part in ('5 banks, 30 clicks', 'EEC1.EngSpeed', 'stale after 100 ms: idle', '127.0.0.1:1502', 'holding 0 = 40001'):
            self.assertIn(part, result.stdout)

    def test_a_tool_that_is_not_there(self):
        write_sound_set(self.folder / 'set')
        rig = self.demo_rig(**{'# no tool': 'tool = "rods"'})
        self.refused(['check', rig], 'boom.tool: the sound set', "has no tool 'rods'")


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
