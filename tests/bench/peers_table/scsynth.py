"""SuperCollider's server without sclang: synth definitions and an OSC score for rendering offline, as bytes."""
import struct

from . import patch
from .click_files import click_files

CONTROL, AUDIO = 1, 2   # rates
TIMES = 2               # special index of BinaryOpUGen: *
FREE_SYNTH = 2          # what is done when a sound is over
DRY_BUS = 16            # behind the hardware's


class Definition:
    """One synth definition, file format 2."""

    def __init__(self, name, parameters=()):
        self.name, self.parameters, self.constants, self.units = name, parameters, [], []
        if parameters:
            self.add('Control', CONTROL, (), len(parameters))

    def add(self, name, rate, inputs, outputs=1, special=0):
        """Inputs are numbers or (unit, output). Returns the unit's number."""
        sources = b''
        for source in inputs:
            if not isinstance(source, tuple):
                if source not in self.constants:
                    self.constants.append(source)
                source = (-1, self.constants.index(source))
            sources += struct.pack('>ii', *source)
        self.units.append(_short(name) + struct.pack('>biih', rate, len(inputs), outputs, special) + sources + bytes([rate]) * outputs)
        return len(self.units) - 1

    def file(self):
        body = _short(self.name) + struct.pack(f'>i{len(self.constants)}f', len(self.constants), *self.constants)
        body += struct.pack('>i', len(self.parameters)) + bytes(4 * len(self.parameters)) + struct.pack('>i', len(self.parameters))
        body += b''.join(_short(p) + struct.pack('>i', i) for i, p in enumerate(self.parameters))
        body += struct.pack('>i', len(self.units)) + b''.join(self.units) + struct.pack('>h', 0)
        return b'SCgf' + struct.pack('>ih', 2, 1) + body


def _short(text):
    return bytes([len(text)]) + text.encode()


def _padded(data):
    return data + bytes(-len(data) % 4)


def message(address, *arguments):
    tags, data = ',', b''
    for a in arguments:
        tags += {int: 'i', float: 'f', str: 's', bytes: 'b'}[type(a)]
        data += (struct.pack('>i', a) if isinstance(a, int) else struct.pack('>f', a) if isinstance(a, float) else
                 _padded(a.encode() + b'\0') if isinstance(a, str) else struct.pack('>i', len(a)) + _padded(a))
    return _padded(address.encode() + b'\0') + _padded(tags.encode() + b'\0') + data


def bundle(time_s, *messages):
    body = b'#bundle\0' + struct.pack('>Q', round(time_s * 2 ** 32)) + b''.join(struct.pack('>i', len(m)) + m for m in messages)
    return struct.pack('>i', len(body)) + body


def click_definition(bus, channels, gain):
    d = Definition('click', ('buffer', 'gain'))
    played = d.add('PlayBuf', AUDIO, ((0, 0), 1., 1., 0., 0., float(FREE_SYNTH)))
    scaled = d.add('BinaryOpUGen', AUDIO, ((played, 0), (0, 1)), special=TIMES)
    if gain != 1:
        scaled = d.add('BinaryOpUGen', AUDIO, ((scaled, 0), gain), special=TIMES)
    d.add('Out', AUDIO, (float(bus), *[(scaled, 0)] * channels), 0)
    return d.file()


def bar_definition():
    """DynKlank: a resonator a mode, and their sum, beside what excites them."""
    d = Definition('bar')
    dry = d.add('In', AUDIO, (float(DRY_BUS),))
    total = dry
    for frequency_hz, decay_s in patch.MODES:
        ring = d.add('Ringz', AUDIO, ((dry, 0), frequency_hz, decay_s))
        total = d.add('MulAdd', AUDIO, ((ring, 0), patch.RING / len(patch.MODES), (total, 0)))
    middle = d.add('BinaryOpUGen', AUDIO, ((total, 0), patch.MIDDLE), special=TIMES)
    d.add('Out', AUDIO, (0., (middle, 0), (middle, 0)), 0)
    return d.file()


def score(files, with_bar):
    bus, channels, gain = (DRY_BUS, 1, 1) if with_bar else (0, 2, patch.MIDDLE)
    first = [message('/d_recv', click_definition(bus, channels, gain))]
    first += [message('/b_allocRead', i, str(file)) for i, file in enumerate(files)]
    if with_bar:
        first += [message('/d_recv', bar_definition()), message('/s_new', 'bar', 1, 1, 0)]
    played = [bundle(b.time_s, message('/s_new', 'click', -1, 0, 0, 0, b.click, 1, b.gain)) for b in patch.blows()]
    return b''.join([bundle(0, *first), *played, bundle(patch.SECONDS, message('/sync', 0))])


def command(folder, out, with_bar):
    file = folder / f'scsynth{with_bar:d}.osc'
    file.write_bytes(score(click_files(folder), with_bar))
    return ['scsynth', '-D', 0, '-i', 0, '-o', 2, '-z', patch.BLOCK, '-N', file, '_', out, patch.RATE, 'WAV', 'float']
