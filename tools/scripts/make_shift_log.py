#!/usr/bin/env python3
"""make_shift_log.py OUT.log: a 90 s CAN log of one drilled hole, as candump -l would have written it.

The messages are those of config/dbc/rig.dbc. The same log comes out byte for byte every time, on every
machine: only whole numbers and + - * / are used, and the noise comes from a counter.
"""
import sys

EPOCH = 1733212800          # s, the log's first second
LENGTH = 90.0               # s
STEP = 0.010                # s, one step of the machine

# When, s: what the driller does. Feed in bar, speed in r/min, rattling 0 none, 1 closed, 2 open.
SCRIPT = [
    (0.0, dict(speed=0, feed=0, percussion=0, rattling=0, load=0)),        # off
    (2.0, dict(speed=210, load=30)),                                       # the starter turns the diesel
    (3.4, dict(speed=1050, load=20)),                                      # it fires and overshoots
    (4.4, dict(speed=800, load=12)),                                       # idle
    (12.0, dict(speed=1500, load=20)),                                     # up to drilling speed
    (14.0, dict(percussion=1, feed=25, load=45)),                          # percussion on, feeling for the rock
    (16.0, dict(feed=42, load=52)),                                        # underfeed
    (26.0, dict(feed=90, load=66)),                                        # normal
    (40.0, dict(feed=152, load=85)),                                       # overfeed
    (50.0, dict(feed=90, load=66)),                                        # normal
    (62.0, dict(feed=72, rattling=1, load=58)),                            # closed rattling
    (68.0, dict(feed=14, rattling=2, load=44)),                            # open rattling
    (76.0, dict(feed=0, percussion=0, rattling=0, speed=800, load=12)),    # idle
    (86.0, dict(speed=0, load=0)),                                         # off
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

    def __init__(self):
        self.wanted = {}
        self.done = 0           # lines of the script
        self.speed = self.feed = self.load = self.ripple = self.hunting = 0.0
        self.coolant = 61.0
        self.steps = 0

    def step(self):
        time = self.steps * STEP
        while self.done < len(SCRIPT) and SCRIPT[self.done][0] <= time + STEP / 2:
            self.wanted.update(SCRIPT[self.done][1])
            self.done += 1
        want = self.wanted
        self.speed += (want['speed'] - self.speed) * STEP / (0.12 if want['speed'] < 300 else 0.35)
        self.feed += (want['feed'] - self.feed) * STEP / 0.25
        self.load += (want['load'] - self.load) * STEP / 0.30
        self.ripple += (noise(1, self.steps) * 9.0 - self.ripple) * 0.25
        self.hunting += (noise(2, self.steps) * 40.0 - self.hunting) * 0.05
        self.coolant += (84.0 - self.coolant) * STEP / 240 if self.speed > 300 else 0
        self.steps += 1

    def speed_raw(self):
        turning = min(1.0, self.speed / 100)
        return max(0, int((self.speed + self.hunting * turning) / 0.125 + 0.5)) if self.speed > 5 else 0

    def feed_raw(self):
        pressed = min(1.0, self.feed / 30)
        return max(0, int((self.feed + self.ripple * pressed) / 0.01 + 0.5)) if self.feed > 0.5 else 0

    def load_raw(self):
        return max(0, min(125, int(self.load + 0.5)))


def word(raw):
    return [raw & 0xFF, raw >> 8]


def eec1(m):
    return [0xF0, 0xFF, m.load_raw() + 125] + word(m.speed_raw()) + [0x00, 0xFF, 0xFF]


def eec2(m):
    return [0xFF, 0xFF, m.load_raw()] + [0xFF] * 5


def et1(m):
    return [int(m.coolant + 40.5)] + [0xFF] * 7


def drill1(m):
    return word(m.feed_raw()) + [0xFF, 0xFF, 0xF0 | m.wanted['percussion'] << 2 | m.wanted['rattling'], 1, 0, 0xFF]


def cabin1(_):
    return [120] + [0xFF] * 7


# Identifier, cycle in steps, first step, data.
MESSAGES = [
    ('0CF00400', 2, 0, eec1),
    ('0CF00300', 5, 1, eec2),
    ('18FF1017', 5, 3, drill1),
    ('18FEEE00', 100, 7, et1),
    ('18FF1128', 100, 9, cabin1),
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
