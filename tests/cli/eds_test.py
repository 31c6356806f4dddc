#!/usr/bin/env python3
"""canvoy eds, from outside. What is expected is typed from CiA 306, and from CiA 407 and 419."""

import configparser
import json
import pathlib
import tempfile
import unittest

from command import FAILED, USAGE, CommandTest, run


class EdsTest(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def export(self, name, *arguments):
        self.assert_done(run("eds", "export", *arguments, "--out", self.path(name)))
        sheet = configparser.ConfigParser(interpolation=None)
        sheet.read(self.path(name))
        return sheet

    def test_exports_a_device_that_the_project_builds(self):
        sheet = self.export("charger.eds", "charger")
        self.assertEqual(sheet["1000"]["DefaultValue"], "0x000001A3")
        self.assertEqual(sheet["6010"]["DataType"], "0x0003")
        self.assertEqual(sheet["6010"]["PDOMapping"], "1")
        self.assertIn("0 errors, 0 warnings", self.assert_done(run("eds", "check", self.path("charger.eds"), "--profile", "419")))

    def test_exports_devices_of_a_lift_that_the_project_builds(self):
        kinds = {"lift-controller": 0, "lift-car-panel": 0, "lift-landing-panel": 0, "lift-call-controller": 1,
                 "lift-input-panel": 2, "lift-output-panel": 3, "lift-door-controller": 4, "lift-door": 5,
                 "lift-position": 6, "lift-light-barrier": 7, "lift-drive-controller": 8, "lift-drive": 9, "lift-load": 10,
                 "lift-sensors": 11}
        for kind, code in kinds.items():
            sheet = self.export(f"{kind}.eds", kind)
            self.assertEqual(sheet["1000"]["DefaultValue"], f"0x{code:02X}0001A1")
            checked = self.assert_done(run("eds", "check", self.path(f"{kind}.eds"), "--profile", "417-4"))
            self.assertIn("0 errors, 0 warnings", checked, kind)
        sheet = self.export("door.eds", "lift-door")
        self.assertEqual(sheet["1508sub1"]["DefaultValue"], "0x00000200")
        self.assertEqual(sheet["6304subB"]["ParameterName"], "Lost of heartbeat")
        sheet = self.export("panel.eds", "lift-landing-panel")
        self.assertEqual(sheet["6000sub1"]["DefaultValue"], "0x0200", "input panel unit")
        self.assertEqual(sheet["6000sub2"]["DefaultValue"], "0x0300", "output panel unit")
        self.assertEqual(sheet["1881sub1"]["DefaultValue"], "$NODEID+0x480")
        self.assertEqual(sheet["1500sub1"]["DefaultValue"], "0x00000400")

    def test_exports_a_dcf_with_the_values_of_a_node(self):
        sheet = self.export("battery.dcf", "battery", "--node-id", "5")
        self.assertEqual(sheet["DeviceComissioning"]["NodeID"], "5")
        self.assertEqual(sheet["1000"]["ParameterValue"], "0x000001A2")

    def test_texts_of_a_sheet_do_not_command_the_terminal(self):
        sheet = "[1000]\nParameterName=Type {0}\nObjectType=0x7\nDataType=0x0007\nAccessType={0}\n"
        one, other = self.path("one.eds"), self.path("other.eds")
        pathlib.Path(one).write_text(sheet.format("\x1b[2J"))
        pathlib.Path(other).write_text(sheet.format("\x1b]0;x\x07"))
        for command in (("diff", one, other), ("check", one), ("convert", one, self.path("one.xdd"))):
            result = run("eds", *command)
            self.assertNotIn("\x1b", result.stdout + result.stderr, command)
            self.assertIn("\\x1B[2J", result.stdout, command)

    def test_a_sheet_agrees_with_itself(self):
        for kind, lss, granularity, product in (("charger", "1", "0", 419), ("bootloader", "0", "0", 302), ("lift-door", "1", "1", 41705)):
            device = self.export("a.eds", kind)["DeviceInfo"]
            self.assertEqual(device["LSS_Supported"], lss, kind)
            self.assertEqual(device["Granularity"], granularity, kind)
            self.assertEqual(int(device["ProductNumber"], 16), product, kind)
            self.assertTrue(pathlib.Path(self.path("a.eds")).read_bytes().isascii(), kind)
        drive = self.export("drive.eds", "lift-drive")
        self.assertIn("Ti - integration time constant", [section.get("ParameterName") for section in drive.values()])
        text = pathlib.Path(self.path("a.eds")).read_text().replace("LSS_Supported=1", "LSS_Supported=1\nVendorNumber=7")
        wrong = text.replace("ProductNumber=0x0000A2E9", "ProductNumber=0").replace("[1018sub4]", "[2018]")
        checked = run("eds", "check", self.path("wrong.eds") if pathlib.Path(self.path("wrong.eds")).write_text(wrong) else "")
        self.assertIn("ProductNumber is 0; expected: 0x0000A2E9, as 1018sub2 has", checked.stdout)
        self.assertIn("LSS_Supported is 1; expected: 0, or 1018sub4", checked.stdout)

    def test_parameters_of_pdos_of_the_old_cia_301_are_no_news(self):
        old = "[1800]\nParameterName=TPDO\nObjectType=0x9\nSubNumber=2\n[1800sub0]\nParameterName=count\nDataType=5\nAccessType=ro\nDefaultValue=4\n"
        old += "[1800sub4]\nParameterName=Compatibility entry\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nDefaultValue=0\n"
        pathlib.Path(self.path("old.eds")).write_text(old)
        checked = run("eds", "check", self.path("old.eds")).stdout
        self.assertNotIn("1800sub4", checked)
        self.assertIn("1000", checked, "what is missing is")

    def test_exports_a_virtual_device_of_a_class(self):
        sheet = self.export("indicator.eds", "407", "--device", "03", "--class", "1", "--subclass", "2")
        self.assertIn("6191", sheet, "destination_number is mandatory in 1.2 (CiA 407, 6.4)")
        self.assertNotIn("6109", sheet, "stop_point_ID is in none of 1.1 to 1.3")
        self.assertIn("0 errors", self.assert_done(run("eds", "check", self.path("indicator.eds"), "--profile", "407")))

    def test_a_device_of_a_profile_that_is_built_on_another_says_what_it_is(self):
        joystick = int(self.export("joystick.eds", "852", "--device", "joystick")["1000"]["DefaultValue"], 16)
        self.assertEqual(joystick, 0x81840191, "1XXX XXX1b, 1b, X1X0b, 0191h (CiA 852, Table 8)")
        self.assertEqual(int(self.export("all.eds", "852")["1000"]["DefaultValue"], 16) & 0xFFFF, 401)

    def test_adds_chosen_objects(self):
        sheet = self.export("own.eds", "419", "--objects", "6060,6070-6081")
        for index in ["6060", "6070", "6080", "6081"]:
            self.assertIn(index, sheet)
        self.assertNotIn("6052", sheet)

    def test_exports_every_virtual_device_without_a_fault(self):
        for profile in ["407", "417-4", "447-3", "852"]:
            lines = [json.loads(line) for line in self.assert_done(run("profile", profile, "--json")).splitlines()]
            devices = {(line["device"], line["class"], line["subclass"]) for line in lines if line["kind"] == "device"}
            self.assertTrue(devices)
            for name, device_class, subclass in devices:
                chosen = ["--device", name, "--class", str(device_class), "--subclass", str(subclass), "--optional"]
                self.assert_done(run("eds", "export", profile, *chosen, "--out", self.path("device.eds")))
                checked = run("eds", "check", self.path("device.eds"), "--profile", profile).stdout
                self.assertIn("0 errors, 0 warnings", checked, chosen)

    def test_exports_another_reading_of_a_profile(self):
        usual = self.export("usual.eds", "852", "--objects", "6411")
        other = self.export("other.eds", "852", "--objects", "6411", "--reading", "wide-displays")
        self.assertIn("6411sub13", usual, "parameter 7 of display 2: 12 + 7")
        self.assertNotIn("6411sub13", other, "it is at 24 + 7 (CiA 852, 9, errata 5)")

    def test_converts_to_xml_and_back_and_compares(self):
        self.export("charger.eds", "charger")
        lost = self.assert_done(run("eds", "convert", self.path("charger.eds"), self.path("charger.xdd")))
        self.assertEqual(lost, "")
        self.assert_done(run("eds", "convert", self.path("charger.xdd"), self.path("again.eds")))
        compared = run("eds", "diff", self.path("charger.eds"), self.path("again.eds"))
        self.assertEqual(self.assert_done(compared), "", "the revision is kept as well")
        self.assertEqual(self.assert_done(run("eds", "diff", self.path("charger.eds"), self.path("charger.eds"))), "")

    def test_what_is_written_found_and_different_is_told_as_json(self):
        first, second, bad = self.path("first.eds"), self.path("second.eds"), self.path("bad.eds")
        (told,) = self.assert_told(run("eds", "export", "charger", "--out", first, "--json"))
        sheet = configparser.ConfigParser(interpolation=None)
        sheet.read(first)
        counted = sum(int(sheet[part]["SupportedObjects"]) for part in ("MandatoryObjects", "OptionalObjects", "ManufacturerObjects"))
        self.assertEqual(told, {"event": "written", "file": first, "objects": counted})
        self.assert_refused(run("eds", "export", "charger", "--json"), USAGE, "--out")
        text = pathlib.Path(first).read_text()
        pathlib.Path(second).write_text(text.replace("ParameterName=Producer heartbeat time", "ParameterName=beat"))
        compared = run("eds", "diff", first, second, "--json")
        self.assertEqual([json.loads(line) for line in compared.stdout.splitlines()],
                         [{"event": "difference", "place": "1017", "key": "ParameterName", "first": "Producer heartbeat time", "second": "beat"}])
        self.assertEqual(compared.returncode, FAILED)
        pathlib.Path(bad).write_text(text.replace("[1017]", "[1017x]"))
        lines = [json.loads(line) for line in run("eds", "check", bad, "--json").stdout.splitlines()]
        self.assertTrue(lines[:-1])
        for line in lines[:-1]:
            self.assertEqual((line["event"], line["file"]), ("finding", bad))
            self.assertIn(line["weight"], ("error", "warning"))
            self.assertTrue(line["text"])
        self.assertEqual(lines[-1]["errors"] + lines[-1]["warnings"], len(lines) - 1)
        *lost, written = self.assert_told(run("eds", "convert", first, self.path("first.xdd"), "--json"))
        self.assertEqual({line["event"] for line in lost} | {written["event"]}, {"lost", "written"} if lost else {"written"})

    def test_tells_line_section_fault_and_what_is_right(self):
        self.export("charger.eds", "charger")
        path = self.folder / "charger.eds"
        text = path.read_text().replace("[6000]\nParameterName=battery_status\nObjectType=0x7\nDataType=0x0005",
                                        "[6000]\nParameterName=battery_status\nObjectType=0x7\nDataType=0x0006")
        path.write_text(text)
        line = text.splitlines().index("[6000]") + 1
        checked = run("eds", "check", str(path), "--profile", "419")
        self.assertEqual(checked.returncode, FAILED)
        self.assertIn(f"{path}:{line}: [6000] DataType is 0x0006; expected: 0x0005 UNSIGNED8\n", checked.stdout)

    def test_refuses_what_there_is_not(self):
        missing = self.path("missing.eds")
        self.assert_refused(run("eds", "check", missing), FAILED, missing)
        (self.folder / "empty.eds").write_text("")
        self.assert_refused(run("eds", "check", self.path("empty.eds")), FAILED, "empty.eds", "no object")
        self.assert_refused(run("eds", "export", "boat"), USAGE, "'boat'")
        self.assert_refused(run("eds", "export", "407", "--device", "77"), USAGE, "'77'", "canvoy profile 407")
        self.assert_refused(run("eds", "export", "407", "--device", "03", "--class", "9"), USAGE, "--class 1")
        self.assert_refused(run("eds", "export", "419", "--objects", "9999"), USAGE, "9999")
        self.assert_refused(run("eds", "export", "419", "--class", "1"), USAGE, "--device")
        self.assert_refused(run("eds", "export", "charger", "--out", self.path("charger.txt")), USAGE, ".eds")
        self.assertFalse((self.folder / "charger.txt").exists())


if __name__ == "__main__":
    unittest.main()
