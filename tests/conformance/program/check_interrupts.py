"""Signals and devices that go away: stopped, restored, the right exit code, no file left.

    python3 check_interrupts.py build/release/halbench [Class[.case]]
"""
import json
import os
import pty
import signal
import subprocess
import sys
import time
import unittest

import halbench
from halbench import ProgramCase

RECORDING_EXPERIMENT = '''schema = "halbench.experiment/1"
device = "sim:htm?seed=1"

[[step]]
kind = "record"
name = "rest"
duration_s = 30
'''
SIGNALS = ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129), (signal.SIGQUIT, 131))


class BoardCase(ProgramCase):
    def board(self, uri):
        description = self.accept("describe", uri, "--json").json()
        values = {p["name"]: p["value"] for p in description["parameters"]
                  if not p["name"].startswith(("reference.", "plateau.", "capture."))}
        status = self.accept("get", uri, "hb.arm", "hb.setpoint", "hb.mode", "current_command", "--json").json()["values"]
        return values, {v["name"]: v["value"] for v in status}


    def recover(self, name):
        """Rows of an interrupted recording of 100 Hz: all that were written, evenly spaced, with their sidecar."""
        with open(self.path(name + ".partial"), encoding="utf-8") as file:
            whole = file.read().rpartition("\n")[0].split("\n")[1:]
        answer = self.accept("convert", name + ".partial", name)
        self.assertRegex(answer.err, rf"recovered {len(whole)} rows \([0-9.]+ s\) of {name}\.partial; (nothing was )?cut off")
        with open(self.path(name), encoding="utf-8") as file:
            rows = file.read().split("\n")[1:-1]
        self.assertEqual(rows, whole)
        self.assertEqual([float(row.split(",")[0]) for row in rows], [i / 100 for i in range(len(rows))])
        with open(self.path(name.replace(".csv", ".meta.json")), encoding="utf-8") as file:
            meta = json.load(file)
        self.assertEqual(meta["markers"], [{"text": "recording interrupted", "time_s": float(rows[-1].split(",")[0])}])
        self.assertEqual((meta["rows"], meta["device"]["model"]), (len(rows), "htm"))
        self.assertFalse(os.path.exists(self.path(name + ".partial")))
        return len(rows)

    def await_octets(self, name, octets=1_000):
        """The recording runs: so much of it is in its partial file, however long a busy machine takes to get there."""
        partial = self.path(name + ".partial")
        until = time.monotonic() + 60
        while not (os.path.exists(partial) and os.path.getsize(partial) > octets):
            self.assertLess(time.monotonic(), until, f"{partial} does not grow")
            time.sleep(0.02)


class Killed(BoardCase):
    """SIGKILL in mid-recording: what had arrived is in the partial file."""

    def kill(self, name, *arguments):
        process = self.start_program(*arguments, "--realtime")
        partial = self.path(name + ".partial")
        self.await_octets(name, 20_000)
        process.kill()
        process.communicate()
        self.assertEqual(process.returncode, -signal.SIGKILL)
        self.assertFalse(os.path.exists(self.path(name)))
        size = os.path.getsize(partial)
        rows = self.recover(name)
        self.assertGreater(rows, 50, f"{size} octets")

    def test_recording_of_a_simulated_board(self):
        self.kill("f.csv", "record", "sim:htm", "--duration", "30", "--out", "f.csv")

    def test_record_step_of_a_run(self):
        self.write("e.toml", RECORDING_EXPERIMENT)
        self.kill("out/rest.csv", "run", "e.toml", "--out", "out")

    def test_recording_of_a_board_on_the_network(self):
        _, uri = self.serve()
        self.kill("f.csv", "record", uri, "--duration", "30", "--out", "f.csv")

    def test_the_next_recording_does_not_destroy_what_is_left(self):
        self.write("f.csv.partial", "time_s,position_rad\n0,1\n0.01,2\n0.0")
        answer = self.accept("record", "sim:htm", "--duration", "0.1", "--out", "f.csv")
        self.assertRegex(answer.err, r"'f\.interrupted\.csv\.partial'; halbench convert")
        self.assert_nothing_left("f.csv", "f.meta.json", "f.interrupted.csv.partial")
        answer = self.accept("convert", "f.interrupted.csv.partial", "old.csv", "--json")
        self.assertEqual(answer.json()["recovered"], {"rows": 2, "duration_s": 0.01, "cut_octets": 3, "damaged_octets": 0, "unchecked_rows": 2})

    def test_nothing_to_recover_is_said(self):
        for text in ("", "time_s,posi", "time_s,position_rad\n", "time_s,position_rad\n0,"):
            self.write("f.csv.partial", text)
            self.refuse(2, "no complete row", "convert", "f.csv.partial", "f.csv")
        self.assert_nothing_left("f.csv.partial")


class Interrupts(BoardCase):
    def interrupt(self, number, after_s, *arguments, recording=None):
        process = self.start_program(*arguments)
        if recording:
            self.await_octets(recording)
        else:
            time.sleep(after_s)
        self.assertIsNone(process.poll(), f"{arguments} ended before the signal")
        process.send_signal(number)
        began = time.monotonic()
        out, err = process.communicate(timeout=15)
        self.assertLess(time.monotonic() - began, 3.0, "ends at once")
        return process.returncode, out, err

    def test_recording_ends_without_its_name_and_says_where_the_rows_are(self):
        for number, code in SIGNALS:
            name = f"f{code}.csv"
            ended, _, err = self.interrupt(number, None, "record", "sim:htm", "--realtime", "--duration", "30", "--out",
                                           name, recording=name)
            self.assertEqual(ended, code, err)
            self.assertRegex(err.strip(), rf"\A[^\n]*'{name}\.partial', halbench convert[^\n]*\Z")
            self.assertFalse(os.path.exists(self.path(name)))
            self.recover(name)

    def test_sweep_ends_and_the_board_is_as_before(self):
        for number, code in SIGNALS:
            _, uri = self.serve()
            before = self.board(uri)
            ended, _, err = self.interrupt(number, 2.0, "identify", uri, "--arm", "--out", "m.json")
            self.assertEqual(ended, code, err)
            self.assertEqual(self.board(uri), before)
            self.assert_nothing_left()

    def test_move_ends_and_the_board_is_as_before(self):
        for number, code in SIGNALS:
            _, uri = self.serve()
            before = self.board(uri)
            ended, out, err = self.interrupt(number, 1.0, "move", uri, "--arm", "--json", "--reference",
                                             "sine,amplitude_deg=20,frequency_hz=1", "--duration", "20")
            self.assertEqual(ended, code, err)
            self.assertEqual(json.loads(out)["exit_code"], code)
            self.assertIn(signal.Signals(number).name, err)
            self.assertEqual(self.board(uri), before)

    def test_terminal_that_closes_stops_the_motor(self):
        """What a lost ssh is to the program: a hang-up, again from the shell, and a terminal that takes no word."""
        _, uri = self.serve()
        before = self.board(uri)
        child, terminal = pty.fork()
        if child == 0:
            os.execv(halbench.PROGRAM, [halbench.PROGRAM, "identify", uri, "--arm"])
        time.sleep(2.0)
        os.close(terminal)
        try:
            os.kill(child, signal.SIGHUP)
            os.kill(child, signal.SIGTERM)
        except ProcessLookupError:
            pass                                # it was quick
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 129)
        self.assertEqual(self.board(uri), before)

    def test_hang_up_ignored_from_the_start_stays_so(self):
        process = subprocess.Popen([halbench.PROGRAM, "record", "sim:htm", "--realtime", "--duration", "1.5", "--out", "f.csv"],
                                   cwd=self.folder, stderr=subprocess.PIPE, text=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.addCleanup(self.end, process)
        self.await_octets("f.csv")
        process.send_signal(signal.SIGHUP)
        _, err = process.communicate(timeout=15)
        self.assertEqual(process.returncode, 0, err)

    def test_gains_on_their_way_go_back(self):
        self.accept("identify", "sim:htm", "--out", "m.json", timeout=110)
        for number, code in SIGNALS[:2]:
            _, uri = self.serve()
            before = self.board(uri)
            # Eight steps of two seconds each: after seven some are written, and not all.
            ended, _, err = self.interrupt(number, 7.0, "tune", "m.json", "--apply", uri, "--live", "--arm", "--foreign-model")
            self.assertEqual(ended, code, err)
            self.assertEqual(self.board(uri), before)

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

    def test_board_that_dies_while_gains_walk_is_not_said_to_have_its_old_ones(self):
        self.accept("identify", "sim:htm", "--out", "m.json", timeout=110)
        server, uri = self.serve()
        process = self.start_program("tune", "m.json", "--apply", uri, "--live", "--arm", "--foreign-model")
        time.sleep(7.0)
        server.kill()
        _, err = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 3, err)
        self.assertIn("not confirmed", err)

    def test_board_that_freezes_in_mid_recording_is_a_device_failure(self):
        server, uri = self.serve()
        process = self.start_program("record", uri, "--duration", "20", "--out", "f.csv")
        self.await_octets("f.csv")
        server.send_signal(signal.SIGSTOP)
        _, err = process.communicate(timeout=15)
        self.assertEqual(process.returncode, 3, err)
        self.assertRegex(err.strip(), r"\A[^\n]*'f\.csv\.partial', halbench convert[^\n]*\Z")
        self.assert_nothing_left("f.csv.partial", "f.chunks.partial", "f.meta.json.partial")
        self.recover("f.csv")
        server.send_signal(signal.SIGCONT)
        self.accept("describe", uri)

    def test_board_that_freezes_for_a_while_is_recorded_on(self):
        server, uri = self.serve()
        process = self.start_program("record", uri, "--duration", "9", "--reconnect", "--json", "--out", "f.csv")
        self.await_octets("f.csv")
        server.send_signal(signal.SIGSTOP)
        time.sleep(2.5)         # longer than a board may be silent
        server.send_signal(signal.SIGCONT)
        out, err = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 0, err)
        result = json.loads(out)
        with open(self.path("f.meta.json"), encoding="utf-8") as file:
            meta = json.load(file)
        with open(self.path("f.csv"), encoding="utf-8") as file:
            times = [float(row.split(",")[0]) for row in file.read().split("\n")[1:-1]]
        self.assertEqual([m["text"] for m in meta["markers"]], ["connection lost", "connection back"])
        self.assertEqual((result["gaps"], len(meta["gaps"])), (1, 1))
        self.assertEqual(result["rows"] + result["lost_rows"], 900)
        self.assertAlmostEqual(result["gaps_s"], result["lost_rows"] / 100)
        self.assertGreater(result["gaps_s"], 2.0)
        self.assertEqual(result["data_quality"]["verdict"], "doubtful")
        self.assertEqual(times, [round(t * 100) / 100 for t in times], "on the grid of the rows before")
        self.assertNotIn("f.csv.partial", os.listdir(self.path(".")))

    def test_board_that_does_not_come_back_in_time_is_a_device_failure(self):
        server, uri = self.serve()
        process = self.start_program("record", uri, "--duration", "3", "--reconnect", "--out", "f.csv")
        self.await_octets("f.csv")
        server.kill()
        _, err = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 3, err)
        self.assertRegex(err, "waiting for the device")
        self.assert_nothing_left("f.csv.partial", "f.chunks.partial", "f.meta.json.partial")

    def test_killed_program_leaves_a_board_that_stops_itself(self):
        _, uri = self.serve()
        parameters, _ = self.board(uri)
        process = self.start_program("identify", uri, "--arm")
        time.sleep(2.0)
        process.kill()
        time.sleep(2.0)         # the board's watchdog: 1 s
        self.assert_stopped_itself(uri, parameters)

    def test_killed_program_leaves_the_gains_from_before_all_steps(self):
        self.accept("identify", "sim:htm", "--out", "m.json", timeout=110)
        _, uri = self.serve()
        parameters, _ = self.board(uri)
        process = self.start_program("tune", "m.json", "--apply", uri, "--live", "--arm", "--foreign-model")
        time.sleep(7.0)
        # On a busy machine the link may have been lost before: then the program ended by itself, to the same effect.
        self.assertIn(process.poll(), (None, 3), "it is on its way")
        process.kill()
        time.sleep(2.0)         # the board's watchdog: 1 s
        # Killed, it could not put the watchdog back.
        own = {"hb.mode": 0, "hb.watchdog_ms": 0}
        self.assertEqual(self.board(uri)[0] | own, parameters | own)

    def assert_stopped_itself(self, uri, parameters):
        values = {v["name"]: v["value"]
                  for v in self.accept("get", uri, "hb.arm", "status", "current_command", "--json").json()["values"]}
        self.assertEqual(values, {"hb.arm": 0, "status": 3, "current_command": 0})
        own = {"hb.mode": 0, "hb.watchdog_ms": 0}          # killed, it could not put these back
        self.assertEqual(self.board(uri)[0] | own, parameters | own, "the old calibration is back")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
