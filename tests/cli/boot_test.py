#!/usr/bin/env python3
"""`canvoy boot` from outside: what it tells of each slave, and how it ends."""

import json
import pathlib
import re
import subprocess
import sys
import time
import unittest

from command import CANVOY, DONE, FAILED, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.2:43119"


class Boot(CommandTest):
    """The network of the command itself, and one over UDP."""

    def test_the_simulated_network_shows_each_of_its_defects(self):
        output = self.assert_done(run("boot", "sim"))
        for part in (
            "node 2 (02h) display",
            "D: another vendor-ID (1018h:01h): expected 00000123h, found 00000124h",
            "node 4 (04h) door    B: no answer",
            "node 5 (05h) lamp    ",
            "K: no heartbeat after error control began",
            "node 6 (06h) valve   has restarted in the middle of its boot-up",
            "node 7 (07h) fan     is up, L: it was operational",
            "node 9 (09h)         has booted, A: it is not among the slaves",
            "node 11 (0Bh) horn   failed, C: another device type (1000h): expected 00000191h, found 000F0191h",
            "node 12 (0Ch) sensor failed, M: another product code (1018h:02h): expected 00000008h, found 00000007h",
            "node 13 (0Dh) heater failed, N: another revision (1018h:03h)",
            "node 14 (0Eh) cooler failed, O: another serial number (1018h:04h)",
            "node 15 (0Fh) mixer  failed, E: no heartbeat, by which to see whether it is operational",
            "node 16 (10h) brake  failed, F: no answer to node guarding",
            "node 17 (11h) gripper failed, G: the data to check its software are missing",
            "node 18 (12h) lift   failed, H: it needs other software, and an update is not allowed",
            "node 19 (13h) drill  failed, I: the download of its software failed",
            "node 19 (13h) drill  the download failed: 08000020h",
            "node 20 (14h) press  failed, J: the download of its configuration failed (06020000h",
            "node 20 (14h) press  2000h:01h was not taken (06020000h",
            "node 21 (15h) robot  has got its program",
            "node 21 (15h) robot  is configured: 1 entry written",
            "all mandatory slaves are up",
        ):
            self.assertIn(part, " ".join(output.split("  ")) if part not in output else output)

    def test_the_same_again_tells_the_same(self):
        self.assertEqual(self.assert_done(run("boot", "sim")), self.assert_done(run("boot", "sim")))

    def test_the_last_table_says_every_letter_that_was_told(self):  # CiA 302-2
        story, _, table = self.assert_done(run("boot", "sim", "--for", "20s")).partition("\n\n")
        told = set(re.findall(r"\b([A-O]): ", story)) | set(re.findall(r"failed, ([A-O]):", story))
        self.assertEqual(told, set("ABCDEFGHIJKLMNO"))
        self.assertEqual(set(re.findall(r"\b([A-O]): ", table)), told)
        self.assertRegex(table, r"node 10 \(0Ah\) motor +mandatory up; told before: B: no answer\n")

    def test_every_line_of_json_is_an_object_and_the_last_is_the_summary(self):
        lines = [json.loads(line) for line in self.assert_done(run("boot", "sim", "--json")).splitlines()]
        self.assertTrue(all(isinstance(line, dict) for line in lines))
        self.assertTrue(all({"time", "node", "event", "step", "text"} <= line.keys() for line in lines[:-1]))
        summary = lines[-1]
        self.assertIs(summary["complete"], True)
        letters = {slave["node"]: (slave["up"], slave["error"]) for slave in summary["slaves"]}
        self.assertEqual(
            letters,
            {
                2: (True, ""),
                3: (False, "D"),
                4: (False, "B"),
                5: (False, "K"),
                6: (True, ""),
                7: (True, "L"),
                8: (True, ""),
                10: (True, ""),
                11: (False, "C"),
                12: (False, "M"),
                13: (False, "N"),
                14: (False, "O"),
                15: (False, "E"),
                16: (False, "F"),
                17: (False, "G"),
                18: (False, "H"),
                19: (False, "I"),
                20: (False, "J"),
                21: (True, ""),
            },
        )

    def test_a_mandatory_slave_that_does_not_come_up_is_a_failure(self):
        for slave, letter in (("3:mandatory,vendor=0x123", "D"), ("4:mandatory", "B"), ("5:mandatory,heartbeat=1s", "K")):
            with self.subTest(slave=slave):
                result = run("boot", "sim", "--node", slave, "--boot-time", "3s")
                self.assertEqual((result.stderr, result.returncode), ("", FAILED), result.stdout)
                self.assertIn(f" {letter}: ", result.stdout)

    def test_it_boots_a_device_of_another_process(self):
        arguments = [CANVOY, "device", "battery", BUS, "--node-id", "10", "--heartbeat", "200ms"]
        with subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True) as device:
            try:
                device.stdout.readline()
                time.sleep(0.2)
                result = run("boot", BUS, "--node", "10:mandatory,name=battery,heartbeat=5s", "--json")
                self.assertEqual((result.stderr, result.returncode), ("", DONE), result.stdout)
                events = [json.loads(line) for line in result.stdout.splitlines()]
                self.assertEqual(events[-1]["slaves"], [{"node": 10, "mandatory": True, "up": True, "error": "", "told": ""}])
                self.assertIn("started", [event.get("event") for event in events])
                wrong = run("boot", BUS, "--node", "10:mandatory,vendor=0x7FFFFFFF")
                self.assertEqual((wrong.stderr, wrong.returncode), ("", FAILED))
                self.assertIn("found", wrong.stdout)
            finally:
                device.terminate()


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
