"""halbench tune and analyse --code, analyse --poles and --compare: what leaves the program for another controller or another tool.

    python3 check_law.py build/release/halbench [Laws|Delays[.case]]

The law's second route is the equation of resources/help/htm-theory.md 8.4, written out below in Python; that of a law with weights and
filters the equation of resources/help/tuning.md, "Shaped loops", each filter by Tustin's substitution in direct form I.
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
from halbench import ProgramCase, product

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
        self.previous = angle
        return self.limited(demand, error, speed, acceleration)

    def limited(self, demand, error, speed, acceleration):
        """With feed-forward and assist; x waits while the current is limited, unless the error leads back."""
        v = self.value
        demand += v("feedforward_inertia") * acceleration + v("feedforward_viscous") * speed
        demand += v("feedforward_coulomb") * max(-1.0, min(1.0, speed / v("feedforward_coulomb_speed")))
        if abs(speed) < v("stiction_speed") and abs(error) > v("stiction_threshold"):
            demand += v("stiction_current") * sign(error)
        current = max(-LIMIT_A, min(LIMIT_A, demand))
        if current == demand or error * demand < 0:
            self.integral += self.period_s * v("ki") * error
        return current


def sampled(numerator, denominator, frequency_rad_s, period_s):
    """Polynomials of s, highest power first, with s = k (z - 1)/(z + 1), k such that the frequency stays where it is."""
    k, order = frequency_rad_s / math.tan(0.5 * frequency_rad_s * period_s), len(denominator) - 1
    answer = []
    for polynomial in (numerator, denominator):
        total = [0.0] * (order + 1)
        for i, factor in enumerate(polynomial):  # of s^(order - i)
            term = [factor * k ** (order - i)]
            for _ in range(order - i):
                term = product(term, [1.0, -1.0])
            for _ in range(i):
                term = product(term, [1.0, 1.0])
            total = [a + b for a, b in zip(total, term)]
        answer.append(total)
    return answer


class Filter:
    """A filter of a file, in direct form I."""
    def __init__(self, entry, period_s):
        kind = entry["kind"]
        w = entry.get("corner_rad_s", entry.get("frequency_rad_s"))
        if kind == "notch":
            z, depth = entry["damping_ratio"], entry["depth_ratio"]
            s = [1.0, 2.0 * depth * z * w, w * w], [1.0, 2.0 * z * w, w * w]
        elif kind == "lead":
            phase = math.radians(entry["phase_deg"])
            root = math.sqrt((1.0 + math.sin(phase)) / (1.0 - math.sin(phase)))
            s = [1.0 / w, 1.0 / root], [1.0 / (root * w), 1.0]
        elif kind == "lag":
            s = [1.0, w], [1.0, w / entry["ratio"]]
        else:
            s = ([0.0, w], [1.0, w]) if entry["order"] == 1 else ([0.0, 0.0, w * w], [1.0, math.sqrt(2.0) * w, w * w])
        self.b, self.a = sampled(*s, w, period_s)
        self.inputs, self.outputs = [0.0] * len(self.b), [0.0] * len(self.b)

    def step(self, value):
        self.inputs = [value] + self.inputs[:-1]
        forced = sum(b * v for b, v in zip(self.b, self.inputs)) - sum(a * v for a, v in zip(self.a[1:], self.outputs))
        self.outputs = [forced / self.a[0]] + self.outputs[:-1]
        return self.outputs[0]


class ShapedLaw(Law):
    """F (Kp (b r - y) + x + D (c r - y)) + feed-forward + assist; x waits while the current is limited, F goes on."""
    def __init__(self, gains):
        super().__init__(gains)
        shaping = gains["gains"]
        self.b, self.c = shaping["setpoint_weights"]["b"], shaping["setpoint_weights"]["c"]
        self.filter_s, self.rate = (shaping["filter_s"] or {"value": 0.0})["value"], 0.0
        self.filters = [Filter(entry, self.period_s) for entry in shaping["filters"]]

    def step(self, angle, ref, speed, acceleration):
        v = self.value
        error, weighted = ref - angle, self.c * ref - angle
        moved = 0.0 if self.previous is None else weighted - self.previous
        seen = self.period_s * (1.0 - self.c) * speed + moved  # of a smooth reference always the speed
        self.rate = (self.filter_s * self.rate + seen) / (self.period_s + self.filter_s)
        demand = v("kp") * (self.b * ref - angle) + self.integral + v("kd") * self.rate
        for each in self.filters:
            demand = each.step(demand)
        self.previous = weighted
        return self.limited(demand, error, speed, acceleration)


SHAPINGS = (
    {"setpoint_weights": {"b": 0.6, "c": 0.3}, "filter_s": {"value": 0.004, "unit": "s"}, "filters": [
        {"kind": "notch", "frequency_rad_s": 180, "depth_ratio": 0.1, "damping_ratio": 0.5},
        {"kind": "low-pass", "corner_rad_s": 250, "order": 2}, {"kind": "lead", "frequency_rad_s": 40, "phase_deg": 15},
        {"kind": "lag", "frequency_rad_s": 2, "ratio": 1.5}]},
    {"setpoint_weights": {"b": 0.6}},  # no filter: the file has no section
    {"filters": [{"kind": "low-pass", "corner_rad_s": 120, "order": 1}]},
)


class Laws(ProgramCase):
    def shaped(self, shaping, **numbers):
        """Model and gains with these weights and filters, as the program reads and writes them."""
        self.accept("identify", "sim:htm?seed=3", "--out", "m.json", timeout=110)
        self.accept("tune", "m.json", "--out", "g.json")
        with open(self.path("g.json"), encoding="utf-8") as file:
            document = json.load(file)
        document["gains"] |= shaping | {name: document["gains"][name] | {"value": value} for name, value in numbers.items()}
        self.write("s.json", json.dumps(document))
        self.run_program("tune", "m.json", "--gains", "s.json", "--out", "judged.json")
        with open(self.path("judged.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_the_code_of_a_shaped_law_is_that_law(self):
        for shaping in SHAPINGS:
            gains = self.shaped(shaping)
            self.run_program("tune", "m.json", "--gains", "s.json", "--code", "law.c")
            self.run_program("analyse", "m.json", "s.json", "--code", "again.c")
            with open(self.path("law.c"), encoding="utf-8") as one, open(self.path("again.c"), encoding="utf-8") as other:
                self.assertEqual(one.read(), other.read())
            library, law, chance = self.compiled(), ShapedLaw(gains), random.Random(1)
            library.start()
            limited = 0
            for row in range(5000):
                ref = 0.3 * math.sin(0.02 * row)
                inputs = (ref + chance.gauss(0.0, 0.01), ref + chance.choice((0.0, 0.02)),
                          chance.choice((0.0, 0.01, -0.01, 0.6 * math.cos(0.02 * row))), chance.gauss(0.0, 1.0))
                expected = law.step(*inputs)
                limited += abs(expected) == LIMIT_A
                # Direct form I in powers of z and sections in z - 1 round otherwise: of some 100 A in the filters a few 1e-13 A, which
                # the lag, whose pole is 0.013 from the circle, sums up a hundredfold.
                self.assertAlmostEqual(library.step(*inputs), expected, delta=1e-9, msg=f"row {row} of {shaping}")
            self.assertTrue(20 < limited < 4950, f"limit and integral are both exercised: {limited}")

    def test_the_code_of_a_shaped_law_moves_the_motor_as_it_was_judged(self):
        """The compiled code in a loop with the exact motor against the program's own step, sample by sample."""
        gains = self.shaped(SHAPINGS[0], stiction_current=0.0)
        self.accept("analyse", "m.json", "s.json", "--code", "law.c", "--step", "step.csv")
        with open(self.path("step.csv"), encoding="utf-8") as file:
            rows = [{key: float(value) for key, value in row.items() if value} for row in csv.DictReader(file)][::10]
        with open(self.path("m.json"), encoding="utf-8") as file:
            ratios = json.load(file)["ratios"]
        a, k, T = ratios["c_over_J"]["value"], ratios["phi_over_J"]["value"], gains["sample_period_s"]
        library, height = self.compiled(), 1e-3  # a small step, which stays within the limit
        library.start()
        library.step(0.0, 0.0, 0.0, 0.0)  # it rested there before
        angle, speed, pending = 0.0, 0.0, [0.0] * int(gains["delay_samples"])
        for number, row in enumerate(rows):
            self.assertAlmostEqual(angle, height * row["response_rad"], delta=1e-12, msg=f"sample {number}")
            pending.append(library.step(angle, height, 0.0, 0.0))
            current = pending.pop(0)
            self.assertAlmostEqual(current, height * row["current_A"], delta=1e-9, msg=f"sample {number}")
            share, final = -math.expm1(-a * T), k * current / a
            angle += final * T + (speed - final) * share / a
            speed += (final - speed) * share
        self.assertGreater(len(rows), 50)

    def compiled(self):
        self.write("wrapper.c", WRAPPER)
        self.count = getattr(self, "count", 0) + 1
        library = self.path(f"law{self.count}.so")  # one that is loaded already would be taken again
        subprocess.run(["cc", "-std=c99", "-pedantic", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wconversion", "-Werror",
                        "-shared", "-fPIC", "-o", library, self.path("wrapper.c")], check=True)
        library = ctypes.CDLL(library)
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


class Delays(ProgramCase):
    """A model knows the delay it was measured with, so that what is promised for it holds on that board."""
    # resources/help/htm-theory.md 9: the motor that is simulated
    DAMPING, INERTIA, TORQUE, PERIOD_S = 1.23e-3, 5.5e-4, 1.43e-2, 0.01

    def phase_margin_deg(self, gains, delay_samples):
        """Of u = Kp e + Ki Ts/(z - 1) e - Kd (1 - 1/z)/Ts psi before the motor and a hold, where |L| is 1 first."""
        a, t = self.DAMPING / self.INERTIA, self.PERIOD_S
        kp, ki, kd = (gains[name]["value"] for name in ("kp", "ki", "kd"))

        def loop(w):
            z = cmath.exp(1j * w * t)
            # hold of phi/J / (s (s + a)): the residues at 0, 0 and -a
            e = math.exp(-a * t)
            plant = self.TORQUE / self.INERTIA * (t / (a * (z - 1)) - (1 - e) / (a * a * (z - e)))
            return (kp + ki * t / (z - 1) + kd * (1 - 1 / z) / t) * plant / z ** delay_samples
        low, high = 1.0, 0.99 * math.pi / t
        for step in range(20000):      # the first crossing, then halving
            w = low + (high - low) * step / 20000
            if abs(loop(w)) < 1:
                below, above = w - (high - low) / 20000, w
                break
        for _ in range(60):
            middle = (below + above) / 2
            below, above = (middle, above) if abs(loop(middle)) > 1 else (below, middle)
        return math.degrees(cmath.phase(loop(above)) % (2 * math.pi) - math.pi)

    def tuned(self, device):
        self.accept("identify", device, "--given", f"J={self.INERTIA}", "--out", "model.json", "--force")
        return self.accept("tune", "model.json", "--method", "recommended", "--json").json()

    def test_promised_margin_is_that_of_a_board_with_the_delay_of_the_model(self):
        for delay_samples in (0, 1):
            told = self.tuned(f"sim:htm?seed=7&delay_samples={delay_samples}")
            promised = told["predicted"]["margins"]["phase_margin_deg"]
            # c and phi come out to 1 %; the phase of the loop turns by less than half a degree with that
            self.assertAlmostEqual(promised, self.phase_margin_deg(told["gains"], delay_samples), delta=0.5)
        gains = self.tuned("sim:htm?seed=7")["gains"]
        self.assertAlmostEqual(self.phase_margin_deg(gains, 0), 37.9, delta=0.5)
        self.assertAlmostEqual(self.phase_margin_deg(gains, 1), 11.7, delta=0.5)

    def test_gains_are_judged_with_the_delay_of_the_model(self):
        self.accept("identify", "sim:htm?seed=7", "--given", f"J={self.INERTIA}", "--out", "model.json")
        self.accept("tune", "model.json", "--method", "recommended", "--out", "gains.json")
        self.accept("identify", "sim:htm?seed=7&delay_samples=1", "--given", f"J={self.INERTIA}", "--out", "late.json")
        judged = self.accept("analyse", "late.json", "gains.json", "--json").json()
        with open(self.path("gains.json"), encoding="utf-8") as file:
            gains = json.load(file)["gains"]
        self.assertAlmostEqual(judged["margins"]["phase_margin_deg"], self.phase_margin_deg(gains, 1), delta=0.5)

    def test_model_of_another_delay_is_applied_to_no_device(self):
        for model, device in ((1, 0), (0, 1)):
            self.accept("identify", f"sim:htm?seed=7&delay_samples={model}", "--given", f"J={self.INERTIA}", "--out",
                        f"model{model}.json")
            refused = self.run_program("tune", f"model{model}.json", "--apply", f"sim:htm?seed=7&delay_samples={device}")
            self.assertEqual(refused.code, 1, refused)
            self.assertIn(f"{model} samples of delay, this device has 0.01 s and {device}", refused.err, refused)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
