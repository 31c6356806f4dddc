#!/usr/bin/env python3
"""`canvoy device operator`: elements by options and by a file, its data sheet, and a host that works with it."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.29:43129"
BEHIND = "udp:239.74.163.30:43130"
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

    def start(self, *arguments):
        device = subprocess.Popen([CANVOY, "device", "operator", *arguments], stdout=subprocess.DEVNULL)
        self.addCleanup(device.wait)
        self.addCleanup(device.terminate)

    def test_a_device_behind_the_module_is_read_and_written_through_it(self):
        self.start(BUS, "--elements", "joysticks=1", "--embedded", BEHIND, "--embedded-emergency", "0x6C0")
        self.start(BEHIND, "--node-id", "7", "--elements", SEAT, "--move", "joystick1.y=-1234@1ms")
        for _ in range(200):
            result = run("read", BUS + "/2:7", "6401:2")
            if "-1234" in result.stdout:
                break
            time.sleep(0.1)
        self.assertIn("-1234", result.stdout, result.stderr)
        self.assertIn("Canvoy operator environment", self.assert_done(run("read", BUS + "/2:7", "1008", "--segmented")))
        self.assertIn("Canvoy operator environment", self.assert_done(run("read", BUS + "/2:7", "1008", "--block")))
        self.assertIn('"network":2,"node":7', self.assert_done(run("read", BUS + "/2:7", "6401:2", "--json")))
        self.assert_done(run("write", BUS + "/2:7", "6200:1", "0x05"))
        self.assertIn("i1: switched-on", self.assert_done(run("read", BEHIND, "7", "6200:1")))
        # The module itself has one joystick, and no indicators.
        self.assert_refused(run("read", BUS, "10", "6200:1"), FAILED, "node 10")
        self.assert_refused(run("read", BUS + "/2:7", "6123"), FAILED, "node 7 (07h) of network 2", "06020000h")
        self.assert_refused(run("read", BUS + "/3:7", "1000"), FAILED, "node 7 (07h) of network 3", "060A0023h")
        # The module says that nobody has answered it: an abort of its own, and no silence.
        self.assert_refused(run("read", BUS + "/2:8", "1000"), FAILED, "node 8 (08h) of network 2", "05040000h")
        self.assert_refused(run("read", BUS + "/2:7", "1000", "--through", "11"), FAILED, "node 11 (0Bh) does not answer")
        self.assert_refused(run("read", BEHIND + "/2:7", "1000", "--through", "7"), FAILED, "05040001h")

    def test_what_is_no_place_behind_a_module_is_refused(self):
        for bus in ("can0/", "can0/2", "can0/2:", "can0/:7", "can0/0:7", "can0/2:0", "can0/2:128", "can0/65536:7", "can0/2:7x"):
            self.assert_refused(run("read", bus, "1000"), USAGE, bus, "can0/2:7")
        self.assert_refused(run("write", "can0/2:7", "10", "6200:1", "5"), USAGE, "5")
        self.assert_refused(run("read", "can0", "10"), USAGE, "required")
        self.assert_refused(run("read", "can0/2:7", "1000", "--indication", "64"), USAGE, "--indication")
        for arguments in (("--embedded", "sim"), ("--embedded", BUS), ("--embedded", BEHIND, "--embedded-emergency", "0x581"),
                          ("--embedded", BEHIND, "--embedded-network", "0")):
            self.assert_refused(run("device", "operator", BUS, *arguments), USAGE)
        self.assert_refused(run("device", "charger", BUS, "--embedded", BEHIND), USAGE, "--embedded", "operator")

    def test_hands_that_are_none_are_refused(self):
        stick = self.folder / "stick.toml"
        stick.write_text('device = "/dev/input/event99"\n[[axis]]\ncode = "ABS_X"\nmoves = "joystick1.x"\n')
        self.assert_refused(run("device", "operator", BUS, "--joystick", str(stick)), FAILED, "/dev/input/event99")
        self.assert_refused(run("device", "operator", BUS, "--joystick", "/dev/null"), FAILED, "/dev/null: this is no input device")
        self.assert_refused(run("device", "operator", BUS, "--joystick", "nowhere.toml"), FAILED, "nowhere.toml")
        stick.write_text('device = "/dev/null"\n[[axis]]\ncode = "ABS_X"\nmoves = "joystick3.x"\n')
        self.assert_refused(run("device", "operator", BUS, "--joystick", str(stick)), FAILED, "stick.toml line 4", "joystick3.x")
        self.assert_refused(run("device", "charger", BUS, "--joystick", "/dev/null"), USAGE, "--joystick", "operator")

    def test_a_program_is_downloaded_in_a_block_and_in_segments(self):
        store, image = str(self.folder / "program.store"), self.folder / "image.bin"
        image.write_bytes(bytes(i * 7 % 256 for i in range(3_000)))
        crc = f"{zlib.crc32(image.read_bytes()):08X}"
        for options in ([], ["--segmented"]):
            device = subprocess.Popen([CANVOY, "device", "operator", BUS, "--program-store", store], stdout=subprocess.PIPE, text=True)
            try:
                self.wait_for("1F57:1", "")
                done = self.assert_done(run("program", BUS, "10", str(image), "--check-crc", "--timeout", "10000ms", *options))
            finally:
                device.terminate()
                said, _ = device.communicate()
            self.assertIn("3000 bytes are program 1", done)
            self.assertIn(f"operator: program 1 came, 3000 bytes, {crc}h", said)
            self.assertIn("operator: program 1 started", said)
        self.assertIn(image.read_bytes(), pathlib.Path(store).read_bytes())

    def test_a_program_wants_a_file_and_an_operator(self):
        wanted = ("--elements", "joysticks=1,program-download=yes")
        self.assert_refused(run("device", "operator", "sim", *wanted), USAGE, "--program-store")
        self.assert_refused(run("device", "charger", "sim", "--program-store", "x"), USAGE, "--program-store", "operator")
        missing = str(self.folder / "missing" / "program.store")
        self.assert_refused(run("device", "operator", "sim", "--program-store", missing), FAILED, "No such file or directory")
        self.assertIn("[1F50sub1]", self.export("loader", wanted[1]))
        self.assertIn("[6445sub1]", self.export("floats", "displays=1,display-floats=yes"))

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
