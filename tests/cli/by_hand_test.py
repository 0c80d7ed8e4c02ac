#!/usr/bin/env python3
"""by_hand_test.py RIGSOUND RIGSOUNDD: a rig by hand, without a bus, a card or its DBC, as a user sees it."""
import csv
import fcntl
import io
import json
import os
import pty
import re
import signal
import struct
import subprocess
import sys
import termios
import unittest

from daemon_case import PATIENCE_S, DaemonCase, wait_for

RIGSOUND, RIGSOUNDD = sys.argv[1], sys.argv[2]
RIG = '''[audio]
device = "null"
block = 256
[sound]
set = "set"
[control]
socket = "{socket}"
[[boom]]
[[boom]]
[[boom]]
[[boom]]
[[can]]
interface = "absent7"
dbc = "absent.dbc"
[can.signals]
engine_rpm = "A.B"
'''
def screen_of(bytes_seen, rows, columns):
    """What a terminal shows after these bytes: home, clear line, clear below and text are all that may come."""
    lines, row, column = [''] * rows, 0, 0
    for token in re.findall(r'\x1b\[[0-9;?]*[A-Za-z]|\r|\n|[^\x1b\r\n]+', bytes_seen.decode(errors='replace')):
        if token == '\x1b[H':
            row = column = 0
        elif token == '\x1b[K':
            lines[row] = lines[row][:column]
        elif token == '\x1b[J':
            lines[row + 1:] = [''] * (rows - row - 1)
        elif token == '\r':
            column = 0
        elif token == '\n':
            assert row + 1 < rows, 'the screen scrolls'
            row += 1
        else:
            assert not token.startswith('\x1b'), token
            lines[row] = lines[row][:column] + token + lines[row][column + len(token):]
            column += len(token)
            assert column <= columns, token
    return lines


class Manual(DaemonCase):
    def setUp(self):
        super().setUp()
        self.rig.write_text(RIG.format(socket=self.socket))
        self.sessions = self.folder / 'sessions'

    def status(self):
        return json.loads(self.ctl('status', '--json').stdout)

    def stop(self, daemon):
        daemon.send_signal(signal.SIGTERM)
        self.assertEqual(daemon.wait(timeout=PATIENCE_S), 0)

    def run_verb(self, *words):
        result = subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def test_by_hand_from_silence_to_the_debrief(self):
        daemon = self.start_daemon('--manual', '--session', self.sessions)
        self.assertIn('MANUAL, NO BUS', self.ctl('status').stdout)
        self.assertEqual(self.ctl('set', 'engine_rpm', '1500').stdout,
                         'engine_rpm 1500, by hand until `rigsound ctl release`\n')
        self.assertEqual(self.ctl('set', 'boom2.feed_pressure_bar', '160').returncode, 0)
        self.assertEqual(self.ctl('set', 'boom3.rattling', 'open').returncode, 0)
        self.assertEqual(self.ctl('set', 'boom1.mean_amplitude_db', '-6').stdout, 'boom1.mean_amplitude_db -6\n')
        wait_for('overfeed', lambda: self.status()['booms'][1]['feed_deviation'] > 1
                 and self.status()['booms'][1]['impacts_made_hz'] > 10)
        text = self.ctl('status').stdout
        self.assertRegex(text, r'boom2: overfeed, feed deviation \+1\.\d\d\n')
        self.assertRegex(text, r'boom3: open_rattling')
        self.assertRegex(text, r'banks: overfeed 100 % \(any rods, any rock\)')
        self.assertRegex(text, r'boom2\.feed_pressure_bar +160 bar +-  manual')
        self.assertIn('controls: mean_amplitude_db -6 dB', text)
        self.assertTrue(all(len(line) <= 100 for line in text.splitlines()), text)
        metrics = self.ctl('metrics').stdout
        self.assertIn('rigsound_signal_state{signal="engine_rpm",rigsound_signal_state="manual"} 1\n', metrics)
        self.assertIn('rigsound_card_playing 0\n', metrics)
        self.assertEqual(self.ctl('release', 'boom2.feed_pressure_bar').stdout, 'released boom2.feed_pressure_bar\n')
        self.assertEqual(len(self.ctl('release', 'all').stdout.splitlines()), 3)
        self.assertEqual(self.ctl('release', 'all').stdout, 'nothing to release\n')
        self.stop(daemon)

        told = self.run_verb('decode', self.rig, '--session', self.sessions)
        rows = list(csv.DictReader(io.StringIO(told.stdout)))
        values = lambda name: [row['value'] for row in rows if row['signal'] == name]
        self.assertEqual(values('engine_rpm'), ['1500', '0'])
        self.assertEqual(values('boom2.feed_pressure_bar'), ['160', '0'])
        self.assertEqual(values('boom3.rattling'), ['open', 'none'])
        self.assertEqual(values('mean_amplitude_db'), ['-6', '0'])
        self.assertEqual(values('boom2.situation'), ['underfeed', 'overfeed', 'underfeed'])
        self.assertEqual(values('manual')[:4],
                         ['engine_rpm', 'engine_rpm boom2.feed_pressure_bar',
                          'engine_rpm boom2.feed_pressure_bar boom3.rattling', 'engine_rpm boom3.rattling'])
        self.assertEqual(values('manual')[-1], 'none')
        times = [float(row['time_s']) for row in rows]
        self.assertEqual(times, sorted(times))
        sounds = [self.run_verb('render', self.rig, '--session', self.sessions, '--out', self.folder / f'{i}.wav').stdout.split()[1]
                  for i in range(2)]
        self.assertEqual(sounds[0], sounds[1])
        states = self.folder / 'states.csv'
        states.write_text(told.stdout)
        self.run_verb('timeline', self.folder / 's.png', '--wav', self.folder / '0.wav', '--states', states)

    def test_the_last_thing_that_is_heard_is_silence(self):
        """Else the card is closed on a sound that the session has and nobody heard."""
        daemon = self.start_daemon('--manual', '--session', self.sessions)
        self.ctl('set', 'boom1.feed_pressure_bar', '160')
        wait_for('sound', lambda: self.status()['meters']['peak_db'] > -40)
        self.stop(daemon)
        self.run_verb('render', self.rig, '--session', self.sessions, '--out', self.folder / 'out.wav')
        sound = (self.folder / 'out.wav').read_bytes()
        silent = (len(sound) - len(sound.rstrip(b'\0'))) // (2 * 4)
        self.assertGreaterEqual(silent, 256 * 3)

    def test_a_session_of_an_engine_that_sounds_otherwise_is_told(self):
        daemon = self.start_daemon('--manual', '--session', self.sessions)
        self.ctl('set', 'boom1.feed_pressure_bar', '160')
        self.stop(daemon)
        session = next(self.sessions.glob('*.rigsession'))
        render = lambda: self.run_verb('render', self.rig, '--session', session, '--out', self.folder / 'out.wav').stderr
        self.assertNotIn('engine', render())
        bytes_ = session.read_bytes()
        word = re.search(rb'\nengine ([0-9a-f]{8})\n', bytes_).group(1)
        session.write_bytes(bytes_.replace(b'\nengine ' + word, b'\nengine 01234567', 1))
        self.assertIn(f'{session}: was played by an engine of another sound, 01234567, this one is {word.decode()}', render())
        session.write_bytes(bytes_.replace(b'\nengine ' + word, b'', 1))
        self.assertIn(f'{session}: does not say which engine played it', render())

    def test_a_rig_named_as_the_folder_of_sessions_is_refused_and_stays(self):
        before = self.rig.read_bytes()
        result = subprocess.run([RIGSOUNDD, self.rig, '--manual', '--session', self.rig], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual((result.returncode, result.stderr), (1, f'{self.rig}: is no folder, expected one for sessions, or a new name\n'))
        self.assertEqual((self.rig.read_bytes(), sorted(path.name for path in self.folder.iterdir())), (before, ['rig.toml', 'set']))

    def test_what_cannot_be_set_is_refused_with_what_can(self):
        daemon = self.start_daemon('--manual')
        for words, part in ((('feed_pressure_bar', '400'), 'feed_pressure_bar: is 400 bar, expected 0...300 bar'),
                            (('boom2.rattling', 'opn'), 'rattling: is opn, did you mean open?'),
                            (('feed_presure_bar', '4'), 'did you mean feed_pressure_bar?'),
                            (('bom2.rattling', 'open'), 'bom2: is no boom of the rig, did you mean boom2?')):
            result = self.ctl('set', *words)
            self.assertEqual((result.returncode, result.stdout, result.stderr.count('\n')), (1, '', 1))
            self.assertIn(part, result.stderr)
        self.stop(daemon)

    def watch(self, seen, rows=24, columns=80):
        """A watch in a terminal of that size; `seen` is asked for each screen. Returns the first it likes."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack('HHHH', rows, columns, 0, 0))
        watch = subprocess.Popen([RIGSOUND, 'ctl', '--socket', self.socket, 'watch', '--every', '0.05'], stdout=theirs)
        os.close(theirs)
        try:
            shown = b''
            while True:
                shown += os.read(ours, 65536)
                views = shown.split(b'\x1b[H')
                for view in views[1:-1]:
                    lines = screen_of(b'\x1b[H' + view, rows, columns)
                    if seen(lines):
                        return lines
                shown = b'\x1b[H' + views[-1]
        finally:
            watch.kill()
            watch.wait()
            os.close(ours)

    def test_watch_fits_a_small_terminal_with_four_booms(self):
        daemon = self.start_daemon('--manual')
        for words in (('engine_rpm', '1500'), ('feed_pressure_bar', '95'), ('boom2.feed_pressure_bar', '160'),
                      ('boom3.rattling', 'closed'), ('boom4.percussion', 'off'), ('rod_count', '6'), ('rock', '2'),
                      ('percussion_rate_hz', '40'), ('boom4.decay_factor', '2'), ('percussion_pressure_bar', '120')):
            self.assertEqual(self.ctl('set', *words).returncode, 0)
        lines = self.watch(lambda lines: any('overfeed' in line for line in lines))
        text = '\n'.join(lines)
        self.assertIn('MANUAL, NO BUS', lines[0])
        self.assertIn('peak', text)
        for word in ('boom4', 'situation', 'closed rattle', 'impacts wanted/made Hz', '95 manual', 'rod_count', 'decay_factor'):
            self.assertIn(word, text)
        short = self.watch(lambda lines: any('more lines' in line for line in lines), rows=12)
        self.assertIn('peak', '\n'.join(short))
        self.stop(daemon)

    def test_watch_waits_for_a_daemon_and_when_it_has_gone(self):
        self.watch(lambda lines: 'waiting for rigsoundd' in lines[0])
        daemon = self.start_daemon('--manual')
        self.watch(lambda lines: lines[0].startswith('rigsoundd rig.toml'))
        self.stop(daemon)
        self.watch(lambda lines: 'waiting for rigsoundd' in lines[0])


class Help(unittest.TestCase):
    def test_set_and_release_list_what_can_be_set_and_the_daemon_the_first_sound(self):
        for command, example in (('set', 'feed_pressure_bar 130'), ('release', 'feed_pressure_bar')):
            text = subprocess.run([RIGSOUND, 'ctl', command, '--help'], capture_output=True, text=True).stdout
            self.assertIn(f'Example: rigsound ctl {command} {example}', text)
            self.lists_all(text)
        text = subprocess.run([RIGSOUNDD, '--help'], capture_output=True, text=True).stdout
        self.assertEqual(text.count('rigsound ctl set '), 3)

    def lists_all(self, text):
        for line in ('feed_pressure_bar 0...300 bar: feed; 0: not feeding', 'rattling none,closed,open: rattling mode',
                     'percussion_rate_hz 0 or 5...120 Hz: impacts a second', 'mean_amplitude_db -60...24 dB: level of the clicks'):
            self.assertIn(line, text)


unittest.main(argv=sys.argv[:1])
