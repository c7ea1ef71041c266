"""halbench analyse and tune --gains: laws with set-point weights and filters are judged, applied and
restored; which way the gain of a loop has to go.

    python3 check_filtered_gains.py build/release/halbench [ShapedGains|GainLimits[.case]]
"""
import csv
import json
import math
import sys
import unittest

import halbench
from halbench import ProgramCase, product

NOTCH = {"kind": "notch", "frequency_rad_s": 180, "depth_ratio": 0.1, "damping_ratio": 0.5}
LOW_PASS = {"kind": "low-pass", "corner_rad_s": 250, "order": 1}


class ShapedGains(ProgramCase):
    def prepare(self, **shaping):
        self.accept("identify", "sim:htm?seed=1", "--out", "m.json", timeout=110)
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
        self.assertIn("needs_filtered_law", [finding["code"] for finding in shaped["warnings"]])
        # The load finds the same integral; what the filters cost of damping it pays in its peak.
        peaks = [document["disturbance"]["peak_rad"] for document in (plain, shaped)]
        self.assertTrue(peaks[0] < peaks[1] < 2 * peaks[0], peaks)
        self.assertEqual(shaped["disturbance"]["final_rad"], 0)
        self.assertIsNotNone(shaped["disturbance"]["intervals"])
        self.assertGreater(shaped["predicted"]["large_step"]["settling_time_s"], 0)
        again = self.accept("analyse", "m.json", "judged.json", "--json").json()
        self.assertEqual(again["margins"], shaped["predicted"]["margins"])
        self.assertEqual(again["robust"], shaped["robust"])
        text = self.accept("tune", "m.json", "--gains", "s.json").out
        for words in ("set-point weights", "b 0.6, c 0", "notch", "corner_rad_s 250"):
            self.assertIn(words, text)

    def test_a_loop_that_no_gain_makes_stable_has_no_gain_margin(self):
        """K_I/K_P above c/J = 2.24 1/s without derivative: unstable at every gain by Routh's criterion (s^3 + c/J s^2 +
        phi/J K_P s + phi/J K_I), and holding and sampling only add delay."""
        for proportional, integral in ((1, 200), (0.1, 50), (2, 16), (0.3, 3)):
            self.prepare(kp={"value": proportional, "unit": "A/rad"}, ki={"value": integral, "unit": "A/(rad*s)"},
                         kd={"value": 0, "unit": "A*s/rad"})
            with self.subTest(f"{proportional} {integral}"):
                judged = self.run_program("analyse", "m.json", "s.json", "--json").json()
                self.assertFalse(judged["stable"])
                self.assertEqual(judged["data_quality"]["verdict"], "doubtful")
                self.assertIsNone(judged["margins"]["gain_margin_ratio"])
                self.assertIsNone(judged["margins"]["gain_limit"])
                self.assertEqual(judged["margins"]["delay_margin_s"], 0, "an unstable loop bears no delay")
                self.assertIsNone(judged["robust"]["gain_margin_ratio_p5"])
                self.assertIsNone(judged["robust"]["intervals"]["gain_margin_ratio"])
                self.assertEqual(judged["robust"]["unstable_fraction"], 1)
                text = self.run_program("analyse", "m.json", "s.json").out
                self.assertNotIn("inf times the limit", text)
                self.assertEqual([line for line in text.splitlines() if line.startswith("gain margin")], [])
                self.assertIn("gain margin none", self.run_program("tune", "m.json", "--gains", "s.json").out)

    def columns(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return {key: [float(row[key]) for row in rows] for key in rows[0]}

    def test_are_compared_and_written_as_tables_with_their_bands(self):
        self.prepare(filters=[LOW_PASS])
        answer = self.accept("analyse", "m.json", "g.json", "--compare", "s.json", "--json").json()
        self.assertLess(answer["compared"][0]["margins"]["phase_margin_deg"], answer["margins"]["phase_margin_deg"])
        self.accept("analyse", "m.json", "s.json", "--bode", "b.csv", "--step", "t.csv", "--poles", "p.csv")
        step, bode = self.columns("t.csv"), self.columns("b.csv")
        self.assertAlmostEqual(step["response_rad"][-1], 1.0, delta=0.1)
        self.assertAlmostEqual(step["load_current_A"][-1], -0.5, delta=0.05)  # the law holds the load
        inside = lambda table, low, what, high: sum(
            l - 1e-12 <= value <= h + 1e-12 for l, value, h in zip(table[low], table[what], table[high])) / len(table[what])
        # The motor that was identified lies among those that the data allow, if not everywhere within nine tenths of them.
        self.assertGreater(inside(bode, "magnitude_p5_db", "magnitude_db", "magnitude_p95_db"), 0.9)
        self.assertGreater(inside(step, "response_p5_rad", "response_rad", "response_p95_rad"), 0.6)
        self.assertGreater(inside(step, "load_angle_p5_rad", "load_angle_rad", "load_angle_p95_rad"), 0.6)

    def test_every_picture_is_drawn(self):
        self.prepare(setpoint_weights={"b": 0.6}, filters=[LOW_PASS])
        views = ("bode", "nyquist", "nichols", "sensitivity", "root-locus", "step", "large-step", "disturbance")
        options = [f"--picture={view}={view}.svg" for view in views]
        self.accept("analyse", "m.json", "s.json", "--compare", "g.json", *options)
        drawn = {}
        for view in views:
            with open(self.path(f"{view}.svg"), encoding="utf-8") as file:
                drawn[view] = file.read()
            self.assertIn("<svg", drawn[view])
        self.accept("tune", "m.json", "--gains", "s.json", "--picture", "step=again.svg")
        self.accept("analyse", "m.json", "g.json", "--picture", "step=board.svg")
        with open(self.path("board.svg"), encoding="utf-8") as file:
            self.assertNotEqual(file.read(), drawn["step"])

    def test_are_applied_verified_and_taken_out_again(self):
        self.prepare(setpoint_weights={"b": 0.7}, filter_s={"value": 0.002, "unit": "s"}, filters=[NOTCH, LOW_PASS])
        applied = self.accept("tune", "m.json", "--gains", "s.json", "--apply", "sim:htm?seed=1", "--json").json()
        self.assertTrue(applied["applied"]["kept"])
        self.assertNotIn("needs_filtered_law", [finding["code"] for finding in applied["warnings"]])  # answered
        after = {value["name"]: value["value"] for value in applied["applied"]["after"]}
        self.assertAlmostEqual(after["gain.reference_weight"], 0.7, delta=1e-6)
        self.assertAlmostEqual(after["gain.derivative_filter"], 0.002, delta=1e-9)
        # The low-pass by Tustin's rule, pre-warped: with t = tan(w T/2), (t d + 2 t)/((1 + t) d + 2 t) in d = z - 1.
        t = math.tan(0.5 * 250 * 0.01)
        for name, value in {"b0": t / (1 + t), "b1": 2 * t / (1 + t), "b2": 0, "a1": 2 * t / (1 + t), "a2": 0}.items():
            self.assertAlmostEqual(after[f"filter.2.{name}"], value, delta=1e-6)
        self.assertEqual((after["filter.3.b0"], after["filter.3.a1"]), (1, 0))
        _, served = self.serve()
        for gains, weight, pole in (("s.json", 0.7, True), ("g.json", 1, False)):
            self.accept("tune", "m.json", "--gains", gains, "--apply", served, "--arm")
            values = self.accept("get", served, "gain.reference_weight", "filter.1.a1", "--json").json()["values"]
            self.assertAlmostEqual(values[0]["value"], weight, delta=1e-6)
            self.assertEqual(values[1]["value"] > 0, pole)

    def test_what_cannot_be_is_refused_before_anything_moves(self):
        self.prepare(filters=[NOTCH])
        self.refuse(2, "--live", "tune", "m.json", "--gains", "s.json", "--apply", "sim:htm?seed=1", "--live")
        self.prepare(filters=[NOTCH] * 5)
        self.refuse(2, "5 filters exceed the maximum of 4", "tune", "m.json", "--gains", "s.json", "--apply", "sim:htm?seed=1")
        self.prepare(filters=[NOTCH | {"q": 1}])
        self.refuse(2, r"gains\.filters\[0\]\.q", "analyse", "m.json", "s.json")
        unstable = {"kind": "section", "b0": 1, "b1": 0, "b2": 0.1, "a1": 0.1, "a2": 0.2}
        self.prepare(filters=[unstable])
        self.refuse(2, "not stable", "tune", "m.json", "--gains", "s.json", "--apply", "sim:htm?seed=1")

    def test_a_section_is_the_filter_that_it_was_made_of(self):
        t = math.tan(0.5 * 250 * 0.01)
        section = {"kind": "section", "b0": t / (1 + t), "b1": 2 * t / (1 + t), "b2": 0, "a1": 2 * t / (1 + t), "a2": 0}
        self.prepare(filters=[LOW_PASS])
        named = self.accept("analyse", "m.json", "s.json", "--json").json()
        self.prepare(filters=[section])
        given = self.accept("analyse", "m.json", "s.json", "--json").json()
        for margin in ("phase_margin_deg", "gain_margin_ratio", "modulus_margin"):
            self.assertAlmostEqual(given["margins"][margin] / named["margins"][margin], 1, delta=1e-9, msg=margin)

    def test_an_unstable_one_is_refused(self):
        self.prepare(filters=[LOW_PASS | {"corner_rad_s": 3, "order": 2}])
        answer = self.run_program("tune", "m.json", "--gains", "s.json", "--json")
        self.assertEqual(answer.code, 1)
        self.assertEqual(answer.json()["data_quality"]["verdict"], "refused")


def total(one, other):
    size = max(len(one), len(other))
    return [a + b for a, b in zip([0.0] * (size - len(one)) + one, [0.0] * (size - len(other)) + other)]


def are_roots_inside(polynomial):
    """Schur's and Cohn's recursion, highest power first: whether every root is inside the unit circle."""
    while len(polynomial) > 1:
        if abs(polynomial[-1]) >= abs(polynomial[0]):
            return False
        share = polynomial[-1] / polynomial[0]
        polynomial = [a - share * b for a, b in zip(polynomial, reversed(polynomial))][:-1]
    return True


class Loop:
    """The published motor (htm-theory.md), its current held, under K_P + T K_I/(z-1) + K_D (z-1)/(T z)."""
    C, PHI, J, T = 1.23e-3, 1.43e-2, 5.5e-4, 0.01

    def __init__(self, kp, ki, kd, delay):
        damping, push = self.C / self.J, self.PHI / self.J
        decay = math.exp(-damping * self.T)
        rest = damping * self.T - 1.0 + decay
        plant = [push / damping ** 2 * b for b in (rest, 1.0 - decay - damping * self.T * decay)]
        law, self.poles = [kp], [1.0, -(1.0 + decay), decay] + [0.0] * delay
        for top, bottom in (([self.T * ki], [1.0, -1.0]), ([kd / self.T, -kd / self.T], [1.0, 0.0])):
            if any(top):
                law = total(product(law, bottom), product(top, self.denominator(law, kp, ki, kd, bottom)))
                self.poles = product(self.poles, bottom)
        self.zeros = product(law, plant)

    @staticmethod
    def denominator(law, kp, ki, kd, bottom):
        """Of the law so far: that of the integral, when the derivative comes behind it."""
        return [1.0, -1.0] if ki and kd and bottom == [1.0, 0.0] else [1.0]

    def is_stable(self, gain=1.0):
        return are_roots_inside(total(self.poles, [gain * zero for zero in self.zeros]))

    def nearest_limit(self):
        """The factor nearest to 1 at which stability changes, each end of a change found by halving."""
        grid = [10.0 ** (exponent / 200.0) for exponent in range(-600, 601)]
        changes = []
        for low, high in zip(grid, grid[1:]):
            begin = self.is_stable(low)
            if begin != self.is_stable(high):
                for _ in range(60):
                    middle = math.sqrt(low * high)
                    low, high = (middle, high) if self.is_stable(middle) == begin else (low, middle)
                changes.append(low)
        return min(changes, key=lambda factor: abs(math.log(factor)))


class GainLimits(ProgramCase):
    def model(self, delay):
        self.accept("identify", "sim:htm?seed=1", "--given", "J=5.5e-4", "--out", "m.json", timeout=110)
        with open(self.path("m.json"), encoding="utf-8") as file:
            model = json.load(file)
        c, phi, inertia, friction = Loop.C, Loop.PHI, Loop.J, 2.05e-2
        parameters = {"viscous_damping": c, "torque_constant": phi, "inertia": inertia,
                      "coulomb_friction": friction}
        ratios = {"c_over_J": c / inertia, "phi_over_J": phi / inertia, "Kf_over_J": friction / inertia,
                  "c_over_phi": c / phi, "Kf_over_phi": friction / phi}
        for group, values in (("parameters", parameters), ("ratios", ratios)):
            for name, value in values.items():
                model[group][name] |= {"value": value, "ci95": None}
        model |= {"delay_samples": delay, "sample_period_s": Loop.T}
        self.write("m.json", json.dumps(model))

    def judged(self, kp, ki, kd, delay):
        self.write("g.json", json.dumps({
            "schema": "halbench.gains/1", "form": "parallel", "sample_period_s": Loop.T,
            "delay_samples": delay, "gains": {
                "kp": {"value": kp, "unit": "A/rad"}, "ki": {"value": ki, "unit": "A/(rad*s)"},
                "kd": {"value": kd, "unit": "A*s/rad"}}}))
        return self.run_program("analyse", "m.json", "g.json", "--json").json()

    def check(self, stable, limit, *cases):
        """By the closed polynomial: is it stable, and at which factor on the gain does that change first?"""
        for delay in sorted({case[3] for case in cases}):
            self.model(delay)
            for case in [case for case in cases if case[3] == delay]:
                with self.subTest(case):
                    loop = Loop(*case)
                    factor = loop.nearest_limit()
                    self.assertEqual((loop.is_stable(), factor > 1.0), (stable, limit == "increase"))
                    judged = self.judged(*case)
                    self.assertEqual((judged["stable"], judged["margins"]["gain_limit"]), (stable, limit))
                    self.assertAlmostEqual(judged["margins"]["gain_margin_ratio"] / factor, 1.0, delta=1e-4)
                    hints = [f["hint"] for f in judged["data_quality"]["findings"] if f["code"] == "unstable"]
                    self.assertEqual(len(hints), 0 if stable else 1)
                    for hint in hints:
                        self.assertIn("stable above" if limit == "increase" else "stable below", hint)
                    text = self.run_program("analyse", "m.json", "g.json").out
                    self.assertRegex(text, f"(?m)^limit of the gain +{limit} of the gain$")

    def test_the_limit_of_the_published_motor_is_that_of_the_theory(self):
        self.assertAlmostEqual(10.0 * Loop(10, 0, 0, 0).nearest_limit(), 17.27, delta=0.005)

    def test_a_loop_with_too_much_gain_is_told_to_lower_it(self):
        self.check(False, "decrease", (20, 0, 0, 0), (17.3, 0, 0, 0), (40, 0, 0, 0), (8, 0, 0, 1),
                   (80, 400, 8, 0), (80, 800, 12, 0))

    def test_a_loop_with_too_little_gain_for_its_integral_is_told_to_raise_it(self):
        """By Routh (c/J + phi/J K_D) K_P > K_I: with K_D more gain helps, and too little is unstable."""
        self.check(False, "increase", (1, 5, 0.1, 0), (0.5, 3, 0.1, 0), (2, 20, 0.3, 0), (1, 20, 0.3, 0),
                   (2, 16, 0.05, 0), (0.2, 2, 0.1, 0), (1, 5, 0.1, 1), (1, 20, 0.3, 1))

    def test_a_stable_loop_is_told_which_way_its_limit_is_nearer(self):
        self.check(True, "increase", (10, 0, 0, 0), (17.2, 0, 0, 0), (10, 0.1, 0, 0), (5, 0, 0, 1))
        self.check(True, "decrease", (1.5, 7.5, 0.15, 0), (3, 15, 0.3, 0), (2.5, 50, 0.75, 0))


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
