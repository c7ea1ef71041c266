"""halbench tune and analyse --code, analyse --poles and --compare: what leaves the program for another controller or another tool.

    python3 check_law.py build/release/halbench [Laws[.case]]

The law's second route is the equation of resources/help/htm-theory.md 8.4, written out below in Python.
"""
import cmath
import csv
import ctypes
import json
import math
import os
import random
import re
import subprocess
import sys
import unittest

import halbench
from halbench import ProgramCase

WRAPPER = """#include "law.c"
static position_law memory;
void start(void) { position_law_start(&memory); }
double step(double angle, double ref, double speed, double acceleration) {
    return position_law_step(&memory, angle, ref, speed, acceleration);
}
"""
LIMIT_A = 4.0  # current.limit of the simulated motor


def sign(value):
    return (value > 0) - (value < 0)


class Law:
    """u = Kp e + x + Kd (r' - (psi[k] - psi[k-1])/Ts) + feed-forward + assist; x waits while u is limited."""
    def __init__(self, gains):
        self.value = lambda name: gains["gains"][name]["value"]
        self.period_s, self.integral, self.previous = gains["sample_period_s"], 0.0, None

    def step(self, angle, ref, speed, acceleration):
        v = self.value
        error, moved = ref - angle, 0.0 if self.previous is None else angle - self.previous
        demand = v("kp") * error + self.integral + v("kd") * (speed - moved / self.period_s)
        demand += v("feedforward_inertia") * acceleration + v("feedforward_viscous") * speed
        demand += v("feedforward_coulomb") * max(-1.0, min(1.0, speed / v("feedforward_coulomb_speed")))
        if abs(speed) < v("stiction_speed") and abs(error) > v("stiction_threshold"):
            demand += v("stiction_current") * sign(error)
        current = max(-LIMIT_A, min(LIMIT_A, demand))
        if current == demand or error * demand < 0:
            self.integral += self.period_s * v("ki") * error
        self.previous = angle
        return current


class Laws(ProgramCase):
    def compiled(self):
        self.write("wrapper.c", WRAPPER)
        subprocess.run(["cc", "-std=c99", "-pedantic", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wconversion", "-Werror",
                        "-shared", "-fPIC", "-o", self.path("law.so"), self.path("wrapper.c")], check=True)
        library = ctypes.CDLL(self.path("law.so"))
        library.step.restype = ctypes.c_double
        library.step.argtypes = [ctypes.c_double] * 4
        return library

    def test_the_code_is_the_law(self):
        gains = self.accept("tune", "sim:htm?seed=3", "--code", "law.c", "--json", timeout=110).json()
        library, law, chance = self.compiled(), Law(gains), random.Random(1)
        library.start()
        limited = 0
        for row in range(5000):
            ref = 0.3 * math.sin(0.02 * row)
            inputs = (ref + chance.gauss(0.0, 0.03), ref, chance.choice((0.0, 0.01, -0.01, 0.6 * math.cos(0.02 * row))),
                      chance.gauss(0.0, 1.0))
            expected = law.step(*inputs)
            limited += abs(expected) == LIMIT_A
            # The same operations in double precision; 5000 sums of the integral round by a few 1e-16 each.
            self.assertAlmostEqual(library.step(*inputs), expected, delta=1e-10, msg=f"row {row}")
        self.assertTrue(50 < limited < 4950, "limit and integral are both exercised")

    def test_both_commands_write_the_same_law(self):
        self.accept("tune", "sim:htm?seed=3", "--code", "law.c", "--out", "gains.json", timeout=110)
        self.accept("identify", "sim:htm?seed=3", "--out", "model.json", timeout=110)
        self.accept("analyse", "model.json", "gains.json", "--code", "again.c", "--poles", "poles.csv", "--step", "step.csv")
        with open(self.path("law.c"), encoding="utf-8") as one, open(self.path("again.c"), encoding="utf-8") as other:
            self.assertEqual(one.read(), other.read())
        self.check_poles()
        self.check_load()

    def check_load(self):
        with open(self.path("step.csv"), encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        with open(self.path("gains.json"), encoding="utf-8") as file:
            gain = json.load(file)["gains"]["kp"]["value"]
        angles = [row["load_angle_rad"] for row in rows]
        self.assertTrue(0.2 * 0.5 / gain < max(angles) < 5 * 0.5 / gain)  # of the order of the load over K_P
        self.assertLess(abs(rows[-1]["load_current_A"] + 0.5), 0.05)  # the law holds the load
        self.assertEqual((rows[0]["load_angle_rad"], rows[0]["load_current_A"]), (0.0, 0.0))

    def check_poles(self):
        with open(self.path("poles.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        place = lambda row: complex(float(row["real"]), float(row["imaginary"]))
        of = lambda kind: [place(row) for row in rows if row["kind"] == kind]
        closed = of("closed")
        self.assertTrue(closed and all(abs(pole) < 1.0 for pole in closed))
        for pole in closed:  # each is a root of prod(z - open) + k prod(z - zero): k is the same number for all
            num, den = 1.0 + 0.0j, 1.0 + 0.0j
            for zero in of("zero"):
                num *= pole - zero
            for start in of("open"):
                den *= pole - start
            ratio = -den / num
            self.first = getattr(self, "first", ratio)
            self.assertLess(abs(ratio - self.first) / abs(self.first), 1e-5, f"{pole}")  # roots of a cluster near 1
            self.assertLess(abs(cmath.phase(ratio)), 1e-5)
        starts = [place(row) for row in rows if row["kind"] == "locus" and float(row["gain_factor"]) == 0.0]
        self.assertEqual(len(starts), len(of("open")))

    def test_gains_compared_are_what_each_is_alone(self):
        self.accept("identify", "sim:htm?seed=3", "--out", "model.json", timeout=110)
        files = {}
        for method in ("recommended", "pole-placement", "lambda"):
            files[method] = f"{method}.json"
            self.run_program("tune", "model.json", "--method", method, "--out", files[method])
        own = lambda answer: {key: value for key, value in answer.json().items() if key not in ("compared", "gains_file", "method")}
        alone = {method: self.run_program("analyse", "model.json", file, "--json") for method, file in files.items()}
        together = self.run_program("analyse", "model.json", files["lambda"], "--compare", files["recommended"],
                                    "--compare", files["pole-placement"], "--json")
        self.assertEqual(together.code, max(answer.code for answer in alone.values()))
        self.assertEqual(own(together), own(alone["lambda"]))
        document = together.json()
        self.assertEqual([entry["method"] for entry in document["compared"]], ["recommended", "pole-placement"])
        for entry in document["compared"]:
            same = own(alone[entry["method"]])
            self.assertEqual({key: entry[key] for key in entry if key not in ("gains_file", "method")},
                             {key: same[key] for key in same if key in entry})
        table = self.run_program("analyse", "model.json", files["lambda"], "--compare", files["recommended"]).out
        margin = f"{alone['recommended'].json()['margins']['phase_margin_deg']:.5g}"
        self.assertRegex(table, rf"\n  phase margin \[deg\] +\S+ +{re.escape(margin)}\n")
        self.refuse(2, r"none\.json", "analyse", "model.json", files["lambda"], "--compare", "none.json")

    def test_a_file_that_cannot_be_written_is_named(self):
        os.mkdir(self.path("law.c"))
        self.refuse(2, r"law\.c: cannot write", "tune", "sim:htm?seed=3", "--code", "law.c", timeout=110)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
