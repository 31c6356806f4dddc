#!/usr/bin/python3
"""A charger and a battery on UDP multicast, python-can as their listener, and the command as their SDO client.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/udp_multicast_test.py
"""

import json
import os
import pathlib
import struct
import subprocess
import sys
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path += [str(TESTS), str(TESTS / "cli")]
import own_network
from command import CANVOY, FAILED, USAGE, CommandTest, run

try:
    import can
    import msgpack  # without it python-can has no such bus
except ImportError as error:
    own_network.skip(f"{error}; scripts/install-packages test installs python3-can and python3-msgpack")

GROUP, PORT = "239.74.163.2", 43113
BUS = f"udp:{GROUP}:{PORT}"
PATIENCE = 120  # seconds


class UdpMulticast(CommandTest):
    """Two devices in one process, on a bus that python-can has as well."""

    @classmethod
    def setUpClass(cls):
        cls.bus = can.Bus(interface="udp_multicast", channel=GROUP, port=PORT, hop_limit=0, fd=True)
        cls.devices = subprocess.Popen(
            [CANVOY, "device", "charger", "battery", BUS, "--state-of-charge", "35"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        cls.boot_ups = [cls.listen(0x705).data, cls.listen(0x70A).data]

    @classmethod
    def tearDownClass(cls):
        cls.bus.shutdown()
        cls.devices.terminate()
        _, errors = cls.devices.communicate(timeout=PATIENCE)
        assert (errors, cls.devices.returncode) == ("", 0), errors

    @classmethod
    def forget(cls):
        """Drops the frames that wait in the socket: they are of the past."""
        while cls.bus.recv(0) is not None:
            pass

    @classmethod
    def listen(cls, can_id, wanted=lambda data: True):
        """The next frame with this identifier of which `wanted` holds."""
        give_up = time.monotonic() + PATIENCE
        while time.monotonic() < give_up:
            message = cls.bus.recv(1)
            if message is not None and message.arbitration_id == can_id and wanted(message.data):
                assert not message.is_extended_id and not message.is_remote_frame
                return message
        raise AssertionError(f"no such frame {can_id:03X} within {PATIENCE} s")

    @classmethod
    def hear(cls, can_id, wanted=lambda data: True):
        """The same, sent from now on."""
        cls.forget()
        return cls.listen(can_id, wanted)

    def hear_operational(self, node):
        self.hear(0x700 + node, lambda data: data == b"\x05")

    def test_python_can_hears_the_boot_ups(self):
        self.assertEqual(self.boot_ups, [b"\x00", b"\x00"])

    def test_python_can_reads_the_tpdos(self):
        self.hear_operational(10)
        temperature, status = struct.unpack("<hB", self.hear(0x18A).data)
        self.assertTrue(10 < temperature / 8 < 40, temperature)
        self.assertEqual(status & 1, 1)
        self.assertEqual(struct.unpack("<hB", self.hear(0x28A).data[:3])[0] / 8, temperature / 8)
        (voltage,) = struct.unpack("<I", self.hear(0x28A).data[3:])
        self.assertTrue(40 < voltage / 1024 < 65, voltage)
        current, charge = struct.unpack("<HB", self.hear(0x38A, lambda data: data[0] | data[1]).data)
        self.assertTrue(0 < current / 16 <= 60, current)
        self.assertTrue(35 <= charge < 40, charge)
        self.hear(0x20A, lambda data: data == b"\x01")  # the charger is ready: the charge has begun

    def test_read_gives_a_value_with_its_unit(self):
        self.assertRegex(self.assert_done(run("read", BUS, "10", "temperature")), r"\A\d\d\.\d+ °C\n\Z")
        self.assertRegex(self.assert_done(run("read", BUS, "0x0A", "6060")), r"\A\d\d\.\d+ V\n\Z")
        self.assertRegex(self.assert_done(run("read", BUS, "5", "battery_temperature")), r"\A\d\d\.\d+ °C\n\Z")
        self.assertEqual(self.assert_done(run("read", BUS, "10", "1008")), '"Canvoy CiA 418 battery"\n')

    def test_read_gives_json(self):
        value = json.loads(self.assert_done(run("read", BUS, "10", "temperature", "--json")))
        self.assertEqual((value["node"], value["index"], value["sub"], value["unit"]), (10, "6010", "00", "°C"))
        self.assertTrue(10 < value["value"] < 40)

    def test_write_changes_a_value(self):
        self.assertEqual(self.assert_done(run("write", BUS, "5", "1017", "400 ms")), "Producer heartbeat time: 1000 ms -> 400 ms\n")
        self.assertEqual(self.assert_done(run("read", BUS, "5", "1017")), "400 ms\n")
        beats = [self.hear(0x705).timestamp for _ in range(5)]
        # Where the machine stands still for a moment, one distance is long, and the next short.
        distances = [after - before for before, after in zip(beats, beats[1:], strict=False)]
        self.assertLess(min(distances), 0.9, "not the 1000 ms of before")

    def test_nmt_commands_nodes(self):
        self.hear_operational(5)
        self.forget()
        self.assertEqual(self.assert_done(run("nmt", BUS, "5", "reset-communication")), "node 5 (05h) has booted\n")
        self.listen(0x705, lambda data: data == b"\x00")
        self.hear_operational(5)  # it finds its battery again, and starts the network

    def test_what_a_node_refuses_is_told_in_one_line(self):
        self.assert_refused(run("read", BUS, "10", "2345"), FAILED, "node 10 (0Ah)", "2345h:00h", "06020000h")
        self.assert_refused(run("read", BUS, "10", "1018:9"), FAILED, "1018h:09h", "06090011h")
        self.assert_refused(run("write", BUS, "10", "temperature", "20 °C"), FAILED, "6010h:00h", "06010002h")
        self.assert_refused(run("write", BUS, "10", "6080", "hex:01 02"), FAILED, "6080h:00h", "06070012h")

    def test_values_that_make_no_sense_are_refused_and_change_nothing(self):
        before = self.assert_done(run("read", BUS, "10", "1017"))
        wrong = [
            (["1017", "65536"], "0 to 65535 ms"),
            (["6080", "101"], "0 to 100 %"),
            (["6080", "full"], "'full'"),
            (["charger_state_of_charge", "50 V"], "'50 V'"),
            (["charger_status", "perhaps"], "'perhaps'", "not ready, ready"),
        ]
        for arguments, *parts in wrong:
            with self.subTest(value=arguments):
                self.assert_refused(run("write", BUS, "10", *arguments), USAGE, *parts)
        self.assertEqual(self.assert_done(run("read", BUS, "10", "1017")), before)

    def test_a_node_that_is_not_there_is_told_of(self):
        result = run("read", BUS, "11", "temperature", "--timeout", "300ms")
        self.assert_refused(result, FAILED, "node 11 (0Bh)", "no answer within", BUS)

    def test_monitor_shows_what_python_can_hears(self):
        self.hear(0x18A)  # before that there is SDO only
        result = run("monitor", BUS, "--count", "60", "--json")  # whether a node has told its profile until then is open
        self.assertEqual(result.returncode, 0, result.stderr)
        frames = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual(len(frames), 60)
        self.assertIn("TPDO1", {frame["service"] for frame in frames})


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
