"""Reads an uncompressed MAT file of version 5 from the format's description alone: {name: value}, where a value is a
list of floats (a column), a text or, for a struct, {field: value}. Asserts that nothing is left over.
"""
import struct

MI_INT8, MI_UINT16, MI_INT32, MI_UINT32, MI_DOUBLE, MI_MATRIX = 1, 4, 5, 6, 9, 14
MX_STRUCT, MX_CHAR, MX_DOUBLE = 2, 4, 6


class Elements:
    """The data elements of a stretch of octets, one after the other, each filled up to a multiple of 8."""

    def __init__(self, octets):
        self.octets, self.place = octets, 0

    def next(self):
        kind, length = struct.unpack_from("<II", self.octets, self.place)
        begin, end = self.place + 8, self.place + 8 + length
        self.place = end if kind == MI_MATRIX else (end + 7) // 8 * 8
        if kind >> 16:                                      # four octets or fewer stand in the tag itself
            kind, length = kind & 0xFFFF, kind >> 16
            assert length <= 4
            begin, end = begin - 4, begin - 4 + length
            self.place = begin + 4
        assert end <= len(self.octets), "an element ends behind its container"
        return kind, self.octets[begin:end]

    def all(self):
        while self.place < len(self.octets):
            yield self.next()


def text_of(octets):
    return octets.decode("utf-16-le")


def fields_of(elements):
    kind, length = elements.next()
    assert kind == MI_INT32
    length = struct.unpack("<i", length)[0]
    kind, names = elements.next()
    assert kind == MI_INT8 and len(names) % length == 0
    names = [names[i:i + length].split(b"\0")[0].decode("ascii") for i in range(0, len(names), length)]
    return {name: matrix(elements.next())[1] for name in names}


def matrix(element):
    kind, octets = element
    assert kind == MI_MATRIX
    elements = Elements(octets)
    kind, flags = elements.next()
    assert kind == MI_UINT32 and len(flags) == 8
    flags = struct.unpack("<II", flags)[0]
    assert flags >> 8 == 0, "not complex, global or logical"
    kind, dimensions = elements.next()
    assert kind == MI_INT32
    rows, columns = struct.unpack("<2i", dimensions)
    kind, name = elements.next()
    assert kind == MI_INT8
    if flags == MX_STRUCT:
        assert (rows, columns) == (1, 1)
        value = fields_of(elements)
    else:
        kind, data = elements.next()
        if flags == MX_CHAR:
            assert kind == MI_UINT16 and rows == min(columns, 1) and len(data) == 2 * columns
            value = text_of(data)
        else:
            assert (flags, kind, columns) == (MX_DOUBLE, MI_DOUBLE, 1) and len(data) == 8 * rows
            value = list(struct.unpack(f"<{rows}d", data))
    assert elements.place >= len(octets), "nothing behind the last element"
    return name.decode("ascii"), value


def read(path):
    with open(path, "rb") as file:
        octets = file.read()
    assert octets.startswith(b"MATLAB 5.0 MAT-file") and octets[124:128] == b"\x00\x01IM", "version 5, little endian"
    variables = [matrix(element) for element in Elements(octets[128:]).all()]
    assert len(dict(variables)) == len(variables), "every name once"
    return dict(variables)
