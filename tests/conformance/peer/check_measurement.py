"""Dynamic DAQ: several lists and ODTs, prescalers, time stamps, consistency, refusals (protocol.md 3.8, 3.9)."""
import wire
from check_base import SlaveCase, not_where
from master import DaqList


class Measurement(SlaveCase):
    def moving(self, master):
        return master.a2l.signals[self.target.moving]

    def others(self, master, count):
        return [s for s in master.a2l.signals.values() if s.name != self.target.moving][:count]

    def assert_regular(self, master, daq, period_s):
        """Strictly increasing time, exactly one sample per period of the device's clock."""
        times = master.unwrapped_s(daq)
        steps = {round((b - a) / period_s, 6) for a, b in zip(times, times[1:])}
        self.assertEqual(steps, {1.0}, "steps in periods")
        self.assertEqual(daq.incomplete, 0)

    @not_where("is_small")
    def test_lists_odts_and_prescalers_without_gap(self):
        master = self.master()
        moving, others = self.moving(master), self.others(master, 5)
        fast = DaqList(event=0, odts=[[moving] + others[:2], others[2:], [moving]])
        fifth = DaqList(event=0, odts=[[moving]], prescaler=5)
        slow = DaqList(event=1, odts=[others[:1], [moving]])
        self.set_in_motion(master)
        self.serve_for(master, 0.3)
        master.start([fast, fifth, slow])
        self.serve_for(master, 2.0)
        master.stop_measuring()
        period_s = {e.number: e.period_s for e in master.a2l.events}
        self.assert_regular(master, fast, period_s[0])
        self.assert_regular(master, fifth, 5 * period_s[0])
        self.assert_regular(master, slow, period_s[1])
        # 2 s at the wall clock's pace; a quarter may be missing on a busy machine.
        self.assertGreater(len(fast.samples), 1.5 / period_s[0])
        self.assertEqual(master.lost, 0)
        self.assert_consistent(fast, fifth)

    def assert_consistent(self, fast, fifth):
        name = self.target.moving
        values = [v[name] for _, v in fast.samples]
        self.assertGreater(len(set(values)), len(values) // 2, "the signal moves")
        for _, sample in fast.samples:
            self.assertEqual(sample[name], sample[name + "#2"], "first and last ODT are of one cycle")
        at = {ticks: v[name] for ticks, v in fast.samples}
        common = [(at[t], v[name]) for t, v in fifth.samples if t in at]
        self.assertGreater(len(common), len(fifth.samples) // 2)
        for one, other in common:
            self.assertEqual(one, other, "two lists of one event see one cycle")

    def test_stop_ends_the_stream_and_start_works_again(self):
        master = self.master()
        daq = DaqList(event=0, odts=[[self.moving(master)]])
        for _ in range(3):
            master.start([daq])
            master.pump(0.1)
            master.stop_measuring()
            self.assertGreater(len(daq.samples), 20)
            daq.samples.clear()
            master.dtos.clear()
            master.pump(0.1)
            self.assertEqual(master.dtos, [])

    def test_every_signal_can_be_measured(self):
        master = self.master()
        master.read_daq_properties()
        for item in master.a2l.signals.values():
            daq = DaqList(event=(item.events or [0])[0], odts=[[item]])
            master.start([daq])
            master.pump(0.04)
            master.stop_measuring()
            self.assertTrue(daq.samples, item.name)

    def test_commands_are_answered_while_measuring(self):
        master = self.master()
        daq = DaqList(event=0, odts=[[self.moving(master)]])
        master.start([daq])
        for _ in range(100):
            master.status()
            master.read(self.moving(master))
        master.stop_measuring()
        self.assertEqual(master.lost, 0)

    def test_clock_runs_with_the_time_stamps(self):
        master = self.master()
        daq = DaqList(event=0, odts=[[self.moving(master)]])
        master.start([daq])
        master.pump(0.2)
        answer = master.command(wire.GET_DAQ_CLOCK)
        ticks = int.from_bytes(answer[3:7], "little" if master.order == "<" else "big")
        master.stop_measuring()
        behind_s = ((ticks - daq.samples[-1][0] + (1 << 31)) % (1 << 32) - (1 << 31)) * master.tick_s
        self.assertLess(abs(behind_s), 0.2)

    def test_order_of_allocation_is_enforced(self):
        master = self.master()
        master.command(wire.FREE_DAQ)
        self.assertEqual(master.error_of(wire.ALLOC_ODT, "BHB", 0, 0, 1), wire.ERR_SEQUENCE)
        self.assertEqual(master.error_of(wire.ALLOC_ODT_ENTRY, "BHBB", 0, 0, 0, 1), wire.ERR_SEQUENCE)
        master.command(wire.ALLOC_DAQ, "BH", 0, 1)
        self.assertEqual(master.error_of(wire.ALLOC_ODT_ENTRY, "BHBB", 0, 0, 0, 1), wire.ERR_SEQUENCE)

    def test_too_much_memory_is_refused_with_30(self):
        master = self.master()
        master.command(wire.FREE_DAQ)
        self.assertEqual(master.error_of(wire.ALLOC_DAQ, "BH", 0, 60000), wire.ERR_MEMORY)
        master.command(wire.FREE_DAQ)
        master.command(wire.ALLOC_DAQ, "BH", 0, 1)
        self.assertEqual(master.error_of(wire.ALLOC_ODT, "BHB", 0, 0, 251), wire.ERR_MEMORY)

    def test_changes_while_running_are_refused_with_11(self):
        master = self.master()
        item = self.moving(master)
        master.start([DaqList(event=0, odts=[[item]])])
        self.assertEqual(master.error_of(wire.SET_DAQ_PTR, "BHBB", 0, 0, 0, 0), wire.ERR_DAQ_ACTIVE)
        master.command(wire.START_STOP_SYNCH, "B", 0)

    def test_entries_outside_the_odt_and_wild_addresses_are_refused(self):
        master = self.master()
        item = self.moving(master)
        master.allocate([DaqList(event=0, odts=[[item]])])
        self.assertIsNotNone(master.error_of(wire.SET_DAQ_PTR, "BHBB", 0, 0, 0, 1))
        self.assertIsNotNone(master.error_of(wire.SET_DAQ_PTR, "BHBB", 0, 0, 1, 0))
        self.assertIsNotNone(master.error_of(wire.SET_DAQ_PTR, "BHBB", 0, 1, 0, 0))
        master.command(wire.SET_DAQ_PTR, "BHBB", 0, 0, 0, 0)
        self.assertIsNotNone(master.error_of(wire.WRITE_DAQ, "BBBI", 0xFF, 4, 0, 0xDEADBEE0))
        self.assertIsNotNone(master.error_of(wire.WRITE_DAQ, "BBBI", 0xFF, 200, item.extension, item.address))
        master.command(wire.SET_DAQ_PTR, "BHBB", 0, 0, 0, 0)
        master.command(wire.WRITE_DAQ, "BBBI", 0xFF, item.size, item.extension, item.address)
        self.assertIsNotNone(master.error_of(wire.WRITE_DAQ, "BBBI", 0xFF, item.size, item.extension, item.address),
                             "the pointer does not leave the ODT")

    def test_odt_longer_than_the_longest_packet_is_refused(self):
        master = self.master()
        master.read_daq_properties()
        item = max(master.a2l.signals.values(), key=lambda s: s.size)
        count = master.max_dto // item.size + 1
        daq = DaqList(event=0, odts=[[item] * count])
        with self.assertRaises(Exception) as caught:
            master.configure([daq])
            master.command(wire.START_STOP_SYNCH, "B", 1)
        self.assertIn(caught.exception.code, (wire.ERR_DAQ_CONFIG, wire.ERR_RANGE, wire.ERR_MEMORY,
                                              wire.ERR_SEQUENCE))

    def test_wrong_event_and_prescaler_zero_are_refused(self):
        master = self.master()
        master.configure([DaqList(event=0, odts=[[self.moving(master)]])])
        self.assertIsNotNone(master.error_of(wire.SET_DAQ_LIST_MODE, "BHHBB", 0x10, 0, 77, 1, 0))
        self.assertIsNotNone(master.error_of(wire.SET_DAQ_LIST_MODE, "BHHBB", 0x10, 55, 0, 1, 0))
        self.assertIsNotNone(master.error_of(wire.SET_DAQ_LIST_MODE, "BHHBB", 0x10, 0, 0, 0, 0))
        self.assertIsNotNone(master.error_of(wire.START_STOP_SYNCH, "B", 9))
