#!/usr/bin/env python3
"""bus_test.py PROJECT BUILD [TEST...]: boots the virtual machine once, runs guest/suite.py in it, then renders
the sessions it left and compares them, bit for bit, with what was captured from the card.

Without a machine the test is skipped (77), loudly; when CI is set in the environment that is a failure.
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys

from vm import machine

HERE = pathlib.Path(__file__).parent
LIMIT_S = 1000
FRAMES_LEFT_IN_THE_CARD = 1024   # when it was closed: rendered, never heard
FRAMES_A_CRASH_MAY_COST = 48000  # heard, not in the session


def prepare(build):
    work = build / 'tests' / 'bus' / 'run'
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    subprocess.run([build / 'tests' / 'bus' / 'write_sound_set', work / 'sounds'], check=True)
    return work


def samples_of(wav):
    data = wav.read_bytes()
    at = 12
    while data[at:at + 4] != b'data':
        at += 8 + struct.unpack('<I', data[at + 4:at + 8])[0]
    return data[at + 8:]


def from_first_sound(raw, frame):
    """The bytes from the first frame that is not silent on."""
    start = len(raw) - len(raw.lstrip(b'\0'))
    return raw[start // frame * frame:]


def same_bits(build, session):
    name = session.stem
    frame = 4 if name.endswith('s16') else 8
    wav = session.with_suffix('.wav')
    subprocess.run([build / 'tools' / 'rigsound', 'render', session.with_suffix('.toml'), '--session', session, '--out',
                    wav], check=True, stdout=subprocess.DEVNULL)
    rendered = from_first_sound(samples_of(wav), frame)
    captured = from_first_sound(session.with_suffix('.raw').read_bytes(), frame)
    common = min(len(rendered), len(captured))
    wrong = next((i for i in range(common) if rendered[i] != captured[i]), None)
    unheard = (len(rendered) - common) // frame
    unrecorded = len(captured[common:].rstrip(b'\0')) // frame
    print(f'FIGURE {name}: {common // frame} frames captured '
          + ('equal those of the rendered session' if wrong is None else f'differ from frame {wrong // frame} on')
          + f'; {unheard} never left the card, {unrecorded} were heard and not recorded')
    return (common > 0 and wrong is None and unheard <= FRAMES_LEFT_IN_THE_CARD and
            unrecorded <= FRAMES_A_CRASH_MAY_COST)


def main():
    project, build = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    work = prepare(build)
    try:
        status = machine.run(work, ['/usr/bin/python3', '-B', HERE / 'guest' / 'suite.py', project, build, work,
                                    *sys.argv[3:]], LIMIT_S)
    except machine.CannotStart as reason:
        print(f'SKIPPED: bus: no virtual machine: {reason}', flush=True)
        return 1 if os.environ.get('CI') else 77
    sessions = sorted(work.glob('*.rigsession'))
    equal = [same_bits(build, session) for session in sessions]
    return 0 if status == 0 and all(equal) else 1


if __name__ == '__main__':
    sys.exit(main())
