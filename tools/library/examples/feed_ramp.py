#!/usr/bin/env python3
"""feed_ramp.py RIG.toml OUT.f32: ten seconds of drilling while the feed rises from 40 to 190 bar, as raw float samples.

Play them: aplay -t raw -f FLOAT_LE -c 2 -r 48000 OUT.f32. Nothing but Python and librigsound is needed.
"""
import ctypes
import sys

library = ctypes.CDLL('librigsound.so.1')
library.rigsound_open.restype = ctypes.c_void_p
library.rigsound_open.argtypes = [ctypes.c_char_p]
library.rigsound_last_error.restype = ctypes.c_char_p
library.rigsound_last_error.argtypes = [ctypes.c_void_p]
library.rigsound_rate.restype = ctypes.c_double
for name in ('rate', 'block', 'channels', 'close'):
    getattr(library, 'rigsound_' + name).argtypes = [ctypes.c_void_p]
library.rigsound_set.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_double]
library.rigsound_process.argtypes = [ctypes.c_void_p, ctypes.POINTER(ctypes.c_float)]


def main():
    if len(sys.argv) != 3:
        sys.exit('usage: feed_ramp.py RIG.toml OUT.f32')
    rig = library.rigsound_open(sys.argv[1].encode())
    if not rig:
        sys.exit(library.rigsound_last_error(None).decode())

    def put(signal, value):
        if library.rigsound_set(rig, signal, 0, value) != 0:
            sys.exit(library.rigsound_last_error(rig).decode())

    rate, frames = library.rigsound_rate(rig), library.rigsound_block(rig)
    block = (ctypes.c_float * (frames * library.rigsound_channels(rig)))()
    put(b'engine_rpm', 1500)
    with open(sys.argv[2], 'wb') as out:
        for number in range(int(10 * rate / frames)):
            put(b'feed_pressure_bar', 40 + int(15 * (number * frames / rate)))   # one bar a step
            library.rigsound_process(rig, block)
            out.write(block)
    library.rigsound_close(rig)


main()
