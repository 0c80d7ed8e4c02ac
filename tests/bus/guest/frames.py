"""CAN frames from Python's own sockets, so that counts are exact."""
import socket
import struct
import time

EEC1, DRILL1, CABIN1 = 0x0CF004FE, 0x18FF10FE, 0x18FF11FE
EFF, ERR = 0x80000000, 0x20000000


def engine_speed(rpm):
    return struct.pack('<3sHB2s', b'\xff\xff\xff', int(rpm / 0.125), 0xff, b'\xff\xff')


def master_gain(db):
    return bytes([int((db + 60) / 0.5)]) + b'\xff' * 7


def drill(feed_bar, rattling=0):
    return struct.pack('<HHBBBB', int(feed_bar * 100), 0xffff, rattling | 3 << 2, 1, 0xff, 0xff)


class Bus:
    def __init__(self, interface):
        self.socket = socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FD_FRAMES, 1)
        self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER, b'')
        self.socket.bind((interface,))

    def close(self):
        self.socket.close()

    def send(self, identifier, data, flags=EFF):
        self.put(struct.pack('=IB3x8s', identifier | flags, len(data), data))

    def send_fd(self, identifier, data, flags=EFF):
        self.put(struct.pack('=IBB2x64s', identifier | flags, len(data), 0, data))

    def put(self, frame):
        while True:
            try:
                self.socket.send(frame)
                return
            except OSError:  # ENOBUFS: the queue is full
                time.sleep(0.001)
