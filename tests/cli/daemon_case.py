"""A test that starts daemons: a rig to be written, a small sound set, and the socket `ctl` asks. sys.argv begins RIGSOUND RIGSOUNDD."""
import socket
import subprocess
import sys
import time

from folder_case import FolderCase
from sound_set import write_sound_set

PATIENCE_S = 60


def wait_for(what, condition, patience_s=PATIENCE_S):
    """What the condition gives once it holds."""
    end = time.monotonic() + patience_s
    while not (found := condition()):
        assert time.monotonic() < end, f'no {what} within {patience_s} s'
        time.sleep(0.05)
    return found


def free_port(kind=socket.SOCK_STREAM):
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


class DaemonCase(FolderCase):
    def setUp(self):
        super().setUp()
        write_sound_set(self.folder / 'set')
        self.rig = self.folder / 'rig.toml'
        self.socket = self.folder / 's'

    def start_daemon(self, *words, patience_s=PATIENCE_S, **more):
        """Of self.rig, once it answers."""
        daemon = subprocess.Popen([sys.argv[2], self.rig, *words], **{'stderr': subprocess.DEVNULL, **more})
        if daemon.stderr:
            self.addCleanup(daemon.stderr.close)
        self.addCleanup(daemon.wait)
        self.addCleanup(daemon.kill)
        wait_for('daemon', lambda: self.ctl('status').returncode == 0, patience_s)
        return daemon

    def ctl(self, *words):
        return subprocess.run([sys.argv[1], 'ctl', '--socket', self.socket, *words], capture_output=True, text=True, timeout=PATIENCE_S)
