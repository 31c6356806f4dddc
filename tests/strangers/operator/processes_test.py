#!/usr/bin/env python3
"""Each device of an excavator in another process, on UDP multicast: a seat, valves, an armrest and a host that the world
does not play, and the seat's own network behind it.

    CANVOY=build/canvoy tests/strangers/operator/processes_test.py
"""

import json
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

BUS = "udp:239.74.163.41:43141"
BEHIND = "udp:239.74.163.42:43142"
PATIENCE = 300  # seconds
# The contact of the right stick's direction (button 8: y+) is closed where the sensor says that it is there.
UNLOCKS_AND_LIFTS = ["push-button-cluster1.b5=1@5s", "push-button-cluster1.b5=0@5200ms", "joystick2.b8=1@7s", "joystick2.y=20000@7s"]


class Processes(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments):
        program = subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

    def world(self, real, embedded=False):
        """A world in which these devices are not played, as a program that tells events and snapshots."""
        text = self.assert_done(run("run", "excavator", "--print"))
        wanted = [('# real = "can0"', f'real = "{BUS}"')]
        wanted += [(f"[{name}]\nplayed = true", f"[{name}]\nplayed = false") for name in real]
        if embedded:
            wanted.append(('# real = "can1"', f'real = "{BEHIND}"'))
        for before, after in wanted:
            self.assertIn(before, text)
            text = text.replace(before, after, 1)
        path = self.folder / f"{'-'.join(real)}.toml"
        path.write_text(text)
        return self.start("run", str(path), "--for", "2min", "--json")

    def until(self, program, is_wanted):
        """What was told up to the line that is wanted."""
        lines = []
        give_up = time.monotonic() + PATIENCE
        for line in program.stdout:
            lines.append(json.loads(line))
            if is_wanted(lines[-1]):
                return lines
            self.assertLess(time.monotonic(), give_up, lines[-5:])
        self.fail(f"it has ended: {program.stderr.read()} {lines[-5:]}")

    def until_lamps(self, program, lit):
        return self.until(program, lambda line: line["event"] == "lamps" and line["lit"] == lit)

    def until_switched(self, program, output):
        return self.until(program, lambda line: line["event"] == "switch" and line["output"] == output and line["on"])

    def until_reads(self, *place, is_wanted):
        give_up = time.monotonic() + PATIENCE
        while True:
            result = run("read", *place)
            if result.returncode == 0 and is_wanted(result.stdout):
                return
            self.assertLess(time.monotonic(), give_up, result.stdout + result.stderr)

    def test_a_real_seat_moves_the_machine(self):
        """The valves tell by their outputs what has reached them; 6411h:03h is the boom."""
        moves = [word for move in UNLOCKS_AND_LIFTS for word in ("--move", move)]
        self.start("device", "operator", BUS, *moves)
        world = self.world(["seat"])
        self.until_switched(world, "hydraulics")
        self.until_reads(BUS, "33", "6411:3", is_wanted=lambda said: int(said) > 10_000)

    def test_behind_a_real_seat_is_an_armrest_of_the_world(self):
        moves = [word for move in UNLOCKS_AND_LIFTS for word in ("--move", move)]
        self.start("device", "operator", BUS, "--embedded", BEHIND, *moves)
        world = self.world(["seat"], embedded=True)
        self.until_switched(world, "hydraulics")
        self.until_reads(BUS, "33", "6411:3", is_wanted=lambda said: int(said) > 10_000)

    def test_real_valves_are_led_and_lead_the_plant(self):
        self.start("device", "io-401", BUS, "--node-id", "33")
        world = self.world(["valves"])
        self.until_switched(world, "hydraulics")
        self.until(world, lambda line: line["event"] == "operator" and line["operator"] == "lowers the bucket")

    def test_a_real_armrest_whose_lever_is_up_locks_and_one_that_is_lost_is_told(self):
        armrest = self.start("device", "io-401", BEHIND, "--node-id", "7")
        world = self.world(["armrest"], embedded=True)
        self.until_lamps(world, ["locked", "ready"])
        told = self.until(world, lambda line: line["event"] == "operator")
        self.assertFalse([line for line in told if line["event"] == "switch" and line["output"] == "hydraulics"])
        armrest.kill()
        self.until(world, lambda line: line["event"] == "lamps" and "fault" in line["lit"])

    def test_a_real_host_works_with_seat_and_valves_of_another_world(self):
        """The host is that of another world, whose seat and valves are here."""
        machine = self.world(["host"])
        self.world(["seat", "valves"])
        self.until_switched(machine, "hydraulics")
        self.until(machine, lambda line: line["event"] == "operator" and line["operator"] == "lowers the bucket")

    def test_what_is_behind_the_seat_of_a_world_is_read_from_outside(self):
        world = self.world(["host"])
        self.until(world, lambda line: line["event"] == "operator")
        self.until_reads(BUS + "/2:7", "6000:1", is_wanted=lambda said: said.strip() == "7")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
