"""Everything a user can get wrong: one clear line with place and remedy, the right exit code, no file left.

    python3 check_bad_input.py build/release/halbench [Class[.case]]
"""
import json
import os
import re
import signal
import socket
import sys
import unittest

import halbench
from halbench import ProgramCase

GOOD_EXPERIMENT = '''schema = "halbench.experiment/1"
title = "A step"
device = "sim:htm?seed=1"

[[step]]
kind = "move"
name = "step100"
reference = { shape = "step", amplitude_deg = 100 }
duration_s = 1.0

[[check]]
quantity = "step100.overshoot_percent"
max = 90
'''


class Usage(ProgramCase):
    def test_what_does_not_exist_is_refused(self):
        for arguments in (["nonsense"], ["describe"], ["describe", "sim:htm", "--nonsense"], ["get", "sim:htm"],
                          ["describe", "sim:htm", "surplus"], ["record", "sim:htm"],
                          ["move", "sim:htm", "--duration", "1"], ["serve", "sim:htm"],
                          ["calibrate", "sim:htm", "everything"], ["--seed", "x", "describe", "sim:htm"],
                          ["--seed", "-1", "describe", "sim:htm"], ["--seed", "1e3", "describe", "sim:htm"],
                          ["identify", "sim:htm", "--directions", "sideways"], ["run"],
                          ["tune", "sim:htm", "--method", "magic"], ["--log-level", "loud", "describe", "sim:htm"]):
            with self.subTest(arguments=arguments):
                self.refuse(2, r"\w", *arguments)
        self.assert_nothing_left()

    def test_help_of_every_command_is_printed(self):
        for command in ("devices", "describe", "get", "set", "record", "move", "calibrate", "identify", "tune",
                        "analyse", "run", "serve", "convert", "spectrum", "import", "recordings",
                        "overlay"):
            with self.subTest(command=command):
                answer = self.accept(command, "--help")
                self.assertIn(command, answer.out)
                self.assertEqual(answer.err, "")

    def test_version_is_told_quickly(self):
        self.assertRegex(self.accept("--version").out, r"^halbench \d+\.\d+\.\d+\n$")
        self.assertIn("halbench", self.accept("--version", "--json").json())


class Addresses(ProgramCase):
    def refuse_device(self, uri, pattern=r"\w", codes=(2,)):
        with self.subTest(uri=uri):
            answer = self.run_program("describe", uri)
            self.assertIn(answer.code, codes, answer)
            self.refuse(answer.code, pattern, "describe", uri)

    def test_malformed_addresses_are_refused(self):
        for uri in ("", ":", "sim", "sim:", "htm", "sim:htm?", "sim:htm?J", "sim:htm?=1", "sim:htm?J=", "sim:htm?J=1&",
                    "sim:htm?J=1&J=2", "sim:htm??J=1", "foo:bar", "sim:nothing", "sim:linear",
                    "sim:htm ", "SIM:htm?x\ny", "tcp:", "tcp:localhost", "tcp:127.0.0.1:", "tcp:127.0.0.1:0x10",
                    "tcp:127.0.0.1:99999", "tcp:127.0.0.1:-1", "replay:", "replay:/no/such/file.csv",
                    "tcp:127.0.0.1:5555?J=1"):
            self.refuse_device(uri)

    def test_unknown_overrides_list_the_known(self):
        self.refuse_device("sim:htm?inertia=1", r"(?s)\bKs_over_Kf\b")

    def test_overrides_out_of_range_are_refused(self):
        for override in ("J=0", "J=-1", "J=nan", "J=inf", "J=1e999", "J=abc", "J=5,5e-4", "J=0x10", "c=-1e-3", "Kf=-1",
                         "phi=0", "Imax=-4", "R_a=0", "delay_samples=3", "delay_samples=0.5", "delay_samples=-1",
                         "imperfections=maybe", "chain=real", "seed=-1", "seed=abc", "seed=1.5", "ambient_C=1000",
                         "friction_scatter=-1", "Ks_over_Kf=-1"):
            self.refuse_device(f"sim:htm?{override}", override.split("=")[0])

    def test_frictionless_motors_are_legal(self):
        self.accept("describe", "sim:htm?Kf=0&c=0")

    def test_nobody_listening_is_a_device_failure(self):
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        self.refuse(3, str(port), "describe", f"tcp:127.0.0.1:{port}")


class Values(ProgramCase):
    def test_names_and_values_are_judged_before_anything_is_sent(self):
        for assignment, word in (("gain.kp", "gain.kp"), ("gain.kp=", "gain.kp"), ("=3", r"\w"), ("gain.kq=3", "gain.kq"),
                                 ("gain.kp=nan", "gain.kp"), ("gain.kp=inf", "gain.kp"), ("gain.kp=-1", "gain.kp"),
                                 ("gain.kp=1e30", "gain.kp"), ("gain.kp=ten", "gain.kp"), ("gain.kp=1,5", "gain.kp"),
                                 ("limit.current=5", "limit.current"), ("limit.temperature=200", "limit.temperature"),
                                 ("delay.samples=0.5", "delay.samples"), ("delay.samples=7", "delay.samples"),
                                 ("position=1", "position"), ("gain.kp=1=2", "gain.kp")):
            with self.subTest(assignment=assignment):
                self.refuse(2, word, "set", "sim:htm", "gain.ki=1", assignment)
        self.refuse(2, "gain.kp", "set", "sim:htm", "gain.kp=1", "gain.kp=2")
        self.refuse(2, "gain.kq", "get", "sim:htm", "gain.kp", "gain.kq")

    def test_saving_on_a_simulated_device_points_to_serve(self):
        self.refuse(2, "serve", "set", "sim:htm", "gain.kp=12", "--save")

    def test_range_and_name_are_told(self):
        self.refuse(2, r"(?=.*limit\.current)(?=.*5)(?=.*4)", "set", "sim:htm", "limit.current=5")

    def test_one_refused_value_leaves_all_as_they_were(self):
        _, uri = self.serve()
        self.refuse(2, "gain.ki", "set", uri, "gain.kp=12", "gain.ki=-1")
        answer = self.accept("get", uri, "gain.kp", "--json")
        self.assertEqual(answer.json()["values"][0]["value"], 10)


class Files(ProgramCase):
    def record(self, *more):
        return ["record", "sim:htm", "--duration", "0.1", *more]

    def test_durations_and_rates_are_judged(self):
        for option in (["--duration", "0"], ["--duration", "-1"], ["--duration", "nan"], ["--duration", "inf"],
                       ["--duration", "1s"], ["--duration", "1e12"]):
            with self.subTest(option=option):
                self.refuse(2, "duration", "record", "sim:htm", *option, "--out", "f.csv")
        for rate in ("0", "-100", "nan", "fast", "1e9", "2000"):
            with self.subTest(rate=rate):
                self.refuse(2, "rate", *self.record("--rate", rate, "--out", "f.csv"))
        self.refuse(2, r"(?=.*333 Hz)(?=.*250)(?=.*333\.33)", *self.record("--rate", "333", "--out", "f.csv"))
        self.refuse(2, "no.such", *self.record("--signals", "position,no.such", "--out", "f.csv"))
        for signals in ("position,position", "position,", ","):
            self.refuse(2, r"\w", *self.record("--signals", signals, "--out", "f.csv"))
        self.assert_nothing_left()

    def test_captures_are_judged(self):
        for pattern, more in (("1 to 4", ["a,b,c,d,e"]), ("no signal 'a'", ["a"]), ("no signal ''", [","]),
                              ("twice", ["speed,speed"]), ("--duration", ["speed", "--duration", "1"]),
                              ("--signals", ["speed", "--signals", "position"]), ("300 Hz.*333", ["speed", "--rate", "300"]),
                              ("before the trigger", ["speed", "--pre-trigger", "1"]), ("zero seconds", ["speed", "--wait", "0"]),
                              ("not a trigger", ["speed", "--trigger", "soon"]), ("no signal 'a'", ["speed", "--trigger", "a>1"]),
                              ("--pre-trigger", ["speed", "--pre-trigger", "half"])):
            with self.subTest(more=more):
                self.refuse(2, pattern, "record", "sim:htm", "--out", "f.csv", "--capture", *more)
        self.refuse(2, "belong to --capture", *self.record("--out", "f.csv", "--trigger", "now"))
        self.refuse(1, "did not come within 2 s", "record", "sim:htm", "--out", "f.csv", "--capture", "speed",
                    "--trigger", "speed>100", "--wait", "2")
        for code, pattern, more in ((2, "belong to --trigger", ["--pre-trigger", "1"]),
                                    (2, "belong to --trigger", ["--wait", "1"]),
                                    (2, "not a trigger", ["--trigger", "soon"]),
                                    (2, "no signal 'a'", ["--trigger", "a>1"]),
                                    (2, "not be negative", ["--trigger", "speed>1", "--pre-trigger", "-1"]),
                                    (2, "zero seconds", ["--trigger", "speed>1", "--wait", "0"]),
                                    (2, "does not go with --trigger", ["--trigger", "speed>1", "--reconnect"]),
                                    (1, "did not come within 2 s", ["--trigger", "speed>100", "--wait", "2"])):
            with self.subTest(more=more):
                self.refuse(code, pattern, *self.record("--out", "f.csv", *more))
        self.assert_nothing_left()

    def test_places_that_cannot_be_written_are_refused(self):
        self.write("file", "x")
        for out in ("file/f.csv", "/proc/none/f.csv", ".", "/", "/dev/null/f.csv"):
            with self.subTest(out=out):
                self.refuse(2, r"\w", *self.record("--out", out))
        self.assert_nothing_left("file")

    def test_folders_are_created(self):
        self.accept(*self.record("--out", "a/b/f.csv"))
        self.assert_nothing_left("a/b/f.csv", "a/b/f.meta.json")

    def fill_disk(self, octets, *command):
        answer = self.run_program(*command, preexec_fn=halbench.limit_file_size(octets))
        self.assertEqual(answer.code, 2, answer)
        self.assertEqual(len(answer.err.strip().split("\n")), 1, answer)
        self.assertNotIn("Unknown error", answer.err)
        return answer

    def test_full_disk_leaves_no_partial_file(self):
        for octets, command in ((1000, ["record", "sim:htm", "--duration", "10", "--out", "f.csv"]),
                                (1000, ["identify", "sim:htm", "--record", "f.csv"]),
                                (1000, ["identify", "sim:htm", "--out", "m.json"]),
                                (1000, ["move", "sim:htm", "--reference", "step,amplitude_deg=10", "--duration", "1",
                                        "--out", "f.csv"])):
            with self.subTest(command=command):
                self.fill_disk(octets, *command)
                self.assert_nothing_left()

    def test_full_disk_in_mid_recording_keeps_what_was_written(self):
        command = ["record", "sim:htm", "--duration", "10", "--rate", "1000", "--out", "f.csv"]
        answer = self.fill_disk(100_000, *command)
        self.assertRegex(answer.err, r"cannot write 'f\.csv'.*'f\.csv\.partial', halbench convert")
        self.assert_nothing_left("f.csv.partial", "f.chunks.partial", "f.meta.json.partial")
        self.assertEqual(os.path.getsize(self.path("f.csv.partial")), 100_000)
        with open(self.path("f.csv.partial"), encoding="utf-8") as file:
            kept = file.read().rpartition("\n")[0] + "\n"
        self.accept("convert", "f.csv.partial", "f.csv")
        self.accept(*command[:-1], "all.csv")
        with open(self.path("f.csv"), encoding="utf-8") as part, open(self.path("all.csv"), encoding="utf-8") as whole:
            self.assertEqual(part.read(), kept)
            self.assertTrue(whole.read().startswith(kept))

    def test_old_file_survives_a_failed_recording(self):
        self.write("f.csv", "old\n")
        self.run_program("record", "sim:htm", "--duration", "10", "--rate", "1000", "--out", "f.csv",
                         preexec_fn=halbench.limit_file_size(100_000))
        with open(self.path("f.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "old\n")
        self.assert_nothing_left("f.csv", "f.csv.partial", "f.chunks.partial", "f.meta.json.partial")

    def test_unknown_recording_formats_are_refused_with_the_known_ones(self):
        self.accept(*self.record("--out", "f.csv"))
        for name in ("f.xls", "f", "f.CSV", "f.csv.partial"):
            self.refuse(2, r"writes \.csv, \.mf4 and \.mat$", "convert", "f.csv", name)
        for name in ("f.xls", "f.mat", "f"):
            self.refuse(2, r"reads \.csv, \.mf4 and \.csv\.partial", "convert", name, "g.csv")
        self.assert_nothing_left("f.csv", "f.meta.json")

    def test_recordings_with_nonsense_are_refused_with_their_place(self):
        head = "time_s,position_rad,current_command_A\n"
        rows = "".join(f"{i / 100},{i},2\n" for i in range(50))
        for name, text in (("empty.csv", ""), ("head.csv", head), ("binary.csv", "\0\1\2" * 500),
                           ("columns.csv", "time_s,speed_rad_s\n0,1\n0.01,2\n"), ("ragged.csv", head + rows + "1,2\n"),
                           ("words.csv", head + rows + "one,2,3\n"), ("nan.csv", head + rows + "0.5,nan,2\n"),
                           ("backwards.csv", head + rows + "0.1,1,2\n"), ("twice.csv", "time_s,time_s\n0,0\n"),
                           ("slow.csv", head + "".join(f"{i},{i},2\n" for i in range(50)))):
            self.write(name, text)
            with self.subTest(name=name):
                answer = self.run_program("identify", name)
                self.assertIn(answer.code, (1, 2), answer)
                if answer.code == 2:
                    self.refuse(2, name, "identify", name)
        self.refuse(2, "none.csv", "identify", "none.csv")


class Models(ProgramCase):
    def test_constants_and_currents_are_judged(self):
        for given in ("J", "J=", "J=0", "J=-1", "J=nan", "J=x", "q=1", "=1"):
            with self.subTest(given=given):
                self.refuse(2, r"\w", "identify", "sim:htm", "--given", given)
        self.refuse(2, "J", "identify", "sim:htm", "--given", "J=1e-4", "--given", "J=2e-4")
        for currents in ("", "1:2", "4:1.6:0.2", "1.6:4:0", "1.6:4:-0.2", "1.6:5:0.2", "a:b:c", "nan:4:1", "1:4:1e-9",
                         "0:4:1:2"):
            with self.subTest(currents=currents):
                self.refuse(2, r"\w", "identify", "sim:htm", "--currents", currents)

    def test_models_and_gains_that_are_none_are_refused(self):
        texts = {"empty.json": "", "garbage.json": "{", "array.json": "[]", "other.json": '{"schema": "other/1"}',
                 "bare.json": '{"schema": "halbench.identification/1"}', "nan.json": '{"schema": NaN}',
                 "deep.json": "[" * 100000,
                 "later.json": '{"schema": "halbench.identification/99"}'}
        for name, text in texts.items():
            self.write(name, text)
            with self.subTest(name=name):
                self.refuse(2, name, "tune", name)
                self.refuse(2, name, "analyse", name, name)
        self.refuse(2, "none.json", "tune", "none.json")

    def test_targets_are_judged(self):
        for option in (["--zeta", "-1"], ["--zeta", "nan"], ["--omega-rad-s", "0"], ["--bandwidth-hz", "-3"],
                       ["--phase-margin-deg", "200"], ["--bandwidth-hz", "many"], ["--max-sensitivity", "1.5"]):
            with self.subTest(option=option):
                self.refuse(2, r"\w", "tune", "sim:htm", *option)
        for option, words in ((["--max-sensitivity", "1"], "1.1 and 3"), (["--max-sensitivity", "calm"], "--max-sensitivity"),
                              (["--current-limit-a", "-1"], "--current-limit-a"), (["--step-deg", "400"], "0 and 360"),
                              (["--current-limit-a", "40"], "device limit of 4 A")):
            with self.subTest(option=option):
                self.refuse(2, words, "tune", "sim:htm", "--method", "min-iae", *option)

    def test_references_are_judged(self):
        for reference in ("", "triangle", "step", "step,amplitude_deg", "step,amplitude_deg=", "step,amplitude_deg=nan",
                          "step,amplitude_deg=x", "step,amplitude=100,amplitude_deg=100", "step,colour=3",
                          "sine,amplitude_deg=45", "sine,amplitude_deg=45,frequency_hz=-1", "step,amplitude_deg=1e12",
                          "step,amplitude_deg=1,amplitude_deg=2"):
            with self.subTest(reference=reference):
                self.refuse(2, r"\w", "move", "sim:htm", "--reference", reference, "--duration", "1")


class Experiments(ProgramCase):
    def refuse_experiment(self, text, pattern, *more):
        self.write("e.toml", text)
        self.refuse(2, pattern, "run", "e.toml", "--out", "out", *more)
        self.assert_nothing_left("e.toml")

    def test_mistakes_are_told_with_line_and_column(self):
        wrong = (("kind = \"move\"", "kind = \"dance\"", 6, "calibrate"), ("shape = \"step\"", "shape = \"spiral\"", 8, "sine"),
                 ("duration_s = 1.0", "duration_s = \"long\"", 9, "duration_s"),
                 ("duration_s = 1.0", "duration_s = -1", 9, "duration_s"), ("duration_s = 1.0", "duration_s = nan", 9, "duration_s"),
                 ("duration_s = 1.0", "duration_ms = 1000", 9, "duration_s"),
                 ("amplitude_deg = 100", "amplitude_inch = 100", 8, "amplitude_deg"),
                 ("max = 90", "maximum = 90", 13, "max"), ("step100.overshoot_percent", "step99.overshoot_percent", 12, "step99"),
                 ("/1\"", "/9\"", 1, "halbench.experiment/1"), ("[[step]]", "[[stage]]", 5, "step"),
                 ("name = \"step100\"", "name = 100", 7, "name"), ("title = ", "title ", 2, r"\w"))
        for old, new, line, word in wrong:
            with self.subTest(new=new):
                self.assertIn(old, GOOD_EXPERIMENT)
                self.refuse_experiment(GOOD_EXPERIMENT.replace(old, new), rf"(?=.*e\.toml:{line}:\d+)(?=.*{word})")

    def test_names_are_given_once(self):
        step = GOOD_EXPERIMENT[GOOD_EXPERIMENT.index("[[step]]"):GOOD_EXPERIMENT.index("[[check]]")]
        self.refuse_experiment(GOOD_EXPERIMENT + step, "step100")

    def test_files_that_are_none_are_refused(self):
        for text in ("", "\0\1\2", "[" * 5000, "schema = 3"):
            self.refuse_experiment(text, r"e\.toml")
        self.refuse(2, "none.toml", "run", "none.toml", "--out", "out")
        self.refuse(2, r"\w", "run", ".", "--out", "out")

    def test_settings_from_the_command_line_are_judged(self):
        for setting in ("step", "step.step100.duration_s", "step.step99.duration_s=1", "step.step100.speed=1",
                        "step.step100.duration_s=x", "step.step100.duration_s=-1", "=1", "step.step100.duration_s="):
            with self.subTest(setting=setting):
                self.refuse_experiment(GOOD_EXPERIMENT, r"\w", "--set", setting)
        self.refuse_experiment(GOOD_EXPERIMENT, "bar", "--device", "foo:bar")

    def test_dry_run_moves_nothing_and_writes_nothing(self):
        self.write("e.toml", GOOD_EXPERIMENT)
        self.accept("run", "e.toml", "--dry-run", "--out", "out")
        self.assert_nothing_left("e.toml")

    def test_missed_check_exits_1_and_keeps_the_results(self):
        self.write("e.toml", GOOD_EXPERIMENT.replace("max = 90", "max = 1"))
        answer = self.run_program("run", "e.toml", "--out", "out")
        self.assertEqual(answer.code, 1, answer)
        with open(self.path("out/junit.xml"), encoding="utf-8") as file:
            self.assertIn("<failure", file.read())

    def test_folder_that_cannot_be_made_is_refused(self):
        self.write("e.toml", GOOD_EXPERIMENT)
        self.write("file", "x")
        for out in ("file", "file/out", "/proc/none/out"):
            with self.subTest(out=out):
                self.refuse(2, r"\w", "run", "e.toml", "--out", out)
        self.assert_nothing_left("e.toml", "file")

    def test_full_disk_at_the_end_of_a_run_keeps_the_result_and_names_what_is_missing(self):
        self.write("e.toml", GOOD_EXPERIMENT)
        answer = self.run_program("run", "e.toml", "--out", "out", "--quiet",
                                  preexec_fn=halbench.limit_file_size(20_000))
        self.assertEqual(answer.code, 2, answer)
        self.assertEqual(len(answer.err.strip().split("\n")), 1, answer)
        self.assertRegex(answer.err, r"missing in 'out': step100\.csv, report\.html; written: result\.json, junit\.xml;")
        self.assert_nothing_left("e.toml", "out/result.json", "out/junit.xml")
        with open(self.path("out/result.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["steps"][0]["name"], "step100")

    def test_full_disk_in_a_record_step_ends_the_run_with_its_result(self):
        self.write("e.toml", GOOD_EXPERIMENT.replace("[[step]]", '''[[step]]
kind = "record"
name = "rest"
duration_s = 10
rate_hz = 1000

[[step]]''', 1))
        answer = self.run_program("run", "e.toml", "--out", "out", "--quiet",
                                  preexec_fn=halbench.limit_file_size(100_000))
        self.assertEqual(answer.code, 2, answer)
        self.assertRegex(answer.err, r"\A[^\n]*step \"rest\": cannot write 'out/rest\.csv'[^\n]*'out/rest\.csv\.partial'[^\n]*\n\Z")
        with open(self.path("out/result.json"), encoding="utf-8") as file:
            self.assertRegex(json.load(file)["error"]["message"], "cannot write")
        self.accept("convert", "out/rest.csv.partial", "out/rest.csv")

    def test_full_disk_from_the_start_of_a_run_says_that_nothing_was_written(self):
        self.write("e.toml", GOOD_EXPERIMENT)
        answer = self.run_program("run", "e.toml", "--out", "out", "--quiet", preexec_fn=halbench.limit_file_size(100))
        self.assertEqual(answer.code, 2, answer)
        self.assertRegex(answer.err, r"\A[^\n]*missing in 'out': result\.json.*; written: nothing;[^\n]*\n\Z")
        self.assert_nothing_left("e.toml")


class Consent(ProgramCase):
    def test_real_devices_are_not_armed_without_consent(self):
        """A served board is not `sim:` any more: for the program it is hardware."""
        _, uri = self.serve()
        for arguments in (["move", uri, "--reference", "step,amplitude_deg=10", "--duration", "1"], ["identify", uri],
                          ["calibrate", uri, "stray"]):
            with self.subTest(arguments=arguments):
                self.refuse(2, "--arm", *arguments)
        self.write("e.toml", f'schema = "halbench.experiment/1"\ndevice = "{uri}"\n[[step]]\nkind = "frequency"\nname = "r"\n')
        self.refuse(2, "--arm", "run", "e.toml", "--out", "out")
        values = self.accept("get", uri, "hb.arm", "status", "--json").json()["values"]
        self.assertEqual([v["value"] for v in values], [0, 0])

    def test_without_consent_a_board_is_not_even_connected(self):
        """Connecting takes it from whoever works with it: nobody listens there, and that is not noticed."""
        nobody = "tcp:127.0.0.1:1"
        self.refuse(2, "--arm", "identify", nobody)
        self.refuse(2, "--arm", "move", nobody, "--reference", "step,amplitude_deg=10", "--duration", "1")
        self.refuse(3, nobody, "identify", nobody, "--arm")

    def test_gains_of_another_motor_are_not_written_without_a_word(self):
        _, uri = self.serve()
        self.accept("identify", "sim:htm?seed=2", "--given", "J=5.5e-4", "--out", "m.json")
        before = self.accept("get", uri, "gain.kp").out
        answer = self.refuse(2, "sim-htm-2.*sim-htm-1.*--foreign-model", "tune", "m.json", "--apply", uri, "--arm")
        self.assertNotIn("releases", answer.err)
        self.refuse(2, "--arm", "tune", "m.json", "--apply", uri, "--foreign-model")
        self.assertEqual(self.accept("get", uri, "gain.kp").out, before)
        allowed = self.run_program("tune", "m.json", "--apply", uri, "--arm", "--foreign-model", "--json")
        self.assertIn(allowed.code, (0, 1), allowed)    # 1: it moved otherwise than that motor would
        self.assertIn("other_device", [w["code"] for w in allowed.json()["warnings"]])

    def test_gains_of_another_simulated_motor_are_told(self):
        self.accept("identify", "sim:htm", "--given", "J=5.5e-4", "--out", "m.json")
        for other, told in (("sim:htm?seed=2", 1), ("sim:htm?c=1.3e-3", 1), ("sim:htm", 0)):
            with self.subTest(other=other):
                document = self.accept("tune", "m.json", "--apply", other, "--json").json()
                self.assertEqual([w["code"] for w in document["warnings"]].count("other_device"), told)
                self.assertEqual(document["warnings"], document["data_quality"]["findings"])
                answer = self.accept("tune", "m.json", "--apply", other)
                self.assertEqual(answer.out.count("other_device"), told, answer)
                kept = self.accept("tune", "m.json", "--apply", other, "--out", "g.json")
                self.assertEqual(kept.err.count("the model was identified on"), told, kept)

    def test_recording_does_not_arm(self):
        _, uri = self.serve()
        self.accept("record", uri, "--duration", "0.3", "--out", "f.csv")
        self.assertEqual(self.accept("get", uri, "hb.arm", "--json").json()["values"][0]["value"], 0)


class Serving(ProgramCase):
    def listen(self, kind, place):
        process = self.start_program("serve", "sim:htm", f"--{kind}", place)
        address = process.stdout.readline().removeprefix("listening ").strip()
        process.send_signal(signal.SIGTERM)
        return address, process.communicate(timeout=10)[1]

    def test_serves_this_machine_alone_unless_told_otherwise(self):
        for kind in ("tcp", "udp"):
            for place in ("0", ":0", "127.0.0.1:0", "localhost:0"):
                with self.subTest(kind=kind, place=place):
                    address, err = self.listen(kind, place)
                    self.assertRegex(address, rf"^{kind}:(127\.0\.0\.1|localhost):\d+$")
                    self.assertEqual(err, "")
            address, err = self.listen(kind, "0.0.0.0:0")
            self.assertRegex(address, rf"^{kind}:0\.0\.0\.0:\d+$")
            self.assertRegex(err, rf"^halbench: warning: {address} is open to the network: [^\n]*127\.0\.0\.1[^\n]*\n$")

    def require_ipv6(self):
        try:
            with socket.socket(socket.AF_INET6, socket.SOCK_STREAM) as probe:
                probe.bind(("::1", 0))
        except OSError:
            self.skipTest("this machine has no IPv6 at all")

    def test_all_addresses_of_ipv6_are_open_to_the_network_and_its_own_is_not(self):
        self.require_ipv6()
        for kind in ("tcp", "udp"):
            for place in ("[::1]:0", "[0:0:0:0:0:0:0:1]:0"):
                with self.subTest(kind=kind, place=place):
                    address, err = self.listen(kind, place)
                    self.assertRegex(address, rf"^{kind}:\[[0:]*1\]:\d+$")
                    self.assertEqual(err, "")
            for place in ("[::]:0", "[0:0:0:0:0:0:0:0]:0"):
                with self.subTest(kind=kind, place=place):
                    address, err = self.listen(kind, place)
                    self.assertRegex(address, rf"^{kind}:\[[0:]+\]:\d+$")
                    self.assertRegex(err, rf"^halbench: warning: {re.escape(address)} is open to the network"
                                          r": [^\n]+\n$")

    def test_it_is_reached_by_ipv6(self):
        self.require_ipv6()
        for kind in ("tcp", "udp"):
            for place in ("[::1]:0", "[::]:0"):
                with self.subTest(kind=kind, place=place):
                    process = self.start_program("serve", "sim:htm", f"--{kind}", place)
                    port = process.stdout.readline().strip().rsplit(":", 1)[1]
                    answer = self.accept("get", f"{kind}:[::1]:{port}", "gain.kp")
                    self.assertIn("gain.kp = 10 A/rad", answer.out)

    def test_places_that_cannot_be_listened_at_are_refused(self):
        for place in ("", "127.0.0.1", "127.0.0.1:x", "127.0.0.1:70000"):
            with self.subTest(place=place):
                self.refuse(2, r"\w", "serve", "sim:htm", "--tcp", place)
        self.refuse(3, "no.such.host.invalid", "serve", "sim:htm", "--tcp", "no.such.host.invalid:1")
        self.refuse(2, "serial", "serve", "serial:/dev/ttyS0", "--tcp", "127.0.0.1:0")
        self.refuse(2, r"\w", "serve", "sim:htm", "--udp", "127.0.0.1")
        self.refuse(3, "udp:no.such.host.invalid", "serve", "sim:htm", "--udp", "no.such.host.invalid:1")
        self.refuse(2, "one of", "serve", "sim:htm", "--udp", "127.0.0.1:0", "--pty")
        self.refuse(2, "one of", "serve", "sim:htm")
        self.refuse(2, "--pty", "serve", "sim:htm", "--tcp", "127.0.0.1:0", "--framing", "off")
        for option, value, allowed in (("--framing", "none", "off, on"), ("--header", "byte", "len_ctr_byte"),
                                       ("--checksum", "crc", "none, byte, word")):
            self.refuse(2, allowed, "serve", "sim:htm", "--pty", option, value)

    def test_faults_that_make_no_sense_are_refused_by_their_name(self):
        for option, values in (("--drop", ("2", "-0.1", "nan", "inf", "x", "")),
                               ("--corrupt", ("1.5", "nan", "1%")),
                               ("--latency-ms", ("-1", "nan", "20ms", "1e9"))):
            for value in values:
                with self.subTest(option=option, value=value):
                    self.refuse(2, option, "serve", "sim:htm", "--tcp", "127.0.0.1:0", option, value)

    def test_master_works_over_every_line_that_loses_and_delays(self):
        for kind in ("tcp", "udp", "pty"):
            with self.subTest(kind=kind):
                faults = ("--drop", "0.01", "--corrupt", "0.001", "--latency-ms", "5", "--seed", "3")
                process, address = self.serve(kind, *faults)
                device = "serial:" + address[4:] if kind == "pty" else address
                self.assertIn("gain.kp = 10 A/rad", self.accept("get", device, "gain.kp").out)
                self.accept("record", device, "--duration", "1", "--out", self.path("rows.csv"))
                process.send_signal(signal.SIGTERM)
                self.assertRegex(process.communicate(timeout=10)[1], r"^halbench: \d+ messages, \d+ dropped, \d+ corrupted\n$")
                self.assertEqual(process.returncode, 0)

    def test_rows_that_a_line_lost_are_told_beside_the_recording(self):
        _, address = self.serve("tcp", "--drop", "0.05")
        answer = self.accept("record", address, "--duration", "2", "--out", self.path("rows.csv"))
        self.assertRegex(answer.err, r"\d+ of 200 rows are missing: \d+(\.\d+)? % of the packets were lost")

    def test_occupied_port_is_told(self):
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            answer = self.run_program("serve", "sim:htm", "--tcp", f"127.0.0.1:{port}", timeout=10)
            self.assertIn(answer.code, (2, 3), answer)
            self.assertIn(str(port), answer.err)


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
