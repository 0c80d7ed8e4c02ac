"""What the tests of `decode`, `check` and `render` share: RIGSOUND ROOT are their words, the program and the project."""
import pathlib
import subprocess
import sys

from folder_case import FolderCase

RIGSOUND, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
MINIMAL = '[[can]]\ninterface = "can0"\ndbc = "{dbc}"\n[can.signals]\nengine_rpm = "{signal}"\n'


def run(*words):
    return subprocess.run([RIGSOUND, *map(str, words)], capture_output=True, text=True, timeout=300)


class RigCase(FolderCase):
    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def demo_rig(self, **replace):
        text = (ROOT / 'config/rigs/demo.toml').read_text()
        text = text.replace('../../out/soundset', str(self.folder / 'set'))
        text = text.replace('../dbc/rig.dbc', str(ROOT / 'config/dbc/rig.dbc')).replace('tool = "rods"', '# no tool')
        for old, new in replace.items():
            assert old in text, old
            text = text.replace(old, new)
        return self.write('demo.toml', text)

    def short_log(self, seconds=16):
        lines = (ROOT / 'config/logs/shift.log').read_text().splitlines(True)
        first = float(lines[0][1:18])
        kept = [line for line in lines if 9 <= float(line[1:18]) - first < 9 + seconds]
        return self.write('short.log', ''.join(kept))

    def refused(self, words, *parts, left=()):
        """Exit code 1, one line on stderr that holds every part, nothing on stdout, no file left."""
        before = set(self.folder.rglob('*'))
        result = run(*words)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(result.stdout, '')
        self.assertEqual(result.stderr.count('\n'), 1, result.stderr)
        for part in parts:
            self.assertIn(str(part), result.stderr)
        self.assertEqual(set(self.folder.rglob('*')), before)
