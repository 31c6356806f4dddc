#!/usr/bin/env python3
"""`canvoy device` with devices of CiA 407: what people do with them, what they read, what outlives power."""

import configparser
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.28:43128"


class OnAWire(CommandTest):
    """Devices in a process of their own, which others command and read by CAN."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments):
        """A process; it has said that all of its devices are there."""
        devices = subprocess.Popen([CANVOY, "device", *arguments, BUS], stdout=subprocess.PIPE, text=True)
        self.addCleanup(devices.stdout.close)
        self.addCleanup(devices.wait)
        self.addCleanup(devices.kill)
        self.until(devices, "pre-operational")
        return devices

    def until(self, devices, text):
        lines = []
        for line in devices.stdout:
            lines.append(line)
            if text in line:
                return lines
        self.fail(f"{text} was not said, but {lines}")

    def read(self, node, entry):
        return self.assert_done(run("read", BUS, node, entry, "--profile", "407")).strip()

    def write(self, node, entry, *value):
        self.assert_done(run("write", BUS, node, entry, *value, "--profile", "407"))

    def test_a_ticket_says_where_it_was_bought(self):
        presses = ["place:stop=17:zone=2:segment=4@5s", "ticket@6500ms", "sell@6500ms", "no-paper@7s", "sell@7500ms"]
        options = [word for press in presses for word in ("--press", press)]
        devices = self.start("on-board-computer", "ticket-canceller", "ticket-printer", *options, "--for", "8s")
        # The on-board computer starts them.
        said = devices.stdout.read()
        # The message with the stop point is none of a canceller's (8.1.4.3).
        self.assertRegex(said, r"ticket-canceller: stamps \d\d:\d\d zone 2 segment 4\n")
        self.assertRegex(said, r"ticket-printer: prints \d\d:\d\d stop 17 zone 2 segment 4\n")
        self.assertIn("ticket-printer: no ticket: there is no paper\n", said)

    def test_a_door_that_opens_has_been_released(self):
        self.start("vehicle-gateway", "--press", "open:2@1s", "--press", "close:2@4s", "--for", "20s")
        watched = run("read", BUS, "11", "6488:1", "--profile", "407", "--json", "--watch", "100ms", "--for", "6s")
        states = [json.loads(line)["raw"] for line in self.assert_done(watched).splitlines()]
        # 9.2.15.7: bit 7 a door is open, bit 5 the doors on the right are released.
        self.assertEqual([state for state, before in zip(states, [""] + states) if state != before], ["00", "A0", "00"])

    def test_a_display_draws_a_text_that_flashes(self):
        picture = self.folder / "stop.png"
        display = self.start("next-stop-indicator-text", "--display", "12x2", "--png", str(picture))
        self.assert_done(run("nmt", BUS, "5", "start"))
        text = self.folder / "text"
        text.write_bytes(b"Br\xfccke")
        self.write("5", "6205:1", "1")  # ISO 8859-1
        self.write("5", "6112:1", "--file", str(text))
        # 6203h by bit number: format (flash slow, align right), 12h, 61h, sub-index; then one object is shown.
        self.write("5", "6203:2", "0x4C126101")
        self.write("5", "6203:1", "1")
        empty = "  |              |\n"
        drawn = self.until(display, "Brücke")
        self.assertEqual(drawn[-1], "  |       Brücke |\n")
        self.assertEqual(self.until(display, "---+")[:1], [empty])
        # Slow is a second: it is dark, and there again.
        dark = self.until(display, "  |")
        self.assertEqual(dark[-1], empty)
        self.until(display, "Brücke")
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_who_is_logged_in_and_how_far_it_went_outlives_power(self):
        store = ["--store", str(self.folder / "identification")]
        device = self.start("identification", *store, "--press", "log-in:driver=1234:line=23:journey=7@100ms", "--for", "1s")
        device.wait()
        device = self.start("identification", *store)
        self.assertEqual([self.read("2", entry) for entry in ("6190", "6192", "6195")], ["1234", "23", "7"])

    def test_what_is_no_store_is_left_as_it_is(self):
        store = self.folder / "letter"
        store.write_bytes(b"\xa5" * 5000)
        self.assert_refused(run("device", "identification", "sim", "--store", str(store)), FAILED, "letter")
        self.assertEqual(store.read_bytes(), b"\xa5" * 5000)

    def test_what_was_counted_outlives_power(self):
        store = ["--store", str(self.folder / "counts")]
        manager = self.start("passenger-counting-manager", *store, "--capacity", "10")
        self.assert_done(run("nmt", BUS, "21", "start"))
        self.write("21", "6700", "0x0502")  # the high byte came in
        self.assertEqual(self.read("21", "6722"), "3")
        manager.terminate()
        manager.wait()
        self.start("passenger-counting-manager", *store, "--capacity", "10")
        self.assertEqual(self.read("21", "6722"), "3")


class DeviceBus(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def said(self, *arguments):
        return self.assert_done(run("device", *arguments))

    def test_without_a_time_there_are_no_tickets(self):
        said = self.said("ticket-canceller", "sim", "--press", "ticket@50ms", "--for", "200ms")
        self.assertIn("ticket-canceller: no ticket: it is not in service\n", said)

    def test_several_virtual_devices_are_one_node_with_its_data_sheet(self):
        name = "ticket-canceller+acoustic-announcer"
        said = self.said(name, "sim", "--for", "100ms")
        self.assertIn(f"{name} node 6 (06h): pre-operational", said)
        sheet = self.folder / "both.eds"
        self.assert_done(run("eds", "export", name, "--out", str(sheet)))
        self.assertIn("0 errors, 0 warnings", self.assert_done(run("eds", "check", str(sheet), "--profile", "407")))
        eds = configparser.ConfigParser(strict=False)
        eds.read(sheet)
        # 9.2.3.1: the high words of 1000h that each alone would have; 04h is a canceller, 07h an announcer.
        default = lambda section: int(eds[section]["DefaultValue"], 0)
        self.assertEqual(default("1000"), 0x0000_0197)
        self.assertEqual(default("67FF"), 0x0000_0197)
        self.assertEqual([default(f"6000sub{sub}") for sub in (0, 1, 2)], [2, 0x0400, 0x0700])

    def test_what_makes_no_sense_is_refused(self):
        for arguments, parts in [
            (["ticket-canceller", "sim", "--press", "hire@2s"], ("'hire@2s'", "ticket@2s")),
            (["ticket-canceller", "sim", "--press", "ticket"], ("'ticket'", "ticket@2s")),
            (["ticket-canceller", "sim", "--press", "ticket:1@2s"], ("'ticket:1@2s'",)),
            (["ticket-reader", "sim", "--press", "ticket@2s"], ("there is nothing",)),
            (["console-keyboard", "sim", "--press", "key:33@2s"], ("'key:33@2s'", "key5@2s")),
            (["console-keyboard", "sim", "--press", "key@2s"], ("'key@2s'",)),
            (["console-keyboard", "sim", "--press", "key33@2s"], ("'key33@2s'", "key5@2s")),
            (["passenger-counter", "sim", "--set", "in=0@2s"], ("'in=0@2s'", "in=3@2s")),
            (["identification", "sim", "--press", "log-in:line=65536@2s"], ("log-in=driver:1234,line:23@2s",)),
            (["identification", "sim", "--press", "log-in:line=1:line=2@2s"], ("'log-in:line=1:line=2@2s'",)),
            (["bus-power-supply", "sim", "--press", "fail:0x2111@2s"], ("fail=0x3110@2s",)),
            (["ticket-canceller", "sim", "--segment", "small"], ("'small'", "minimum")),
            (["ticket-canceller", "sim", "--png", "x.png"], ("--png", "0")),
            (["next-stop-indicator-text", "sim", "--display", "32"], ("'32'", "32x4")),
            (["next-stop-indicator-text", "sim", "--display", "129x1"], ("128x16",)),
            (["acoustic-announcer", "sim", "--announce", "Town Hall"], ("'Town Hall'", "17=")),
            (["ticket-canceller+taximeter", "sim"], ("'taximeter'", "CiA 407")),
            (["taximeter+ticket-canceller", "sim"], ("'ticket-canceller'", "CiA 447")),
            (["ticket-canceller+ticket-canceller", "sim"], ("twice",)),
            (["on-board-computer+identification", "sim"], ("different physical devices", "8.1.4.3")),
            (["identification+ticket-canceller+on-board-computer", "sim"], ("8.1.4.3",)),
            (["ticket-canceller+", "sim"], ("ticket-canceller+",)),
            (["lift-drive+ticket-canceller", "sim"], ("'lift-drive'", "CiA 407 or CiA 447")),
            (["passenger-counter", "sim", "--door", "13"], ("--door", "1 to 12")),
        ]:
            with self.subTest(arguments):
                self.assert_refused(run("device", *arguments), USAGE, *parts)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
