"""One seed, one result: identical bytes in every locale, with and without a display, wherever it runs.

    python3 check_determinism.py build/release/halbench [Determinism[.case]]
"""
import os
import sys
import unittest

import halbench
from halbench import REPOSITORY, ProgramCase

SURROUNDINGS = (
    {"LC_ALL": "C", "LANG": "C", "TZ": "UTC"},
    {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8", "TZ": "Asia/Tokyo", "DISPLAY": ":99"},
    {"LC_ALL": "tr_TR.UTF-8", "LANG": "tr_TR.UTF-8", "TZ": "America/St_Johns"},
)
EXPERIMENT = '''schema = "halbench.experiment/1"
title = "Steps"
device = "sim:htm?seed=3"
[[step]]
kind = "move"
name = "step100"
reference = { shape = "step", amplitude_deg = 100 }
duration_s = 2.0
[[check]]
quantity = "step100.overshoot_percent"
max = 90
'''


class Determinism(ProgramCase):
    def run_in(self, surroundings, name, *arguments):
        """Everything the command said and wrote, run in a folder of that name."""
        folder = self.path(name)
        os.mkdir(folder)
        with open(os.path.join(folder, "e.toml"), "w", encoding="utf-8") as file:
            file.write(EXPERIMENT)
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "LC_ALL", "LANG", "TZ")}
        done = halbench.subprocess.run([halbench.PROGRAM, *arguments], capture_output=True, timeout=100, check=False,
                                       cwd=folder, env=environment | surroundings)
        self.assertEqual(done.returncode, 0, done.stderr)
        files = {"stdout": done.stdout}
        for place, _, names in os.walk(folder):
            for file_name in names:
                path = os.path.join(place, file_name)
                with open(path, "rb") as file:
                    files[os.path.relpath(path, folder)] = file.read()
        return files

    def compare(self, *arguments, at_least):
        first, *others = (self.run_in(s, f"{arguments[0]}{'i' * i}\u00fc", *arguments) for i, s in enumerate(SURROUNDINGS))
        self.assertGreaterEqual(len(first), at_least, sorted(first))
        for other in others:
            self.assertEqual(sorted(first), sorted(other))
        for name in first:
            for other in others:
                self.assertEqual(first[name], other[name], name)
            for trace in (REPOSITORY, self.folder, os.path.expanduser("~/")):
                self.assertNotIn(trace.encode(), first[name], f"{name} tells where it was made")
        return first

    def test_description(self):
        self.compare("describe", "sim:htm?seed=3", "--json", at_least=2)

    def test_recording(self):
        files = self.compare("record", "sim:htm?seed=3", "--duration", "1", "--out", "f.csv", at_least=4)
        other = self.run_in(SURROUNDINGS[0], "other", "record", "sim:htm?seed=4", "--duration", "1", "--out", "f.csv")
        self.assertNotEqual(files["f.csv"], other["f.csv"], "another seed is another motor")

    def test_identification(self):
        self.compare("identify", "sim:htm?seed=3", "--given", "J=5.5e-4", "--out", "m.json", "--record", "r.csv",
                     at_least=5)

    def test_frequency_response(self):
        self.compare("identify", "sim:htm?seed=3", "--frequency", "--out", "f.json", "--record", "r.csv", "--bode", "b.csv",
                     at_least=6)

    def test_tuning(self):
        self.compare("tune", "sim:htm?seed=3", "--out", "g.json", at_least=3)

    def test_pictures(self):
        self.accept("record", "sim:htm?seed=3", "--duration", "1", "--out", "f.csv")
        for ending in ("svg", "pdf", "png"):
            os.mkdir(self.path(ending))
            here, self.folder = self.folder, self.path(ending)
            self.compare("plot", os.path.join("..", "..", "f.csv"), "--out", f"p.{ending}", at_least=3)
            self.folder = here

    def test_a_recording_that_was_changed(self):
        self.accept("record", "sim:htm?seed=3", "--duration", "1", "--out", "f.csv")
        with open(self.path("f.csv"), "r+", encoding="utf-8") as file:
            signals = file.readline().count(",")
            file.seek(0, os.SEEK_END)
            file.write("1" + ",0" * signals + "\n")
        self.compare("spectrum", os.path.join(self.folder, "f.csv"), "--signal", "position", "--out", "s.csv", "--json",
                     at_least=3)

    def test_experiment_with_its_report(self):
        files = self.compare("run", "e.toml", "--out", "out", at_least=6)
        self.assertIn("out/report.html", files)

    def test_tour_through_all_that_a_report_shows(self):
        tour = os.path.join(REPOSITORY, "resources", "experiments", "htm", "tour.toml")
        self.compare("run", tour, "--out", "out", at_least=6)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
