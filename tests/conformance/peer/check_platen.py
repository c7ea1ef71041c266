"""A positioner on air, driven by our independent master: it arms, homes, moves and stops (protocol.md 3.11, 3.15).

    python3 check_platen.py "halbench serve sim:planar --tcp 127.0.0.1:0" [case]
    python3 check_platen.py "mps2_serve sim:planar mps2_planar.elf" [case]
"""
import shlex
import sys
import time
import unittest

import wire
from master import Master, XcpError
from target import Running

COMMAND = []
TRAPEZOID = 8
POSITION = 2
STOPPED_BY_COMMAND = 2
STOPPED_BY_WATCHDOG = 3
COILS = [f"current.coil{number}" for number in range(1, 7)]


class Platen(unittest.TestCase):
    def setUp(self):
        self.running = Running(COMMAND, "pty")
        self.addCleanup(self.running.stop)
        self.master = Master(self.running.address)
        self.addCleanup(self.master.close)
        self.master.connect()
        self.master.describe()

    def wait_for(self, is_true, what, patience_s=20.0):
        """The board runs at its own pace; the status requests feed the watchdog."""
        end = time.monotonic() + patience_s
        while not is_true():
            self.assertLess(time.monotonic(), end, what)
            self.master.status()

    def home(self):
        self.master.write_name("hb.home", 1)
        self.wait_for(lambda: self.master.read_name("homed") == 1, "it homes")
        self.assertEqual(self.master.read_name("hb.home"), 0, "an order that is done")

    def travel(self, distance_m, speed_m_s):
        """Returns where it began: without current it glides until it is armed."""
        self.master.write_name("hb.mode", POSITION)
        self.master.write_name("hb.arm", 1)
        self.wait_for(lambda: self.master.read_name("reference.x") != 0, "it holds its place")
        start_m = self.master.read_name("reference.x")
        for name, value in (("shape", TRAPEZOID), ("amplitude", distance_m), ("rate", speed_m_s), ("acceleration", 1.0)):
            self.master.write_name("reference.x." + name, value)
        self.master.write_name("reference.start", 1)
        return start_m

    def assert_without_current(self):
        self.wait_for(lambda: all(self.master.read_name(coil) == 0 for coil in COILS), "the brake ends by itself")

    def assert_latched(self, latch):
        self.wait_for(lambda: self.master.read_name("status") == latch, "it says why it stopped")
        with self.assertRaises(XcpError):
            self.master.write_name("hb.arm", 1)

    def test_it_homes_and_travels_where_it_is_told_to(self):
        self.home()
        self.master.write_name("hb.watchdog_ms", 2000)
        start_m = self.travel(2e-3, 0.05)
        # The noise of a pose is some micrometres; the integral is still taking up the cable's force.
        self.wait_for(lambda: abs(self.master.read_name("position.x") - start_m - 2e-3) < 1e-4, "it arrives")
        self.assertEqual(self.master.read_name("torn_count"), 0)
        self.master.write_name("hb.arm", 0)
        self.assert_without_current()

    def test_a_stop_brakes_it_and_stays(self):
        self.home()
        self.master.write_name("hb.watchdog_ms", 2000)
        self.travel(0.04, 0.02)
        self.wait_for(lambda: abs(self.master.read_name("speed.x")) > 0.01, "it moves")
        self.master.command(wire.USER_CMD, "B", wire.USER_STOP)
        self.assert_latched(STOPPED_BY_COMMAND)
        self.assert_without_current()
        self.master.command(wire.USER_CMD, "B", wire.USER_CLEAR)
        self.wait_for(lambda: self.master.read_name("status") == 0, "the stop is cleared")

    def test_a_silent_master_is_not_waited_for(self):
        self.home()
        self.travel(0.04, 0.02)
        self.wait_for(lambda: abs(self.master.read_name("speed.x")) > 0.01, "it moves")
        self.assertEqual(self.master.read_name("hb.watchdog_ms"), 1000)
        # Silent until the watchdog ends the session, however slowly the board runs.
        end = time.monotonic() + 30.0
        while not self.master.events and time.monotonic() < end:
            self.master.pump(0.1)
        self.master.connect()
        self.assert_latched(STOPPED_BY_WATCHDOG)
        self.assert_without_current()


if __name__ == "__main__":
    COMMAND = shlex.split(sys.argv.pop(1))
    unittest.main()
