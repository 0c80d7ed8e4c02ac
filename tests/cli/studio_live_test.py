#!/usr/bin/env python3
"""studio_live_test.py RIGSOUND RIGSOUNDD: the studio passes on what a running daemon says and is told."""
import http.client
import json
import re
import subprocess
import sys
import unittest

from daemon_case import PATIENCE_S, DaemonCase


class Live(DaemonCase):
    def setUp(self):
        super().setUp()
        self.rig.write_text(f'[audio]\ndevice = "null"\n[sound]\nset = "set"\n[control]\nsocket = "{self.socket}"\n')
        pages = self.folder / 'pages'
        pages.mkdir()
        (pages / 'index.html').write_text('page')
        self.studio = subprocess.Popen([sys.argv[1], 'studio', self.folder / 'set', '--pages', pages, '--daemon', self.socket],
                                       stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.studio.stdout.close)
        self.addCleanup(self.studio.wait)
        self.addCleanup(self.studio.kill)
        self.port, self.token = re.search(r':(\d+)/#(\w+)', self.studio.stdout.readline()).groups()

    def ask(self, method, path, body=None):
        connection = http.client.HTTPConnection('127.0.0.1', int(self.port), timeout=PATIENCE_S)
        self.addCleanup(connection.close)
        connection.request(method, '/api/v1' + path, json.dumps(body) if body else None,
                           {'X-Rigsound-Token': self.token, 'Content-Type': 'application/json'})
        return connection.getresponse()

    def test_without_a_daemon_it_says_so(self):
        self.assertEqual(self.ask('POST', '/live', {'command': 'status'}).status, 503)
        self.assertEqual(self.ask('GET', '/live/events').status, 503)

    def test_what_is_set_is_heard_of_until_the_daemon_goes(self):
        daemon = self.start_daemon('--manual')
        events = self.ask('GET', '/live/events')
        self.assertEqual(events.status, 200)
        first = json.loads(events.readline())
        self.assertEqual((first['event'], 'signals' in first['change']), ('change', True))
        answer = json.loads(self.ask('POST', '/live', {'command': 'set', 'key': 'feed_pressure_bar', 'value': 130}).read())
        self.assertEqual((answer['ok'], answer['set'][0]['value']), (True, 130))
        for line in events:
            signals = json.loads(line).get('change', {}).get('signals', {})
            if signals.get('feed_pressure_bar', {}).get('value') == 130:
                break
        else:
            self.fail('never told')
        refused = self.ask('POST', '/live', {'command': 'set', 'key': 'feed_pressure_bar', 'value': 9000})
        self.assertEqual(refused.status, 400, refused.read())
        self.assertEqual(self.ask('POST', '/live', {'command': 'subscribe'}).status, 400)
        daemon.kill()
        last = [json.loads(line) for line in events][-1]
        self.assertEqual(last['event'], 'gone')


unittest.main(argv=sys.argv[:1])
