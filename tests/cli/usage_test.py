#!/usr/bin/env python3
"""usage_test.py RIGSOUND RIGSOUNDD: help and wrong usage of every verb, as a user meets them."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

RIGSOUND, RIGSOUNDD = sys.argv[1:3]


def run(*words, program=RIGSOUND):
    return subprocess.run([program, *words], capture_output=True, text=True, timeout=60)


def listed(help_text, *headings):
    """Names and summaries under the headings of a help."""
    found = {}
    for heading in headings:
        part = re.search(rf'^{heading}:\n((?:  .*\n)+)', help_text, re.M)
        assert part, heading
        found.update(re.findall(r'^  (\S+) {2,}(.+)$', part.group(1), re.M))
    return found


class Help(unittest.TestCase):
    def setUp(self):
        self.verbs = listed(run('--help').stdout, 'Prepare', 'Run', 'Inspect')
        self.commands = listed(run('ctl', '--help').stdout, 'Commands')

    def test_every_verb_stands_under_one_of_three_headings(self):
        for verb in ('analyze', 'background', 'bench', 'check', 'clicks', 'ctl', 'decode', 'denoise', 'record', 'render',
                     'replay', 'resynth', 'simulate', 'tool'):
            self.assertIn(verb, self.verbs)
        self.assertEqual(run('--help').stdout.count('\n\n'), 5)  # options, three headings, example

    def test_summaries_are_imperative_without_a_full_stop(self):
        for name, summary in {**self.verbs, **self.commands}.items():
            self.assertRegex(summary, r'^[A-Z][a-z]*[^s.] .*[^.]$', name)

    def test_everything_has_an_example_of_itself(self):
        calls = [[verb] for verb in self.verbs] + [['ctl', command] for command in self.commands]
        for call in calls:
            result = run(*call, '--help')
            self.assertEqual(result.returncode, 0)
            self.assertIn('Example: rigsound ' + ' '.join(call), result.stdout)
        self.assertIn('Example: rigsoundd ', run('--help', program=RIGSOUNDD).stdout)

    def test_details_fit_a_terminal(self):
        for verb in self.verbs:
            details = run(verb, '--help').stdout.split('Example: ')[0].split('\n\n')[-2]
            if not details.startswith(('Options', '[Option')):
                self.assertLessEqual(max(map(len, details.splitlines())), 100, verb)


class Studio(unittest.TestCase):
    def test_its_web_server_costs_other_verbs_nothing(self):
        needed = subprocess.run(['ldd', RIGSOUND], capture_output=True, text=True, check=True).stdout
        self.assertNotRegex(needed, 'httplib|libssl')
        own = subprocess.run(['ldd', RIGSOUND + '-studio'], capture_output=True, text=True, check=True).stdout
        self.assertRegex(own, 'httplib')

    def test_its_program_knows_its_name(self):
        for words in (('studio', '--help'), ('--help',)):
            self.assertEqual(run(*words, program=RIGSOUND + '-studio').stdout, run('studio', '--help').stdout)

    def test_without_its_program_it_says_what_to_install(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = shutil.copy(RIGSOUND, folder)
            result = run('studio', folder, program=alone)
            self.assertEqual((result.returncode, result.stdout), (3, ''))
            self.assertEqual(result.stderr, f'{folder}/rigsound-studio: is not there; install it beside rigsound\n')


class WrongUsage(unittest.TestCase):
    def refused(self, words, text, program=RIGSOUND):
        result = run(*words.split(), program=program)
        self.assertEqual(result.returncode, 2, words)
        self.assertEqual(result.stdout, '')
        self.assertEqual(result.stderr.splitlines()[0], text)
        self.assertLess(len(result.stderr), 200)

    def test_unknown_verb_names_the_nearest(self):
        self.refused('rendr rig.toml --log a.log', 'unknown verb rendr, did you mean render?')
        self.refused('--json rendr', 'unknown option --json')
        self.refused('xylophone', 'unknown verb xylophone')
        self.refused('dceode', 'unknown verb dceode, did you mean decode?')
        self.refused('toool', 'unknown verb toool, did you mean tool?')
        self.refused('', 'expected a verb')

    def test_unknown_command_names_the_nearest(self):
        self.refused('ctl statsu', 'unknown command statsu, did you mean status?')
        self.refused('ctl --socket s.sock mut', 'unknown command mut, did you mean mute?')
        self.refused('ctl', 'expected a command')

    def test_unknown_option_names_the_nearest_of_its_verb(self):
        self.refused('render rig.toml --lgo a.log --out o.wav', 'unknown option --lgo, did you mean --log?')
        self.refused('render rig.toml --log a.log --out o.wav --sede=3', 'unknown option --sede, did you mean --seed?')
        self.refused('resynth b o.wav --seconds 2 --dacey 1', 'unknown option --dacey, did you mean --decay?')
        self.refused('ctl set engine_rpm 3 --scoket s', 'unknown option --scoket, did you mean --socket?')
        self.refused('check rig.toml --colour', 'unknown option --colour')
        self.refused('check rig.toml other.toml', 'unexpected word other.toml')
        self.refused('rig.toml --manaul', 'unknown option --manaul, did you mean --manual?', program=RIGSOUNDD)

    def test_decimal_comma(self):
        self.refused('tool --length 0,5 --diameter 0.025', "--length: '0,5' is no number, expected a decimal point: 0.5")
        self.refused('bench --seconds 0,5', "--seconds: '0,5' is no number, expected a decimal point: 0.5")

    def test_ranges_say_what_they_accept(self):
        self.refused('bench --seconds 1e9', '--seconds: is 1e9, expected 0.1...3600 s')
        self.refused('bench --seconds nan', "--seconds: 'nan' is no number, expected one such as 0.5")
        self.refused('record rig.toml --out a --seconds 0', '--seconds: is 0, expected 0.001 s or more')
        self.refused('background a.wav --rpm 5000 --out set', '--rpm: is 5000, expected 300...4000 r/min')
        self.refused('resynth a b.wav --seconds 1 --gain-db 30', '--gain-db: is 30, expected -60...24 dB')
        self.refused('timeline a.png --wav a.wav --states s.csv --underfeed 400', '--underfeed: is 400, expected 0...300 bar')
        self.refused('clicks in.wav --jobs -1', '--jobs: is -1, expected 1 or more')
        self.refused('clicks in.wav --jobs 1.5', "--jobs: '1.5' is no whole number, expected one such as 2")
        self.refused('clicks in.wav --jobs 4294967296', "--jobs: '4294967296' is no whole number, expected one such as 2")
        self.refused('rig.toml --session-limit 0', '--session-limit: is 0, expected 0.01...1000000 MB', program=RIGSOUNDD)

    def test_words(self):
        self.refused('clicks in.wav --method papre', '--method: is papre, expected click-nmf|paper, did you mean paper?')

    def test_seeds_are_not_negative(self):
        self.refused('resynth a b --seconds 1 --seed -1',
                     "--seed: '-1' is no whole number from 0 on, expected one such as 2")

    def test_shards_count_from_one(self):
        for shard in ('0/4', '5/4', '1/0', '2', '1/4x'):
            self.refused(f'analyze in --out out --shard {shard}',
                         f"--shard: '{shard}' is wrong, expected I/N with I from 1 to N, or auto")

    def test_missing(self):
        self.refused('check', 'RIG.toml is required')
        self.refused('tool --length 0.5', '--length: is needed with --diameter, or --from')
        self.refused('background --formula', '--out: is needed, or --resynth')
        self.refused('', 'RIG.toml is required', program=RIGSOUNDD)


class Numbers(unittest.TestCase):
    def test_negative_and_hexadecimal_numbers_are_taken(self):
        with tempfile.TemporaryDirectory() as folder:
            absent = str(pathlib.Path(folder) / 'absent')
            for words in (('resynth', absent, absent, '--seconds', '1', '--gain-db', '-6', '--seed', '0x10'),
                          ('background', absent, '--rpm', '800,1500', '--out', absent)):
                expected = 2 if words[0] == 'background' else 1  # read; two speeds for one recording is usage
                self.assertEqual(run(*words).returncode, expected, words)
            self.assertEqual(run('ctl', '--socket', absent, 'set', 'mean_amplitude_db', '-6').returncode, 3)


unittest.main(argv=sys.argv[:1])
