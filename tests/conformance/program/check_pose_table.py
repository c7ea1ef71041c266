"""Paths from a table of poses: what is read, what is refused with its place, what the result holds.

    python3 check_pose_table.py build/release/halbench [PoseTables[.case]]
"""
import csv
import json
import sys
import unittest

import halbench
from halbench import ProgramCase

SIMULATED = "sim:planar?imperfections=off"
TIMED = "time_s,x_mm,y_mm,phi_mrad\n0,0,0,0\n1,2,1,0.5\n2,2,1,0.5\n3.5,0,0,0\n"
VISITED = "x_mm;y_mm\r\n1,5;0\r\n1,5;-1\r\n"
LIMITS = ",rate_mm_s=20,acceleration_m_s2=0.5,jerk_m_s3=20,dwell_s=0.5"
EXPERIMENT = '''schema = "halbench.experiment/1"
title = "Poses"
device = "sim:planar?imperfections=off"

[[step]]
kind = "move"
name = "scan"
reference = { shape = "table", file = "poses.csv", rate_mm_s = 50, rate_mrad_s = 50 }

[[check]]
quantity = "scan.axes.0.figures.rms_error_m"
max = 1e-4
'''


class PoseTables(ProgramCase):
    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8", newline="") as file:
            file.write(text)
        return self.path(name)

    def refuse_table(self, text, pattern, keys=""):
        self.write("poses.csv", text)
        with self.subTest(text=text[:60], keys=keys):
            self.refuse(2, pattern, "move", SIMULATED, "--reference", "table,file=poses.csv" + keys, "--out", "m.csv", "--quiet")

    def test_timed_poses_are_reached_and_told(self):
        self.write("poses.csv", TIMED)
        answer = self.accept("move", SIMULATED, "--reference", "table,file=poses.csv", "--out", "m.csv", "--json")
        self.assertRegex(answer.err, r"the table takes 3\.500 s")
        result = answer.json()
        self.assertEqual(result["data_quality"]["verdict"], "good")
        self.assertEqual([axis["axis"] for axis in result["axes"]], ["x", "y", "phi"])
        self.assertEqual(result["axes"][0]["figures"]["travel_s"], 3.5)
        rows = result["axes"][0]["figures"]["rows"]
        self.assertEqual([row["line"] for row in rows], [2, 3, 4, 5])
        self.assertEqual([row["arrival_s"] for row in rows], [0, 1, 2, 3.5])
        self.assertIsNotNone(rows[1]["settling_time_s"])  # a pause of a second follows
        self.assertGreater(result["contour"]["peak_m"], 0)
        self.assertGreaterEqual(result["contour"]["peak_m"], result["contour"]["rms_m"])
        with open(self.path("m.csv"), encoding="utf-8") as file:
            recorded = list(csv.DictReader(file))
        # The board's own reference: the pose of the file, a second after the start; single precision.
        for name, pose in (("reference_x_m", 2e-3), ("reference_y_m", 1e-3), ("reference_phi_rad", 0.5e-3)):
            self.assertAlmostEqual(float(recorded[1000][name]) - float(recorded[-1][name]), pose, delta=1e-8)
            self.assertAlmostEqual(float(recorded[1500][name]) - float(recorded[1000][name]), 0, delta=1e-9)

    def test_text_tells_rows_and_contour(self):
        self.write("poses.csv", TIMED)
        out = self.accept("move", SIMULATED, "--reference", "table,file=poses.csv").out
        self.assertIn("distance from the path", out)
        self.assertIn("true position of axis x", out)
        self.assertIn("true position of axis phi", out)
        self.assertRegex(out, r"4 rows of the table, axis x\n +largest error +\S+ m\n")

    def test_rows_without_times_are_visited(self):
        self.write("poses.csv", VISITED)
        answer = self.accept("move", SIMULATED, "--reference", "table,file=poses.csv" + LIMITS, "--json")
        # d/v + v/a + a/j of 1.5 mm and of 1 mm, which is too short for 20 mm/s: 2 (T_j + T_a) + 2 T_j with
        # a (T_j + T_a)(2 T_j + T_a) = d (planar-theory.md, 9.1); and the dwell.
        jerk_s = 0.5 / 20
        hold_s = ((jerk_s ** 2 + 4 * 1e-3 / 0.5) ** 0.5 - 3 * jerk_s) / 2
        expected = 1.5e-3 / 0.02 + 0.02 / 0.5 + jerk_s + 0.5 + 4 * jerk_s + 2 * hold_s
        result = answer.json()
        self.assertAlmostEqual(result["axes"][0]["figures"]["travel_s"], expected, delta=1e-9)
        self.assertEqual([axis["axis"] for axis in result["axes"]], ["x", "y"])
        self.assertEqual([other["axis"] for other in result["axes"][0]["cross_axes"]], ["phi"])

    def test_every_mistake_names_its_place(self):
        for text, pattern in (("", r"poses\.csv:1:1: the file is empty"),
                              ("x_mm\n1\n", r"poses\.csv:2:1: the table has one row only"),
                              ("x_mm,y_mm\n1,2\n1,NaN\n", r"poses\.csv:3:3: 'NaN'"),
                              ("x_mm,y_mm\n1,2\n-Inf,1\n", r"poses\.csv:3:1: '-Inf'"),
                              ("x_mm,y_mm\n1,2\none,1\n", r"poses\.csv:3:1: 'one'"),
                              ("time_s,x_mm\n1,1\n1,2\n", r"poses\.csv:3:1: time 1 s comes after 1 s"),
                              ("x_mm,x_m\n1,1\n2,2\n", r"axis x is given twice"),
                              ("x_mm,z_mm\n1,1\n2,2\n", r"poses\.csv:1:6: the device has no axis 'z'.*x, y, phi"),
                              ("x_kg\n1\n2\n", r"'kg' is no unit"),
                              ("x_mrad\n1\n2\n", r"axis x is in m, not in rad"),
                              ("x_mm\n5\n60\n", r"poses\.csv:3: row 2: axis x goes as far as 0\.06 m.*0\.05 m \(window\.x\)"),
                              ("x_mm;y_mm\n1,2\n3,4\n", r"1 cells, but the header has 2 columns")):
            self.refuse_table(text, pattern, ",rate_mm_s=20,acceleration_m_s2=0.5,rate_mrad_s=9,acceleration_rad_s2=1")
        self.refuse_table("x_mm\n1\n2\n", r"needs rate_m_s")
        self.refuse_table("time_s,x_mm\n0,1\n2,2\n", r"poses\.csv:2: at time 0 the pose is not 0")
        self.refuse_table("time_s,x_mm\n1,1\n2,1\n2.05,30\n", r"poses\.csv:4: row 3: axis x moves at .* m/s, the limit is 0\.4 m/s \(window\.speed\)")
        self.refuse_table(TIMED, r"row 2: axis x moves at .*the limit is 0\.003 m/s", ",rate_mm_s=3")
        self.refuse_table("time_s,x_mm\n" + "".join(f"{i + 1},{i % 2}\n" for i in range(600)), r"602 pieces, the board has room for 512")
        self.refuse(2, r"poses", "move", SIMULATED, "--reference", "table,file=missing_poses.csv")
        self.refuse(2, r"needs file", "move", SIMULATED, "--reference", "table")
        self.write("poses.csv", TIMED)
        self.refuse(2, r"[Nn]ame no axis", "move", SIMULATED, "--axis", "x", "--reference", "table,file=poses.csv", "--quiet")

    def test_a_motor_refuses(self):
        self.write("poses.csv", "time_s,angle_deg\n1,5\n2,0\n")
        self.refuse(2, r"follows no table of poses", "move", "sim:htm", "--reference", "table,file=poses.csv", "--quiet")

    def test_the_table_is_never_overwritten(self):
        path = self.write("poses.csv", TIMED)
        for reference in ("table,file=poses.csv", "table,file=poses.csv,rate_mm_s=50", "table,rate_mm_s=50,file=" + path):
            self.refuse(2, r"would overwrite", "move", SIMULATED, "--reference", reference, "--out", "poses.csv", "--force")
        with open(path, encoding="utf-8") as file:
            self.assertEqual(file.read(), TIMED)

    def test_a_settling_window_is_of_its_own_quantity(self):
        self.write("poses.csv", TIMED)
        settling = []
        for window in ("settled_um = 50", "settled_m = 1e-9"):  # as radians the second would never be kept
            self.write("scan.toml", EXPERIMENT.replace('name = "scan"', 'name = "scan"\nrepeat = 1\n' + window))
            self.accept("run", "scan.toml", "--out", "out", "--force")
            with open(self.path("out/result.json"), encoding="utf-8") as file:
                axes = json.load(file)["steps"][0]["axes"]
            settling.append([row["settling_time_s"] for row in axes[2]["figures"]["rows"]])
        self.write("scan.toml", EXPERIMENT)
        self.accept("run", "scan.toml", "--out", "out", "--force")
        with open(self.path("out/result.json"), encoding="utf-8") as file:
            axes = json.load(file)["steps"][0]["axes"]
        # 2 % of the way, as without a window.
        self.assertEqual(settling, 2 * [[row["settling_time_s"] for row in axes[2]["figures"]["rows"]]])
        self.write("poses.csv", "time_s,phi_mrad\n1,0.5\n2,0.5\n3,0\n")
        self.write("scan.toml", EXPERIMENT.replace('name = "scan"', 'name = "scan"\nrepeat = 1\nsettled_urad = 50')
                   .replace("rms_error_m", "rms_error_rad"))
        self.accept("run", "scan.toml", "--out", "out", "--force")

    def test_an_experiment_takes_it_too(self):
        self.write("poses.csv", TIMED)
        self.write("scan.toml", EXPERIMENT)
        self.accept("run", "scan.toml", "--out", "out")
        with open(self.path("out/result.json"), encoding="utf-8") as file:
            result = json.load(file)
        self.assertTrue(result["passed"])
        self.write("scan.toml", EXPERIMENT.replace("rate_mm_s = 50", "rate_mm_s = 1"))
        self.refuse(2, r"scan\.toml:\d+:\d+: poses\.csv:3: row 2: axis x moves at", "run", "scan.toml", "--out", "other")
        for key, pattern in (("repeat = 2\nalternate = true", r"does not alternate its direction"), ("repeat = 2\nsettled_deg = 1", r"'settled_deg' is no unit of axis x")):
            self.write("scan.toml", EXPERIMENT.replace('name = "scan"', 'name = "scan"\n' + key))
            self.refuse(2, r"scan\.toml:\d+:\d+: .*" + pattern, "run", "scan.toml", "--out", "other")
        self.write("scan.toml", EXPERIMENT.replace('"poses.csv"', '"out/poses.csv"'))
        self.write("out/poses.csv", TIMED)
        self.refuse(2, r"which this command reads", "run", "scan.toml", "--out", "out", "--force")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
