#!/usr/bin/env python3
"""attack_test.py RIGSOUND RIGSOUNDD: who asks much, holds places or says nothing keeps nobody else from being answered, and nothing from ending."""
import json
import os
import resource
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest

from daemon_case import PATIENCE_S, DaemonCase, free_port, wait_for

FAR_LESS_S = 20  # than the minute that a device may take, and more than any machine needs
RELOAD, STATUS = b'{"command": "reload"}\n', b'{"command": "status"}\n'


def figure(what, seconds):
    print(f'FIGURE {what}: {seconds * 1e3:.0f} ms', flush=True)


class Asking(threading.Thread):
    """Another user, who asks for the status again and again on a connection of its own."""
    def __init__(self, path):
        super().__init__()
        self.path, self.over, self.answers, self.worst_s, self.last = path, False, 0, 0, None

    def run(self):
        with socket.socket(socket.AF_UNIX) as line:
            line.settimeout(PATIENCE_S)
            line.connect(str(self.path))
            with line.makefile('rb') as answers:
                while not self.over:
                    start = time.monotonic()
                    line.sendall(STATUS)
                    self.last = json.loads(answers.readline())
                    self.worst_s = max(self.worst_s, time.monotonic() - start)
                    self.answers += 1

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *_):
        self.over = True
        self.join()


class Watchdog(threading.Thread):
    """What systemd would hear of a daemon started with `env`. Like systemd it reads at once: the kernel holds ten unread messages, then who writes waits."""
    def __init__(self, test):
        super().__init__()
        path = test.folder / 'notify'
        self.feedings, self.known = 0, 0
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(str(path))
        self.env = {**os.environ, 'NOTIFY_SOCKET': str(path), 'WATCHDOG_USEC': '200000'}
        self.start()
        test.addCleanup(self.join)
        test.addCleanup(self.socket.shutdown, socket.SHUT_RDWR)

    def run(self):
        with self.socket:
            while heard := self.socket.recv(4096):
                self.feedings += heard.count(b'WATCHDOG=1')

    def fed(self):
        """Times since the last call."""
        known, self.known = self.known, self.feedings
        return self.known - known


class Attack(DaemonCase):
    def write_rig(self, more='', device='null'):
        self.metrics = free_port()
        self.rig.write_text(f'[audio]\ndevice = "{device}"\n[sound]\nset = "set"\n[control]\nsocket = "{self.socket}"\n'
                            f'metrics = "127.0.0.1:{self.metrics}"\n{more}')

    def start(self, more='', **options):
        self.write_rig(more)
        return self.start_daemon(**options)

    def connect(self, port=None):
        line = socket.socket(socket.AF_UNIX if port is None else socket.AF_INET)
        self.addCleanup(line.close)
        line.settimeout(PATIENCE_S)
        line.connect(str(self.socket) if port is None else ('127.0.0.1', port))
        return line

    def get(self, request=b'GET /metrics HTTP/1.1\r\nHost: x\r\n\r\n'):
        with self.connect(self.metrics) as line:
            line.sendall(request)
            answer = b''
            while part := line.recv(65536):
                answer += part
        return answer.decode()

    def ends(self, daemon, what):
        start = time.monotonic()
        daemon.send_signal(signal.SIGTERM)
        self.assertEqual(daemon.wait(timeout=FAR_LESS_S), 0)
        figure(f'SIGTERM obeyed, {what}', time.monotonic() - start)


class Paths(DaemonCase):
    """A slip of the pen in a path costs no file."""
    def there(self):
        return {path: path.read_bytes() if path.is_file() else None for path in self.folder.rglob('*')}

    def run_both(self, socket_path, *words):
        """What `check` and a start say, one line each, and that they leave everything as it is."""
        self.rig.write_text(f'[audio]\ndevice = "null"\n[sound]\nset = "set"\n[control]\nsocket = "{socket_path}"\n')
        before = self.there()
        said = []
        for program in ([sys.argv[1], 'check', self.rig], [sys.argv[2], self.rig, *words]):
            result = subprocess.run(program, capture_output=True, text=True, timeout=PATIENCE_S)
            said.append((result.returncode, result.stderr))
        self.assertEqual(self.there(), before)
        return said

    def test_a_socket_that_names_something_else(self):
        (self.folder / 'notes.txt').write_text('mine')
        (self.folder / 'notes').mkdir()
        for path, kind in ((self.folder / 'notes.txt', 'a file'), (self.folder / 'notes', 'a folder'), ('/dev/null', 'a device')):
            wrong = (1, f'{self.rig}:6: control.socket: "{path}" is {kind}, expected a socket, or nothing yet\n')
            self.assertEqual(self.run_both(path), [wrong, wrong])

    def test_a_folder_of_sessions_that_is_none(self):
        for name in ('notes.1.txt', 'notes.2.txt', 'notes.3.txt', 'notes.txt'):
            (self.folder / name).write_text(name)
        for path in (self.rig, self.folder / 'notes.txt', '/dev/null'):
            _, started = self.run_both(self.socket, '--session', path)
            self.assertEqual(started, (1, f'{path}: is no folder, expected one for sessions, or a new name\n'))

    def test_a_serial_line_that_is_a_file(self):
        self.rig.write_text(f'[sound]\nset = "set"\n[[modbus]]\ntransport = "rtu"\naddress = "{self.rig}"\n'
                            '[modbus.signals]\nrod_count = { table = "holding", address = 0, type = "uint16" }\n')
        check = subprocess.run([sys.argv[1], 'check', self.rig], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual((check.returncode, check.stderr), (1, f'{self.rig}:5: modbus.address: "{self.rig}" is a file, expected a serial device\n'))


class Devices(Attack):
    def test_neither_a_reload_nor_the_end_waits_for_a_silent_plc(self):
        with socket.create_server(('127.0.0.1', 0)) as plc:
            bus = '[[modbus]]\nrole = "client"\naddress = "127.0.0.1:%d"\nunit = 1\ntimeout_ms = 60000\npoll_ms = %d\n' \
                  '[modbus.signals]\nfeed_pressure_bar = {{ table = "holding", address = 0, type = "uint16" }}\n'.replace('{{', '{').replace('}}', '}')
            port = plc.getsockname()[1]
            daemon = self.start(bus % (port, 20))
            silent, _ = plc.accept()
            self.addCleanup(silent.close)
            self.assertTrue(silent.recv(100))  # the question
            self.rig.write_text(self.rig.read_text().replace('poll_ms = 20', 'poll_ms = 30'))
            line = self.connect()
            start = time.monotonic()
            line.sendall(RELOAD)
            with line.makefile('rb') as answers:
                self.assertTrue(json.loads(answers.readline())['ok'])
            figure('reload beside a silent PLC', time.monotonic() - start)
            self.assertLess(time.monotonic() - start, FAR_LESS_S)
            again, _ = plc.accept()
            self.addCleanup(again.close)
            self.assertTrue(again.recv(100))
            self.ends(daemon, 'a PLC silent')

    def test_a_sound_card_that_does_not_answer(self):
        """Opening it opens a pipe, which waits for somebody to read from it."""
        os.mkfifo(self.folder / 'pipe')
        config = self.folder / 'asound.conf'
        config.write_text(f'pcm.hangs {{ type file slave.pcm {{ type null }} file "{self.folder}/pipe" format raw }}\n')
        watchdog = Watchdog(self)
        self.write_rig(device='hangs')
        daemon = self.start_daemon(env={**watchdog.env, 'ALSA_CONFIG_PATH': str(config)})
        with Asking(self.socket) as other:
            def wait(what, condition):
                wait_for(what, lambda: watchdog.fed() and other.last and condition(other.last['audio']))
            wait('word of it', lambda audio: 'does not answer, it is being opened' in audio['card'])
            answered, blocks = other.answers, other.last['audio']['blocks']
            wait('answers and blocks', lambda audio: other.answers > answered + 20 and audio['blocks'] > blocks + 100)
        figure('worst status beside a sound card that hangs', other.worst_s)
        self.ends(daemon, 'a sound card hanging')
        self.assertFalse(self.socket.exists())

    def test_nor_for_a_name_server(self):
        bus = '[[modbus]]\nrole = "client"\naddress = "no-such-plc.invalid:502"\nunit = 1\n' \
              '[modbus.signals]\nfeed_pressure_bar = { table = "holding", address = 0, type = "uint16" }\n'
        self.ends(self.start(bus), 'a name looked up')


class Control(Attack):
    def test_others_are_answered_between_pipelined_reloads(self):
        watchdog = Watchdog(self)
        daemon = self.start(env=watchdog.env)
        with Asking(self.socket) as other:
            greedy = self.connect()
            greedy.sendall(150 * RELOAD)  # 3 kB
            wait_for('a reload', lambda: other.last and other.last['reloads'] > 0)
            self.assertLess(other.last['reloads'], 150)
            answered = other.answers
            wait_for('answers', lambda: other.answers > answered + 20)
            watchdog.fed()
            wait_for('watchdog', watchdog.fed)
        figure('worst status beside 150 reloads of one client', other.worst_s)
        self.ends(daemon, 'reloads pipelined')

    def test_reloads_asked_for_by_many_at_once_are_few(self):
        self.start()
        clients = [self.connect() for _ in range(7)]
        for client in clients:
            client.sendall(RELOAD)
        for client in clients:
            with client.makefile('rb') as answers:
                self.assertEqual(json.loads(answers.readline()), {'ok': True, 'not_applied': []})
        self.assertLess(json.loads(self.ctl('status', '--json').stdout)['reloads'], 7)

    def test_a_client_that_asks_much_and_reads_nothing(self):
        daemon = self.start()
        with Asking(self.socket) as other:
            deaf = self.connect()
            deaf.setblocking(False)
            sent = 0
            for _ in range(1000):  # 22 MB, were they taken
                try:
                    sent += deaf.send(1000 * STATUS)
                except BlockingIOError:
                    break
            answered = other.answers
            wait_for('answers', lambda: other.answers > answered + 20)
        self.assertLess(sent, 4 << 20)  # what the kernel keeps
        figure('worst status beside 10 000 of one client', other.worst_s)
        with open(f'/proc/{daemon.pid}/status') as status:
            peak_kb = next(int(line.split()[1]) for line in status if line.startswith('VmHWM'))
        print(f'FIGURE peak memory of the daemon: {peak_kb // 1024} MB', flush=True)
        self.ends(daemon, 'status pipelined')

    def test_a_flood_without_a_line_is_cut(self):
        self.start()
        flood = self.connect()
        sent = 0
        with self.assertRaises((BrokenPipeError, ConnectionResetError)):
            for _ in range(16):
                flood.sendall(b'x' * (1 << 20))
                sent += 1
        self.assertEqual(self.ctl('status').returncode, 0)

    def test_idle_connections_keep_nobody_out(self):
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(4096, hard), hard))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))
        daemon = self.start()
        held = [self.connect(port) for _ in range(500) for port in (None, self.metrics)]
        start = time.monotonic()
        self.assertEqual(self.ctl('status').returncode, 0)
        self.assertIn('rigsound_blocks_total', self.get())
        figure('ctl status and metrics beside 1000 connections', time.monotonic() - start)
        self.ends(daemon, '1000 connections')
        self.assertEqual(len(held), 1000)


class Metrics(Attack):
    def test_only_get_metrics_is_answered_with_the_page(self):
        self.start()
        for request, status in ((b'GET /metrics HTTP/1.1\r\nHost: x\r\n\r\n', '200 OK'), (b'GET / HTTP/1.1\r\nHost: x\r\n\r\n', '404 Not Found'),
                                (b'POST /metrics HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n', '405 Method Not Allowed'),
                                (b'nonsense\r\n\r\n', '400 Bad Request')):
            self.assertEqual(self.get(request).split('\r\n')[0], f'HTTP/1.1 {status}', request)


class Modbus(Attack):
    SERVER = '[[modbus]]\nrole = "server"\naddress = "127.0.0.1:%d"\nallow = ["127.0.0.0/8"]\n' \
             '[modbus.signals]\nrod_count = { table = "holding", address = 0, type = "uint16" }\n'

    def test_connections_that_ask_now_and_then_keep_no_simulator_out(self):
        port = free_port()
        self.start(self.SERVER % port)
        read = b'\0\1\0\0\0\6\1\3\0\0\0\1'

        def ask(line, request):
            line.sendall(request)
            return line.recv(100)

        def server_up():
            return json.loads(self.ctl('status', '--json').stdout)['buses'][0]['up']

        wait_for('server', server_up)
        held = [self.connect(port) for _ in range(32)]
        answers = [ask(line, read) for line in held[-8:]]
        self.assertTrue(all(answers))
        simulator = self.connect(port)
        self.assertEqual(ask(simulator, b'\0\2\0\0\0\6\1\6\0\0\0\7'), b'\0\2\0\0\0\6\1\6\0\0\0\7')
        bus = json.loads(self.ctl('status', '--json').stdout)['buses'][0]
        self.assertEqual((bus['evicted_connections'], bus['rejected_connections']), (32 + 1 - 8, 0))


class Clock(Attack):
    def audio(self):
        return json.loads(self.ctl('status', '--json').stdout)['audio']

    def test_a_device_that_never_blocks_is_paced(self):
        self.write_rig()
        self.rig.write_text(self.rig.read_text().replace('device = "null"', 'device = "plug:null"'))
        self.start_daemon()
        wait_for('loss', lambda: self.audio()['losses'] > 0)
        wait_for('words', lambda: 'it has no clock' in self.audio()['card'])
        first, start = self.audio()['blocks'], time.monotonic()
        time.sleep(2)
        rate_hz = (self.audio()['blocks'] - first) / (time.monotonic() - start)
        print(f'FIGURE blocks a second of a device that never blocks: {rate_hz:.0f} of 750', flush=True)
        self.assertLess(rate_hz, 3000)  # 29 600 before
        self.assertFalse(self.audio()['playing'])

    def test_a_stop_of_three_seconds_is_counted_and_lies_in_the_session(self):
        sessions = self.folder / 'sessions'
        self.write_rig()
        daemon = self.start_daemon('--manual', '--session', sessions)
        self.ctl('set', 'engine_rpm', '1500')
        wait_for('session', lambda: self.audio()['blocks'] > 750)
        self.assertEqual((self.audio()['clock_jumps'], self.audio()['skipped_blocks']), (0, 0))
        start, before = time.monotonic(), self.audio()['blocks']
        daemon.send_signal(signal.SIGSTOP)
        time.sleep(3)
        daemon.send_signal(signal.SIGCONT)
        wait_for('jump', lambda: self.audio()['clock_jumps'] == 1)
        audio, seconds = self.audio(), time.monotonic() - start
        blocks = audio['blocks'] - before
        print(f'FIGURE SIGSTOP for 3 s: {blocks} blocks and {audio["skipped_blocks"]} skipped in {seconds:.2f} s, '
              f'{(blocks + audio["skipped_blocks"]) / 750:.2f} s of blocks', flush=True)
        self.assertGreater(audio['skipped_blocks'], 2200)
        self.assertIn(f'rigsound_skipped_blocks_total {audio["skipped_blocks"]}\n', self.get())
        daemon.terminate()
        daemon.wait()
        out = self.folder / 'out.wav'
        rendered = subprocess.run([sys.argv[1], 'render', self.rig, '--session', sessions, '--out', out], capture_output=True, text=True,
                                  timeout=PATIENCE_S)
        self.assertEqual(rendered.returncode, 0, rendered.stderr)
        told = subprocess.run([sys.argv[1], 'decode', self.rig, '--session', sessions], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertIn('s of them were skipped', told.stderr)
        length_s = float(told.stderr.split(': ')[1].split(' s')[0])
        self.assertAlmostEqual(length_s, (out.stat().st_size - 100) / 8 / 48000, delta=0.1)


class Crashes(Attack):
    def crash(self, sessions):
        """A run in which much is said, and what lies in the folder after it."""
        daemon = self.start_daemon('--manual', '--session', sessions, '--session-limit', '0.01')
        requests = [b'{"command": "set", "key": "engine_rpm", "value": %d}\n' % rpm for rpm in range(600, 1000)]
        with self.connect() as line, line.makefile('rb') as answers:
            line.sendall(b''.join(requests))
            for _ in requests:
                answers.readline()
        wait_for('flush', lambda: json.loads(self.ctl('status', '--json').stdout)['session']['bytes'] > 1000)
        daemon.kill()
        daemon.wait()
        return {path.name for path in sessions.iterdir()}

    def test_the_first_session_outlives_a_crash_loop(self):
        self.write_rig()
        sessions = self.folder / 'sessions'
        first = self.crash(sessions)
        self.assertEqual(len(first), 1)
        seen = set(first)
        for _ in range(9):
            left = self.crash(sessions)
            seen |= left
            self.assertLessEqual(first, left)
        self.assertLess(len(left), len(seen))  # others had to go
        print(f'FIGURE kill -9, {len(seen)} times, under 10 kB: {len(left)} sessions are left, the first among them', flush=True)
        self.assertLess(sum(path.stat().st_size for path in sessions.iterdir()), 10_000)


unittest.main(argv=sys.argv[:1])
