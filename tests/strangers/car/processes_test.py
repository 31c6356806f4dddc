#!/usr/bin/python3
"""All virtual devices of CiA 447-3 as 16 processes on UDP multicast: a gateway that gives 15 devices their node-IDs by
Fastscan, and starts them. python-can hears that all of them are operational, and stay so.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/car/processes_test.py
"""

import pathlib
import subprocess
import sys
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path += [str(TESTS), str(TESTS / "cli")]
import own_network
from command import CANVOY, CommandTest

try:
    import can
    import msgpack  # without it python-can has no such bus
except ImportError as error:
    own_network.skip(f"{error}; scripts/install-packages test installs python3-can and python3-msgpack")

GROUP, PORT = "239.74.163.29", 43129
BUS = f"udp:{GROUP}:{PORT}"
ADD_ONS = [
    "fire-extinguishing",
    "emergency-fresh-air",
    "power-supply",
    "discrete-inputs",
    "terminal",
    "gps+navigation",
    "taximeter",
    "printer",
    "real-time-clock+driver-identification",
    "tariff-display",
    "taxi-alarm",
    "radio+audio-switch",
    "roof-bar-light",
    "roof-bar-sound+hands-free",
    "blue-light",
]
PATIENCE = 240  # seconds, on a machine that does other things as well
OPERATIONAL = 0x05


class Processes(CommandTest):
    def start(self, *arguments):
        program = subprocess.Popen([CANVOY, "device", *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

    def test_fifteen_devices_join_by_fastscan_and_all_are_operational(self):
        with can.Bus(interface="udp_multicast", channel=GROUP, port=PORT) as bus:
            programs = [
                self.start(device, BUS, "--node-id", "lss", "--serial-number", str(5000 + i)) for i, device in enumerate(ADD_ONS)
            ]
            programs.append(self.start("ivn-gateway", BUS))
            heard = {}
            give_up = time.monotonic() + PATIENCE
            while sum(state == OPERATIONAL for state in heard.values()) < 16:
                self.assertLess(time.monotonic(), give_up, heard)
                message = bus.recv(1)
                if message and 0x701 <= message.arbitration_id <= 0x710 and message.data:
                    heard[message.arbitration_id - 0x700] = message.data[0]
            self.assertEqual(sorted(heard), list(range(1, 17)), "node-IDs 1 to 16, each once")
            # Nobody is lost, boots again, or leaves operational in the seconds after.
            still = {}
            until = time.monotonic() + 5
            while time.monotonic() < until:
                message = bus.recv(1)
                if message and 0x701 <= message.arbitration_id <= 0x710 and message.data:
                    still.setdefault(message.arbitration_id - 0x700, set()).add(message.data[0])
            self.assertEqual(still, {node: {OPERATIONAL} for node in range(1, 17)})
            self.assertEqual([program.poll() for program in programs], [None] * 16)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
