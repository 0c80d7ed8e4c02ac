"""Bit for bit through the card, no xruns, and how fast a frame is heard."""
import os
import shutil
import signal
import statistics
import subprocess
import time
import unittest

from frames import EEC1, Bus, engine_speed
from place import PLACE
from rigs import write_rig
from running import Daemon, sessions_in, wait_for
from sound import CAPTURE, PLAYBACK, PeriodClock, Recording

LOOKAHEAD_MS = 2  # of [mix], where a rig says nothing


def part_of_log(seconds):
    """The bundled log from second 0 on; `seconds` of it."""
    path = '/tmp/part.log'
    first = None
    with open(PLACE.log) as whole, open(path, 'w') as out:
        for line in whole:
            time = float(line[1:line.index(')')])
            first = time if first is None else first
            if time - first <= seconds:
                out.write(line)
    return path


class Sound(unittest.TestCase):
    def play_log(self, log, block, form):
        """canplayer -> vcan0 -> daemon -> loopback -> arecord; capture and session are left for the host."""
        name = f'log_{block}_{form}'
        rig = write_rig(f'{PLACE.work}/{name}.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, block=block, periods=3,
                        form=form, can=['vcan0'])
        sessions = f'/tmp/{name}'
        with PeriodClock(PLACE.period_clock, block), Recording(f'/tmp/{name}.raw', form, block) as recording:
            with Daemon(PLACE.rigsoundd, rig, '--session', sessions) as daemon:
                daemon.wait_playing()
                subprocess.run(['canplayer', '-I', log, 'vcan0=can0'], check=True)
                status = daemon.status()
                self.assertEqual(daemon.terminate(), 0)
            self.assertEqual(recording.stop(), '')
        shutil.move(f'/tmp/{name}.raw', PLACE.work)
        shutil.move(sessions_in(sessions)[-1], f'{PLACE.work}/{name}.rigsession')
        audio = status['audio']
        seconds = audio['blocks'] * block / 48000
        print(f'FIGURE block {block} {form}: {audio["xruns"]} xruns and {audio["deadline_misses"]} deadline misses in '
              f'{seconds:.1f} s, load {100 * audio["load"]:.1f} % of the emulated processor', flush=True)
        self.assertIn('SCHED_FIFO', audio['scheduling'])
        self.assertEqual((audio['xruns'], audio['losses'], status['session']['problem']), (0, 0, ''))
        sent = sum(1 for _ in open(log))
        seen = status['buses'][0]
        self.assertEqual(seen['frames_dropped'], 0)
        self.assertEqual(seen['frames_used'], seen['frames_seen'])
        self.assertLess(seen['frames_seen'], sent)  # the kernel's filter keeps ET1 and the like away

    def test_the_whole_log_at_64(self):
        self.play_log(PLACE.log, 64, 'float')

    def test_half_a_minute_at_128(self):
        self.play_log(part_of_log(30), 128, 's32')

    def test_half_a_minute_at_256(self):
        self.play_log(part_of_log(30), 256, 's16')

    def test_the_other_pairs_of_period_and_format(self):
        for block, form in ((64, 's16'), (64, 's32'), (128, 's16'), (128, 'float'), (256, 's32'), (256, 'float')):
            with self.subTest(block=block, form=form):
                self.play_log(part_of_log(4), block, form)

    def test_a_stopped_process_costs_silence_but_no_sample(self):
        """A real xrun: the daemon may not run for a while. State, block clock and every sample survive it."""
        rig = write_rig(f'{PLACE.work}/gaps_128_float.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, block=128,
                        form='float', can=['vcan0'], safety='stale_after_ms = 0')
        sessions = '/tmp/gaps_128_float'
        with PeriodClock(PLACE.period_clock, 128), Recording('/tmp/gaps_128_float.raw', 'float', 128) as recording:
            with Daemon(PLACE.rigsoundd, rig, '--session', sessions) as daemon:
                daemon.wait_playing()
                bus = Bus('vcan0')
                for rpm in (900, 1500, 2100):
                    bus.send(EEC1, engine_speed(rpm))
                    daemon.wait_signal('engine_rpm', rpm)
                    xruns, blocks = (daemon.status()['audio'][key] for key in ('xruns', 'blocks'))
                    daemon.process.send_signal(signal.SIGSTOP)
                    time.sleep(0.1)
                    daemon.process.send_signal(signal.SIGCONT)
                    wait_for('blocks again', lambda: daemon.status()['audio']['blocks'] > blocks + 100)
                    audio = daemon.status()['audio']
                    self.assertEqual((audio['xruns'], audio['losses']), (xruns + 1, 0))
                    self.assertEqual(daemon.signal('engine_rpm')['value'], rpm)
                bus.close()
                self.assertEqual(daemon.terminate(), 0)
            self.assertEqual(recording.stop(), '')
        shutil.move('/tmp/gaps_128_float.raw', PLACE.work)
        shutil.move(sessions_in(sessions)[-1], f'{PLACE.work}/gaps_128_float.rigsession')

    def check_latency(self, kind, where, **buses):
        block, periods = 64, 3
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, block=block, periods=periods,
                        form='float', safety='stale_after_ms = 0', **buses)
        with PeriodClock(PLACE.period_clock, block), Daemon(PLACE.rigsoundd, rig) as daemon:
            daemon.wait_playing()
            words = [PLACE.frame_to_sound, CAPTURE, where, str(block), '10']
            told = subprocess.run(words, check=True, capture_output=True, text=True).stdout
        latencies = [float(line.split()[1]) for line in told.splitlines()]
        limit = 1e3 * block * (1 + periods) / 48000 + LOOKAHEAD_MS
        print(f'FIGURE {kind} to sound: mean {statistics.mean(latencies):.2f} ms, worst {max(latencies):.2f} ms, '
              f'one block, the buffer and the look-ahead are {limit:.2f} ms', flush=True)
        self.assertEqual(len(latencies), 10)
        self.assertLessEqual(max(latencies), limit)

    def test_a_frame_is_heard_within_a_block_the_buffer_and_the_look_ahead(self):
        self.check_latency('frame', 'vcan0', can=['vcan0'])

    def test_a_datagram_is_heard_within_a_block_the_buffer_and_the_look_ahead(self):
        self.check_latency('datagram', '127.0.0.1:1503', udp=['address = "127.0.0.1:1503"'])

    def test_the_listener_may_stop_and_come_back(self):
        rig = write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, block=256, form='float',
                        can=['vcan0'])
        with PeriodClock(PLACE.period_clock, 256), Daemon(PLACE.rigsoundd, rig) as daemon:
            daemon.wait_playing()
            for _ in range(3):
                with Recording('/tmp/listener.raw', 'float', 256):
                    blocks = daemon.status()['audio']['blocks']
                    while daemon.status()['audio']['blocks'] < blocks + 100:
                        pass
                self.assertGreater(os.path.getsize('/tmp/listener.raw'), 0)
            audio = daemon.status()['audio']
            self.assertEqual((audio['xruns'], audio['losses']), (0, 0))
