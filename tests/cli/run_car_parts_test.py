#!/usr/bin/env python3
"""`canvoy run FILE` with devices of a car as processes of their own on a real bus, and what such processes keep."""

import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network
import side_by_side

BUSES = side_by_side.buses("udp:239.74.163.23", 43123)
# The driver is in a hurry: all takes some 50 s of the clock.
TAXI = """network = "taxi"
nmea = "drive.nmea"
[bus]
real = "BUS"
[shift]
sign_on_after = "20s"
waiting_max = "1s"
boarding_max = "2s"
paying_max = "2s"
"""
POLICE = """network = "police"
[bus]
real = "BUS"
"""


def sentence(second, knots):
    content = f"GPRMC,1200{second:02},A,4808.220,N,01134.500,E,{knots},084.4,211126,,"
    checksum = 0
    for byte in content.encode():
        checksum ^= byte
    return f"${content}*{checksum:02X}\r\n"


def at_noon():
    """The environment, at a place where it is noon: until a meter is told the time, its tariff is by its own clock."""
    west = datetime.datetime.now(datetime.timezone.utc).hour - 12
    return {**os.environ, "TZ": f"NOON{west}"}


class RunCarParts(CommandTest):
    def setUp(self):
        self.bus = next(BUSES)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # 10 s at 36 km/h, and half a second to begin and to end.
        drive = sentence(0, 0) + "".join(sentence(second, 19.4384) for second in range(1, 12)) + sentence(12, 0)
        (self.folder / "drive.nmea").write_text(drive)

    def play(self, network, elsewhere, devices, length):
        """The lines of the rest, and what each process of devices has said."""
        path = self.folder / "car.toml"
        path.write_text(network.replace("BUS", self.bus) + "".join(f"[{name}]\nplayed = false\n" for name in elsewhere))
        parts = [
            subprocess.Popen([CANVOY, "device", *device, self.bus], stdout=subprocess.PIPE, text=True, env=at_noon())
            for device in devices
        ]
        try:
            result = run("run", str(path), "--json", "--for", length)
        finally:
            told = []
            for part in parts:
                part.terminate()
                told.append(part.communicate(timeout=60)[0])
        self.assertEqual(result.stderr, "")
        return [json.loads(line) for line in result.stdout.splitlines()], told

    def test_a_meter_on_the_bus_is_what_the_driver_follows(self):
        keys = ["sign-on@37s", "hire@43s", "stop@71s", "for-hire@77s", "sign-off@83s"]
        presses = [word for key in keys for word in ("--press", key)]
        meter = ["taximeter", "--node-id", "lss", "--serial-number", "1002"]
        others = ["--printer", "3", "--sign", "5", "--clock", "4", *presses]
        lines, told = self.play(TAXI, ["taximeter"], [[*meter, *others]], "97s")
        states = [line["state"] for line in lines if line.get("event") == "meter"]
        self.assertEqual(states, ["for hire", "hired", "stopped", "for hire", "signed off"])
        for text in ("for hire", "hired, 3.90", "stopped, ", "signed off"):
            self.assertIn(f"taximeter: {text}", told[0])
        trip = lines[-1]["trips"][0]
        self.assertAlmostEqual(trip["distance_m"], 110, delta=1)
        self.assertIs(trip["judged"], True, "its fare is read over the mesh")
        shown = re.findall(r"taximeter: stopped, (\d+\.\d\d)", told[0])[-1]
        self.assertEqual(f"{trip['paid']:.2f}", shown, "the passenger pays what the meter shows")
        self.assertTrue(any(line.startswith("INCOME") for line in lines[-1]["paper"]), "it has our printer print")
        self.assertIs(lines[-1]["all_held"], True)

    def test_a_printer_on_the_bus_prints_the_receipt(self):
        printer = ["printer", "--node-id", "lss", "--serial-number", "1003"]
        lines, told = self.play(TAXI, ["printer"], [printer], "90s")
        self.assertEqual(len(lines[-1]["trips"]), 1)
        self.assertIn("printer: TAXI M-TX 447", told[0])
        self.assertRegex(told[0], r"printer: TOTAL +\d+\.\d\d")
        self.assertIs(lines[-1]["all_held"], True)

    def test_a_blue_light_on_the_bus_is_named_and_started_by_the_police_car(self):
        blue_light = ["blue-light", "--node-id", "lss", "--serial-number", "2005"]
        lines, told = self.play(POLICE, ["blue-light"], [blue_light], "60s")
        self.assertIn("is node 5", told[0])
        self.assertIn("blue-light: operational", told[0])
        states = [line["state"] for line in lines if line.get("event") == "nmt-state" and line["node"] == 5]
        self.assertEqual(states, ["operational"])
        self.assertIs(lines[-1]["all_held"], True)

    def test_a_gateway_gives_each_device_the_node_id_that_it_had_before_the_gateway_was_off(self):
        devices = {"radio": "71", "printer": "72"}

        def ids_by_name(names):
            """The node-ID that each device was given by a gateway that is started now."""
            parts = {
                name: subprocess.Popen(
                    [CANVOY, "device", name, "--node-id", "lss", "--serial-number", devices[name], self.bus],
                    stdout=subprocess.PIPE,
                    text=True,
                )
                for name in names
            }
            self.assert_done_loosely(
                run("device", "ivn-gateway", self.bus, "--store", str(self.folder / "gateway.store"), "--for", "12s")
            )
            found = {}
            for name, part in parts.items():
                part.terminate()
                found[name] = re.search(r"is node (\d+)", part.communicate(timeout=60)[0]).group(1)
            return found

        first = ids_by_name(["radio", "printer"])
        self.assertEqual(set(first.values()), {"2", "3"})
        second = next(name for name, node in first.items() if node == "3")
        self.assertEqual(ids_by_name([second]), {second: "3"}, "alone it would have become node 2")

    def test_what_a_seat_has_in_its_memory_outlives_the_gateways_process(self):
        def ask_gateway(*requests):
            """What is read of the driver's seat after these commands (6018:01, table of 4.2.2.12)."""
            part = subprocess.Popen(
                [CANVOY, "device", "ivn-gateway", self.bus, "--store", str(self.folder / "gateway.store")], stdout=subprocess.PIPE, text=True
            )
            try:
                part.stdout.readline()
                for request in requests:
                    self.assert_done_loosely(run("write", self.bus, "1", "6018:01", request))
                return run("read", self.bus, "1", "6019:01").stdout
            finally:
                part.terminate()
                part.communicate(timeout=60)

        self.assertIn("rm: No memory recalled", ask_gateway("0xFF9FFF"), "nothing is in memory 1 yet")
        self.assertIn("sm: Memory 1 stored", ask_gateway("0xFCFFFF"))
        self.assertIn("rm: Memory 1 recalled", ask_gateway("0xFF9FFF"))

    def test_several_orders_are_said_in_one(self):
        said = self.assert_done(run("device", "taximeter", "--press", "hire@0s,sign-on@50ms", "sim", "--set", "supplement=1@100ms,level=2@150ms", "--for", "300ms"))
        self.assertIn("hire: not in this state", said)
        self.assertIn("taximeter: for hire", said)
        self.assertIn("supplement: not in this state", said)
        self.assertNotIn("level: not in this state", said)

    def test_what_a_meter_has_counted_outlives_its_process(self):
        store = str(self.folder / "meter.store")
        arguments = ["device", "taximeter", "sim", "--store", store]
        first = run(*arguments, "--press", "sign-on@200ms", "--press", "hire@500ms", "--for", "1500ms")
        self.assertIn("taximeter: hired, ", self.assert_done(first))
        again = self.assert_done(run(*arguments, "--press", "stop@500ms", "--press", "for-hire@700ms", "--for", "1s"))
        self.assertIn("taximeter: stopped, ", again, "the trip goes on after a short loss of power")
        self.assertNotIn("not in this state", again)
        last = self.assert_done(run(*arguments, "--press", "sign-on@200ms", "--for", "500ms"))
        self.assertIn("sign-on: not in this state", last, "the shift is under way")

    def test_a_meter_is_sealed_and_says_who_has_touched_it(self):
        store = str(self.folder / "meter.store")
        keys = ["begin-calibration@50ms", "enter-service@100ms", "open-seal@200ms", "enter-service@400ms", "begin-calibration@500ms"]
        keys += ["end-calibration@600ms", "leave-service@700ms", "close-seal@800ms", "leave-service@900ms"]
        presses = [word for key in keys for word in ("--press", key)]
        said = self.assert_done(run("device", "taximeter", "sim", "--store", store, *presses, "--for", "1500ms"))
        for key in ("begin-calibration", "enter-service", "end-calibration", "leave-service"):
            self.assertEqual(said.count(f"{key}: not in this state"), 1, "without the seal, without pulses, or with it open")
        told = re.findall(r"taximeter: recorded: [-0-9]+ [:0-9]+ UTC: (.*)", said)
        self.assertEqual(told, ["seal opened", "service mode entered", "seal closed", "sealed, k 24000"])

        meter = subprocess.Popen([CANVOY, "device", "taximeter", self.bus, "--store", store], stdout=subprocess.PIPE, text=True)
        try:
            self.await_node("5")
            refused = run("write", self.bus, "5", "6056h", "200")
            self.assertEqual(refused.returncode, 1)
            self.assertIn("08000021h", refused.stderr)
            newest = self.assert_done(run("read", self.bus, "5", "5F21h:01h", "--type", "vs"))
            self.assertIn("write refused, default channel, 6056h:00h = C8h", newest)
            self.assertIn("sealed, k 24000", self.assert_done(run("read", self.bus, "5", "5F21h:02h", "--type", "vs")), "of the process before")
        finally:
            meter.terminate()
            meter.communicate(timeout=60)

    def await_node(self, node):
        for _ in range(600):
            if run("read", self.bus, node, "1000h").returncode == 0:
                return
        self.fail(f"node {node} does not answer")

    def test_a_gps_says_what_was_recorded(self):
        log = self.folder / "gps.log"
        drive = pathlib.Path(__file__).parents[2] / "examples" / "town.nmea"
        watcher = subprocess.Popen([CANVOY, "monitor", self.bus, "--profile", "447-3", "--for", "4s"], stdout=subprocess.PIPE, text=True)
        self.assert_done_loosely(run("device", "ivn-gateway", "gps", self.bus, "--nmea", str(drive), "--for", "3s"))
        log.write_text(watcher.communicate(timeout=60)[0])
        self.assertIn("48.140", log.read_text())

    def assert_done_loosely(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_says_what_is_wrong(self):
        for arguments, *parts in [
            (["taximeter", "--press", "fly@2s"], "--press", "'fly@2s'", "sign-on, hire,"),
            (["taximeter", "--press", "hire"], "--press", "'hire'"),
            (["taximeter", "--press", "hire@1s", "stop@2s"], "'stop@2s'", "hire@2s,stop@9s in one"),
            (["taximeter", "--press", "hire@1s,fly@2s"], "--press", "'fly@2s'"),
            (["printer", "--press", "hire@2s"], "--press", "'hire@2s'", "there is paper="),
            (["ivn-gateway", "--speed", "fast@2s"], "--speed", "'fast@2s'", "50@10s"),
            (["gps", "--speed", "5@2s", "--nmea", str(self.folder / "drive.nmea")], "--speed"),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(run("device", *arguments, "sim", "--for", "1s"), USAGE, *parts)


def load_tests(loader, tests, pattern):
    return side_by_side.Suite(tests)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
