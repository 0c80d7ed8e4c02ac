"""suite.py PROJECT BUILD WORK [TEST...]: everything that needs a real bus or a real card. Runs in the guest.

Without TEST all but `soak_tests`, which takes too long for every day.
"""
import sys
import unittest

from place import PLACE
from read_ahead import read_ahead

MODULES = ['sound_tests', 'can_tests', 'modbus_tests', 'field_tests', 'log_tests', 'life_tests']

if __name__ == '__main__':
    read_ahead(PLACE.programs(), [PLACE.sounds, f'{PLACE.project}/config'])
    chosen = sys.argv[4:] or MODULES
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(
        unittest.defaultTestLoader.loadTestsFromNames(chosen))
    sys.exit(0 if result.wasSuccessful() else 1)
