"""Where things are, told by the host."""
import pathlib
import shutil
import sys


def here(program):
    """A copy in the guest's own memory: a page fetched from the host takes time that no test may depend on."""
    pathlib.Path('/tmp/bin').mkdir(exist_ok=True)
    return shutil.copy(program, '/tmp/bin')


class Place:
    def __init__(self, project, build, work):
        self.project, self.work = project, pathlib.Path(work)
        self.sounds = f'{work}/sounds'
        self.log = f'{project}/config/logs/shift.log'
        self.rigsoundd = here(f'{build}/tools/rigsoundd')
        self.rigsound = here(f'{build}/tools/rigsound')
        self.period_clock = here(f'{build}/tests/bus/period_clock')
        self.frame_to_sound = here(f'{build}/tests/bus/frame_to_sound')
        self.plc = here(f'{build}/tests/bus/plc')

    def programs(self):
        return [self.rigsoundd, self.rigsound, self.period_clock, self.frame_to_sound, self.plc]


PLACE = Place(*sys.argv[1:4])
