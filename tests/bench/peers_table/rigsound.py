"""rigsound: a sound set of one bank, a rig, and states that drill all the time."""
import json
import pathlib
import subprocess
import sys

from . import patch

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'cli'))
from sound_set import SITUATIONS, write_clicks  # noqa: E402

BAR = 'bar'


def write_bank(folder):
    gap = patch.RATE / patch.BLOWS_HZ
    numbers = dict(format=1, sample_rate=patch.RATE, T0=gap, sigma_T=patch.GAP_SPREAD * gap, r_T=0., p_miss=0., p_double=0., B=patch.LEVEL,
                   sigma_B=patch.LEVEL_SPREAD * patch.LEVEL, r_B=0., N_a=2, alpha_a=0., alpha_d=1 / (patch.DECAY_S * patch.RATE),
                   gain_db=0., source_file='none', source_sha256='', settings='', tool_version='peers')
    folder.mkdir(parents=True)
    (folder / 'bank.json').write_text(json.dumps(numbers))
    write_clicks(folder / 'clicks.wav', patch.clicks(), patch.RATE)


def write_rig(program, folder):
    """The sound set and two rigs: one with a bar, one without."""
    sounds = folder / 'set'
    write_bank(sounds / 'banks/clicks')
    (sounds / 'soundset.toml').write_text('format = 1\n' + ''.join(
        f'[[bank]]\nname = "clicks"\nsituation = "{situation}"\n' for situation in SITUATIONS))
    subprocess.run([program, 'tool', '--length', '0.5', '--diameter', '0.025', '--name', BAR, '--out', sounds], check=True,
                   stdout=subprocess.DEVNULL)
    text = f'[audio]\nrate = {patch.RATE}\nblock = {patch.BLOCK}\n[sound]\nset = "set"\n'
    rigs = {False: folder / 'clicks.toml', True: folder / 'bar.toml'}
    rigs[False].write_text(text)
    rigs[True].write_text(text + f'[[boom]]\ntool = "{BAR}"\n')
    states = folder / 'states.csv'
    states.write_text(f'time_s,signal,value\n0,feed_pressure_bar,90\n{patch.SECONDS - 1e-3},feed_pressure_bar,90\n')
    return rigs, states
