"""Where things are, told by the host."""
import pathlib
import sys


class Place:
    def __init__(self, project, build, work):
        self.project, self.work = project, pathlib.Path(work)
        self.sounds = f'{work}/sounds'
        self.log = f'{project}/config/logs/shift.log'
        self.rigsoundd = f'{build}/tools/rigsoundd'
        self.rigsound = f'{build}/tools/rigsound'
        self.period_clock = f'{build}/tests/bus/period_clock'
        self.frame_to_sound = f'{build}/tests/bus/frame_to_sound'
        self.plc = f'{build}/tests/bus/plc'


PLACE = Place(*sys.argv[1:4])
