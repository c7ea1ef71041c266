"""A tiny reader of the A2L subset of protocol.md 3.13: enough for a tool that only wants to measure and tune."""
import re
import struct
from dataclasses import dataclass, field

from wire import TYPES, type_size

TOKEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:[^"\\]|\\.|"")*"|/begin\b|/end\b|[^\s"/]+|/', re.S)


class Text(str):
    """A quoted string, to tell it from a word."""


class Block(list):
    def __init__(self, name):
        super().__init__()
        self.name = name

    def blocks(self, name):
        return [item for item in self if isinstance(item, Block) and item.name == name]

    def words(self):
        return [item for item in self if not isinstance(item, Block)]

    def after(self, keyword, count=1):
        """The words that follow a keyword, or None."""
        words = self.words()
        for index, word in enumerate(words):
            if word == keyword and not isinstance(word, Text):
                return words[index + 1] if count == 1 else words[index + 1:index + 1 + count]
        return None


def parse_tree(text):
    root = Block("")
    stack = [root]
    tokens = [t for t in TOKEN.findall(text) if not t.startswith(("/*", "//"))]
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if token == "/begin":
            index += 1
            block = Block(tokens[index])
            stack[-1].append(block)
            stack.append(block)
        elif token == "/end":
            index += 1
            if stack[-1].name != tokens[index]:
                raise ValueError(f"/end {tokens[index]} inside {stack[-1].name}")
            stack.pop()
        elif token.startswith('"'):
            stack[-1].append(Text(token[1:-1].replace('""', '"').replace('\\"', '"')))
        else:
            stack[-1].append(token)
        index += 1
    if len(stack) != 1:
        raise ValueError(f"{stack[-1].name} is not closed")
    return root


def number(word):
    return int(word, 0) if re.fullmatch(r"[+-]?(0[xX][0-9a-fA-F]+|\d+)", word) else float(word)


@dataclass
class Conversion:
    """phys = slope * raw + offset; or words for numbers."""
    unit: str = ""
    slope: float = 1.0
    offset: float = 0.0
    words: dict = field(default_factory=dict)


@dataclass
class Item:
    name: str
    text: str
    type: str
    address: int
    extension: int
    lower: float
    upper: float
    conversion: Conversion
    count: int = 1
    events: list = field(default_factory=list)
    is_read_only: bool = False

    def __post_init__(self):
        """A limit above its type is clamped to the type (protocol 3.13): floats print 4294967295 as ...300."""
        if not self.type.startswith("FLOAT"):
            bits = 8 * type_size(self.type)
            is_signed = self.type[0] == "S" or self.type == "A_INT64"
            lowest, highest = (-(1 << bits - 1), (1 << bits - 1) - 1) if is_signed else (0, (1 << bits) - 1)
            ends = sorted((self.physical(lowest), self.physical(highest)))
            self.lower, self.upper = max(self.lower, ends[0]), min(self.upper, ends[1])

    @property
    def size(self):
        return type_size(self.type) * self.count

    def decode(self, octets, order):
        """Raw octets -> raw values (a list when it is an array)."""
        values = struct.unpack(f"{order}{self.count}{TYPES[self.type]}", octets)
        return values[0] if self.count == 1 else list(values)

    def encode(self, raw, order):
        return struct.pack(order + TYPES[self.type], raw)

    def physical(self, raw):
        return self.conversion.slope * raw + self.conversion.offset

    def raw(self, physical):
        value = (physical - self.conversion.offset) / self.conversion.slope
        return value if self.type.startswith("FLOAT") else round(value)


@dataclass
class Segment:
    address: int
    size: int
    pages: int


@dataclass
class Event:
    name: str
    number: int
    period_s: float


class Description:
    def __init__(self, text):
        project = parse_tree(text).blocks("PROJECT")[0]
        module = project.blocks("MODULE")[0]
        self.epk = module.blocks("MOD_PAR")[0].after("EPK") if module.blocks("MOD_PAR") else None
        self.byte_order = next((b.after("BYTE_ORDER") for b in module.blocks("MOD_COMMON")), None)
        self.conversions = read_conversions(module)
        layouts = {b[0]: b.after("FNC_VALUES", 2)[1] for b in module.blocks("RECORD_LAYOUT")}
        self.signals = {i.name: i for i in (self.measurement(b) for b in module.blocks("MEASUREMENT"))}
        self.parameters = {i.name: i for i in (self.characteristic(b, layouts)
                                               for b in module.blocks("CHARACTERISTIC"))}
        self.segments = [s for p in module.blocks("MOD_PAR") for s in map(read_segment, p.blocks("MEMORY_SEGMENT"))]
        self.interface = next(b for b in module.blocks("IF_DATA") if b[0] == "XCP")
        self.events = read_events(self.interface)

    def conversion(self, name, unit):
        found = self.conversions.get(name, Conversion())
        return Conversion(unit if unit is not None else found.unit, found.slope, found.offset, found.words)

    def measurement(self, block):
        words = block.words()
        extension = block.after("ECU_ADDRESS_EXTENSION") or "0"
        dimension = count_of(block, "ARRAY_SIZE", "MATRIX_DIM")
        events = []
        for interface in block.blocks("IF_DATA"):
            for daq in interface.blocks("DAQ_EVENT"):
                for part in [daq] + daq.blocks("DEFAULT_EVENT_LIST") + daq.blocks("AVAILABLE_EVENT_LIST"):
                    inner = part.words()
                    events += [number(inner[i + 1]) for i, w in enumerate(inner) if w == "EVENT"]
        return Item(words[0], words[1], words[2], number(block.after("ECU_ADDRESS")), number(extension),
                    number(words[6]), number(words[7]), self.conversion(words[3], block.after("PHYS_UNIT")),
                    dimension, sorted(set(events)))

    def characteristic(self, block, layouts):
        words = block.words()
        extension = block.after("ECU_ADDRESS_EXTENSION") or "0"
        count = count_of(block, "NUMBER", "MATRIX_DIM")
        return Item(words[0], words[1], layouts[words[4]], number(words[3]), number(extension),
                    number(words[7]), number(words[8]), self.conversion(words[6], block.after("PHYS_UNIT")),
                    count, is_read_only="READ_ONLY" in words)


def count_of(block, *keywords):
    """Elements of an array: the product of the dimensions that follow the keyword; 1 without one."""
    words = block.words()
    for keyword in keywords:
        if keyword in words:
            count = 1
            for word in words[words.index(keyword) + 1:]:
                if not re.fullmatch(r"\d+", word):
                    break
                count *= int(word)
            return count
    return 1


def read_conversions(module):
    tables = {}
    for block in module.blocks("COMPU_VTAB"):
        words = block.words()
        pairs = words[4:4 + 2 * number(words[3])]
        tables[words[0]] = {number(pairs[i]): pairs[i + 1] for i in range(0, len(pairs), 2)}
    conversions = {}
    for block in module.blocks("COMPU_METHOD"):
        words = block.words()
        conversion = Conversion(unit=words[4])
        if words[2] == "LINEAR":
            conversion.slope, conversion.offset = map(number, block.after("COEFFS_LINEAR", 2))
        elif words[2] == "RAT_FUNC":
            a, b, c, d, e, f = map(number, block.after("COEFFS", 6))
            if a or d or e:
                raise ValueError(f"{words[0]}: only linear RAT_FUNC is in the subset")
            conversion.slope, conversion.offset = f / b, -c / b
        elif words[2] == "TAB_VERB":
            conversion.words = tables[block.after("COMPU_TAB_REF")]
        conversions[words[0]] = conversion
    return conversions


def read_segment(block):
    words = block.words()
    pages = 0
    for interface in block.blocks("IF_DATA"):
        for segment in interface.blocks("SEGMENT"):
            pages = number(segment.words()[1])
    return Segment(number(words[5]), number(words[6]), pages)


def read_events(interface):
    events = []
    for daq in interface.blocks("DAQ"):
        for block in daq.blocks("EVENT"):
            name, _, index, _, _, cycle, unit, _ = block.words()[:8]
            events.append(Event(name, number(index), number(cycle) * 10.0 ** (number(unit) - 9)))
    return events
