"""Contestants in turn, so that a busy machine hits all alike; of each the least processor time counts."""
import os
import subprocess
from dataclasses import dataclass
from typing import Callable


@dataclass
class Contestant:
    name: str
    run: Callable      # once; returns the processor seconds it took
    best_s: float = float('inf')


def whole_process(command, out):
    """User and system seconds of a program, from its start to its end. `out`: the file it makes, made anew each time."""
    def run():
        out.unlink(missing_ok=True)
        with open(out.with_suffix('.log'), 'wb') as log:
            process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=log, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode or not out.exists():
            raise SystemExit(f'{command[0]} ended with {process.returncode}:\n{out.with_suffix(".log").read_text()}')
        return usage.ru_utime + usage.ru_stime
    return run


def said_seconds(command):
    """Of a program that measures itself and prints them."""
    def run():
        return float(subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True).stdout)
    return run


def race(contestants, rounds, shown):
    for number in range(rounds):
        for contestant in contestants:
            shown(number, contestant)
            contestant.best_s = min(contestant.best_s, contestant.run())
