"""The clicks of the patch as WAV files, which some read."""
import pathlib
import sys

from . import patch

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'cli'))
from sound_files import write_wav  # noqa: E402


def click_files(folder):
    files = [folder / f'click{i}.wav' for i in range(patch.CLICKS)]
    for file, click in zip(files, patch.clicks()):
        if not file.exists():
            write_wav(file, [click], patch.RATE)
    return files
