"""Sounds of Debian packages: fetched into a folder with apt-get, unpacked there, never installed or copied elsewhere."""
import ctypes
import glob
import os
import struct
import subprocess
import tempfile

import numpy as np

PATTERNS = {  # package: files, kind, how many of them
    'alsa-utils': ('usr/share/sounds/alsa/*.wav', 'speech', 9),
    'chromium-bsu-data': ('usr/share/games/chromium-bsu/wav/*.wav', 'effects', 9),
    'frozen-bubble-data': ('usr/share/games/frozen-bubble/snd/*.ogg', 'effects', 21),
    'opencity-data': ('usr/share/games/opencity/sound/*', 'industry and traffic', 9),
    'pingus-data': ('usr/share/games/pingus/data/sounds/*', 'effects', 11),
    'sound-theme-freedesktop': ('usr/share/sounds/freedesktop/stereo/*.oga', 'signals', 35),
    'xmoto-data': ('usr/share/games/xmoto/Textures/Musics/*.ogg', 'music', 7),
    'bzflag-data': ('usr/share/games/bzflag/*.wav', 'effects', 15),
    'lincity-ng-data': ('usr/share/games/lincity-ng/sounds/*.wav', 'industry and traffic', 70),
    'lmms-common': ('usr/share/lmms/samples/beats/*.ogg', 'drum loops', 20),
    'scorched3d-data': ('usr/share/games/scorched3d/data/globalmods/*/data/wav/*/*.wav', 'effects', 40),
    'searchandrescue-data': ('usr/share/games/searchandrescue/sounds/*.wav', 'aircraft', 40),
    'torus-trooper-data': ('usr/share/games/torus-trooper/sounds/musics/*.ogg', 'music', 4),
    'tuxpaint-data': ('usr/share/tuxpaint/sounds/*.wav', 'effects', 20),
}
OPENTTD, AIR_HAMMER = 'openttd-opensfx', 33
LOWEST_RATE, SHORTEST_S = 16000, .45


class Info(ctypes.Structure):
    _fields_ = [('frames', ctypes.c_int64), ('rate', ctypes.c_int), ('channels', ctypes.c_int), ('format', ctypes.c_int),
                ('sections', ctypes.c_int), ('seekable', ctypes.c_int)]


def read(path, seconds=30):
    """Rate and one channel, or None."""
    library = ctypes.CDLL('libsndfile.so.1')
    library.sf_open.restype = ctypes.c_void_p
    library.sf_readf_float.argtypes, library.sf_readf_float.restype = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64], ctypes.c_int64
    library.sf_close.argtypes = [ctypes.c_void_p]
    info = Info()
    sound = library.sf_open(path.encode(), 0x10, ctypes.byref(info))
    if not sound:
        return None
    frames = min(info.frames, seconds * info.rate)
    samples = np.zeros(frames * info.channels, np.float32)
    got = library.sf_readf_float(sound, samples.ctypes.data, frames)
    library.sf_close(sound)
    mono = samples[:got * info.channels].reshape(-1, info.channels).mean(1)
    return (info.rate, mono) if info.rate >= LOWEST_RATE and len(mono) >= SHORTEST_S * info.rate else None


def unpacked(where, package):
    folder = os.path.join(where, package)
    if not os.path.isdir(folder):
        os.makedirs(where, exist_ok=True)
        subprocess.run(['apt-get', 'download', package], cwd=where, check=True, capture_output=True)
        subprocess.run(['dpkg', '-x', glob.glob(os.path.join(where, package + '_*.deb'))[0], folder], check=True)
    return folder


def openttd(folder):
    """The sounds of a catalogue: offset and length of each entry, a name before each WAV."""
    with open(glob.glob(os.path.join(folder, '**', 'opensfx.cat'), recursive=True)[0], 'rb') as file:
        catalogue = file.read()
    for entry in range((struct.unpack('<I', catalogue[:4])[0] & 0x7fffffff) // 8):
        at = struct.unpack('<I', catalogue[8 * entry:8 * entry + 4])[0] & 0x7fffffff
        start = catalogue.find(b'RIFF', at, at + 600)
        if start < 0:
            continue
        with tempfile.NamedTemporaryFile(suffix='.wav') as file:
            file.write(catalogue[start:start + 8 + struct.unpack('<I', catalogue[start + 4:start + 8])[0]])
            file.flush()
            sound = read(file.name)
        if sound:
            yield ('air hammer' if entry == AIR_HAMMER else 'towns and machines', 'opensfx %d' % entry, entry == AIR_HAMMER, *sound)


def sounds(where):
    """Kind, source, whether it drills, rate, samples. What a package holds twice comes once."""
    yield from openttd(unpacked(where, OPENTTD))
    heard = set()
    for package, (pattern, kind, most) in PATTERNS.items():
        for path in sorted(glob.glob(os.path.join(unpacked(where, package), pattern)))[:most]:
            sound = read(path)
            if sound and sound[1].tobytes() not in heard:
                heard.add(sound[1].tobytes())
                yield (kind, '%s %s' % (package, os.path.basename(path).replace('__', '_')), False, *sound)
