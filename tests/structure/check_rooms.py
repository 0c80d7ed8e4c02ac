#!/usr/bin/env python3
"""Fails when a room includes what it may not.

check_rooms.py ROOT     reads every source of every room and holds its includes against RULES
check_rooms.py --self   shows that each kind of violation is caught
"""
import pathlib
import re
import sys
import tempfile

STANDARD = re.compile(r'^[a-z_0-9]+$')
C_HEADERS = re.compile(r'^((sys|linux|net|netinet|arpa)/([a-z_0-9]+/)?)?[a-z_0-9]+\.h$')

# Room: rooms it may include, and headers of libraries (beside the C++ standard library).
RULES = {
    'engine': ((), ()),
    'drivers': (('engine',), ('modbus', 'alsa/', 'sndfile', 'pcap', 'readerwriterqueue', 'POSIX')),
    'config': (('engine', 'drivers'), ('toml++/', 'nlohmann/', 'sndfile', 'samplerate', 'fmt/')),
    'analysis': (('engine', 'drivers', 'config'),
                 ('Eigen/', 'unsupported/Eigen/', 'nlopt', 'sndfile', 'samplerate', 'nlohmann/', 'openssl/', 'fmt/',
                  'math.h', 'png.h')),
    'tools': (('engine', 'drivers', 'config', 'analysis'),
              ('CLI/', 'fmt/', 'spdlog/', 'nlohmann/', 'openssl/', 'readerwriterqueue', 'systemd/', 'POSIX')),
}
# The daemon plays; it never analyses.
DAEMON = 'tools/rigsoundd'
# What the engine must not know even from the standard library.
ENGINE_NEVER = {'thread', 'mutex', 'condition_variable', 'future', 'random', 'iostream', 'fstream', 'cstdio', 'chrono',
                'filesystem', 'regex', 'shared_mutex', 'sstream', 'ostream', 'istream'}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)


def owners(root):
    """Every includable path of every room -> the room."""
    found = {}
    for room in RULES:
        base = root / room
        for path in base.rglob('*.hpp'):
            relative = path.relative_to(base).as_posix()
            if relative.startswith('include/'):
                found.setdefault(relative[len('include/'):], room)
            found.setdefault(relative, room)
            found.setdefault(f'{room}/{relative}', room)
    return found


def complaint(room, name, system, owner, where):
    rooms, libraries = RULES[room]
    target = owner.get(name)
    if target is None and not system:  # beside the source, or in a parent of it
        return None
    if target is not None:
        if target != room and target not in rooms:
            return f'{room}/ may not include {target}/ ("{name}")'
        if where.startswith(DAEMON) and target == 'analysis':
            return f'the daemon may not include analysis/ ("{name}")'
        return None
    if STANDARD.match(name):
        if room == 'engine' and name in ENGINE_NEVER:
            return f'engine/ may not include <{name}>'
        return None
    if any(name.startswith(prefix) for prefix in libraries if prefix != 'POSIX'):
        return None
    if room == 'engine' and name in ('immintrin.h', 'emmintrin.h', 'arm_neon.h'):
        return None
    if room != 'engine' and 'POSIX' in libraries and C_HEADERS.match(name):
        return None
    return f'{room}/ may not include <{name}>'


def violations(root):
    owner = owners(root)
    for room in RULES:
        for path in sorted((root / room).rglob('*')):
            if path.suffix not in ('.cpp', '.hpp', '.h'):
                continue
            where = path.relative_to(root).as_posix()
            text = path.read_text(encoding='utf-8')
            for match in INCLUDE.finditer(text):
                problem = complaint(room, match.group(2), match.group(1) == '<', owner, where)
                if problem:
                    yield f'{where}:{text.count(chr(10), 0, match.start(2)) + 1}: {problem}'


def self_test():
    cases = {
        'engine/a.cpp': ('#include <mutex>', '#include <alsa/asoundlib.h>', '#include "rigsound/file.hpp"'),
        'drivers/a.cpp': ('#include <toml++/toml.h>', '#include "rigsound/config/rig.hpp"'),
        'config/a.cpp': ('#include <pthread.h>', '#include "rigsound/analysis/a.hpp"'),
        'analysis/a.cpp': ('#include <modbus/modbus.h>',),
        'tools/rigsoundd/a.cpp': ('#include "rigsound/analysis/a.hpp"',),
    }
    headers = ('engine/include/rigsound/engine.hpp', 'drivers/include/rigsound/file.hpp',
               'config/include/rigsound/config/rig.hpp', 'analysis/include/rigsound/analysis/a.hpp')
    for where, lines in cases.items():
        for line in lines:
            with tempfile.TemporaryDirectory() as folder:
                root = pathlib.Path(folder)
                for name in headers + (where,):
                    (root / name).parent.mkdir(parents=True, exist_ok=True)
                    (root / name).write_text('#include <vector>\n')
                if list(violations(root)):
                    sys.exit('check_rooms: complains of a clean house')
                (root / where).write_text(line + '\n')
                if len(list(violations(root))) != 1:
                    sys.exit(f'check_rooms: does not catch {line} in {where}')


def main():
    if sys.argv[1:] == ['--self']:
        return self_test()
    problems = list(violations(pathlib.Path(sys.argv[1])))
    print('\n'.join(problems) or 'every room includes only what it may')
    sys.exit(1 if problems else 0)


main()
