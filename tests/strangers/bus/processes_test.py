#!/usr/bin/python3
"""Devices of a bus in other processes, and python-can, on UDP multicast: the next stop is drawn and announced by devices
of ours beside a bus that does not play them, and python-can shows the clock that the on-board computer tells.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/bus/processes_test.py
"""

import pathlib
import subprocess
import sys
import tempfile
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

GROUP, PORT = "239.74.163.27", 43127
BUS = f"udp:{GROUP}:{PORT}"
SECOND_BUS = "udp:239.74.163.28:43128"
PATIENCE = 120  # seconds


def shown_clock(data):
    """`2026-11-23 08:15`, by the rules of SAE J1939: years since 1985, quarters of days."""
    year, quarters, month, hour, minute = data[:5]
    return f"{1985 + year:04}-{month:02}-{(quarters + 3) // 4:02} {hour:02}:{minute:02}"


class Processes(CommandTest):
    def start(self, *arguments):
        program = subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

    def until_said(self, program, text):
        """The lines up to the one with `text`."""
        lines = []
        give_up = time.monotonic() + PATIENCE
        for line in program.stdout:
            lines.append(line)
            if text in line:
                return lines
            self.assertLess(time.monotonic(), give_up, lines)
        self.fail(f"{text} was not said, but {lines}")

    def test_python_can_shows_the_clock(self):
        with can.Bus(interface="udp_multicast", channel=GROUP, port=PORT) as bus:
            # It looks at its clock now and then, the last time perhaps in the minute before.
            before = time.gmtime()
            computer = self.start("device", "on-board-computer", BUS)
            self.until_said(computer, "pre-operational")
            bus.send(can.Message(arbitration_id=0x000, data=[1, 1], is_extended_id=False))
            give_up = time.monotonic() + PATIENCE
            message = None
            while message is None or message.arbitration_id != 0x181:
                message = bus.recv(1)
                self.assertLess(time.monotonic(), give_up)
            first, last = (time.strftime("%Y-%m-%d %H:%M", moment) for moment in (before, time.gmtime()))
            self.assertTrue(first <= (shown := shown_clock(message.data)) <= last, f"{shown} is not from {first} to {last}")

    def test_a_bus_has_its_next_stop_shown_and_announced_by_other_processes(self):
        text = self.assert_done(run("run", "bus", "--print"))
        for before, after in [
            ('# real = "can0"', f'real = "{BUS}"'),
            ("[next-stop]  # node 5\nplayed = true", "[next-stop]\nplayed = false"),
            ("[announcer]  # node 9\nplayed = true", "[announcer]\nplayed = false"),
        ]:
            self.assertIn(before, text)
            text = text.replace(before, after, 1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "bus.toml"
            file.write_text(text)
            picture = pathlib.Path(folder) / "stop.png"
            display = self.start("device", "next-stop-indicator-text", BUS, "--png", str(picture))
            announcer = self.start("device", "acoustic-announcer", BUS, "--announce", "1=Central Station")
            bus = self.start("run", str(file), "--for", "1min")
            drawn = self.until_said(display, "Central Station")
            self.assertIn("  | Central Station                  |\n", drawn)
            self.until_said(display, "---+")
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
            self.until_said(announcer, "acoustic-announcer: stop 1, Central Station")
            self.assertIsNone(bus.poll())

    def test_the_second_car_has_its_devices_in_other_processes_too(self):
        text = self.assert_done(run("run", "bus", "--print"))
        for before, after in [
            ('# real = "can1"', f'real = "{SECOND_BUS}"'),
            ("[second-next-stop]  # node 35\nplayed = true", "[second-next-stop]\nplayed = false"),
            ("[second-announcer]  # node 39\nplayed = true", "[second-announcer]\nplayed = false"),
        ]:
            self.assertIn(before, text)
            text = text.replace(before, after, 1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "bus.toml"
            file.write_text(text)
            display = self.start("device", "next-stop-indicator-text", SECOND_BUS, "--node-id", "35")
            announcer = self.start("device", "acoustic-announcer", SECOND_BUS, "--node-id", "39", "--announce", "1=Central")
            bus = self.start("run", str(file), "--for", "1min")
            self.until_said(display, "| Central Station                  |")
            self.until_said(announcer, "acoustic-announcer: stop 1, Central")
            self.assertIsNone(bus.poll())


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
