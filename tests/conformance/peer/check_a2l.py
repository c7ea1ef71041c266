"""The peers' own building blocks against known vectors."""
import unittest

import wire
from a2l import Description, parse_tree

TEXT = '''ASAP2_VERSION 1 61 /* comment /begin */ // another "one"
/begin PROJECT p "it ""is"" so" /begin MODULE m ""
  /begin MOD_PAR "" EPK "v1" /begin MEMORY_SEGMENT s "" DATA RAM INTERN 0x10000 64 -1 -1 -1 -1 -1
    /begin IF_DATA XCP /begin SEGMENT 0 2 0 0 0 /end SEGMENT /end IF_DATA /end MEMORY_SEGMENT /end MOD_PAR
  /begin MEASUREMENT hall.a "flux" SWORD CM 0 0 -169E-3 0.169 ECU_ADDRESS 0x8 PHYS_UNIT "T"
    /begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST EVENT 1 /end DAQ_EVENT /end IF_DATA /end MEASUREMENT
  /begin MEASUREMENT state "" UBYTE CW 0 0 0 1 ECU_ADDRESS 16 /end MEASUREMENT
  /begin COMPU_METHOD CM "" RAT_FUNC "%1" "mT" COEFFS 0 4 2 0 0 1 /end COMPU_METHOD
  /begin COMPU_METHOD CW "" TAB_VERB "%1" "" COMPU_TAB_REF T /end COMPU_METHOD
  /begin COMPU_VTAB T "" TAB_VERB 2 0 "off" 1 "on" /end COMPU_VTAB
  /begin RECORD_LAYOUT L FNC_VALUES 1 FLOAT32_IEEE ROW_DIR DIRECT /end RECORD_LAYOUT
  /begin CHARACTERISTIC block "" VAL_BLK 0x10000 L 0 CM 0 1 MATRIX_DIM 2 3 READ_ONLY /end CHARACTERISTIC
  /begin FUTURE thing /begin INNER 1 2 /end INNER /end FUTURE
  /begin IF_DATA XCP /begin DAQ DYNAMIC 0 1 0 /begin EVENT "fast" "f" 0 DAQ 255 1 6 0 /end EVENT /end DAQ /end IF_DATA
/end MODULE /end PROJECT'''


class Reader(unittest.TestCase):
    def test_reads_the_subset(self):
        a2l = Description(TEXT)
        hall, block = a2l.signals["hall.a"], a2l.parameters["block"]
        self.assertEqual((hall.address, hall.type, hall.events, hall.conversion.unit), (8, "SWORD", [1], "T"))
        # RAT_FUNC 0 4 2 0 0 1: raw = 4 phys + 2, so raw 10 is 2.
        self.assertEqual(hall.physical(10), 2.0)
        self.assertEqual(hall.raw(2.0), 10)
        self.assertEqual((block.count, block.size, block.is_read_only), (6, 24, True))
        self.assertEqual(a2l.signals["state"].conversion.words, {0: "off", 1: "on"})
        self.assertEqual((a2l.epk, a2l.segments[0].size, a2l.segments[0].pages), ("v1", 64, 2))
        self.assertEqual(a2l.events[0].period_s, 1e-3)

    def test_refuses_unbalanced_blocks(self):
        for text in ("/begin A", "/begin A /end B"):
            with self.assertRaises(ValueError):
                parse_tree(text)


class Wire(unittest.TestCase):
    def test_checksum_has_the_published_check_value(self):
        # Check value of CRC-16/CCITT-FALSE for the digits 1..9.
        self.assertEqual(wire.crc16_citt(b"123456789"), 0x29B1)

    def test_stream_is_cut_at_every_position(self):
        octets = wire.message(b"\xff\x00", 3) + wire.message(b"\xfd", 4)
        for cut in range(len(octets) + 1):
            splitter = wire.Splitter()
            found = splitter.feed(octets[:cut]) + splitter.feed(octets[cut:])
            self.assertEqual(found, [(3, b"\xff\x00"), (4, b"\xfd")])

    def test_length_zero_is_nonsense(self):
        with self.assertRaises(ValueError):
            wire.Splitter().feed(b"\0\0\0\0")


if __name__ == "__main__":
    unittest.main()
