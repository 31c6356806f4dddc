#!/usr/bin/env python3
"""canvoy eds read: two batteries on a bus; the DCF of one configures the other, and a stand-in is made of it."""

import configparser
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.8:43119"

# What differs from the defaults: heartbeat, a consumer, the third TPDO on a CAN-ID of its own.
CHANGES = """\
1017 0 u16 700
1016 1 u32 0x000501F4
1802 1 u32 0x80000380
1802 2 u8 254
1802 5 u16 200
1802 1 u32 0x00000381
"""


# Of a device that gives its own sheet.
STORED_EDS = """\
[1021]
ParameterName=Store EDS
ObjectType=0x2
DataType=0x000F
AccessType=ro
[1022]
ParameterName=Store format
ObjectType=0x7
DataType=0x0005
AccessType=ro
DefaultValue=0
"""


# What a profile does not describe: UNSIGNED16 (CiA 306: 0x0006).
OWN_OBJECT = """\
[2000]
ParameterName=Speed
ObjectType=0x7
DataType=0x0006
AccessType=rw
DefaultValue=1500
"""


def wait_for(node):
    for _ in range(100):
        if run("read", BUS, node, "1000").returncode == 0:
            return
        time.sleep(0.1)
    raise AssertionError(f"node {node} does not come up")


class EdsRead(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.devices = []
        for node in ("10", "20"):
            cls.start("battery", node)

    @classmethod
    def start(cls, kind, node):
        device = subprocess.Popen(
            [CANVOY, "device", kind, BUS, "--node-id", node], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        cls.devices.append(device)
        wait_for(node)

    @classmethod
    def tearDownClass(cls):
        for device in cls.devices:
            device.terminate()
            device.wait()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def sheet(self, node, name, *arguments):
        said = self.assert_done(run("eds", "read", BUS, node, "--out", self.path(name), *arguments))
        self.assertRegex(said, r"\Anode \d+ \(\w+h\), by [^\n]+: \d+ entries read, written to [^\n]+\n([^\n]+\n)?\Z")
        # A profile does not describe what the manufacturer has added; a sheet of the device does.
        self.assertEqual(f"is left out: canvoy clone {BUS} {node} reads 2000h to 9FFFh whole" in said, "by CiA" in said, said)
        sheet = configparser.ConfigParser(interpolation=None)
        sheet.read(self.path(name))
        return sheet

    def test_a_node_becomes_a_dcf_by_its_profile(self):
        sheet = self.sheet("10", "ten.dcf", "--name", "left", "--bit-rate", "250")
        self.assertEqual(sheet["1000"]["ParameterValue"], "0x000001A2", "CiA 418")
        self.assertEqual(sheet["DeviceComissioning"]["NodeID"], "10")
        self.assertEqual(sheet["DeviceComissioning"]["NodeName"], "left")
        self.assertEqual(sheet["DeviceComissioning"]["Baudrate"], "250")
        self.assertIn("0 errors, 0 warnings", self.assert_done(run("eds", "check", self.path("ten.dcf"), "--profile", "418")))

    def test_a_node_becomes_a_dcf_by_an_eds(self):
        self.assert_done(run("eds", "export", "battery", "--out", self.path("battery.eds")))
        sheet = self.sheet("10", "ten.dcf", "--eds", self.path("battery.eds"))
        self.assertEqual(sheet["FileInfo"]["LastEDS"], self.path("battery.eds"))
        self.assertIn("0 errors, 0 warnings", self.assert_done(run("eds", "check", self.path("ten.dcf"), "--profile", "418")))

    def test_the_dcf_of_one_node_configures_another(self):
        changes = self.folder / "changes.txt"
        changes.write_text(CHANGES)
        self.assert_done(run("configure", BUS, "10", str(changes)))
        self.sheet("10", "ten.dcf")
        said = self.assert_done(run("configure", BUS, "20", self.path("ten.dcf")))
        self.assertIn("the file is of node 10 (0Ah)", said)
        one, other = self.sheet("10", "ten.dcf"), self.sheet("20", "twenty.dcf")
        different = {
            name
            for name in one
            if one[name].get("ParameterValue") != other[name].get("ParameterValue") and one[name].get("PDOMapping") != "1"
        }
        # CAN-IDs that go with the node-ID: emergency, two RPDOs and two TPDOs (the third is the same number for both).
        moved = {"1014", "1400sub1", "1401sub1", "1402sub1", "1800sub1", "1801sub1", "1200sub1", "1200sub2"}
        self.assertLessEqual(different, moved | {"6051", "6050", "6053"})
        self.assertEqual(int(other["1014"]["ParameterValue"], 16), 0x80 + 20)
        self.assertEqual(int(other["1802sub1"]["ParameterValue"], 16), 0x381)
        self.assertEqual(int(other["1802sub5"]["ParameterValue"], 16), 200)
        self.assertEqual(int(other["1017"]["ParameterValue"], 16), 700)
        self.assertEqual(int(other["1016sub1"]["ParameterValue"], 16), 0x000501F4)

    def test_a_stand_in_made_of_the_dcf_has_the_same_dcf(self):
        self.sheet("10", "ten.dcf")
        self.start(self.path("ten.dcf"), "30")
        self.sheet("30", "thirty.dcf")
        said = run("eds", "diff", self.path("ten.dcf"), self.path("thirty.dcf")).stdout
        places = {line.split("]")[0].strip("[") for line in said.splitlines()}
        # The battery's own values go on, its stand-in's do not.
        self.assertLessEqual(places, {"DeviceComissioning", "6000", "6010", "6060", "6070", "6081", "1F80"}, said)

    def test_the_dcf_becomes_a_concise_dcf(self):
        self.sheet("20", "twenty.dcf")
        self.assert_done(run("eds", "convert", self.path("twenty.dcf"), self.path("twenty.cdcf")))
        direct = self.assert_done(run("configure", BUS, "20", self.path("twenty.dcf"), "--check"))
        concise = self.assert_done(run("configure", BUS, "20", self.path("twenty.cdcf"), "--check"))
        self.assertEqual(direct.splitlines()[1:], concise.splitlines(), "after the line on process data")

    def test_the_domains_of_a_node_become_files_beside_its_dcf(self):
        self.assert_done(run("eds", "export", "battery", "--out", self.path("battery.eds")))
        with open(self.path("battery.eds"), "a") as sheet:
            sheet.write(STORED_EDS)
        self.start(self.path("battery.eds"), "40")
        sheet = self.sheet("40", "forty.dcf", "--domains", str(self.folder))
        stored = sheet["1021"]["UploadFile"]
        self.assertEqual(stored, self.path("1021sub0.bin"))
        self.assertIn("ParameterName=Device type", pathlib.Path(stored).read_text())
        self.assertNotIn("UploadFile", self.sheet("40", "plain.dcf")["1021"])

    def test_it_is_told_as_json(self):
        self.assert_done(run("eds", "export", "charger", "--out", self.path("charger.eds")))
        result = run("eds", "read", BUS, "10", "--eds", self.path("charger.eds"), "--out", self.path("ten.dcf"), "--json")
        *unread, written = self.assert_told(result)
        # A battery is no client of SDO (06020000h: there is no such object).
        lacking = next(line for line in unread if line["index"] == "1280" and line["sub"] == "01")
        self.assertEqual(lacking, {"event": "unread", "node": 10, "index": "1280", "sub": "01", "name": lacking["name"], "text": "06020000h: the object does not exist in the dictionary"})
        self.assertEqual((written["event"], written["file"], written["unread"]), ("written", self.path("ten.dcf"), len(unread)))
        self.assertGreater(written["entries"], 10)

    def test_what_cannot_be_read_is_told_in_words(self):
        self.assert_done(run("eds", "export", "charger", "--out", self.path("charger.eds")))
        result = run("eds", "read", BUS, "10", "--eds", self.path("charger.eds"), "--out", self.path("ten.dcf"))
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"1280h:01h [^\n]*: 06020000h: the object does not exist")
        self.assertRegex(result.stdout, r"\d+ entries read, \d+ not, written to")

    def test_the_lines_of_a_refusal_make_an_eds_of_a_node_with_an_object_of_its_own(self):
        self.assert_done(run("eds", "export", "battery", "--out", self.path("own.eds")))
        with open(self.path("own.eds"), "a") as sheet:
            sheet.write(OWN_OBJECT)
        self.start(self.path("own.eds"), "50")
        told = run("clone", BUS, "50", "--ask", "2000-200F", "--out", self.path("made.eds")).stderr
        lines = [part.split(" leaves")[0].replace(";", "").split() for part in told.split("canvoy ")[1:]]
        self.assertEqual([line[0] for line in lines], ["clone", "eds"], told)
        self.assert_done(run(*lines[0][:3], "--ask", "2000-200F", *lines[0][3:]))
        said = self.assert_done(run(*lines[1]))
        self.assertRegex(said, r"\A\S+ does not hold ParameterValue of \d+ entries\n\Z")
        made = configparser.ConfigParser(interpolation=None)
        made.read(self.path("made.eds"))
        self.assertEqual(made["2000"]["DataType"], "0x0006", "by its length of two bytes")
        self.assertNotIn("ParameterValue", made["2000"])

    def test_what_is_not_there_leaves_no_file(self):
        missing = run("eds", "read", BUS, "99", "--out", self.path("no.dcf"), "--timeout", "100ms")
        self.assert_refused(missing, FAILED, "node 99", "no answer")
        self.assert_refused(run("eds", "read", BUS, "10", "--out", self.path("no.txt")), USAGE, ".dcf")
        for verb in (("eds", "read"), ("clone",)):
            line = f"canvoy {' '.join(verb)} {BUS} 10 --out {self.path('no.dcf')}"
            self.assert_refused(run(*verb, BUS, "10", "--out", self.path("no.eds")), USAGE, "an EDS holds no values", line)
        self.assert_refused(run("eds", "read", BUS, "10", "--out", self.path("no.xdd")), USAGE, "no.xdc")
        self.assert_refused(run("eds", "read", BUS, "200"), USAGE, "200")
        self.assert_refused(run("eds", "read", BUS, "10", "--domains", self.path("no")), USAGE, "no folder")
        self.assert_refused(run("eds", "read", BUS, "10", "--eds", self.path("no.eds")), FAILED, "no.eds")
        self.assert_refused(run("eds", "read", BUS, "10", "--profile", "1"), USAGE, "'1'")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_dcf_without_values_configures_nothing(self):
        self.assert_done(run("eds", "export", "battery", "--out", self.path("battery.eds")))
        self.assert_refused(run("configure", BUS, "10", self.path("battery.eds")), FAILED, "ParameterValue")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
