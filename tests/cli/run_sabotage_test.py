#!/usr/bin/env python3
"""Network files and writes of strangers that a customer would complain of: each breaks the invariant
that it is about, alone and beside a harmless fault elsewhere, and makes no node fill the bus.

Every third line is tried, beside the fault; with CANVOY_TESTS=all, all are, and alone as well.
"""

import json
import os
import pathlib
import tempfile
import unittest

from command import CommandTest, run

FAILED_INVARIANT = 1
LOAD_MOST = 20  # percent of a bus; without sabotage, up to 10
TRIES_ALL = os.environ.get("CANVOY_TESTS") == "all"


def little(value, size):
    return value.to_bytes(size, "little").hex()


def write(node, entry, value, size, at="180s"):
    return f"write:bus=sim0:node={node}:object={entry}:bytes={little(value, size)}@{at}"


def off(node, index, can_id):
    """The PDO is invalid (CiA 301, 7.5.2.35: bit 31)."""
    return [write(node, f"{index}/01", 0x80000000 | can_id, 4)]


def synchronous(node, index):
    """With the 240th SYNC, in a network without SYNC."""
    return [write(node, f"{index}/02", 240, 1)]


def rare(node, index, can_id):
    """Inhibit time of 6 s."""
    return [
        write(node, f"{index}/01", 0x80000000 | can_id, 4, "180s"),
        write(node, f"{index}/03", 60000, 2, "180100ms"),
        write(node, f"{index}/01", can_id, 4, "180200ms"),
    ]


def silent(node, index):
    """Without its event timer."""
    return [write(node, f"{index}/05", 0, 2)]


def heartbeat(node, ms):
    return [write(node, "1017/00", ms, 2)]


def mapped(node, communication, mapping, can_id, *entries):
    """Other contents than the partner expects."""
    steps = [write(node, f"{communication}/01", 0x80000000 | can_id, 4, "180s"), write(node, f"{mapping}/00", 0, 1, "180100ms")]
    for i, entry in enumerate(entries, 1):
        steps.append(write(node, f"{mapping}/{i:02}", entry, 4, f"1802{i:02}ms"))
    steps.append(write(node, f"{mapping}/00", len(entries), 1, "180300ms"))
    return steps + [write(node, f"{communication}/01", can_id, 4, "180400ms")]


def repeated(node, entry, value, size, seconds=range(600, 1000, 5)):
    """From before the first call for help to its end."""
    return [write(node, entry, value, size, f"{second}s") for second in seconds]


# Host 1, seat 10, valves 33.
EXCAVATOR = {
    "heartbeat of the valves each 10 s": (heartbeat(33, 10000), "indicators"),
    "heartbeat of the seat each 10 s": (heartbeat(10, 10000), "indicators"),
    "no heartbeat of the host": (heartbeat(1, 0), "lost_host"),
    "left joystick with SYNC": (synchronous(10, 1800), "axis_delta"),
    "left joystick without timer": (silent(10, 1800), "service"),
    "left joystick each 6 s": (rare(10, 1800, 0x18A), "axis_delta"),
    "right joystick with SYNC": (synchronous(10, 1804), "axis_delta"),
    "right joystick without timer": (silent(10, 1804), "service"),
    "right joystick each 6 s": (rare(10, 1804, 0x28A), "axis_delta"),
    "axes of the joystick exchanged": (mapped(10, 1800, "1A00", 0x18A, 0x64010210, 0x64010110), "axis_delta"),
    "angles with SYNC": (synchronous(33, 1801), "display"),
    "angles each 6 s": (rare(33, 1801, 0x2A1), "display"),
    "angles off": (off(33, 1801, 0x2A1), "display"),
    "fuel with SYNC": (synchronous(33, 1802), "display"),
    "fuel off": (off(33, 1802, 0x3A1), "display"),
    "outputs of the valves with SYNC": (synchronous(33, 1400), "presses"),
    "outputs of the valves off": (off(33, 1400, 0x221), "presses"),
    "valves with SYNC": (synchronous(33, 1401), "unwanted_motion"),
    "valves off": (off(33, 1401, 0x321), "unwanted_motion"),
    "valves of boom and stick exchanged": (mapped(33, 1401, 1601, 0x321, 0x64110610, 0x64110510), "unwanted_motion"),
    "lamps with SYNC": (synchronous(10, 1400), "indicators"),
    "lamps off": (off(10, 1400, 0x20A), "indicators"),
    "display with SYNC": (synchronous(10, 1401), "display"),
    "display off": (off(10, 1401, 0x30A), "display"),
}
# Charger 5, battery 10.
CHARGER = {
    "heartbeat of the battery each 10 s": (heartbeat(10, 10000), "less_than_asked"),
    "heartbeat of the battery is not watched": ([write(5, "1016/01", 0, 4)], "battery_left_waiting"),
    "voltage with SYNC": (synchronous(10, 1801), "battery_left_waiting"),
    "voltage without timer": (silent(10, 1801), "less_than_asked"),
    "voltage off": (off(10, 1801, 0x28A), "battery_left_waiting"),
    "voltage each 6 s": (rare(10, 1801, 0x28A), "less_than_asked"),
    "request with SYNC": (synchronous(10, 1802), "battery_left_waiting"),
    "request without timer": (silent(10, 1802), "battery_left_waiting"),
    "request off": (off(10, 1802, 0x38A), "battery_left_waiting"),
    "request each 6 s": (rare(10, 1802, 0x38A), "less_than_asked"),
    "request with another CAN-ID": (
        [write(10, "1802/01", 0x8000038A, 4), write(10, "1802/01", 0x38B, 4, "180500ms")],
        "battery_left_waiting",
    ),
}
BUS = {
    "clock of the computer off": (off(1, 1800, 0x181), "clock"),
    "clock of the computer with SYNC": (synchronous(1, 1800), "clock"),
    "stop message off": (off(1, 1802, 0x181), "announcements"),
    "place message off": (off(1, 1801, 0x181), "tickets"),
    "stop request off": (off(1, 1805, 0x1C1), "stop_sign"),
    "motion off": (off(11, 1800, 0x18B), "passengers"),
    "motion with SYNC": (synchronous(11, 1800), "passengers"),
    "first counter off": (off(20, 1801, 0x294), "passengers"),
    "second counter off": (off(22, 1801, 0x296), "passengers"),
    "people aboard off": (off(21, 1801, 0x295), "passengers"),
    "stop request of the second car off": (off(30, 1800, 0x19E), "second_stop_sign"),
    "stop request of the second car with SYNC": (synchronous(30, 1800), "second_stop_sign"),
    "no heartbeat of the identification": (heartbeat(2, 0), "next_stop"),
    "no heartbeat of the next stop": (heartbeat(5, 0), "lie"),
}
POLICE = {
    "ignition switch off": (off(1, 1800, 0x181), "power"),
    "ignition switch with SYNC": (synchronous(1, 1800), "power"),
    "ignition switch not heard by the supply": (off(9, 1400, 0x181), "power"),
    "no heartbeat of the hands-free": (heartbeat(8, 0), "carrier"),
    "heartbeat of the hands-free each minute": (heartbeat(8, 60000), "carrier"),
    "no heartbeat of the inputs": (heartbeat(10, 0), "calls"),
    "heartbeat of the inputs each 10 s": (heartbeat(10, 10000), "speech"),
    "number pad": (repeated(2, "6081/00", 1, 1), "terminal_wait"),
    "first display": (repeated(2, "6098/00", 1, 1), "terminal_wait"),
    "roof bar": (repeated(3, "6130/01", 0, 4), "blue_light"),
    "siren": (repeated(4, "613A/01", 0, 4, range(700, 960)), "siren"),
    "flashers": (repeated(5, "6140/00", 0, 4), "blue_light"),
    "power of the radio, as told to it": (repeated(6, "6070/00", 0, 1), "speech"),
    "radio": (repeated(6, "6116/00", 0, 1), "speech"),
    "hands-free": (repeated(8, "6151/00", 1, 1), "carrier"),
    "power of the radio": (repeated(9, "6071/00", 1, 1), "power"),
    "power of the periphery": (repeated(9, "6074/00", 1, 1), "power"),
    "central locking": (repeated(1, "600A/00", 1, 1, range(600, 1500, 10)), "locks"),
}
# Changes of the built-in file.
TAXI = {
    "a constant of smaller wheels": (("k = 24000", "k = 24500"), "fare"),
    "a constant of larger wheels": (("k = 24000", "k = 23000"), "fare"),
    "worn tyres": (("wheel_circumference = 2 ", "wheel_circumference = 1.9 "), "distance"),
    "winter tyres": (("wheel_circumference = 2 ", "wheel_circumference = 2.02 "), "distance"),
    "a tooth of the sensor that is broken": (("rotation = 48", "rotation = 47"), "distance"),
    "a sensor that counts both edges": (("rotation = 48", "rotation = 96"), "fare"),
    "a meter of another taxi": (("M-TX 447", "M-TX 448"), "receipt_lines"),
}
LIFT = {
    "drive": {
        "actual velocity off": (["1907 1 u32 0x80000185"], "chain_stops"),
        "commands with SYNC": (["1504 2 u8 240"], "lift_serves"),
        "commands with the CAN-ID of the velocity": (["1504 1 u32 0x80000180", "1504 1 u32 0x184"], "lift_serves"),
        "heartbeat each 10 s": (["1017 0 u16 10000"], "lift_serves"),
    },
    "position": {
        "position with SYNC": (["1906 2 u8 240"], "lift_serves"),
        "position each 6 s": (["1906 1 u32 0x8000018C", "1906 3 u16 60000", "1906 1 u32 0x18C"], "call_served"),
        "position with the CAN-ID of the door": (["1906 1 u32 0x8000018C", "1906 1 u32 0x201"], "lift_serves"),
    },
    "door": {
        "door with SYNC": (["190A 2 u8 240"], "lift_serves"),
        "commands with SYNC": (["1508 2 u8 240"], "no_call_lost"),
    },
    "light-barrier": {
        "light barrier with SYNC": (["190B 2 u8 240"], "nobody_gives_up"),
        "light barrier off": (["190B 1 u32 0x80000205"], "nobody_gives_up"),
    },
    "controller": {
        "velocity not heard": (["1507 1 u32 0x80000185"], "chain_stops"),
        "drive not heard": (["1506 1 u32 0x80000181"], "lift_serves"),
        "commands to the drive with SYNC": (["1904 2 u8 240"], "lift_serves"),
        "commands to the door with SYNC": (["1908 2 u8 240"], "no_call_lost"),
    },
    "car-panel": {
        "buttons each 6 s": (["1881 1 u32 0x80000490", "1881 3 u16 60000", "1881 1 u32 0x490"], "call_acknowledged"),
        "lamps off": (["1500 1 u32 0x80000400"], "call_acknowledged"),
    },
}


class RunSabotage(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def broken(self, *arguments):
        result = run("run", *arguments, "--json")
        self.assertEqual(result.returncode, FAILED_INVARIANT, result.stderr)
        summary = json.loads(result.stdout.splitlines()[-1])
        for bus in summary["buses"]:
            self.assertLess(bus["load_percent"], LOAD_MOST, bus["bus"])
        return [each["invariant"] for each in summary["invariants"] if not each["held"]]

    def assert_break(self, sabotages, fault, arguments_of):
        """Each of `sabotages` by its name: what is done, and the invariant; `arguments_of` makes a run of what is done."""
        for what, (done, invariant) in list(sabotages.items())[:: 1 if TRIES_ALL else 3]:
            for beside in ([], ["--fault", fault]) if TRIES_ALL else (["--fault", fault],):
                with self.subTest(what, beside=beside):
                    self.assertIn(invariant, self.broken(*arguments_of(done), *beside))

    def assert_writes_break(self, world, length, sabotages, fault):
        self.assert_break(sabotages, fault, lambda writes: [world, "--for", length, *(part for each in writes for part in ("--act", each))])

    def file_of(self, world):
        return self.assert_done(run("run", world, "--print"))

    def changed_file(self, text, before, after):
        self.assertIn(before, text)
        path = self.folder / "network.toml"
        path.write_text(text.replace(before, after, 1))
        return str(path)

    def test_an_excavator(self):
        self.assert_writes_break("excavator", "8min", EXCAVATOR, "corrupted-frames@60s+5s")

    def test_a_charger(self):
        self.assert_writes_break("charger", "90min", CHARGER, "corrupted-frames@60s+5s")

    def test_a_bus(self):
        self.assert_writes_break("bus", "50min", BUS, "restart:node=12@60s")

    def test_a_police_car(self):
        self.assert_writes_break("police", "100min", POLICE, "restart:node=11@60s")

    def test_a_taxi(self):
        file = self.file_of("taxi")
        self.assert_break(TAXI, "restart:node=8@5min", lambda change: [self.changed_file(file, *change), "--for", "4h"])

    def test_a_lift(self):
        file = self.file_of("lift")
        for device, sabotages in LIFT.items():
            line = f'device = "lift-{device}"\n'
            self.assert_break(
                sabotages,
                "stuck-button@60s+5s",
                lambda values, line=line: [self.changed_file(file, line, f"{line}values = {json.dumps(values)}\n"), "--for", "1h"],
            )

    def test_a_file_beside_the_name_of_a_world_is_refused(self):
        path = self.folder / "network.toml"
        path.write_text(self.file_of("lift"))
        for words in (["lift", str(path)], [str(path), "lift"]):
            result = run("run", *words, "--for", "1s")
            self.assertEqual(result.returncode, 2, words)
            self.assertIn("exclude each other", result.stderr)
            self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    unittest.main()
