"""What the tests of the field share: RIGSOUND ROOT are their words, the program and the project.

The files lie in `cases/`: what people reported of other tools, made small.
"""
import csv
import io
import pathlib
import subprocess
import sys

from folder_case import FolderCase

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
CASES = ROOT / 'tests/cli/cases'


def run(*words, **more):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300, **more)


def decode(rig, log, *words, **more):
    return run('decode', CASES / rig, '--log', log if log == '-' else CASES / log, *words, **more)


def told(result):
    """(time, signal, value) of every row."""
    rows = csv.DictReader(io.StringIO(result.stdout))
    return [(float(r['time_s']), r['signal'], r['value']) for r in rows]


class FieldCase(FolderCase):
    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content) if isinstance(content, bytes) else path.write_text(content)
        return path

    def good(self, result, *parts):
        self.assertEqual(result.returncode, 0, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)
        return told(result)

    def refused(self, result, *parts):
        self.assertEqual((result.returncode, result.stdout), (1, ''), result.stderr)
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)

    def speeds(self, result, *expected):
        """(time, r/min) of every row."""
        rows = self.good(result)
        self.assertEqual([(round(t, 6), float(v)) for t, s, v in rows if s == 'engine_rpm'], list(expected), result.stderr)
