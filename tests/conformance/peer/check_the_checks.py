"""A check that cannot fail is a defect: slaves that break one rule must fail the case that holds it."""
import os
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
MUST_FAIL = (
    ("time_stands", "Measurement.test_lists_odts_and_prescalers_without_gap"),
    ("time_backwards", "Measurement.test_lists_odts_and_prescalers_without_gap"),
    ("short_dto", "Measurement.test_lists_odts_and_prescalers_without_gap"),
    ("no_dto", "Measurement.test_every_signal_can_be_measured"),
    ("wrong_checksum", "Memory.test_checksum_is_crc16_citt_of_the_segment"),
    ("refuses_everything", "Session.test_unknown_commands_are_refused_with_20"),
    ("a2l_garbage", "Identity.test_a2l_agrees_with_the_slave"),
    ("short_answers", "Session.test_status_is_idle_and_unlocked"),
    ("read_only_page", "Pages.test_values_of_one_set_never_mix"),
    ("no_watchdog", "Safety.test_silence_of_the_master_stops_the_motor"),
    ("accepts_anything", "Parameters.test_values_outside_the_limits_are_refused"),
    ("accepts_anything", "Parameters.test_not_a_number_is_refused"),
    ("gaps", "Measurement.test_lists_odts_and_prescalers_without_gap"),
    ("switches_in_pieces", "Pages.test_values_of_one_set_never_mix"),
)


class Checks(unittest.TestCase):
    def test_broken_slaves_are_caught(self):
        for variant, case in MUST_FAIL:
            with self.subTest(variant=variant, case=case):
                done = subprocess.run([sys.executable, os.path.join(HERE, "check_slave.py"), "--slave", variant, case],
                                      capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertRegex(done.stderr, r"FAILED \((failures|errors)=")


if __name__ == "__main__":
    unittest.main(verbosity=2)
