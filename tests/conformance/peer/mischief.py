"""Where a hostile slave departs from the protocol. A well-behaved one passes through here unchanged."""
import random
import struct

import wire
from wire import RES, ERR, EV

DESCRIPTIONS = {
    "a2l_garbage": lambda text: bytes(random.Random(1).choices(b"/begin end \"{}%&x09\n", k=20000)),
    "a2l_binary": lambda text: random.Random(2).randbytes(20000),
    "a2l_many_blocks": lambda text: text + b"/begin A /end A " * 50000,
    "a2l_deep": lambda text: b"/begin A " * 20000,
    "a2l_empty": lambda text: b"",
}


RESTART_AFTER_DTOS, PAUSE_CYCLES = 50, 300


class Mischief:
    def __init__(self, variant):
        self.kind = variant.mischief
        self.order = variant.byte_order
        self.previous = bytes([RES])
        self.dto_count = 0
        self.is_past_connect = False
        self.clock_origin = 0           # what is taken from the clock since it started again
        self.pause_cycles = 0

    def description(self, text):
        return DESCRIPTIONS.get(self.kind, lambda t: t)(text)

    def claimed_length(self, length):
        return 0xFFFFFFF0 if self.kind == "a2l_huge" else length

    def checksum(self, value):
        return value ^ 0x5555 if self.kind == "wrong_checksum" else value

    def ticks(self, ticks):
        if self.kind == "time_stands":
            return 12345
        if self.kind == "time_backwards":
            return (0x40000000 - ticks) & 0xFFFFFFFF
        if self.kind.startswith("clock_restarts") and self.dto_count == RESTART_AFTER_DTOS:
            self.clock_origin = ticks
        return ticks - self.clock_origin

    def dto(self, packet):
        self.dto_count += 1
        if self.kind == "pid_out_of_range":
            return bytes([0xE0]) + packet[1:]
        if self.kind == "short_dto":
            return packet[:-2]
        return packet

    def spoil(self, board):
        """Breaks one rule of the board itself."""
        if self.kind == "no_watchdog":
            board.watch = lambda: None
        if self.kind == "accepts_anything":
            for memory in board.pages + [board.live]:
                memory.are_limits_kept = False

    def switches_in_pieces(self):
        return self.kind == "switches_in_pieces"

    def streams(self):
        if self.kind == "clock_restarts_after_a_pause" and self.dto_count == RESTART_AFTER_DTOS:
            self.pause_cycles += 1
            if self.pause_cycles <= PAUSE_CYCLES:
                return False
        return self.kind != "no_dto" and not (self.kind == "gaps" and random.random() < 0.01)

    def hangs_up_now(self):
        return self.kind == "hangs_up_in_stream" and self.dto_count == 40

    def frame(self, octets):
        if not self.is_past_connect:
            return octets
        if self.kind == "lying_len":                     # longer than what follows: the stream loses its grid
            return struct.pack("<H", struct.unpack_from("<H", octets)[0] + 3) + octets[2:]
        if self.kind == "zero_len":
            return b"\x00\x00" + octets[2:]
        if self.kind == "endless_len":
            return b"\xff\xff" + octets[2:]
        return octets

    def answers(self, command, answers):
        """What is sent instead of the right answers to a command."""
        if command[0] == wire.CONNECT:
            return self.connect_answers(answers)
        self.is_past_connect = True
        if self.kind in ("mute", "silence"):
            return []
        if self.kind == "refuses_everything":
            return [bytes([ERR, wire.ERR_GENERIC])]
        if self.kind == "short_answers":
            return [answer[:1] if answer[0] == RES else answer for answer in answers]
        if self.kind == "wrong_answers":
            late, self.previous = self.previous, answers[-1] if answers else self.previous
            return [late]
        if self.kind == "event_flood":
            return [bytes([EV, wire.EV_OVERLOAD])] * 300 + answers
        return answers

    def connect_answers(self, answers):
        if self.kind == "mute":
            return []
        if self.kind == "short_connect":
            return [answer[:3] for answer in answers]
        if self.kind == "tiny_max_cto":
            return [answer[:3] + b"\x02\x01\x00" + answer[6:] for answer in answers]
        return answers
