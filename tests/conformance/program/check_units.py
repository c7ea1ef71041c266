"""Units that a recording or a result states are believed, and nothing that is there is overwritten.

    python3 check_units.py build/release/halbench [RecordedUnits[.case]]
"""
import csv
import json
import math
import os
import sys
import unittest

import halbench
from halbench import ProgramCase

GIVEN = ("--given", "J=5.5e-4")
SWEEP = ("identify", "sim:htm?seed=7", *GIVEN)


class RecordedUnits(ProgramCase):
    def setUp(self):
        super().setUp()
        self.accept(*SWEEP, "--record", "sweep.csv", "--out", "m.json", timeout=110)
        with open(self.path("sweep.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.rows = [tuple(float(row[name]) for name in ("time_s", "position_rad", "current_command_A")) for row in rows]
        self.plain = self.identified("plain.csv", "position_rad", "current_command_A")

    def table(self, name, position, current, turn=lambda x: x, scale=lambda x: x):
        lines = [f"time_s,{position},{current}"]
        lines += [f"{time!r},{turn(angle)!r},{scale(amps)!r}" for time, angle, amps in self.rows]
        return self.write(name, "\n".join(lines) + "\n")

    def identified(self, name, *columns, **changes):
        self.table(name, *columns, **changes)
        return self.accept("identify", name, *GIVEN, "--json").json()

    def assert_same(self, result):
        """Other digits are written, which the fit may see in the last of its own (1e-6 of an interval of 1e-2)."""
        for name in ("torque_constant", "viscous_damping", "coulomb_friction"):
            one, other = self.plain["parameters"][name], result["parameters"][name]
            self.assertAlmostEqual(other["value"] / one["value"], 1.0, delta=1e-6, msg=name)
            self.assertEqual(other["unit"], one["unit"])
        self.assertEqual(result["data_quality"]["verdict"], self.plain["data_quality"]["verdict"])

    def test_known_columns_in_another_unit_are_converted(self):
        for position, per_radian in (("position_deg", 180 / math.pi), ("position_mrad", 1e3),
                                     ("position_rev", 0.5 / math.pi), ("position [deg]", 180 / math.pi)):
            with self.subTest(position):
                self.assert_same(self.identified("u.csv", position, "current_command_A", turn=lambda x, f=per_radian: x * f))
        self.assert_same(self.identified("u.csv", "position_rad", "current_command_mA", scale=lambda x: x * 1e3))

    def test_the_time_is_converted_too(self):
        for name, per_second in (("time_ms", 1e3), ("time_us", 1e6), ("time [ms]", 1e3), ("time_min", 1 / 60)):
            with self.subTest(name):
                lines = [f"{name},position_deg,current_command_mA"]
                lines += [f"{t * per_second!r},{math.degrees(angle)!r},{amps * 1e3!r}" for t, angle, amps in self.rows]
                self.write("t.csv", "\n".join(lines) + "\n")
                self.assert_same(self.accept("identify", "t.csv", *GIVEN, "--json").json())
        self.write("t.csv", "time_Hz,position_rad,current_command_A\n0,0,0\n1,0,0\n")
        self.refuse(2, "halbench import", "identify", "t.csv")

    def test_another_quantity_is_refused_by_every_reader(self):
        for position in ("position_mm", "position [furlong]", "position_counts", "position_V"):
            self.table("u.csv", position, "current_command_A")
            for reader in (("identify", "u.csv"), ("plot", "u.csv", "--out", "p.svg"), ("convert", "u.csv", "o.mf4"),
                           ("spectrum", "u.csv", "--signal", "current_command", "--out", "s.csv")):
                with self.subTest(f"{reader[0]} {position}"):
                    self.refuse(2, "column 'position", *reader)

    def test_a_column_that_is_missing_is_told_with_those_that_are_there(self):
        for position, name in (("position_furlongs", "position_furlongs"), ("Winkel", "Winkel"), ("pos_rad", "pos")):
            self.table("u.csv", position, "current_command_A")
            with self.subTest(position):
                self.refuse(2, f"present: {name}, current_command", "identify", "u.csv", *GIVEN)

    def test_an_angle_that_wraps_is_put_together_again(self):
        for begin in (0.0, -math.pi):
            result = self.identified("w.csv", "position_rad", "current_command_A",
                                     turn=lambda x, b=begin: (x - b) % (2 * math.pi) + b)
            codes = [finding["code"] for finding in result["data_quality"]["findings"]]
            self.assertIn("angle_wraps", codes)
            self.assertNotIn("plateaus_stopped", codes)
            self.assertEqual(sum(point["used"] for point in result["points"]),
                             sum(point["used"] for point in self.plain["points"]))
            self.assert_same(result)


class StatedUnits(ProgramCase):
    def setUp(self):
        super().setUp()
        self.accept(*SWEEP, "--out", "m.json", timeout=110)
        with open(self.path("m.json"), encoding="utf-8") as file:
            self.model = json.load(file)

    def gains(self, name, kp, ki, kd):
        document = {"schema": "halbench.gains/1", "form": "parallel", "sample_period_s": 0.01, "delay_samples": 0,
                    "gains": {key: {"value": value, "unit": unit}
                              for key, (value, unit) in {"kp": kp, "ki": ki, "kd": kd}.items()}}
        return self.write(name, json.dumps(document))

    def test_gains_per_degree_are_converted(self):
        self.gains("deg.json", (10, "A/deg"), (0.1, "A/(deg*s)"), (0.02, "A*s/deg"))
        turn = 180 / math.pi
        self.gains("rad.json", (10 * turn, "A/rad"), (0.1 * turn, "A/(rad*s)"), (0.02 * turn, "A*s/rad"))
        deg, rad = (self.run_program("analyse", "m.json", name, "--json") for name in ("deg.json", "rad.json"))
        self.assertEqual(deg.code, rad.code)
        self.assertFalse(deg.json()["stable"], "573 A/rad on a motor that 40 A/rad hold")
        self.assertEqual(deg.json()["stable"], rad.json()["stable"])

    def test_another_quantity_is_refused_naming_the_key(self):
        self.gains("g.json", (10, "A"), (1, "A/(rad*s)"), (1, "A*s/rad"))
        self.refuse(2, r"gains\.kp\.unit", "analyse", "m.json", "g.json")
        self.gains("g.json", (10, "A/rad"), (1, "furlong"), (1, "A*s/rad"))
        self.refuse(2, r"gains\.ki\.unit", "analyse", "m.json", "g.json")
        self.model["parameters"]["inertia"]["unit"] = "kg*m"
        self.write("m.json", json.dumps(self.model))
        self.refuse(2, r"parameters\.inertia\.unit", "tune", "m.json")

    def test_a_model_in_other_units_is_the_same_model(self):
        before = self.accept("tune", "m.json", "--json").json()
        for key, unit, factor in (("torque_constant", "mN*m/A", 1e3), ("inertia", "g*cm^2", 1e7)):
            quantity = self.model["parameters"][key]
            quantity.update(value=quantity["value"] * factor, unit=unit, ci95=[x * factor for x in quantity["ci95"]])
        self.write("u.json", json.dumps(self.model))
        after = self.accept("tune", "u.json", "--json").json()
        for name in ("kp", "ki", "kd"):
            self.assertAlmostEqual(after["gains"][name]["value"] / before["gains"][name]["value"], 1.0, delta=1e-9)

    def test_what_identify_writes_is_read_again(self):
        self.accept("identify", "sim:htm?seed=3", "--given", "J=5.5e-4", "--given", "phi=1.5e-2", "--out", "two.json",
                    timeout=110)
        self.accept("tune", "two.json", "--out", "two_gains.json")
        self.accept("identify", "sim:htm?seed=3", "--out", "bare.json", timeout=110)
        self.accept("identify", "sim:htm?seed=3&J=7.5e-4", "--bare", "bare.json", "--added-inertia", "2e-4", "--out",
                    "added.json", timeout=110)
        self.accept("tune", "added.json", "--out", "added_gains.json")

    def test_a_model_that_contradicts_itself_is_refused(self):
        self.model["parameters"]["inertia"]["value"] *= 1.2
        self.write("c.json", json.dumps(self.model))
        self.refuse(2, r"ratios\.c_over_J", "tune", "c.json")


class Overwriting(ProgramCase):
    def test_nothing_is_overwritten_without_force(self):
        self.write("there.csv", "mine\n")
        for command in (("record", "sim:htm", "--duration", "1", "--out", "there.csv"),
                        ("move", "sim:htm", "--reference", "step,amplitude_deg=5", "--duration", "1", "--out", "there.csv"),
                        ("identify", "sim:htm", "--record", "there.csv")):
            self.refuse(2, "there.csv' exists already", *command, is_forced=False)
        with open(self.path("there.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine\n")
        self.accept("record", "sim:htm", "--duration", "1", "--out", "there.csv", "--force", is_forced=False)
        os.remove(self.path("there.csv"))
        self.refuse(2, "there.meta.json' exists already", "record", "sim:htm", "--duration", "1", "--out", "there.csv",
                    is_forced=False)

    def read_octets(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_no_command_replaces_what_it_reads(self):
        self.accept("record", "sim:htm", "--duration", "1", "--out", "run.csv")
        before = self.read_octets("run.csv")
        for words in (("spectrum", "run.csv", "--signal", "position", "--out", "run.csv"),
                      ("identify", "run.csv", "--out", "run.csv")):
            self.assertEqual(self.run_program(*words, is_forced=False).code, 2, words)
            self.assertEqual(self.read_octets("run.csv"), before, words)

    def test_a_folder_of_something_else_takes_no_run(self):
        os.mkdir(self.path("out"))
        self.write("out/thesis.docx", "mine\n")
        experiment = os.path.join(halbench.REPOSITORY, "resources", "experiments", "htm", "tour.toml")
        self.refuse(2, "contains files that are not results", "run", experiment, "--out", "out", is_forced=False)
        self.refuse(2, "contains files that are not results", "run", experiment, "--out", "out")
        self.assert_nothing_left("out/thesis.docx")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
