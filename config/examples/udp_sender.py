#!/usr/bin/env python3
"""Sends a drill's state to a rig's [[udp]]: udp_sender.py [HOST [PORT [SECONDS]]]"""
import json
import math
import socket
import sys
import time

host = sys.argv[1] if len(sys.argv) > 1 else '127.0.0.1'
port = int(sys.argv[2]) if len(sys.argv) > 2 else 1503
seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 60

sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
start = time.monotonic()
seq = 0
while (now := time.monotonic() - start) < seconds:
    state = {
        'engine_rpm': 1500 + 100 * math.sin(now),
        'feed_pressure_bar': 90,
        'percussion': True,        # or 1, or "on"
        'rattling': 'none',        # "none", "closed", "open"
        'rod_count': 2,
        'seq': seq,                # optional: what the network delivers late is left out
    }                              # of a second boom: 'boom2.rattling', or 'boom2': {'rattling': 'none'}
    sock.sendto(json.dumps(state).encode(), (host, port))
    seq += 1
    time.sleep(0.02)               # send at a steady pace: silence makes signals stale
