#!/usr/bin/env python3
"""control_test.py RIGSOUND RIGSOUNDD ROOT: the control protocol as other people's programs speak it, held against its schema."""
import json
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import unittest

import jsonschema

from daemon_case import PATIENCE_S, DaemonCase, free_port, wait_for

RIGSOUND, RIGSOUNDD, ROOT = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
TOKEN = '0123456789abcdef-very-secret'
SCHEMA = json.loads((ROOT / 'tools/rigsoundd/control.schema.json').read_text())


def validator(part):
    return jsonschema.Draft202012Validator({**SCHEMA, 'oneOf': [{'$ref': f'#/$defs/{part}'}]})


REQUEST, ANSWER, EVENT, STATUS = map(validator, ('request', 'answer', 'event', 'status'))


class Client:
    """A line each way; what is said and what comes is held against the schema."""
    def __init__(self, connected):
        connected.settimeout(PATIENCE_S)
        self.socket, self.lines = connected, connected.makefile('r')

    def say(self, text):
        self.socket.sendall(text.encode() + b'\n')

    def next(self):
        line = self.lines.readline()
        return json.loads(line) if line else None

    def ask(self, **request):
        REQUEST.validate(request)
        self.say(json.dumps(request))
        answer = self.next()
        ANSWER.validate(answer)
        return answer

    def close(self):
        self.lines.close()
        self.socket.close()


class Case(DaemonCase):
    def write_rig(self, control=''):
        self.rig.write_text('[audio]\ndevice = "null"\nblock = 256\n[sound]\nset = "set"\n[[boom]]\n[[boom]]\n'
                            f'[control]\nsocket = "{self.socket}"\n{control}')

    def start(self, control='', *words):
        self.write_rig(control)
        return self.start_daemon('--manual', *words)

    def tcp(self, token=TOKEN + '\n', mode=0o600):
        self.port = free_port()
        self.token = self.folder / 'token'
        self.token.write_text(token)
        self.token.chmod(mode)
        return f'tcp = "127.0.0.1:{self.port}"\ntoken_file = "token"\n'

    def refused(self, control):
        """The one line of a daemon that does not start."""
        self.write_rig(control)
        result = subprocess.run([RIGSOUNDD, self.rig, '--manual'], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual((result.returncode, result.stderr.count('\n')), (1, 1), result.stderr)
        return result.stderr.rstrip('\n')

    def connect(self, address=None):
        family = socket.AF_UNIX if address is None else socket.AF_INET
        connected = socket.socket(family)
        connected.connect(str(self.socket) if address is None else address)
        client = Client(connected)
        self.addCleanup(client.close)
        return client


class Schema(Case):
    def test_every_request_and_answer_is_what_the_schema_says(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        self.start('', '--session', self.folder / 'sessions')
        client = self.connect()
        status = client.ask(command='status')
        STATUS.validate(status)
        for name, limits in (('feed_pressure_bar', 130), ('boom2.rattling', 'open'), ('engine_rpm', 1500), ('boom1.decay_factor', 2)):
            self.assertTrue(client.ask(command='set', key=name, value=limits)['ok'])
        wait_for('impacts', lambda: client.ask(command='status')['booms'][0]['impacts_made_hz'] > 0)
        self.assertTrue(client.ask(command='metrics')['ok'])
        self.assertEqual(client.ask(command='mute', on=True)['muted'], True)
        self.assertEqual(client.ask(command='mute')['muted'], False)
        self.assertEqual(client.ask(command='release', key='boom2.rattling')['released'], ['boom2.rattling'])
        self.assertGreater(len(client.ask(command='release', key='all')['released']), 2)
        self.assertEqual(client.ask(command='reload')['not_applied'], [])
        self.assertFalse(client.ask(command='set', key='volume', value=1)['ok'])
        self.assertEqual(client.ask(command='subscribe', topics=['booms'], every_s=0.1)['topics'], ['booms'])
        EVENT.validate(client.next())

    def test_nonsense_is_no_request_of_the_schema_and_refused_by_the_daemon(self):
        self.start()
        client = self.connect()
        for text, error in (('{"command": "fly"}', 'unknown command'), ('{"command": "statsu"}', 'did you mean status?'), ('{}', 'unknown command'),
                            ('{"command": "set", "key": "feed_presure_bar", "value": 1}', 'did you mean feed_pressure_bar?'),
                            ('{"command": "set", "key": "engine_rpm"}', 'no value'), ('[]', 'one JSON object'), ('x', 'one JSON object'),
                            ('{"command": "subscribe", "every_s": 0}', 'every_s: is 0 s, expected 0.1...3600 s'),
                            ('{"command": "subscribe", "topics": ["signal"]}', 'did you mean signals?')):
            client.say(text)
            answer = client.next()
            ANSWER.validate(answer)
            self.assertFalse(answer['ok'], text)
            self.assertIn(error, answer['error'])
        for request in ({}, {'command': 'fly'}, {'command': 'set', 'key': 'a'}, {'command': 'subscribe', 'topics': []}, {'token': 1}):
            self.assertFalse(REQUEST.is_valid(request), request)

    def test_every_command_and_topic_stands_in_the_protocol(self):
        text = (ROOT / 'tools/rigsoundd/PROTOCOL.md').read_text()
        commands = set(re.findall(r'^\| `\{"command": "(\w+)"', text, re.M))
        told = [SCHEMA['$defs'][ref['$ref'].rsplit('/', 1)[1]] for ref in SCHEMA['$defs']['request']['oneOf']]
        known = {word for one in told if 'command' in one['properties'] for word in
                 one['properties']['command'].get('enum', [one['properties']['command'].get('const')])}
        self.assertEqual(commands, known)
        for topic in SCHEMA['$defs']['topic']['enum']:
            self.assertIn(f'`{topic}`', text)


class Subscribe(Case):
    def test_what_changes_is_pushed_until_ctrl_c(self):
        self.start()
        watcher = subprocess.Popen([RIGSOUND, 'ctl', '--socket', self.socket, 'subscribe', '--json', '--every', '0.1', '--topics', 'signals,booms'],
                                   stdout=subprocess.PIPE, text=True)
        self.addCleanup(watcher.wait)
        self.addCleanup(watcher.stdout.close)
        self.addCleanup(watcher.kill)
        event = json.loads(watcher.stdout.readline())
        EVENT.validate(event)
        self.assertEqual(event['change']['muted'], False)
        self.assertEqual(event['change']['booms']['boom2']['situation'], 'underfeed')
        self.ctl('set', 'boom2.feed_pressure_bar', '160')
        seen = {}
        while 'overfeed' not in seen.values():
            event = json.loads(watcher.stdout.readline())
            EVENT.validate(event)
            seen.update({'feed': event['change'].get('signals', {}).get('boom2.feed_pressure_bar', {}).get('value', seen.get('feed')),
                         'situation': event['change'].get('booms', {}).get('boom2', {}).get('situation')})
        self.assertEqual(seen['feed'], 160)
        watcher.send_signal(signal.SIGINT)
        self.assertEqual(watcher.wait(timeout=PATIENCE_S), 130)

    def test_lines_for_people_name_each_value(self):
        daemon = self.start()
        watcher = subprocess.Popen([RIGSOUND, 'ctl', '--socket', self.socket, 'subscribe', '--topics', 'signals'], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(watcher.stdout.close)
        self.addCleanup(watcher.stderr.close)
        def line_with(part):
            return next(line for line in watcher.stdout if part in line).split(' ', 1)[1]
        self.assertEqual(line_with('engine_rpm.unit'), 'signals.engine_rpm.unit r/min\n')
        self.ctl('set', 'engine_rpm', '1500')
        self.assertEqual(line_with('engine_rpm.validity manual'), 'signals.engine_rpm.validity manual\n')
        self.ctl('mute', 'on')
        self.assertEqual(line_with('muted true'), 'muted true\n')
        daemon.send_signal(signal.SIGTERM)
        self.assertEqual(watcher.wait(timeout=PATIENCE_S), 3)
        self.assertIn('rigsoundd has gone', watcher.stderr.read())

    def test_a_subscriber_that_does_not_read_holds_up_nobody(self):
        daemon = self.start()
        sleeper, other = self.connect(), self.connect()
        sleeper.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        sleeper.ask(command='subscribe', every_s=0.1)
        memory = lambda: int(re.search(r'VmRSS:\s+(\d+)', pathlib.Path(f'/proc/{daemon.pid}/status').read_text()).group(1))
        for i in range(200):
            other.ask(command='set', key='engine_rpm', value=1000 + i)
        before = memory()
        for i in range(2000):
            other.ask(command='set', key='engine_rpm', value=1000 + i)
        self.assertLess(memory() - before, 4096)
        sleeper.socket.settimeout(PATIENCE_S)
        state = {}
        while state != 2999:
            state = sleeper.next()['change'].get('signals', {}).get('engine_rpm', {}).get('value', state)


class Access(Case):
    def test_mode_and_group_are_those_of_the_rig(self):
        self.start('mode = "0606"\n')
        self.assertEqual(self.socket.stat().st_mode & 0o777, 0o606)

    def test_a_group_that_does_not_exist_is_refused_by_name(self):
        self.assertEqual(self.refused('group = "no-such-group"\n'),
                         f'{self.rig}:10: control.group: there is no group "no-such-group", expected one of this machine (getent group)')
        self.assertFalse(self.socket.exists())

    def test_a_socket_named_like_a_file_leaves_it(self):
        self.write_rig()
        self.rig.write_text(self.rig.read_text().replace(str(self.socket), str(self.rig)))
        before = self.rig.read_text()
        result = subprocess.run([RIGSOUNDD, self.rig, '--manual'], capture_output=True, text=True, timeout=PATIENCE_S)
        check = subprocess.run([RIGSOUND, 'check', self.rig], capture_output=True, text=True, timeout=PATIENCE_S)
        said = f'{self.rig}:9: control.socket: "{self.rig}" is a file, expected a socket, or nothing yet\n'
        self.assertEqual((result.returncode, result.stderr, self.rig.read_text()), (1, said, before))
        self.assertEqual((check.returncode, check.stdout, check.stderr), (1, '', said))


class Tcp(Case):
    def test_the_token_opens_the_connection_and_nothing_else_does(self):
        self.start(self.tcp())
        client = self.connect(('127.0.0.1', self.port))
        self.assertEqual(client.ask(token=TOKEN), {'ok': True})
        self.assertTrue(client.ask(command='status')['ok'])
        for first in ('{"command": "status"}', '{"token": ""}', json.dumps({'token': TOKEN[:-1]}), json.dumps({'token': TOKEN + 'x'}),
                      json.dumps({'token': TOKEN[:-1] + 'x'}), json.dumps({'token': TOKEN, 'command': 'status'}), json.dumps([TOKEN]), TOKEN,
                      'GET / HTTP/1.1\r', '{"token": null}'):
            stranger = self.connect(('127.0.0.1', self.port))
            stranger.say(first + '\n{"command": "mute", "on": true}')
            answer = stranger.next()
            ANSWER.validate(answer)
            self.assertFalse(answer['ok'], first)
            self.assertIsNone(stranger.next(), first)
        self.assertFalse(client.ask(command='status')['muted'])
        self.assertTrue(self.connect().ask(command='status')['ok'])  # the UNIX socket asks for none

    def test_only_loopback_and_only_with_a_token(self):
        where = f'{self.rig}:10: control.tcp: '
        for address in ('0.0.0.0:7000', '192.168.1.5:7000', '[::]:7000', 'localhost:7000', '127.0.0.1', '127.0.0.0/8:7000', '7000', 'x:y'):
            self.assertEqual(self.refused(f'tcp = "{address}"\ntoken_file = "token"\n'),
                             where + f'"{address}" is no address on this machine, expected 127.0.0.1:PORT, [::1]:PORT or ""')
        self.assertEqual(self.refused('tcp = "127.0.0.1:7000"\n'), where + 'lets every user of this machine in, expected token_file too')
        self.assertEqual(self.refused('token_file = "token"\n'),
                         f'{self.rig}:10: control.token_file: is asked for over tcp only, expected tcp too')

    def test_a_token_that_anybody_knows_is_none(self):
        for token in ('', '\n', 'short\n', 'fifteen-letters\n', 'two words and more letters\n', 'x' * 513, '\n' + TOKEN):
            self.assertIn(f'{self.folder}/token:1: is no token, expected 16...512 letters', self.refused(self.tcp(token)))
        for mode in (0o604, 0o602, 0o601):
            self.assertEqual(self.refused(self.tcp(mode=mode)),
                             f'{self.folder}/token: is open to every user, expected a token for few (chmod o= FILE)')
        control = self.tcp()
        self.token.unlink()
        self.assertEqual(self.refused(control), f'{self.folder}/token: cannot be read, expected the token of [control] tcp')
        check = subprocess.run([RIGSOUND, 'check', self.rig], capture_output=True, text=True)
        self.assertEqual((check.returncode, check.stderr), (1, f'{self.folder}/token: cannot be read, expected the token of [control] tcp\n'))
        self.start(self.tcp(mode=0o640))


class Examples(Case):
    def test_python(self):
        self.start()
        client = subprocess.Popen([sys.executable, ROOT / 'config/examples/control_client.py', self.socket, 'feed_pressure_bar', '160'],
                                  stdout=subprocess.PIPE, text=True)
        self.addCleanup(client.wait)
        self.addCleanup(client.stdout.close)
        self.addCleanup(client.kill)
        self.assertIn("'manual': True", client.stdout.readline())
        self.assertIn("'topics': ['booms', 'signals']", client.stdout.readline())
        self.assertTrue(any("'situation': 'overfeed'" in line for line in client.stdout))

    def test_c_sharp(self):
        if not shutil.which('mcs') or not shutil.which('mono'):
            print('\nSKIPPED: C# control client: no mcs and mono here', flush=True)
            self.skipTest('no mono')
        self.start(self.tcp())
        program = self.folder / 'ControlClient.exe'
        subprocess.run(['mcs', f'-out:{program}', ROOT / 'config/examples/ControlClient.cs'], check=True, timeout=PATIENCE_S)
        client = subprocess.Popen(['mono', program, str(self.port), self.token, 'feed_pressure_bar', '160'], stdout=subprocess.PIPE, text=True)
        self.addCleanup(client.wait)
        self.addCleanup(client.stdout.close)
        self.addCleanup(client.kill)
        for part in ('"ok":true', '"set":', '"topics":'):
            answer = json.loads(client.stdout.readline())
            self.assertIn(part, json.dumps(answer, separators=(',', ':')))
        for line in client.stdout:
            event = json.loads(line)
            EVENT.validate(event)
            if event['change'].get('booms', {}).get('boom1', {}).get('situation') == 'overfeed':
                return
        self.fail('no overfeed')


unittest.main(argv=sys.argv[:1])
