"""The product's master against boards that keep the protocol and yet are a trap for who records them.

    python3 check_odd_boards.py build/release/halbench [Class[.case]]
"""
import csv
import json
import math
import os
import sys
import unittest

import check_program
from check_program import Answer, ProgramCase
from mischief import PAUSE_CYCLES, RESTART_AFTER_DTOS


class Recorded(ProgramCase):
    def path(self, name):
        return os.path.join(self.folder, name)

    def record(self, variant, signals, seconds, rate=100):
        self.serve(variant)
        return self.accept("record", "--duration", str(seconds), "--rate", str(rate), "--signals", signals,
                           "--out", self.path("rows.csv"))

    def columns(self, name):
        """The header and the columns of a recording."""
        with open(self.path(name), encoding="utf-8") as file:
            header, *rows = csv.reader(file)
        self.assertEqual(len(header), len(set(header)), "no column twice")
        return header, {key: [float(row[index]) for row in rows] for index, key in enumerate(header)}

    def sidecar(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return json.load(file)

    def by_name(self, name):
        """The values of each signal by the name that the sidecar gives its column."""
        header, values = self.columns(f"{name}.csv")
        signals = self.sidecar(f"{name}.meta.json")["signals"]
        self.assertEqual(sorted(["time_s", *(signal["column"] for signal in signals)]), sorted(header))
        return {signal["name"]: values[signal["column"]] for signal in signals}

    def read(self, verb, *arguments):
        answer = Answer([verb, *arguments, "--force", "--json"], self.environment)
        self.assertEqual(answer.code, 0, answer)
        return answer.json()


class MeetingNames(Recorded):
    """Signals whose columns would meet: `a_b` counts, `a.b` is a third of it, `a_b_2` a sine of 1 Hz,
    `time_s` a ramp."""
    NAMES = ("a_b", "a.b", "a_b_2", "time_s")

    def setUp(self):
        self.record("meeting_names", ",".join(self.NAMES), 3)

    def assert_right(self, values, *names):
        """Each is what the board makes of its cycle, which counts ten a row from that of the first row."""
        begin = round(3 * values["a.b"][0])
        for row in range(len(values["a.b"])):
            cycle = begin + 10 * row
            due = {"a_b": cycle, "a.b": cycle / 3.0, "a_b_2": math.sin(0.002 * math.pi * cycle),
                   "time_s": cycle % 20000 - 10000}
            for name in names or self.NAMES:
                self.assertAlmostEqual(values[name][row], due[name], delta=1e-6, msg=f"{name} in row {row}")

    def test_each_has_a_column_and_its_own_values(self):
        header, values = self.columns("rows.csv")
        self.assertEqual((header[0], len(header)), ("time_s", 5))
        for row, time_s in enumerate(values["time_s"]):
            self.assertAlmostEqual(time_s, row / 100, delta=1e-6, msg="the first column is the time")
        values = self.by_name("rows")
        self.assertEqual(set(values), set(self.NAMES))
        self.assertEqual(len(values["a_b"]), 300)
        self.assert_right(values)

    def test_converting_keeps_names_and_values(self):
        for way in ("copy.csv", "copy.mf4"):
            with self.subTest(way):
                self.read("convert", self.path("rows.csv"), self.path(way))
                self.read("convert", self.path(way), self.path("back.csv"))
                self.assert_right(self.by_name("back"))

    def test_a_signal_is_taken_by_its_name_and_not_by_anothers_column(self):
        """`a_b_2` is the name of one signal and may be the column of another; no order mixes them up."""
        for names in (["a_b_2", "a.b"], ["a.b", "a_b"], ["time_s", "a.b"], ["a.b", "time_s", "a_b_2", "a_b"]):
            with self.subTest(names):
                self.read("convert", self.path("rows.csv"), self.path("some.csv"), "--signals",
                          ",".join(names))
                values = self.by_name("some")
                self.assertEqual(set(values), set(names))
                self.assert_right(values, *names)

    def test_its_spectrum_is_that_of_the_signal_of_this_name(self):
        """The sine has its line at 1 Hz with the amplitude 1, a ramp has none; three whole periods."""
        told = self.read("spectrum", self.path("rows.csv"), "--signal", "a_b_2", "--window", "rectangular",
                         "--segment_s", "3", "--out", self.path("s.csv"))
        self.assertEqual(told["signal"], "a_b_2")
        self.assertAlmostEqual(told["peaks"][0]["frequency_Hz"], 1.0, delta=0.01)
        self.assertAlmostEqual(told["peaks"][0]["value"], 1.0, delta=0.01)
        self.assertAlmostEqual(told["rms"]["value"], math.sqrt(0.5), delta=0.01)

    def test_the_recording_as_a_device_has_the_names(self):
        uri = "replay:" + self.path("rows.csv")
        signals = self.read("describe", uri)["signals"]
        self.assertEqual({signal["name"] for signal in signals}, set(self.NAMES))
        self.read("record", uri, "--duration", "2", "--rate", "100", "--signals", "a_b_2,a.b,time_s", "--out",
                  self.path("again.csv"))
        self.assert_right(self.by_name("again"), "a_b_2", "a.b", "time_s")

    def test_laid_over_another_each_signal_meets_its_own(self):
        self.read("convert", self.path("rows.csv"), self.path("same.csv"))
        told = self.read("overlay", self.path("rows.csv"), self.path("same.csv"), "--signals",
                         ",".join(self.NAMES), "--out", self.path("both.csv"))
        signals = told["runs"][1]["signals"]
        self.assertEqual(len(signals), 4)
        for signal in signals:
            self.assertEqual(signal["difference"]["largest"], 0, signal)
        values = self.by_name("both")
        for run in ("rows", "same"):
            self.assert_right({name: values[f"{run}.{name}"] for name in self.NAMES})

    def test_every_picture_is_drawn(self):
        for name in self.NAMES:
            self.read("plot", self.path("rows.csv"), "--signals", name, "--out", self.path("p.svg"))
            with open(self.path("p.svg"), encoding="utf-8") as file:
                self.assertIn("<svg", file.read())


class ClockRestarts(Recorded):
    """The board's clock begins anew after 50 rows, as after a reset: how long it was away, the host tells."""
    SAID = "the device clock restarted"

    def check(self, variant, away_s):
        answer = self.record(variant, "counter", 1.5)
        self.assertIn(self.SAID, answer.err)
        result = answer.json()
        self.assertEqual(result["data_quality"]["verdict"], "doubtful")
        finding, = [f for f in result["data_quality"]["findings"] if f["code"] == "clock_restarted"]
        self.assertTrue(finding["message"] and finding["hint"])
        _, values = self.columns("rows.csv")
        times, cycles = values["time_s"], values["counter"]
        self.assertEqual(result["rows"], len(times))
        self.assertEqual(times, sorted(set(times)), "the time goes on")
        gap, = self.sidecar("rows.meta.json")["gaps"]
        at, = [row for row, time_s in enumerate(times) if abs(time_s - gap["time_s"]) < 1e-9]
        self.assertEqual(at, RESTART_AFTER_DTOS, "the gap is before the first row of the new clock")
        for first, last in ((0, at), (at, len(times))):
            for row in range(first, last):
                self.assertEqual(cycles[row], cycles[first] + 10 * (row - first), "each row has its values")
                self.assertAlmostEqual(times[row] - times[first], (row - first) / 100, delta=1e-6)
        # The board's cycles are its true time: what the axis leaves out is what the board was away.
        self.assertAlmostEqual(times[at] - times[at - 1], away_s + 0.01, delta=0.2)
        self.assertAlmostEqual(cycles[at] - cycles[at - 1], 1000 * away_s + 10, delta=200)
        self.assertAlmostEqual(gap["lost_rows"], 100 * away_s, delta=20)
        self.assertEqual(result["lost_rows"], gap["lost_rows"])
        return answer

    def test_the_gap_is_marked_and_as_long_as_the_board_was_away(self):
        self.check("clock_restarts_after_a_pause", PAUSE_CYCLES / 1000)

    def test_a_clock_that_starts_again_without_a_pause_is_a_gap_too(self):
        self.check("clock_restarts", 0.0)

    def test_those_who_read_the_recording_see_the_gap(self):
        for variant, missing in (("clock_restarts_after_a_pause", PAUSE_CYCLES / 10), ("clock_restarts", 0)):
            with self.subTest(variant):
                self.record(variant, "counter", 1.5)
                listed, = self.read("recordings", self.folder)["recordings"]
                self.assertEqual(listed["gaps"], 1)
                self.assertAlmostEqual(listed["missing_rows"], missing, delta=20)

    def test_a_clock_that_goes_on_leaves_no_gap(self):
        answer = self.record("plain", "counter", 1.5)
        self.assertNotIn(self.SAID, answer.err)
        self.assertEqual(answer.json()["data_quality"]["findings"], [])
        self.assertEqual(self.sidecar("rows.meta.json")["gaps"], [])


if __name__ == "__main__":
    check_program.PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
