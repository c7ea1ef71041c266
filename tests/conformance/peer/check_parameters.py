"""Every parameter at its limits, refusals, calibration pages and atomic switches (protocol.md 3.10, 3.13)."""
import math
import struct

import wire
from check_base import SlaveCase
from master import XcpError


def tunable(master, target):
    return [p for p in master.a2l.parameters.values() if not p.is_read_only and p.name not in target.triggers]


def stored(item, limit):
    """A limit as the board may keep it: 0.05 is 0.0500000007 as FLOAT32, 4294967295 is 4294967296."""
    raw = item.raw(limit)
    is_float = item.type == "FLOAT32_IEEE" or item.type[1:] == "LONG"
    return struct.unpack("<f", struct.pack("<f", raw))[0] if is_float else raw


class Parameters(SlaveCase):
    def first_element(self, master, item):
        value = master.read(item)
        return value[0] if item.count > 1 else value

    def test_every_parameter_takes_its_limits_and_is_restored(self):
        master = self.master()
        for item in tunable(master, self.target):
            before = self.first_element(master, item)
            for value in (item.raw(item.lower), before, item.raw(item.upper), before):
                with self.subTest(item.name, value=value):
                    master.write(item, value)
                    octets = item.encode(value, master.order)
                    self.assertEqual(item.encode(self.first_element(master, item), master.order), octets)

    def test_initial_values_are_within_their_limits(self):
        master = self.master()
        for item in master.a2l.parameters.values():
            values = master.read(item)
            for value in values if item.count > 1 else [values]:
                self.assertTrue(math.isfinite(value), item.name)
                if not item.is_read_only:
                    self.assertTrue(item.lower <= item.physical(value) <= item.upper, f"{item.name} = {value}")

    def refused_or_limited(self, master, item, octets):
        """The board keeps what can hurt inside its limits whatever a foreign tool writes."""
        error = master.error_of(wire.SHORT_DOWNLOAD, "BBBI", len(octets), 0, item.extension, item.address,
                                tail=octets)
        value = item.physical(self.first_element(master, item))
        self.assertTrue(math.isfinite(value), f"{item.name} = {value}")
        lower, upper = (item.physical(stored(item, limit)) for limit in (item.lower, item.upper))
        self.assertTrue(lower <= value <= upper, f"{item.name} = {value}, error {error}")

    def test_values_outside_the_limits_are_refused(self):
        master = self.master()
        for item in tunable(master, self.target):
            if item.type.startswith("FLOAT"):
                span = max(abs(item.upper), abs(item.lower), 1.0)
                wrong = [item.upper + span, item.lower - span]
            else:
                bits = 8 * wire.type_size(item.type)
                lowest, highest = (-(1 << bits - 1), (1 << bits - 1) - 1) if item.type[0] == "S" else (0, (1 << bits) - 1)
                wrong = [v for v in (item.raw(item.upper) + 1, item.raw(item.lower) - 1) if lowest <= v <= highest]
            for value in wrong:
                with self.subTest(item.name, value=value):
                    self.refused_or_limited(master, item, item.encode(value, master.order))

    def test_not_a_number_is_refused(self):
        master = self.master()
        for item in tunable(master, self.target):
            if item.type.startswith("FLOAT"):
                for value in (math.nan, math.inf, -math.inf):
                    with self.subTest(item.name, value=value):
                        self.refused_or_limited(master, item, item.encode(value, master.order))

    def test_not_a_number_does_not_enter_in_pieces(self):
        """Two halves of a NaN, and the low half first: no write of a part may leave a wrong whole."""
        master = self.master()
        item = master.a2l.parameters["gain.kp"]
        octets = item.encode(math.nan, master.order)
        for part in ((0, 2), (2, 2), (3, 1), (2, 1)):
            start, count = part
            master.error_of(wire.SHORT_DOWNLOAD, "BBBI", count, 0, item.extension, item.address + start,
                            tail=octets[start:start + count])
            value = master.read(item)
            self.assertTrue(item.lower <= value <= item.upper, f"{part}: {value}")

    def test_read_only_parameters_are_refused(self):
        master = self.master()
        for item in master.a2l.parameters.values():
            if item.is_read_only:
                self.assertIsNotNone(master.error_of(wire.SHORT_DOWNLOAD, "BBBI", 1, 0, item.extension, item.address,
                                                     tail=b"\0"), item.name)

    def test_download_moves_the_address(self):
        master = self.master()
        master.set_mta(master.a2l.segments[0].address)
        image = master.upload(24)
        master.write_octets(master.a2l.segments[0].address, image[:8])
        master.command(wire.DOWNLOAD, "B", 4, tail=image[8:12])
        self.assertEqual(master.upload(12), image[12:24])


class Pages(SlaveCase):
    def setUp(self):
        super().setUp()
        self.m = self.master()
        self.first, self.last = (self.m.a2l.parameters[n] for n in ("set.first", "set.last"))
        self.kp = self.m.a2l.parameters["gain.kp"]
        self.segment = self.m.a2l.segments[0]

    def image(self, page):
        self.m.set_page(2, page)
        self.m.set_mta(self.segment.address)
        return self.m.upload(self.segment.size)

    def test_there_is_one_segment_of_two_pages(self):
        self.assertEqual(self.m.command(wire.GET_PAG_PROCESSOR_INFO)[0], 1)
        self.assertEqual(self.segment.pages, 2)

    def test_pages_are_separate_and_copied(self):
        before = self.m.read(self.kp)
        self.m.set_page(2, 1 - self.m.page(1))
        self.m.write(self.kp, 3.25)
        self.m.set_page(2, self.m.page(1))
        self.assertEqual(self.m.read(self.kp), before)
        active = self.m.page(1)
        self.m.copy_page(active, 1 - active)
        self.assertEqual(self.image(0), self.image(1))

    def test_wrong_segments_and_pages_are_refused(self):
        self.assertIsNotNone(self.m.error_of(wire.SET_CAL_PAGE, "BBB", 3, 1, 0))
        self.assertIsNotNone(self.m.error_of(wire.SET_CAL_PAGE, "BBB", 3, 0, 2))
        self.assertIsNotNone(self.m.error_of(wire.GET_CAL_PAGE, "BB", 1, 7))
        self.assertIsNotNone(self.m.error_of(wire.COPY_CAL_PAGE, "BBBB", 0, 0, 0, 9))
        self.assertIsNotNone(self.m.error_of(wire.COPY_CAL_PAGE, "BBBB", 0, 5, 0, 0))

    def test_values_of_one_set_never_mix(self):
        before = self.m.read_name("torn_count")
        for n in range(1, 1001):
            self.m.transaction([(self.first, n), (self.kp, 1.0 + n % 50), (self.last, n)])
        self.assertEqual(self.m.read(self.kp), 1.0)
        self.assertEqual(self.m.read_name("torn_count"), before)

    def test_torn_count_sees_a_mixed_set(self):
        """The counter of the case above can count: a set written in place is mixed for many cycles."""
        before = self.m.read_name("torn_count")
        self.m.set_page(2, self.m.page(1))
        self.m.write(self.first, 12345)
        self.m.pump(0.1)
        self.assertGreater(self.m.read_name("torn_count"), before)

    def test_values_of_one_set_never_mix_while_the_motor_turns(self):
        self.set_in_motion(self.m)
        before = self.m.read_name("torn_count")
        for n in range(1, 101):
            self.m.transaction([(self.first, n), (self.last, n)])
        self.assertEqual(self.m.read_name("torn_count"), before)
        self.assertEqual(self.m.read_name("hb.arm"), 1)

    def transaction_steps(self, active):
        other = 1 - active
        return [lambda m: m.set_page(2, other), lambda m: m.copy_page(active, other),
                lambda m: m.write(m.a2l.parameters["set.first"], 7),
                lambda m: m.write(m.a2l.parameters["gain.kp"], 2.5),
                lambda m: m.write(m.a2l.parameters["set.last"], 7),
                lambda m: m.checksum(self.segment.address, self.segment.size)]

    def test_link_cut_inside_a_transaction_changes_nothing(self):
        active = self.m.page(1)
        before = self.image(active)
        steps = self.transaction_steps(active)
        for done in range(len(steps) + 1):
            self.m.close()          # which holds the session
            cut = self.master()
            for step in steps[:done]:
                step(cut)
            cut.close()
            self.m = self.master()
            self.assertEqual(self.m.page(1), active)
            self.assertEqual(self.image(active), before, f"after {done} commands")

    def test_checksum_differs_between_pages_that_differ(self):
        active = self.m.page(1)
        self.m.copy_page(active, 1 - active)
        self.m.set_page(2, 1 - active)
        same = self.m.checksum(self.segment.address, self.segment.size)
        self.m.write(self.kp, struct.unpack("<f", struct.pack("<f", 7.77))[0])
        self.assertNotEqual(self.m.checksum(self.segment.address, self.segment.size), same)


class Store(SlaveCase):
    def test_store_request_is_answered(self):
        """A board without non-volatile memory refuses; one with it reports the end by EV 03."""
        master = self.master()
        try:
            master.command(wire.SET_REQUEST, "BH", 1, 0)
        except XcpError as error:
            self.assertIn(error.code, (wire.ERR_UNKNOWN, wire.ERR_RANGE, wire.ERR_ACCESS_DENIED, wire.ERR_GENERIC,
                                       wire.ERR_MODE))
            return
        master.pump(1.0)
        self.assertTrue(any(e[1] == wire.EV_STORE_DONE for e in master.events))
