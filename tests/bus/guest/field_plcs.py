"""field_plcs.py KIND WHERE: devices as they are in the field. Prints `listening`, serves until killed.

sparse  PORT    pymodbus with a sparse store: holding registers 100 and 106, exception 2 for a read over what lies between
closing PORT    answers one request a connection, then closes it: register 100 is 90, 200 is 55
units   DEVICE  units 1 and 2 on one serial line: register 0 is 81 and 82; says `garbled` when two requests mix
"""
import socket
import struct
import sys

READ = struct.Struct('>BBHH')


def checksum(frame):
    crc = 0xFFFF
    for byte in frame:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ 0xA001 if crc & 1 else crc >> 1
    return struct.pack('<H', crc)


def sparse(port):
    from pymodbus.datastore import ModbusServerContext, ModbusSlaveContext, ModbusSparseDataBlock
    from pymodbus.server import StartTcpServer
    store = ModbusSlaveContext(hr=ModbusSparseDataBlock({100: 90, 106: 2}), zero_mode=True)
    print('listening', flush=True)
    StartTcpServer(context=ModbusServerContext(slaves=store, single=True), address=('127.0.0.1', int(port)))


def closing(port):
    held = {100: 90, 200: 55}
    listening = socket.create_server(('127.0.0.1', int(port)))
    print('listening', flush=True)
    while True:
        peer, _ = listening.accept()
        with peer:
            request = b''
            while len(request) < 12:
                got = peer.recv(12 - len(request))
                if not got:
                    break
                request += got
            if len(request) == 12:
                _, function, first, count = READ.unpack(request[6:])
                values = [held.get(first + i, 0) for i in range(count)]
                answer = struct.pack(f'>BBB{count}H', request[6], function, 2 * count, *values)
                peer.sendall(request[:4] + struct.pack('>H', len(answer)) + answer)


def units(device):
    with open(device, 'r+b', buffering=0) as line:
        print('listening', flush=True)
        while True:
            request = b''
            while len(request) < 8:
                request += line.read(8 - len(request))
            unit, function, _, count = READ.unpack(request[:6])
            if checksum(request[:6]) != request[6:] or function != 3 or unit not in (1, 2):
                print('garbled', flush=True)
                continue
            answer = struct.pack(f'>BBB{count}H', unit, 3, 2 * count, *[80 + unit] * count)
            line.write(answer + checksum(answer))


if __name__ == '__main__':
    {'sparse': sparse, 'closing': closing, 'units': units}[sys.argv[1]](sys.argv[2])
