"""The lines a master reaches a board on: TCP, UDP, and serial with framing (protocol.md sections 3.2, 3.3).

Written from protocol.md only; shares no code with the product.
"""
import os
import select
import socket
import struct
import termios
import tty

import wire

SYNC, ESCAPE = 0x9A, 0x9B
MOST_IN_A_DATAGRAM = 512


def word_sum(octets):
    return sum(struct.unpack(f"<{len(octets) // 2}H", octets)) & 0xFFFF


def sxi_frame(packet, counter):
    """SYNC, then LEN u8, CTR u8, packet, fill to an even length and the sum of words, escaped."""
    body = bytes([len(packet), counter & 0xFF]) + packet
    body += b"\0" * (len(body) % 2)
    body += struct.pack("<H", word_sum(body))
    escaped = b"".join({SYNC: b"\x9b\x01", ESCAPE: b"\x9b\x00"}.get(o, bytes([o])) for o in body)
    return bytes([SYNC]) + escaped


def plain_frame(packet, counter):
    """LEN u8, CTR u8, packet, fill to an even length and the sum of words: the same without SYNC and escapes."""
    body = bytes([len(packet), counter & 0xFF]) + packet
    body += b"\0" * (len(body) % 2)
    return body + struct.pack("<H", word_sum(body))


class PlainSplitter:
    """Cuts a line without framing that nothing is lost on; the first damage is the end of it."""

    def __init__(self):
        self.buffer = bytearray()
        self.damaged = 0

    def feed(self, octets):
        self.buffer += octets
        found = []
        while self.buffer:
            summed = (2 + self.buffer[0] + 1) // 2 * 2
            if len(self.buffer) < summed + 2:
                break
            frame = bytes(self.buffer[:summed + 2])
            del self.buffer[:summed + 2]
            if frame[0] == 0 or struct.unpack_from("<H", frame, summed)[0] != word_sum(frame[:summed]):
                self.damaged += 1
                self.buffer.clear()
                break
            found.append((frame[1], frame[2:2 + frame[0]]))
        return found


class SxiSplitter:
    """Cuts a line of octets, fed in any pieces, into (counter, packet); drops and counts what is damaged."""

    def __init__(self):
        self.frame = None           # None: waiting for SYNC
        self.is_escaped = False
        self.damaged = 0

    def drop(self):
        self.damaged += 1
        self.frame = None

    def feed(self, octets):
        found = []
        for octet in octets:
            if octet == SYNC:
                if self.frame:
                    self.damaged += 1
                self.frame, self.is_escaped = bytearray(), False
            elif self.frame is not None:
                found += self.take(octet)
        return found

    def take(self, octet):
        if self.is_escaped:
            self.is_escaped = False
            if octet > 1:
                self.drop()
                return []
            octet = SYNC if octet == 1 else ESCAPE
        elif octet == ESCAPE:
            self.is_escaped = True
            return []
        self.frame.append(octet)
        if self.frame[0] == 0:
            self.drop()
            return []
        summed = (2 + self.frame[0] + 1) // 2 * 2
        if len(self.frame) < summed + 2:
            return []
        frame, self.frame = bytes(self.frame), None
        if struct.unpack_from("<H", frame, summed)[0] != word_sum(frame[:summed]):
            self.damaged += 1
            return []
        return [(frame[1], frame[2:2 + frame[0]])]


class TcpLine:
    turn = 0x10000                  # the message counter's
    calls = 1                       # CONNECTs that a board may need to hear one

    def __init__(self, place, timeout_s):
        host, port = place.rsplit(":", 1)
        self.socket = socket.create_connection((host, int(port)), timeout=timeout_s)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.splitter = wire.Splitter()

    def fileno(self):
        return self.socket.fileno()

    def send(self, packets, counter):
        self.send_octets(b"".join(wire.message(packet, counter + i) for i, packet in enumerate(packets)))

    def send_octets(self, octets):
        self.socket.sendall(octets)

    def receive(self):
        """Messages that arrived, and whether the line is still there."""
        try:
            octets = self.socket.recv(65536)
        except ConnectionError:
            octets = b""
        return self.splitter.feed(octets), bool(octets)

    def close(self):
        self.socket.close()


class UdpLine:
    turn = 0x10000
    calls = 1

    def __init__(self, place, _):
        host, port = place.rsplit(":", 1)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect((host, int(port)))
        self.datagrams = []         # octets of each that arrived

    def fileno(self):
        return self.socket.fileno()

    def send(self, packets, counter):
        for i, packet in enumerate(packets):            # exactly one command per datagram
            self.send_octets(wire.message(packet, counter + i))

    def send_octets(self, octets):
        self.socket.send(octets)

    def receive(self):
        try:
            octets = self.socket.recv(65536)
        except ConnectionError:
            return [], False
        self.datagrams.append(len(octets))
        splitter = wire.Splitter()
        found = splitter.feed(octets)
        if splitter.buffer:
            raise ValueError("a datagram holds whole messages only")
        return found, True

    def close(self):
        self.socket.close()


class SxiLine:
    turn = 0x100
    calls = 10
    frame = staticmethod(sxi_frame)
    make_splitter = SxiSplitter

    def __init__(self, place, _):
        self.file = os.open(place, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.file)
        termios.tcflush(self.file, termios.TCIOFLUSH)
        self.splitter = self.make_splitter()

    def fileno(self):
        return self.file

    def send(self, packets, counter):
        self.send_octets(b"".join(self.frame(packet, counter + i) for i, packet in enumerate(packets)))

    def send_octets(self, octets):
        while octets:
            select.select([], [self.file], [])
            octets = octets[os.write(self.file, octets):]

    def receive(self):
        try:
            octets = os.read(self.file, 65536)
        except OSError:
            octets = b""
        return self.splitter.feed(octets), bool(octets)

    def close(self):
        if self.file >= 0:
            os.close(self.file)
        self.file = -1


class PlainLine(SxiLine):
    frame = staticmethod(plain_frame)
    make_splitter = PlainSplitter


def open_line(address, timeout_s):
    """`tcp:HOST:PORT`, `udp:HOST:PORT`, `pty:PATH` or, without framing, `plain:PATH`."""
    kind, place = address.split(":", 1)
    return {"tcp": TcpLine, "udp": UdpLine, "pty": SxiLine, "plain": PlainLine}[kind](place, timeout_s)
