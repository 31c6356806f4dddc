#!/usr/bin/env python3
"""`canvoy device operator`: elements by options and by a file, its data sheet, and a host that works with it."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.29:43129"
SEAT = "joysticks=2,push-button-clusters=1,indicator-clusters=1,displays=1,display-parameters=2"


class Operator(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def export(self, name, elements):
        sheet = str(self.folder / f"{name}.eds")
        self.assert_done(run("eds", "export", "operator", "--elements", elements, "--out", sheet))
        self.assertIn("0 errors, 0 warnings", self.assert_done(run("eds", "check", sheet, "--profile", "852")), elements)
        return pathlib.Path(sheet).read_text()

    def test_data_sheets_have_what_is_there(self):
        text = self.export("seat", SEAT)
        # Table 8: joysticks with buttons, push-buttons, indicators, displays.
        self.assertIn("DefaultValue=0xF18F0191", text)
        self.assertIn("[6401sub6]", text)
        self.assertNotIn("[6401sub7]", text)
        self.assertNotIn("[6426]", text, "of CiA 401")
        self.assertIn("[1821]", text)
        self.assertNotIn("[1813]", text)
        self.export("remote", "push-button-clusters=1")
        most = "joysticks=16,foot-pedals=16,encoders=8,wheels=8,push-button-clusters=8,indicator-clusters=8,displays=8"
        self.assertIn("[6426]", self.export("cabin", most + ",configuration=yes"))

    def test_more_than_the_most_is_refused_in_one_line(self):
        for elements, *said in (
            ("joysticks=17", "joysticks=17: 0 to 16"),
            ("foot-pedals=17", "0 to 16"),
            ("encoders=9", "0 to 8"),
            ("wheels=9", "0 to 8"),
            ("push-button-clusters=9", "0 to 8"),
            ("indicator-clusters=9", "0 to 8"),
            ("displays=9", "0 to 8"),
            ("displays=1,display-parameters=13", "1 to 12"),
            ("displays=1,display-parameters=0", "1 to 12"),
            ("joysticks=-1", "joysticks=-1"),
            ("joysticks", "joysticks=: 0 to 16"),
            ("stick=1", "'stick' is none of joysticks"),
            ("configuration=maybe", "yes or no"),
            ("configuration=yes", "give one at least"),
        ):
            self.assert_refused(run("device", "operator", "sim", "--elements", elements), USAGE, "--elements", *said)
            self.assert_refused(run("eds", "export", "operator", "--elements", elements), USAGE, "--elements", *said)
        self.assert_refused(run("eds", "export", "charger", "--elements", "joysticks=1"), USAGE, "--elements")
        seat = self.folder / "seat.toml"
        seat.write_text("wheels = 1\njoysticks = 17\n")
        self.assert_refused(run("device", "operator", "sim", "--elements", str(seat)), FAILED, "seat.toml", "2", "joysticks")

    def test_what_cannot_be_moved_is_refused(self):
        for move in ("joystick3.x=1@1s", "joystick1.x@1s", "joystick1.x=1", "wheel1=1@1s", "joystick1.b9=1@1s", "=1@1s",
                     "push-button-cluster1.b65=1@1s", "joystick1=1@1s"):
            self.assert_refused(run("device", "operator", "sim", "--elements", SEAT, "--move", move), USAGE)

    def wait_for(self, place, expected):
        """A device comes up, and what is moved comes with time."""
        for _ in range(200):
            result = run("read", BUS, "10", place)
            if result.returncode == DONE and expected in result.stdout:
                return
            time.sleep(0.1)
        self.fail(f"{place} is never {expected}")

    def test_a_host_reads_what_is_moved_and_switches_indicators(self):
        seat = self.folder / "seat.toml"
        seat.write_text("joysticks = 1\npush-button-clusters = 1\nindicator-clusters = 1\ndisplays = 1\n")
        device = subprocess.Popen(
            [CANVOY, "device", "operator", BUS, "--elements", str(seat), "--move", "joystick1.y=-12000@1ms",
             "--move", "joystick1.b2=1@1ms", "--move", "push-button-cluster1.b64=1@1ms"],
            stdout=subprocess.PIPE, text=True)
        try:
            for place, expected in (("6401:2", "-12000"), ("6000:2", "b2: switched-on"), ("6000:38", "pb8: switched-on")):
                self.wait_for(place, expected)
            self.assert_done(run("write", BUS, "10", "6200:1", "0x05"))
            self.assert_done(run("write", BUS, "10", "6411:3", "77"))
        finally:
            device.terminate()
            said, _ = device.communicate()
        self.assertIn("indicator 1 of cluster 1 on", said)
        self.assertIn("indicator 3 of cluster 1 on", said)
        self.assertNotIn("indicator 2", said)
        self.assertIn("display 1 parameter 3: 77", said)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
