"""An independent XCP master over TCP, UDP and serial lines, written from protocol.md (sections 3.1, 3.2, 3.5-3.11)."""
import select
import struct
import time
from dataclasses import dataclass, field

import wire
from a2l import Description
from line import open_line
from wire import RES, ERR, EV, SERV


class XcpError(Exception):
    """The slave answered ERR."""

    def __init__(self, code, command):
        super().__init__(f"command {command:02X} answered with error {code:02X}")
        self.code = code


class NoAnswer(Exception):
    """Nothing came in time, or the connection is gone."""


@dataclass
class DaqList:
    """What one list shall measure: the items of each ODT, in order."""
    event: int
    odts: list
    prescaler: int = 1
    first_pid: int = 0
    number: int = 0
    samples: list = field(default_factory=list)      # (ticks, {name: raw}); names repeat as name#2 ...
    pending: dict = field(default_factory=dict)
    incomplete: int = 0

    def entry_names(self, odt):
        seen = {}
        for index, items in enumerate(self.odts):
            names = []
            for item in items:
                seen[item.name] = seen.get(item.name, 0) + 1
                names.append(item.name if seen[item.name] == 1 else f"{item.name}#{seen[item.name]}")
            if index == odt:
                return names
        raise IndexError(odt)


class Master:
    def __init__(self, address, timeout_s=10.0):
        self.timeout_s = timeout_s
        self.line = open_line(address, timeout_s)
        self.counter = 0
        self.expected_counter = None
        self.lost = 0
        self.is_closed = False
        self.answers, self.events, self.texts, self.dtos = [], [], [], []
        self.lists = []
        self.order = "<"
        self.max_cto, self.max_dto = 8, 8

    def close(self):
        self.line.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # ---- packets -----------------------------------------------------------------------------------------

    def send(self, *packets):
        """Sends packets in one write, whatever is outstanding."""
        self.line.send(packets, self.counter)
        self.counter += len(packets)

    def pump(self, seconds):
        """Takes in whatever arrives within this time."""
        end = time.monotonic() + seconds
        while True:
            left = end - time.monotonic()
            ready, _, _ = select.select([self.line], [], [], max(left, 0.0))
            if not ready:
                return
            self.take_in()
            if self.is_closed:
                return

    def take_in(self):
        messages, is_open = self.line.receive()
        self.is_closed = self.is_closed or not is_open
        for counter, packet in messages:
            if self.expected_counter is not None:
                self.lost += (counter - self.expected_counter) % self.line.turn
            self.expected_counter = (counter + 1) % self.line.turn
            kind = packet[0]
            if kind in (RES, ERR):
                self.answers.append(packet)
            elif kind == EV:
                self.events.append(packet)
            elif kind == SERV:
                self.texts.append(packet)
            else:
                self.dtos.append(packet)

    def answer(self, timeout_s=None):
        end = time.monotonic() + (timeout_s or self.timeout_s)
        while not self.answers:
            left = end - time.monotonic()
            if left <= 0 or self.is_closed:
                raise NoAnswer("connection closed" if self.is_closed else "timeout")
            ready, _, _ = select.select([self.line], [], [], left)
            if ready:
                self.take_in()
        return self.answers.pop(0)

    def command(self, code, layout="", *values, tail=b""):
        """Sends one command and returns what follows FF."""
        self.answers.clear()
        self.send(bytes([code]) + struct.pack(self.order + layout, *values) + tail)
        packet = self.answer()
        if packet[0] == ERR:
            raise XcpError(packet[1], code)
        return packet[1:]

    def error_of(self, code, layout="", *values, tail=b""):
        """The error code of a command that must be refused; None when it was accepted."""
        try:
            self.command(code, layout, *values, tail=tail)
        except XcpError as error:
            return error.code
        return None

    # ---- session -----------------------------------------------------------------------------------------

    def call(self):
        """CONNECT. Opening a serial port resets some boards, which do not hear the first ones (protocol.md 3.6)."""
        for _ in range(self.line.calls - 1):
            self.answers.clear()
            self.send(bytes([wire.CONNECT, 0]))
            try:
                self.answer(0.3)
                self.pump(0.1)          # answers to the calls before it
                break
            except NoAnswer:
                if self.is_closed:
                    raise
        return self.command(wire.CONNECT, "B", 0)

    def connect(self, patience_s=5.0):
        """Asks again while another master holds the session: one that vanished does for a while (protocol.md 3.2)."""
        lost = self.lost
        end = time.monotonic() + patience_s
        while True:
            try:
                answer = self.call()
                break
            except XcpError as error:
                if error.code != wire.ERR_NOT_ACCESSIBLE or time.monotonic() > end:
                    raise
                time.sleep(0.1)
        self.lost = lost                    # what an older session left on its way is discarded, not lost
        assert len(answer) == 7, f"CONNECT answers 8 octets, got {len(answer) + 1}"
        self.resource, self.comm_mode = answer[0], answer[1]
        self.order = ">" if self.comm_mode & 1 else "<"
        self.max_cto = answer[2]
        self.max_dto, self.protocol, self.transport = struct.unpack(self.order + "HBB", answer[3:7])
        return answer

    def status(self):
        session, protection, _, configuration = struct.unpack(self.order + "BBBH", self.command(wire.GET_STATUS))
        return session, protection, configuration

    def get_id(self, kind):
        answer = self.command(wire.GET_ID, "B", kind)
        mode, _, length = struct.unpack_from(self.order + "BHI", answer)
        if mode & 1:
            return answer[7:7 + length]
        return self.upload(length)

    def describe(self):
        """Uploads and reads the A2L."""
        octets = self.get_id(4)
        self.a2l = Description(octets.decode("utf-8"))
        return self.a2l

    # ---- memory ------------------------------------------------------------------------------------------

    def set_mta(self, address, extension=0):
        self.command(wire.SET_MTA, "HBI", 0, extension, address)

    def upload(self, length):
        octets = b""
        while len(octets) < length:
            octets += self.command(wire.UPLOAD, "B", min(length - len(octets), self.max_cto - 1))
        return octets

    def block_upload(self, length):
        """Slave block mode: one command, several answers in a row."""
        self.send(bytes([wire.UPLOAD, length]))
        octets, parts = b"", 0
        while len(octets) < length:
            packet = self.answer()
            if packet[0] == ERR:
                raise XcpError(packet[1], wire.UPLOAD)
            octets += packet[1:]
            parts += 1
        return octets, parts

    def read(self, item):
        """Raw value (or list) of a signal or parameter."""
        if item.size <= self.max_cto - 1:
            octets = self.command(wire.SHORT_UPLOAD, "BBBI", item.size, 0, item.extension, item.address)
        else:
            self.set_mta(item.address, item.extension)
            octets = self.upload(item.size)
        return item.decode(octets, self.order)

    def write(self, item, raw):
        octets = item.encode(raw, self.order)
        self.command(wire.SHORT_DOWNLOAD, "BBBI", len(octets), 0, item.extension, item.address, tail=octets)

    def write_octets(self, address, octets, extension=0):
        self.set_mta(address, extension)
        step = self.max_cto - 2
        for start in range(0, len(octets), step):
            part = octets[start:start + step]
            self.command(wire.DOWNLOAD, "B", len(part), tail=part)

    def read_name(self, name):
        item = self.a2l.parameters.get(name) or self.a2l.signals[name]
        return self.read(item)

    def write_name(self, name, physical):
        item = self.a2l.parameters[name]
        self.write(item, item.raw(physical))

    def checksum(self, address, size, extension=0):
        self.set_mta(address, extension)
        kind, _, value = struct.unpack(self.order + "BHI",
                                       self.command(wire.BUILD_CHECKSUM, "BHI", 0, 0, size))
        return kind, value

    # ---- pages -------------------------------------------------------------------------------------------

    def page(self, mode, segment=0):
        return self.command(wire.GET_CAL_PAGE, "BB", mode, segment)[2]

    def set_page(self, mode, page, segment=0):
        self.command(wire.SET_CAL_PAGE, "BBB", mode, segment, page)

    def copy_page(self, source, destination, segment=0):
        self.command(wire.COPY_CAL_PAGE, "BBBB", segment, source, segment, destination)

    def copy_to_idle_page(self, source, destination):
        """Right after a switch the page may still be the loop's; a board that protects it refuses until then."""
        end = time.monotonic() + self.timeout_s
        while True:
            try:
                return self.copy_page(source, destination)
            except XcpError as error:
                if error.code not in (wire.ERR_WRITE_PROTECTED, wire.ERR_BUSY) or time.monotonic() > end:
                    raise

    def transaction(self, writes):
        """Writes (item, raw) pairs to the other page and switches the control loop to it (protocol 3.10)."""
        active = self.page(1)
        other = 1 - active
        self.set_page(2, other)
        self.copy_to_idle_page(active, other)
        for item, raw in writes:
            self.write(item, raw)
        self.set_page(1, other)
        # The loop takes the page at the start of its next cycle; until then the old page is still in use.
        end = time.monotonic() + self.timeout_s
        while self.page(1) != other:
            if time.monotonic() > end:
                raise NoAnswer("the control loop did not take the page")

    # ---- measurement -------------------------------------------------------------------------------------

    def read_daq_properties(self):
        answer = self.command(wire.GET_DAQ_PROCESSOR_INFO)
        self.daq_properties, self.max_daq, self.max_event, self.min_daq, key = \
            struct.unpack(self.order + "BHHBB", answer)
        self.id_field = key >> 6
        answer = self.command(wire.GET_DAQ_RESOLUTION_INFO)
        self.granularity, self.max_entry, _, _, mode, self.ticks = struct.unpack(self.order + "BBBBBH", answer)
        self.time_size, self.time_fixed = mode & 7, bool(mode & 8)
        self.tick_s = self.ticks * wire.TIME_UNITS_S[mode >> 4]

    def allocate(self, lists):
        self.command(wire.FREE_DAQ)
        self.command(wire.ALLOC_DAQ, "BH", 0, len(lists))
        for number, daq in enumerate(lists):
            daq.number = number
            self.command(wire.ALLOC_ODT, "BHB", 0, number, len(daq.odts))
        for daq in lists:
            for odt, items in enumerate(daq.odts):
                self.command(wire.ALLOC_ODT_ENTRY, "BHBB", 0, daq.number, odt, len(items))

    def configure(self, lists):
        self.read_daq_properties()
        self.allocate(lists)
        for daq in lists:
            for odt, items in enumerate(daq.odts):
                self.command(wire.SET_DAQ_PTR, "BHBB", 0, daq.number, odt, 0)
                for item in items:
                    self.command(wire.WRITE_DAQ, "BBBI", 0xFF, item.size, item.extension, item.address)
            self.command(wire.SET_DAQ_LIST_MODE, "BHHBB", 0x10, daq.number, daq.event, daq.prescaler, 0)
            daq.first_pid = self.command(wire.START_STOP_DAQ_LIST, "BH", 2, daq.number)[0]
        self.lists = lists

    def start(self, lists):
        self.configure(lists)
        self.dtos.clear()
        self.command(wire.START_STOP_SYNCH, "B", 1)

    def stop_measuring(self):
        self.command(wire.START_STOP_SYNCH, "B", 0)
        self.assemble()

    def assemble(self):
        """Puts the DTOs that arrived together to samples."""
        for packet in self.dtos:
            self.assemble_one(packet)
        self.dtos.clear()

    def find_list(self, packet):
        """(list, ODT, octets of the identification field) of a DTO."""
        if self.id_field == 0:
            for daq in self.lists:
                if daq.first_pid <= packet[0] < daq.first_pid + len(daq.odts):
                    return daq, packet[0] - daq.first_pid, 1
            raise ValueError(f"PID {packet[0]} belongs to no list")
        if self.id_field == 1:
            return self.lists[packet[1]], packet[0], 2
        start = 1 if self.id_field == 2 else 2
        return self.lists[struct.unpack_from(self.order + "H", packet, start)[0]], packet[0], start + 2

    def assemble_one(self, packet):
        daq, odt, position = self.find_list(packet)
        if odt == 0:
            if daq.pending:
                daq.incomplete += 1
            letter = {1: "B", 2: "H", 4: "I"}[self.time_size]
            ticks = struct.unpack_from(self.order + letter, packet, position)[0]
            position += self.time_size
            daq.pending = {"next": 0, "ticks": ticks, "values": {}}
        if not daq.pending or daq.pending["next"] != odt:
            daq.incomplete += 1
            daq.pending = {}
            return
        for name, item in zip(daq.entry_names(odt), daq.odts[odt]):
            daq.pending["values"][name] = item.decode(packet[position:position + item.size], self.order)
            position += item.size
        daq.pending["next"] = odt + 1
        if odt + 1 == len(daq.odts):
            daq.samples.append((daq.pending["ticks"], daq.pending["values"]))
            daq.pending = {}

    def unwrapped_s(self, daq):
        """Time of each sample in seconds from the first, by nearest difference modulo the counter's size."""
        turn = 1 << (8 * self.time_size)
        total, times, last = 0, [], None
        for ticks, _ in daq.samples:
            if last is not None:
                step = (ticks - last) % turn
                total += step - turn if step >= turn // 2 else step
            last = ticks
            times.append(total * self.tick_s)
        return times
