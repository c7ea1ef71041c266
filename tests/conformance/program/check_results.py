"""Every document the program prints keeps the common form: schema, header, known units, snake_case, no NaN.

    python3 check_results.py build/release/halbench [Results[.case]]
"""
import json
import math
import os
import re
import sys
import unittest

import halbench
from halbench import REPOSITORY, ProgramCase

HEADER = {"schema", "halbench", "device", "started", "seed", "data_quality"}
# Keys that are names of the device or of the book's letters, not of ours.
LETTERS = re.compile(r"(?<![a-z])(Kf|J)(?![a-z])")
UNIT_SUFFIX = re.compile(r"_(A|V|T|N|K|Nm|degC|A_per_rad|T_per_A|A_per_V|dB|Hz|1_s|mT)$")


def known_units():
    with open(os.path.join(REPOSITORY, "control/base/units.cpp"), encoding="utf-8") as file:
        return set(re.findall(r'Unit\{"([^"]*)",', file.read()))


class Results(ProgramCase):
    def check(self, *arguments, header=True):
        answer = self.run_program(*arguments, "--json")
        self.assertIn(answer.code, (0, 1), answer)
        document = answer.json()
        self.assertRegex(document["schema"], r"^halbench\.[a-z]+/1$")
        if header:
            self.assertEqual(HEADER - set(document), set(), answer)
            self.assertEqual(list(document)[0], "schema")
            self.assertIn(document["data_quality"]["verdict"], ("good", "doubtful", "refused"))
            for finding in document["data_quality"]["findings"]:
                self.assertTrue(finding["code"] and finding["message"] and finding["hint"], finding)
        self.walk(document, document["schema"])
        return document

    def walk(self, value, where):
        if isinstance(value, dict):
            for key, inner in value.items():
                self.assert_key(key, where)
                if key == "unit" and inner is not None:
                    self.assertIn(inner, known_units(), where)
                self.walk(inner, f"{where}.{key}")
        elif isinstance(value, list):
            for index, inner in enumerate(value):
                self.walk(inner, f"{where}[{index}]")

    def assert_key(self, key, where):
        if "." in key or where.endswith(("overrides", "steps")):
            return
        self.assertRegex(LETTERS.sub("x", UNIT_SUFFIX.sub("", key)), r"^[a-z][a-z0-9_]*$", where)

    def test_looking(self):
        self.check("devices", header=False)
        description = self.check("describe", "sim:htm", header=False)
        names = {s["name"] for s in description["signals"]}
        self.assertIn("truth.position", names)
        roles = {p["role"] for p in description["parameters"]}
        self.assertIn("gain.kp", roles)
        self.check("get", "sim:htm", "position", "gain.kp", header=False)
        self.check("set", "sim:htm", "gain.kp=12", header=False)

    def test_motion(self):
        self.check("record", "sim:htm", "--duration", "0.2", "--out", "f.csv")
        self.check("move", "sim:htm", "--reference", "step,amplitude_deg=100", "--duration", "2")
        self.check("move", "sim:htm", "--reference", "sine,amplitude_deg=45,frequency_hz=1", "--duration", "3")

    def rows_of(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return [line.split(",") for line in file.read().split("\n")[1:-1]]

    def test_captures(self):
        result = self.check("record", "sim:htm?hall_noise_mT=2", "--capture", "hall.a,speed", "--trigger", "hall.a>0.157",
                            "--pre-trigger", "0.5", "--rate", "500", "--out", "f.csv")
        self.assertEqual((result["rows"], result["lost_rows"]), (4096, 0))
        with open(self.path("f.csv"), encoding="utf-8") as file:
            rows = [line.split(",") for line in file.read().split("\n")[:-1]]
        self.assertEqual(rows[0], ["time_s", "hall_a_T", "speed_rad_s"])
        self.assertEqual((rows[1][0], rows[2049][0], rows[-1][0]), ("-4.096", "0", "4.094"))
        with open(self.path("f.meta.json"), encoding="utf-8") as file:
            meta = json.load(file)
        self.assertEqual(meta["markers"], [{"text": "trigger", "time_s": 0}])
        self.assertEqual((meta["rows"], meta["period_s"]), (4096, 0.002))
        self.accept("record", "replay:f.csv", "--duration", "8", "--rate", "500", "--out", "again.csv")

    def test_a_recording_that_waits_for_its_trigger_is_a_piece_of_the_plain_one(self):
        device = "sim:htm?hall_noise_mT=2"
        self.check("record", device, "--signals", "position,hall.a", "--duration", "6", "--out", "plain.csv")
        plain = self.rows_of("plain.csv")
        hall = [float(row[2]) for row in plain]
        level = 0.161  # two sigma above the 157 mT of the rotor at rest: soon, but not at once
        event = next(i for i in range(1, len(hall)) if hall[i - 1] < level <= hall[i])
        event_s = (event - 1 + (level - hall[event - 1]) / (hall[event] - hall[event - 1])) / 100
        for before_s in (0, 0.2, 100):
            with self.subTest(before_s=before_s):
                result = self.check("record", device, "--signals", "position", "--trigger", f"hall.a>{level}",
                                    "--pre-trigger", str(before_s), "--duration", "2", "--out", f"{before_s}.csv")
                first = max(0, math.ceil((event_s - before_s) * 100))
                last = math.ceil((event_s + 2) * 100)
                rows = self.rows_of(f"{before_s}.csv")
                self.assertEqual([row[1:] for row in rows], [row[1:] for row in plain[first:last]])
                self.assertEqual([row[0] for row in rows], [row[0] for row in plain[:last - first]])
                # The file has the values as the board's 4-octet floats: 4e-9 T of them in a rise of 4 mT in 10 ms.
                self.assertAlmostEqual(result["trigger_s"], event_s - first / 100, delta=2e-8)
                with open(self.path(f"{before_s}.meta.json"), encoding="utf-8") as file:
                    meta = json.load(file)
                self.assertEqual(meta["markers"], [{"text": "trigger", "time_s": result["trigger_s"]}])
                self.assertEqual((meta["gaps"], meta["rows"]), ([], last - first))

    def test_models(self):
        free = self.check("identify", "sim:htm")
        for parameter in free["parameters"].values():
            self.assertEqual((parameter["value"], parameter["ci95"], parameter["source"]),
                             (None, None, "not identifiable"))
        self.check("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        self.check("identify", "sim:htm", "--currents", "0.2:1:0.2")
        for method, *targets in (["recommended"], ["pole-placement"], ["bandwidth", "--bandwidth-hz", "4"]):
            self.check("tune", "m.json", "--method", method, *targets, "--out", f"{method}.json")
            self.check("analyse", "m.json", f"{method}.json")

    def test_a_warning_is_told_once(self):
        self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        for method in ("recommended", "published", "published-degrees"):
            document = self.accept("tune", "m.json", "--method", method, "--json").json()
            text = self.accept("tune", "m.json", "--method", method).out
            self.assertEqual(document["warnings"], document["data_quality"]["findings"])
            for warning in document["warnings"]:
                self.assertEqual(text.count(warning["message"]), 1, text)

    def test_the_terminal_gives_six_digits_with_units_under_headings(self):
        self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        self.accept("tune", "m.json", "--out", "g.json")
        move = ("move", "sim:htm", "--reference", "step,amplitude_deg=20", "--duration", "1")
        analyse = ("analyse", "m.json", "g.json")
        figures = self.accept(*move, "--json").json()["figures"]
        told = {move: {"true position of the simulated rotor", "measured position", "drive"},
                analyse: {"margins of the sampled loop", "small step, without friction and current limit",
                          "large step, with friction and current limit"}}
        for arguments, headings in told.items():
            text = self.accept(*arguments).out
            self.assertLessEqual(headings, set(text.split("\n")), text)
            for number in re.findall(r"\d\S*(?= ?(?:s|deg|rad|rad/s|%|A|degC)?$)", text, re.M):
                self.assertLessEqual(len(re.sub(r"e.*|\D", "", number).lstrip("0")), 6, text)
        text = self.accept(*move).out
        self.assertIn(f"  {'peak current':<24} {figures['peak_current_A']:.6g} A\n", text)
        self.assertIn(f"  {'final error':<24} {figures['measured_final_error_deg']:.6g} deg\n", text)

    def test_the_verdict_says_what_is_assumed(self):
        self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        self.accept("tune", "m.json", "--out", "g.json")
        self.accept("calibrate", "sim:htm", "stray", "--apply", "--out", "c.json")
        for command in (["tune", "m.json"], ["analyse", "m.json", "g.json"]):
            self.assertIn("\nStable under the stated assumptions:\n  ", self.accept(*command).out)
            self.assertRegex(self.accept(*command, "--calibration", "c.json").out, r"\nGood: (robustly )?stable\n")

    def test_a_calibration_tells_how_well_the_stray_field_is_known(self):
        self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        self.accept("calibrate", "sim:htm", "stray", "--apply", "--out", "c.json")
        codes = [{w["code"] for w in self.accept("tune", "m.json", *options, "--json").json()["warnings"]}
                 for options in ((), ("--calibration", "c.json"))]
        self.assertIn("stray_field_not_calibrated", codes[0])
        self.assertFalse({code for code in codes[1] if code.startswith("stray_field")})
        self.accept("tune", "m.json", "--out", "g.json")
        analysed = self.check("analyse", "m.json", "g.json", "--calibration", "c.json")
        self.assertFalse({w["code"] for w in analysed["warnings"] if w["code"].startswith("stray_field")})

    def test_calibrations(self):
        for what in ("hall", "stray", "static-friction", "all"):
            self.check("calibrate", "sim:htm", what)

    def test_run(self):
        with open(os.path.join(REPOSITORY, "resources/experiments/htm/figure-13a-steps.toml"), encoding="utf-8") as file:
            self.write("e.toml", file.read())
        self.check("run", "e.toml", "--out", "out")

    def test_a_file_beside_it_that_cannot_be_written_does_not_hide_a_result(self):
        self.write("file", "")
        for mode, schema in (("--frequency --from-hz 2 --to-hz 8 --periods 4 --record", "frequency"),
                             ("--frequency --from-hz 2 --to-hz 8 --periods 4 --bode", "frequency"),
                             ("--given J=5.5e-4 --currents 2:4:1 --directions forward --record", "identification")):
            arguments = ("identify", "sim:htm", *mode.split(), "file/x.csv")
            answer = self.run_program(*arguments, "--json")
            told = answer.json()
            self.assertEqual((answer.code, told["schema"], told["exit_code"]), (2, "halbench.error/1", 2), answer)
            self.assertRegex(told["message"], "file/x.csv")
            self.assertEqual(told["result"]["schema"], f"halbench.{schema}/1", answer)
            self.assertIn(told["result"]["data_quality"]["verdict"], ("good", "doubtful", "refused"))
            answer = self.run_program(*arguments)
            self.assertTrue(answer.code == 2 and answer.out.strip(), answer)
            answer = self.run_program(*arguments, "--out", "r.json")
            self.assertRegex(answer.err, "the result is in r.json")
            with open(self.path("r.json"), encoding="utf-8") as file:
                self.assertEqual(json.load(file)["schema"], f"halbench.{schema}/1")

    def test_written_files_are_what_is_printed(self):
        self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        printed = self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--json").out
        with open(self.path("m.json"), encoding="utf-8") as file:
            self.assertEqual(file.read(), printed)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
