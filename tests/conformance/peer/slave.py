"""An independent XCP slave over TCP with foreign and hostile variants, written from protocol.md.

    python3 slave.py VARIANT [PORT]     first line on stdout: listening tcp:127.0.0.1:PORT; ends with SIGTERM
"""
import select
import socket
import struct
import sys
import time

import wire
from board import Board, Refused
from board_a2l import render
from mischief import Mischief
from variants import VARIANTS
from wire import RES, ERR, EV

IDENTITY = b"independent peer"
EPK = b"peer 1"


class Daq:
    def __init__(self):
        self.odts = []
        self.event, self.prescaler, self.mode = 0, 1, 0
        self.is_selected = self.is_running = False
        self.first_pid = 0
        self.countdown = 0


class Slave:
    def __init__(self, variant):
        self.variant = variant
        self.order = variant.byte_order
        self.board = Board(self.order, 1 if variant.pages == "none" else 2,
                           1 if variant.pages == "readonly" else None)
        self.board.describe_otherwise(variant.described)
        self.mischief = Mischief(variant)
        self.mischief.spoil(self.board)
        self.a2l = self.mischief.description(render(self.board, variant).encode())
        self.is_connected = False
        self.clock_origin = 0
        self.reset_session()

    def reset_session(self):
        self.daqs, self.pointer, self.mta = [], None, (0, 0)
        self.alloc_state = 0

    # ---- commands: code -> (octets after the code at least, handler) -------------------------------------

    def table(self):
        table = {
            wire.CONNECT: (1, self.connect), wire.DISCONNECT: (0, self.disconnect),
            wire.GET_STATUS: (0, self.get_status), wire.SYNCH: (0, self.synch),
            wire.GET_COMM_MODE_INFO: (0, lambda p: bytes([0, 0, 0, 0, 0, 0, 1])),
            wire.GET_ID: (1, self.get_id), wire.SET_MTA: (7, self.set_mta),
            wire.UPLOAD: (1, self.upload), wire.SHORT_UPLOAD: (7, self.short_upload),
            wire.BUILD_CHECKSUM: (7, self.build_checksum), wire.USER_CMD: (1, self.user_command),
            wire.DOWNLOAD: (1, self.download), wire.SHORT_DOWNLOAD: (7, self.short_download),
            wire.GET_DAQ_CLOCK: (0, self.get_daq_clock),
            wire.GET_DAQ_PROCESSOR_INFO: (0, self.daq_processor_info),
            wire.GET_DAQ_RESOLUTION_INFO: (0, self.daq_resolution_info),
            wire.GET_DAQ_EVENT_INFO: (3, self.daq_event_info),
            wire.FREE_DAQ: (0, self.free_daq), wire.ALLOC_DAQ: (3, self.alloc_daq),
            wire.ALLOC_ODT: (4, self.alloc_odt), wire.ALLOC_ODT_ENTRY: (5, self.alloc_entry),
            wire.SET_DAQ_PTR: (5, self.set_daq_pointer), wire.WRITE_DAQ: (7, self.write_daq),
            wire.SET_DAQ_LIST_MODE: (7, self.set_list_mode),
            wire.START_STOP_DAQ_LIST: (3, self.start_stop_list), wire.START_STOP_SYNCH: (1, self.start_stop),
        }
        if self.variant.pages != "none":
            table.update({
                wire.SET_CAL_PAGE: (3, self.set_page), wire.GET_CAL_PAGE: (2, self.get_page),
                wire.COPY_CAL_PAGE: (4, self.copy_page),
                wire.GET_PAG_PROCESSOR_INFO: (0, lambda p: bytes([1, 0])),
                wire.GET_PAGE_INFO: (3, self.page_info),
            })
        if not self.variant.short_download:
            del table[wire.SHORT_DOWNLOAD]
        return table

    def handle(self, packet):
        """The answers to one packet."""
        code = packet[0]
        if code == wire.USER_CMD and packet[1:2] == b"\x45":
            self.board.stop(1)
            return [bytes([RES, 1])] if self.is_connected else []
        if (not self.is_connected and code != wire.CONNECT) or code < 0xC0:
            return []
        self.board.idle_ms = 0
        try:
            shortest, handler = self.table().get(code, (0, None))
            if handler is None:
                raise Refused(wire.ERR_UNKNOWN)
            if len(packet) - 1 < shortest:
                raise Refused(wire.ERR_SYNTAX)
            return [bytes([RES]) + (handler(packet[1:]) or b"")]
        except Refused as refusal:
            return [bytes([ERR, refusal.code])]

    def unpack(self, layout, octets):
        return struct.unpack_from(self.order + layout, octets)

    def pack(self, layout, *values):
        return struct.pack(self.order + layout, *values)

    # ---- session -----------------------------------------------------------------------------------------

    def connect(self, _):
        self.reset_session()
        self.is_connected = True
        self.board.has_expired = False
        basic = (1 if self.order == ">" else 0) | 0x80
        return bytes([0x05, basic, self.variant.max_cto]) + self.pack("HBB", self.variant.max_dto, 1, 1)

    def disconnect(self, _):
        self.reset_session()
        self.is_connected = False

    def get_status(self, _):
        running = 0x40 if any(d.is_running for d in self.daqs) else 0
        return bytes([running, 0, 0]) + self.pack("H", 0)

    def synch(self, _):
        raise Refused(wire.ERR_SYNCH)

    def get_id(self, p):
        texts = {0: IDENTITY, 1: IDENTITY, 4: self.a2l, 5: EPK}
        if p[0] not in texts:
            return b"\x00" + self.pack("HI", 0, 0)
        if p[0] == 4:
            self.mta = (1, 0)
            return b"\x00" + self.pack("HI", 0, self.mischief.claimed_length(len(self.a2l)))
        return b"\x01" + self.pack("HI", 0, len(texts[p[0]])) + texts[p[0]]

    def user_command(self, p):
        if p[0] != wire.USER_CLEAR:
            raise Refused(wire.ERR_RANGE)
        self.board.latch = 0
        return b"\x00"

    # ---- memory ------------------------------------------------------------------------------------------

    def read_memory(self, extension, address, count):
        if count == 0 or count > self.variant.max_cto - 1:
            raise Refused(wire.ERR_RANGE)
        if extension == 1:
            return self.a2l[address:address + count].ljust(count, b" ")
        return self.board.read(address, count)

    def set_mta(self, p):
        _, extension, address = self.unpack("HBI", p)
        self.mta = (extension, address)

    def upload(self, p):
        octets = self.read_memory(*self.mta, p[0])
        self.mta = (self.mta[0], self.mta[1] + p[0])
        return octets

    def short_upload(self, p):
        count, _, extension, address = self.unpack("BBBI", p)
        return self.read_memory(extension, address, count)

    def download(self, p):
        if len(p) < 1 + p[0]:
            raise Refused(wire.ERR_SYNTAX)
        self.board.write(self.mta[1], p[1:1 + p[0]])
        self.mta = (self.mta[0], self.mta[1] + p[0])

    def short_download(self, p):
        count, _, _, address = self.unpack("BBBI", p)
        if len(p) < 7 + count:
            raise Refused(wire.ERR_SYNTAX)
        self.board.write(address, p[7:7 + count])

    def build_checksum(self, p):
        size = self.unpack("BHI", p)[2]
        octets = self.board.read(self.mta[1], size)
        return b"\x08" + self.pack("HI", 0, self.mischief.checksum(wire.crc16_citt(octets)))

    # ---- pages -------------------------------------------------------------------------------------------

    def set_page(self, p):
        mode, segment, page = p[:3]
        if segment != 0:
            raise Refused(wire.ERR_SEGMENT)
        if page > 1:
            raise Refused(wire.ERR_PAGE)
        if mode & 1 and self.mischief.switches_in_pieces():
            self.board.copy_half(self.board.next_page, page)
        if mode & 1:
            self.board.next_page = page
        if mode & 2:
            self.board.host_page = page

    def get_page(self, p):
        if p[1] != 0:
            raise Refused(wire.ERR_SEGMENT)
        if p[0] not in (1, 2):
            raise Refused(wire.ERR_MODE)
        return bytes([0, 0, self.board.active_page if p[0] == 1 else self.board.host_page])

    def copy_page(self, p):
        source, destination = p[1], p[3]
        if source > 1 or destination > 1:
            raise Refused(wire.ERR_PAGE)
        if destination == self.board.read_only_page:
            raise Refused(wire.ERR_WRITE_PROTECTED)
        self.board.pages[destination].octets[:] = self.board.pages[source].octets

    def page_info(self, p):
        return bytes([0x3F if p[2] != self.board.read_only_page else 0x0F, 0])

    # ---- measurement -------------------------------------------------------------------------------------

    def daq_processor_info(self, _):
        return bytes([0x13 | 0x80]) + self.pack("HHBB", self.variant.max_daq, 2, 0, self.variant.id_field << 6)

    def daq_resolution_info(self, _):
        return bytes([1, 8, 1, 0, 4 | 8 | self.variant.time_unit << 4]) + self.pack("H", 1)

    def daq_event_info(self, p):
        event = self.unpack("BH", p)[1]
        if event > 1:
            raise Refused(wire.ERR_RANGE)
        return bytes([0x04, 255, 4, (1, 10)[event], 6, 0])

    def get_daq_clock(self, _):
        return bytes([0, 0, 1]) + self.pack("I", self.ticks())

    def ticks(self):
        per_cycle = {0: 1_000_000, 3: 1000}[self.variant.time_unit]
        return (self.variant.time_start + (self.board.cycles - self.clock_origin) * per_cycle) & 0xFFFFFFFF

    def require_stopped(self):
        if any(d.is_running for d in self.daqs):
            raise Refused(wire.ERR_DAQ_ACTIVE)

    def free_daq(self, _):
        self.daqs, self.pointer, self.alloc_state = [], None, 1

    def alloc_daq(self, p):
        if self.alloc_state != 1:
            raise Refused(wire.ERR_SEQUENCE)
        count = self.unpack("BH", p)[1]
        if count > 8:
            raise Refused(wire.ERR_MEMORY)
        self.daqs, self.alloc_state = [Daq() for _ in range(count)], 2

    def daq(self, number):
        if number >= len(self.daqs):
            raise Refused(wire.ERR_RANGE)
        return self.daqs[number]

    def alloc_odt(self, p):
        _, number, count = self.unpack("BHB", p)
        if self.alloc_state not in (2, 3):
            raise Refused(wire.ERR_SEQUENCE)
        if count > 16:
            raise Refused(wire.ERR_MEMORY)
        self.daq(number).odts = [[] for _ in range(count)]
        self.alloc_state = 3

    def alloc_entry(self, p):
        _, number, odt, count = self.unpack("BHBB", p)
        if self.alloc_state not in (3, 4) or odt >= len(self.daq(number).odts):
            raise Refused(wire.ERR_SEQUENCE)
        if count > 32:
            raise Refused(wire.ERR_MEMORY)
        self.daq(number).odts[odt] = [None] * count
        self.alloc_state = 4

    def set_daq_pointer(self, p):
        self.require_stopped()
        _, number, odt, entry = self.unpack("BHBB", p)
        if odt >= len(self.daq(number).odts) or entry >= len(self.daqs[number].odts[odt]):
            raise Refused(wire.ERR_RANGE)
        self.pointer = [number, odt, entry]

    def write_daq(self, p):
        self.require_stopped()
        _, size, _, address = self.unpack("BBBI", p)
        if self.pointer is None or self.pointer[2] >= len(self.daqs[self.pointer[0]].odts[self.pointer[1]]):
            raise Refused(wire.ERR_DAQ_CONFIG)
        number, odt, entry = self.pointer
        signal = next((s for s in self.board.signals if s.address == address), None)
        if signal is None or wire.type_size(signal.type) != size:
            raise Refused(wire.ERR_ACCESS_DENIED)
        self.daqs[number].odts[odt][entry] = signal
        if self.dto_length(number, odt) > self.variant.max_dto:
            raise Refused(wire.ERR_DAQ_CONFIG)
        self.pointer[2] += 1

    def dto_length(self, number, odt):
        length = (1, 2, 3, 4)[self.variant.id_field] + (4 if odt == 0 else 0)
        return length + sum(wire.type_size(s.type) for s in self.daqs[number].odts[odt] if s)

    def set_list_mode(self, p):
        mode, number, event, prescaler, _ = self.unpack("BHHBB", p)
        daq = self.daq(number)
        if event > 1 or prescaler < 1 or not mode & 0x10:
            raise Refused(wire.ERR_MODE)
        daq.mode, daq.event, daq.prescaler = mode, event, prescaler

    def start_stop_list(self, p):
        mode, number = self.unpack("BH", p)
        daq = self.daq(number)
        if mode == 1:
            raise Refused(wire.ERR_MODE)
        daq.is_selected = mode == 2
        daq.first_pid = sum(len(d.odts) for d in self.daqs[:number])
        return bytes([daq.first_pid if self.variant.id_field == 0 else 0])

    def start_stop(self, p):
        if p[0] > 2:
            raise Refused(wire.ERR_MODE)
        if p[0] == 1:
            self.clock_origin = self.board.cycles    # the clock's turns come at known times of the measurement
        for daq in self.daqs:
            if p[0] == 0:
                daq.is_running = False
            elif daq.is_selected:
                daq.is_running, daq.countdown = p[0] == 1, 0
            daq.is_selected = False

    def dto_header(self, number, odt):
        if self.variant.id_field == 0:
            return bytes([self.daqs[number].first_pid + odt])
        if self.variant.id_field == 1:
            return bytes([odt, number])
        return bytes([odt] + ([0] if self.variant.id_field == 3 else [])) + self.pack("H", number)

    def dtos(self):
        """The measurement packets of the control cycle that has just ended."""
        packets = []
        for number, daq in enumerate(self.daqs if self.mischief.streams() else []):
            if not daq.is_running or (daq.event == 1 and self.board.cycles % 10 != 0):
                continue
            daq.countdown = (daq.countdown or daq.prescaler) - 1
            if daq.countdown:
                continue
            for odt, signals in enumerate(daq.odts):
                packet = self.dto_header(number, odt)
                if odt == 0:
                    packet += self.pack("I", self.mischief.ticks(self.ticks()))
                packet += b"".join(self.board.signal_octets(s) for s in signals)
                packet += b"\x00" * (-len(packet) % self.variant.pad)
                packets.append(self.mischief.dto(packet))
        return packets


class Server:
    """Serves one master at a time: the first one that sent CONNECT, until it ends the session or leaves."""

    def __init__(self, slave, port=0):
        self.slave = slave
        self.listener = socket.create_server(("127.0.0.1", port))
        self.port = self.listener.getsockname()[1]
        self.callers = {}               # socket: splitter
        self.peer = None                # the master
        self.counter = 0
        self.started = time.monotonic()

    def send(self, packet):
        if self.peer is None:
            return
        octets = self.slave.mischief.frame(wire.message(packet, self.counter))
        self.counter += 1
        try:
            self.peer.sendall(octets)
        except OSError:
            self.drop()

    def drop(self):
        if self.peer:
            self.leave(self.peer)

    def leave(self, caller):
        self.callers.pop(caller, None)
        caller.close()
        if caller is self.peer:
            self.peer = None
            self.slave.is_connected = False
            self.slave.reset_session()

    def accept(self):
        caller, _ = self.listener.accept()
        caller.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        caller.settimeout(2.0)
        self.callers[caller] = wire.Splitter()

    def admits(self, caller, packet):
        """Whether the packet is the master's; a stranger may ask for the session, and stop the board."""
        if caller is self.peer:
            return True
        if packet[:2] == bytes([wire.USER_CMD, wire.USER_STOP]):
            self.slave.handle(packet)
        if packet[:2] != bytes([wire.CONNECT, 0]):
            return False
        if self.peer and self.slave.is_connected:
            caller.sendall(wire.message(bytes([ERR, wire.ERR_NOT_ACCESSIBLE]), 0))
            return False
        self.peer = caller
        return True

    def take_in(self, caller):
        try:
            octets = caller.recv(65536)
            packets = self.callers[caller].feed(octets) if octets else []
            for _, packet in packets:
                if self.admits(caller, packet):
                    for answer in self.slave.mischief.answers(packet, self.slave.handle(packet)):
                        self.send(answer)
        except (OSError, ValueError):
            octets = b""
        if not octets and caller in self.callers:
            self.leave(caller)

    def advance(self):
        due = int((time.monotonic() - self.started) * 1000)
        if due - self.slave.board.cycles > 500:           # the machine slept: do not replay the past
            self.started += (due - self.slave.board.cycles) / 1000
            return
        while self.slave.board.cycles < due:
            self.slave.board.tick()
            self.after_tick()

    def after_tick(self):
        if self.slave.board.has_expired and self.slave.is_connected:
            self.send(bytes([EV, wire.EV_TERMINATED, 2]))
            self.slave.is_connected = False
            self.slave.reset_session()
        for packet in self.slave.dtos():
            self.send(packet)
            if self.slave.mischief.hangs_up_now():
                self.drop()
                return

    def step(self):
        ready, _, _ = select.select([self.listener, *self.callers], [], [], 0.0005)
        for caller in list(self.callers):       # the oldest first: a master that left is known before the next asks
            if caller in ready and caller in self.callers:
                self.take_in(caller)
        if self.listener in ready:
            self.accept()
        self.advance()


def main():
    server = Server(Slave(VARIANTS[sys.argv[1]]), int(sys.argv[2]) if len(sys.argv) > 2 else 0)
    print(f"listening tcp:127.0.0.1:{server.port}", flush=True)
    while True:
        server.step()


if __name__ == "__main__":
    main()
