"""Whole programs on the same patch: ten clicks, and clicks with a bar."""
from . import csound, fluidsynth, patch, rigsound, scsynth
from .race import Contestant, race, said_seconds, whole_process
from .sound_check import level_db
from .table import Row

ALIKE_DB = 1     # levels of the clicks
WHOLE, ALONE, WITH_BAR = '>= 2 times', '>= 3 times', '>= 3 times'


def _contestants(programs, folder):
    """Those of the clicks, those of the clicks with a bar; of each ours first. And the files they write."""
    rigs, states = rigsound.write_rig(programs.rigsound, folder)
    outs = {}

    def process(name, key, command_of):
        outs[key] = folder / f'{key}.wav'
        return Contestant(name, whole_process(command_of(outs[key]), outs[key]))

    def render(key, with_bar):
        return process('rigsound render', key, lambda out: [programs.rigsound, 'render', rigs[with_bar], '--states', states, '--out', out, '--no-hash'])

    alone = Contestant('Engine::process', said_seconds([programs.patch_cost, rigs[False], states]))
    clicks = [render('rigsound', False), alone,
              process('scsynth', 'scsynth', lambda out: scsynth.command(folder, out, False)),
              process('Csound', 'csound', lambda out: csound.command(folder, out, False)),
              process('FluidSynth', 'fluidsynth', lambda out: fluidsynth.command(folder, out))]
    bar = [render('rigsound_bar', True),
           process('scsynth, 12 Ringz (DynKlank)', 'scsynth_bar', lambda out: scsynth.command(folder, out, True)),
           process('Csound, 12 mode', 'csound_bar', lambda out: csound.command(folder, out, True))]
    return clicks, bar, outs


def _require_alike(outs):
    levels = {key: level_db(out) for key, out in outs.items()}
    clicks = {key: level for key, level in levels.items() if not key.endswith('_bar')}
    if max(clicks.values()) - min(clicks.values()) > ALIKE_DB or min(levels.values()) < min(clicks.values()) - ALIKE_DB:
        raise SystemExit(f'they do not play the same: RMS in dB {levels}')


def _row(what, ours, theirs, reach):
    return Row(f'{what}, against {theirs.name}', reach, theirs.best_s / ours.best_s, f'{theirs.best_s:.3f} s / {ours.best_s:.3f} s')


def rows(programs, folder, rounds, shown):
    clicks, bar, outs = _contestants(programs, folder)
    race(clicks + bar, rounds, shown)
    _require_alike(outs)
    ours, alone, *others = clicks
    seconds = f'{patch.SECONDS} s'
    for other in others:
        yield _row(f'ten clicks, {seconds}, whole process', ours, other, WHOLE)
    for other in others:
        yield _row(f'ten clicks, {seconds}, engine alone', alone, other, ALONE)
    for other in bar[1:]:
        yield _row(f'clicks and bar, {seconds}, whole process', bar[0], other, WITH_BAR)
