#!/usr/bin/env python3
"""manual_test.py RIGSOUND RIGSOUNDD: man pages and completions say what --help says."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

RIGSOUND, RIGSOUNDD = sys.argv[1:3]


def out(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def verbs_of(*words):
    """Names that the help lists, two columns in."""
    text = out(*words, '--help').split('Example:')[0]
    blocks = re.findall(r'^(?:Prepare|Run|Inspect|Commands):\n((?:  \S.*\n| {4,}\S.*\n)+)', text, flags=re.M)
    return [line.split()[0] for block in blocks for line in block.splitlines() if re.match(r'  \S', line)]


def options_of(*words):
    return set(re.findall(r'^ {2,4}(?:-\w,)?(--[\w-]+)', out(*words, '--help'), flags=re.M))


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_manual.'))
        out(RIGSOUND, '--write-man-pages', cls.folder / 'man1')
        out(RIGSOUNDD, '--write-man-pages', cls.folder / 'man8')

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def page(self, name):
        return (self.folder / name).read_text().replace('\\-', '-').replace('\\fB', '').replace('\\fR', '').replace('\\fI', '')

    def test_every_verb_has_a_page_with_every_option(self):
        verbs = verbs_of(RIGSOUND)
        self.assertIn('render', verbs)
        self.assertEqual({f'rigsound-{verb}.1' for verb in verbs} | {'rigsound.1'},
                         {page.name for page in (self.folder / 'man1').iterdir()})
        for verb in verbs:
            page = self.page(f'man1/rigsound-{verb}.1')
            for command in [[]] + [[name] for name in verbs_of(RIGSOUND, verb)]:
                for option in options_of(RIGSOUND, verb, *command):
                    self.assertIn(option, page, verb)
            self.assertIn('.SH EXAMPLES' if not verbs_of(RIGSOUND, verb) else 'Example:', page)
            self.assertIn('EXIT STATUS', page)
            self.assertIn('128 + N', page)
        for option in options_of(RIGSOUNDD):
            self.assertIn(option, self.page('man8/rigsoundd.8'))

    def test_man_reads_the_pages_without_a_word(self):
        if not shutil.which('man'):
            print('\nSKIPPED: man reads the pages: no man here', flush=True)
            self.skipTest('no man')
        for page in sorted(self.folder.rglob('*.[18]')):
            read = subprocess.run(['man', '--warnings', '-l', page], capture_output=True, text=True, env={'LC_ALL': 'C'})
            self.assertEqual((read.returncode, read.stderr), (0, ''), page)

    def test_bash_completes_verbs_commands_options_and_words(self):
        script = self.folder / 'rigsound.bash'
        script.write_text(out(RIGSOUND, '--write-completion', 'bash'))

        def completed(*words):
            quoted = ' '.join(f"'{word}'" for word in words)
            return out('bash', '-c', f'source {script}; COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _rigsound; '
                       'echo "${COMPREPLY[@]}"').split()
        self.assertEqual(set(completed('rigsound', '')), set(verbs_of(RIGSOUND)) | {'--help', '--version'})
        self.assertEqual(completed('rigsound', 'rend'), ['render'])
        self.assertIn('status', completed('rigsound', 'ctl', 's'))
        self.assertEqual(completed('rigsound', 'render', '--l'), ['--log'])
        self.assertIn('overfeed', completed('rigsound', 'analyze', 'a.wav', '--situation', ''))

    def test_zsh_reads_its_completion(self):
        if not shutil.which('zsh'):
            print('\nSKIPPED: zsh reads its completion: no zsh here', flush=True)
            self.skipTest('no zsh')
        script = self.folder / '_rigsound'
        script.write_text(out(RIGSOUND, '--write-completion', 'zsh'))
        out('zsh', '-n', script)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
