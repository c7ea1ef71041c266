"""The product's master against our slaves: foreign boards give right values, hostile ones one clear error.

    python3 check_program.py build/release/halbench [Class[.case]]
"""
import json
import os
import subprocess
import sys
import tempfile
import time
import unittest

from master import Master
from relay import Relay, Tap
from target import program_target, slave_target
from variants import FOREIGN, HOSTILE

PROGRAM = ""
# Recovery is two repeats after time-outs of about a second (protocol 3.6); the rest is a busy machine.
PATIENCE_S = 9.0
STREAM_TROUBLE = {"pid_out_of_range", "short_dto", "time_backwards", "time_stands", "hangs_up_in_stream", "no_dto"}
HARMLESS = {"event_flood", "a2l_many_blocks"}      # right values all the same


class Answer:
    def __init__(self, arguments, environment):
        began = time.monotonic()
        done = subprocess.run([PROGRAM] + arguments, capture_output=True, text=True, timeout=30, check=False,
                              env=environment)
        self.seconds = time.monotonic() - began
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr
        self.arguments = arguments

    def __str__(self):
        return f"halbench {' '.join(self.arguments)}: exit {self.code}, {self.seconds:.1f} s\n{self.out}{self.err}"

    def json(self):
        return json.loads(self.out)


class ProgramCase(unittest.TestCase):
    def serve(self, variant):
        running = slave_target(variant).start()
        self.addCleanup(running.stop)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.environment = os.environ | {"XDG_CACHE_HOME": os.path.join(self.folder, "cache")}
        self.running, self.uri = running, running.address

    def run_on(self, verb, *arguments):
        return Answer([verb, self.uri, *arguments, "--json"], self.environment)

    def accept(self, verb, *arguments):
        answer = self.run_on(verb, *arguments)
        self.assertEqual(answer.code, 0, answer)
        return answer

    def refuse(self, code, verb, *arguments):
        answer = self.run_on(verb, *arguments)
        self.assertEqual(answer.code, code, answer)
        self.assert_one_clear_error(answer)
        return answer

    def assert_one_clear_error(self, answer):
        error = answer.json()
        self.assertEqual(error["schema"], "halbench.error/1", answer)
        self.assertEqual(error["exit_code"], answer.code, answer)
        self.assertTrue(error["code"] and error["message"], answer)
        self.assertEqual(len(answer.err.strip().splitlines()), 1, answer)
        self.assertLess(answer.seconds, PATIENCE_S, answer)

    def board_value(self, name):
        """What the board runs with, read by our own master on the page of the control loop."""
        master = Master(self.running.address)
        master.connect()
        master.describe()
        if master.a2l.segments:
            master.set_page(2, master.page(1))
        value = master.read_name(name)
        master.close()
        return value


class ForeignCase(ProgramCase):
    def check_description(self):
        description = self.accept("describe").json()
        self.assertEqual(description["schema"], "halbench.description/1")
        signals = {s["name"]: s for s in description["signals"]}
        parameters = {p["name"]: p for p in description["parameters"]}
        self.assertEqual(signals["sine"]["unit"], "A")
        self.assertEqual((signals["level"]["unit"], signals["level"]["max"]), ("V", 300))
        self.assertEqual(signals["counter"]["max_rate_hz"], 1000)
        kp = parameters["gain.kp"]
        self.assertEqual((kp["value"], kp["min"], kp["max"], kp["unit"]), (10, 0, 1000, "A/rad"))
        self.assertEqual(parameters["trim"]["value"], -5)

    def values(self, *names):
        return {v["name"]: v["value"] for v in self.accept("get", *names).json()["values"]}

    def check_values(self):
        self.assertEqual(self.values("gain.kp", "gain.ki", "trim", "divider"),
                         {"gain.kp": 10, "gain.ki": 0.5, "trim": -5, "divider": 10})
        self.accept("set", "gain.kp=12.5", "gain.ki=1.25", "trim=7")
        self.assertEqual(self.values("gain.ki", "gain.kp", "trim"), {"gain.ki": 1.25, "gain.kp": 12.5, "trim": 7})
        self.assertEqual(self.board_value("gain.kp"), 12.5)
        self.assertEqual(self.board_value("hb.arm"), 0)

    def check_refusals(self):
        for wrong in ("gain.kp=2000", "gain.kp=-1", "gain.kp=nan", "gain.kp=inf", "trim=1.5", "no.such=1", "gain.kp=",
                      "gain.kp", "counter=3"):
            self.refuse(2, "set", "gain.ki=3", wrong)
        self.refuse(2, "get", "no.such")
        self.assertEqual(self.board_value("gain.kp"), 12.5)
        self.assertEqual(self.board_value("gain.ki"), 1.25)

    def check_recording(self, rate, seconds=0.2):
        path = os.path.join(self.folder, f"at{rate}.csv")
        self.accept("record", "--duration", str(seconds), "--rate", str(rate), "--signals",
                    "counter,sine,wide,level,counter_again", "--out", path)
        with open(path, encoding="utf-8") as file:
            header, *lines = file.read().splitlines()
        self.assertEqual(header, "time_s,counter,sine_A,wide_rad,level_V,counter_again")
        rows = [[float(cell) for cell in line.split(",")] for line in lines]
        self.assertEqual(len(rows), round(rate * seconds))
        for index, row in enumerate(rows):
            self.assertAlmostEqual(row[0], index / rate, delta=1e-6)
            self.assertEqual(row[1], rows[0][1] + index * 1000 // rate, "no sample is lost or doubled")
            self.assertEqual(row[1], row[5], "one cycle")
            self.assertAlmostEqual(row[3], row[1] / 3.0, delta=1e-9)
            self.assertAlmostEqual(row[4], ((row[1] % 20000) - 10000) * 0.01, delta=1e-9)

    def check_all(self, variant):
        self.serve(variant)
        self.check_description()
        self.check_values()
        self.check_refusals()
        self.check_recording(100)
        self.check_recording(500)


def foreign_case(variant):
    return lambda self: self.check_all(variant)


class ForeignFormats(ForeignCase):
    """Byte orders, identifications and paddings of their own."""


class ForeignMemory(ForeignCase):
    """Other pages, other commands, other sizes."""


class ForeignClock(ForeignCase):
    """Clocks that turn over; the recordings begin 0.1 s before a turn."""

    def test_two_turns_of_a_nanosecond_clock(self):
        """The 32-bit counter turns 0.1 s and 4.4 s after the start; times go on."""
        self.serve("nanosecond_clock")
        self.check_recording(100, 4.6)


for name in FOREIGN:
    if "clock" in name:
        group = ForeignClock
    elif "page" in name or "download" in name or "packets" in name:
        group = ForeignMemory
    else:
        group = ForeignFormats
    setattr(group, f"test_{name}", foreign_case(name))


class HostileCase(ProgramCase):
    def check_all(self, variant):
        self.serve(variant)
        codes = {"describe": self.check("describe"), "get": self.check("get", "gain.kp")}
        if variant in STREAM_TROUBLE | HARMLESS:
            self.assertEqual(codes, {"describe": 0, "get": 0})
        elif variant == "wrong_checksum":
            self.refuse(3, "set", "gain.kp=12", "gain.ki=3")
            self.assertEqual(self.board_value("gain.kp"), 10, "not switched to a page that may be damaged")
        else:
            self.assertEqual(set(codes.values()), {3})
            self.refuse(3, "set", "gain.kp=12")
        if variant != "wrong_checksum":
            self.check_recording(variant)

    def check(self, *arguments):
        answer = self.run_on(*arguments)
        self.assertIn(answer.code, (0, 3), answer)
        if answer.code:
            self.assert_one_clear_error(answer)
        return answer.code

    def check_recording(self, variant):
        path = os.path.join(self.folder, "hostile.csv")
        answer = self.run_on("record", "--duration", "0.5", "--rate", "1000", "--signals", "counter,sine", "--out", path)
        if variant in HARMLESS:
            self.assertEqual(answer.code, 0, answer)
            return
        self.assertEqual(answer.code, 3, answer)
        self.assert_one_clear_error(answer)
        self.assertFalse(os.path.exists(path), "no partial file under the final name")


def hostile_case(variant):
    return lambda self: self.check_all(variant)


class HostileFrames(HostileCase):
    """Boards that say nothing, or nonsense about what follows."""


class HostileAnswers(HostileCase):
    """Boards whose answers are wrong."""


class HostileStream(HostileCase):
    """Boards whose descriptions or samples are wrong."""


for name in HOSTILE:
    if name in STREAM_TROUBLE or name.startswith("a2l"):
        group = HostileStream
    else:
        group = HostileFrames if name.endswith("_len") or name in ("mute", "silence") else HostileAnswers
    setattr(group, f"test_{name}", hostile_case(name))


class UnrulyNetwork(unittest.TestCase):
    """Datagrams that come twice, late or never: a value never stands under another name (protocol.md 3.2)."""
    NAMES = ("gain.kp", "gain.ki", "gain.kd", "limit.current", "window.speed", "window.position", "feedforward.inertia")

    def setUp(self):
        self.running = program_target(PROGRAM, "udp").start()
        self.addCleanup(self.running.stop)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.environment = os.environ | {"XDG_CACHE_HOME": self.folder.name}

    def network(self, seed, **faults):
        relay = Relay(self.running.address, seed, **faults)
        self.addCleanup(relay.stop)
        return relay

    def values(self, uri, lossy=False):
        """None on a lossy line that was given up: after two repeats, which a busy machine needs by itself at times."""
        answer = Answer(["get", uri, *self.NAMES, "--json"], self.environment)
        if lossy and answer.code == 3:
            self.assertEqual(answer.json()["code"], "device_lost", answer)
            return None
        self.assertEqual(answer.code, 0, answer)
        return {v["name"]: v["value"] for v in answer.json()["values"]}

    def test_values_are_right_whatever_comes_twice(self):
        right = self.values(self.running.address)
        relay = self.network(1)
        for _ in range(25):
            self.assertEqual(self.values(relay.address), right)
        self.assertGreater(relay.counts["twice"], 25)

    def test_values_are_right_whatever_is_overtaken_or_lost(self):
        right = self.values(self.running.address)
        relay = self.network(2, twice=0.03, late=0.01, lost=0.01)
        seen = [self.values(relay.address, lossy=True) for _ in range(10)]
        self.assertEqual([values for values in seen if values not in (right, None)], [])
        self.assertGreaterEqual(seen.count(right), 5)
        self.assertGreater(sum(relay.counts.values()), 20)

    def test_rows_come_once_and_what_is_overtaken_is_counted(self):
        relay = self.network(3, twice=0.05, late=0.05)
        path = os.path.join(self.folder.name, "f.csv")
        answer = Answer(["record", relay.address, "--duration", "2", "--rate", "100", "--out", path, "--json"],
                        self.environment)
        self.assertEqual(answer.code, 0, answer)
        with open(path, encoding="utf-8") as file:
            times = [float(row.split(",")[0]) for row in file.read().splitlines()[1:]]
        self.assertEqual(times, sorted(set(times)), "no row twice, none out of order")
        result = answer.json()
        self.assertEqual(result["rows"], len(times))
        self.assertGreater(result["lost_rows"], 0)
        # What was overtaken behind the last row that came has no row after it to be missed from.
        self.assertIn(result["rows"] + result["lost_rows"], range(197, 201))


class OtherFirmware(ProgramCase):
    """A description of another firmware than the board's: said everywhere, and nothing is written."""
    SAID = "its description is of 'FW-OTHER'"

    def setUp(self):
        self.serve("plain")
        master = Master(self.running.address)
        master.connect()
        text = master.get_id(4).decode("utf-8")
        self.epk = master.describe().epk
        self.kept = master.read_name("gain.kp")
        master.command(0xFE)
        master.close()
        self.own = self.uri + "?a2l=" + self.describe("own.a2l", text)
        self.uri += "?a2l=" + self.describe("other.a2l", text.replace(f'"{self.epk}"', '"FW-OTHER"'))

    def describe(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_reading_is_doubtful_and_says_so(self):
        path = os.path.join(self.folder, "f.csv")
        for verb, arguments in (("describe", ()), ("get", ("gain.kp", "counter")),
                                ("record", ("--duration", "0.1", "--signals", "counter", "--out", path))):
            with self.subTest(verb=verb):
                answer = self.accept(verb, *arguments)
                self.assertRegex(answer.err, f"warning: the board runs firmware '{self.epk}', but {self.SAID}")
                quality = answer.json()["data_quality"]
                self.assertEqual(quality["verdict"], "doubtful")
                self.assertEqual([f["code"] for f in quality["findings"]], ["other_firmware"])
                self.assertTrue(quality["findings"][0]["hint"])

    def test_nothing_is_written(self):
        for verb, arguments in (("set", ("gain.kp=12",)), ("set", ("gain.kp=12", "--save")),
                                ("move", ("--arm", "--reference", "step,amplitude_deg=5", "--duration", "0.2"))):
            with self.subTest(verb=verb, arguments=arguments):
                answer = self.run_on(verb, *arguments)
                self.assertIn(answer.code, (2, 3), answer)
                self.assertIn(self.SAID, answer.err)
                self.assertTrue(answer.json()["hint"], answer)
        self.assertIn("writing is blocked", self.run_on("set", "gain.kp=12").json()["message"])
        self.assertEqual(self.board_value("gain.kp"), self.kept)
        self.assertEqual(self.board_value("hb.arm"), 0)

    def test_own_description_is_good(self):
        self.uri = self.own
        answer = self.accept("get", "gain.kp")
        self.assertEqual(answer.json()["data_quality"]["verdict"], "good")
        self.assertNotIn("firmware", answer.err)
        self.accept("set", "gain.kp=12")
        self.assertEqual(self.board_value("gain.kp"), 12)


class OtherFirmwareOfAMotor(ProgramCase):
    """The same with a board that can do all procedures, which the slave of this folder cannot: what each has
    to write is refused before anything is sent, on the wire and in both pages."""
    SAID = OtherFirmware.SAID

    def setUp(self):
        self.running = program_target(PROGRAM, "udp").start()
        self.addCleanup(self.running.stop)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.environment = os.environ | {"XDG_CACHE_HOME": self.path("cache"),
                                         "XDG_DATA_HOME": self.path("data")}
        self.tap = Tap(self.running.address)
        self.addCleanup(self.tap.stop)
        self.kept = self.memory()
        self.own = self.tap.address + "?a2l=" + self.write("own.a2l", self.text)
        other = self.text.replace(f'"{self.epk}"', '"FW-OTHER"')
        self.uri = self.tap.address + "?a2l=" + self.write("other.a2l", other)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def memory(self):
        """Every parameter on either page, read by our own master past the tap."""
        master = Master(self.running.address)
        master.connect()
        self.text = master.get_id(4).decode("utf-8")
        self.epk = master.describe().epk
        read = {}
        for page in (0, 1):
            master.set_page(2, page)
            read |= {(page, name): master.read_name(name) for name in master.a2l.parameters}
        active = master.page(1)
        master.command(0xFE)
        master.close()
        return read | {"page": active}

    def prepare(self, verb, *arguments):
        """On a simulated motor or the board's own description."""
        answer = Answer([verb, *arguments, "--force"], self.environment)
        self.assertEqual(answer.code, 0, answer)

    def said(self, *arguments):
        """The answer of a command that says which description it has and writes nothing."""
        self.tap.sent.clear()
        answer = Answer([*arguments, "--json"], self.environment)
        self.assertIn(f"warning: the board runs firmware '{self.epk}', but {self.SAID}", answer.err, answer)
        self.assertTrue(self.tap.sent, "the board was asked")
        self.assertEqual(self.tap.writes(), [], answer)
        self.assertEqual(self.memory(), self.kept, answer)
        return answer

    def assert_blocked(self, *arguments):
        answer = self.said(*arguments)
        self.assertIn(answer.code, (2, 3), answer)
        error = answer.json()
        self.assertEqual((error["schema"], error["exit_code"]), ("halbench.error/1", answer.code), answer)
        self.assertIn("writing is blocked", error["message"])
        self.assertIn("description of this firmware", error["hint"])

    def assert_doubtful(self, quality):
        self.assertEqual(quality["verdict"], "doubtful")
        self.assertIn("other_firmware", [finding["code"] for finding in quality["findings"]])

    def test_the_tap_sees_what_is_written(self):
        answer = Answer(["set", self.own, "gain.kp=12"], self.environment)
        self.assertEqual(answer.code, 0, answer)
        self.assertTrue(self.tap.writes())
        self.assertNotEqual(self.memory(), self.kept)

    def test_it_is_not_identified(self):
        self.prepare("identify", "sim:htm", "--given", "J=5.5e-4", "--out", self.path("m.json"))
        for arguments in (("--given", "J=5.5e-4", "--out", self.path("o.json")), ("--frequency",),
                          ("--relay", "--model", self.path("m.json"))):
            with self.subTest(arguments):
                self.assert_blocked("identify", self.uri, "--arm", *arguments)
        self.assertFalse(os.path.exists(self.path("o.json")))

    def test_it_is_not_calibrated(self):
        for arguments in (("hall",), ("hall", "--apply"), ("all", "--out", self.path("c.json"))):
            with self.subTest(arguments):
                self.assert_blocked("calibrate", self.uri, *arguments, "--arm")
        self.assertFalse(os.path.exists(self.path("c.json")))

    def test_no_gains_are_applied(self):
        self.prepare("identify", "sim:htm", "--given", "J=5.5e-4", "--out", self.path("m.json"))
        self.prepare("tune", self.path("m.json"), "--out", self.path("g.json"))
        for arguments in ((), ("--live",), ("--gains", self.path("g.json"))):
            with self.subTest(arguments):
                self.assert_blocked("tune", self.path("m.json"), "--apply", self.uri, "--arm",
                                    "--foreign-model", *arguments)
        self.assert_blocked("tune", self.uri, "--arm", "--given", "J=5.5e-4")

    def test_no_settings_are_restored(self):
        self.prepare("config", "save", self.own, self.path("c.toml"))
        with open(self.path("c.toml"), encoding="utf-8") as file:
            saved = file.read()
        edited = saved.replace("'gain.kp' = { value = 10,", "'gain.kp' = { value = 12,")
        self.assertNotEqual(edited, saved)
        self.write("c.toml", edited)
        for arguments in ((), ("--only", "gain.kp"), ("--save",)):
            with self.subTest(arguments):
                answer = self.said("config", "restore", self.uri, self.path("c.toml"), *arguments)
                self.assertNotEqual(answer.code, 0, answer)
                document = answer.json()
                if document["schema"] != "halbench.error/1":
                    self.assert_doubtful(document["data_quality"])
                    row, = [row for row in document["rows"] if row["name"] == "gain.kp"]
                    self.assertEqual((row["restored"], row["device"]), (False, 10))
                    self.assertIn("writing is blocked", row["reason"])

    def test_settings_that_were_read_by_it_are_doubtful(self):
        answer = self.said("config", "save", self.uri, self.path("c.toml"))
        self.assert_doubtful(answer.json()["data_quality"])
        answer = self.said("config", "compare", self.uri, self.path("c.toml"))
        self.assert_doubtful(answer.json()["data_quality"])

    STEPS = {"set": 'values = { "gain.kp" = 12 }\n',
             "move": 'reference = { shape = "step", amplitude_deg = 5 }\nduration_s = 0.5\n',
             "calibrate": 'what = "hall"\napply = true\n',
             "identify": 'given = { J = 5.5e-4 }\n'}

    def test_an_experiment_writes_nothing(self):
        for kind, step in self.STEPS.items():
            with self.subTest(kind):
                self.write("e.toml", f'schema = "halbench.experiment/1"\ntitle = "t"\ndevice = "{self.uri}"\n'
                                     f'\n[[step]]\nkind = "{kind}"\nname = "s"\n{step}')
                answer = self.said("run", self.path("e.toml"), "--arm", "--force", "--out", self.path("run"))
                self.assertNotEqual(answer.code, 0, answer)
                self.assertIn("writing is blocked", answer.out + answer.err)
                with open(self.path("run/result.json"), encoding="utf-8") as file:
                    result = json.load(file)
                self.assertFalse(result["passed"])
                self.assert_doubtful(result["data_quality"])


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
