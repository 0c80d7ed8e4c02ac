#!/usr/bin/env python3
"""page_test.py RIGSOUND: the report in a browser: its width, and its sounds."""
import http.server
import json
import pathlib
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

RIGSOUND = sys.argv[1]
CHROMIUM = shutil.which('chromium')

# Opens every page in a frame of either width, then plays in the first; sends what it saw.
LOOK = '''<!doctype html><title>look</title><script>
const wait = (thing, what) => new Promise(done => thing.addEventListener(what, done, {once: true}));
const frame = async (page, width) => {
  const f = document.createElement('iframe');
  f.style.cssText = `border:0;height:900px;width:${width}px`;
  f.src = page;
  document.body.append(f);
  await wait(f, 'load');
  return f.contentDocument;
};
const seen = {widths: []};
const look = async () => {
  for (const page of %s) for (const width of [420, 1280]) {
    const root = (await frame(page, width)).documentElement;
    seen.widths.push([page, width, root.scrollWidth, root.clientWidth]);
  }
  const page = await frame(%s[0], 1280), player = page.querySelector('.player');
  const takes = [...player.querySelectorAll('audio')];
  seen.seconds = takes.map(take => take.duration);
  const seeked = wait(takes[0], 'seeked');
  takes[0].currentTime = 1.25;
  await seeked;
  takes[1].addEventListener('play', () => { seen.second_from = takes[1].currentTime; });  // after the page's own
  await takes[1].play();
  takes[2].addEventListener('play', () => { seen.third_after = takes[2].currentTime - takes[1].currentTime; });
  const playing = wait(takes[2], 'playing');
  player.dispatchEvent(new KeyboardEvent('keydown', {key: '3'}));
  await playing;
  seen.paused = takes.map(take => take.paused);
  seen.focus = takes.indexOf(page.activeElement);
};
onload = () => look().catch(error => { seen.error = String(error); })
  .finally(() => fetch('/seen', {method: 'POST', body: JSON.stringify(seen)}));
</script><body></body>'''


def look_at(pages):
    """What the browser saw; `pages`: {address: file}."""
    seen = queue.Queue()
    files = {'/': LOOK % (json.dumps(list(pages)), json.dumps(list(pages)))}
    files.update({address: file.read_text() for address, file in pages.items()})

    class Pages(http.server.BaseHTTPRequestHandler):
        def answer(self, code, text):
            self.send_response(code)
            self.send_header('Content-Type', 'text/html; charset=utf-8')
            self.end_headers()
            self.wfile.write(text.encode())

        def do_GET(self):
            self.answer(*((200, files[self.path]) if self.path in files else (404, '')))

        def do_POST(self):
            seen.put(json.loads(self.rfile.read(int(self.headers['Content-Length']))))
            self.answer(200, '')

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), Pages)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen(
            [CHROMIUM, '--headless', '--no-sandbox', '--disable-gpu', '--mute-audio', '--window-size=1400,1000',
             '--autoplay-policy=no-user-gesture-required', '--remote-debugging-port=0', f'--user-data-dir={profile}',
             f'http://127.0.0.1:{server.server_port}/'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            return seen.get(timeout=300)
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
            server.server_close()


class Page(unittest.TestCase):
    def test_fits_every_width_and_plays_on_where_the_last_sound_was(self):
        if not CHROMIUM:
            print('\nSKIPPED: report in a browser: no chromium here', flush=True)
            return
        folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_cli.'))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        for words in (['simulate', '--out', folder, '--ids', 100, '--snr', 12],
                      ['analyze', folder / 'c100_12.wav', '--out', folder / 'set', '--report', folder / 'report.html']):
            subprocess.run([RIGSOUND, *map(str, words)], check=True, capture_output=True, timeout=600)
        seen = look_at({'/bank': next((folder / 'set/banks').glob('*/report.html')), '/report': folder / 'report.html'})
        self.assertNotIn('error', seen)
        self.assertEqual(len(seen['widths']), 4)
        for page, width, content, room in seen['widths']:
            self.assertLessEqual(content, room, f'{page} at {width}')
        self.assertEqual(seen['seconds'], [2, 2, 2])
        self.assertAlmostEqual(seen['second_from'], 1.25, delta=0.01)
        self.assertAlmostEqual(seen['third_after'], 0, delta=0.1)
        self.assertEqual(seen['paused'], [True, True, False])
        self.assertEqual(seen['focus'], 2)


unittest.main(argv=sys.argv[:1])
