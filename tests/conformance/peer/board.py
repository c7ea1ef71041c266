"""The board behind the independent slave: a small control loop with signals, two calibration pages and a watchdog."""
import math
import struct
from dataclasses import dataclass

from wire import type_size, TYPES

SIGNAL_BASE, LIVE_BASE, SEGMENT_BASE = 0x1000, 0x30000, 0x20000
WORDS = {
    "status": {0: "idle", 1: "armed", 2: "stopped by command", 3: "stopped by watchdog", 4: "fault"},
}


@dataclass
class Signal:
    name: str
    type: str
    unit: str = ""
    slope: float = 1.0
    lower: float = -1e6
    upper: float = 1e6
    address: int = 0
    label: str = ""             # in the description, when not the name


@dataclass
class Parameter:
    name: str
    type: str
    unit: str
    lower: float
    upper: float
    default: float
    count: int = 1
    address: int = 0

    @property
    def size(self):
        return type_size(self.type) * self.count


def signal_table():
    signals = [
        Signal("counter", "ULONG", upper=4294967295.0, lower=0),
        Signal("sine", "FLOAT32_IEEE", "A", lower=-4, upper=4),
        Signal("wide", "FLOAT64_IEEE", "rad"),
        Signal("level", "SWORD", "V", slope=0.01, lower=-300, upper=300),
        Signal("counter_again", "ULONG", upper=4294967295.0, lower=0),
        Signal("speed", "FLOAT32_IEEE", "rad/s"),
        Signal("status", "UBYTE", lower=0, upper=4),
        Signal("torn_count", "ULONG", upper=4294967295.0, lower=0),
    ]
    for index, signal in enumerate(signals):
        signal.address = SIGNAL_BASE + 8 * index
    return signals


def place(parameters, address):
    for parameter in parameters:
        size = type_size(parameter.type)
        address = (address + size - 1) // size * size
        parameter.address = address
        address += parameter.size
    return parameters


def segment_table():
    return place([
        Parameter("set.first", "ULONG", "", 0, 4294967295, 0),
        Parameter("gain.kp", "FLOAT32_IEEE", "A/rad", 0, 1000, 10),
        Parameter("gain.ki", "FLOAT32_IEEE", "A/(rad*s)", 0, 500, 0.5),
        Parameter("gain.kd", "FLOAT32_IEEE", "A*s/rad", 0, 50, 0),
        Parameter("divider", "UWORD", "", 1, 500, 10),
        Parameter("trim", "SBYTE", "", -100, 100, -5),
        Parameter("curve", "FLOAT32_IEEE", "A", -4, 4, 1.5, count=4),
        Parameter("set.last", "ULONG", "", 0, 4294967295, 0),
    ], SEGMENT_BASE)


def live_table():
    return place([
        Parameter("hb.arm", "UBYTE", "", 0, 1, 0),
        Parameter("hb.mode", "UBYTE", "", 0, 3, 0),
        Parameter("hb.setpoint", "FLOAT32_IEEE", "A", -4, 4, 0),
        Parameter("hb.watchdog_ms", "ULONG", "ms", 0, 2000, 0),
        Parameter("hb.stop", "UBYTE", "", 0, 1, 0),
    ], LIVE_BASE)


class Refused(Exception):
    def __init__(self, code):
        super().__init__(f"error {code:02X}")
        self.code = code


class Memory:
    """Parameters as octets in the board's byte order, with a table of limits."""

    def __init__(self, base, parameters, order):
        self.base, self.parameters, self.order = base, parameters, order
        self.are_limits_kept = True
        last = parameters[-1]
        self.octets = bytearray(last.address + last.size - base)
        for parameter in parameters:
            for index in range(parameter.count):
                self.put(parameter, self.cast(parameter, parameter.default), index)

    @staticmethod
    def cast(parameter, value):
        return float(value) if parameter.type.startswith("FLOAT") else int(value)

    def put(self, parameter, value, index=0):
        struct.pack_into(self.order + TYPES[parameter.type], self.octets,
                         parameter.address - self.base + index * type_size(parameter.type), value)

    def get(self, name, index=0):
        parameter = next(p for p in self.parameters if p.name == name)
        return struct.unpack_from(self.order + TYPES[parameter.type], self.octets,
                                  parameter.address - self.base + index * type_size(parameter.type))[0]

    def read(self, address, count):
        start = address - self.base
        if start < 0 or start + count > len(self.octets):
            raise Refused(0x22)
        return bytes(self.octets[start:start + count])

    def write(self, address, octets):
        """All or nothing: refused when one touched value would leave its limits or not be finite."""
        self.read(address, len(octets))
        before = bytes(self.octets)
        self.octets[address - self.base:address - self.base + len(octets)] = octets
        if not self.are_limits_kept:
            return
        for parameter in self.parameters:
            for index in range(parameter.count):
                value = self.get(parameter.name, index)
                if not (math.isfinite(value) and parameter.lower <= value <= parameter.upper):
                    self.octets[:] = before
                    raise Refused(0x22)


class Board:
    """One call of tick() is one control cycle of 1 ms."""

    def __init__(self, order="<", pages=2, read_only_page=None):
        self.order = order
        self.signals = signal_table()
        self.live = Memory(LIVE_BASE, live_table(), order)
        self.pages = [Memory(SEGMENT_BASE, segment_table(), order) for _ in range(pages)]
        self.read_only_page = read_only_page
        self.active_page = self.next_page = self.host_page = 0
        self.values = {signal.name: 0 for signal in self.signals}
        self.latch = 0              # 0 none, 1 command, 2 watchdog
        self.cycles = 0
        self.idle_ms = 0
        self.has_expired = False

    def describe_otherwise(self, changes):
        """Signals that have another label, unit or slope in the description; `changes` by name."""
        for signal in self.signals:
            for key, value in changes.get(signal.name, {}).items():
                setattr(signal, key, value)

    def stop(self, latch):
        self.latch = latch
        for name in ("hb.arm", "hb.mode", "hb.setpoint"):
            self.set_live(name, 0)

    def set_live(self, name, value):
        parameter = next(p for p in self.live.parameters if p.name == name)
        self.live.put(parameter, Memory.cast(parameter, value))

    def after_live_write(self, was_armed):
        """What the magic parameters do when they are written (protocol 3.11, 3.15)."""
        if self.live.get("hb.stop"):
            self.set_live("hb.stop", 0)
            self.stop(1)
        if self.live.get("hb.arm") and not was_armed:
            self.set_live("hb.setpoint", 0)
            if self.latch:
                self.set_live("hb.arm", 0)
                raise Refused(0x24)
            if self.live.get("hb.watchdog_ms") == 0:
                self.set_live("hb.watchdog_ms", 1000)
        if was_armed and not self.live.get("hb.arm"):
            self.stop(self.latch)

    def copy_half(self, source, destination):
        """What a board does that copies its page while the loop runs: the loop sees one mixed cycle."""
        whole = bytes(self.pages[source].octets)
        half = len(whole) // 2
        self.pages[source].octets[:half] = self.pages[destination].octets[:half]
        self.tick()
        self.pages[source].octets[:] = whole

    def tick(self):
        self.cycles += 1
        self.active_page = self.next_page
        page = self.pages[self.active_page]
        if page.get("set.first") != page.get("set.last"):
            self.values["torn_count"] += 1
        self.watch()
        armed = self.live.get("hb.arm")
        self.values["speed"] += 0.01 * (10 * self.live.get("hb.setpoint") - self.values["speed"]) if armed else 0
        self.values["counter"] = self.values["counter_again"] = self.cycles
        self.values["sine"] = struct.unpack("<f", struct.pack("<f", math.sin(0.002 * math.pi * self.cycles)))[0]
        self.values["wide"] = self.cycles / 3.0
        self.values["level"] = self.cycles % 20000 - 10000
        self.values["status"] = self.latch + 1 if self.latch else int(armed)

    def watch(self):
        limit = self.live.get("hb.watchdog_ms")
        self.idle_ms += 1
        if limit and self.live.get("hb.arm") and self.idle_ms >= limit:
            self.stop(2)
            self.has_expired = True

    def signal_octets(self, signal):
        return struct.pack(self.order + TYPES[signal.type], self.values[signal.name])

    def read(self, address, count):
        for signal in self.signals:
            if signal.address == address and count == type_size(signal.type):
                return self.signal_octets(signal)
        if address >= LIVE_BASE:
            return self.live.read(address, count)
        return self.pages[self.host_page].read(address, count)

    def write(self, address, octets):
        if address >= LIVE_BASE:
            was_armed, watchdog_ms = self.live.get("hb.arm"), self.live.get("hb.watchdog_ms")
            self.live.write(address, octets)
            if was_armed and self.live.get("hb.watchdog_ms") == 0:
                self.set_live("hb.watchdog_ms", watchdog_ms)
                raise Refused(0x22)
            self.after_live_write(was_armed)
            return
        if address < SEGMENT_BASE or self.host_page == self.read_only_page:
            raise Refused(0x23)
        self.pages[self.host_page].write(address, octets)
