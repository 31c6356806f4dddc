#!/usr/bin/env python3
"""canvoy scan and clone: who is on a bus; a device that nobody describes gets a stand-in that answers as it did."""

import configparser
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.14:43119"


def entry(place, data_type, value, name="an entry", access="rw"):
    return f"[{place}]\nParameterName={name}\nDataType={data_type}\nAccessType={access}\nDefaultValue={value}\n"


# Of a profile that nobody here knows (CiA 999), with objects of its maker.
UNKNOWN = (
    "[DeviceInfo]\nProductName=Pump\n"
    + entry("1000", 7, "0x000003E7", access="ro")
    + entry("1001", 5, 0, access="ro")
    + entry("1017", 6, 0)
    + "[1018]\nParameterName=Identity\nObjectType=9\nSubNumber=3\n"
    + entry("1018sub0", 5, 2, access="ro")
    + entry("1018sub1", 7, "0x2F0", access="ro")
    + entry("1018sub2", 7, "0x77", access="ro")
    + entry("2000", 6, "0x1234")
    + entry("2001", 9, "pump house")
    + entry("2003", 5, 200)
    + "[2004]\nParameterName=Levels\nObjectType=8\nSubNumber=3\n"
    + entry("2004sub0", 5, 2, access="ro")
    + entry("2004sub1", 7, 100000)
    + entry("2004sub2", 7, 7)
    + entry("6123", 7, "0xCAFE0001")
)


class SlowNode:
    """Node 45, which takes its time to say what it is, and says nothing else; until the end of a with statement."""

    BUS = "udp:239.74.163.16:43119"
    DELAY_S = 0.5

    def __enter__(self):
        self.asked = []  # when, by whose CAN-ID, for their device types
        self.hears = False
        self.bus = subprocess.Popen([CANVOY, "monitor", self.BUS, "--filter", "id=600..67F", "--json"], stdout=subprocess.PIPE, text=True)
        self.thread = threading.Thread(target=self.answer)
        self.thread.start()
        while not self.hears:
            run("send", self.BUS, "67F#00")
        return self

    def __exit__(self, *_):
        self.bus.terminate()
        self.thread.join()
        self.bus.communicate(timeout=60)

    def answer(self):
        for line in self.bus.stdout:
            told = json.loads(line)
            self.hears = True
            can_id, data = told["frame"].split("#")
            if data == "4000100000000000":  # CiA 301, 7.2.4.3.5: an upload of 1000h
                self.asked.append((told["time"], can_id))
            if (can_id, data) == ("62D", "4000100000000000"):
                threading.Timer(self.DELAY_S, run, ("send", self.BUS, "5AD#43001000E7030000")).start()


class Scan(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        sheet = cls.folder / "pump.eds"
        sheet.write_text(UNKNOWN)
        cls.start("battery", "10")
        cls.start(str(sheet), "33")

    @classmethod
    def start(cls, kind, node):
        device = subprocess.Popen([CANVOY, "device", kind, BUS, "--node-id", node], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(200):
            if run("read", BUS, node, "1000").returncode == DONE:
                return device
            time.sleep(0.1)
        raise AssertionError(f"node {node} does not come up")

    def test_all_who_are_there_are_told_with_their_identities(self):
        lines = [json.loads(line) for line in self.assert_done(run("scan", BUS, "--json")).splitlines()]
        self.assertEqual(lines[-1], {"nodes": 2, "unconfigured": False})
        battery, pump = lines[:-1]
        self.assertEqual((battery["node"], battery["profile"], battery["heard"], battery["answers"]), (10, "418", True, True))
        self.assertEqual((pump["node"], pump["profile"], pump["device_type"]), (33, "999", "000003E7"))
        self.assertEqual((pump["vendor_id"], pump["product_code"]), ("000002F0", "00000077"))
        self.assertNotIn("serial_number", pump, "it has none")
        text = self.assert_done(run("scan", BUS, "--no-lss"))
        self.assertRegex(text, r"(?m)^10 +[a-z-]+ +[0-9A-F]{8} +418 ")
        self.assertIn("2 nodes\n", text)

    def test_all_are_asked_while_it_listens_and_a_slow_node_is_waited_for(self):
        with SlowNode() as node:
            lines = [json.loads(line) for line in self.assert_done(run("scan", node.BUS, "--json")).splitlines()]
        asked = node.asked
        self.assertEqual([(line["node"], line["device_type"], line["heard"], line["answers"]) for line in lines[:-1]], [(45, "000003E7", False, True)])
        self.assertEqual([can_id for _, can_id in asked], [f"{0x600 + node:03X}" for node in range(1, 128)])
        self.assertLess(asked[-1][0] - asked[0][0], 10, "seconds from the first question to the last: nobody is waited for between them")

    def test_devices_without_a_node_id_are_told(self):
        bus = "udp:239.74.163.17:43119"
        battery = subprocess.Popen([CANVOY, "device", "battery", bus, "--node-id", "lss"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(battery.communicate)
        self.addCleanup(battery.terminate)
        for line in battery.stdout:
            if "waits for a node-ID by LSS" in line:
                break
        self.assertIn("there are devices without a node-ID", self.assert_done(run("scan", bus, "--timeout", "1s")))
        unasked = run("scan", bus, "--no-lss", "--json")
        self.assertEqual((json.loads(unasked.stdout), unasked.returncode), ({"nodes": 0, "unconfigured": False}, FAILED))

    def test_the_network_is_written_with_a_dcf_for_each_and_can_be_exported(self):
        network = self.folder / "network.toml"
        self.assert_done(run("scan", BUS, "--out", str(network)))
        sheet = configparser.ConfigParser(interpolation=None, strict=False)
        sheet.read(self.folder / "node10.dcf")
        self.assertEqual(sheet["1000"]["DefaultValue"], "0x000001A2")
        self.assertEqual(sheet["DeviceComissioning"]["NodeID"], "10")
        dbc = self.assert_done(run("export", "dbc", str(network), encoding="latin-1"))
        self.assertIn("BO_ 394 ", dbc)
        self.assertIn("BO_ 1825 ", dbc)

    def test_a_clone_answers_as_the_device_did(self):
        clone = str(self.folder / "clone.dcf")
        told = self.assert_done(run("clone", BUS, "33", "--ask", "2000-2010,6120-6130", "--out", clone))
        self.assertIn("5 that nobody does", told)
        stand_in = self.start(clone, "34")
        for place, kind in (("1000", "u32"), ("1018:1", "u32"), ("2000", "u16"), ("2001", "vs"), ("2003", "u8"), ("2004:0", "u8"),
                            ("2004:1", "u32"), ("2004:2", "u32"), ("6123", "u32")):
            there, here = (self.assert_done(run("read", BUS, node, place, "--type", kind)) for node in ("33", "34"))
            self.assertEqual(here, there, place)
        self.assert_refused(run("read", BUS, "34", "2002"), FAILED, "06020000h")
        self.assert_refused(run("read", BUS, "34", "2004:3"), FAILED, "06090011h")
        stand_in.terminate()
        stand_in.wait()

    def test_what_makes_no_sense_is_refused(self):
        self.assert_refused(run("scan", "sim"), USAGE, "sim")
        self.assert_refused(run("scan", BUS, "--out", "network.txt"), USAGE, ".toml")
        self.assert_refused(run("scan", BUS, "--listen", "soon"), USAGE, "soon")
        self.assert_refused(run("clone", BUS, "33", "--ask", "20"), USAGE, "'20'")
        self.assert_refused(run("clone", BUS, "33", "--ask", "3000-2000"), USAGE, "3000-2000")
        self.assert_refused(run("clone", BUS, "33", "--out", "x.eds"), USAGE, ".dcf")
        self.assert_refused(run("clone", BUS, "99", "--timeout", "50ms"), FAILED, "node 99")
        empty = run("scan", "udp:239.74.163.15:43119", "--listen", "100ms", "--timeout", "10ms")
        self.assertEqual((empty.stdout, empty.returncode), ("0 nodes\n", FAILED))


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
