"""Runs the program as a user does and checks what the command-line contract says of every answer."""
import atexit
import json
import os
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = ""
REPOSITORY = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))


def set_program(path):
    """From here on the program keeps what it keeps in a folder of the test's own."""
    global PROGRAM
    PROGRAM = os.path.abspath(path)
    cache = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, cache, ignore_errors=True)
    os.environ["XDG_CACHE_HOME"] = cache


class Answer:
    def __init__(self, arguments, done, seconds):
        self.arguments, self.code, self.seconds = arguments, done.returncode, seconds
        self.out, self.err = done.stdout, done.stderr

    def __str__(self):
        return f"halbench {' '.join(self.arguments)}\nexit {self.code} after {self.seconds:.1f} s\n" \
               f"--- stdout\n{self.out[:2000]}--- stderr\n{self.err[:2000]}"

    def json(self):
        return json.loads(self.out, parse_constant=lambda word: (_ for _ in ()).throw(ValueError(word)))


def limit_file_size(octets):
    """A disk that is full after so many octets, for a child process."""
    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (octets, octets))
    return prepare


def product(one, other):
    """Of two polynomials, highest power first."""
    result = [0.0] * (len(one) + len(other) - 1)
    for i, a in enumerate(one):
        for j, b in enumerate(other):
            result[i + j] += a * b
    return result


class ProgramCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        data = tempfile.TemporaryDirectory()
        self.addCleanup(data.cleanup)
        self.data = data.name                   # what the program keeps for its user

    def environment(self):
        return os.environ | {"XDG_DATA_HOME": self.data}

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def run_program(self, *arguments, timeout=60, is_forced=True, **options):
        """May overwrite what an earlier call of the test wrote, unless it is said not to."""
        options.setdefault("env", self.environment())
        is_command = arguments and not arguments[0].startswith("-")
        force = ["--force"] if is_forced and is_command else []
        began = time.monotonic()
        done = subprocess.run([PROGRAM, *arguments[:1], *force, *arguments[1:]], capture_output=True, text=True,
                              timeout=timeout, check=False, cwd=self.folder, **options)
        return Answer(arguments, done, time.monotonic() - began)

    def start_program(self, *arguments):
        process = subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   cwd=self.folder, env=self.environment())
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        process.kill()
        process.communicate()

    def serve(self, kind="tcp", *options):
        where = ["--pty"] if kind == "pty" else [f"--{kind}", "127.0.0.1:0"]
        process = self.start_program("serve", "sim:htm?seed=1", *where, *options)
        line = process.stdout.readline()
        self.assertRegex(line, r"^listening pty:/dev/\S+$" if kind == "pty" else rf"^listening {kind}:127\.0\.0\.1:\d+$")
        return process, line.split(" ", 1)[1].strip()

    def accept(self, *arguments, **options):
        answer = self.run_program(*arguments, **options)
        self.assertEqual(answer.code, 0, answer)
        return answer

    def refuse(self, code, pattern, *arguments, **options):
        """As text: one line on stderr. Under --json: also halbench.error/1 on stdout and nothing else there."""
        answer = self.run_program(*arguments, **options)
        self.assertEqual(answer.code, code, answer)
        self.assertEqual(answer.out, "", answer)
        lines = answer.err.strip().split("\n")
        self.assertEqual(len(lines), 1, answer)
        self.assertRegex(lines[0], pattern, answer)
        documented = self.run_program(*arguments, "--json", **options)
        self.assertEqual(documented.code, code, documented)
        error = documented.json()
        self.assertEqual((error["schema"], error["exit_code"]), ("halbench.error/1", code), documented)
        self.assertTrue(error["message"] and error["hint"], f"message and remedy\n{documented}")
        return answer

    def assert_nothing_left(self, *allowed):
        """No file under its final name and no partial one."""
        left = [os.path.relpath(os.path.join(place, name), self.folder)
                for place, _, names in os.walk(self.folder) for name in names]
        self.assertEqual(sorted(set(left) - set(allowed)), [])
