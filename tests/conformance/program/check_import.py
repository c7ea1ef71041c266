"""Tables of other programs become recordings: every way to write one, every number to the last bit by Python's own
reading, what is not certain is asked, and an identification works on the result.

    python3 check_import.py build/release/halbench [Import[.case]]
"""
import csv
import itertools
import json
import os
import random
import struct
import sys
import unittest

import halbench
from halbench import REPOSITORY, ProgramCase

SEPARATORS = {",": ",", ";": ";", "tab": "\t", "space": " "}


def numbers(count):
    """Written in many ways: too many digits, few, exponents, denormal, and what a 4-octet float becomes in 8."""
    rng = random.Random(7)
    for row in range(count):
        value = rng.gauss(0, 1) * 10 ** rng.uniform(-15, 15)
        yield (repr(value), f"{value:.30e}", f"{value:.3f}", f"{value:+.5E}", repr(5e-324 * (row + 1)),
               repr(struct.unpack("f", struct.pack("f", value))[0]))[row % 6]


class Import(ProgramCase):
    def write_bytes(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)

    def rows(self, name):
        with open(self.path(name), newline="", encoding="utf-8") as file:
            return list(csv.reader(file))

    def table(self, separator, decimal, header, line_end, mark):
        lines = {"0": [], "1": [["t[ms]", "a"]], "units": [["t", "a"], ["ms", "A"]]}[header]
        lines = [separator.join(cells) for cells in lines]
        cells = [(f"{row}.{row % 9 + 1}", text) for row, text in enumerate(numbers(120))]
        for pair in cells:
            texts = [text.replace(".", decimal) for text in pair]
            lines.append(separator.join(f'"{t}"' if separator == decimal else t for t in texts))
        text = "".join(line + line_end for line in lines)
        return ("\ufeff" if mark else "").encode() + text.encode(), cells

    def test_every_way_to_write_a_table_is_seen_and_read_to_the_last_bit(self):
        for word, decimal, header, line_end, mark in itertools.product(
                SEPARATORS, ".,", ("0", "1", "units"), ("\n", "\r\n"), (False, True)):
            with self.subTest(separator=word, decimal=decimal, header=header, line_end=line_end, mark=mark):
                data, cells = self.table(SEPARATORS[word], decimal, header, line_end, mark)
                self.write_bytes("in.csv", data)
                known = ["--time", "1", "--unit", "1=ms"] if header == "0" else []
                answer = self.accept("import", "in.csv", "--out", "out.csv", *known, "--json").json()
                self.assertEqual(answer["dialect"], {
                    "separator": word, "decimal": decimal, "header": header, "comment_lines": 0,
                    "line_end": "CR LF" if line_end == "\r\n" else "LF", "byte_order_mark": mark})
                rows = self.rows("out.csv")[1:]
                self.assertEqual([[float(x) for x in row] for row in rows],
                                 [[float(t) / 1000, float(a)] for t, a in cells])

    def test_what_is_not_certain_is_asked_with_the_options_that_tell(self):
        for text, answers in (("1,5\n2,5\n", (["--separator", "none", "--decimal", ","], ["--separator", ","])),
                              ("1,234;2\n2,345;3\n", (["--decimal", ","],))):
            self.write("in.csv", text)
            rate = ["--rate_Hz", "10", "--out", "out.csv"]
            refused = self.refuse(2, r"uncertain; add --", "import", "in.csv", *rate)
            self.assert_nothing_left("in.csv")
            preview = self.accept("import", "in.csv", "--preview", "--json").json()
            self.assertIsNone(preview["dialect"])
            self.assertEqual(preview["first_lines"], text.split())
            for answer in preview["questions"][0]["answers"]:
                self.assertIn(answer["option"], refused.err)
            for options in answers:
                self.accept("import", "in.csv", *rate, *options)
            self.assertIn("uncertain", self.accept("import", "in.csv", "--preview").out)
            for name in ("out.csv", "out.meta.json"):
                os.remove(self.path(name))

    def test_time_and_units_are_asked_for(self):
        self.write("in.csv", "x;omega\n0,5;60\n1,5;120\n2,5;180\n")
        self.refuse(2, r"time column is uncertain; add --time x .* or --rate_Hz F", "import", "in.csv", "--out", "o.csv")
        self.refuse(2, r"unit of column 'x' .*unit of column 'omega' .*--unit 'x=ms'.*--unit 'omega=rpm'", "import", "in.csv",
                    "--out", "o.csv", "--time", "x", "--map", "speed=omega")
        self.accept("import", "in.csv", "--out", "o.csv", "--time", "x", "--unit", "x=s", "--map", "speed=omega",
                    "--unit", "omega=rpm")
        self.assertEqual(self.rows("o.csv")[0], ["time_s", "speed_rad_s"])

    def test_nonsense_is_refused(self):
        self.write("in.csv", "t_s,a\n0.5,1\n1.5,2\n")
        for options, pattern in (
                (["--separator", "x"], "--separator"), (["--decimal", "x"], "--decimal"), (["--header", "2"], "--header"),
                (["--rate_Hz", "fast"], "--rate_Hz"), (["--rate_Hz", "-1"], "--rate_Hz"), (["--map", "speed"], "--map"),
                (["--map", "speed=b"], "no column 'b'"), (["--unit", "a=furlong"], "is not a known unit"), (["--time", "b"], "'b'"),
                (["--separator", ";"], r"in\.csv:\d:\d: "), (["--decimal", ","], r"in\.csv:\d:\d: ")):
            with self.subTest(options=options):
                self.refuse(2, pattern, "import", "in.csv", "--out", "o.csv", *options)
        self.refuse(2, "--out is missing", "import", "in.csv")
        self.refuse(2, "overwrite", "import", "in.csv", "--out", "./in.csv")
        self.refuse(2, r"no \.csv file", "import", "in.csv", "--out", "o.mat")
        self.refuse(2, "cannot read", "import", "none.csv", "--out", "o.csv")
        self.assert_nothing_left("in.csv")

    def test_an_identification_works_on_another_programs_table_as_on_ours(self):
        self.accept("identify", "sim:htm?seed=3", "--given", "J=5.5e-4", "--record", "own.csv", "--out", "own.json")
        own = self.rows("own.csv")
        names = {"position_rad": "Winkel [rad]", "current_command_A": "Strom [mA]"}
        keep = [own[0].index(name) for name in names]
        with open(self.path("in.csv"), "w", encoding="utf-8") as file:
            file.write("# von einem anderen Programm\r\nZeit [s];" + ";".join(names.values()) + ";\r\n")
            for row in own[1:]:
                position, current = (row[i] for i in keep)
                cells = [row[0], position, repr(float(current) * 1000)]
                file.write(";".join(cell.replace(".", ",") for cell in cells) + ";\r\n")
        self.accept("import", "in.csv", "--out", "new.csv", "--map", "position=Winkel", "--map",
                    "current_command=Strom")
        new = self.rows("new.csv")
        self.assertEqual(new[0], ["time_s", "position_rad", "current_command_A"])
        for mine, theirs in zip(own[1:], new[1:], strict=True):
            self.assertEqual([float(mine[0]), float(mine[keep[0]])], [float(x) for x in theirs[:2]])
        answer = self.accept("identify", "new.csv", "--given", "J=5.5e-4", "--json").json()
        again = self.accept("identify", "own.csv", "--given", "J=5.5e-4", "--json").json()
        for name, parameter in again["parameters"].items():     # mA and back costs a rounding, no more
            self.assertAlmostEqual(answer["parameters"][name]["value"] / parameter["value"], 1.0, 6, name)

    def test_documents_are_what_the_schema_publishes(self):
        import jsonschema
        with open(os.path.join(REPOSITORY, "resources/schemas/import.schema.json"), encoding="utf-8") as file:
            validator = jsonschema.Draft7Validator(json.load(file))
        self.write("sure.csv", "t_s;a [bar]\n0,5;1\n1,5;\n2,5;3\n9,5;2\n")
        self.write("unsure.csv", "1,5\n2,5\n")
        for arguments in (["sure.csv", "--preview"], ["unsure.csv", "--preview"], ["sure.csv", "--out", "o.csv"]):
            answer = self.accept("import", *arguments, "--json").json()
            validator.validate(answer)
        self.assertEqual({f["code"] for f in answer["data_quality"]["findings"]},
                         {"unit_not_known", "time_not_uniform", "rows_lost", "missing_values"})


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
