#!/usr/bin/env python3
"""airhammer.py OUT.wav: takes the air hammer out of Debian's package openttd-opensfx.

The recording is "air hammer half close.wav" by Bluesy1905, cut and edited by Wuzzy, CC BY 3.0; it is entry 33
of opensfx.cat. A .cat container is a table of (offset, size) pairs, 32-bit little endian, bit 31 of the offset
set; each entry is a length byte and a name, then the file.
"""
import os
import struct
import sys
import tempfile

CONTAINER = '/usr/share/games/openttd/baseset/opensfx/opensfx.cat'
ENTRY = 33
OFFSET = 0x7fffffff


def entry(container, index):
    count = (struct.unpack_from('<I', container, 0)[0] & OFFSET) // 8
    if index >= count:
        raise ValueError(f'has {count} entries, expected more than {index}')
    offset, size = struct.unpack_from('<II', container, 8 * index)
    offset &= OFFSET
    start = offset + 1 + container[offset]
    if container[start:start + 4] != b'RIFF':
        raise ValueError(f'entry {index} is not a WAV file')
    return container[offset + 1:start - 1].decode('utf-8'), container[start:start + size]


def main():
    if len(sys.argv) != 2:
        sys.exit('usage: airhammer.py OUT.wav')
    try:
        with open(CONTAINER, 'rb') as file:
            credit, wav = entry(file.read(), ENTRY)
    except (OSError, ValueError, struct.error) as error:
        sys.exit(f'{CONTAINER}: {error}; install the package openttd-opensfx')
    folder = os.path.dirname(os.path.abspath(sys.argv[1]))
    with tempfile.NamedTemporaryFile(dir=folder, delete=False) as file:
        file.write(wav)
    os.chmod(file.name, 0o644)
    os.replace(file.name, sys.argv[1])
    print(credit)


main()
