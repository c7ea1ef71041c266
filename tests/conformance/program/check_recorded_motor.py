"""Recordings of a motor as users have them: right within the interval, or told.

    python3 check_recorded_motor.py build/release/halbench [RecordedMotor[.case]]

The rotor is moved by its closed solution (resources/help/htm-theory.md section 3.1), so that the constants are known.
"""
import json
import math
import random
import sys
import unittest

import halbench
from halbench import ProgramCase

J, C, KF, PHI = 5.5e-4, 1.23e-3, 2.05e-2, 1.43e-2
GIVEN = ("--given", f"J={J}")
PERIOD_s = 0.01
SWEEP = ((0.0, 0.3), (4.0, 2.2), (0.0, 0.7), (-3.2, 2.0), (0.0, 0.6), (2.6, 2.0), (0.0, 0.6))
ONE_WAY = ((3.6, 5.6), (3.8, 4.4))


def moved(angle, speed, torque, friction, duration):
    """Angle and speed after a constant torque, to the next rest at most; the rest of the time the rotor stands."""
    if speed == 0.0 and abs(torque) <= friction:
        return angle, 0.0
    sign = math.copysign(1.0, speed if speed != 0.0 else torque)
    final, rate = (torque - sign * friction) / C, C / J
    if sign * final < 0.0 and speed != 0.0:
        duration = min(duration, math.log((speed - final) / -final) / rate)
    decay = math.exp(-rate * duration)
    after = final + (speed - final) * decay
    return angle + final * duration + (speed - final) * (1.0 - decay) / rate, after if after * sign > 1e-12 else 0.0


def motion(plan, scatter=0.0, seed=1, angle=0.0, speed=0.0):
    """Rows of time, angle and current; friction is drawn anew for each current, the angle read to 0.04 degrees."""
    draw = random.Random(seed)
    rows = []
    for current, duration in plan:
        friction = KF * (1.0 + scatter * draw.choice((-1.0, 1.0)))
        for _ in range(round(duration / PERIOD_s)):
            rows.append((len(rows) * PERIOD_s, angle + draw.gauss(0.0, 7e-4), current))
            angle, speed = moved(angle, speed, PHI * current, friction, PERIOD_s)
    return rows


class RecordedMotor(ProgramCase):
    def identified(self, rows, position="position_rad", current="current_command_A", turn=lambda x: x, amps=lambda x: x):
        lines = [f"time_s,{position},{current}"]
        lines += [f"{time:.2f},{turn(angle)!r},{amps(value)!r}" for time, angle, value in rows]
        self.write("motor.csv", "\n".join(lines) + "\n")
        return self.run_program("identify", "motor.csv", *GIVEN, "--json").json()

    @staticmethod
    def verdict(result):
        return result["data_quality"]["verdict"]

    @staticmethod
    def codes(result):
        return [finding["code"] for finding in result["data_quality"]["findings"]]

    def assert_right(self, result):
        """Good, and 1 % of the truth, far more than noise of 0.04 degrees makes of run-ups to 30 rad/s."""
        self.assertEqual(self.verdict(result), "good", result["data_quality"])
        for name, truth in (("torque_constant", PHI), ("viscous_damping", C), ("coulomb_friction", KF)):
            self.assertAlmostEqual(result["parameters"][name]["value"] / truth, 1.0, delta=0.01, msg=name)
        self.assertGreater(len(result["points"]), 0)
        self.assertTrue(all(point["used"] for point in result["points"]), result["points"])

    def test_run_ups_and_coast_downs_give_the_constants_in_every_unit(self):
        rows = motion(SWEEP)
        for changes in ({}, {"position": "position_deg", "turn": math.degrees},
                        {"position": "position [rev]", "turn": lambda x: x / (2 * math.pi),
                         "current": "current_command [mA]", "amps": lambda x: 1e3 * x}):
            with self.subTest(changes):
                self.assert_right(self.identified(rows, **changes))

    def test_two_plateaus_of_one_direction_do_not_tell_the_torque_constant(self):
        """The friction of one differs from that of the other by a few per cent, and phi/J is their difference over 0.2 A."""
        for seed in range(1, 9):
            rows = motion(ONE_WAY, scatter=0.033, seed=seed, angle=320.0, speed=21.0)
            for changes in ({"position": "position_deg", "turn": math.degrees}, {},
                            {"position": "position_mrad", "turn": lambda x: 1e3 * x}):
                with self.subTest(f"{seed} {changes}"):
                    result = self.identified(rows, **changes)
                    self.assertEqual(self.verdict(result), "doubtful")
                    self.assertIn("friction_scatter_assumed", self.codes(result))
                    low, high = result["ratios"]["phi_over_J"]["ci95"]
                    self.assertTrue(low <= PHI / J <= high, (low, high))
                    self.assertGreater(high - low, 0.2 * PHI / J)

    def test_a_reversed_sign_is_refused(self):
        rows = motion(SWEEP)
        for changes in ({"amps": lambda x: -x}, {"turn": lambda x: -x},
                        {"position": "position_deg", "turn": lambda x: -math.degrees(x),
                         "current": "current_command_mA", "amps": lambda x: 1e3 * x}):
            with self.subTest(changes):
                result = self.identified(rows, **changes)
                self.assertEqual(self.verdict(result), "refused")
                self.assertIn("sign_reversed", self.codes(result))
                self.assertIn("sign of current or angle", json.dumps(result["data_quality"]))

    def test_a_wrapped_angle_is_continued_and_every_plateau_counts(self):
        rows = motion(SWEEP, angle=0.4)
        for changes in ({"turn": lambda x: x % (2 * math.pi)},
                        {"turn": lambda x: (x + math.pi) % (2 * math.pi) - math.pi},
                        {"position": "position_deg", "turn": lambda x: math.degrees(x) % 360.0}):
            with self.subTest(changes):
                result = self.identified(rows, **changes)
                self.assertIn("angle_wraps", self.codes(result))
                self.assert_right(result)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
