"""The lines themselves: datagrams, frames, damage, masters that come and go (protocol.md 3.2, 3.3)."""
import random
import struct
import time
import unittest

import line
import wire
from check_base import SlaveCase, not_where
from master import DaqList, NoAnswer, XcpError
from wire import RES


def damaged(frame, kind, random_numbers):
    """The frame with one thing wrong behind its first octet."""
    octets = bytearray(frame)
    at = random_numbers.randrange(1, len(octets))
    if kind == "flip":
        octets[at] ^= 1 << random_numbers.randrange(8)
    elif kind == "lost":
        del octets[at]
    elif kind == "extra":
        octets.insert(at, random_numbers.randrange(256))
    else:
        octets = bytearray(random_numbers.randbytes(len(octets)))
    return bytes(octets)


class SelfTest(unittest.TestCase):
    """Our own framing against the page's vectors."""

    def test_frames_are_those_of_the_page(self):
        self.assertEqual(line.sxi_frame(b"\xff\x00", 0).hex(), "9a0200ff000101")
        self.assertEqual(line.sxi_frame(b"\xfd", 1).hex(), "9a0101fd00fe01")
        self.assertEqual(line.plain_frame(b"\xff\x00", 0).hex(), "0200ff000101")
        self.assertEqual(line.plain_frame(b"\xfd", 1).hex(), "0101fd00fe01")

    def test_any_packet_comes_back_at_any_cut(self):
        numbers = random.Random(1)
        for counter in range(300):
            packet = bytes(numbers.choice((0x9A, 0x9B, 0, 1, 0xFF)) for _ in range(numbers.randrange(1, 250)))
            frame = line.sxi_frame(packet, counter)
            cut = numbers.randrange(len(frame))
            splitter = line.SxiSplitter()
            self.assertEqual(splitter.feed(frame[:cut]) + splitter.feed(frame[cut:]), [(counter & 0xFF, packet)])


class Datagrams(SlaveCase):
    def test_datagrams_are_short_and_shared(self):
        master = self.master()
        signals = list(master.a2l.signals.values())
        lists = [DaqList(event=0, odts=[signals[:12]]), DaqList(event=0, odts=[signals[:12]])]
        master.start(lists)
        master.line.datagrams.clear()
        master.pump(1.0)
        count = len(master.line.datagrams)
        messages = len(master.dtos)
        master.stop_measuring()
        self.assertGreater(count, 100)
        self.assertGreater(messages, count, "several messages share a datagram")
        self.assertLessEqual(max(master.line.datagrams), line.MOST_IN_A_DATAGRAM)
        self.assertEqual(master.lost, 0)

    def test_several_commands_in_one_datagram_are_answered(self):
        master = self.master(describe=False)
        master.line.send_octets(b"".join(wire.message(bytes([wire.GET_STATUS]), i) for i in range(5)))
        for _ in range(5):
            self.assertEqual(master.answer()[0], RES)

    def test_nonsense_is_dropped_and_the_session_goes_on(self):
        master = self.master(describe=False)
        status = wire.message(bytes([wire.GET_STATUS]), 0)
        for nonsense in (b"", b"\0", b"\0\0\0\0", b"\xff\xff\0\0", status[:-1], b"\x05" + status[1:], b"\xff" * 1400):
            master.line.send_octets(nonsense)
        self.assert_silent(master, 0.1)
        master.line.send_octets(status + status[:3])            # a whole message, then a broken one
        self.assertEqual(master.answer()[0], RES)
        master.status()

    def test_stranger_is_ignored(self):
        master = self.master(describe=False)
        stranger = self.raw_master()
        stranger.send(bytes([wire.GET_STATUS]))
        stranger.send(bytes([wire.DISCONNECT]))
        self.assert_silent(stranger, 0.2)
        self.assertEqual(master.answers, [])
        master.status()

    def test_stream_stays_with_the_master_that_connected_first(self):
        first = self.master()
        first.start([DaqList(event=0, odts=[[first.a2l.signals[self.target.moving]]])])
        first.pump(0.1)
        self.assertTrue(first.dtos)
        second = self.raw_master()
        with self.assertRaises(XcpError):
            second.connect(patience_s=0)
        first.pump(0.05)
        first.dtos.clear()
        first.pump(0.1)
        self.assertTrue(first.dtos)
        self.assertEqual((second.dtos, first.lost), ([], 0))

    def test_command_that_comes_twice_is_done_and_answered_once(self):
        master = self.master()
        for _ in range(50):
            octets = wire.message(bytes([wire.GET_STATUS]), master.counter)
            master.counter += 1
            master.line.send_octets(octets)
            master.line.send_octets(octets)
            self.assertEqual(master.answer()[0], RES)
        self.assert_silent(master, 0.2)
        connect = wire.message(bytes([wire.CONNECT, 0]), 0)     # the first one of all, late
        master.start([DaqList(event=0, odts=[[master.a2l.signals[self.target.moving]]])])
        master.line.send_octets(connect)
        self.serve_for(master, 0.2)
        self.assertTrue(master.status()[0] & 0x40, "the session was not begun anew")

    def test_command_that_was_overtaken_is_not_done(self):
        master = self.master()
        item = master.a2l.parameters["gain.kp"]
        orders = [struct.pack("<BBBBI", wire.SHORT_DOWNLOAD, item.size, 0, item.extension, item.address) +
                  item.encode(value, master.order) for value in (11, 12)]
        for number in (1, 0):
            master.line.send_octets(wire.message(orders[number], master.counter + number))
        master.counter += 2
        self.assertEqual(master.answer()[0], RES)
        self.assert_silent(master, 0.2)
        self.assertEqual(item.physical(master.read(item)), 12)

    def test_stop_of_a_stranger_is_obeyed(self):
        master = self.master()
        self.set_in_motion(master)
        stranger = self.raw_master()
        stranger.send(bytes([wire.USER_CMD, wire.USER_STOP]))
        master.pump(0.1)
        self.wait_for_value(master, "status", self.target.stopped_by_command)


class Frames(SlaveCase):
    def test_damaged_frames_are_dropped_and_the_next_one_is_answered(self):
        """200 damaged commands of four kinds: the next command is answered every time, without a repeat."""
        master = self.master(describe=False)
        numbers = random.Random(7)
        for index in range(200):
            kind = ("flip", "lost", "extra", "garbage")[index % 4]
            frame = line.sxi_frame(bytes([wire.GET_ID, 1]), master.counter)
            master.line.send_octets(damaged(frame, kind, numbers))
            master.pump(0.004)
            master.answers.clear()          # damage that the sum does not see may be answered
            master.status()
        self.assertEqual(master.line.splitter.damaged, 0)

    def test_damaged_frame_is_never_answered(self):
        master = self.master(describe=False)
        frame = line.sxi_frame(bytes([wire.GET_STATUS]), master.counter)
        for at in range(1, len(frame)):
            master.line.send_octets(frame[:at] + bytes([frame[at] ^ 0x10]) + frame[at + 1:])
        self.assert_silent(master, 0.3)
        master.status()

    def test_command_survives_any_cut(self):
        master = self.master(describe=False)
        for octet in line.sxi_frame(bytes([wire.GET_STATUS]), master.counter):
            master.line.send_octets(bytes([octet]))
            time.sleep(0.003)
        self.assertEqual(len(master.answer()), 6)

    @not_where("is_small")
    def test_every_packet_fits_the_frame(self):
        master = self.master()
        self.assertLessEqual(master.max_dto, 255)
        master.read_daq_properties()
        signals = list(master.a2l.signals.values())
        odts, room = [[]], master.max_dto - 1 - master.time_size
        for item in signals * 8:
            if room < item.size:
                odts, room = odts + [[]], master.max_dto - 1
            odts[-1].append(item)
            room -= item.size
        daq = DaqList(event=1, odts=odts[:-1])
        master.start([daq])
        self.serve_for(master, 0.5)
        master.stop_measuring()
        self.assertGreater(len(daq.samples), 20)
        self.assertEqual((daq.incomplete, master.lost, master.line.splitter.damaged), (0, 0, 0))

    def test_line_survives_masters_that_come_and_go(self):
        for _ in range(5):
            master = self.master()
            master.start([DaqList(event=0, odts=[list(master.a2l.signals.values())[:12]])])
            master.close()                  # in the middle of the stream
            time.sleep(0.1)                 # nobody listens: the line fills up
        master = self.master()
        master.status()
        self.assertEqual(master.lost, 0)

    def test_line_without_a_reader_does_not_hold_up_the_board(self):
        master = self.master()
        master.start([DaqList(event=0, odts=[list(master.a2l.signals.values())[:12]])])
        time.sleep(0.5)                     # 500 frames of about 60 octets: more than the line holds
        master.connect()
        self.assertFalse(master.status()[0] & 0x40)

    def test_what_was_on_its_way_is_discarded_by_connect(self):
        first = self.master()
        first.start([DaqList(event=0, odts=[[first.a2l.signals[self.target.moving]]])])
        time.sleep(0.1)
        first.close()
        second = self.raw_master()
        second.send(bytes([wire.CONNECT, 0]))
        try:
            self.assertEqual(second.answer()[0], RES)
        except NoAnswer:
            self.fail("CONNECT was not answered")


class PlainFrames(SlaveCase):
    """A line without framing: what tells where a command begins is the pause before it."""
    PAUSE_S = 0.1                           # twice what the page asks for

    def test_damaged_command_is_never_answered_and_the_pause_ends_it(self):
        master = self.master(describe=False)
        numbers = random.Random(7)
        for index in range(24):
            kind = ("flip", "lost", "extra", "garbage")[index % 4]
            frame = line.plain_frame(bytes([wire.GET_STATUS]), master.counter)
            master.line.send_octets(damaged(frame, kind, numbers))
            master.pump(self.PAUSE_S)
            master.answers.clear()          # garbage may be a command to the sum of words
            master.status()
        self.assertEqual(master.line.splitter.damaged, 0)

    def test_half_a_command_does_not_spoil_the_next_one(self):
        master = self.master(describe=False)
        frame = line.plain_frame(bytes([wire.GET_ID, 1]), master.counter)
        for cut in range(1, len(frame)):
            master.line.send_octets(frame[:cut])
            self.assert_silent(master, self.PAUSE_S)
            master.status()

    def test_command_survives_any_cut(self):
        master = self.master(describe=False)
        for octet in line.plain_frame(bytes([wire.GET_STATUS]), master.counter):
            master.line.send_octets(bytes([octet]))
            time.sleep(0.003)
        self.assertEqual(len(master.answer()), 6)

    def test_the_description_says_how_the_line_is(self):
        text = self.master(describe=False).get_id(4).decode("utf-8")
        sxi = text[text.index("/begin XCP_ON_SxI"):text.index("/end XCP_ON_SxI")]
        self.assertNotIn("FRAMING", sxi)
        self.assertIn("HEADER_LEN_CTR_BYTE CHECKSUM_WORD", sxi)
