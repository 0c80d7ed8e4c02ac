#!/usr/bin/env python3
"""make_shift_log.py OUT.log: a 112 s CAN log of one drilled hole, as candump -l would have written it.

The messages are those of config/dbc/rig.dbc; the hole is drilled some ten times faster than rock allows. The
same log comes out byte for byte every time, on every machine: only whole numbers and + - * / are used, and the
noise comes from a counter.
"""
import sys

EPOCH = 1733212800          # s, the log's first second
LENGTH = 112.0              # s
STEP = 0.010                # s, one step of the machine
ROD = 3.66                  # m, length of a rod

# When, s: what the driller, the rock and the instructor do. Pressures in bar, speed in r/min, load and flushing in %,
# rattling 0 none, 1 closed, 2 open; advance in mm/s; overfeed: how fast the feed rises, bar/s; simulation 0 run,
# 1 freeze.
SCRIPT = [
    (0.0, dict(speed=0, feed=0, hammer=0, rotation=0, damper=0, flushing=0, load=0, percussion=0, rattling=0, rods=1,
               rock=1, advance=0, overfeed=0, broken=0, simulation=0)),         # off
    (2.0, dict(speed=210, load=30)),                                            # the starter turns the diesel
    (3.4, dict(speed=1050, load=20)),                                           # it fires and overshoots
    (4.4, dict(speed=800, load=12)),                                            # idle
    (9.0, dict(speed=1500, load=20, flushing=60)),                              # up to drilling speed
    (11.0, dict(percussion=1, feed=25, hammer=90, rotation=35, damper=40, load=45)),   # collaring, feeling for the rock
    (13.0, dict(feed=42, advance=80, load=52)),                                 # underfeed
    (19.0, dict(feed=90, hammer=150, rotation=55, damper=60, advance=260, load=66)),   # normal
    (32.0, dict(feed=0, hammer=0, percussion=0, rotation=0, advance=0, load=30)),      # a rod is added
    (35.0, dict(rods=2)),
    (35.5, dict(feed=90, hammer=150, percussion=1, rotation=55, advance=200, load=66)),   # normal, two rods
    (44.0, dict(rock=2, rotation=48, advance=90)),                              # harder rock
    (52.0, dict(overfeed=5)),                                                   # the feed creeps up: overfeed
    (68.0, dict(broken=1, overfeed=0, feed=20, rotation=15, advance=0, load=40)),         # a rod breaks
    (71.0, dict(feed=0, hammer=0, percussion=0, rotation=0, load=20)),
    (73.0, dict(simulation=1)),                                                 # the instructor explains
    (77.0, dict(simulation=0)),
    (79.0, dict(broken=0, rods=1, feed=72, hammer=120, percussion=1, rattling=1, load=58)),   # closed rattling
    (86.0, dict(feed=14, rattling=2, load=44)),                                 # open rattling
    (94.0, dict(feed=0, hammer=0, percussion=0, rattling=0, flushing=0, damper=0, speed=800, load=12)),   # idle
    (106.0, dict(speed=0, load=0)),                                             # off
]

MASK = (1 << 64) - 1


def noise(stream, counter):
    """-1...1, triangular, from the SplitMix64 output function of (stream, counter)."""
    total = 0
    for half in (0, 1):
        z = (stream * 0x9E3779B97F4A7C15 + (2 * counter + half) * 0xD1B54A32D192ED03) & MASK
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        total += (z ^ (z >> 31)) >> 40
    return total / (1 << 24) - 1.0


class Machine:
    """Follows the script as a machine would: pressure and speed lag behind, the pump and the diesel shake them."""

    LAGS = dict(feed=0.25, hammer=0.20, rotation=0.30, damper=0.50, load=0.30, flushing=0.80)   # s

    def __init__(self):
        self.wanted = {}
        self.done = 0           # lines of the script
        self.now = dict.fromkeys(self.LAGS, 0.0)
        self.speed = self.ripple = self.hunting = self.position = 0.0
        self.rods = 1
        self.coolant = 61.0
        self.steps = 0

    def step(self):
        time = self.steps * STEP
        while self.done < len(SCRIPT) and SCRIPT[self.done][0] <= time + STEP / 2:
            self.wanted.update(SCRIPT[self.done][1])
            self.done += 1
        want = self.wanted
        want['feed'] += want['overfeed'] * STEP
        if not want['simulation']:
            self.move(want)
        self.steps += 1

    def move(self, want):
        self.speed += (want['speed'] - self.speed) * STEP / (0.12 if want['speed'] < 300 else 0.35)
        for name, lag in self.LAGS.items():
            self.now[name] += (want[name] - self.now[name]) * STEP / lag
        self.ripple += (noise(1, self.steps) * 9.0 - self.ripple) * 0.25
        self.hunting += (noise(2, self.steps) * 40.0 - self.hunting) * 0.05
        self.coolant += (84.0 - self.coolant) * STEP / 240 if self.speed > 300 else 0
        self.position = min(ROD, self.position + want['advance'] * STEP / 1000)
        if want['rods'] != self.rods:
            self.rods, self.position = want['rods'], 0.0

    def speed_raw(self):
        turning = min(1.0, self.speed / 100)
        return max(0, int((self.speed + self.hunting * turning) / 0.125 + 0.5)) if self.speed > 5 else 0

    def pressure_raw(self, name, shaken):
        bar = self.now[name]
        pressed = min(1.0, bar / 30)
        return max(0, int((bar + self.ripple * shaken * pressed) / 0.01 + 0.5)) if bar > 0.5 else 0

    def load_raw(self):
        return max(0, min(125, int(self.now['load'] + 0.5)))


def word(raw):
    return [raw & 0xFF, raw >> 8]


def eec1(m):
    return [0xF0, 0xFF, m.load_raw() + 125] + word(m.speed_raw()) + [0x00, 0xFF, 0xFF]


def eec2(m):
    return [0xFF, 0xFF, m.load_raw()] + [0xFF] * 5


def et1(m):
    return [int(m.coolant + 40.5)] + [0xFF] * 7


def drill1(m):
    state = 0xC0 | m.wanted['broken'] << 4 | m.wanted['percussion'] << 2 | m.wanted['rattling']
    return word(m.pressure_raw('feed', 1.0)) + [0xFF, 0xFF, state, m.wanted['rods'], m.wanted['rock'], 0xFF]


def drill2(m):
    return (word(m.pressure_raw('hammer', 0.5)) + word(m.pressure_raw('rotation', 0.4)) +
            word(m.pressure_raw('damper', 0.2)) + [0xFF, 0xFF])


def drill3(m):
    return word(int(m.position * 1000 + 0.5)) + [int(m.now['flushing'] / 0.4 + 0.5)] + [0xFF] * 5


def cabin1(m):
    return [120, 0xFC | m.wanted['simulation']] + [0xFF] * 6


# Identifier, cycle in steps, first step, data.
MESSAGES = [
    ('0CF00400', 2, 0, eec1),
    ('0CF00300', 5, 1, eec2),
    ('18FF1017', 5, 3, drill1),
    ('18FF1217', 10, 4, drill2),
    ('18FF1317', 20, 6, drill3),
    ('18FEEE00', 100, 7, et1),
    ('18FF1128', 50, 9, cabin1),
]


def lines():
    machine = Machine()
    for step in range(int(LENGTH / STEP + 0.5)):
        machine.step()
        # One after the other on the wire, 0.28 ms each at 500 kbit/s, after a little waiting.
        microseconds = step * 10000 + int(150 * (1 + noise(3, step)))
        if step == 0:
            microseconds = 0
        for identifier, cycle, first, data in MESSAGES:
            if step % cycle == first % cycle and step >= first:
                text = ''.join(f'{byte:02X}' for byte in data(machine))
                yield f'({EPOCH + microseconds // 1000000:010d}.{microseconds % 1000000:06d}) can0 {identifier}#{text}'
                microseconds += 280


def main():
    if len(sys.argv) != 2:
        sys.exit('usage: make_shift_log.py OUT.log')
    with open(sys.argv[1], 'w', encoding='ascii', newline='\n') as log:
        log.write('\n'.join(lines()) + '\n')


main()
