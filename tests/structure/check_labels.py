#!/usr/bin/env python3
"""check_labels.py ROOT BUILD: every kind of test can be run alone, with no more packages than it needs.

Every test has one label; `ctest -L LABEL` finds tests for each; `tools/test -L LABEL` knows them all, has a list of
packages for each, and refuses others before it installs anything.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

LABELS = ('unit', 'golden', 'cli', 'bus', 'fuzz', 'structure', 'studio')
# What only tests in machines of other kinds need: half a gigabyte and a kernel.
HEAVY = ('qemu', 'aarch64', 'clang', 'busybox', 'slurm')


def labels_of(test):
    return next((p['value'] for p in test['properties'] if p['name'] == 'LABELS'), [])


def tests_of(build):
    """Asked from a folder of its own: ctest begins a new LastTest.log, and the one of the run that this is part of is read at its end."""
    with tempfile.TemporaryDirectory(prefix='rigsound_labels.') as folder:
        (pathlib.Path(folder) / 'CTestTestfile.cmake').write_text(f'subdirs("{build}")\n')
        shown = subprocess.run(['ctest', '--test-dir', folder, '--show-only=json-v1'], check=True, capture_output=True, text=True)
    return json.loads(shown.stdout)['tests']


def main():
    root, build = map(pathlib.Path, sys.argv[1:])
    problems = []
    tests = tests_of(build)
    for test in tests:
        if len(set(labels_of(test)) & set(LABELS)) != 1:
            problems.append(f'{test["name"]}: labels {labels_of(test)}, expected one of {LABELS}')
    for label in LABELS:
        if not any(label in labels_of(test) for test in tests):
            problems.append(f'ctest -L {label} finds no test')
        if not (root / f'tools/scripts/packages/test_{label}.txt').is_file():
            problems.append(f'tools/scripts/packages has no list for label {label}')
    for packages in ('build', 'test_unit'):
        for name in (root / f'tools/scripts/packages/{packages}.txt').read_text().split():
            if name.startswith(HEAVY) or any(word in name for word in HEAVY):
                problems.append(f'tools/test -L unit installs {name}')
    wrong = subprocess.run([root / 'tools/test', '-L', 'unitt'], capture_output=True, text=True)
    if wrong.returncode != 2 or wrong.stdout or "'unitt', expected one of unit" not in wrong.stderr:
        problems.append(f'tools/test -L unitt: exit code {wrong.returncode}, {wrong.stderr!r}')
    print('\n'.join(problems) or f'{len(tests)} tests, each with one label')
    sys.exit(1 if problems else 0)


main()
