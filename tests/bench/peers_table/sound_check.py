"""Whether what a program wrote is the patch: its length, and its level, without which a ratio of times says nothing."""
import array
import math
import struct

from . import patch

FROM_S, FOR_S = patch.SECONDS / 3, 10
FRAME = 8   # bytes: two channels of 32 bit float


def _samples_at(file):
    """Place and size of a WAV's data."""
    file.seek(12)
    while head := file.read(8):
        name, size = head[:4], struct.unpack('<I', head[4:])[0]
        if name == b'data':
            return file.tell(), size
        file.seek(size + size % 2, 1)
    raise SystemExit(f'{file.name}: no samples')


def level_db(path):
    """RMS of the left channel of a part. Ends the program when the file is of another length than the patch."""
    with open(path, 'rb') as file:
        at, size = _samples_at(file)
        seconds = size / FRAME / patch.RATE
        if not patch.SECONDS - .1 <= seconds <= patch.SECONDS + 3:
            raise SystemExit(f'{path}: {seconds:.1f} s, expected {patch.SECONDS}')
        file.seek(at + round(FROM_S * patch.RATE) * FRAME)
        left = array.array('f', file.read(round(FOR_S * patch.RATE) * FRAME))[::2]
    return 10 * math.log10(sum(x * x for x in left) / len(left) + 1e-20)
