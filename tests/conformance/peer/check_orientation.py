"""The board that senses an orientation, read by our independent master: fields and angles are those of the theory.

    python3 check_orientation.py build/release/halbench [case]
"""
import math
import sys
import unittest

from master import Master
from target import LINES, Running

PROGRAM = ""
STRENGTH_T = 0.0991864782
PLACEMENT_DEG = ((0, 0, 0), (0, 0, 45), (45, 45, -90))
POSE_DEG = (20.0, -30.0, 50.0)
# Single precision: a few roundings of 6e-8 near one.
CLOSE = 2e-6


def about(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = [[float(r == k) for k in range(3)] for r in range(3)]
    matrix[i][i] = matrix[j][j] = c
    matrix[j][i], matrix[i][j] = s, -s
    return matrix


def product(*matrices):
    result = about(0, 0)
    for matrix in matrices:
        result = [[sum(result[r][k] * matrix[k][c] for k in range(3)) for c in range(3)] for r in range(3)]
    return result


def column(matrix, index, sign=1.0):
    return [sign * matrix[r][index] for r in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def readings():
    """B = 5 (n.Q n) n - 2 Q n with Q = q (u u^T - v v^T): spherical-theory.md, section 3.3."""
    alpha, beta, gamma = POSE_DEG
    rotor = product(about(0, alpha), about(1, beta), about(2, gamma))
    u, v = column(rotor, 0), column(rotor, 1)
    for a, b, g in PLACEMENT_DEG:
        sensor = product(about(2, g), about(1, b), about(0, a))
        n = column(sensor, 0)
        q = [STRENGTH_T * (u[i] * dot(u, n) - v[i] * dot(v, n)) for i in range(3)]
        field = [5 * dot(n, q) * n[i] - 2 * q[i] for i in range(3)]
        yield from (dot(field, n), dot(field, column(sensor, 2, -1.0)), dot(field, column(sensor, 1)))


class Orientation(unittest.TestCase):
    def setUp(self):
        alpha, beta, gamma = POSE_DEG
        uri = f"sim:spherical?chain=ideal&alpha_deg={alpha}&beta_deg={beta}&gamma_deg={gamma}"
        self.running = Running([PROGRAM, "serve", uri, *LINES["tcp"]], "tcp")
        self.addCleanup(self.running.stop)
        self.master = Master(self.running.address)
        self.master.connect()
        self.addCleanup(self.master.close)
        self.master.describe()

    def test_fields_are_those_of_the_theory(self):
        names = [f"field.{sensor}.{axis}" for sensor in range(3) for axis in ("r", "theta", "phi")]
        for name, expected in zip(names, readings()):
            self.assertAlmostEqual(self.master.read_name(name), expected, delta=CLOSE, msg=name)

    def test_angles_are_those_of_the_pose(self):
        for name, expected in zip(("alpha", "beta", "gamma"), POSE_DEG):
            value = self.master.read_name("orientation." + name)
            self.assertAlmostEqual(value, math.radians(expected), delta=2 * CLOSE, msg=name)
            self.assertAlmostEqual(self.master.read_name("truth." + name), math.radians(expected), delta=1e-12, msg=name)
        self.assertAlmostEqual(self.master.read_name("strength"), STRENGTH_T, delta=CLOSE)

    def test_there_is_nothing_to_arm(self):
        for name in ("hb.arm", "hb.mode", "hb.setpoint", "reference.start"):
            self.assertNotIn(name, self.master.a2l.parameters)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
