"""The commands that README and help show do what they say.

    python3 check_documents.py build/release/halbench [Documents[.case]]
"""
import os
import re
import shlex
import sys
import unittest

import halbench
from halbench import REPOSITORY, ProgramCase

PAGES = ("README.md", "resources/help/index.md", "resources/help/identification.md", "resources/help/tuning.md")
COMMAND = re.compile(r"^ {4}(?:build/release/)?halbench (.*)$", re.M)


def commands_of(page):
    path = os.path.join(REPOSITORY, page)
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        text = file.read()
    return [shlex.split(line, comments=True) for line in COMMAND.findall(text)]


class Documents(ProgramCase):
    def test_every_command_shown_runs(self):
        for page in PAGES:
            os.symlink(os.path.join(REPOSITORY, "resources"), self.path("resources"))
            for arguments in commands_of(page):
                if arguments[0] == "serve" or re.search(r"[A-Z]{4}|\.\.\.|\[", " ".join(arguments)):
                    continue                     # a synopsis, or a command that does not end
                with self.subTest(page=page, command=" ".join(arguments)):
                    self.accept(*arguments, timeout=100)
            os.unlink(self.path("resources"))

    def test_the_help_names_every_shipped_experiment(self):
        with open(os.path.join(REPOSITORY, "resources/help/command-line.md"), encoding="utf-8") as file:
            named = set(re.findall(r"`([\w-]+\.toml)`", file.read()))
        folder = os.path.join(REPOSITORY, "resources/experiments")
        shipped = {name for _, _, names in os.walk(folder) for name in names if name.endswith(".toml")}
        self.assertGreater(len(shipped), 20)
        self.assertEqual(shipped - named, set())
        self.assertEqual(named - shipped, set())

    def test_the_readme_shows_commands(self):
        self.assertGreater(len(commands_of("README.md")), 5)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
