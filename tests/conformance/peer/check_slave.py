"""Runs the checks against a slave.

    python3 check_slave.py --program build/release/halbench [Class[.case]]
    python3 check_slave.py --udp build/release/halbench [Class[.case]]
    python3 check_slave.py --slave plain [Class[.case]]
"""
import unittest

import check_base
import target
from check_line import Datagrams, Frames, PlainFrames, SelfTest
from check_measurement import Measurement
from check_parameters import Pages, Parameters, Store
from check_safety import Safety
from check_session import Identity, Memory, Session

__all__ = ["Datagrams", "Frames", "Identity", "Measurement", "Memory", "Pages", "Parameters", "PlainFrames", "Safety", "SelfTest", "Session", "Store"]

if __name__ == "__main__":
    check_base.set_target(target.from_arguments())
    unittest.main(verbosity=2)
