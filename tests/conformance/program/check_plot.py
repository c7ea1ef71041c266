"""halbench plot and convert --derive: pictures of recordings, and signals computed from others.

    python3 check_plot.py build/release/halbench [Plots[.case]]
"""
import json
import math
import re
import sys
import unittest

import halbench
from halbench import ProgramCase

ROWS = 400
FIELD_T = 0.157


class Plots(ProgramCase):
    def setUp(self):
        super().setUp()
        angles = [0.01 * row for row in range(ROWS)]
        rows = [f"{row / 100!r},{FIELD_T * math.cos(angle)!r},{FIELD_T * math.sin(angle)!r},{angle!r},3\n"
                for row, angle in enumerate(angles) if not 200 <= row < 250]
        self.write("f.csv", "time_s,hall_a_T,hall_b_T,position_rad,status\n" + "".join(rows))

    def text(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_the_ending_says_the_format(self):
        for name, start in (("a.svg", b"<svg"), ("a.pdf", b"%PDF-"), ("a.png", b"\x89PNG")):
            self.accept("plot", "f.csv", "--out", name)
            with open(self.path(name), "rb") as file:
                self.assertTrue(file.read().startswith(start), name)

    def test_there_is_a_panel_for_each_unit_with_titled_axes(self):
        answer = self.accept("plot", "f.csv", "--out", "a.svg", "--json").json()
        self.assertEqual(answer["panels"], [{"unit": "T", "signals": ["hall.a", "hall.b"]},
                                            {"unit": "rad", "signals": ["position"]}])
        self.assertEqual((answer["rows"], answer["from_s"], answer["to_s"]), (ROWS - 50, 0, 3.99))
        for title in ("flux density [T]", "angle [rad]", "time [s]", "f.csv", "hall.a"):
            self.assertIn(">" + title + "<", self.text("a.svg"))

    def test_a_signal_goes_to_the_right_axis_of_the_one_before_it(self):
        answer = self.accept("plot", "f.csv", "--out", "a.svg", "--right", "position", "--json").json()
        self.assertEqual(answer["panels"], [{"unit": "T", "signals": ["hall.a", "hall.b"], "right": ["position"],
                                             "right_unit": "rad"}])
        for words in ("flux density [T]", "angle [rad]", "position (right)"):
            self.assertIn(">" + words + "<", self.text("a.svg"))
        self.refuse(2, "no.such", "plot", "f.csv", "--out", "b.svg", "--right", "no.such")
        self.refuse(2, "no right axis", "plot", "f.csv", "--out", "b.svg", "--right", "hall.a")

    def test_lost_rows_interrupt_the_line(self):
        self.accept("plot", "f.csv", "--out", "a.svg", "--signals", "position")
        self.accept("plot", "f.csv", "--out", "b.svg", "--signals", "position", "--to", "1.9")
        lines = [len([points for points in re.findall('<polyline[^>]* points="([^"]*)"', self.text(name))
                      if len(points.split()) > 5]) for name in ("a.svg", "b.svg")]  # ticks have fewer
        self.assertEqual(lines[0], lines[1] + 1)

    def test_equal_recordings_give_equal_files(self):
        for ending in ("svg", "pdf", "png"):
            for name in ("a.", "b."):
                self.accept("plot", "f.csv", "--out", name + ending)
            with open(self.path("a." + ending), "rb") as one, open(self.path("b." + ending), "rb") as other:
                self.assertEqual(one.read(), other.read(), ending)

    def test_a_derived_signal_is_drawn_and_converted_with_its_unit(self):
        derive = ("--derive", "field = sqrt(hall.a^2 + hall.b^2)", "--derive", "share = field / hall.a")
        panels = self.accept("plot", "f.csv", "--out", "a.pdf", *derive, "--signals", "hall.a", "--json").json()["panels"]
        self.assertEqual(panels, [{"unit": "T", "signals": ["hall.a", "field"]}, {"unit": "1", "signals": ["share"]}])
        self.accept("convert", "f.csv", "g.csv", *derive)
        header, *rows = self.text("g.csv").splitlines()
        self.assertEqual(header, "time_s,hall_a_T,hall_b_T,position_rad,status,field_T,share")
        for row in rows:
            self.assertAlmostEqual(float(row.split(",")[5]), FIELD_T, places=12)
        notes = {note["name"]: note for note in json.loads(self.text("g.meta.json"))["signals"]}
        self.assertEqual(notes["field"]["expression"], "sqrt(hall.a^2 + hall.b^2)")
        self.assertEqual((notes["share"]["unit"], "expression" in notes["hall.a"]), ("1", False))
        self.accept("convert", "g.csv", "h.mf4")
        self.accept("convert", "h.mf4", "i.csv")
        self.assertEqual(self.text("i.csv"), self.text("g.csv"))
        self.assertEqual(self.text("i.meta.json"), self.text("g.meta.json"))

    def test_mistakes_are_refused_with_their_place(self):
        def refuse(pattern, *arguments):
            with self.subTest(arguments=arguments):
                self.refuse(2, pattern, *arguments)
        refuse(r"no format of pictures.*\.svg, \.pdf and \.png", "plot", "f.csv", "--out", "a.jpg")
        refuse("no signal 'speed'.*available: hall.a", "plot", "f.csv", "--out", "a.svg", "--signals", "speed")
        refuse("no rows in this interval", "plot", "f.csv", "--out", "a.svg", "--from", "9")
        refuse("--out", "plot", "f.csv")
        for text, place in (("x = hall.a +* 2", "x: column 9 of the expression: unexpected '\\*'"),
                            ("x = hall.c", "column 1 of the expression: unknown signal 'hall.c'"),
                            ("x = (hall.a", r"column 8 of the expression: missing \)"),
                            ("x = hall.a + position", "unit of the expression cannot be determined.*give the unit"),
                            ("hall.a = position", "'hall.a' is taken"),
                            ("hall.a + 1", "--derive: 'hall.a \\+ 1' defines no signal")):
            refuse(place, "convert", "f.csv", "g.csv", "--derive", text)
            refuse(place, "plot", "f.csv", "--out", "a.svg", "--derive", text)
        self.assert_nothing_left("f.csv")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
