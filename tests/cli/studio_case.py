"""A test that runs `rigsound studio`, asked over HTTP as a page asks it. sys.argv begins RIGSOUND."""
import http.client
import json
import math
import random
import re
import struct
import subprocess
import sys

from folder_case import FolderCase
from sound_set import write_sound_set

PATIENCE_S = 120


def write_recording(path, seconds, rate=48000, rate_hz=24, seed=1):
    """Clicks at an even rate over a little noise, 16 bit, mono."""
    chance = random.Random(seed)
    samples = [int(chance.gauss(0, 30)) for _ in range(int(seconds * rate))]
    for n in range(int(seconds * rate_hz)):
        at = int(n * rate / rate_hz)
        for i in range(min(600, len(samples) - at)):
            samples[at + i] += int(12000 * math.exp(-i / 100) * math.sin(0.3 * i))
    data = struct.pack(f'<{len(samples)}h', *samples)
    head = struct.pack('<4sI4s4sIHHIIHH4sI', b'RIFF', 36 + len(data), b'WAVE', b'fmt ', 16, 1, 1, rate, 2 * rate, 2, 16,
                       b'data', len(data))
    path.write_bytes(head + data)
    return path


class Reply:
    def __init__(self, response):
        self.status, self.body = response.status, response.read()
        self.headers = {name.lower(): value for name, value in response.getheaders()}

    @property
    def json(self):
        return json.loads(self.body)


class StudioCase(FolderCase):
    def setUp(self):
        super().setUp()
        self.sound_set = self.folder / 'set'
        self.recordings = self.folder / 'recordings'
        self.pages = self.folder / 'pages'
        self.recordings.mkdir()
        self.pages.mkdir()
        (self.pages / 'index.html').write_text('<!doctype html><title>studio</title>')
        (self.pages / 'app.js').write_text('export {};')
        write_sound_set(self.sound_set)

    def start(self, *words, **more):
        self.server = subprocess.Popen(
            [sys.argv[1], 'studio', self.sound_set, '--recordings', self.recordings, '--pages', self.pages, *map(str, words)],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)
        self.addCleanup(self.server.stderr.close)
        self.addCleanup(self.server.stdout.close)
        self.addCleanup(self.server.wait)
        self.addCleanup(self.server.kill)
        self.address = self.server.stdout.readline().strip()
        found = re.fullmatch(r'http://127\.0\.0\.1:(\d+)/#([0-9a-f]{32})', self.address)
        self.assertTrue(found, self.address or self.server.stderr.read())
        self.port, self.token = int(found[1]), found[2]

    def raw(self, method, path, body=None, headers=()):
        """With no header but those given and what HTTP itself needs."""
        connection = http.client.HTTPConnection('127.0.0.1', self.port, timeout=PATIENCE_S)
        try:
            connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
            for name, value in dict(headers).items():
                connection.putheader(name, value)
            if body is not None:
                connection.putheader('Content-Length', str(len(body)))
            connection.endheaders(body)
            return Reply(connection.getresponse())
        finally:
            connection.close()

    def ask(self, method, path, json_body=None, **headers):
        """As the page does. A header of None is left out."""
        wanted = {'Host': f'127.0.0.1:{self.port}', 'X-Rigsound-Token': self.token}
        body = None
        if json_body is not None:
            body = json.dumps(json_body).encode()
            wanted['Content-Type'] = 'application/json'
        wanted.update({name.replace('_', '-'): value for name, value in headers.items()})
        return self.raw(method, '/api/v1' + path, body, {name: value for name, value in wanted.items() if value is not None})

    def get(self, path):
        reply = self.ask('GET', path)
        self.assertEqual(reply.status, 200, reply.body[:300])
        return reply

    def recording_id(self, name):
        return next(r['id'] for r in self.get('/state').json['recordings'] if r['name'] == name)
