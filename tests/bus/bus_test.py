#!/usr/bin/env python3
"""bus_test.py PROJECT BUILD [TEST...]: boots the virtual machine once, runs guest/suite.py in it, then renders
the sessions it left and compares them, bit for bit, with what was captured from the card.

Without a machine the test is skipped (77), loudly; when CI is set in the environment that is a failure. A machine
that started and did not come to an end has failed, wherever it is.

TEST is a module or a test of guest/, e.g. can_tests.Flood. `soak_tests` (ten minutes of sound at each period) runs
only when it is named.
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys

from vm import machine

HERE = pathlib.Path(__file__).parent
LIMIT_S = 2000
SOAK_LIMIT_S = 3 * 3600
FRAMES_LEFT_IN_THE_CARD = 1024   # when it was closed: rendered, never heard
FRAMES_A_CRASH_MAY_COST = 48000  # heard, not in the session


def prepare(build):
    work = build / 'tests' / 'bus' / 'run'
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    subprocess.run([build / 'tools' / 'packaging' / 'write_sound_set', work / 'sounds'], check=True)
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


def without_silence(raw, frame):
    nothing = bytes(frame)
    frames = (raw[i:i + frame] for i in range(0, len(raw) - frame + 1, frame))
    return b''.join(sound for sound in frames if sound != nothing)


def same_bits(build, session):
    """After an xrun (`gaps_`) the card was silent for a while: then silence does not count."""
    name = session.stem
    frame = 4 if name.endswith('s16') else 8
    compared = without_silence if name.startswith('gaps_') else from_first_sound
    wav = session.with_suffix('.wav')
    subprocess.run([build / 'tools' / 'rigsound', 'render', session.with_suffix('.toml'), '--session', session, '--out',
                    wav], check=True, stdout=subprocess.DEVNULL)
    rendered = compared(samples_of(wav), frame)
    captured = compared(session.with_suffix('.raw').read_bytes(), frame)
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
    chosen = sys.argv[3:]
    work = prepare(build)
    command = ['/usr/bin/python3', '-B', HERE / 'guest' / 'suite.py', project, build, work, *chosen]
    limit_s = SOAK_LIMIT_S if any('soak' in name for name in chosen) else LIMIT_S
    try:
        status = machine.run(work, command, limit_s, (project, build))
    except machine.CannotStart as reason:
        required = bool(os.environ.get('CI'))
        print(f'{"FAILED" if required else "SKIPPED"}: bus: no virtual machine: {reason}', flush=True)
        return 1 if required else 77
    sessions = sorted(work.glob('*.rigsession'))
    equal = [same_bits(build, session) for session in sessions]
    return 0 if status == 0 and all(equal) else 1


if __name__ == '__main__':
    sys.exit(main())
