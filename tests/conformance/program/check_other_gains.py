"""halbench analyse --what-if and tune --apply --live: what other gains would do, and how they get onto the board.

    python3 check_other_gains.py build/release/halbench [OtherGains[.case]]
"""
import csv
import json
import sys
import unittest

import halbench
from halbench import ProgramCase

STEP = ("--reference", "step,amplitude_deg=28.6", "--duration", "2")


class OtherGains(ProgramCase):
    def prepare(self):
        self.accept("identify", "sim:htm?seed=3", "--out", "m.json", timeout=110)
        self.accept("tune", "m.json", "--out", "g.json")

    def test_a_recorded_move_with_other_gains(self):
        self.prepare()
        self.accept("move", "sim:htm?seed=3", *STEP, "--out", "move.csv")
        answer = self.accept("analyse", "m.json", "g.json", "--what-if", "move.csv", "--motion", "f.csv", "--json")
        what_if = answer.json()["what_if"]
        self.assertTrue(what_if["explained"])
        # The published gains, with which a simulated motor starts, overshoot; the recommended ones hardly do.
        self.assertLess(what_if["predicted"]["overshoot_rad"], 0.5 * what_if["recorded"]["overshoot_rad"])
        with open(self.path("f.csv"), encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        self.assertEqual(len(rows), 401)
        for row in rows:
            self.assertLessEqual(row["p5_rad"], row["p95_rad"])
        again = self.accept("analyse", "m.json", "g.json", "--what-if", "move.csv", "--json")
        self.assertEqual(again.out, answer.out, "the same seed, the same bytes")
        self.assertIn("the same move with these gains", self.accept("analyse", "m.json", "g.json", "--what-if", "move.csv").out)

    def test_a_move_of_another_motor_says_nothing(self):
        self.prepare()
        self.accept("move", "sim:htm?seed=3&J=1.65e-3", *STEP, "--out", "move.csv")
        answer = self.run_program("analyse", "m.json", "g.json", "--what-if", "move.csv")
        self.assertEqual(answer.code, 1)
        self.assertIn("WITHHELD", answer.out)
        self.assertIn("does not match the recorded move", answer.out)
        document = self.run_program("analyse", "m.json", "g.json", "--what-if", "move.csv", "--json").json()["what_if"]
        self.assertIsNone(document["predicted"])
        self.assertEqual(document["data_quality"]["verdict"], "refused")

    def test_what_is_no_recorded_move_is_refused(self):
        self.prepare()
        self.refuse(2, "--what-if", "analyse", "m.json", "g.json", "--motion", "f.csv")
        self.refuse(2, r"none\.csv", "analyse", "m.json", "g.json", "--what-if", "none.csv")
        self.accept("record", "sim:htm", "--duration", "0.5", "--signals", "hall.a", "--out", "hall.csv")
        self.refuse(2, "position", "analyse", "m.json", "g.json", "--what-if", "hall.csv")

    def test_gains_in_small_steps(self):
        self.prepare()
        answer = self.accept("tune", "m.json", "--apply", "sim:htm?seed=3", "--live", "--json")
        applied = answer.json()["applied"]
        self.assertTrue(applied["kept"])
        self.assertEqual(len(applied["steps"]), applied["planned_steps"])
        self.assertNotIn("other_device", [warning["code"] for warning in answer.json()["warnings"]], "it is the same motor")
        kp = [step["values"][0]["value"] for step in applied["steps"]]
        self.assertEqual(sorted(kp), kp)
        self.assertAlmostEqual(kp[-1], answer.json()["gains"]["kp"]["value"], delta=1e-4)  # single precision
        self.refuse(2, "--apply", "tune", "m.json", "--live")

    def test_gains_of_a_file_are_judged_and_applied_like_designed_ones(self):
        self.prepare()
        designed = self.accept("tune", "m.json", "--apply", "sim:htm?seed=3", "--json")
        from_file = self.accept("tune", "m.json", "--gains", "g.json", "--apply", "sim:htm?seed=3", "--json")
        self.assertEqual(from_file.out, designed.out, "the same gains, the same proof, the same move")
        walked = self.accept("tune", "m.json", "--gains", "g.json", "--apply", "sim:htm?seed=3", "--live", "--json")
        self.assertEqual(walked.json()["applied"]["after"], designed.json()["applied"]["after"])

    def test_gains_of_a_file_that_cannot_be_applied(self):
        self.prepare()
        with open(self.path("g.json"), encoding="utf-8") as file:
            good = json.load(file)
        bad = json.loads(json.dumps(good))
        bad["gains"]["kp"]["value"] = 400.0    # beyond the sampled limit with this K_D: unstable
        self.write("bad.json", json.dumps(bad))
        answer = self.refuse(1, "unstable.*nothing was written", "tune", "m.json", "--gains", "bad.json", "--apply", "sim:htm?seed=3")
        self.assertNotIn("Verif", answer.err)
        shown = self.run_program("tune", "m.json", "--gains", "bad.json", "--json")
        self.assertEqual((shown.code, shown.json()["data_quality"]["verdict"]), (1, "refused"), "shown, not applied")
        for number in ("NaN", "1e999", "null", '"40"'):
            text = json.dumps(good).replace(json.dumps(good["gains"]["kp"]["value"]), number, 1)
            self.write("none.json", text)
            self.refuse(2, r"none\.json", "tune", "m.json", "--gains", "none.json", "--apply", "sim:htm?seed=3")
        self.refuse(2, "--gains.*--method", "tune", "m.json", "--gains", "g.json", "--method", "lqr")
        self.refuse(2, r"lost\.json", "tune", "m.json", "--gains", "lost.json")
        other = json.loads(json.dumps(good))
        other["device"]["id"] = "sim-htm-9"
        self.write("other.json", json.dumps(other))
        told = self.accept("tune", "m.json", "--gains", "other.json", "--json").json()
        self.assertIn("other_device", [warning["code"] for warning in told["warnings"]])
        _, uri = self.serve()
        self.accept("identify", "sim:htm?seed=1", "--out", "n.json", timeout=110)
        self.refuse(2, "sim-htm-9.*--foreign-model", "tune", "n.json", "--gains", "other.json", "--apply", uri, "--arm")

    def test_bands_and_pictures_of_a_loop(self):
        self.prepare()
        answer = self.accept("analyse", "m.json", "g.json", "--bode", "b.csv", "--step", "s.csv", "--disturbance", "1",
                             "--picture", "bode=b.svg", "--picture", "nyquist=n.pdf", "--picture", "disturbance=d.png", "--json")
        load = answer.json()["disturbance"]
        self.assertEqual(load["load_A"], 1)
        half = self.accept("tune", "m.json", "--picture", "root-locus=r.svg", "--json").json()["disturbance"]
        self.assertAlmostEqual(load["peak_rad"], 2 * half["peak_rad"], delta=1e-9)    # linear
        self.assertLess(load["intervals"]["peak_rad"]["p5"], load["peak_rad"])
        self.assertGreater(load["intervals"]["peak_rad"]["p95"], load["peak_rad"])
        for name, value, low, high in (("b.csv", "magnitude_db", "magnitude_p5_db", "magnitude_p95_db"),
                                       ("s.csv", "load_angle_rad", "load_angle_p5_rad", "load_angle_p95_rad")):
            with open(self.path(name), encoding="utf-8") as file:
                rows = [{key: float(text) for key, text in row.items()} for row in csv.DictReader(file)]
            # The estimate lies within nine tenths of the motors that its covariance allows.
            inside = [row[low] - 1e-12 <= row[value] <= row[high] + 1e-12 for row in rows]
            self.assertGreater(sum(inside), 0.95 * len(inside), name)
        for name, begin in (("b.svg", b"<"), ("n.pdf", b"%PDF"), ("d.png", b"\x89PNG"), ("r.svg", b"<")):
            with open(self.path(name), "rb") as file:
                self.assertTrue(file.read(8).startswith(begin), name)
        self.refuse(2, "smith", "analyse", "m.json", "g.json", "--picture", "smith=a.svg")
        self.refuse(2, "--disturbance", "tune", "m.json", "--disturbance", "0")

    def test_a_motor_that_moves_otherwise_keeps_its_gains(self):
        self.prepare()
        answer = self.run_program("tune", "m.json", "--apply", "sim:htm?seed=3&J=1.65e-3", "--live")
        self.assertEqual(answer.code, 1)
        self.assertIn("outside the predicted band", answer.out)
        self.assertIn("not kept, old gains restored", answer.out)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
