"""What every check of a slave shares: a fresh slave and a connected master per case."""
import time
import unittest

from master import Master, NoAnswer

TARGET = None       # set by check_slave.py


def set_target(target):
    global TARGET
    TARGET = target


def only_on(*lines):
    """A case that makes sense on some lines only."""
    def decorate(case):
        def run(self):
            if self.target.line in lines:
                case(self)
        run.__doc__ = case.__doc__
        return run
    return decorate


def not_where(trait):
    """A case that asks for more than boards with this trait of theirs (target.py) have."""
    def decorate(case):
        def run(self):
            if getattr(self.target, trait):
                self.skipTest(trait)
            case(self)
        run.__doc__ = case.__doc__
        return run
    return decorate


class SlaveCase(unittest.TestCase):
    def setUp(self):
        self.target = TARGET
        self.running = TARGET.start()
        self.addCleanup(self.running.stop)

    def raw_master(self):
        master = Master(self.running.address)
        self.addCleanup(master.close)
        return master

    def master(self, describe=True):
        """Connected, and unless told otherwise with the A2L read."""
        master = self.raw_master()
        master.connect()
        if describe:
            master.describe()
        return master

    def set_in_motion(self, master, setpoint=2.0, watchdog_ms=None):
        if watchdog_ms is not None:
            master.write_name("hb.watchdog_ms", watchdog_ms)
        master.write_name("hb.mode", 1)
        master.write_name("hb.arm", 1)
        master.write_name("hb.setpoint", setpoint)

    def serve_for(self, master, seconds):
        """Lets time pass while the watchdog is fed."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            master.pump(0.05)
            master.status()

    def wait_for_value(self, master, name, expected, seconds=2.0):
        end = time.monotonic() + seconds
        while True:
            value = master.read_name(name)
            if value == expected or time.monotonic() > end:
                self.assertEqual(value, expected, name)
                return

    def assert_silent(self, master, seconds=0.3):
        master.answers.clear()
        with self.assertRaises(NoAnswer):
            master.answer(seconds)
