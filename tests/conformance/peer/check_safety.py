"""Stop, arm, watchdog, latches (protocol.md 3.11, 3.15)."""
import time

import wire
from check_base import SlaveCase, not_where
from master import DaqList
from wire import RES

STOP = bytes([wire.USER_CMD, wire.USER_STOP])


class Safety(SlaveCase):
    def assert_stopped(self, master, latch):
        self.wait_for_value(master, "status", latch)
        self.assertEqual(master.read_name("hb.arm"), 0)
        self.assertEqual(master.read_name("hb.setpoint"), 0)
        self.assertIsNotNone(self.arm_error(master), "arming is refused while a stop is latched")
        self.assertEqual(master.read_name("hb.arm"), 0)

    def arm_error(self, master):
        item = master.a2l.parameters["hb.arm"]
        return master.error_of(wire.SHORT_DOWNLOAD, "BBBI", item.size, 0, item.extension, item.address,
                               tail=item.encode(1, master.order))

    def clear(self, master):
        master.command(wire.USER_CMD, "B", wire.USER_CLEAR)
        self.wait_for_value(master, "status", 0)

    def test_arming_starts_with_set_point_zero_and_a_watchdog(self):
        master = self.master()
        self.assertEqual(master.read_name("hb.watchdog_ms"), 0, "off by default, foreign tools work")
        item = master.a2l.parameters["hb.setpoint"]
        master.error_of(wire.SHORT_DOWNLOAD, "BBBI", item.size, 0, item.extension, item.address,
                        tail=item.encode(1.0, master.order))
        master.write_name("hb.mode", 1)
        master.write_name("hb.arm", 1)
        self.assertEqual(master.read_name("hb.setpoint"), 0)
        self.assertEqual(master.read_name("hb.watchdog_ms"), 1000)
        self.wait_for_value(master, "status", 1)

    def test_disarming_takes_the_set_point_away(self):
        master = self.master()
        self.set_in_motion(master)
        master.write_name("hb.arm", 0)
        self.wait_for_value(master, "status", 0)
        self.assertEqual(master.read_name("hb.setpoint"), 0)

    def test_stop_command_latches_until_cleared(self):
        master = self.master()
        self.set_in_motion(master)
        answer = master.command(wire.USER_CMD, "B", wire.USER_STOP)
        self.assertGreaterEqual(len(answer), 1)
        self.assert_stopped(master, self.target.stopped_by_command)
        self.clear(master)
        self.set_in_motion(master)
        self.wait_for_value(master, "status", 1)

    def test_stop_parameter_does_the_same(self):
        master = self.master()
        self.set_in_motion(master)
        master.write_name("hb.stop", 1)
        self.assert_stopped(master, self.target.stopped_by_command)

    def test_stop_three_times_in_a_row_is_answered_in_order(self):
        master = self.master()
        self.set_in_motion(master)
        master.answers.clear()
        master.send(STOP)
        master.send(STOP, STOP)
        for _ in range(3):
            self.assertEqual(master.answer()[0], RES)
        self.assert_stopped(master, self.target.stopped_by_command)

    def test_stop_is_obeyed_while_a_command_is_pending(self):
        master = self.master()
        self.set_in_motion(master)
        segment = master.a2l.segments[0]
        master.set_mta(segment.address)
        checksum = bytes([wire.BUILD_CHECKSUM, 0, 0, 0]) + segment.size.to_bytes(
            4, "little" if master.order == "<" else "big")
        master.answers.clear()
        master.send(checksum, STOP)
        self.assertEqual(len(master.answer()), 8, "the outstanding command's answer comes first")
        self.assertEqual(master.answer()[0], RES)
        self.assert_stopped(master, self.target.stopped_by_command)

    def test_stop_is_obeyed_silently_when_not_connected(self):
        master = self.master()
        self.set_in_motion(master)
        master.command(wire.DISCONNECT)
        master.send(STOP)
        self.assert_silent(master, 0.2)
        master.connect()
        self.assert_stopped(master, self.target.stopped_by_command)

    @not_where("is_reset_by_opening")
    def test_stop_by_a_stranger_who_never_connects(self):
        master = self.master()
        self.set_in_motion(master, watchdog_ms=2000)
        master.close()
        stranger = self.raw_master()
        stranger.send(STOP)
        stranger.pump(0.2)
        stranger.close()
        self.assert_stopped(self.master(), self.target.stopped_by_command)

    def test_damaged_stop_is_not_obeyed(self):
        master = self.master()
        self.set_in_motion(master)
        master.send(bytes([wire.USER_CMD]))
        self.assertEqual(master.answer()[1], wire.ERR_SYNTAX)
        self.assertEqual(master.read_name("hb.arm"), 1)

    def test_silence_of_the_master_stops_the_motor(self):
        master = self.master()
        daq = DaqList(event=0, odts=[[master.a2l.signals["status"]]])
        master.start([daq])
        self.set_in_motion(master, watchdog_ms=300)
        began = time.monotonic()
        while not master.events and time.monotonic() < began + 2:
            master.pump(0.01)
        waited_s = time.monotonic() - began
        self.assertTrue(master.events, "EV 07 was not sent")
        self.assertEqual(master.events[0][1], wire.EV_TERMINATED)
        self.assertGreater(waited_s, 0.25)
        self.assertLess(waited_s, 0.6)      # 300 ms and what a busy machine adds
        master.pump(0.05)
        master.dtos.clear()
        master.pump(0.2)
        self.assertEqual(master.dtos, [], "measurement has ended")
        master.send(bytes([wire.GET_STATUS]))
        self.assert_silent(master, 0.2)
        master.connect()
        self.assert_stopped(master, self.target.stopped_by_watchdog)
        self.clear(master)

    def test_any_command_feeds_the_watchdog(self):
        master = self.master()
        self.set_in_motion(master, watchdog_ms=400)
        self.serve_for(master, 1.2)
        self.assertEqual(master.read_name("hb.arm"), 1)

    @not_where("is_reset_by_opening")
    def test_watchdog_cannot_be_taken_away_while_armed(self):
        master = self.master()
        self.set_in_motion(master, watchdog_ms=300)
        item = master.a2l.parameters["hb.watchdog_ms"]
        self.assertLessEqual(item.upper, 2000)
        self.assertEqual(master.error_of(wire.SHORT_DOWNLOAD, "BBBI", item.size, 0, item.extension, item.address,
                                         tail=item.encode(0, master.order)), wire.ERR_RANGE)
        master.close()
        time.sleep(0.6)
        self.assert_stopped(self.master(), self.target.stopped_by_watchdog)

    @not_where("is_reset_by_opening")
    def test_master_that_vanishes_leaves_a_stopped_motor(self):
        master = self.master()
        self.set_in_motion(master, watchdog_ms=300)
        master.close()
        time.sleep(0.6)
        self.assert_stopped(self.master(), self.target.stopped_by_watchdog)

    def test_session_ended_in_order_leaves_nothing_latched(self):
        master = self.master()
        self.set_in_motion(master, watchdog_ms=800)     # that a busy machine does not let run out before
        master.write_name("hb.arm", 0)
        master.command(wire.DISCONNECT)
        master.pump(1.2)
        master.connect()
        self.wait_for_value(master, "status", 0)
