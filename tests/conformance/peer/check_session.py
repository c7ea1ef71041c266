"""Session, identity, malformed commands, memory access (protocol.md 3.1, 3.2, 3.5-3.7)."""
import struct
import time

import wire
from check_base import SlaveCase, only_on
from master import XcpError
from wire import RES, ERR

# Octets that each command needs after its code.
REQUEST_LENGTH = {
    wire.GET_ID: 1, wire.SET_MTA: 7, wire.UPLOAD: 1, wire.SHORT_UPLOAD: 7, wire.BUILD_CHECKSUM: 7,
    wire.DOWNLOAD: 2, wire.SHORT_DOWNLOAD: 8, wire.SET_CAL_PAGE: 3, wire.GET_CAL_PAGE: 2, wire.COPY_CAL_PAGE: 4,
    wire.SET_DAQ_PTR: 5, wire.WRITE_DAQ: 7, wire.SET_DAQ_LIST_MODE: 7, wire.START_STOP_DAQ_LIST: 3,
    wire.START_STOP_SYNCH: 1, wire.GET_DAQ_EVENT_INFO: 3, wire.ALLOC_DAQ: 3, wire.ALLOC_ODT: 4,
    wire.ALLOC_ODT_ENTRY: 5,
}
UNUSED_CODES = (0xC1, 0xC8, 0xCF, 0xD2, 0xD0)


class Session(SlaveCase):
    def test_connect_announces_what_the_session_needs(self):
        master = self.master(describe=False)
        self.assertTrue(master.resource & 1, "CAL/PAG")
        self.assertTrue(master.resource & 4, "DAQ")
        self.assertGreaterEqual(master.max_cto, 8)
        self.assertGreaterEqual(master.max_dto, 8)
        self.assertEqual((master.protocol, master.transport), (1, 1))
        self.assertEqual(master.comm_mode & 0b110, 0, "address granularity is one octet")

    def test_status_is_idle_and_unlocked(self):
        session, protection, _ = self.master(describe=False).status()
        self.assertEqual(session & 0x41, 0)
        self.assertEqual(protection, 0)

    def test_unconnected_slave_is_silent(self):
        master = self.raw_master()
        for code in (wire.GET_STATUS, wire.SYNCH, wire.GET_DAQ_CLOCK, 0xC1):
            master.send(bytes([code]))
        self.assert_silent(master)
        master.connect()

    def test_disconnect_ends_the_session(self):
        master = self.master(describe=False)
        master.command(wire.DISCONNECT)
        master.send(bytes([wire.GET_STATUS]))
        self.assert_silent(master)
        master.connect()
        master.status()

    def test_connect_again_clears_the_measurement(self):
        master = self.master()
        item = next(iter(master.a2l.signals.values()))
        from master import DaqList
        master.start([DaqList(event=0, odts=[[item]])])
        master.pump(0.1)
        self.assertTrue(master.dtos)
        self.assertTrue(master.status()[0] & 0x40)
        master.connect()
        master.pump(0.05)
        master.dtos.clear()
        master.pump(0.1)
        self.assertEqual(master.dtos, [])
        self.assertFalse(master.status()[0] & 0x40)

    def test_unknown_commands_are_refused_with_20(self):
        master = self.master(describe=False)
        for code in UNUSED_CODES:
            self.assertEqual(master.error_of(code, "II", 0, 0), wire.ERR_UNKNOWN, f"{code:02X}")

    def test_short_commands_are_refused_with_21(self):
        master = self.master(describe=False)
        for code, length in REQUEST_LENGTH.items():
            for present in range(length):
                error = master.error_of(code, tail=bytes(present))
                if code in (wire.SHORT_DOWNLOAD, wire.DOWNLOAD) and present and present == length - 1:
                    continue                     # a download of no octets: refused or harmless
                self.assertEqual(error, wire.ERR_SYNTAX, f"{code:02X} with {present} of {length} octets")

    def test_download_announcing_more_than_it_holds_is_refused(self):
        master = self.master(describe=False)
        master.set_mta(0x10000)
        self.assertIn(master.error_of(wire.DOWNLOAD, "B", 8, tail=b"\0\0"), (wire.ERR_SYNTAX, wire.ERR_RANGE))

    def test_synch_is_answered_with_error_00(self):
        master = self.master(describe=False)
        for _ in range(3):
            self.assertEqual(master.error_of(wire.SYNCH), wire.ERR_SYNCH)

    def test_every_code_leaves_the_session_usable(self):
        master = self.master(describe=False)
        for code in range(0xC0, 0x100):
            if code in (wire.CONNECT, wire.DISCONNECT, wire.USER_CMD):
                continue
            for tail in (b"", b"\xff" * 7, b"\xff" * (master.max_cto - 1)):
                master.answers.clear()
                master.send(bytes([code]) + tail)
                self.assertIn(master.answer()[0], (RES, ERR), f"{code:02X}")
                master.pump(0)
        master.connect()
        master.status()

    def test_stimulation_packets_are_not_answered(self):
        master = self.master(describe=False)
        master.send(b"\x00\x01\x02", b"\x7f", b"\xbf\x00")
        self.assert_silent(master, 0.2)
        master.status()

    @only_on("tcp")
    def test_messages_survive_any_cut(self):
        master = self.raw_master()
        octets = wire.message(bytes([wire.CONNECT, 0]), 0) + wire.message(bytes([wire.GET_STATUS]), 1)
        for octet in octets:
            master.line.send_octets(bytes([octet]))
        self.assertEqual(master.answer()[0], RES)
        self.assertEqual(len(master.answer()), 6)

    @only_on("tcp")
    def test_nonsense_length_ends_the_connection_and_not_the_slave(self):
        master = self.master(describe=False)
        master.line.send_octets(b"\x00\x00\x00\x00" * 4 + b"\xff\xff" * 40000)
        end = time.monotonic() + 2
        while not master.is_closed and time.monotonic() < end:
            master.pump(0.05)
        self.assertTrue(master.is_closed)
        self.master(describe=False).status()

    def test_slave_counts_its_messages_without_gap(self):
        master = self.master()
        for _ in range(300):
            master.status()
        self.assertEqual(master.lost, 0)

    @only_on("tcp", "udp")
    def test_second_master_is_refused_until_the_first_one_ends(self):
        first = self.master()
        second = self.raw_master()
        for _ in range(3):
            self.assert_refused(second)
            second.send(bytes([wire.GET_STATUS]), bytes([wire.DISCONNECT]))
            self.assert_silent(second, 0.1)
            first.status()
        self.assertEqual(first.lost, 0)
        first.command(wire.DISCONNECT)
        second.connect(patience_s=0)
        second.status()
        self.assert_refused(first)

    @only_on("tcp")
    def test_master_that_leaves_frees_the_board_at_once(self):
        self.master(describe=False).close()
        self.raw_master().connect(patience_s=0)

    @only_on("tcp")
    def test_bare_connections_do_not_disturb(self):
        early = self.raw_master()                       # a port scan that came before
        master = self.master()
        self.set_in_motion(master, watchdog_ms=500)
        for _ in range(20):
            self.raw_master().close()                   # a health check
            self.raw_master()                           # one that stays open
            nonsense = self.raw_master()
            nonsense.line.send_octets(b"GET / HTTP/1.1\r\nHost: board\r\n\r\n")
            self.serve_for(master, 0.05)
        early.send(bytes([wire.GET_STATUS]))
        self.assert_silent(early, 0.1)
        self.assertEqual(master.read_name("hb.arm"), 1)
        self.assertEqual((master.lost, master.is_closed), (0, False))

    @only_on("tcp", "udp")
    def test_silent_master_with_a_watchdog_is_followed_by_the_next(self):
        first = self.master()
        self.set_in_motion(first, watchdog_ms=300)
        second = self.raw_master()
        self.assert_refused(second)
        time.sleep(0.5)
        second.connect(patience_s=0)

    @only_on("tcp", "udp")
    def test_master_that_says_nothing_keeps_its_session_while_nobody_asks(self):
        master = self.master(describe=False)
        time.sleep(4.0)
        master.status()

    def assert_refused(self, master):
        with self.assertRaises(XcpError) as refused:
            master.connect(patience_s=0)
        self.assertEqual(refused.exception.code, wire.ERR_NOT_ACCESSIBLE)

    def test_slave_survives_masters_that_vanish(self):
        for _ in range(10):
            master = self.raw_master()
            master.connect()
            master.send(bytes([wire.GET_ID, 4]), bytes([wire.UPLOAD, 5]))
            master.close()
        self.master(describe=False).status()

    def test_ends_when_told(self):
        self.master(describe=False)
        self.assertIn(self.running.stop(), (0, -15))


class Identity(SlaveCase):
    def test_texts_are_given(self):
        master = self.master()
        self.assertTrue(master.get_id(1).decode("ascii"))
        self.assertEqual(master.get_id(5).decode("ascii"), master.a2l.epk)

    def test_unknown_identification_is_empty_or_refused(self):
        master = self.master(describe=False)
        try:
            self.assertEqual(master.get_id(0x99), b"")
        except Exception as error:
            self.assertEqual(error.code, wire.ERR_RANGE)

    def test_a2l_is_the_same_at_every_upload(self):
        master = self.master(describe=False)
        self.assertEqual(master.get_id(4), master.get_id(4))

    def test_a2l_agrees_with_the_slave(self):
        master = self.master()
        self.assertEqual(master.a2l.byte_order, "MSB_LAST" if master.order == "<" else "MSB_FIRST")
        layer = master.a2l.interface.blocks("PROTOCOL_LAYER")[0]
        self.assertEqual([int(w) for w in layer[8:10]], [master.max_cto, master.max_dto])

    def test_events_agree_with_the_slave(self):
        master = self.master()
        master.read_daq_properties()
        self.assertEqual(len(master.a2l.events), master.max_event)
        for event in master.a2l.events:
            _, _, _, cycle, unit, _ = master.command(wire.GET_DAQ_EVENT_INFO, "BH", 0, event.number)
            self.assertAlmostEqual(cycle * wire.TIME_UNITS_S[unit], event.period_s)
        self.assertIsNotNone(master.error_of(wire.GET_DAQ_EVENT_INFO, "BH", 0, 99))

    def test_block_upload_where_announced(self):
        master = self.master(describe=False)
        if not master.comm_mode & 0x40:
            return                               # not announced: the master must not use it
        text = master.get_id(4)
        master.command(wire.GET_ID, "B", 4)
        octets, parts = master.block_upload(255)
        self.assertEqual(octets, text[:255])
        self.assertEqual(parts, -(-255 // (master.max_cto - 1)))
        octets, _ = master.block_upload(200)
        self.assertEqual(octets, text[255:455], "the address moved on")


class Memory(SlaveCase):
    def test_every_signal_is_read(self):
        master = self.master()
        self.assertGreater(len(master.a2l.signals), 5)
        for item in master.a2l.signals.values():
            value = item.physical(master.read(item))
            self.assertTrue(item.lower <= value <= item.upper, f"{item.name} = {value}")

    def test_signals_are_not_written(self):
        master = self.master()
        for item in master.a2l.signals.values():
            error = master.error_of(wire.SHORT_DOWNLOAD, "BBBI", item.size, 0, item.extension, item.address,
                                    tail=bytes(item.size))
            self.assertIn(error, (wire.ERR_RANGE, wire.ERR_WRITE_PROTECTED, wire.ERR_ACCESS_DENIED), item.name)

    def test_wild_addresses_are_refused(self):
        master = self.master()
        last = max(i.address for i in master.a2l.signals.values())
        for extension, address in ((0, last + 4096), (0, 0xFFFFFFFF), (0, 0xFFFFFFFC), (0x77, 0), (0, 0x7FFFFFFF)):
            self.assertIsNotNone(master.error_of(wire.SHORT_UPLOAD, "BBBI", 4, 0, extension, address),
                                 f"{extension}:{address:X}")
            self.assertIsNotNone(master.error_of(wire.SHORT_DOWNLOAD, "BBBI", 4, 0, extension, address,
                                                 tail=struct.pack("<I", 1)), f"{extension}:{address:X}")

    def test_reading_across_the_end_of_the_segment_is_refused(self):
        master = self.master()
        segment = master.a2l.segments[0]
        end = segment.address + segment.size
        self.assertIsNotNone(master.error_of(wire.SHORT_UPLOAD, "BBBI", 4, 0, 0, end - 2))
        self.assertIsNotNone(master.error_of(wire.SHORT_UPLOAD, "BBBI", 1, 0, 0, end))

    def test_checksum_is_crc16_citt_of_the_segment(self):
        master = self.master()
        segment = master.a2l.segments[0]
        master.set_mta(segment.address)
        image = master.upload(segment.size)
        self.assertEqual(master.checksum(segment.address, segment.size), (8, wire.crc16_citt(image)))
        self.assertEqual(master.checksum(segment.address, 1), (8, wire.crc16_citt(image[:1])))

    def test_checksum_beyond_the_segment_is_refused(self):
        master = self.master()
        segment = master.a2l.segments[0]
        master.set_mta(segment.address)
        self.assertIsNotNone(master.error_of(wire.BUILD_CHECKSUM, "BHI", 0, 0, segment.size + 1))
        self.assertIsNotNone(master.error_of(wire.BUILD_CHECKSUM, "BHI", 0, 0, 0xFFFFFFFF))

    def test_paged_parameters_lie_in_the_segment(self):
        master = self.master()
        segment = master.a2l.segments[0]
        inside = [p for p in master.a2l.parameters.values()
                  if p.extension == 0 and segment.address <= p.address < segment.address + segment.size]
        self.assertTrue(any(p.name == "gain.kp" for p in inside))
        for item in inside:
            self.assertLessEqual(item.address + item.size, segment.address + segment.size, item.name)
