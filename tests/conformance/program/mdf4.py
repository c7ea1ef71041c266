"""Reads an ASAM MDF 4.1 file from the standard's description of its blocks alone and asserts all that a finalised,
sorted file of one group has to keep: every octet belongs to exactly one block, every block is linked from the header.
"""
import struct
import xml.etree.ElementTree as ET

XML = "{http://www.asam.net/mdf/v4}"
# id: links and data octets by the standard; None = any number of data octets
SHAPES = {"HD": (6, 32), "FH": (2, 16), "DG": (4, 8), "CG": (6, 32), "SI": (3, 8), "CN": (8, 72), "EV": (5, 32),
          "TX": (0, None), "MD": (0, None), "DT": (0, None)}
# Which block may stand at the end of which link; a name that is not here must be no link.
LINKS = {"HD": {0: "DG", 1: "FH", 4: "EV", 5: "MD"}, "FH": {0: "FH", 1: "MD"}, "DG": {0: "DG", 1: "CG", 2: "DT", 3: "MD"},
         "CG": {0: "CG", 1: "CN", 2: "TX", 3: "SI", 5: "MD"}, "SI": {0: "TX", 1: "TX", 2: "MD"},
         "CN": {0: "CN", 2: "TX", 3: "SI", 6: "TX", 7: "MD"}, "EV": {0: "EV", 3: "TX", 4: "MD"}}
ROOTS = {"HD": "HDcomment", "FH": "FHcomment", "CN": "CNcomment", "EV": "EVcomment"}


class Block:
    def __init__(self, kind, offset, length, links, data):
        self.kind, self.offset, self.length, self.links, self.data = kind, offset, length, links, data


class Mdf4:
    """blocks, start_ns, signals [(name, unit, comment)], rows [(time, value...)], events [(time, name, comment)]"""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.octets = file.read()
        self.blocks = {}
        self.identification()
        self.walk("HD", 64, None)
        self.cover()
        header = self.blocks[64]
        self.start_ns, offsets, flags, time_class, hd_flags, _, angle, distance = struct.unpack("<QIBBBBdd", header.data)
        assert (offsets, flags, time_class, hd_flags, angle, distance) == (0, 2, 0, 0, 0, 0), header.data
        self.comment = self.xml(header.links[5])
        self.group(self.blocks[header.links[0]])
        self.events = [self.event(block) for block in self.chain(header.links[4])]
        self.check_history(header.links[1])

    def identification(self):
        file, version, program, reserved, number, rest, flags, custom = struct.unpack("<8s8s8s4sH30sHH", self.octets[:64])
        assert file == b"MDF     ", "finalised"
        assert (version, number) == (b"4.10    ", 410)
        assert program == b"Halbench" and reserved == bytes(4) and rest == bytes(30) and (flags, custom) == (0, 0)

    def walk(self, kind, offset, parent):
        """Every block that can be reached, each read once."""
        todo = [(kind, offset, parent)]
        while todo:
            kind, offset, parent = todo.pop()
            assert offset % 8 == 0, f"{kind} at {offset} of {parent} is not aligned"
            if offset in self.blocks:
                assert self.blocks[offset].kind == kind
                continue
            marker, reserved, length, count = struct.unpack_from("<4sIQQ", self.octets, offset)
            assert marker == b"##" + kind.encode() and reserved == 0, f"{marker} at {offset}, linked as {kind}"
            links, data = SHAPES[kind]
            assert count == links and offset + length <= len(self.octets), f"{kind} at {offset}"
            begin = offset + 24 + 8 * links
            assert data is None or length == 24 + 8 * links + data, f"{kind} at {offset} has {length} octets"
            block = Block(kind, offset, length, struct.unpack_from(f"<{links}Q", self.octets, offset + 24),
                          self.octets[begin:offset + length])
            self.blocks[offset] = block
            for index, link in enumerate(block.links):
                allowed = LINKS[kind].get(index)
                assert link == 0 or allowed, f"{kind} at {offset}: link {index}"
                if link:
                    todo.append((allowed, link, f"{kind} at {offset}"))

    def cover(self):
        """No octet outside of a block, no block that nothing links to, no overlap."""
        end = 64
        for offset in sorted(self.blocks):
            assert offset == end, f"{offset - end} octets before the block at {offset}"
            end = offset + self.blocks[offset].length
        assert end == len(self.octets), f"{len(self.octets) - end} octets behind the last block"

    def chain(self, offset):
        while offset:
            yield self.blocks[offset]
            offset = self.blocks[offset].links[0]

    def text(self, offset):
        if not offset:
            return ""
        text, _, filling = self.blocks[offset].data.partition(b"\0")
        assert len(text) < len(self.blocks[offset].data) and not filling.strip(b"\0"), "ends with zeros"
        assert len(filling) < 8
        return text.decode("utf-8")

    def xml(self, offset, kind="HD"):
        """{name or tree/name: (text, unit)} of the common properties."""
        if not offset:
            return {}
        root = ET.fromstring(self.text(offset))
        assert root.tag == XML + ROOTS[kind] and root[0].tag == XML + "TX", root.tag
        properties = root.find(XML + "common_properties")
        found = {}
        for element in [] if properties is None else properties:
            inside = list(element) if element.tag == XML + "tree" else [element]
            prefix = element.get("name") + "/" if element.tag == XML + "tree" else ""
            for each in inside:
                assert each.tag == XML + "e" and set(each.attrib) <= {"name", "unit"}
                found[prefix + each.get("name")] = (each.text, each.get("unit"))
        return found

    def group(self, data_group):
        assert data_group.links[0] == 0 and data_group.data == bytes(8), "one group, no record id: sorted"
        group = self.blocks[data_group.links[1]]
        record, cycles, flags, separator, reserved, octets, invalid = struct.unpack("<QQHHIII", group.data)
        assert (record, flags, separator, reserved, invalid) == (0, 0, 0, 0, 0) and group.links[0] == 0
        self.source = self.read_source(self.blocks[group.links[3]])
        self.signals = []
        for index, channel in enumerate(self.chain(group.links[1])):
            self.channel(index, channel)
        assert octets == 8 * len(self.signals)
        assert len({name for name, _, _ in self.signals}) == len(self.signals), "names are unique in a group"
        data = self.blocks[data_group.links[2]].data
        assert len(data) == cycles * octets, f"{len(data)} octets of {cycles} cycles"
        self.rows = list(struct.iter_unpack(f"<{len(self.signals)}d", data))

    def channel(self, index, channel):
        kind, sync, data_type, bit, octet, bits, flags, invalid, precision, reserved, attachments = struct.unpack_from(
            "<BBBBIIIIBBH", channel.data)
        assert (kind, sync) == ((2, 1) if index == 0 else (0, 0)), "time is the master"
        assert (data_type, bit, octet, bits) == (4, 0, 8 * index, 64), "float, little endian"
        assert (flags, invalid, precision, reserved, attachments) == (0, 0, 255, 0, 0) and channel.data[24:] == bytes(48)
        assert channel.links[2], "a channel has a name"
        self.signals.append((self.text(channel.links[2]), self.text(channel.links[6]), self.xml(channel.links[7], "CN")))

    def read_source(self, source):
        kind, bus, flags = struct.unpack_from("<BBB", source.data)
        assert (kind, bus) == (1, 0) and flags <= 1
        return self.text(source.links[0]), self.text(source.links[1]), bool(flags)

    def event(self, block):
        kind, sync, extent, cause, flags, *_, scopes, attachments, creator, base, factor = struct.unpack("<BBBBB3BIHHqd", block.data)
        assert (kind, sync, extent, cause, flags, scopes, attachments, creator) == (6, 1, 0, 0, 0, 0, 0, 0)
        return base * factor, self.text(block.links[3]), self.xml(block.links[4], "EV")

    def check_history(self, offset):
        entries = list(self.chain(offset))
        assert len(entries) == 1, "a file has a history"
        assert struct.unpack("<QIB3s", entries[0].data) == (self.start_ns, 0, 2, bytes(3))
        root = ET.fromstring(self.text(entries[0].links[1]))
        assert [child.tag for child in root] == [XML + tag for tag in ("TX", "tool_id", "tool_vendor", "tool_version")]
