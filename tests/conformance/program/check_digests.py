"""What the shipped experiments and the commands of README.md write stays byte for byte what digests.txt says.

    python3 check_digests.py build/release/halbench Htm|Planar|Spherical|Readme    compares
    python3 check_digests.py build/release/halbench --update                       writes digests.txt anew

A change that shall alter results is followed by --update, and the commit says why the named files differ. Left out of
the digests: the version of the program and of the firmware, dates of the wall clock, the names of folders, pictures
(their letters are those of the machine's fonts), and the formats .mat and .mf4, which tests/conformance/program reads back.
The digests hold on x86-64 with the C library of Debian 12; elsewhere the check is listed as skipped.
"""
import hashlib
import os
import platform
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

import halbench
from halbench import REPOSITORY

DIGESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "digests.txt")
SKIPPED = 77
# The C library computes sines with other last bits on processors that multiply and add in one step.
ONE_ARITHMETIC = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4", "LC_ALL": "C", "TZ": "UTC"}
NO_DIGEST = (".svg", ".pdf", ".png", ".mat", ".mf4")
LEFT_OUT = (
    (re.compile(rb"<svg.*?</svg>", re.DOTALL), b"<svg/>"),
    (re.compile(rb"\d+\.\d+\.\d+-0x[0-9A-F]{8}"), b"FIRMWARE"),
    (re.compile(rb"2\d\d\d-\d\d-\d\dT\d\d:\d\d:\d\d"), b"DATE"),
)
# Ends when it is interrupted; lists dates of files.
NO_COMMANDS = ("serve", "recordings")


def environment(folder):
    return os.environ | ONE_ARITHMETIC | {"XDG_DATA_HOME": os.path.join(folder, "data"), "XDG_CACHE_HOME": os.path.join(folder, "cache")}


def version():
    return subprocess.run([halbench.PROGRAM, "--version"], capture_output=True, check=True).stdout.split()[1]


def digest(content):
    for pattern, word in LEFT_OUT:
        content = pattern.sub(word, content)
    return hashlib.sha256(content.replace(version(), b"VERSION")).hexdigest()


def digests_in(folder):
    found = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if os.path.isfile(path) and not name.endswith(NO_DIGEST):
            with open(path, "rb") as file:
                found[name] = digest(file.read())
    return found


def experiments():
    """"htm/tour" of every shipped experiment."""
    root = os.path.join(REPOSITORY, "resources", "experiments")
    return sorted(f"{model}/{name[:-5]}" for model in os.listdir(root)
                  for name in os.listdir(os.path.join(root, model)) if name.endswith(".toml"))


def run_experiment(name):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        file = os.path.join(REPOSITORY, "resources", "experiments", name + ".toml")
        subprocess.run([halbench.PROGRAM, "--quiet", "run", file, "--out", out], capture_output=True, timeout=300,
                       check=False, env=environment(folder))
        return {f"experiments/{name}/{file}": value for file, value in digests_in(out).items()}


def readme_commands():
    """The words of each line of README.md that calls the installed program."""
    with open(os.path.join(REPOSITORY, "README.md"), encoding="utf-8") as file:
        lines = [shlex.split(line, comments=True) for line in file if line.startswith("    halbench ")]
    return [words[1:] for words in lines if words[1] not in NO_COMMANDS]


def run_readme():
    """All of them in one folder, as a reader would; what each prints counts too."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        work = os.path.join(folder, "work")
        os.mkdir(work)
        for number, words in enumerate(readme_commands(), 1):
            done = subprocess.run([halbench.PROGRAM, "--quiet", *words], capture_output=True, timeout=300, check=False,
                                  cwd=work, env=environment(folder))
            if done.returncode != 0:
                raise AssertionError(f"halbench {' '.join(words)}: exit {done.returncode}\n{done.stderr.decode()}")
            found[f"readme/{number:02}-{words[0]}"] = digest(done.stdout)
        return found | {f"readme/{file}": value for file, value in digests_in(work).items()}


def kept():
    with open(DIGESTS, encoding="utf-8") as file:
        return {name: value for value, name in (line.split() for line in file)}


class Digests(unittest.TestCase):
    def check(self, found, prefix):
        expected = {name: value for name, value in kept().items() if name.startswith(prefix)}
        differing = sorted(name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name))
        self.assertTrue(expected, f"digests.txt has nothing of {prefix}")
        self.assertEqual(differing, [], "these differ from digests.txt, or are on one side only")


class Htm(Digests):
    """The experiments of one actuator; the methods are added below."""


class Planar(Digests):
    pass


class Spherical(Digests):
    pass


def add_experiment(name):
    def test(self):
        self.check(run_experiment(name), f"experiments/{name}/")
    model, title = name.split("/")
    setattr(globals()[model.capitalize()], "test_" + re.sub(r"\W", "_", title), test)


class Readme(Digests):
    def test_commands(self):
        self.check(run_readme(), "readme/")

    def test_every_experiment_has_digests(self):
        named = {"/".join(name.split("/")[1:3]) for name in kept() if name.startswith("experiments/")}
        self.assertEqual(sorted(named), experiments())

    def test_a_changed_file_has_another_digest(self):
        self.assertNotEqual(digest(b'"value": 1.25'), digest(b'"value": 1.250001'))
        self.assertEqual(digest(b'"started": "2026-01-02T03:04:05Z"'), digest(b'"started": "2031-12-31T23:59:59Z"'))
        self.assertNotEqual(digest(b'"started": "1970-01-01T00:00:00Z"'), digest(b'"started": "1970-01-01T00:00:01Z"'))
        self.assertEqual(digest(b'"halbench": "' + version() + b'"'), digest(b'"halbench": "VERSION"'))


def update():
    found = {}
    for name in experiments():
        found |= run_experiment(name)
    found |= run_readme()
    with open(DIGESTS, "w", encoding="utf-8") as file:
        file.writelines(f"{value}  {name}\n" for name, value in sorted(found.items()))


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    if platform.machine() != "x86_64" or platform.libc_ver()[0] != "glibc":
        print("digests are kept for x86-64 with the GNU C library")
        sys.exit(SKIPPED)
    for each in experiments():
        add_experiment(each)
    if sys.argv[1:] == ["--update"]:
        update()
    else:
        unittest.main(verbosity=2)
