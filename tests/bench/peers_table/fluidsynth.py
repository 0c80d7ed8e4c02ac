"""FluidSynth: a SoundFont with the clicks on ten keys, and a MIDI file that strikes them."""
import math
import struct

from . import patch

FIRST_KEY = 60
LOUDEST = 1.            # gain of velocity 127, whose square is the gain
PEAK = 4 / 16.7         # more than any click's highest sample
CHANNELS = (0, 1, 2, 3)   # in turn: a key struck again on its channel would cut its last click off
HELD_S = .09
TICKS_A_SECOND = 48000    # at 120 quarters a minute
KEY_RANGE, INSTRUMENT, SAMPLE_ID, ROOT_KEY = 43, 41, 53, 58   # generators
VOLUME = 7              # controller
SILENT_FRAMES = 46      # behind each sample, as the format wants


def _chunk(name, data):
    return name + struct.pack('<I', len(data)) + data + bytes(len(data) % 2)


def _samples(clicks):
    """16 bit, and where each starts and ends."""
    data, spans, at = b'', [], 0
    for click in clicks:
        data += struct.pack(f'<{len(click)}h', *(round(32767 * x / PEAK) for x in click)) + bytes(2 * SILENT_FRAMES)
        spans.append((at, at + len(click)))
        at += len(click) + SILENT_FRAMES
    return data, spans


def soundfont(clicks):
    data, spans = _samples(clicks)
    preset = struct.pack('<20sHHHIII', b'clicks', 0, 0, 0, 0, 0, 0) + struct.pack('<20sHHHIII', b'EOP', 0, 0, 1, 0, 0, 0)
    generators = b''.join(struct.pack('<HBBHHHH', KEY_RANGE, FIRST_KEY + i, FIRST_KEY + i, ROOT_KEY, FIRST_KEY + i, SAMPLE_ID, i)
                          for i in range(len(clicks)))
    bags = b''.join(struct.pack('<HH', 3 * i, 0) for i in range(len(clicks) + 1))
    headers = b''.join(struct.pack('<20sIIIIIBbHH', f'click{i}'.encode(), start, end, start, end, patch.RATE, FIRST_KEY + i, 0, 0, 1)
                       for i, (start, end) in enumerate(spans)) + struct.pack('<20sIIIIIBbHH', b'EOS', *[0] * 9)
    parts = [(b'phdr', preset), (b'pbag', struct.pack('<HHHH', 0, 0, 1, 0)), (b'pmod', bytes(10)),
             (b'pgen', struct.pack('<HHHH', INSTRUMENT, 0, 0, 0)),
             (b'inst', struct.pack('<20sH20sH', b'clicks', 0, b'EOI', len(clicks))), (b'ibag', bags), (b'imod', bytes(10)),
             (b'igen', generators + bytes(4)), (b'shdr', headers)]
    info = _chunk(b'ifil', struct.pack('<HH', 2, 1)) + _chunk(b'isng', b'EMU8000\0') + _chunk(b'INAM', b'clicks\0\0')
    return _chunk(b'RIFF', b'sfbk' + _chunk(b'LIST', b'INFO' + info) + _chunk(b'LIST', b'sdta' + _chunk(b'smpl', data)) +
                  _chunk(b'LIST', b'pdta' + b''.join(_chunk(name, part) for name, part in parts)))


def _quantity(value):
    """A number of variable length."""
    digits = [value & 127]
    while value := value >> 7:
        digits.append(value & 127 | 128)
    return bytes(reversed(digits))


def midi(blows):
    events = [(0., bytes([0xb0 | channel, VOLUME, 127])) for channel in CHANNELS]
    for n, b in enumerate(blows):
        channel, key = CHANNELS[n % len(CHANNELS)], FIRST_KEY + b.click
        velocity = min(127, max(1, round(127 * math.sqrt(b.gain / LOUDEST))))
        events += [(b.time_s, bytes([0x90 | channel, key, velocity])), (b.time_s + HELD_S, bytes([0x80 | channel, key, 0]))]
    events.append((patch.SECONDS, b'\xff\x2f\x00'))
    track, before = b'', 0
    for time_s, event in sorted(events):
        tick = round(time_s * TICKS_A_SECOND)
        track += _quantity(tick - before) + event
        before = tick
    return b'MThd' + struct.pack('>IHHH', 6, 0, 1, TICKS_A_SECOND // 2) + b'MTrk' + struct.pack('>I', len(track)) + track


def command(folder, out):
    font, song = folder / 'clicks.sf2', folder / 'clicks.mid'
    font.write_bytes(soundfont(patch.clicks()))
    song.write_bytes(midi(patch.blows()))
    return ['fluidsynth', '-n', '-i', '-q', '-R', 0, '-C', 0, '-g', f'{LOUDEST * PEAK:.6f}', '-r', patch.RATE, '-z', patch.BLOCK, '-T', 'wav',
            '-O', 'float', '-F', out, font, song]
