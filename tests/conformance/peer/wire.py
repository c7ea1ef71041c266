"""What both peers know of the wire: message framing on TCP, codes, checksum.

Written from resources/help/protocol.md only; shares no code with the product.
"""
import struct

RES, ERR, EV, SERV = 0xFF, 0xFE, 0xFD, 0xFC

CONNECT, DISCONNECT, GET_STATUS, SYNCH = 0xFF, 0xFE, 0xFD, 0xFC
GET_COMM_MODE_INFO, GET_ID, SET_REQUEST, GET_SEED, UNLOCK = 0xFB, 0xFA, 0xF9, 0xF8, 0xF7
SET_MTA, UPLOAD, SHORT_UPLOAD, BUILD_CHECKSUM, USER_CMD = 0xF6, 0xF5, 0xF4, 0xF3, 0xF1
DOWNLOAD, SHORT_DOWNLOAD = 0xF0, 0xED
SET_CAL_PAGE, GET_CAL_PAGE, GET_PAG_PROCESSOR_INFO = 0xEB, 0xEA, 0xE9
GET_SEGMENT_INFO, GET_PAGE_INFO, COPY_CAL_PAGE = 0xE8, 0xE7, 0xE4
SET_DAQ_PTR, WRITE_DAQ, SET_DAQ_LIST_MODE, GET_DAQ_LIST_MODE = 0xE2, 0xE1, 0xE0, 0xDF
START_STOP_DAQ_LIST, START_STOP_SYNCH, GET_DAQ_CLOCK = 0xDE, 0xDD, 0xDC
GET_DAQ_PROCESSOR_INFO, GET_DAQ_RESOLUTION_INFO, GET_DAQ_EVENT_INFO = 0xDA, 0xD9, 0xD7
FREE_DAQ, ALLOC_DAQ, ALLOC_ODT, ALLOC_ODT_ENTRY = 0xD6, 0xD5, 0xD4, 0xD3
GET_VERSION = 0xC0

ERR_SYNCH, ERR_BUSY, ERR_DAQ_ACTIVE = 0x00, 0x10, 0x11
ERR_UNKNOWN, ERR_SYNTAX, ERR_RANGE, ERR_WRITE_PROTECTED, ERR_ACCESS_DENIED = 0x20, 0x21, 0x22, 0x23, 0x24
ERR_PAGE, ERR_MODE, ERR_SEGMENT, ERR_SEQUENCE, ERR_DAQ_CONFIG = 0x26, 0x27, 0x28, 0x29, 0x2A
ERR_MEMORY, ERR_GENERIC, ERR_NOT_ACCESSIBLE = 0x30, 0x31, 0x33

EV_STORE_DONE, EV_OVERLOAD, EV_TERMINATED, EV_USER = 0x03, 0x06, 0x07, 0xFE
USER_STOP, USER_CLEAR = 0x45, 0x52

TIME_UNITS_S = {code: 10.0 ** (code - 9) for code in range(10)}

# Type name -> struct letter; the sizes follow from it.
TYPES = {
    "UBYTE": "B", "SBYTE": "b", "UWORD": "H", "SWORD": "h", "ULONG": "I", "SLONG": "i",
    "A_UINT64": "Q", "A_INT64": "q", "FLOAT32_IEEE": "f", "FLOAT64_IEEE": "d",
}


def type_size(name):
    return struct.calcsize("<" + TYPES[name])


def crc16_citt(octets):
    """CRC16-CITT: polynomial 1021, start FFFF, not reflected, no final exclusive-or (protocol 3.5)."""
    crc = 0xFFFF
    for octet in octets:
        crc ^= octet << 8
        for _ in range(8):
            crc = ((crc << 1) ^ 0x1021) & 0xFFFF if crc & 0x8000 else (crc << 1) & 0xFFFF
    return crc


def message(packet, counter):
    """LEN u16 | CTR u16 | PACKET, always little endian (protocol 3.2)."""
    return struct.pack("<HH", len(packet), counter & 0xFFFF) + packet


class Splitter:
    """Cuts a TCP byte stream, fed in any pieces, into (counter, packet)."""

    def __init__(self, longest=65535):
        self.buffer = bytearray()
        self.longest = longest

    def feed(self, octets):
        self.buffer += octets
        found = []
        while len(self.buffer) >= 4:
            length, counter = struct.unpack_from("<HH", self.buffer)
            if length == 0 or length > self.longest:
                raise ValueError(f"nonsense LEN {length}")
            if len(self.buffer) < 4 + length:
                break
            found.append((counter, bytes(self.buffer[4:4 + length])))
            del self.buffer[:4 + length]
        return found
