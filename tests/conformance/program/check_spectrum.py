"""halbench spectrum: lines, intervals and summary of a signal whose spectrum is known.

    python3 check_spectrum.py build/release/halbench [Spectra[.case]]
"""
import math
import sys
import unittest

import halbench
from halbench import ProgramCase

RATE_HZ, ROWS = 1000, 4000
AMPLITUDE_A, FREQUENCY_HZ = 2.5, 50


def sine(row):
    return AMPLITUDE_A * math.sin(2 * math.pi * FREQUENCY_HZ * row / RATE_HZ)


class Spectra(ProgramCase):
    def setUp(self):
        super().setUp()
        self.record("f.csv", lambda row: repr(sine(row)))

    def record(self, name, value, time=lambda row: row / RATE_HZ):
        rows = "".join(f"{time(row)!r},{value(row)}\n" for row in range(ROWS))
        self.write(name, "time_s,current_a_A\n" + rows)

    def summary(self, *options, name="f.csv"):
        answer = self.accept("spectrum", name, "--signal", "current.a", *options, "--out", "s.csv", "--json")
        return answer.json()

    def lines(self):
        with open(self.path("s.csv"), encoding="utf-8") as file:
            header, *rows = file.read().splitlines()
        return header, [[float(field) for field in row.split(",")] for row in rows]

    def test_an_amplitude_is_that_of_the_sine(self):
        for kind, value in (("amplitude", AMPLITUDE_A), ("rms", AMPLITUDE_A / math.sqrt(2))):
            summary = self.summary("--kind", kind)
            self.assertEqual((summary["kind"], summary["value_unit"], summary["segments"]), (kind, "A", 1))
            self.assertAlmostEqual(summary["peaks"][0]["frequency_Hz"], FREQUENCY_HZ, places=9)
            self.assertAlmostEqual(summary["peaks"][0]["value"], value, places=9)
            self.assertAlmostEqual(summary["rms"]["value"], AMPLITUDE_A / math.sqrt(2), places=9)
            header, lines = self.lines()
            self.assertEqual(header, "frequency_Hz,value_A,low_A,high_A")
            self.assertEqual(len(lines), ROWS // 2 + 1)
            self.assertAlmostEqual(lines[200][0], FREQUENCY_HZ, places=9)
            self.assertAlmostEqual(lines[200][1], value, places=9)
            self.assertTrue(all(low <= value <= high for _, value, low, high in lines))

    def test_a_density_integrates_to_the_mean_square(self):
        for kind, unit, column, power in (("psd", "A^2/Hz", "value_A_squared_per_Hz", 1),
                                          ("asd", "A/sqrt(Hz)", "value_A_per_sqrtHz", 2)):
            summary = self.summary("--kind", kind, "--segment_s", "0.5", "--window", "blackman-harris")
            self.assertEqual((summary["value_unit"], summary["segments"]), (unit, 15))
            header, lines = self.lines()
            self.assertEqual(header.split(",")[1], column)
            integral = sum(line[1] ** power for line in lines) * summary["line_distance_Hz"]
            self.assertAlmostEqual(integral, AMPLITUDE_A ** 2 / 2, places=9)

    def test_a_part_of_the_recording_is_taken(self):
        summary = self.summary("--from", "1", "--to", "2")
        self.assertEqual((summary["rows"], summary["segment_s"]), (1000, 1.0))

    def test_as_text_the_peaks_are_told(self):
        answer = self.accept("spectrum", "f.csv", "--signal", "current_a_A", "--out", "s.csv")
        self.assertRegex(answer.out, r"(?s)amplitude of current\.a, A\n.*highest peaks\n +50 Hz  2\.5  \[")
        self.assertEqual(answer.err.strip(), "halbench: wrote s.csv")
        self.assertEqual(answer.out.count(" Hz  "), 1)  # rounding is no peak

    def test_gaps_and_missing_values_are_told_and_not_bridged(self):
        self.record("g.csv", lambda row: "" if row == 900 else repr(sine(row)),
                    lambda row: row / RATE_HZ + (0.5173 if row >= 1500 else 0))
        summary = self.summary("--segment_s", "0.5", name="g.csv")
        self.assertEqual((summary["gaps"], summary["missing_values"], summary["rows"]), (1, 1, ROWS))
        self.assertAlmostEqual(summary["peaks"][0]["value"], AMPLITUDE_A, places=9)
        self.assertEqual(summary["data_quality"]["verdict"], "good")
        summary = self.summary("--segment_s", "2.4", name="g.csv")
        self.assertEqual(summary["data_quality"]["verdict"], "good")
        self.record("h.csv", lambda row: "" if row % 500 == 300 else repr(sine(row)))
        summary = self.summary("--segment_s", "0.45", "--overlap", "0", name="h.csv")
        self.assertEqual(summary["data_quality"]["verdict"], "good")
        self.record("i.csv", lambda row: "" if row < 2600 and row % 100 == 50 else repr(sine(row)))
        summary = self.summary("--segment_s", "1", name="i.csv")
        self.assertEqual(summary["data_quality"]["findings"][0]["code"], "rows_left_out")

    def test_what_has_no_spectrum_is_refused(self):
        def refuse(code, pattern, *arguments, name="f.csv"):
            with self.subTest(arguments=arguments):
                self.refuse(code, pattern, "spectrum", name, *arguments, "--out", "s.csv")
        signal = ("--signal", "current.a")
        refuse(2, "no signal 'speed'.*available: current.a", "--signal", "speed")
        refuse(2, "--kind: 'power'.*amplitude, rms, psd, asd", *signal, "--kind", "power")
        refuse(2, "--window: 'hanning'.*hann", *signal, "--window", "hanning")
        refuse(2, "--segment_s: 'long' is not a number", *signal, "--segment_s", "long")
        refuse(2, "overlap of 1", *signal, "--overlap", "1")
        refuse(2, "fewer than 8 rows", *signal, "--segment_s", "0.001")
        refuse(1, "f.csv: .*has 4000 rows, 4 s.*shorter segment", *signal, "--segment_s", "5")
        refuse(2, "cannot read|no such|does not exist", *signal, name="none.csv")
        self.record("u.csv", lambda row: "1", lambda row: (row + 0.3 * (row % 2)) / RATE_HZ)
        refuse(1, "u.csv: .*uneven sampling.*resample", *signal, name="u.csv")
        self.record("n.csv", lambda row: "")
        refuse(1, "without gap or missing value", *signal, name="n.csv")
        self.refuse(2, "--signal", "spectrum", "f.csv", "--out", "s.csv")
        self.refuse(2, "--out", "spectrum", "f.csv", *signal)
        self.assert_nothing_left("f.csv", "u.csv", "n.csv")

    def test_equal_recordings_give_equal_bytes(self):
        first = (self.summary("--kind", "psd"), self.lines())
        self.assertEqual((self.summary("--kind", "psd"), self.lines()), first)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
