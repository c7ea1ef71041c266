"""Units that a recording or a result states are believed, and nothing that is there is overwritten.

    python3 check_units.py build/release/halbench [RecordedUnits[.case]]
"""
import csv
import json
import math
import os
import re
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


class MovedUnits(ProgramCase):
    """A recorded move in the units of other programs, in brackets, is the same move to all who read it."""
    SI = {"position": "position_rad", "speed": "speed_rad_s", "reference": "reference_rad",
          "current_command": "current_command_A"}
    OTHER = {"position": ("position [deg]", 180 / math.pi), "speed": ("speed [rpm]", 30 / math.pi),
             "reference": ("reference [deg]", 180 / math.pi),
             "current_command": ("current_command [mA]", 1e3)}

    def setUp(self):
        super().setUp()
        self.accept("move", "sim:htm?seed=3", "--reference", "step,amplitude_deg=28.6", "--duration", "2",
                    "--out", "move.csv")
        with open(self.path("move.csv"), encoding="utf-8") as file:
            self.rows = [{name: float(row[column]) for name, column in (self.SI | {"time": "time_s"}).items()}
                         for row in csv.DictReader(file)]
        self.table("si.csv", {name: (column, 1.0) for name, column in self.SI.items()})
        self.table("other.csv", self.OTHER)

    def table(self, name, columns):
        """Without a sidecar, so that the header alone tells the units."""
        lines = [",".join(["time_s", *(header for header, _ in columns.values())])]
        for row in self.rows:
            values = [row["time"], *(row[name] * factor for name, (_, factor) in columns.items())]
            lines.append(",".join(repr(value) for value in values))
        return self.write(name, "\n".join(lines) + "\n")

    def assert_si(self, name):
        """A file of the program's own has its columns in SI and the values that were moved."""
        with open(self.path(name), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(self.rows))
        for column in rows[0]:
            signal = next((key for key, due in self.SI.items() if column.endswith(due)), None)
            if column != "time_s":
                self.assertIsNotNone(signal, f"{column} is in SI")
                for row, due in zip(rows, self.rows):
                    self.assertAlmostEqual(float(row[column]), due[signal], delta=1e-9, msg=column)
        return list(rows[0])

    def test_laid_over_the_same_in_si_nothing_differs(self):
        answer = self.accept("overlay", "si.csv", "other.csv", "--signals", ",".join(self.SI), "--out",
                             "o.csv", "--json")
        signals = answer.json()["runs"][1]["signals"]
        self.assertEqual(len(signals), 4)
        for signal in signals:
            self.assertLess(signal["difference"]["largest"], 1e-9, signal)
        self.assertEqual(len(self.assert_si("o.csv")), 9)

    def test_what_if_gives_the_same_prediction(self):
        self.accept("identify", "sim:htm?seed=3", "--out", "m.json", timeout=110)
        self.accept("tune", "m.json", "--out", "g.json")
        self.write("ran.json", json.dumps({
            "schema": "halbench.gains/1", "form": "parallel", "sample_period_s": 0.01, "delay_samples": 0,
            "gains": {"kp": {"value": 10, "unit": "A/rad"}, "ki": {"value": 0.1, "unit": "A/(rad*s)"},
                      "kd": {"value": 0, "unit": "A*s/rad"}}}))
        words = ("analyse", "m.json", "g.json", "--ran", "ran.json", "--json", "--what-if")
        si, other = (self.accept(*words, name).json()["what_if"] for name in ("si.csv", "other.csv"))
        self.assertTrue(si["explained"])
        for of in ("recorded", "predicted"):
            for key, value in si[of].items():
                if isinstance(value, float):
                    self.assertAlmostEqual(other[of][key], value, delta=1e-6 * max(1.0, abs(value)), msg=key)
        # A second route: the step ends where the motor stood in the recording.
        error = self.rows[-1]["reference"] - self.rows[-1]["position"]
        self.assertAlmostEqual(abs(other["recorded"]["final_error_rad"]), abs(error), delta=0.01)

    def test_as_a_device_it_has_si_units_and_values(self):
        told = self.accept("describe", "replay:other.csv", "--json").json()
        self.assertEqual({signal["name"]: signal["unit"] for signal in told["signals"]},
                         {"position": "rad", "speed": "rad/s", "reference": "rad", "current_command": "A"})
        rate = round(1 / (self.rows[1]["time"] - self.rows[0]["time"]))
        self.accept("record", "replay:other.csv", "--duration", repr(len(self.rows) / rate), "--rate",
                    str(rate), "--signals", ",".join(self.SI), "--out", "r.csv")
        self.assertEqual(self.assert_si("r.csv"), ["time_s", *self.SI.values()])

    def test_a_chosen_part_is_converted_too(self):
        self.accept("convert", "other.csv", "c.csv", "--signals", "speed,position")
        self.assertEqual(sorted(self.assert_si("c.csv")), ["position_rad", "speed_rad_s", "time_s"])

    def test_another_quantity_is_refused_naming_the_column(self):
        self.accept("identify", "sim:htm?seed=3", "--out", "m.json", timeout=110)
        self.accept("tune", "m.json", "--out", "g.json")
        for signal, header in (("position", "position [V]"), ("speed", "speed [deg]"),
                               ("reference", "reference (A)"), ("current_command", "current_command [rpm]")):
            self.table("wrong.csv", self.OTHER | {signal: (header, 1.0)})
            for words in (("overlay", "si.csv", "wrong.csv", "--signals", "position", "--out", "o.csv"),
                          ("overlay", "wrong.csv", "si.csv", "--signals", "position", "--out", "o.csv"),
                          ("analyse", "m.json", "g.json", "--what-if", "wrong.csv", "--ran", "g.json"),
                          ("describe", "replay:wrong.csv"), ("get", "replay:wrong.csv", "position"),
                          ("record", "replay:wrong.csv", "--duration", "1", "--out", "o.csv")):
                with self.subTest(f"{header}: {words[0]}"):
                    answer = self.refuse(2, "column '" + re.escape(header), *words)
                    self.assertIn("wrong.csv", answer.err)
        self.assertFalse(os.path.exists(self.path("o.csv")))


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


class MeasuredUnits(ProgramCase):
    """What a calibration and a relay experiment state in another unit, and what that makes of a design."""

    def setUp(self):
        super().setUp()
        self.accept(*SWEEP, "--out", "m.json", timeout=110)

    def edit(self, source, name, change):
        with open(self.path(source), encoding="utf-8") as file:
            document = json.load(file)
        change(document)
        self.write(name, json.dumps(document))

    @staticmethod
    def scaled(quantity, factor, unit):
        quantity.update(value=quantity["value"] * factor, unit=unit,
                        ci95=quantity["ci95"] and [end * factor for end in quantity["ci95"]])

    def stray_error(self, name):
        """What the findings of a design with this calibration say of the stray coefficient, in per cent."""
        answer = self.run_program("tune", "m.json", "--calibration", name, "--json")
        said = {finding["code"]: finding["message"] for finding in answer.json()["warnings"]}
        return int(re.search(r"error of the stray coefficient (\d+) %", said["stray_field_error"])[1])

    def test_a_stray_coefficient_in_other_units_is_the_same(self):
        """3 mT/A that may be 1.5 to 4.5 err by half, whatever they are written in."""
        self.accept("calibrate", "sim:htm?seed=7", "stray", "--out", "cal.json", timeout=110)

        def widen(document):
            document["applied"] = True
            document["figures"]["stray.coefficient"].update(value=3e-3, ci95=[1.5e-3, 4.5e-3], unit="T/A")
        self.edit("cal.json", "wide.json", widen)
        self.assertEqual(self.stray_error("wide.json"), 50)
        plain = self.analysed("wide.json")
        for unit, factor in (("mT/A", 1e3), ("uT/A", 1e6), ("uT/mA", 1e3), ("T/mA", 1e-3)):
            with self.subTest(unit):
                self.edit("wide.json", "other.json",
                          lambda d, f=factor, u=unit: self.scaled(d["figures"]["stray.coefficient"], f, u))
                self.assertEqual(self.stray_error("other.json"), 50)
                self.assertEqual(self.analysed("other.json"), plain)

    def analysed(self, calibration):
        self.accept("tune", "m.json", "--out", "g.json")
        return self.run_program("analyse", "m.json", "g.json", "--calibration", calibration, "--json").json()

    def test_another_quantity_in_a_calibration_is_refused_naming_the_key(self):
        self.accept("calibrate", "sim:htm?seed=7", "all", "--out", "cal.json", timeout=110)
        self.accept("tune", "m.json", "--out", "g.json")
        for key, unit in (("stray.coefficient", "T"), ("stray.coefficient", "A/T"), ("hall.offset_a", "A"),
                          ("hall.offset_b", "rad"), ("hall.amplitude", "furlong"), ("hall.quadrature", "T"),
                          ("hall.gain_ratio", "T"), ("angle_error.rms", "mT")):
            self.edit("cal.json", "wrong.json", lambda d, k=key, u=unit: d["figures"][k].update(unit=u))
            for words in (("analyse", "m.json", "g.json"), ("tune", "m.json"),
                          ("tune", "m.json", "--gains", "g.json")):
                with self.subTest(f"{key} {unit} {words}"):
                    self.refuse(2, rf"wrong\.json: \"figures\.{re.escape(key)}\.unit\" is \"{unit}\"", *words,
                                "--calibration", "wrong.json")

    def test_a_calibration_in_other_units_is_read(self):
        self.accept("calibrate", "sim:htm?seed=7", "all", "--out", "cal.json", timeout=110)
        plain = self.analysed("cal.json")
        self.assertEqual(plain["schema"], "halbench.analysis/1")

        def rewrite(document):
            for key, unit, factor in (("stray.coefficient", "mT/A", 1e3), ("hall.offset_a", "mT", 1e3),
                                      ("hall.offset_b", "uT", 1e6), ("hall.amplitude", "mT", 1e3),
                                      ("hall.quadrature", "deg", 180 / math.pi),
                                      ("angle_error.rms", "mrad", 1e3)):
                self.scaled(document["figures"][key], factor, unit)
        self.edit("cal.json", "other.json", rewrite)
        self.assertEqual(self.analysed("other.json"), plain)

    def relay(self):
        """Of this motor: ultimate gain 16 A/rad and period 0.3 s, as round numbers."""
        self.accept("identify", "sim:htm?imperfections=off", "--relay", "--out", "measured.json", timeout=110)

        def round_off(document):
            document["ultimate_gain"].update(value=16.0, ci95=[15.5, 16.5], unit="A/rad")
            document["ultimate_period"].update(value=0.3, ci95=[0.29, 0.31], unit="s")
        self.edit("measured.json", "relay.json", round_off)

    def design(self, name):
        answer = self.run_program("tune", "m.json", "--method", "ziegler-nichols", "--relay", name, "--json")
        return {key: answer.json()["gains"][key]["value"] for key in ("kp", "ki", "kd")}

    def assert_ziegler_nichols(self, name):
        """K_P = 0.6 K_u, T_i = T_u/2, T_d = T_u/8 (tuning.md) for 16 A/rad and 0.3 s."""
        gains = self.design(name)
        for key, due in (("kp", 0.6 * 16), ("ki", 0.6 * 16 / 0.15), ("kd", 0.6 * 16 * 0.0375)):
            self.assertAlmostEqual(gains[key] / due, 1.0, delta=1e-9, msg=key)

    def test_an_ultimate_gain_and_period_in_other_units_give_the_same_design(self):
        self.relay()
        self.assert_ziegler_nichols("relay.json")
        for key, unit, factor in (("ultimate_gain", "A/deg", math.pi / 180), ("ultimate_gain", "mA/rad", 1e3),
                                  ("ultimate_period", "ms", 1e3), ("ultimate_period", "us", 1e6),
                                  ("ultimate_period", "min", 1 / 60)):
            with self.subTest(unit):
                self.edit("relay.json", "other.json",
                          lambda d, k=key, f=factor, u=unit: self.scaled(d[k], f, u))
                self.assert_ziegler_nichols("other.json")

    def test_another_quantity_in_a_relay_experiment_is_refused_naming_the_key(self):
        self.relay()
        for key, unit in (("ultimate_gain", "A"), ("ultimate_gain", "rad/A"), ("ultimate_gain", "furlong"),
                          ("ultimate_period", "Hz"), ("ultimate_period", "rad"), ("ultimate_period", "")):
            with self.subTest(f"{key} {unit}"):
                self.edit("relay.json", "wrong.json", lambda d, k=key, u=unit: d[k].update(unit=u))
                self.refuse(2, rf"wrong\.json: \"{key}\.unit\" is \"{unit}\"", "tune", "m.json", "--method",
                            "ziegler-nichols", "--relay", "wrong.json")


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
