"""The daemon as a child process, its control socket, and waiting without guessing."""
import json
import os
import signal
import socket
import subprocess
import time


PATIENCE_S = 300  # of the guest's time, which runs away while it waits for a page from the host


def wait_for(what, ready, limit_s=PATIENCE_S):
    """Polls until `ready()` is true; `what` names it when it never is."""
    end = time.monotonic() + limit_s
    while True:
        value = ready()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f'waited in vain for {what}')
        time.sleep(0.02)


def sessions_in(folder):
    """Paths, oldest first."""
    return sorted(f'{folder}/{name}' for name in os.listdir(folder))


class Daemon:
    def __init__(self, program, rig, *arguments, socket_path='/tmp/control.sock', env=None, log='/tmp/rigsoundd.log'):
        if os.path.exists(socket_path):
            os.unlink(socket_path)
        self.log_path, self.socket_path = log, socket_path
        with open(log, 'w') as out:
            self.process = subprocess.Popen([program, rig, *map(str, arguments)], stderr=out,
                                            env={**os.environ, **(env or {})})
        wait_for('the control socket', lambda: self.process.poll() is not None or self.answers())
        if self.process.poll() is not None:
            raise AssertionError('rigsoundd ended: ' + self.log())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()

    def log(self):
        with open(self.log_path) as text:
            return text.read()

    def ask(self, command, **more):
        with socket.socket(socket.AF_UNIX) as client:
            client.connect(self.socket_path)
            client.sendall(json.dumps({'command': command, **more}).encode() + b'\n')
            answer = b''
            while not answer.endswith(b'\n'):
                answer += client.recv(65536)
        return json.loads(answer)

    def answers(self):
        """Between its bind and its listen a socket is there and refuses."""
        try:
            return self.status()['ok']
        except (FileNotFoundError, ConnectionRefusedError):
            return False

    def status(self):
        return self.ask('status')

    def bus(self, name):
        return next(b for b in self.status()['buses'] if b['name'] == name)

    def signal(self, name):
        return next(s for s in self.status()['signals'] if s['name'] == name)

    def wait_signal(self, name, value=None, validity='valid', limit_s=PATIENCE_S):
        def there():
            s = self.signal(name)
            return s['validity'] == validity and (value is None or abs(s['value'] - value) < 1e-3)
        wait_for(f'{name} = {value} {validity}, is {self.signal(name)}', there, limit_s)

    def wait_playing(self):
        wait_for('the sound card', lambda: self.status()['audio']['playing'] and self.status()['audio']['blocks'] > 100)

    def terminate(self):
        """SIGTERM; returns the exit code."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(timeout=PATIENCE_S)
