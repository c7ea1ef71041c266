"""Descriptions of boards in the network are read once and kept; whatever happens to the copy does no harm.

    python3 check_cache.py build/release/halbench [Class[.case]]
"""
import os
import sys
import unittest

import halbench
from halbench import ProgramCase

FROM_CACHE, FROM_BOARD = "taken from the cache", "read from the device"


class Cache(ProgramCase):
    def setUp(self):
        super().setUp()
        self.cache = self.path("cache")

    def describe(self, uri, origin, cache=None):
        answer = self.accept("describe", uri, "--json", "--log-level", "debug",
                             env=os.environ | {"XDG_CACHE_HOME": cache or self.cache})
        self.assertIn(origin, answer.err, answer)
        return {key: value for key, value in answer.json().items() if key != "started"}     # the wall clock's

    def kept(self):
        return [os.path.join(place, name) for place, _, names in os.walk(self.cache) for name in names]

    def test_second_connection_takes_the_copy_and_says_the_same(self):
        for kind in ("tcp", "udp"):
            _, uri = self.serve(kind)
            self.assertEqual(self.describe(uri, FROM_BOARD), self.describe(uri, FROM_CACHE))
        self.assertEqual(len(self.kept()), 2, "the line is part of the description")

    def test_damaged_copy_is_ignored_and_replaced(self):
        _, uri = self.serve()
        first = self.describe(uri, FROM_BOARD)
        path, = self.kept()
        with open(path, "rb") as file:
            whole = file.read()
        for damaged in (b"", whole[:-1], whole + b" ", whole[:100] + b"#" + whole[101:], b"\0" * len(whole)):
            with open(path, "wb") as file:
                file.write(damaged)
            self.assertEqual(self.describe(uri, FROM_BOARD), first)
            with open(path, "rb") as file:
                self.assertEqual(file.read(), whole)

    def test_folder_that_cannot_be_written_changes_nothing(self):
        _, uri = self.serve()
        for _ in range(2):
            self.describe(uri, FROM_BOARD, "/dev/null")

    def test_simulated_device_is_never_kept(self):
        self.accept("describe", "sim:htm", env=os.environ | {"XDG_CACHE_HOME": self.cache})
        self.assertEqual(self.kept(), [])


if __name__ == "__main__":
    halbench.set_program(sys.argv.pop(1))
    unittest.main(verbosity=2)
