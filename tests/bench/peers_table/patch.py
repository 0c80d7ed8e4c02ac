"""What all play: 40 blows a second on ten clicks, each blow one of them with its gain, in the middle of two channels."""
import array
import math
import random
from dataclasses import dataclass

RATE, BLOCK, SECONDS = 48000, 64, 300
BLOWS_HZ, CLICKS, CLICK_S, DECAY_S = 40, 10, .08, 1 / 86
LEVEL, LEVEL_SPREAD, GAP_SPREAD = .5, .2, .04   # norm of a click; spreads are shares of the mean
MIDDLE = 2 ** -.5   # of equal-power panning
RING = .25          # of the bar beside the clicks
# A bar's modes: hertz, and the seconds in which they fall by 60 dB. Eight transversal, four longitudinal ones.
MODES = [(480 * ((2 * n + 1) / 3) ** 2, .6 / n ** .5) for n in range(1, 9)] + [(5100 * n, .3 / n) for n in range(1, 5)]


@dataclass
class Blow:
    time_s: float
    click: int
    gain: float


def clicks():
    """Noise that decays, of unit norm."""
    draw = random.Random(1)
    made = []
    for _ in range(CLICKS):
        noise = [draw.gauss(0, 1) * math.exp(-n / (DECAY_S * RATE)) for n in range(round(CLICK_S * RATE))]
        norm = math.sqrt(sum(x * x for x in noise))
        made.append(array.array('f', [x / norm for x in noise]))
    return made


def blows():
    draw, made, time_s = random.Random(2), [], 0.
    while time_s < SECONDS - CLICK_S:
        gain = LEVEL * max(.1, 1 + LEVEL_SPREAD * draw.gauss(0, 1))
        made.append(Blow(time_s, draw.randrange(CLICKS), gain))
        time_s += max(.1, 1 + GAP_SPREAD * draw.gauss(0, 1)) / BLOWS_HZ
    return made
