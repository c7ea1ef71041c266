"""Recordings in other programs' formats, taken apart by readers that share nothing with the program.

    python3 check_exports.py build/release/halbench [Class[.case]]
"""
import csv
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import unittest

import halbench
import mat5
from halbench import ProgramCase
from mdf4 import Mdf4 as Mdf4File

HOSTILE = "a<b>&\"c\" ]]> \u00e4 \u8f74"
COLUMNS = ["position_rad", "hall_a_T", "status", "x_A", "x_V"]
META = {"schema": "halbench.recording-meta/1", "halbench": "0.1.0", "started": "2026-01-02T03:04:05Z", "period_s": 0.01,
        "device": {"model": "htm", "id": HOSTILE, "firmware": "epk", "simulated": True, "overrides": {"c": "2e-3"}},
        "signals": [{"name": "position", "column": "position_rad", "unit": "rad", "role": "position"},
                    {"name": "hall.a", "column": "hall_a_T", "unit": "T", "role": "hall.a"}],
        "parameters": [{"name": "gain.kp", "value": 0.1, "unit": "A/rad"}],
        "changes": [{"time_s": 0.05, "name": "gain.kp", "value": 1 / 3}],
        "markers": [{"time_s": 1 / 7, "text": HOSTILE}, {"time_s": -0.5, "text": ""}], "gaps": []}


class ExportCase(ProgramCase):
    def made(self):
        """A CSV with a gap, a missing value, and the extremes of a double; its rows as numbers."""
        lines = ["time_s," + ",".join(COLUMNS)]
        for row in range(500):
            values = [repr(math.sin(row) / 3), "" if row == 7 else repr(row * 5e-324), str(row), "-1.7976931348623157e308", "0.1"]
            lines.append(",".join([repr((row if row < 100 else row + 50) / 100), *values]))
        self.write("made.csv", "\n".join(lines) + "\n")
        self.write("made.meta.json", json.dumps(META))
        self.accept("convert", "made.csv", "run.csv")           # our own digits
        return self.rows("run.csv")

    def rows(self, name):
        with open(self.path(name), encoding="utf-8", newline="") as file:
            table = list(csv.reader(file))
        return [tuple(float(field) if field else math.nan for field in row) for row in table[1:]]

    def octets(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def assert_same_bits(self, rows, expected):
        def bits(table):
            return [tuple("nan" if math.isnan(value) else struct.pack("<d", value) for value in row) for row in table]
        self.assertEqual(bits(rows), bits(expected))


class Mdf4(ExportCase):
    def test_a_made_file_keeps_the_standard_and_every_bit(self):
        expected = self.made()
        self.accept("convert", "run.csv", "run.mf4")
        file = Mdf4File(self.path("run.mf4"))
        self.assert_same_bits(file.rows, expected)
        self.assertEqual([signal[:2] for signal in file.signals], [("time", "s"), ("position", "rad"), ("hall.a", "T"),
                                                                  ("status", ""), ("x", "A"), ("x_V", "V")])
        self.assertEqual(file.signals[2][2], {"role": ("hall.a", None)})
        self.assertEqual(file.signals[5][2], {"signal": ("x", None)})
        self.assertEqual(file.start_ns, 1767323045 * 10**9)
        self.assertEqual(file.source, ("htm", HOSTILE, True))
        self.assertEqual(file.comment["device.id"], (HOSTILE, None))
        self.assertEqual(file.comment["parameters/gain.kp"], ("0.1", "A/rad"))
        self.assertEqual(file.comment["overrides/c"], ("2e-3", None))
        self.assertEqual(file.events, [(1 / 7, HOSTILE, {}), (-0.5, "", {}),
                                       (0.05, f"gain.kp = {1 / 3!r}", {"parameter": ("gain.kp", None), "value": (repr(1 / 3), None)})])

    def test_there_and_back_is_the_same_file_and_sidecar(self):
        self.made()
        self.accept("convert", "run.csv", "run.mf4")
        self.accept("convert", "run.mf4", "back.csv")
        self.assertEqual(self.octets("back.csv"), self.octets("run.csv"))
        self.assertEqual(self.octets("back.meta.json"), self.octets("run.meta.json"))
        self.accept("convert", "run.mf4", "again.mf4")
        self.assertEqual(self.octets("again.mf4"), self.octets("run.mf4"))

    def test_a_recording_of_the_simulated_motor_and_a_part_of_it(self):
        self.accept("record", "sim:htm", "--duration", "2", "--out", "run.csv")
        self.accept("convert", "run.csv", "run.mf4")
        self.assert_same_bits(Mdf4File(self.path("run.mf4")).rows, self.rows("run.csv"))
        self.accept("convert", "run.mf4", "part.mf4", "--signals", "hall.a,position_rad", "--from", "0.5", "--to", "1")
        part = Mdf4File(self.path("part.mf4"))
        self.assertEqual([signal[0] for signal in part.signals], ["time", "hall.a", "position"])
        self.assertEqual((len(part.rows), part.rows[0][0]), (50, 0.5))

    def test_every_command_that_opens_a_recording_takes_it(self):
        self.accept("identify", "sim:htm", "--record", "sweep.csv")
        self.accept("convert", "sweep.csv", "sweep.mf4")
        from_csv = self.accept("identify", "sweep.csv", "--json").json()
        self.assertEqual(self.accept("identify", "sweep.mf4", "--json").json(), from_csv)
        self.accept("record", "replay:sweep.mf4", "--duration", "1", "--signals", "position", "--out", "again.csv")

    def test_a_recording_that_was_cut_is_not_passed_on_as_good(self):
        self.accept("record", "sim:htm", "--duration", "2", "--out", "run.csv")
        self.accept("convert", "run.csv", "whole.csv")
        with open(self.path("run.csv"), "rb") as file:
            lines = file.readlines()
        with open(self.path("run.csv"), "wb") as file:
            file.writelines(lines[:101])
        for arguments in (("convert", "run.csv", "cut.csv"),
                          ("record", "replay:run.csv", "--duration", "0.5", "--out", "again.csv"),
                          ("spectrum", "run.csv", "--signal", "position", "--out", "s.csv"),
                          ("overlay", "whole.csv", "run.csv", "--signals", "position", "--out", "both.csv")):
            answer = self.accept(*arguments, "--json")
            self.assertIn("100 of 200 rows", answer.err)
            quality = answer.json()["data_quality"]
            self.assertEqual(quality["verdict"], "doubtful")
            self.assertEqual([finding["code"] for finding in quality["findings"]], ["recording_changed"])
        self.assertNotIn("changed", self.accept("convert", "cut.csv", "more.csv").err)

    def test_damage_is_refused_with_block_and_octet(self):
        self.made()
        self.accept("convert", "run.csv", "run.mf4")
        whole = self.octets("run.mf4")
        for size in (0, 63, 100, len(whole) // 2, len(whole) - 1):
            with open(self.path("cut.mf4"), "wb") as file:
                file.write(whole[:size])
            answer = self.run_program("convert", "cut.mf4", "out.csv")
            self.assertEqual(answer.code, 2, answer)
            self.assertRegex(answer.err, r"cut\.mf4: block (ID|##[A-Z]{2}) at byte \d+: ")


class Mat(ExportCase):
    NAMES = ["time_s", "position", "hall_a", "status", "x", "x_2"]

    def test_every_bit_name_unit_and_note_is_there(self):
        expected = self.made()
        self.accept("convert", "run.csv", "run.mat")
        file = mat5.read(self.path("run.mat"))
        self.assert_same_bits(list(zip(*(file[name] for name in self.NAMES))), expected)
        self.assertEqual(file["units"], dict(zip(self.NAMES, ("s", "rad", "T", "", "A", "V"))))
        self.assertEqual((file["meta_model"], file["meta_id"], file["meta_firmware"]), ("htm", HOSTILE, "epk"))
        self.assertEqual((file["meta_started"], file["meta_software"]), ("2026-01-02T03:04:05Z", "0.1.0"))
        with open(self.path("run.meta.json"), encoding="utf-8") as sidecar:
            self.assertEqual(json.loads(file["meta_json"]), json.load(sidecar) | {"sha256": ""})
        self.assertEqual(set(file), {*self.NAMES, "units", "signals", "meta_model", "meta_id", "meta_firmware", "meta_started",
                                     "meta_software", "meta_json"})

    def test_a_part_and_equal_files_for_equal_recordings(self):
        self.accept("record", "sim:htm", "--duration", "2", "--out", "run.csv")
        self.accept("convert", "run.csv", "run.mf4")
        for source in ("run.csv", "run.mf4"):
            self.accept("convert", source, source + ".mat", "--signals", "hall.a", "--from", "0.5", "--to", "1")
        self.assertEqual(self.octets("run.csv.mat"), self.octets("run.mf4.mat"))
        part = mat5.read(self.path("run.csv.mat"))
        self.assertEqual((len(part["hall_a"]), part["time_s"][0], part["units"]), (50, 0.5, {"time_s": "s", "hall_a": "T"}))

    def test_a_full_disk_leaves_nothing(self):
        self.made()
        self.refuse(2, r"cannot write 'run\.mat", "convert", "run.csv", "run.mat", preexec_fn=halbench.limit_file_size(10_000))
        self.assert_nothing_left("made.csv", "made.meta.json", "run.csv", "run.meta.json")


class MatInOctave(ExportCase):
    def test_every_number_is_there_to_its_last_bit(self):
        expected = self.made()
        self.accept("convert", "run.csv", "run.mat")
        names = Mat.NAMES
        done = subprocess.run(["octave-cli", "--quiet", "--eval",
                               f"load run.mat; rows_ = [{', '.join(names)}].'; "
                               "printf('%s\\n', num2hex(rows_(:)).'); "
                               "printf('%s %s %d', units.hall_a, meta_model, rows(time_s))"],
                              cwd=self.folder, capture_output=True, text=True, check=True)
        digits, words = done.stdout.split("\n")
        self.assertEqual(words, "T htm 500")
        numbers = [struct.unpack(">d", bytes.fromhex(digits[i:i + 16]))[0] for i in range(0, len(digits), 16)]
        width = len(names)
        self.assert_same_bits([tuple(numbers[i:i + width]) for i in range(0, len(numbers), width)], expected)


class CsvInPandas(ExportCase):
    """Written and read where the decimal sign is a comma."""
    GERMAN = "de_DE.UTF-8"
    READER = """
import locale, struct, sys, pandas
assert locale.setlocale(locale.LC_ALL, sys.argv[2]) and locale.localeconv()["decimal_point"] == ","
table = pandas.read_csv(sys.argv[1], float_precision="round_trip")
print(",".join(table.columns))
for row in table.itertuples(index=False):
    print(" ".join(struct.pack("<d", float(value)).hex() for value in row))
"""

    def environment(self):
        return super().environment() | {"LC_ALL": self.GERMAN, "LANG": self.GERMAN}

    def read(self, name):
        done = subprocess.run([SYSTEM_PYTHON, "-c", self.READER, name, self.GERMAN], cwd=self.folder,
                              capture_output=True, text=True, env=self.environment(), check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        header, *lines = done.stdout.splitlines()
        return header.split(","), [tuple(struct.unpack("<d", bytes.fromhex(word))[0] for word in line.split())
                                   for line in lines]

    def test_every_number_is_read_to_its_last_bit(self):
        expected = self.made()
        names, rows = self.read("run.csv")
        self.assertEqual(names, ["time_s", *COLUMNS])
        self.assert_same_bits(rows, expected)

    def test_a_recording_of_the_simulated_motor_too(self):
        self.accept("record", "sim:htm", "--duration", "2", "--out", "run.csv")
        names, rows = self.read("run.csv")
        self.assertEqual(names[0], "time_s")
        self.assert_same_bits(rows, self.rows("run.csv"))
        self.assertEqual(len(rows), 200)


# The system's, to which its packages belong.
SYSTEM_PYTHON = "/usr/bin/python3"
SKIPPED = 77                                            # what ctest lists as not run


def has_reader(name):
    if name.startswith("MatInOctave"):
        return shutil.which("octave-cli") is not None
    if name.startswith("CsvInPandas"):
        return subprocess.run([SYSTEM_PYTHON, "-c", "import pandas"], capture_output=True, check=False).returncode == 0
    return True


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    absent = [name for name in sys.argv[1:] if not has_reader(name)]
    if absent:                                          # where they are said to be there, that is a failure
        print(f"{', '.join(absent)}: the reader is not installed (./dev test --night installs it)")
        sys.exit(1 if os.environ.get("HALBENCH_READERS") else SKIPPED)
    unittest.main(verbosity=2)
