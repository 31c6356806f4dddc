#!/usr/bin/env python3
"""canvoy read and write with nodes that do not say what they are, and of types that nobody describes."""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run
from xdd_test import EDITOR

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.11:43119"


def entry(place, data_type, value, access="rw"):
    return f"[{place}]\nParameterName=an entry\nDataType={data_type}\nAccessType={access}\nDefaultValue={value}\n"


# Without a device type (1000h), and with a text that would clear a terminal.
SHEET = (
    entry("1001", 5, 0, "ro")
    + entry("1017", 6, 0)
    + entry("2000", 6, "0x1234")
    + entry("2001", 8, "1.5")
    + entry("2002", 9, "a\x1b[2Jb")
    + entry("2003", 9, "Pr\udcfcfer")
    + entry("6010", 3, -2)
)


OWN_SHEET = """[2000]
ParameterName=Pump speed
DataType=6
AccessType=rw
DefaultValue=100
[2010]
ParameterName=Motor
ObjectType=9
SubNumber=2
[2010sub0]
ParameterName=Entries
DataType=5
AccessType=ro
DefaultValue=1
[2010sub1]
ParameterName=Current
DataType=3
AccessType=ro
DefaultValue=-7
"""


class ReadWrite(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        sheet = cls.folder / "untold.eds"
        sheet.write_bytes(SHEET.encode(errors="surrogateescape"))
        cls.start(sheet, "9", "1001")

    @classmethod
    def start(cls, sheet, node, wanted):
        device = subprocess.Popen(
            [CANVOY, "device", str(sheet), BUS, "--node-id", node], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(200):
            if run("read", BUS, node, wanted).returncode == DONE:
                return
            time.sleep(0.1)
        raise AssertionError(f"node {node} does not come up")

    def read(self, *arguments):
        return self.assert_done(run("read", BUS, "9", *arguments)).rstrip("\n")

    def test_an_index_can_be_read_where_the_device_type_cannot(self):
        self.assertEqual(self.read("6010"), "FE FF")
        self.assertEqual(self.read("6010", "--type", "i16"), "-2")
        self.assertEqual(self.read("6010", "--profile", "419"), "-0.250 °C")
        self.assert_refused(run("read", BUS, "9", "battery_temperature"), FAILED, "1000h:00h", "06020000h", "--profile")
        self.assertEqual(self.read("battery_temperature", "--profile", "419"), "-0.250 °C")

    def test_a_value_can_be_written_where_the_device_type_cannot_be_read(self):
        self.assert_refused(run("write", BUS, "9", "6010", "5"), USAGE, "6010h:00h", "--type")
        self.assert_done(run("write", BUS, "9", "6010", "5", "--type", "i16"))
        self.assertEqual(self.read("6010", "--type", "i16"), "5")
        self.assert_done(run("write", BUS, "9", "6010", "hex:FE FF"))

    def test_the_data_sheet_of_a_node_has_names_and_types_of_its_own(self):
        sheet = self.folder / "own.eds"
        sheet.write_text(OWN_SHEET)
        self.start(sheet, "31", "2000")

        def done(verb, *arguments):
            return self.assert_done(run(verb, BUS, "31", *arguments, "--eds", sheet)).rstrip("\n")

        self.assertEqual(done("read", "pump_speed"), "100")
        self.assertEqual(done("read", "Motor:Current"), "-7")
        self.assertEqual(done("write", "2000", "250"), "Pump speed: 100 -> 250")
        self.assertIn("PASS node 31 (1Fh): Pump speed = 250", done("expect", "pump_speed = 250"))
        self.assert_refused(run("write", BUS, "31", "pump_speed", "65536", "--eds", sheet), USAGE, "65535")
        self.assert_refused(run("read", BUS, "31", "pump_sped", "--eds", sheet), USAGE, "the data sheet", "did you mean 'Pump speed'?")
        self.assert_refused(run("read", BUS, "31", "2000", "--eds", sheet, "--profile", "419"), USAGE, "--profile", "--eds")
        self.assert_refused(run("read", BUS, "31", "2000", "--eds", self.folder / "none.eds"), FAILED, "none.eds")
        script = run("script", BUS, "-", input=f"expect 31 Motor:Current = -7 --eds {sheet}\n")
        self.assertIn("1 of 1 lines passed", self.assert_done(script))

    def test_a_value_is_read_as_the_type_that_is_said(self):
        self.assertEqual(self.read("2000", "--type", "u16"), "4660")
        self.assertEqual(self.read("2001", "--type", "r32"), "1.5")
        self.assertEqual(json.loads(self.read("2000", "--type", "u16", "--json")), {"node": 9, "index": "2000", "sub": "00", "raw": "3412", "value": 4660})
        self.assert_refused(run("read", BUS, "9", "2000", "--type", "u17"), USAGE, "'u17'", "u8 to u64")
        self.assert_refused(run("read", BUS, "9", "2000", "--type", "u32"), FAILED, "2 bytes", "u32 has 4", "34 12")
        self.assert_refused(run("read", BUS, "9", "2000", "--type", "u16", "--out", str(self.folder / "x")), USAGE, "--type")

    def test_numbers_beyond_the_type_are_not_written(self):
        for value, kind in (("1e39", "r32"), ("-1e39", "r32"), ("1e309", "r64"), ("65536", "u16"), ("-18446744073709551615", "u64"),
                            ("-18446744073709551615", "u16"), ("18446744073709551615", "i16")):  # fmt: skip
            self.assert_refused(run("write", BUS, "9", "2001", "--type", kind, "--", value), USAGE, value)
        self.assertEqual(self.read("2001", "--type", "r32"), "1.5")

    def test_texts_of_a_node_do_not_command_the_terminal(self):
        self.assertEqual(self.read("2002", "--type", "vs"), '"a\\x1B[2Jb"')
        self.assertEqual(self.read("2003", "--type", "vs"), '"Prüfer"')
        self.assertEqual(json.loads(self.read("2003", "--type", "vs", "--json"))["value"], "Prüfer")

    def test_a_load_is_in_the_unit_that_the_node_tells(self):  # CiA 417-4, 4.12.1 to 4.12.3
        sheet = self.folder / "load.eds"
        sheet.write_text(
            entry("1000", 7, "0x1A1", "ro")
            + entry("1001", 5, 0, "ro")
            + "[6480]\nParameterName=Load value\nObjectType=8\nSubNumber=3\n"
            + entry("6480sub0", 5, 2, "ro")
            + entry("6480sub1", 6, 450)
            + entry("6480sub2", 6, 2)
        )
        self.start(sheet, "13", "1001")

        def read(*arguments):
            return self.assert_done(run("read", BUS, "13", "6480:1", *arguments)).rstrip("\n")

        self.assertEqual(read(), "450 kg")
        self.assert_done(run("write", BUS, "13", "6480:2", "0xFD02", "--type", "u16"))  # milli, kilogram
        self.assertEqual(read(), "0.450 kg")
        self.assertEqual(json.loads(read("--json"))["unit"], "kg")
        self.assertEqual(read("--type", "u16"), "450")
        self.assert_done(run("write", BUS, "13", "6480:1", "2 kg"))
        self.assertEqual(read("--type", "u16"), "2000")
        self.assert_done(run("write", BUS, "13", "6480:2", "0x0021", "--type", "u16"))  # newton
        self.assertEqual(read(), "2000 N")
        self.assert_refused(run("write", BUS, "13", "6480:1", "5 kg"), USAGE, "a number in N")
        self.assert_done(run("write", BUS, "13", "6480:2", "0x00EE", "--type", "u16"))  # nobody knows it
        self.assertEqual(read(), "2000")
        self.assertNotIn("unit", json.loads(read("--json")))

    def test_a_load_is_in_kilograms_where_the_node_tells_no_unit(self):  # CiA 417-4, 4.12.1
        sheet = self.folder / "kilograms.eds"
        sheet.write_text(
            entry("1000", 7, "0x1A1", "ro")
            + entry("1001", 5, 0, "ro")
            + "[6480]\nParameterName=Load value\nObjectType=8\nSubNumber=2\n"
            + entry("6480sub0", 5, 1, "ro")
            + entry("6480sub1", 6, 450)
        )
        self.start(sheet, "14", "1001")
        self.assertEqual(self.assert_done(run("read", BUS, "14", "absolute_load_value")), "450 kg\n")

    def test_a_cabin_is_no_plain_input_device(self):  # CiA 852, 11.2: the number of CiA 401, and bits of its own
        sheet = self.folder / "cabin.eds"
        sheet.write_text(
            entry("1000", 7, "0x81840191", "ro")
            + entry("1001", 5, 0, "ro")
            + "[6401]\nParameterName=Read analogue input 16-bit\nObjectType=8\nSubNumber=2\n"
            + entry("6401sub0", 5, 1, "ro")
            + entry("6401sub1", 3, 100, "ro")
        )
        self.start(sheet, "15", "1001")
        read = self.assert_done(run("read", BUS, "15", "6401:1", "--json"))
        self.assertIn("Joystick", json.loads(read)["name"])

    def test_a_file_of_an_editor_is_a_device(self):
        sheet = self.folder / "editor.xpd"
        sheet.write_text(EDITOR)
        self.start(sheet, "12", "1001")
        self.assertEqual(self.assert_done(run("read", BUS, "12", "1014", "--type", "u32")), "140\n", "0x80+$NODEID")
        self.assert_done(run("write", BUS, "12", "1017", "500", "--type", "u16"))


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
