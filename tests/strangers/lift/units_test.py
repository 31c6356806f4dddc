#!/usr/bin/python3
"""The door and the scale of a simulated lift are those of a stranger: python-can on UDP multicast.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/lift/units_test.py
"""

import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path += [str(TESTS), str(TESTS / "cli")]
import own_network
from command import CANVOY, CommandTest, run

try:
    import can
    import msgpack  # without it python-can has no such bus
except ImportError as error:
    own_network.skip(f"{error}; scripts/install-packages test installs python3-can and python3-msgpack")

GROUP, PORT = "239.74.163.23", 43123
DOOR, LOAD = 6, 13
# 6301h: the state in bits 12 to 15; lock and safety contact, in bits 4 and 0, are closed or open, the rest is not there.
CLOSED, CLOSING, OPENED, OPENING = 0x03DD, 0x23CC, 0x33CC, 0x53CC
CLOSES, OPENS = (0x0, 0x1), (0x3, 0x4)  # commands in bits 12 to 15 of 6300h
TRAVEL = 1.5  # seconds
PATIENCE = 300  # seconds
OVERLOAD = 14  # norm, full and overload (6482h:01h)


class Units:
    """A door that takes its time, and a scale."""

    def __init__(self, bus):
        self.bus = bus
        self.state, self.target, self.there_at = CLOSED, CLOSED, 0
        self.signals = 0
        self.next_heartbeat = 0
        for node in (DOOR, LOAD):
            self.send(0x700 + node, b"\x00")

    def send(self, can_id, data):
        self.bus.send(can.Message(arbitration_id=can_id, data=data, is_extended_id=False))

    def tell_door(self):
        position = {CLOSED: 0, OPENED: 800}.get(self.state, 400)
        self.send(0x201, struct.pack("<HH", self.state, position))

    def tell_load(self, signals):
        self.signals = signals
        self.send(0x188, bytes([signals]))

    def obey(self, command):
        way, end = (CLOSING, CLOSED) if command in CLOSES else (OPENING, OPENED)
        if command not in CLOSES + OPENS or self.target == end:
            return
        self.state, self.target, self.there_at = way, end, time.monotonic() + TRAVEL
        self.tell_door()

    def run_until(self, end, over=lambda: False):
        while time.monotonic() < end and not over():
            message = self.bus.recv(0.02)
            if message is not None and message.is_remote_frame:
                if message.arbitration_id == 0x201:
                    self.tell_door()
                if message.arbitration_id == 0x188:
                    self.tell_load(self.signals)
            elif message is not None and message.arbitration_id == 0x200:
                self.obey(message.data[1] >> 4)
            now = time.monotonic()
            if self.state != self.target and now >= self.there_at:
                self.state = self.target
                self.tell_door()
            if now >= self.next_heartbeat:
                self.next_heartbeat = now + 0.3
                for node in (DOOR, LOAD):
                    self.send(0x700 + node, b"\x05")


class StrangersUnits(CommandTest):
    def network(self, folder):
        text = self.assert_done(run("run", "lift", "--lifts", "1", "--floors", "3", "--print"))
        for before, after in [
            ('# real = "can0"', f'real = "udp:{GROUP}:{PORT}"'),
            ('device = "lift-door"', 'device = "lift-door"\nplayed = false'),
            ('device = "lift-load"', 'device = "lift-load"\nplayed = false'),
            ("# list =", "list ="),
        ]:
            self.assertIn(before, text)
            text = text.replace(before, after, 1)
        (folder / "people.csv").write_text("seconds,from,to,kg\n3,2,1,75\n")
        (folder / "house.toml").write_text(text)
        return str(folder / "house.toml")

    @staticmethod
    def opened(told):
        """The floors at which the doors have opened."""
        return [event["floor"] for event in list(told) if event.get("event") == "doors"]

    def test_a_passenger_waits_for_the_scale_and_boards_through_the_door(self):
        with tempfile.TemporaryDirectory() as folder:
            network = self.network(pathlib.Path(folder))
            bus = can.Bus(interface="udp_multicast", channel=GROUP, port=PORT, hop_limit=0, fd=True)
            self.addCleanup(bus.shutdown)
            units = Units(bus)
            units.signals = OVERLOAD
            rest = subprocess.Popen([CANVOY, "run", network, "--json"], stdout=subprocess.PIPE, text=True)
            self.addCleanup(rest.communicate)
            self.addCleanup(rest.kill)
            told = []
            listener = threading.Thread(target=lambda: told.extend(map(json.loads, rest.stdout)))
            listener.start()
            begin = time.monotonic()
            units.run_until(begin + 12)
            units.tell_load(0)
            # The passenger leaves, and the doors close behind him.
            units.run_until(begin + PATIENCE, lambda: self.opened(told)[-2:] == [2, 1] and units.state == CLOSED)
            rest.terminate()
            listener.join()
        starts = [event["time"] for event in told if event.get("event") == "start"]
        self.assertTrue(starts, told)
        self.assertGreater(starts[0], 8, "not while the scale says overload")
        self.assertEqual(self.opened(told)[-2:], [2, 1])
        self.assertEqual([now["served"] for now in told if "served" in now][-1], 1)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
