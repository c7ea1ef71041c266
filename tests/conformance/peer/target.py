"""Starts the slave under test: the product's simulated board, or our own slave to test the tests."""
import os
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass

HERE = os.path.dirname(os.path.abspath(__file__))


@dataclass
class Target:
    """How to start a slave and what the checks need to know about it beyond its A2L."""
    command: list
    moving: str                 # a signal that differs in every control cycle once set_in_motion() was called
    triggers: tuple = ("hb.arm", "hb.stop", "reference.start", "capture.start")
    stopped_by_command: int = 2
    stopped_by_watchdog: int = 3
    line: str = "tcp"
    is_small: bool = False              # room for two short lists only
    is_reset_by_opening: bool = False   # as an Arduino: what was latched is gone with the master that was

    def start(self):
        return Running(self.command, self.line)


class Running:
    def __init__(self, command, kind):
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        while line.startswith("Loaded "):               # simavr's own
            line = self.process.stdout.readline()
        line = line.replace(" serial:", " pty:")        # the same by another name
        if not re.fullmatch(r"listening (tcp:127\.0\.0\.1:\d+|udp:127\.0\.0\.1:\d+|pty:/\S+)\n", line):
            self.stop()
            raise RuntimeError(f"{command[0]} said {line!r} instead of its address")
        self.address = line.split(" ", 1)[1].strip()
        if kind == "plain":
            self.address = self.address.replace("pty:", "plain:")

    def stop(self):
        """Ends it and returns its exit code."""
        self.process.terminate()
        try:
            return self.process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()
        finally:
            self.process.stdout.close()


def slave_target(variant="plain"):
    return Target([sys.executable, os.path.join(HERE, "slave.py"), variant], moving="counter")


LINES = {"tcp": ["--tcp", "127.0.0.1:0"], "udp": ["--udp", "127.0.0.1:0"], "pty": ["--pty"],
         "plain": ["--pty", "--framing", "off"]}


def program_target(program, kind="tcp"):
    return Target([program, "serve", "sim:htm?seed=1", *LINES[kind]], moving="position", line=kind)


def command_target(command):
    """Any other board with our signals whose first line says `listening tcp:127.0.0.1:PORT`."""
    return Target(shlex.split(command), moving="position")


def firmware_target(command):
    """The board's own program, run instruction by instruction behind a serial line."""
    return Target(shlex.split(command), moving="position", line="pty", is_small=True, is_reset_by_opening=True)


def from_arguments():
    """`--program PATH`, `--udp PATH`, `--pty PATH`, `--plain PATH` (a pty without framing), `--slave VARIANT`,
    `--firmware "COMMAND"` or `--command "COMMAND"` in front of unittest's own arguments."""
    kind, value = sys.argv[1:3]
    del sys.argv[1:3]
    if kind in ("--udp", "--pty", "--plain"):
        return program_target(value, kind[2:])
    return {"--program": program_target, "--slave": slave_target, "--command": command_target,
            "--firmware": firmware_target}[kind](value)
