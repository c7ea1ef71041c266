"""A network between a master and a board on UDP: it delivers some datagrams twice, some late, and loses some."""
import random
import select
import socket
import threading

import wire

class Relay:
    def __init__(self, board, seed, twice=0.05, late=0.0, lost=0.0):
        self.numbers = random.Random(seed)
        self.twice, self.late, self.lost = twice, late, lost
        self.counts = {"twice": 0, "late": 0, "lost": 0}
        self.front = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.front.bind(("127.0.0.1", 0))
        self.back = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        host, port = board.split(":", 1)[1].rsplit(":", 1)
        self.back.connect((host, int(port)))
        self.address = f"udp:127.0.0.1:{self.front.getsockname()[1]}"
        self.master = None
        self.waiting = {}               # socket: the datagram that the next one overtakes
        self.is_over = False
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def stop(self):
        self.is_over = True
        self.thread.join()
        self.front.close()
        self.back.close()

    def run(self):
        while not self.is_over:
            ready, _, _ = select.select([self.front, self.back], [], [], 0.05)
            for source in ready:
                try:
                    octets, sender = source.recvfrom(65536)
                except ConnectionError:
                    continue
                if source is self.front:
                    self.master = sender
                self.carry(source, octets)

    def carry(self, source, octets):
        draw = self.numbers.random()
        copies = [octets]
        if draw < self.twice:
            copies, kind = [octets, octets], "twice"
        elif draw < self.twice + self.late:
            copies, kind = [], "late"
        elif draw < self.twice + self.late + self.lost:
            copies, kind = [], "lost"
        else:
            kind = None
        before = self.waiting.pop(source, None)
        for datagram in copies + ([before] if before else []):
            if source is self.front:
                self.back.send(datagram)
            else:
                self.front.sendto(datagram, self.master)
        if kind == "late":
            self.waiting[source] = octets
        if kind:
            self.counts[kind] += 1


class Tap(Relay):
    """A network that carries every datagram once and remembers what the master sent."""
    WRITES = {wire.DOWNLOAD, wire.SHORT_DOWNLOAD, wire.COPY_CAL_PAGE, wire.SET_REQUEST, 0xEF, 0xEE, 0xEC}

    def __init__(self, board):
        self.sent = []
        super().__init__(board, 1, twice=0.0)

    def carry(self, source, octets):
        if source is self.front:
            self.sent += [packet for _, packet in wire.Splitter().feed(octets)]
        super().carry(source, octets)

    def writes(self):
        """Memory that was written, pages copied, settings stored, pages switched for the control loop."""
        return [packet.hex() for packet in self.sent if packet[0] in self.WRITES
                or packet[0] == wire.SET_CAL_PAGE and packet[1] & 1]
