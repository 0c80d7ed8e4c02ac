"""Sound files for tests, written and read from the description of WAV and by nothing of rigsound."""
import array
import ctypes
import math
import pathlib
import random
import struct


def write_wav(path, channels, rate=48000):
    """32 bit float; `channels`: one list of samples each, all as long."""
    count = len(channels)
    data = struct.pack(f'<{count * len(channels[0])}f', *(x for frame in zip(*channels) for x in frame))
    chunks = [(b'fmt ', struct.pack('<HHIIHH', 3, count, rate, rate * 4 * count, 4 * count, 32)), (b'data', data)]
    body = b'WAVE' + b''.join(name + struct.pack('<I', len(text)) + text for name, text in chunks)
    pathlib.Path(path).write_bytes(b'RIFF' + struct.pack('<I', len(body)) + body)
    return pathlib.Path(path)


def read_wav(raw):
    """(channels, rate, samples in their order) of the bytes of a 32 bit float WAV whose sizes are right."""
    assert raw[:4] == b'RIFF' and raw[8:12] == b'WAVE'
    assert struct.unpack('<I', raw[4:8])[0] == len(raw) - 8, 'the header is of another size'
    at, form = 12, None
    while at + 8 <= len(raw):
        name, size = raw[at:at + 4], struct.unpack('<I', raw[at + 4:at + 8])[0]
        if name == b'fmt ':
            form = struct.unpack('<HHIIHH', raw[at + 8:at + 24])
        if name == b'data':
            assert form[0] == 3 and form[5] == 32 and at + 8 + size <= len(raw)
            return form[1], form[2], struct.unpack(f'<{size // 4}f', raw[at + 8:at + 8 + size])
        at += 8 + size + (size & 1)
    raise AssertionError('no data chunk')


def strikes(seconds, rate=48000, every_s=0.04):
    """Something that rings at each strike."""
    step = int(every_s * rate)
    return [0.4 * math.exp(-(n % step) / (0.004 * rate)) * math.sin(2 * math.pi * 1900 * (n % step) / rate)
            for n in range(int(seconds * rate))]


def drilling():
    """A second at 48 kHz: forty strikes."""
    return [0.8 * math.exp(-(n % 1200) / 190) * math.sin(0.25 * (n % 1200)) for n in range(48000)]


def diesel():
    """A second at 48 kHz: twelve cycles, at 1440 r/min."""
    return [0.8 * math.exp(-(n % 4000) / 400) * math.sin(0.02 * (n % 4000)) for n in range(48000)]


def write_long_wav(path, second, seconds):
    """Two channels of 16 bit at 48 kHz: the same second again and again, and noise that is mixed in when they are read."""
    size, draw = seconds * 48000 * 4, random.Random(1)
    frames = array.array('h', bytes(48000 * 4))
    frames[0::2] = array.array('h', [round(32767 * x) for x in second])
    with open(path, 'wb') as file:
        file.write(b'RIFF' + struct.pack('<I', 36 + size) + b'WAVEfmt ' + struct.pack('<IHHIIHH', 16, 1, 2, 48000, 48000 * 4, 4, 16) +
                   b'data' + struct.pack('<I', size))
        for _ in range(seconds):
            frames[1::2] = array.array('h', array.array('b', draw.randbytes(48000)))
            file.write(frames.tobytes())
    return pathlib.Path(path)


class Info(ctypes.Structure):
    _fields_ = [('frames', ctypes.c_int64), ('rate', ctypes.c_int), ('channels', ctypes.c_int), ('format', ctypes.c_int),
                ('sections', ctypes.c_int), ('seekable', ctypes.c_int)]


def read_sound(path):
    """(format, rate, samples in their order) of any file of libsndfile, by libsndfile itself."""
    library = ctypes.CDLL('libsndfile.so.1')
    library.sf_open.restype = ctypes.c_void_p
    library.sf_readf_float.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64]
    library.sf_close.argtypes = [ctypes.c_void_p]
    info = Info()
    sound = library.sf_open(str(path).encode(), 0x10, ctypes.byref(info))
    assert sound, path
    samples = (ctypes.c_float * (info.frames * info.channels))()
    library.sf_readf_float(sound, samples, info.frames)
    library.sf_close(sound)
    return info.format, info.rate, list(samples)
