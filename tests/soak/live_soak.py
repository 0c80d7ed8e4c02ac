#!/usr/bin/env python3
"""live_soak.py RIGSOUND RIGSOUNDD HOURS: a daemon under a random shift, with reloads, stops, masters that come and go and clients that mean no good.

Watches memory, descriptors, the block clock and the level; ends with 1 when one of them is not as it should be."""
import json
import os
import pathlib
import random
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'cli'))
from daemon_case import free_port, wait_for  # noqa: E402
from sound_set import write_sound_set  # noqa: E402

RIGSOUND, RIGSOUNDD, HOURS = sys.argv[1], sys.argv[2], float(sys.argv[3])
RIG = '''[audio]
device = "null"
[sound]
set = "set"
[mix]
drill_db = {gain}
[control]
socket = "{folder}/s"
[[modbus]]
role = "server"
address = "127.0.0.1:{port}"
[modbus.signals]
engine_rpm = {{ table = "holding", address = 0, type = "uint16" }}
feed_pressure_bar = {{ table = "holding", address = 1, type = "uint16" }}
'''


class Soak:
    def __init__(self, folder):
        self.folder, self.port, self.random = folder, free_port(), random.Random(1)
        write_sound_set(folder / 'set')
        self.write_rig(0)
        self.log = open(folder / 'log', 'w')
        self.daemon = subprocess.Popen([RIGSOUNDD, folder / 'rig.toml', '--session', folder / 'sessions', '--session-limit', '2'], stderr=self.log)
        wait_for('socket', (folder / 's').exists)
        wait_for('server', lambda: self.status()['buses'][0]['up'])

    def write_rig(self, gain):
        (self.folder / 'rig.toml').write_text(RIG.format(gain=gain, folder=self.folder, port=self.port))

    def ask(self, command):
        with socket.socket(socket.AF_UNIX) as line, line.makefile('rb') as answer:
            line.connect(str(self.folder / 's'))
            line.sendall(json.dumps({'command': command}).encode() + b'\n')
            return json.loads(answer.readline())

    def status(self):
        return self.ask('status')

    def drill(self):
        with socket.create_connection(('127.0.0.1', self.port)) as master:
            rpm, feed = self.random.randrange(2200), self.random.randrange(300)
            master.sendall(struct.pack('>HHHBBHHBHH', 1, 0, 11, 1, 16, 0, 2, 4, rpm, feed))
            master.recv(100)

    def reload(self):
        self.write_rig(-self.random.randrange(12))
        assert self.ask('reload')['ok']

    def nonsense(self):
        with socket.create_connection(('127.0.0.1', self.port)) as master:
            master.sendall(self.random.randbytes(300))
        with socket.socket(socket.AF_UNIX) as client:
            client.connect(str(self.folder / 's'))
            client.sendall(self.random.randbytes(1000) + b'\n')

    def stop_a_while(self):
        self.daemon.send_signal(signal.SIGSTOP)
        time.sleep(self.random.uniform(0.1, 2.5))
        self.daemon.send_signal(signal.SIGCONT)

    def figures(self):
        with open(f'/proc/{self.daemon.pid}/status') as status:
            memory_kb = next(int(line.split()[1]) for line in status if line.startswith('VmRSS'))
        audio = self.status()['audio']
        return {'memory_mb': memory_kb / 1024, 'descriptors': len(os.listdir(f'/proc/{self.daemon.pid}/fd')),
                'clock_s': (audio['blocks'] + audio['skipped_blocks']) * audio['block_ms'] / 1000, 'time_s': time.monotonic(), **audio}

    def run(self):
        deeds = [self.drill] * 40 + [self.reload] * 3 + [self.nonsense] * 3 + [self.stop_a_while]
        for _ in range(20):
            self.random.choice(deeds)()
        self.reload()
        first, loudest_db = self.figures(), -200
        end = time.monotonic() + HOURS * 3600
        while time.monotonic() < end:
            self.random.choice(deeds)()
            time.sleep(self.random.uniform(0, 0.5))
            loudest_db = max(loudest_db, self.status()['meters']['peak_db'])
        last = self.figures()
        drift_s = (last['clock_s'] - first['clock_s']) - (last['time_s'] - first['time_s'])
        print(f'FIGURE live soak of {HOURS:g} h: {last["memory_mb"] - first["memory_mb"]:+.1f} MB, {last["descriptors"] - first["descriptors"]:+d} descriptors, '
              f'block clock {drift_s * 1000:+.0f} ms after {last["clock_jumps"]} jumps, {last["deadline_misses"]} deadline misses, '
              f'peak {loudest_db:.1f} dBFS, sessions {sum(f.stat().st_size for f in (self.folder / "sessions").iterdir()) / 1e6:.1f} MB', flush=True)
        self.daemon.terminate()
        code = self.daemon.wait(timeout=60)
        jump_s = 0.002 * (last['clock_jumps'] - first['clock_jumps'])  # each is counted in whole blocks
        return (code == 0 and last['memory_mb'] - first['memory_mb'] < 32 and last['descriptors'] - first['descriptors'] < 8
                and abs(drift_s) < 0.2 + jump_s and -100 < loudest_db <= -0.9)


with tempfile.TemporaryDirectory(prefix='rigsound_soak.') as place:
    soak = Soak(pathlib.Path(place))
    try:
        good = soak.run()
    finally:
        soak.daemon.kill()
        soak.daemon.wait()
        soak.log.close()
sys.exit(0 if good else 1)
