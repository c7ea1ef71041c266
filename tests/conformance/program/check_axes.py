"""A device with several axes moves the one that is named, in its own units; a device with one needs no name.

    python3 check_axes.py build/release/halbench [Axes[.case]]
"""
import csv
import json
import os
import sys
import unittest

import halbench
from halbench import ProgramCase

STEP = ("--reference", "step,amplitude_um=1000", "--duration", "1")
TURN = ("--reference", "step,amplitude_mrad=2", "--duration", "1")
MOTOR = ("move", "sim:htm?imperfections=off", "--reference", "step,amplitude_deg=90", "--duration", "0.5")
SIMULATED = "sim:planar?imperfections=off"


class Axes(ProgramCase):
    def moved(self, *arguments):
        answer = self.accept("move", SIMULATED, *arguments, "--json").json()
        self.assertNotIn("figures", answer)
        self.assertEqual(answer["data_quality"]["verdict"], "good")
        self.assertEqual(len(answer["axes"]), 1)
        return answer["axes"][0]

    def test_the_named_axis_moves_in_its_own_units(self):
        for axis, reference, unit, height in (("x", STEP, "m", 1e-3), ("y", STEP, "m", 1e-3), ("phi", TURN, "rad", 2e-3)):
            with self.subTest(axis):
                one = self.moved("--axis", axis, *reference)
                self.assertEqual(one["axis"], axis)
                self.assertIsNone(one["predicted"])
                # A step with the published gains has risen after half a second and ends within 4 % after one: what is
                # left falls with exp(-2.2 t) (planar-theory.md, section 9).
                self.assertLess(one["figures"]["rise_time_s"], 0.5)
                self.assertLess(abs(one["figures"][f"final_error_{unit}"]), 0.04 * height)
                self.assertLess(one["figures"]["overshoot_percent"], 0.5)

    def test_the_other_axes_are_told(self):
        others = self.moved("--axis", "x", *STEP)["cross_axes"]
        self.assertEqual([other["axis"] for other in others], ["y", "phi"])
        self.assertLess(others[0]["peak_m"], 50e-6)
        self.assertLess(others[1]["peak_rad"], 1e-3)

    def test_the_recording_holds_every_axis(self):
        self.moved("--axis", "x", *STEP, "--out", "m.csv")
        with open(self.path("m.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 1001)
        for name in ("position_x_m", "position_y_m", "position_phi_rad", "reference_x_m", "effort_x_N", "current_coil6_A"):
            self.assertIn(name, rows[0])
        risen = float(rows[-1]["reference_x_m"]) - float(rows[-1]["position_x_m"])
        self.assertLess(abs(risen), 4e-5)
        self.assertEqual(len({row["reference_y_m"] for row in rows}), 1)

    def test_text_names_axis_and_units(self):
        answer = self.accept("move", SIMULATED, "--axis", "x", *STEP)
        for words in ("true position of axis x", "measured position of axis x", r"final error +\S+ m\n", r"peak effort +\S+ N\n",
                      r"axis phi, which was to stay\n +largest distance +\S+ rad"):
            self.assertRegex(answer.out, words)

    def test_a_step_of_an_experiment_names_its_axis(self):
        text = '''schema = "halbench.experiment/1"
title = "One axis after the other"
device = "sim:planar?imperfections=off"
[[step]]
kind = "move"
name = "right"
axis = "x"
reference = { shape = "step", amplitude_um = 1000 }
duration_s = 1
[[step]]
kind = "move"
name = "turn"
axis = "phi"
reference = { shape = "step", amplitude_mrad = 2 }
duration_s = 1
[[check]]
quantity = "right.axes.0.figures.overshoot_percent"
max = 1
'''
        self.write("good.toml", text)
        steps = self.accept("run", "good.toml", "--out", "out", "--json").json()["steps"]
        self.assertEqual([step["axes"][0]["axis"] for step in steps], ["x", "phi"])
        for words, changed in (("no axis 'z'", text.replace('"phi"', '"z"')), ("several axes", text.replace('axis = "x"\n', "")),
                               ("axis phi is rotary", text.replace("amplitude_mrad", "amplitude_um")),
                               ("'amplitude_mm' and 'amplitude_um' exclude each other", text.replace("= 1000 ", "= 1000, amplitude_mm = 1 ")),
                               ("not for a device with several axes", text.replace("duration_s = 1", "duration_s = 1\nlock_threshold_deg = 2", 1))):
            with self.subTest(words):
                self.write("bad.toml", changed)
                self.assertRegex(self.run_program("run", "bad.toml", "--out", "bad").err, words)
        self.write("bad.toml", text.replace('"phi"', '"z"'))
        self.refuse(2, "step \"turn\": the device has no axis 'z'", "run", "bad.toml", "--out", "none")    # before the first moves

    def test_what_is_not_clear_is_refused_before_anything_moves(self):
        for words, *arguments in (("several axes", *STEP), ("axis phi is rotary", "--axis", "all", *STEP), ("no axis 'z'", "--axis", "z", *STEP),
                                  ("is linear", "--axis", "x", *TURN), ("axis phi is rotary", "--axis", "phi", *STEP),
                                  ("window of 0.05 m", "--axis", "x", "--reference", "step,amplitude_mm=80", "--duration", "1"),
                                  ("a length with an angle", "--axis", "x", "--reference",
                                   "ramp,rate_mm_s=1,amplitude_deg=1", "--duration", "1")):
            with self.subTest(words):
                self.refuse(2, words, "move", SIMULATED, *arguments, "--out", "m.csv")
        self.assertRegex(self.run_program("move", SIMULATED, *STEP).err, "x, y, phi")
        self.assert_nothing_left()

    def test_one_axis_needs_no_name_and_its_result_is_as_ever(self):
        without, named = self.accept(*MOTOR, "--json"), self.accept(*MOTOR, "--axis", "angle", "--json")
        self.assertEqual(without.out, named.out)
        self.assertIn("final_error_deg", json.loads(without.out)["figures"])
        self.refuse(2, "no axis 'x'", *MOTOR, "--axis", "x")
        self.refuse(2, "axis angle is rotary", "move", "sim:htm", *STEP)

    def test_axes_are_identified_in_one_motion(self):
        answer = self.accept("identify", "sim:planar", "--given", "m=0.64", "--json").json()
        self.assertEqual(answer["schema"], "halbench.axis-model/1")
        self.assertEqual([axis["axis"] for axis in answer["axes"]], ["x", "y", "phi"])
        for pair in ("12", "34", "56"):
            # 3.523 N/A of the windings, gains of the coils within 2 %, not the 3.098 N/A that is published (planar-theory.md, section 5.3)
            self.assertAlmostEqual(answer["constants"][f"force_constant_{pair}"]["value"], 3.523, delta=0.07)
        one = self.accept("identify", "sim:planar", "--axis", "y", "--json").json()
        self.assertEqual([axis["axis"] for axis in one["axes"]], ["y"])
        self.assertIsNone(one["constants"]["inertia"]["value"])
        self.assertRegex(self.accept("identify", "sim:planar").out, r"mass_not_given: .*--given m=0.64")

    def test_frequency_response_is_a_matrix(self):
        quick = ("identify", "sim:planar", "--frequency", "--from-hz", "4", "--to-hz", "40", "--periods", "8")
        answer = self.accept(*quick, "--bode", "b.csv", "--json").json()
        self.assertEqual(answer["schema"], "halbench.axis-frequency/1")
        self.assertEqual([axis["axis"] for axis in answer["axes"]], ["x", "y", "phi"])
        for axis, margin in zip(answer["axes"], (62.8, 62.8, 51.0)):
            # planar-theory.md section 9; the force constant of the windings is 13.7 % larger and moves the margins a little
            self.assertAlmostEqual(axis["margins"]["phase_margin_deg"]["value"], margin, delta=3.0)
            self.assertEqual(axis["margins"]["gain_margin_db"]["withheld"], "no_crossing")
        self.assertEqual(len(answer["points"][0]["plant"]), 3)
        with open(self.path("b.csv"), encoding="utf-8") as file:
            self.assertTrue(file.readline().startswith("frequency_hz,plant_x_x_db"))
        one = self.accept(*quick, "--axis", "phi", "--json").json()
        self.assertEqual([axis["axis"] for axis in one["axes"]], ["phi"])
        for words, *arguments in (("no axis 'z'", "--axis", "z"), ("--base-rad-s", "--base-rad-s", "5"), ("octave", "--from-hz", "4", "--to-hz", "5"),
                                  ("--excitation", "--excitation", "chirp"), ("effort", "--effort-ratio", "0.9")):
            with self.subTest(words):
                self.refuse(2, words, "identify", "sim:planar", "--frequency", *arguments)
        self.refuse(2, "--effort-ratio", "identify", "sim:htm", "--frequency", "--effort-ratio", "0.1")

    def test_chips_are_calibrated_and_nothing_stays_without_consent(self):
        answer = self.accept("calibrate", "sim:planar", "hall", "--json").json()
        self.assertFalse(answer["applied"])
        self.assertIsNone(answer["residual_before_deg"])                         # of a motor's angle
        figures = {name: figure["value"] for name, figure in answer["figures"].items()}
        self.assertLess(figures["error_x_after"], 0.1 * figures["error_x_before"])
        self.assertTrue(self.accept("calibrate", "sim:planar", "all", "--apply", "--json").json()["applied"])

    def test_what_an_axis_does_not_know_is_refused(self):
        for words, *arguments in (("no axis 'z'", "identify", "sim:planar", "--axis", "z"), ("no constant 'J'", "identify", "sim:planar", "--given", "J=1"),
                                  ("are for a motor", "identify", "sim:planar", "--directions", "forward"),
                                  ("no static friction", "calibrate", "sim:planar", "static-friction"),
                                  ("no axis 'x'", "identify", "sim:htm", "--axis", "x"),
                                  ("--axis: the device has no axis 'x'", "identify", "sim:htm", "--relay", "--axis", "x"),
                                  ("frequency response of its axes", "identify", "sim:planar", "--relay", "--axis", "x")):
            with self.subTest(words):
                self.refuse(2, words, *arguments)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
