#!/usr/bin/env python3
"""Sets a signal of a running rigsoundd and follows what changes: control_client.py [SOCKET [KEY VALUE]]"""
import json
import socket
import sys

path = sys.argv[1] if len(sys.argv) > 1 else '/run/rigsound/control.sock'
with socket.socket(socket.AF_UNIX) as client:
    client.connect(path)
    lines = client.makefile('rw')

    def say(**request):
        print(json.dumps(request), file=lines, flush=True)

    if len(sys.argv) > 3:
        say(command='set', key=sys.argv[2], value=float(sys.argv[3]))
    say(command='subscribe', topics=['signals', 'booms'])
    for line in lines:  # answers first, then events
        print(json.loads(line), flush=True)
