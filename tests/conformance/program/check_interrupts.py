"""Signals and devices that go away: stopped, restored, the right exit code, no file left.

    python3 check_interrupts.py build/release/halbench [Class[.case]]
"""
import signal
import sys
import time
import unittest

import halbench
from halbench import ProgramCase

SIGNALS = ((signal.SIGINT, 130), (signal.SIGTERM, 143))


class BoardCase(ProgramCase):
    def board(self, uri):
        description = self.accept("describe", uri, "--json").json()
        values = {p["name"]: p["value"] for p in description["parameters"]
                  if not p["name"].startswith(("reference.", "plateau.", "capture.", "hb.watchdog"))}
        status = self.accept("get", uri, "hb.arm", "hb.setpoint", "hb.mode", "current_command", "--json").json()["values"]
        return values, {v["name"]: v["value"] for v in status}


class Interrupts(BoardCase):
    def interrupt(self, number, after_s, *arguments):
        process = self.start_program(*arguments)
        time.sleep(after_s)
        self.assertIsNone(process.poll(), f"{arguments} ended before the signal")
        process.send_signal(number)
        began = time.monotonic()
        out, err = process.communicate(timeout=15)
        self.assertLess(time.monotonic() - began, 3.0, "ends at once")
        return process.returncode, out, err

    def test_recording_ends_without_a_file(self):
        for number, code in SIGNALS:
            ended, _, err = self.interrupt(number, 0.7, "record", "sim:htm", "--realtime", "--duration", "30", "--out",
                                           "f.csv")
            self.assertEqual(ended, code, err)
            self.assert_nothing_left()

    def test_sweep_ends_and_the_board_is_as_before(self):
        for number, code in SIGNALS:
            _, uri = self.serve()
            before = self.board(uri)
            ended, _, err = self.interrupt(number, 2.0, "identify", uri, "--arm", "--out", "m.json")
            self.assertEqual(ended, code, err)
            self.assertEqual(self.board(uri), before)
            self.assert_nothing_left()

    def test_serving_ends_with_success(self):
        for number, _ in SIGNALS:
            for kind in ("tcp", "udp", "pty"):
                process, _ = self.serve(kind)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=5), 0, kind)


class Departures(BoardCase):
    def test_board_that_dies_in_mid_sweep_is_a_device_failure(self):
        server, uri = self.serve()
        process = self.start_program("identify", uri, "--arm", "--out", "m.json")
        time.sleep(2.0)
        server.kill()
        began = time.monotonic()
        _, err = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 3, err)
        self.assertLess(time.monotonic() - began, 8.0)
        self.assert_nothing_left()

    def test_board_that_freezes_in_mid_recording_is_a_device_failure(self):
        server, uri = self.serve()
        process = self.start_program("record", uri, "--duration", "20", "--out", "f.csv")
        time.sleep(1.0)
        server.send_signal(signal.SIGSTOP)
        _, err = process.communicate(timeout=15)
        self.assertEqual(process.returncode, 3, err)
        self.assert_nothing_left()
        server.send_signal(signal.SIGCONT)
        self.accept("describe", uri)

    def test_killed_program_leaves_a_board_that_stops_itself(self):
        _, uri = self.serve()
        parameters, _ = self.board(uri)
        process = self.start_program("identify", uri, "--arm")
        time.sleep(2.0)
        process.kill()
        time.sleep(2.0)         # the board's watchdog: 1 s
        values = {v["name"]: v["value"]
                  for v in self.accept("get", uri, "hb.arm", "status", "current_command", "--json").json()["values"]}
        self.assertEqual(values, {"hb.arm": 0, "status": 3, "current_command": 0})
        self.assertEqual(self.board(uri)[0] | {"hb.mode": 0}, parameters | {"hb.mode": 0}, "the old calibration is back")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
