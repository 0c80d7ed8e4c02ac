"""Brings into the guest's memory what the tests will need of the host's files.

While the guest waits for the host it has nothing to do, and its clock jumps ahead: a page missing in the middle of a
test would cost seconds of its time.
"""
import pathlib
import shutil
import subprocess

TOOLS = ['aplay', 'arecord', 'candump', 'cangen', 'canplayer', 'ip', 'mbpoll', 'socat']


def read(path):
    with open(path, 'rb') as file:
        while file.read(1 << 20):
            pass


def libraries_of(program):
    told = subprocess.run(['ldd', program], capture_output=True, text=True).stdout
    return [word for word in told.split() if word.startswith('/')]


def read_ahead(programs, folders):
    files = {tool for tool in map(shutil.which, TOOLS) if tool} | set(programs)
    for program in list(files):
        files.update(libraries_of(program))
    for folder in [*folders, '/usr/share/alsa']:
        files.update(str(path) for path in pathlib.Path(folder).rglob('*') if path.is_file())
    for file in sorted(files):
        read(file)
