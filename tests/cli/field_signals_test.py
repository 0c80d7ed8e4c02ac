#!/usr/bin/env python3
"""field_signals_test.py RIGSOUND ROOT: signal maps as they exist in the field, and the devices they name."""
import socket
import struct
import sys
import threading
import unittest

from field_case import CASES, FieldCase, decode, run
from sound_set import write_sound_set


class Nearest(FieldCase):
    """A log of which nothing can be used is a failure that names the nearest thing."""

    def test_a_parameter_group_from_elsewhere(self):
        self.refused(decode('nov.toml', 'j1939-no-vframeformat.log'),
                     'none of its 2 frames is of use to the rig: PGN 61444 came from 00, the DBC says FE: j1939 = true?')

    def test_other_identifiers_and_interfaces(self):
        log = self.write('a.log', '(1.000000) can0 123#00\n(1.000000) can0 18FF1000#00\n')
        self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'it holds 123, 18FF1000, the rig wants EEC1 = 0CF004FE')
        log = self.write('a.log', '(1.000000) can0 123#00\n(1.000000) can1 0CF00400#F07D85401FFFFF85\n')
        self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'EEC1 came on can1', '--can can1=can0?')
        self.speeds(run('decode', CASES / 'eec1.toml', '--log', log, '--can', 'can1=can0'), (0, 1000))

    def test_fd_frames_on_a_classic_bus(self):
        self.refused(decode('eec1.toml', 'fd64.log'), 'CAN FD frames: fd = true?')
        rig = self.write('rig.toml', (CASES / 'eec1.toml').read_text().replace('dbc/', f'{CASES}/dbc/').replace('interface', 'fd = true\ninterface'))
        self.speeds(run('decode', rig, '--log', CASES / 'fd64.log'), (0, 1000))

    def test_values_that_are_none(self):
        log = self.write('a.log', '(1.000000) can0 0CF00400#FFFFFFFFFFFFFFFF\n')
        self.refused(run('decode', CASES / 'eec1.toml', '--log', log), 'EEC1.EngSpeed has no value: not_available')

    def test_units_addresses_and_servers_of_a_capture(self):
        self.refused(decode('mb_unit7.toml', 'modbus-eth.pcap'), '10.0.0.1:502 unit 1: holding 0 = 40001', 'unit 7')
        self.refused(decode('mb_40001.toml', 'modbus-eth.pcap'), '10.0.0.1:502 unit 1: holding 0 = 40001')


class Signals(FieldCase):
    def test_an_error_indicator_does_not_hammer(self):
        rows = self.good(decode('perc.toml', 'percussion-error-10b.log'), 'percussion: 41 values refused, last error_value')
        self.assertEqual([(s, v) for _, s, v in rows if s == 'percussion'], [('percussion', 'off')])
        rows = self.good(decode('perc.toml', 'percussion-not-available-11b.log'), 'percussion: 41 values refused, last not_available')
        self.assertEqual([(s, v) for _, s, v in rows if s == 'percussion'], [('percussion', 'off')])
        rows = self.good(decode('perc.toml', 'percussion-on.log'))
        self.assertEqual([v for _, s, v in rows if s == 'percussion'], ['off', 'on', 'off'])

    def test_codes_of_short_and_odd_fields(self):
        rows = self.good(decode('short.toml', 'j1939-short-fields.log'))
        self.assertNotIn(('rod_count', '15'), [(s, v) for _, s, v in rows])
        self.assertEqual([v for _, s, v in rows if s == 'rod_count'], ['3'])
        self.assertEqual(max(float(v) for _, s, v in rows if s == 'feed_pressure_bar'), 100)

    def test_two_sources_of_one_message_are_told(self):
        log = self.write('a.log', ''.join(f'({t}.000000) can0 {id_}#F07D85401FFFFF85\n' for t, id_ in
                                          ((1, '0CF00400'), (2, '0CF00421'), (3, '0CF00400'))))
        result = run('decode', CASES / 'eec1.toml', '--log', log)
        self.good(result)
        self.assertEqual(result.stderr.count('EEC1 comes from 00, 21: all are taken in turn, source = 0x00 takes one'), 1)

    def test_what_comes_by_transport_protocol_is_said_to(self):
        self.refused(decode('j1939-tp.toml', 'j1939-tp-bam.log'), 'transport protocol (PGN 60416 and 60160)')

    def test_several_dbc_files_one_interface(self):
        self.good(decode('two-dbc-one-bus.toml', 'percussion-on.log'))
        self.refused(decode('one-interface-two-sections.toml', 'percussion-on.log'), 'dbc = ["a.dbc", "b.dbc"]')
        self.refused(decode('one-signal-twice.toml', 'percussion-on.log'), 'another bus does too')

    def test_maps_as_tools_write_them(self):
        def use(dbc, name='M.S'):
            rig = self.write('rig.toml', f'[safety]\nstale_after_ms = 0\n[[can]]\ninterface = "can0"\ndbc = "{CASES}/dbc/{dbc}"\n'
                                         f'[can.signals]\nengine_rpm = "{name}"\n')
            return run('decode', rig, '--log', CASES / 'dbc.log')
        for dbc in ('bs_nonempty', 'crlf', 'dotfive', 'ev', 'sci', 'spaces', 'dup_id', 'dup_message', 'dup_signal', 'umlaut',
                    'other_bad_mux', 'cm_nosemi', 'rep_candevstudio196', 'rep_cantools113', 'rep_cantools4',
                    'rep_cantools62', 'rep_cppcanparser9_11'):
            with self.subTest(dbc):
                self.good(use(dbc + '.dbc'))
        self.good(use('longname.dbc', 'M.EngineSpeedOfTheMainDieselEngineAfterFilter'))
        self.good(use('longname.dbc', 'M.EngineSpeedOfTheMainDieselEn0000'))
        self.refused(use('utf16.dbc'), 'utf16.dbc: is UTF-16')
        self.refused(use('cr.dbc'), 'cr.dbc: has line ends of CR alone')
        for dbc in ('comma', 'factor0', 'hexid', 'inf', 'nanrange', 'nounit', 'toolong', 'minuses', 'mux_neg'):
            with self.subTest(dbc):
                self.refused(use(dbc + '.dbc'), dbc + '.dbc:')


class Plc(threading.Thread):
    """A sparse Modbus server: holding registers 100 and 106, exception 2 for everything else."""
    HELD = {100: 90, 106: 2}

    def __init__(self):
        super().__init__(daemon=True)
        self.listening = socket.create_server(('127.0.0.1', 0))
        self.port = self.listening.getsockname()[1]
        self.start()

    def run(self):
        while True:
            peer, _ = self.listening.accept()
            with peer, peer.makefile('rb') as stream:
                while head := stream.read(8):
                    tid, _, length, unit, function = struct.unpack('>HHHBB', head)
                    first, count = struct.unpack('>HH', stream.read(length - 2))
                    there = [self.HELD.get(first + i) for i in range(count)]
                    pdu = bytes((function | 0x80, 2)) if None in there else struct.pack(f'>BB{count}H', function, 2 * count, *there)
                    peer.sendall(struct.pack('>HHHB', tid, 0, len(pdu) + 1, unit) + pdu)


class Check(FieldCase):
    def check(self, text, *words):
        if not (self.folder / 'set').exists():
            write_sound_set(self.folder / 'set')
        rig = self.write('rig.toml', f'[sound]\nset = "{self.folder}/set"\n' + text)
        return run('check', rig, *words)

    def case(self, name, *words):
        return self.check((CASES / name).read_text().replace('dbc/', f'{CASES}/dbc/'), *words)

    def test_lines_and_ports(self):
        self.refused(self.case('two-servers-one-port.toml'), 'is a port that two servers listen at')
        result = self.case('rtu-one-line-two-units.toml')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.case('modbus-two-units-one-host.toml').returncode, 0)
        self.assertEqual(self.case('modbus-status-word-bit.toml').returncode, 0)
        self.assertEqual(self.case('two-dbc-one-bus.toml').returncode, 0)

    def test_addresses_of_a_manual(self):
        result = self.case('mb_40001.toml')
        self.assertEqual(result.returncode, 0)
        self.assertIn('address 40001 counts from 0, so it is holding 40001 = 80002: address = 0?', result.stderr)

    def test_units_and_ranges(self):
        dbc = self.write('m.dbc', 'BO_ 256 DrillLeft: 8 A\n SG_ Feed : 0|16@1+ (1,0) [0|40000] "kPa" A\n'
                                  ' SG_ Load : 16|8@1+ (1,0) [0|100] "%" A\n')
        result = self.check(f'[[can]]\ninterface = "can0"\ndbc = "{dbc}"\n[can.signals]\nfeed_pressure_bar = "DrillLeft.Feed"\n'
                            'engine_load = "DrillLeft.Load"\n')
        self.assertEqual(result.returncode, 0)
        self.assertIn('rig.toml:7: can.signals.feed_pressure_bar: DrillLeft.Feed is in kPa, feed_pressure_bar in bar: scale = 0.01?',
                      result.stderr)
        self.assertNotIn('engine_load', result.stderr)

    def test_a_probe_of_a_device_with_holes(self):
        text = (CASES / 'modbus-sparse-plc.toml').read_text().replace('1702', str(Plc().port))
        result = self.check(text, '--probe')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('005A', result.stdout)
        result = self.check(text.replace('106', '103'), '--probe')
        self.assertEqual(result.returncode, 3)
        self.assertIn('005A', result.stdout)
        self.assertIn('cannot be read: Illegal data address', result.stdout)
        self.assertIn('1 signals cannot be read', result.stderr)


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], '-v'])
