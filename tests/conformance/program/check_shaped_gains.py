"""halbench analyse and tune --gains: controllers that the board's law is not are judged and never applied.

    python3 check_shaped_gains.py build/release/halbench [ShapedGains[.case]]
"""
import csv
import json
import sys
import unittest

import halbench
from halbench import ProgramCase

NOTCH = {"kind": "notch", "frequency_rad_s": 180, "depth_ratio": 0.1, "damping_ratio": 0.5}
LOW_PASS = {"kind": "low-pass", "corner_rad_s": 250, "order": 1}


class ShapedGains(ProgramCase):
    def prepare(self, **shaping):
        self.accept("identify", "sim:htm?seed=3", "--out", "m.json", timeout=110)
        self.accept("tune", "m.json", "--out", "g.json")
        with open(self.path("g.json"), encoding="utf-8") as file:
            document = json.load(file)
        document["gains"] |= shaping
        with open(self.path("s.json"), "w", encoding="utf-8") as file:
            json.dump(document, file)

    def test_are_judged_and_read_back(self):
        self.prepare(setpoint_weights={"b": 0.6}, filter_s={"value": 0.002, "unit": "s"}, filters=[NOTCH, LOW_PASS])
        plain = self.accept("tune", "m.json", "--gains", "g.json", "--json").json()
        shaped = self.accept("tune", "m.json", "--gains", "s.json", "--out", "judged.json", "--json").json()
        self.assertEqual(shaped["gains"]["setpoint_weights"], {"b": 0.6, "c": 0})
        self.assertEqual(shaped["gains"]["filters"], [NOTCH, LOW_PASS])
        self.assertEqual(shaped["gains"]["kp"], plain["gains"]["kp"])
        margins = [document["predicted"]["margins"]["phase_margin_deg"] for document in (plain, shaped)]
        self.assertLess(margins[1], margins[0])  # what the filters cost
        self.assertLess(shaped["proof"]["noise_gain_A_per_rad"], plain["proof"]["noise_gain_A_per_rad"])
        self.assertIn("not_on_board", [finding["code"] for finding in shaped["warnings"]])
        for absent in ("limit_cycles", "disturbance"):
            self.assertIsNone(shaped[absent])
        again = self.accept("analyse", "m.json", "judged.json", "--json").json()
        self.assertEqual(again["margins"], shaped["predicted"]["margins"])
        self.assertEqual(again["robust"], shaped["robust"])
        text = self.accept("tune", "m.json", "--gains", "s.json").out
        for words in ("set-point weights", "b 0.6, c 0", "notch", "corner_rad_s 250"):
            self.assertIn(words, text)

    def test_are_compared_and_written_as_tables(self):
        self.prepare(filters=[LOW_PASS])
        answer = self.accept("analyse", "m.json", "g.json", "--compare", "s.json", "--json").json()
        self.assertLess(answer["compared"][0]["margins"]["phase_margin_deg"], answer["margins"]["phase_margin_deg"])
        self.accept("analyse", "m.json", "s.json", "--bode", "b.csv", "--step", "t.csv", "--poles", "p.csv")
        with open(self.path("t.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["load_angle_rad"] + row["response_p5_rad"] for row in rows}, {""})
        self.assertAlmostEqual(float(rows[-1]["response_rad"]), 1.0, delta=0.1)

    def test_what_the_board_cannot_run_is_refused_before_anything_moves(self):
        self.prepare(filters=[NOTCH])
        for option in (("--apply", "sim:htm?seed=3"), ("--code", "law.c"), ("--picture", "bode=b.svg")):
            self.refuse(2, option[0], "tune", "m.json", "--gains", "s.json", *option)
        self.refuse(2, "--code", "analyse", "m.json", "s.json", "--code", "law.c")
        self.prepare(filters=[NOTCH | {"q": 1}])
        self.refuse(2, r"gains\.filters\[0\]\.q", "analyse", "m.json", "s.json")
        self.prepare(setpoint_weights={"b": 1, "c": 0}, filters=[])  # nothing that the board has not
        self.accept("tune", "m.json", "--gains", "s.json", "--apply", "sim:htm?seed=3")

    def test_an_unstable_one_is_refused(self):
        self.prepare(filters=[LOW_PASS | {"corner_rad_s": 3, "order": 2}])
        answer = self.run_program("tune", "m.json", "--gains", "s.json", "--json")
        self.assertEqual(answer.code, 1)
        self.assertEqual(answer.json()["data_quality"]["verdict"], "refused")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
