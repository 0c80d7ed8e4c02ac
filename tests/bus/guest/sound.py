"""The other side of the loopback card, and its clock."""
import array
import subprocess
import time

from running import wait_for

PLAYBACK, CAPTURE = 'hw:Loopback,0', 'hw:Loopback,1'
FORMATS = {'float': 'FLOAT_LE', 's32': 'S32_LE', 's16': 'S16_LE'}


class PeriodClock:
    """Lets the loopback tick every `period` frames, as a real card does."""

    def __init__(self, program, period):
        self.process = subprocess.Popen([program, str(period)], stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline().strip() == 'running'
        self.select('hw:Dummy,0')

    @staticmethod
    def select(source):
        with open('/proc/asound/Loopback/timer_source', 'w') as timer:
            timer.write(source)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.select('')
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()


class Recording:
    def __init__(self, path, form, period, device=CAPTURE):
        self.path, self.complaint = path, None
        self.process = subprocess.Popen(
            ['arecord', '-q', '-D', device, '-f', FORMATS[form], '-c', '2', '-r', '48000', '-t', 'raw',
             f'--period-size={period}', f'--buffer-size={64 * period}', path], stderr=subprocess.PIPE, text=True)
        wait_for('arecord to run', lambda: self.state() == 'RUNNING')

    @staticmethod
    def state():
        with open('/proc/asound/Loopback/pcm1c/sub0/status') as status:
            text = status.read()
        return text.split('state: ')[1].split()[0] if 'state: ' in text else 'closed'

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        """Returns what arecord complained of."""
        if self.complaint is None:
            self.process.terminate()
            lines = self.process.communicate()[1].splitlines()
            self.complaint = '\n'.join(line for line in lines if 'Aborted by signal' not in line)
        return self.complaint


def peak_of(path, seconds):
    """Highest magnitude in the last `seconds` of a float recording, or in all of it."""
    with open(path, 'rb') as raw:
        data = raw.read()
    wanted = int(seconds * 48000) * 8
    end = len(data) // 8 * 8
    samples = array.array('f', data[max(0, end - wanted):end])
    return max(map(abs, samples), default=0.0)


