#!/usr/bin/env python3
"""Fails when the range of an option or of a model's field is written anywhere but in its list.

check_ranges.py ROOT     reads the sources of engine/, drivers/ and config/
check_ranges.py --self   shows that each kind of second writing is caught

A list is a function `fields(Archive& a, SomeOptions& o)` beside its struct (rigsound/machine/fields.hpp).
"""
import pathlib
import re
import sys
import tempfile

ROOMS = ('engine', 'drivers', 'config')
NUMBER = r"-?(?:\d[\d.']*(?:[eE][-+]?\d+)?)[fF]?"
LIST = re.compile(r'^void fields\(Archive& a, (\w+)& o\) \{\n(.*?)\n\}', re.S | re.M)
LINE = re.compile(r'\ba\("(\w+)"(?:, "(\w+)")?,\s*(o\.[\w.]+)')

# What must not stand outside a list, and why.
ELSEWHERE = (
    (re.compile(r'\.(?:number|integer|floats|pairs)\(\s*"[^;]*?[,{]\s*%s\s*,\s*%s\s*[,})]' % (NUMBER, NUMBER)),
     'a getter is given literal bounds'),
    (re.compile(r'\b(?:between|within|clamp|in_range)\([^;{]*?,\s*%s\s*,\s*%s\s*\)' % (NUMBER, NUMBER)),
     'a value is held against literal bounds'),
    (re.compile(r'(\b[\w.\->]+) [<>]=? %s (?:&&|\|\|) \1 [<>]=? %s' % (NUMBER, NUMBER)),
     'a value is compared with literal bounds'),
    (re.compile(r'\bRange(?:\s+\w+)?\{\s*%s\s*,\s*%s' % (NUMBER, NUMBER)),
     'a range is made in passing, expected a list or a constant'),
)
CONSTANT = re.compile(r'^\s*(?:inline )?constexpr Range[^;]*;', re.M | re.S)
IN_COMMENT = re.compile(r'//.*?\d\s?(?:\.\.\.|…|–)\s?[-+]?\d')
# Only what reads or checks options; synthesis clamps its own signals.
READS = re.compile(r'(?:^|/)(?:\w*check\w*|options|\w+_options)\.[ch]pp$|^config/')


def blanked(pattern, text):
    """`text` with every match replaced by as many lines of nothing."""
    return pattern.sub(lambda match: '\n' * match.group(0).count('\n'), text)


def line_of(text, at):
    return text.count('\n', 0, at) + 1


def of_lists(where, text):
    for found in LIST.finditer(text):
        keys, members = set(), set()
        for entry in LINE.finditer(found.group(2)):
            names = {entry.group(1), entry.group(2)} - {None}
            if names & keys or entry.group(3) in members:
                yield (f'{where}:{line_of(text, found.start(2) + entry.start())}: '
                       f'{found.group(1)} has "{entry.group(1)}" twice')
            keys |= names
            members.add(entry.group(3))
    for number, line in enumerate(text.split('\n'), 1):
        if IN_COMMENT.search(line):
            yield f'{where}:{number}: a comment repeats a range, expected it in the list only'


def of_readers(where, text):
    bare = blanked(CONSTANT, blanked(LIST, re.sub(r'//[^\n]*', '', text)))
    for pattern, problem in ELSEWHERE:
        for found in pattern.finditer(bare):
            yield f'{where}:{line_of(bare, found.start())}: {problem}'


def violations(root):
    for room in ROOMS:
        for path in sorted((root / room).rglob('*')):
            if path.suffix not in ('.cpp', '.hpp'):
                continue
            where = path.relative_to(root).as_posix()
            text = path.read_text(encoding='utf-8')
            has_list = LIST.search(text) is not None
            if has_list:
                yield from of_lists(where, text)
            if has_list or READS.search(where):
                yield from of_readers(where, text)


CLEAN = '''// A scene.
constexpr Range kGains{-60, 24, "dB"};
struct Scene {
  double feed_bar = 15, gain_db = 0;  ///< from low to high
};
template <class Archive>
void fields(Archive& a, Scene& o) {
  constexpr Range kFeeds =
      Range{0, 300, "bar"}.rounded(2);
  a("feed_bar", o.feed_bar, kFeeds);
  a("gain_db", o.gain_db, kGains);
  a("level_db", "phase", o.orders, kGains, Range{-4, 4});
}
'''


def self_test():
    cases = (
        ('engine/options.hpp', CLEAN.replace('from low', '0...300 bar, from low')),
        ('engine/options.hpp', CLEAN.replace('"gain_db"', '"feed_bar"')),
        ('engine/options.hpp', CLEAN.replace('"phase"', '"gain_db"')),
        ('engine/options.hpp', CLEAN.replace('o.gain_db, k', 'o.feed_bar, k')),
        ('engine/engine_check.cpp', 'require(between(s.feed_bar, 0, 300), "feed_bar");'),
        ('engine/engine_check.cpp', 'require(s.feed_bar >= 0 && s.feed_bar <= 300, "feed_bar");'),
        ('engine/engine_check.cpp', 'check("feed_bar", s.feed_bar, Range{0, 300, "bar"});'),
        ('config/rig/section.cpp', 's.feed_bar = table.number("feed_bar", s.feed_bar, 0, 300);'),
        ('config/rig/section.cpp', 's.feed_bar = table.number("feed_bar",\n    s.feed_bar, {-1.5, 3e2});'),
        ('config/json/bank.cpp', 'b.rods = json.integer("rods", Range{0, 20});'),
        ('config/json/bank.cpp', 'const Range rods{0, 20};'),
    )
    for where, text in cases:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            files = {'engine/options.hpp': CLEAN, 'config/read.cpp': 'x = table.number("x", x, kGains);\n',
                     'engine/some_check.cpp': 'check.at_most(2 * t, "2 T0", x, "sigma");\n'}
            for name, content in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(content)
            if problems := list(violations(root)):
                sys.exit(f'check_ranges: complains of clean sources: {problems}')
            (root / where).parent.mkdir(parents=True, exist_ok=True)
            (root / where).write_text(text)
            if not list(violations(root)):
                sys.exit(f'check_ranges: does not catch {text!r} in {where}')


def main():
    if sys.argv[1:] == ['--self']:
        return self_test()
    problems = list(violations(pathlib.Path(sys.argv[1])))
    print('\n'.join(problems) or 'every range stands once')
    sys.exit(1 if problems else 0)


main()
