#!/usr/bin/env python3
"""canvoy script: lines of the other verbs in one session, with expectations, judged by exit status, JSON and JUnit."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.22:43122"

GOOD = """\
# a battery comes up
nmt 10 reset-node
wait 'heartbeat and node=10 within 5s'
write 10 1017 100ms     # quicker
nmt 10 operational
expect 10 'temperature > -20degC' within 2s
expect 10 temperature in -20..60degC within 2s
send 123#DEADBEEF
"""


class Script(CommandTest):
    @classmethod
    def setUpClass(cls):
        battery = subprocess.Popen([CANVOY, "device", "battery", BUS, "--node-id", "10", "--heartbeat", "100ms"], stdout=subprocess.DEVNULL)
        cls.addClassCleanup(battery.wait)
        cls.addClassCleanup(battery.terminate)
        for _ in range(100):
            if run("read", BUS, "10", "1000", "--timeout", "200ms").returncode == DONE:
                return
        raise AssertionError("the battery does not come up")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def script(self, text, *options):
        path = self.folder / "test.canvoy"
        path.write_text(text)
        return run("script", BUS, str(path), *options)

    def test_all_lines_are_run_in_one_session(self):
        output = self.assert_done(self.script(GOOD))
        self.assertIn("  2  nmt 10 reset-node\nnode 10 (0Ah) has booted\n", output)
        self.assertIn("  4  write 10 1017 100ms     # quicker\nProducer heartbeat time: 100 ms -> 100 ms\n", output)
        self.assertTrue(output.endswith("  8  send 123#DEADBEEF\n7 of 7 lines passed\n"), output)

    def test_a_line_that_fails_ends_it(self):
        result = self.script("read 10 1017\nexpect 10 temperature < -20\nsync\n")
        self.assertEqual(result.returncode, FAILED)
        self.assertRegex(result.stdout, r"  2  expect 10 temperature < -20\n     FAIL node 10 \(0Ah\): temperature = .*expected")
        self.assertTrue(result.stdout.endswith("1 of 3 lines passed, 1 failed, 1 not run\n"), result.stdout)
        going = self.script("read 77 1017 --timeout 50ms\nsync\n", "--keep-going")
        self.assertTrue(going.stdout.endswith("1 of 2 lines passed, 1 failed\n"), going.stdout)
        self.assertEqual(going.returncode, FAILED)

    def test_a_report_is_as_junit_has_it(self):
        report = self.folder / "report.xml"
        self.assertEqual(self.script("sync\nexpect 10 temperature < -20\nsync\n", "--junit", str(report)).returncode, FAILED)
        suite = xml.etree.ElementTree.parse(report).getroot()
        self.assertEqual((suite.tag, suite.get("tests"), suite.get("failures"), suite.get("skipped")), ("testsuite", "3", "1", "1"))
        self.assertEqual([case.get("name") for case in suite],
                         ["line 1: sync", "line 2: expect 10 temperature < -20", "line 3: sync"])  # fmt: skip
        self.assertIn("expected", suite[1].find("failure").get("message"))

    def test_json_has_an_object_for_each_line_and_a_summary(self):
        lines = [json.loads(line) for line in self.assert_done(self.script("read 10 1017\nsync\n", "--json")).splitlines()]
        self.assertEqual([line.get("event") for line in lines], [None, "line", None, "line", "summary"])
        self.assertEqual((lines[0]["index"], lines[1]["passed"], lines[1]["text"]), ("1017", True, "read 10 1017"))
        self.assertEqual(lines[-1], {"event": "summary", "lines": 2, "passed": 2, "failed": 0, "skipped": 0})

    def test_lines_may_be_of_several_buses(self):
        other = "udp:239.74.163.22:43132"
        charger = subprocess.Popen([CANVOY, "device", "charger", other, "--node-id", "5", "--heartbeat", "100ms"], stdout=subprocess.DEVNULL)
        self.addCleanup(charger.wait)
        self.addCleanup(charger.terminate)
        for _ in range(100):
            if run("read", other, "5", "1000", "--timeout", "200ms").returncode == DONE:
                break
        path = self.folder / "both.canvoy"

        def script(text):
            path.write_text(text)
            return run("script", f"{BUS},{other}", str(path), "--json")

        lines = self.assert_told(script(
            f"read {BUS} 10 1000\nread {other} 5 1000\nwait 'heartbeat and node=5 within 5s'\nwait 'heartbeat and node=10 within 5s'\n"
            f"wait 'heartbeat and bus={other} within 5s'\nwait {BUS} 50ms\nwait 50ms\n"))  # fmt: skip
        self.assertEqual([line["raw"] for line in lines if "raw" in line], ["A2010000", "A3010000"], "CiA 418, CiA 419")
        heard = [(line["bus"], line["frame"][:3]) for line in lines if "frame" in line]
        self.assertEqual(heard, [(other, "705"), (BUS, "70A"), (other, "705")])
        self.assertEqual(lines[-1]["passed"], 7)
        self.assert_refused(script("read 10 1000\n"), USAGE, "line 1: on which bus? read udp")
        failed = script(f"wait {BUS} 'heartbeat and node=5 within 300ms'\n")
        self.assertIn("no frame passes", failed.stdout)
        self.assertEqual(failed.returncode, FAILED)
        both = run("wait", f"{BUS},{other}", "heartbeat and node=5 within 5s")
        self.assertIn(f"{other} 705#", self.assert_done(both))

    def test_a_difference_fails_its_line(self):
        (self.folder / "node10.txt").write_text("1017 0 u16 777\n")
        done = self.script(f"configure 10 {self.folder}/node10.txt --diff\nsync\n")
        self.assertIn("\nnode 10 (0Ah): 1 of 1 entry differs\n     FAIL: exit status 1\n0 of 2 lines passed, 1 failed, 1 not run\n", done.stdout)
        self.assertEqual(done.returncode, FAILED)

    def test_a_time_may_be_written_as_it_is_printed(self):
        done = self.script("wait 20 ms\nwait '20 ms'\nwait 0.02s\n")
        self.assertIn("3 of 3 lines passed", self.assert_done(done))

    def test_stdin_is_a_script_too(self):
        done = subprocess.run([CANVOY, "script", BUS, "-"], input="sync\n", capture_output=True, text=True, timeout=60)
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("  1  sync\n1 of 1 lines passed\n", "", DONE))

    def test_devices_of_a_script_are_moved_by_hand(self):
        bus = "udp:239.74.163.22:43152"
        path = self.folder / "hands.canvoy"
        path.write_text(
            "device battery --node-id 11 --heartbeat 100ms\n"
            "device io-401 --node-id 33 --heartbeat 100ms\n"
            "wait 'heartbeat and node=11 within 5s'\nwait 'heartbeat and node=33 within 5s'\n"
            "expect 11 temperature = 20 within 2s\n"
            "set temperature=60\nexpect 11 temperature = 60 within 2s\n"
            "set input3=on\nexpect 33 6000:1 = 4 within 2s\n"
            "press input1\nexpect 33 6000:1 = 5 within 2s\nexpect 33 6000:1 = 4 within 2s\n"
        )
        output = self.assert_done(run("script", bus, str(path)))
        self.assertIn("  6  set temperature=60\n  7  expect 11 temperature = 60 within 2s\nPASS", output)
        self.assertTrue(output.endswith("12 of 12 lines passed\n"), output)
        gone = run("read", bus, "11", "1000", "--timeout", "100ms")
        self.assertEqual(gone.returncode, FAILED, "they end with the script")

    def test_the_line_behind_a_device_finds_it(self):
        path = self.folder / "soon.canvoy"
        path.write_text("device battery --node-id 12\nread 12 temperature\ndevice charger battery\nread 5 1000\nread 10 1000\n")
        output = self.assert_done(run("script", "udp:239.74.163.22:43153", str(path)))
        self.assertTrue(output.endswith("5 of 5 lines passed\n"), output)

    def test_a_device_that_waits_for_a_node_id_is_there_at_once(self):
        lines = self.assert_told(self.script("device battery --node-id lss\ndevice charger battery --node-id lss --node-id 13\nread 13 1000\n", "--json"))
        lines = [each for each in lines if each.get("event") == "line"]
        self.assertEqual([each["passed"] for each in lines], [True] * 3)
        self.assertLess(lines[0]["duration_s"], 4, "it answers that it has none")
        self.assertLess(lines[1]["duration_s"], 4)

    def test_hands_that_no_device_has_are_refused_before_anything_is_done(self):
        for line, *parts in (
            ("set temperature=60", "line 1", "there is no device before this line"),
            ("device batery", "line 1", "did you mean 'battery'?"),
            ("device battery --node-id 200", "line 1", "200"),
            ("device battery --help", "line 1", "a line has no --help"),
            ("device battery -h", "line 1", "a line has no -h"),
            ("device battery --hands", "line 1", "a line has no --hands"),
            ("device --list", "line 1", "device is required"),
            ("device battery\nset temperature=hot", "line 2", "temperature"),
            ("device battery\nset colour=red", "line 2", "colour"),
            ("device battery\npress temperature", "line 2", "temperature"),
            ("device battery\nset", "line 2", "set NAME=VALUE"),
        ):
            self.assert_refused(self.script(line + "\nsync\n"), USAGE, *parts)

    def test_a_data_sheet_names_the_objects_of_its_node_in_all_lines(self):
        sheet = self.folder / "own.eds"
        text = self.assert_done(run("eds", "export", "battery"))
        sheet.write_text(text.replace("[6010]\nParameterName=temperature", "[2010]\nParameterName=warmth").replace("=0x6010", "=0x2010"))
        lines = "read 10 temperature --profile 418\nread 0Ah warmth\n"
        for said in (str(sheet), f"10={sheet}", f"0x0A={sheet}"):
            result = self.script(lines, "--eds", said)
            self.assertEqual(result.returncode, FAILED, said)
            self.assertIn("1 of 2 lines passed, 1 failed", result.stdout)
            self.assertIn("06020000h", result.stdout)  # the battery does not have 2010h
        for others in ((), ("--eds", f"11={sheet}"), ("--eds", f"pump={sheet}")):
            self.assertEqual(self.script(lines, *others).returncode, USAGE, others)

    def test_nothing_is_done_where_a_line_is_none(self):
        for line, *parts in (
            ("raed 10 1017", "'raed'", "did you mean 'read'?"),
            ("read 10", "object"),
            ("read 10 'temperature", "quote"),
            ("read 10 1017 --josn", "did you mean '--json'?"),
            ("read 10 tempersture", "did you mean 'temperature'?"),
            ("write 10 tempersture 20", "did you mean 'temperature'?"),
            ("write 10 1017 70000 --type u16", "65535"),
            ("expect 10 tempersture = 20", "did you mean 'temperature'?"),
            ("expect 300 1000 = 5", "'300' is no node-ID"),
            ("expect 10 temperature 20", "temperature 20"),
            ("read --help", "no --help"),
            ("script other.canvoy", "'script'"),
            ("monitor", "'monitor' is no verb of a script: ", "read", "wait"),
        ):
            with self.subTest(line=line):
                self.assert_refused(self.script(f"write 10 1017 444ms\n{line}\n"), USAGE, "test.canvoy line 2", *parts)
        self.assertNotEqual(run("read", BUS, "10", "1017").stdout, "444 ms\n")
        self.assert_refused(self.script("# nothing\n"), USAGE, "no line")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
