"""Settings of a board that is not simulated: saved, compared, restored, and kept before they change.

    python3 check_config.py build/release/halbench [Class[.case]]
"""
import os
import sys
import tomllib
import unittest

import halbench
from halbench import ProgramCase


class Config(ProgramCase):
    def setUp(self):
        super().setUp()
        _, self.uri = self.serve()

    def backups(self):
        return [os.path.join(place, name) for place, _, names in os.walk(self.data) for name in names]

    def value(self, name):
        return self.accept("get", self.uri, name, "--json").json()["values"][0]["value"]

    def config(self, what, *arguments, code=0):
        answer = self.run_program("config", what, self.uri, "c.toml", "--json", *arguments)
        self.assertEqual(answer.code, code, answer)
        return answer.json()

    def edit(self, old, new):
        with open(self.path("c.toml"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn(old, text)
        with open(self.path("c.toml"), "w", encoding="utf-8") as file:
            file.write(text.replace(old, new))

    def test_what_was_saved_comes_back_and_what_was_there_is_kept(self):
        self.config("save")
        self.assertEqual(self.backups(), [])
        self.accept("set", self.uri, "gain.kp=25", "hall.offset_a=0.001")
        rows = {row["name"]: row for row in self.config("compare", code=1)["rows"] if row["state"] != "same"}
        self.assertEqual({name: (row["device"], row["file"]) for name, row in rows.items()},
                         {"gain.kp": (25, 10), "hall.offset_a": (rows["hall.offset_a"]["device"], 0)})
        restored = [row["name"] for row in self.config("restore")["rows"] if row["restored"]]
        self.assertEqual(sorted(restored), ["gain.kp", "hall.offset_a"])
        self.assertEqual((self.value("gain.kp"), self.value("hall.offset_a")), (10, 0))
        self.config("compare")
        path, = self.backups()
        with open(path, "rb") as file:
            kept = tomllib.load(file)
        self.assertEqual(kept["parameters"]["gain.kp"], {"value": 25, "unit": "A/rad"})
        self.assertAlmostEqual(kept["calibration"]["hall.offset_a"]["value"], 0.001, places=9)

    def test_calibration_of_another_device_waits_for_a_word(self):
        self.config("save")
        self.edit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 12,")
        self.edit("'hall.offset_a' = { value = 0,", "'hall.offset_a' = { value = 0.002,")
        self.edit("[device]", "[device.overrides]\n'c' = '1'\n[device]")
        document = self.config("restore")
        self.assertFalse(document["same_device"])
        self.assertEqual(document["data_quality"]["findings"][0]["code"], "other_device")
        self.assertEqual((self.value("gain.kp"), self.value("hall.offset_a")), (12, 0))
        self.config("restore", "--calibration")
        self.assertAlmostEqual(self.value("hall.offset_a"), 0.002, places=9)

    def test_a_row_that_cannot_be_is_said_and_the_others_are_restored(self):
        self.config("save")
        self.edit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 12,")
        self.edit("'gain.ki' = { value = 0.1, unit = 'A/(rad*s)' }", "'gain.ki' = { value = 0.1, unit = 'A' }")
        self.edit("'limit.current' = { value = 4,", "'limit.current' = { value = 400,")
        rows = {row["name"]: row for row in self.config("restore", code=1)["rows"]}
        self.assertEqual({name for name, row in rows.items() if row["state"] == "refused"}, {"gain.ki", "limit.current"})
        self.assertTrue(rows["gain.ki"]["reason"] and rows["limit.current"]["reason"])
        self.assertEqual(self.value("gain.kp"), 12)
        self.assertEqual(self.value("limit.current"), 4)

    def test_only_what_is_named_is_written(self):
        self.config("save")
        self.edit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 12,")
        self.edit("'gain.kd' = { value = 0,", "'gain.kd' = { value = 1,")
        self.config("restore", "--only", "gain.kd")
        self.assertEqual((self.value("gain.kp"), self.value("gain.kd")), (10, 1))
        self.refuse(2, "gain.kq", "config", "restore", self.uri, "c.toml", "--only", "gain.kq")
        self.assertEqual(len(self.backups()), 1, "nothing was changed, so nothing is kept")

    def test_nothing_changes_when_the_copy_cannot_be_kept(self):
        self.config("save")
        self.edit("'gain.kp' = { value = 10,", "'gain.kp' = { value = 12,")
        answer = self.run_program("config", "restore", self.uri, "c.toml", env=os.environ | {"XDG_DATA_HOME": "/dev/null"})
        self.assertEqual(answer.code, 2, answer)
        self.assertEqual(self.value("gain.kp"), 10)

    def test_bad_words_and_files_are_refused(self):
        self.config("save")
        self.refuse(2, "save, compare or restore", "config", "burn", self.uri, "c.toml")
        self.refuse(2, "restore", "config", "compare", self.uri, "c.toml", "--save")
        self.refuse(2, "one of the two", "config", "restore", self.uri, "c.toml", "--only", "gain.kp", "--calibration")
        self.refuse(2, "serve", "config", "restore", "sim:htm", "c.toml", "--save")
        self.refuse(2, "none.toml", "config", "compare", self.uri, "none.toml")
        self.edit("model = 'htm'", "model = 'planar'")
        self.refuse(2, "planar", "config", "restore", self.uri, "c.toml")
        self.edit("halbench.configuration/1", "halbench.configuration/9")
        self.refuse(2, r"(?=.*c\.toml:1)(?=.*newer)", "config", "compare", self.uri, "c.toml")


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
