"""Rig files for the tests."""
import pathlib

CAN_SIGNALS = '''
engine_rpm = "EEC1.EngSpeed"
feed_pressure_bar = "DRILL1.FeedPressure"
rattling = "DRILL1.Rattling"
percussion = "DRILL1.Percussion"
rod_count = "DRILL1.RodCount"
master_gain_db = "CABIN1.MasterGain"
'''


def write_rig(path, project, sounds, *, device='null', block=64, periods=3, form='auto', can=(), modbus=(), udp=(), fd=False,
              safety='', socket='/tmp/control.sock'):
    """`can`: interfaces; `modbus`, `udp`: texts of whole sections."""
    text = f'[audio]\ndevice = "{device}"\nblock = {block}\nperiods = {periods}\nformat = "{form}"\n'
    text += f'[sound]\nset = "{sounds}"\n[safety]\n{safety}\n[control]\nsocket = "{socket}"\n'
    for interface in can:
        text += f'[[can]]\ninterface = "{interface}"\nfd = {str(fd).lower()}\ndbc = "{project}/config/dbc/rig.dbc"\n'
        text += '[can.signals]' + CAN_SIGNALS
    for section in modbus:
        text += '[[modbus]]\n' + section + '\n'
    for section in udp:
        text += '[[udp]]\n' + section + '\n'
    pathlib.Path(path).write_text(text)
    return path
