"""What the analysis measures in a clip: the figures that speak against drilling, one row a window."""
import csv
import glob
import os
import shutil
import subprocess
import tempfile

FEWEST_DRILLING = 6  # kFewestDrillingClicks of clicks/drilling_test
FEATURES = ('rate', 'swell', 'surplus', 'pulses', 'dispersion', 'rise', 'rhythm', 'irregularity', 'unexplained', 'repetition')


def features_of(binary, path):
    """No row where fewer clicks are found than drill: such a window is no drilling whatever the model."""
    folder = tempfile.mkdtemp(prefix='verdict-')
    try:
        subprocess.run([binary, 'clicks', path, '--jobs', '1', '--dump', os.path.join(folder, 'dump')], check=True,
                       capture_output=True)
        rows = []
        for table in glob.glob(os.path.join(folder, 'dump', '**', 'pass2_evidence.csv'), recursive=True):
            with open(table) as file:
                rows += [[float(row[name]) for name in FEATURES] for row in csv.DictReader(file) if float(row['clicks']) >= FEWEST_DRILLING]
        return rows
    finally:
        shutil.rmtree(folder, ignore_errors=True)
