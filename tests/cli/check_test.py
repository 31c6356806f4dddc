#!/usr/bin/env python3
"""canvoy check: a device of ours on a bus, its reports, and how it ends. Which case finds what is tried at exact times by the unit
tests of canvoy/text/check."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network
from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

BUS = "udp:239.74.163.2:43113"
NOT_CONFORMING = 4


class Check(CommandTest):
    @classmethod
    def setUpClass(cls):
        own_network.enter_or_skip()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.sheet = str(cls.folder / "battery.eds")
        assert run("eds", "export", "battery", "--out", cls.sheet).returncode == DONE
        device = subprocess.Popen([CANVOY, "device", "battery", BUS], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(200):
            if run("read", BUS, "10", "1000").returncode == DONE:
                return
            time.sleep(0.1)
        raise AssertionError("the battery does not come up")

    def path(self, name):
        return str(self.folder / name)

    def test_sdo_of_a_battery_passes_and_is_told_in_each_report(self):
        names = {name: self.path(f"check.{name}") for name in ("json", "junit", "html")}
        arguments = [word for name, path in names.items() for word in (f"--{name}", path)]
        done = run("check", BUS, "10", "--eds", self.sheet, "--only", "sdo", *arguments)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""), done.stdout)
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)
        self.assertRegex(done.stdout, r"(?m)^SDO +31 +0 +0$")
        lines = [json.loads(line) for line in pathlib.Path(names["json"]).read_text().splitlines()]
        self.assertEqual([line["verdict"] for line in lines[:-1]], 31 * ["PASS"])
        self.assertEqual((lines[-1]["node"], lines[-1]["device_type"], lines[-1]["failed"], lines[-1]["whole"]), (10, "000001A2", 0, True))
        suite = ElementTree.parse(names["junit"]).getroot()
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("skipped")), ("31", "0", "0"))
        page = pathlib.Path(names["html"]).read_text()
        self.assertEqual(len(re.findall(r'<tr id="sdo-\d\d" class="pass">', page)), 31)
        self.assertNotIn("<h2>Failed", page)
        self.assertNotIn("<script", page)

    def test_a_sheet_of_another_device_fails_with_frames(self):
        sheet = pathlib.Path(self.path("other.eds"))
        sheet.write_text(pathlib.Path(self.sheet).read_text().replace("0x000001A2", "0x000001A3"))
        report = self.path("other.json")
        done = run("check", BUS, "10", "--eds", str(sheet), "--only", "dictionary-07", "--json", report)
        self.assertEqual((done.returncode, done.stderr), (NOT_CONFORMING, ""), done.stdout)
        self.assertIn("1000h:00h is A2 01 00 00, and by the data sheet A3 01 00 00", " ".join(done.stdout.split()))
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)
        case = json.loads(pathlib.Path(report).read_text().splitlines()[0])
        self.assertEqual((case["case"], case["verdict"]), ("dictionary-07", "FAIL"))
        self.assertTrue(any("58A#43001000A2010000" in line for line in case["frames"]), case["frames"])

    def test_all_cases_are_listed_with_their_clauses(self):
        text = self.assert_done(run("check", "--list", "--profile", "418"))
        self.assertLessEqual(max(map(len, text.splitlines())), 80)
        path = self.path("list.json")
        self.assert_done(run("check", "--list", "--profile", "418", "--json", path))
        cases = [json.loads(line) for line in pathlib.Path(path).read_text().splitlines()]
        self.assertEqual(len(cases), len({case["case"] for case in cases}), "each has a name of its own")
        for case in cases:
            self.assertTrue(case["clause"].startswith("CiA ") and case["title"] and case["expects"], case)
            self.assertIn(case["case"], text)
        chosen = self.assert_done(run("check", "--list", "--only", "SYNC"))
        self.assertEqual(chosen.count("clause "), sum(case["class"] == "SYNC" for case in cases))

    def test_bad_input_is_refused_in_a_line(self):
        self.assert_refused(run("check"), USAGE, "BUS NODE")
        self.assert_refused(run("check", BUS), USAGE, "BUS NODE")
        self.assert_refused(run("check", BUS, "128"), USAGE, "128")
        self.assert_refused(run("check", "sim", "10"), USAGE, "sim")
        self.assert_refused(run("check", BUS, "10", "--eds", "none.eds"), FAILED, "none.eds")
        self.assert_refused(run("check", BUS, "10", "--profile", "999"), USAGE, "999")
        self.assert_refused(run("check", BUS, "10", "--only", "none"), USAGE, "none")
        self.assert_refused(run("check", "--list", "--only", "none"), USAGE, "none")
        # Before the test, which would be in vain.
        for report in ("--json", "--junit", "--html"):
            done = run("check", BUS, "10", "--only", "sdo-01", report, self.path("none/report"))
            self.assert_refused(done, FAILED, "none/report", "check the path")
        self.assert_refused(run("check", BUS, "10", "--hands", "/no/such/file"), FAILED, "/no/such/file", "check the path")
        hands = pathlib.Path(self.path("bad.txt"))
        for line, words in (("press it", "request = command"), ("= true", "request = command"), ("a = 1\na = 2", "already")):
            hands.write_text(line + "\n")
            self.assert_refused(run("check", BUS, "10", "--hands", str(hands)), FAILED, "bad.txt", words)
        self.assert_refused(run("check", BUS, "99", "--timeout", "200ms"), FAILED, "node 99", "no answer")


HANDS_BUS = "udp:239.74.163.2:43115"


class CheckHands(CommandTest):
    """A taxi alarm whose key is pressed by a command, and by a person: both write to the standard input of `canvoy device`."""

    @classmethod
    def setUpClass(cls):
        own_network.enter_or_skip()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.keys = cls.folder / "keys"
        os.mkfifo(cls.keys)
        # Both ends, so that it never is at its end.
        cls.input = os.open(cls.keys, os.O_RDWR)
        cls.addClassCleanup(os.close, cls.input)
        device = subprocess.Popen([CANVOY, "device", "taxi-alarm", HANDS_BUS, "--node-id", "9", "--stdin"], stdin=cls.input,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(200):
            if run("read", HANDS_BUS, "9", "1000").returncode == DONE:
                return
            time.sleep(0.1)
        raise AssertionError("the alarm does not come up")

    def verdict(self, *arguments, **options):
        report = self.folder / "report.json"
        done = run("check", HANDS_BUS, "9", "--only", "447-3-taxi-alarm-01", "--json", str(report), *arguments, **options)
        lines = [json.loads(line) for line in report.read_text().splitlines()]
        return done, lines[0]

    def hands(self, pressed):
        file = self.folder / "hands.txt"
        file.write_text(f"# who presses\npress the alarm key = echo {pressed} > {self.keys}\n"
                        f"let the alarm key go = echo alarm=released > {self.keys}\n")
        return str(file)

    def test_a_script_presses(self):
        done, case = self.verdict("--hands", self.hands("alarm=pressed"))
        self.assertEqual((done.returncode, case["verdict"]), (DONE, "PASS"), done.stdout)

    def test_a_key_that_is_pressed_and_not_told_fails(self):
        done, case = self.verdict("--hands", self.hands("alarm=released"))
        self.assertEqual((done.returncode, case["verdict"]), (NOT_CONFORMING, "FAIL"), done.stdout)

    def test_a_command_that_fails_says_nothing_of_the_device(self):
        file = self.folder / "broken.txt"
        file.write_text("press the alarm key = false\nlet the alarm key go = true\n")
        done, case = self.verdict("--hands", str(file))
        self.assertEqual((done.returncode, case["verdict"]), (DONE, "n/a"), done.stdout)

    def test_without_hands_it_does_not_apply(self):
        done, case = self.verdict()
        self.assertEqual((done.returncode, case["verdict"]), (DONE, "n/a"), done.stdout)
        self.assertIn("--hands", case["why"])

    def test_a_person_is_asked_at_the_terminal(self):
        done, case = self.verdict("--hands", "-", input="?\n")
        self.assertEqual((done.returncode, case["verdict"]), (DONE, "n/a"), done.stdout)
        self.assertIn("Please let the alarm key go, then Enter", done.stdout)


if __name__ == "__main__":
    unittest.main()
