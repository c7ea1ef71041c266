"""halbench recordings and overlay: what a folder holds, and runs on one time axis.

    python3 check_comparing.py build/release/halbench [Lists|Overlays[.case]]
"""
import csv
import datetime
import hashlib
import json
import math
import os
import sys
import time
import unittest

import halbench
from halbench import ProgramCase


class Comparing(ProgramCase):
    def record(self, name, value, rate_hz=100, rows=100, start_s=0.0, markers=(), **said):
        """A recording with the sidecar of its own: time, position and status."""
        text = "".join(f"{start_s + row / rate_hz:.6g},{value(row / rate_hz)!r},{row % 3}\n" for row in range(rows))
        self.write(f"{name}.csv", "time_s,position_rad,status\n" + text)
        signals = [{"name": "position", "column": "position_rad", "unit": "rad", "role": "position"},
                   {"name": "status", "column": "status", "unit": "", "role": ""}]
        with open(self.path(f"{name}.csv"), "rb") as file:
            checksum = hashlib.sha256(file.read()).hexdigest()
        meta = {"schema": "halbench.recording-meta/1", "sha256": checksum, "halbench": "0", "device": {"model": "htm", "id": "HB-17"},
                "started": "2026-03-01T10:00:00Z", "signals": signals, "rows": rows, "period_s": 1 / rate_hz,
                "markers": [{"time_s": time_s, "text": text} for time_s, text in markers]}
        self.write(f"{name}.meta.json", json.dumps(meta | said))


class Lists(Comparing):
    def identification(self, name, started, damping, half, device="HB-17", source="identified"):
        value = {"value": damping, "unit": "N*m*s/rad", "ci95": [damping - half, damping + half], "source": source}
        units = {"coulomb_friction": "N*m", "torque_constant": "N*m/A", "inertia": "kg*m^2"}
        others = {name: {"value": None, "unit": unit, "ci95": None, "source": "not identifiable"}
                  for name, unit in units.items()}
        self.write(name, json.dumps({
            "schema": "halbench.identification/1", "started": started,
            "device": {"model": "htm", "id": device, "firmware": "", "simulated": False, "overrides": {}},
            "data_quality": {"verdict": "good", "findings": []},
            "parameters": {"viscous_damping": value} | others}))

    def listed(self, *arguments):
        return self.accept("recordings", *arguments, "--json").json()

    def test_a_folder_tells_its_recordings_newest_first(self):
        self.record("old", math.sin)
        self.record("new", math.sin, rows=250, started="2026-03-02T10:00:00Z", tags=["cold", "bearing"], notes="first")
        self.write("new.model.json", "{}")
        new, old = self.listed()["recordings"]
        self.assertEqual((new["file"], new["name"], old["name"]), ("new.csv", "new", "old"))
        self.assertEqual((new["device"], new["simulated"], new["started"]), ("HB-17", False, "2026-03-02T10:00:00Z"))
        self.assertAlmostEqual(new["duration_s"], 2.5)
        self.assertEqual((new["signals"], new["tags"], new["notes"]), (["position", "status"], ["cold", "bearing"], "first"))
        self.assertEqual((new["results"], old["results"], old["notes"]), (["new.model.json"], [], None))
        self.assertEqual((new["gaps"], new["missing_rows"], new["interrupted"]), (0, 0, False))

    def test_a_file_without_a_sidecar_is_listed_without_what_is_not_known(self):
        self.write("alone.csv", "time_s,position_rad\n0,1\n")
        (alone,) = self.listed(".")["recordings"]
        self.assertEqual((alone["started"], alone["device"], alone["duration_s"], alone["signals"]), (None, None, None, []))

    def test_every_word_that_is_searched_for_must_occur(self):
        self.record("cold", math.sin, tags=["winter"])
        self.record("warm", math.sin)
        self.assertEqual([entry["name"] for entry in self.listed("--search", "hb-17 WINTER")["recordings"]], ["cold"])
        self.assertEqual(self.listed("--search", "winter warm")["recordings"], [])

    def test_drift_is_against_the_first_of_the_same_device_and_beyond_both_intervals(self):
        self.identification("b.json", "2026-02-01T00:00:00Z", 3e-3, 1e-4)
        self.identification("a.json", "2026-03-01T00:00:00Z", 2.02e-3, 1e-4)
        self.identification("c.json", "2026-01-01T00:00:00Z", 2e-3, 1e-4)
        self.identification("other.json", "2025-01-01T00:00:00Z", 9e-3, 1e-4, device="HB-99")
        self.identification("given.json", "2026-04-01T00:00:00Z", 4e-3, 0, source="given")
        self.write("gains.json", '{"schema": "halbench.gains/1"}')
        self.write("broken.json", "{")
        found = self.listed()["identifications"]
        self.assertEqual([entry["file"] for entry in found],
                         ["other.json", "c.json", "b.json", "a.json", "given.json"])
        drifts = [entry["parameters"]["viscous_damping"]["drift"] for entry in found]
        self.assertEqual((drifts[0], drifts[1], drifts[4]), (None, None, None))
        # half-widths of 1e-4 both: more than 1.414e-4 is a drift
        self.assertAlmostEqual(drifts[2]["ratio"], 0.5)
        self.assertAlmostEqual(drifts[3]["ratio"], 0.01)
        self.assertEqual((drifts[2]["significant"], drifts[3]["significant"]), (True, False))
        self.assertIsNone(found[1]["parameters"]["inertia"]["value"])

    def test_as_text_it_is_two_tables(self):
        self.record("run", math.sin, tags=["cold"])
        self.identification("a.json", "2026-01-01T00:00:00Z", 2e-3, 1e-4)
        self.identification("b.json", "2026-02-01T00:00:00Z", 3e-3, 1e-4)
        answer = self.accept("recordings")
        self.assertRegex(answer.out, r"run\.csv +2026-03-01T10:00:00Z +1 s +HB-17 +\[cold\]")
        self.assertRegex(answer.out, r"(?s)identified values.*b\.json.*viscous c +0\.003 .*\+50\.00 % drifted")
        self.assertEqual(answer.err, "")

    def test_what_a_killed_program_left_is_marked(self):
        self.write("run.csv.partial", "time_s,position_rad\n0,1\n0.01,2\n")
        (left,) = self.listed()["recordings"]
        self.assertEqual((left["file"], left["name"], left["interrupted"]), ("run.csv.partial", "run", True))
        self.assertIn("interrupted", self.accept("recordings").out)

    def test_an_empty_folder_is_no_error_and_none_is(self):
        self.assertEqual(self.listed()["recordings"], [])
        self.assertEqual(self.accept("recordings").out, "no recordings\n")
        self.refuse(2, "'none' is no folder", "recordings", "none")
        self.write("file", "")
        self.refuse(2, "'file' is no folder", "recordings", "file")


class Retention(Comparing):
    def old(self, name, days, **said):
        self.record(name, math.sin, **({"automatic_name": name} | said))
        when = time.time() - 86400 * days
        started = datetime.datetime.fromtimestamp(when, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
        with open(self.path(f"{name}.meta.json"), encoding="utf-8") as file:
            meta = json.load(file)
        self.write(f"{name}.meta.json", json.dumps(meta | {"started": started}))
        for ending in ("csv", "meta.json"):
            os.utime(self.path(f"{name}.{ending}"), (when, when))

    def files(self):
        return sorted(name for name in os.listdir(self.path(".")) if name.endswith((".csv", ".json")))

    def retain(self, *arguments):
        return self.accept("recordings", *arguments, "--json").json()

    def test_without_a_word_nothing_is_removed(self):
        self.old("a", 40)
        self.old("b", 2)
        before = self.files()
        told = self.retain("--retain", "30d")
        self.assertEqual([(each["file"], each["reason"], each["action"]) for each in told["removals"]], [("a.csv", "days", "none")])
        self.assertEqual((told["recordings"], told["days"], told["limit_bytes"]), (2, 30, None))
        answer = self.accept("recordings", ".", "--retain", "30d")
        self.assertRegex(answer.out, r"would go +a\.csv .*more than 30 days old")
        self.assertIn("nothing was removed", answer.out)
        self.assertEqual(self.files(), before)

    def test_delete_removes_what_was_said_and_says_it(self):
        self.old("a", 40)
        self.old("b", 2)
        self.old("tagged", 50, tags=["keep"])
        self.old("mine", 60, automatic_name="other")
        self.old("own", 60, automatic_name="")
        self.write("foreign.csv", "time_s,x\n0,1\n")
        answer = self.accept("recordings", "--retain", "30d", "--delete", "--json")
        told = answer.json()
        self.assertEqual([(each["file"], each["action"]) for each in told["removals"]], [("a.csv", "delete")])
        self.assertEqual([(each["file"], each["kept_because"]) for each in told["kept"]], [("tagged.csv", "it has tags")])
        self.assertEqual((told["recordings"], told["before_bytes"] - told["after_bytes"]), (3, told["removals"][0]["bytes"]))
        self.assertRegex(answer.err, r"deleted .*a\.csv")
        self.assertEqual(self.files(), sorted(["foreign.csv"] + [f"{name}.{ending}" for name in ("b", "mine", "own", "tagged")
                                                                 for ending in ("csv", "meta.json")]))

    def test_what_was_edited_stays(self):
        self.old("a", 40)
        with open(self.path("a.csv"), "a", encoding="utf-8") as file:
            file.write("9,9,9\n")
        os.utime(self.path("a.csv"), (1.7e9, 1.7e9))
        (removal,) = self.retain("--retain", "1d", "--delete")["removals"]
        self.assertEqual((removal["action"], removal["kept_because"]), ("kept", "'a' is kept: its data were changed"))
        self.assertEqual(self.files(), ["a.csv", "a.meta.json"])

    def test_what_is_recorded_by_a_mask_is_named_counted_and_retained(self):
        for number in ("001", "002"):
            told = self.accept("record", "sim:htm", "--duration", "0.1", "--out-mask", "runs/{device}_{date}_{number}", "--json").json()
            self.assertEqual(told["file"], f"sim-htm-1_1970-01-01_{number}.csv")
            self.assertTrue(os.path.exists(self.path(f"runs/{told['file']}")))
        told = self.retain("runs", "--retain", "1d")
        self.assertEqual((told["recordings"], told["removals"]), (2, []), "of the last 24 hours")
        self.accept("record", "sim:htm", "--duration", "0.1", "--out-mask", "knock.csv")
        self.accept("record", "sim:htm", "--duration", "0.1", "--out-mask", "knock")
        self.accept("record", "sim:htm", "--capture", "hall.a", "--out-mask", "knock")
        self.assertEqual([name for name in self.files() if name.endswith(".csv")], ["knock-2.csv", "knock-3.csv", "knock.csv"])

    def test_wrong_orders_are_refused_with_a_remedy(self):
        self.old("a", 40)
        before = self.files()
        for message, arguments in (("invalid limit '30'", ("--retain", "30")),
                                   ("belong to --retain", ("--delete",)),
                                   ("exclude each other", ("--retain", "30d", "--delete", "--trash")),
                                   ("--search does not go", ("--retain", "30d", "--search", "x")),
                                   ("'none' is no folder", ("none", "--retain", "30d"))):
            self.refuse(2, message, "recordings", *arguments)
        for message, arguments in (("--out is required", ()), ("exclude each other", ("--out", "a.csv", "--out-mask", "b")),
                                   ("character 1: there is no placeholder 'dev'", ("--out-mask", "runs/{dev}")),
                                   ("--out-mask has no {name}", ("--out-mask", "{name}"))):
            self.refuse(2, message, "record", "sim:htm", "--duration", "0.1", *arguments)
        self.assertEqual(self.files(), before)


class Overlays(Comparing):
    def overlay(self, *arguments):
        return self.accept("overlay", *arguments, "--out", "o.csv", "--json").json()

    def rows(self):
        with open(self.path("o.csv"), newline="", encoding="utf-8") as file:
            header, *rows = csv.reader(file)
        return header, [[float(field) if field else None for field in row] for row in rows]

    def test_equal_axes_keep_every_value_and_tell_the_difference(self):
        self.record("one", math.sin, rows=201)
        self.record("two", lambda t: math.sin(t) + 0.1 * t, rows=201)
        told = self.overlay("one.csv", "two.csv", "--signals", "position,status")
        header, rows = self.rows()
        self.assertEqual(header, ["time_s", "one_position_rad", "one_status", "two_position_rad", "two_status"])
        self.assertEqual(len(rows), 201)
        for number, (time_s, one, status, two, _) in enumerate(rows):
            self.assertEqual((time_s, one, status), (number / 100, math.sin(number / 100), number % 3))
            self.assertEqual(two, math.sin(time_s) + 0.1 * time_s)
        first, second = told["runs"]
        self.assertIsNone(first["signals"][0]["difference"])
        difference = second["signals"][0]["difference"]
        # of 0.1 t over 0 ... 2 s: mean 0.1, largest 0.2 at the end; rms from the sum of squares of 0 ... 200
        self.assertAlmostEqual(difference["mean"], 0.1, places=12)
        self.assertAlmostEqual(difference["rms"], 1e-3 * math.sqrt(200 * 401 / 6), places=12)
        self.assertAlmostEqual(difference["largest"], 0.2, places=12)
        self.assertEqual((difference["rows"], difference["largest_at_s"]), (201, 2.0))
        self.assertEqual(second["signals"][1]["difference"]["rms"], 0)
        self.assertEqual(second["signals"][0]["column"], "two_position_rad")

    def test_signals_whose_names_meet_have_a_column_each_as_the_file_names_it(self):
        for run in ("one", "two"):
            self.write(f"{run}.csv", "time_s,a_b,a_b_2\n" + "".join(f"{row / 100},{row},{-row}\n" for row in range(50)))
            with open(self.path(f"{run}.csv"), "rb") as file:
                checksum = hashlib.sha256(file.read()).hexdigest()
            self.write(f"{run}.meta.json", json.dumps({
                "schema": "halbench.recording-meta/1", "sha256": checksum, "halbench": "0", "device": {}, "rows": 50,
                "started": "2026-03-01T10:00:00Z", "period_s": 0.01, "signals": [
                    {"name": "a.b", "column": "a_b", "unit": "", "role": ""},
                    {"name": "a_b", "column": "a_b_2", "unit": "", "role": ""}]}))
        told = self.overlay("one.csv", "two.csv", "--signals", "a.b,a_b")
        header, _ = self.rows()
        columns = [signal["column"] for run in told["runs"] for signal in run["signals"]]
        self.assertEqual(columns, header[1:])
        self.assertEqual(len(set(columns)), 4)

    def test_runs_begin_at_their_marker_and_empty_fields_are_where_nothing_was_recorded(self):
        self.record("one", lambda t: t, markers=[(0.2, "knock"), (0.4, "knock")])
        self.record("two", lambda t: t, start_s=5.0, markers=[(5.5, "knock")])
        told = self.overlay("one.csv", "two.csv", "--signals", "position", "--align", "marker:knock")
        self.assertEqual([run["zero_s"] for run in told["runs"]], [0.2, 5.5])
        self.assertEqual((told["from_s"], told["to_s"], told["rows"]), (-0.5, 0.79, 130))
        _, rows = self.rows()
        at = {round(row[0], 6): row[1:] for row in rows}
        self.assertEqual(at[-0.5], [None, 0.0])
        self.assertEqual(at[0.0], [0.2, 0.5])
        self.assertEqual(at[0.79], [0.99, None])
        self.assertAlmostEqual(told["runs"][1]["signals"][0]["difference"]["mean"], 0.3)

    def test_the_trigger_is_where_a_capture_or_the_record_button_was(self):
        self.record("one", lambda t: t, markers=[(0.1, "record"), (0.3, "trigger")])
        self.record("two", lambda t: t, markers=[(0.5, "record")])
        told = self.overlay("one.csv", "two.csv", "--signals", "position", "--align", "trigger", "--from", "0", "--to", "0.1")
        self.assertEqual([run["zero_s"] for run in told["runs"]], [0.3, 0.5])
        self.assertEqual(told["rows"], 11)

    def test_another_rate_is_drawn_onto_the_finer_axis(self):
        self.record("fine", lambda t: t, rate_hz=1000, rows=1000)
        self.record("coarse", lambda t: 2 * t, rate_hz=100, rows=100)
        told = self.overlay("fine.csv", "coarse.csv", "--signals", "position,status", "--to", "0.5")
        self.assertEqual((told["period_s"], told["rows"]), (0.001, 501))
        _, rows = self.rows()
        for time_s, fine, _, coarse, status in rows:
            self.assertAlmostEqual(fine, time_s, places=12)
            self.assertAlmostEqual(coarse, 2 * time_s, places=12)   # a line is met by lines
            self.assertIn(status, (0, 1, 2))                         # a state has nothing between
        # of t over 0 ... 0.5 s
        self.assertAlmostEqual(told["runs"][1]["signals"][0]["difference"]["largest"], 0.5, places=12)

    def test_a_gap_is_not_bridged(self):
        self.write("gap.csv", "time_s,position_rad\n" + "".join(
            f"{row / 100:.6g},{row}\n" for row in range(50) if not 20 <= row < 30))
        self.record("one", lambda t: t, rows=50)
        told = self.overlay("one.csv", "gap.csv", "--signals", "position")
        _, rows = self.rows()
        self.assertEqual([row[0] for row in rows if row[2] is None], [row / 100 for row in range(20, 30)])
        self.assertEqual(told["runs"][1]["signals"][0]["difference"]["rows"], 40)

    def test_the_overlay_is_a_recording_itself(self):
        for name in ("a,b", "a b"):
            self.record(name, math.sin)
        self.overlay("a,b.csv", "a b.csv", "--signals", "position")
        (listed,) = [entry for entry in self.accept("recordings", "--json").json()["recordings"] if entry["name"] == "o"]
        self.assertEqual(listed["signals"], ["a_b.position", "a_b-2.position"])
        self.accept("convert", "o.csv", "o.mf4", "--signals", "a_b-2.position")
        self.accept("describe", "replay:o.csv")

    def test_runs_without_a_common_time_are_doubtful(self):
        self.record("one", math.sin, markers=[(0.0, "here")])
        self.record("two", math.sin, markers=[(-3.0, "here")])
        told = self.overlay("one.csv", "two.csv", "--signals", "position", "--align", "marker:here")
        self.assertEqual(told["data_quality"]["verdict"], "doubtful")
        self.assertEqual(told["data_quality"]["findings"][0]["code"], "no_common_time")
        self.assertIsNone(told["runs"][1]["signals"][0]["difference"])

    def test_as_text_the_differences_are_told(self):
        self.record("one", lambda t: t)
        self.record("two", lambda t: t + 0.25)
        answer = self.accept("overlay", "one.csv", "two.csv", "--signals", "position", "--out", "o.csv")
        self.assertRegex(answer.out, r"position in rad, against one\n  two +mean 0\.25, rms 0\.25, largest 0\.25 at \S+ s")
        self.assertEqual(answer.err.strip(), "halbench: wrote o.csv (100 rows)")

    def test_equal_recordings_give_equal_bytes(self):
        self.record("one", math.sin)
        self.record("two", math.cos)
        first = (self.overlay("one.csv", "two.csv", "--signals", "position"), self.rows())
        self.assertEqual((self.overlay("one.csv", "two.csv", "--signals", "position"), self.rows()), first)

    def test_what_cannot_be_laid_over_each_other_is_refused(self):
        self.record("one", math.sin, markers=[(0.1, "knock")])
        self.record("two", math.sin)
        self.write("damaged.csv", "time_s,position_rad\n0,x\n")
        both = ("overlay", "one.csv", "two.csv")
        position = ("--signals", "position", "--out", "o.csv")
        self.refuse(2, "two recordings", "overlay", "one.csv", *position)
        self.refuse(2, "--signals", *both, "--out", "o.csv")
        self.refuse(2, "--out", *both, "--signals", "position")
        self.refuse(2, r"one\.csv: .*no signal 'speed'.*position", *both, "--signals", "speed", "--out", "o.csv")
        self.refuse(2, r"'two' has no marker 'knock'", *both, *position, "--align", "marker:knock")
        self.refuse(2, r"'one' has no trigger.*'knock'", *both, *position, "--align", "trigger")
        self.refuse(2, "--align: 'end'.*marker:TEXT", *both, *position, "--align", "end")
        self.refuse(2, "--from: 'soon'", *both, *position, "--from", "soon")
        self.refuse(2, "no row between", *both, *position, "--from", "2", "--to", "1")
        self.refuse(2, "too many numbers", *both, *position, "--to", "1e9")
        self.refuse(2, "cannot read|no such|does not exist", "overlay", "one.csv", "none.csv", *position)
        self.refuse(2, r"damaged\.csv:2:3", "overlay", "one.csv", "damaged.csv", *position)
        self.assert_nothing_left("one.csv", "one.meta.json", "two.csv", "two.meta.json", "damaged.csv")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
