#!/usr/bin/env python3
"""Fails when a module includes what it may not, or draws past the kit of charts.

check_rooms.py ROOT     reads every source and every CMakeLists.txt of every module
check_rooms.py --self   shows that each kind of violation is caught

A module sees of another one only its include/rigsound/... Inside engine/ arrows point down the FLOORS.
"""
import pathlib
import re
import sys
import tempfile

STANDARD = re.compile(r'^[a-z_0-9]+$')
C_HEADERS = re.compile(r'^((sys|linux|net|netinet|arpa)/([a-z_0-9]+/)?)?[a-z_0-9]+\.h$')
SIMD = ('immintrin.h', 'emmintrin.h', 'arm_neon.h')

GROUND = ('engine/dsp', 'engine/machine')
# Module: modules it may include, and headers of libraries (beside the C++ standard library).
RULES = {
    'engine/dsp': ((), ()),
    'engine/machine': (('engine/dsp',), ()),
    'engine': (GROUND, ()),
    'drivers': ((*GROUND, 'engine'), ('modbus', 'alsa/', 'lo/', 'sndfile', 'pcap', 'readerwriterqueue', 'nlohmann/', 'POSIX')),
    'config': ((*GROUND, 'engine', 'drivers'), ('toml++/', 'nlohmann/', 'sndfile', 'nettle/', 'fmt/')),
    'analysis': ((*GROUND, 'engine', 'drivers', 'config'),
                 ('Eigen/', 'unsupported/Eigen/', 'nlopt', 'sndfile', 'samplerate', 'nlohmann/', 'nettle/', 'fmt/',
                  'math.h', 'png.h', 'ft2build.h')),
    'tools': ((*GROUND, 'engine', 'drivers', 'config', 'analysis'),
              ('CLI/', 'fmt/', 'httplib.h', 'spdlog/', 'nlohmann/', 'nettle/', 'readerwriterqueue', 'systemd/', 'POSIX')),
}
# Inside engine/, from the ground up: a part may include itself and the floors below. Public headers stand on the
# floor of what they describe; files and headers not named here are the models on the ground or engine.cpp on top.
FLOORS = (
    ('field_check.hpp', 'field_check.cpp'),
    ('impact',),
    ('drill', 'tool', 'diesel'),
    ('string',),
    ('scene', 'mix', 'rigsound/feed_reach.hpp', 'rigsound/feed_rule.hpp', 'rigsound/options.hpp', 'rigsound/sound_set.hpp'),
    ('engine_check.hpp', 'engine_check.cpp', 'engine.cpp', 'rigsound/engine.hpp'),
)
# The daemon and the library play; they never analyse.
PLAYERS = {'tools/rigsoundd/': 'the daemon', 'tools/library/': 'the library'}
# Programs of other people, built against what is installed.
EXAMPLES = ('tools/library/examples/', 'config/examples/')
# CLI11 costs seconds in every file that includes it.
COMMAND_LINE = 'tools/cli/'
# So does the library for HTTP, in the one file that includes it.
WEB_SERVER = 'tools/studio/server/http_server.cpp'
# Charts look alike, in light and dark, because one kit draws them.
CHARTS = 'analysis/chart/'
MARKS = re.compile(r'<(svg|path|polyline|circle|rect)[ >]')
# What the engine must not know even from the standard library.
ENGINE_NEVER = {'thread', 'mutex', 'condition_variable', 'future', 'random', 'iostream', 'fstream', 'cstdio', 'chrono',
                'filesystem', 'regex', 'shared_mutex', 'sstream', 'ostream', 'istream'}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
INCLUDE_PATHS = re.compile(r'(?:target_)?include_directories\s*\(([^)]*)\)')
FOLDER = re.compile(r'(\$\{(?:PROJECT|CMAKE)_SOURCE_DIR\}|\$\{CMAKE_CURRENT_(?:SOURCE|LIST)_DIR\}|\.\.)((?:/[\w.]+)*)')


def module_of(path):
    """The module a path inside the project belongs to; None outside all of them."""
    return next((m for m in RULES if path == m or path.startswith(m + '/')), None)


def headers(root):
    """Includable names of every module: {name: module} of public and of private headers."""
    public, private = {}, {}
    for module in RULES:
        for path in sorted((root / module).rglob('*.hpp')):
            relative = path.relative_to(root / module).as_posix()
            if module_of(path.relative_to(root).as_posix()) != module:
                continue
            if relative.startswith('include/'):
                public[relative[len('include/'):]] = module
            for name in (relative, f'{module}/{relative}'):
                private.setdefault(name, set()).add(module)
    return public, private


def floor_of(name):
    """(floor, part) of a file or header of engine/; the models and parts that are new stand on floor -1."""
    for floor, parts in enumerate(FLOORS):
        for part in parts:
            if name == part or name.startswith(part + '/'):
                return floor, part
    return -1, name


def inside_engine(name, where):
    """What is wrong with the synthesiser's file `where` including its own header `name`."""
    relative = where[len('engine/'):]
    if relative.startswith('include/'):
        relative = relative[len('include/'):]
    floor, part = floor_of(relative)
    wanted, target = floor_of(name)
    if wanted > floor:
        return f'engine/{part} may not include up to engine/{target} ("{name}")'
    if wanted == floor and target != part and not ('.' in part or '.' in target):
        return f'engine/{part} may not include engine/{target} beside it ("{name}")'
    if relative.startswith('tool/design/') and name.startswith('tool/') and not name.startswith('tool/design/'):
        return f'engine/tool/design/ may not include what plays its design ("{name}")'
    return None


def of_module(target, name, where, private):
    module = module_of(where)
    if target != module and target not in RULES[module][0]:
        return f'{module}/ may not include {target}/ ("{name}")'
    if target != module and private:
        return f'{module}/ may not include a private header of {target}/ ("{name}")'
    player = next((who for folder, who in PLAYERS.items() if where.startswith(folder)), None)
    if player and target == 'analysis':
        return f'{player} may not include analysis/ ("{name}")'
    return inside_engine(name, where) if module == target == 'engine' else None


def of_library(name, where):
    module = module_of(where)
    libraries = RULES[module][1]
    if STANDARD.match(name):
        return f'engine/ may not include <{name}>' if module.startswith('engine') and name in ENGINE_NEVER else None
    if name.startswith('CLI/') and not where.startswith(COMMAND_LINE):
        return f'only {COMMAND_LINE} may include <{name}>'
    if name == 'httplib.h' and where != WEB_SERVER:
        return f'only {WEB_SERVER} may include <{name}>'
    if any(name.startswith(prefix) for prefix in libraries if prefix != 'POSIX'):
        return None
    if module.startswith('engine') and name in SIMD or 'POSIX' in libraries and C_HEADERS.match(name):
        return None
    return f'{module}/ may not include <{name}>'


def complaint(name, system, where, root, public, private):
    module = module_of(where)
    if (root / where).parent.joinpath(name).is_file():  # beside the source
        return inside_engine(name, where) if module == 'engine' else None
    if name in public:
        return of_module(public[name], name, where, private=False)
    owners = private.get(name, ())
    if owners:
        return of_module(module if module in owners else sorted(owners)[0], name, where, private=True)
    return of_library(name, where) if system else None


def of_cmake(path, root):
    """Include paths into another module's private folders."""
    text = path.read_text(encoding='utf-8')
    folder = path.parent
    module = module_of(folder.relative_to(root).as_posix())
    for command in INCLUDE_PATHS.finditer(text):
        for match in FOLDER.finditer(command.group(1)):
            base = root if 'PROJECT_' in match.group(1) or 'CMAKE_SOURCE' in match.group(1) else (
                folder.parent if match.group(1) == '..' else folder)
            named = pathlib.Path(str(base) + match.group(2)).resolve()
            if root.resolve() not in named.parents:
                continue
            target = module_of(named.relative_to(root.resolve()).as_posix())
            if target and target != module and 'include' not in named.parts[len(root.resolve().parts):]:
                at = text.count('\n', 0, command.start(1) + match.start()) + 1
                yield f'{path.relative_to(root).as_posix()}:{at}: adds a private folder of {target}/ to its include paths'


def violations(root):
    public, private = headers(root)
    for top in sorted({module.split('/')[0] for module in RULES}):
        for path in sorted((root / top).rglob('*')):
            if path.name == 'CMakeLists.txt':
                yield from of_cmake(path, root)
            if path.suffix not in ('.cpp', '.hpp', '.h'):
                continue
            where = path.relative_to(root).as_posix()
            if where.startswith(EXAMPLES):
                continue
            text = path.read_text(encoding='utf-8')
            for match in () if where.startswith(CHARTS) else MARKS.finditer(text):
                yield f'{where}:{text.count(chr(10), 0, match.start()) + 1}: only {CHARTS} may write <{match.group(1)}>'
            for match in INCLUDE.finditer(text):
                problem = complaint(match.group(2), match.group(1) == '<', where, root, public, private)
                if problem:
                    yield f'{where}:{text.count(chr(10), 0, match.start(2)) + 1}: {problem}'


CLEAN = {
    'engine/dsp/include/rigsound/dsp/fft.hpp': '#include <vector>',
    'engine/dsp/twiddle.hpp': '#include <array>',
    'engine/machine/include/rigsound/machine/signal.hpp': '#include "rigsound/dsp/fft.hpp"',
    'engine/machine/words.hpp': '#include <string>',
    'engine/include/rigsound/engine.hpp': '#include "rigsound/options.hpp"',
    'engine/include/rigsound/options.hpp': '#include "rigsound/machine/signal.hpp"',
    'engine/include/rigsound/tool_model.hpp': '#include <vector>',
    'engine/field_check.hpp': '#include <string>',
    'engine/impact/train.hpp': '#include "rigsound/dsp/fft.hpp"',
    'engine/drill/layer.hpp': '#include "impact/train.hpp"\n#include "field_check.hpp"',
    'engine/tool/bar.hpp': '#include <immintrin.h>',
    'engine/tool/bar.cpp': '#include "tool/bar.hpp"\n#include "tool/design/solver.hpp"',
    'engine/tool/design/solver.hpp': '#include "rigsound/tool_model.hpp"',
    'engine/scene/rig.hpp': '#include "drill/layer.hpp"\n#include "rigsound/options.hpp"',
    'engine/engine.cpp': '#include "rigsound/engine.hpp"\n#include "scene/rig.hpp"',
    'drivers/include/rigsound/file.hpp': '#include <sys/stat.h>',
    'drivers/can/port.hpp': '#include "rigsound/machine/signal.hpp"\n#include <linux/can.h>',
    'config/include/rigsound/config/rig.hpp': '#include "rigsound/engine.hpp"',
    'config/toml/table.hpp': '#include <toml++/toml.h>',
    'analysis/include/rigsound/analysis/chain.hpp': '#include "rigsound/config/rig.hpp"',
    'analysis/clicks/fit.hpp': '#include <Eigen/Core>',
    'analysis/chart/svg.cpp': 'const char* start = "<svg viewBox=";',
    'analysis/CMakeLists.txt': 'target_include_directories(a PUBLIC include PRIVATE ${PROJECT_SOURCE_DIR}/analysis)',
    'tools/cli/verb.cpp': '#include <CLI/CLI.hpp>',
    'tools/studio/server/http_server.cpp': '#include <httplib.h>',
    'tools/rigsound/main.cpp': '#include "rigsound/analysis/chain.hpp"',
    'tools/rigsoundd/main.cpp': '#include "rigsound/config/rig.hpp"',
    'tools/library/examples/player.cpp': '#include <alsa/asoundlib.h>',
    'tools/CMakeLists.txt': 'target_include_directories(t PRIVATE ${PROJECT_SOURCE_DIR}/engine/include)',
}
BREAKS = (
    ('engine/dsp/fft.cpp', '#include "rigsound/machine/signal.hpp"'),
    ('engine/dsp/fft.cpp', '#include <alsa/asoundlib.h>'),
    ('engine/dsp/fft.cpp', '#include "rigsound/tool_model.hpp"'),
    ('engine/machine/signal.cpp', '#include "rigsound/options.hpp"'),
    ('engine/machine/signal.cpp', '#include "twiddle.hpp"'),
    ('engine/machine/signal.cpp', '#include <mutex>'),
    ('engine/a.cpp', '#include <chrono>'),
    ('engine/a.cpp', '#include "rigsound/file.hpp"'),
    ('engine/a.cpp', '#include "words.hpp"'),
    ('engine/impact/train.cpp', '#include "drill/layer.hpp"'),
    ('engine/drill/layer.cpp', '#include "scene/rig.hpp"'),
    ('engine/drill/layer.cpp', '#include "tool/bar.hpp"'),
    ('engine/drill/layer.cpp', '#include "rigsound/options.hpp"'),
    ('engine/mix/mixer.cpp', '#include "rigsound/engine.hpp"'),
    ('engine/tool/design/solver.cpp', '#include "tool/bar.hpp"'),
    ('engine/include/rigsound/tool_model.hpp', '#include "rigsound/options.hpp"'),
    ('drivers/a.cpp', '#include <toml++/toml.h>'),
    ('drivers/a.cpp', '#include "rigsound/config/rig.hpp"'),
    ('drivers/a.cpp', '#include "tool/bar.hpp"'),
    ('config/a.cpp', '#include <pthread.h>'),
    ('config/a.cpp', '#include "rigsound/analysis/chain.hpp"'),
    ('config/a.cpp', '#include "can/port.hpp"'),
    ('analysis/a.cpp', '#include <modbus/modbus.h>'),
    ('analysis/a.cpp', 'const char* start = "<svg viewBox=";'),
    ('analysis/a.cpp', '#include "twiddle.hpp"'),
    ('analysis/a.cpp', '#include "engine/drill/layer.hpp"'),
    ('analysis/CMakeLists.txt', 'target_include_directories(a PRIVATE\n  ${PROJECT_SOURCE_DIR}/engine)'),
    ('analysis/CMakeLists.txt', 'include_directories(../engine/tool)'),
    ('engine/machine/CMakeLists.txt', 'target_include_directories(m PRIVATE ${PROJECT_SOURCE_DIR}/engine/dsp)'),
    ('tools/rigsound/a.cpp', '#include "clicks/fit.hpp"'),
    ('tools/rigsound/a.cpp', '#include <CLI/CLI.hpp>'),
    ('tools/studio/server/a.cpp', '#include <httplib.h>'),
    ('tools/rigsound/a.cpp', '#include "toml/table.hpp"'),
    ('tools/rigsoundd/a.cpp', '#include "rigsound/analysis/chain.hpp"'),
    ('tools/library/a.cpp', '#include "rigsound/analysis/chain.hpp"'),
)


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in CLEAN.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text + '\n')
        if problems := list(violations(root)):
            sys.exit(f'check_rooms: complains of clean sources: {problems}')
        for where, line in BREAKS:
            path = root / where
            before = path.read_text() if path.exists() else None
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(line + '\n')
            problems = list(violations(root))
            if len(problems) != 1 or not problems[0].startswith(where + ':'):
                sys.exit(f'check_rooms: does not catch {line} in {where}: {problems}')
            path.unlink() if before is None else path.write_text(before)


def main():
    if sys.argv[1:] == ['--self']:
        return self_test()
    problems = list(violations(pathlib.Path(sys.argv[1])))
    print('\n'.join(problems) or 'every module includes only what it may')
    sys.exit(1 if problems else 0)


main()
