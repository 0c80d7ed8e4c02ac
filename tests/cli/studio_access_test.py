#!/usr/bin/env python3
"""studio_access_test.py RIGSOUND: the server of `rigsound studio` lets in its own page alone."""
import pathlib
import socket
import subprocess
import sys
import unittest

from studio_case import PATIENCE_S, StudioCase, write_recording

RIGSOUND = sys.argv[1]


class WhoMayAsk(StudioCase):
    def setUp(self):
        super().setUp()
        self.start()

    def test_the_page_needs_no_token_and_everything_else_does(self):
        here = {'Host': f'127.0.0.1:{self.port}'}
        page = self.raw('GET', '/', headers=here)
        self.assertEqual((page.status, b'<title>studio</title>' in page.body), (200, True))
        self.assertEqual(self.raw('GET', '/app.js', headers=here).headers['content-type'], 'text/javascript; charset=utf-8')
        for token in (None, '', 'x' * 32, self.token[:-1], self.token + '0'):
            self.assertEqual(self.ask('GET', '/state', X_Rigsound_Token=token).status, 401, token)
        self.assertEqual(self.ask('GET', '/state').status, 200)

    def test_a_host_that_is_another_is_refused(self):
        for host in (None, 'evil.example', f'evil.example:{self.port}', '127.0.0.1', f'127.0.0.1:{self.port + 1}',
                     f'127.0.0.1.evil.example:{self.port}'):
            for path in ('/', '/api/v1/state'):
                self.assertEqual(self.raw('GET', path, headers={
                    k: v for k, v in {'Host': host, 'X-Rigsound-Token': self.token}.items() if v is not None}).status, 403, host)
        self.assertEqual(self.ask('GET', '/state', Host=f'localhost:{self.port}').status, 200)

    def test_an_origin_that_is_another_page_is_refused(self):
        for origin in ('http://evil.example', 'null', f'https://127.0.0.1:{self.port}', f'http://127.0.0.1:{self.port + 1}'):
            for method in ('GET', 'POST'):
                self.assertEqual(self.ask(method, '/jobs', {} if method == 'POST' else None, Origin=origin).status, 403, origin)
        self.assertEqual(self.ask('GET', '/state', Origin=f'http://127.0.0.1:{self.port}').status, 200)
        self.assertEqual(self.ask('POST', '/jobs', {}, Sec_Fetch_Site='cross-site').status, 403)

    def test_headers_keep_the_page_to_itself(self):
        page = self.raw('GET', '/', headers={'Host': f'127.0.0.1:{self.port}'})
        policy = page.headers['content-security-policy']
        self.assertNotIn('unsafe-inline', policy)
        self.assertNotIn("'unsafe-eval'", policy)
        self.assertIn("default-src 'none'", policy)
        self.assertIn("frame-ancestors 'none'", policy)
        self.assertEqual(page.headers['x-content-type-options'], 'nosniff')

    def test_requests_are_bounded(self):
        self.assertEqual(self.ask('POST', '/jobs', {'kind': 'x' * (1 << 20)}).status, 413)
        self.assertEqual(self.ask('POST', '/listen/results', {'csv': 'x' * (1 << 20)}).status, 201)
        self.assertEqual(self.ask('POST', '/listen/results', {'csv': 'x' * (4 << 20)}).status, 413)
        headers = {'Host': f'127.0.0.1:{self.port}', 'X-Rigsound-Token': self.token, 'Content-Type': 'application/json'}
        deep = b'{"kind":' + b'[' * 100000
        self.assertEqual(self.raw('POST', '/api/v1/jobs', deep, headers).status, 400)
        self.assertEqual(self.raw('POST', '/api/v1/jobs', b'kind', headers).status, 400)
        self.assertEqual(self.raw('POST', '/api/v1/jobs', b'{}', {**headers, 'Content-Type': 'text/plain'}).status, 415)
        self.assertEqual(self.raw('POST', '/api/v1/jobs', b'{}', {**headers, 'Content-Encoding': 'gzip'}).status, 415)
        with socket.create_connection(('127.0.0.1', self.port), PATIENCE_S) as endless:
            endless.sendall((f'POST /api/v1/jobs HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nX-Rigsound-Token: {self.token}\r\n'
                             'Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n').encode())
            self.assertIn(b' 411 ', endless.recv(4096).split(b'\r\n')[0])
        self.assertEqual(self.raw('GET', '/' + 'a' * 20000, headers=headers).status, 414)
        self.assertEqual(self.ask('GET', '/state').status, 200)

    def test_only_this_machine_is_answered(self):
        listening = [line.split()[1] for line in pathlib.Path('/proc/net/tcp').read_text().splitlines()[1:]
                     if line.split()[3] == '0A']
        self.assertIn(f'0100007F:{self.port:04X}', listening)
        self.assertNotIn(f'00000000:{self.port:04X}', listening)


class WhatMayBeRead(StudioCase):
    def setUp(self):
        super().setUp()
        self.secret = self.folder / 'secret.wav'
        write_recording(self.secret, 1)
        write_recording(self.recordings / 'a.wav', 2)
        (self.recordings / 'link.wav').symlink_to(self.secret)
        (self.recordings / 'a.txt').symlink_to(self.folder / 'elsewhere.txt')
        (self.pages / 'out.js').symlink_to('/etc/hostname')
        (self.sound_set / 'banks/away').symlink_to(self.folder)
        (self.sound_set / 'tools').symlink_to(self.folder)
        self.start()

    def test_paths_and_links_that_leave_the_folders_lead_nowhere(self):
        here = {'Host': f'127.0.0.1:{self.port}', 'X-Rigsound-Token': self.token}
        for path in ('/../secret.wav', '/%2e%2e/secret.wav', '/..%2fsecret.wav', '/app.js/../../secret.wav', '/out.js',
                     '//etc/passwd', '/%00'):
            self.assertEqual(self.raw('GET', path, headers=here).status, 404, path)
        state = self.get('/state').json
        self.assertEqual([r['name'] for r in state['recordings']], ['a.wav'])
        for bank in ('..', '%2e%2e', '..%2f..%2fsecret.wav', 'away', '.', 'none'):
            self.assertIn(self.ask('GET', f'/banks/{bank}').status, (403, 404), bank)
        for result in ('..%2fsoundset.toml', '..'):
            self.assertEqual(self.ask('GET', f'/listen/results/{result}').status, 404)

    def test_a_label_track_that_is_a_link_is_not_written(self):
        recording = self.recording_id('a.wav')
        reply = self.ask('PUT', f'/recordings/{recording}/labels', {
            'version': 'absent', 'parts': [{'from_s': 0, 'to_s': 1, 'situation': 'normal'}]})
        self.assertEqual(reply.status, 403, reply.body)
        self.assertFalse((self.folder / 'elsewhere.txt').exists())


class WrongUsage(StudioCase):
    def run_studio(self, *words):
        result = subprocess.run([RIGSOUND, 'studio', *map(str, words)], capture_output=True, text=True, timeout=PATIENCE_S)
        return result.returncode, result.stderr

    def test_what_is_not_there_is_one_line(self):
        for code, text, words in (
                (1, 'expected one of a sound set', [self.folder / 'none/set', '--pages', self.pages]),
                (1, 'expected one of recordings', [self.sound_set, '--recordings', self.folder / 'none', '--pages', self.pages]),
                (1, 'holds no index.html', [self.sound_set, '--pages', self.folder])):
            self.assertEqual((self.run_studio(*words)[0], text in self.run_studio(*words)[1]), (code, True), words)

    def test_a_port_that_is_taken_is_told(self):
        self.start()
        code, text = self.run_studio(self.sound_set, '--pages', self.pages, '--port', self.port)
        self.assertEqual((code, 'cannot be listened at' in text), (3, True), text)


unittest.main(argv=sys.argv[:1])
