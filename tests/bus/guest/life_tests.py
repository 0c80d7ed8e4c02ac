"""Start, reload and end; cards that come and go; sessions under kill -9 and on a full disk."""
import json
import os
import shutil
import signal
import socket
import subprocess
import time
import unittest

from frames import EEC1, Bus, engine_speed
from place import PLACE
from rigs import write_rig
from running import PATIENCE_S, Daemon, sessions_in, wait_for
from sound import PLAYBACK, PeriodClock, Recording, peak_of

DRIVERS = '/sys/bus/platform/drivers'


def rig(**options):
    return write_rig('/tmp/rig.toml', PLACE.project, PLACE.sounds, can=['vcan0'],
                     **{'safety': 'stale_after_ms = 0', 'form': 'float', 'block': 256, **options})


def run_diesel():
    bus = Bus('vcan0')
    bus.send(EEC1, engine_speed(1500))
    bus.close()


def change_speed(bus):
    """A hundred changes, each in a block of its own, or nearly so."""
    for rpm in range(600, 2600, 20):
        bus.send(EEC1, engine_speed(rpm))
        time.sleep(0.006)


def driver(action, name='snd_aloop'):
    """unbind takes the card out, bind puts it back."""
    with open(f'{DRIVERS}/{name}/{action}', 'w') as file:
        file.write(f'{name}.0')


class Life(unittest.TestCase):
    def test_sigterm_fades_out_and_ends_with_0(self):
        with PeriodClock(PLACE.period_clock, 256), Recording('/tmp/fade.raw', 'float', 256):
            with Daemon(PLACE.rigsoundd, rig(device=PLAYBACK)) as daemon:
                daemon.wait_playing()
                run_diesel()
                wait_for('sound', lambda: daemon.status()['meters']['peak_db'] > -50)
                self.assertEqual(daemon.terminate(), 0)
        with open('/tmp/fade.raw', 'rb') as raw:
            data = raw.read().rstrip(b'\0')
        loud = peak_of('/tmp/fade.raw', 5)
        with open('/tmp/tail.raw', 'wb') as tail:
            tail.write(data[:len(data) // 8 * 8])
        self.assertGreater(loud, 1e-3)
        self.assertLess(peak_of('/tmp/tail.raw', 0.01), loud * 1e-3)  # the last that is not silence is nearly so

    def test_systemd_hears_of_start_state_and_life(self):
        path = '/tmp/notify'
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as listener:
            listener.bind(path)
            listener.settimeout(PATIENCE_S)
            told = ''
            with Daemon(PLACE.rigsoundd, rig(device='hw:CARD=Missing'),
                        env={'NOTIFY_SOCKET': path, 'WATCHDOG_USEC': '200000'}) as daemon:
                while not all(word in told for word in ('READY=1', 'STATUS=no sound', 'WATCHDOG=1')):
                    told += listener.recv(4096).decode() + '\n'
                self.assertEqual(daemon.terminate(), 0)
                while 'STOPPING=1' not in told:
                    told += listener.recv(4096).decode() + '\n'
        os.unlink(path)

    def test_a_reload_takes_all_or_nothing(self):
        path = rig()
        with Daemon(PLACE.rigsoundd, path) as daemon:
            wait_for('vcan0', lambda: daemon.bus('can vcan0')['up'])
            run_diesel()
            daemon.wait_signal('engine_rpm', 1500)
            rig(device='hw:Loopback,0', modbus=['role = "server"\naddress = "127.0.0.1:1502"\n[modbus.signals]\n'
                                                'rock = { table = "holding", address = 0, type = "uint16" }'])
            answer = daemon.ask('reload')
            self.assertTrue(answer['ok'])
            self.assertEqual(answer['not_applied'], ['audio.device: null, wanted hw:Loopback,0'])
            wait_for('the new bus', lambda: daemon.bus('modbus 127.0.0.1:1502')['up'])
            daemon.wait_signal('engine_rpm', 1500)  # what was known stays known
            with open(path, 'a') as broken:
                broken.write('\n[mix]\ndril_db = 0\n')
            answer = daemon.ask('reload')
            self.assertFalse(answer['ok'])
            self.assertIn('dril_db', answer['error'])
            os.kill(daemon.process.pid, signal.SIGHUP)
            wait_for('SIGHUP', lambda: daemon.status()['failed_reloads'] == 2)
            status = daemon.status()
            self.assertEqual((status['reloads'], len(status['buses'])), (1, 2))

    def test_ctl_commands(self):
        with Daemon(PLACE.rigsoundd, rig()) as daemon:
            def ctl(*words):
                return subprocess.run([PLACE.rigsound, 'ctl', '--socket', daemon.socket_path, *words],
                                      capture_output=True, text=True)
            self.assertEqual(ctl('set', 'mean_frequency_hz', '42').returncode, 0)
            self.assertEqual(ctl('set', 'decay_factor', '99').returncode, 1)
            self.assertEqual(ctl('mute', 'on').stdout, 'muted\n')
            status = json.loads(ctl('status', '--json').stdout)
            self.assertEqual((status['booms'][0]['mean_frequency_hz'], status['muted']), (42, True))
            self.assertIn('MUTED', ctl('status').stdout)
            metrics = ctl('metrics').stdout
            self.assertTrue(metrics.endswith('# EOF\n'))
            self.assertIn('rigsound_blocks_total', metrics)
            self.assertEqual(ctl('reload').stdout, 'reloaded\n')
            with subprocess.Popen([PLACE.rigsound, 'ctl', '--socket', daemon.socket_path, 'watch', '--every', '0.05'],
                                  stdout=subprocess.PIPE, text=True) as watch:
                views = ''
                while views.count('rigsoundd ') < 3:
                    views += watch.stdout.readline()
                watch.kill()
            self.assertIn('peak', views)
        self.assertEqual(subprocess.run([PLACE.rigsound, 'ctl', '--socket', '/tmp/none', 'status'],
                                        capture_output=True).returncode, 3)


class Card(unittest.TestCase):
    def test_no_card_and_no_bus_at_the_start_both_picked_up(self):
        subprocess.run(['ip', 'link', 'del', 'vcan0'], check=True)
        driver('unbind')
        with Daemon(PLACE.rigsoundd, rig(device=PLAYBACK)) as daemon:
            wait_for('blocks without a card', lambda: daemon.status()['audio']['blocks'] > 100)
            self.assertFalse(daemon.status()['audio']['playing'])
            self.assertIn('does not exist', daemon.bus('can vcan0')['problem'])
            driver('bind')
            subprocess.run(['ip', 'link', 'add', 'vcan0', 'type', 'vcan'], check=True)
            subprocess.run(['ip', 'link', 'set', 'vcan0', 'up'], check=True)
            daemon.wait_playing()
            wait_for('vcan0', lambda: daemon.bus('can vcan0')['up'])
            run_diesel()
            daemon.wait_signal('engine_rpm', 1500)

    def test_the_default_device(self):
        with Daemon(PLACE.rigsoundd, rig(device='default', form='auto')) as daemon:
            daemon.wait_playing()
            self.assertIn('sound card default: 2 channels, 48000 Hz', daemon.status()['audio']['card'])
            blocks = daemon.status()['audio']['blocks']
            wait_for('two seconds', lambda: daemon.status()['audio']['blocks'] > blocks + 2 * 48000 / 256)
            audio = daemon.status()['audio']
            print(f'FIGURE default: {audio["card"]}, {audio["xruns"]} xruns', flush=True)
            self.assertEqual((audio['xruns'], audio['losses']), (0, 0))

    def test_a_device_that_cannot_do_it_says_what_it_can(self):
        with Daemon(PLACE.rigsoundd, rig(device='hw:Dummy,0', form='float')) as daemon:
            wait_for('blocks without a card', lambda: daemon.status()['audio']['blocks'] > 5)
            card = daemon.status()['audio']['card']
            self.assertIn('it can do', card)
            print(f'FIGURE refused: {card}', flush=True)

    def test_a_card_pulled_out_and_put_back(self):
        with Daemon(PLACE.rigsoundd, rig(device=PLAYBACK)) as daemon:
            daemon.wait_playing()
            driver('unbind')
            wait_for('the loss', lambda: daemon.status()['audio']['losses'] >= 1)
            blocks = daemon.status()['audio']['blocks']
            wait_for('blocks without a card', lambda: daemon.status()['audio']['blocks'] > blocks + 100)
            driver('bind')
            daemon.wait_playing()

    def test_a_card_that_another_program_holds(self):
        holder = subprocess.Popen(['aplay', '-q', '-D', PLAYBACK, '-f', 'FLOAT_LE', '-c', '2', '-r', '48000', '/dev/zero'],
                                  stderr=subprocess.DEVNULL)
        wait_for('aplay', lambda: 'RUNNING' in open('/proc/asound/Loopback/pcm0p/sub0/status').read())
        with Daemon(PLACE.rigsoundd, rig(device=PLAYBACK + ',0')) as daemon:
            self.assertIn('busy', daemon.status()['audio']['card'])
            holder.kill()
            holder.wait()
            daemon.wait_playing()


class Sessions(unittest.TestCase):
    def test_kill_9_loses_a_second_at_most(self):
        path = write_rig(f'{PLACE.work}/killed.toml', PLACE.project, PLACE.sounds, device=PLAYBACK, block=256, form='float',
                         can=['vcan0'], safety='stale_after_ms = 0')
        with PeriodClock(PLACE.period_clock, 256), Recording('/tmp/killed.raw', 'float', 256) as recording:
            with Daemon(PLACE.rigsoundd, path, '--session', '/tmp/killed') as daemon:
                daemon.wait_playing()
                run_diesel()
                blocks = daemon.status()['audio']['blocks']
                wait_for('two seconds', lambda: daemon.status()['audio']['blocks'] > blocks + 2 * 48000 / 256)
                daemon.process.kill()
                daemon.process.wait()
            recording.stop()
        shutil.move('/tmp/killed.raw', PLACE.work)
        shutil.move(sessions_in('/tmp/killed')[-1], f'{PLACE.work}/killed.rigsession')

    def test_a_card_of_another_format_begins_the_next(self):
        """The session must hold what the card got, also when the card came later and is no float card."""
        driver('unbind', 'snd_dummy')
        path = rig(device='hw:Dummy,0', form='auto')
        with Daemon(PLACE.rigsoundd, path, '--session', '/tmp/late') as daemon:
            wait_for('vcan0', lambda: daemon.bus('can vcan0')['up'])
            run_diesel()  # a session that tells nothing would not stay
            daemon.wait_signal('engine_rpm', 1500)
            driver('bind', 'snd_dummy')
            daemon.wait_playing()
            wait_for('the next session', lambda: len(sessions_in('/tmp/late')) == 2)
            wait_for('its end of the first', lambda: daemon.status()['session']['recording'])
            self.assertEqual(daemon.terminate(), 0)
        for file, form in zip(sessions_in('/tmp/late'), (b'format auto\n', b'format S16\n')):
            with open(file, 'rb') as session:
                self.assertIn(form, session.read())

    def test_a_full_disk_stops_the_recording_and_nothing_else(self):
        os.makedirs('/tmp/small', exist_ok=True)
        subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=4k', 'tmpfs', '/tmp/small'], check=True)
        try:
            with Daemon(PLACE.rigsoundd, rig(), '--session', '/tmp/small/sessions') as daemon:
                wait_for('vcan0', lambda: daemon.bus('can vcan0')['up'])
                bus = Bus('vcan0')
                def full():
                    change_speed(bus)
                    return daemon.status()['session']['problem']
                self.assertIn('No space left', wait_for('the disk to be full', full))
                bus.close()
                blocks = daemon.status()['audio']['blocks']
                wait_for('more blocks', lambda: daemon.status()['audio']['blocks'] > blocks + 100)
                self.assertEqual(daemon.terminate(), 0)
        finally:
            subprocess.run(['umount', '/tmp/small'], check=True)

    def test_a_session_at_its_limit_begins_the_next_and_the_oldest_goes(self):
        with Daemon(PLACE.rigsoundd, rig(), '--session', '/tmp/short', '--session-limit', '0.02') as daemon:
            wait_for('vcan0', lambda: daemon.bus('can vcan0')['up'])
            bus = Bus('vcan0')
            first = wait_for('a session', lambda: daemon.status()['session']['file'])
            def turned():
                change_speed(bus)
                return not os.path.exists(first)
            wait_for('the first to go', turned)
            bus.close()
            self.assertEqual(daemon.terminate(), 0)
        self.assertGreater(len(sessions_in('/tmp/short')), 1)
        self.assertLess(sum(map(os.path.getsize, sessions_in('/tmp/short'))), 25000)
