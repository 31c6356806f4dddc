#!/usr/bin/env python3
"""canvoy decode of a log of several buses, from outside: what is known is known for each bus.

What is expected is typed from CiA 301, 305, 418 and 419."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

# Node 10 is a battery (CiA 418) on can0 and a charger (CiA 419) on can1: each tells its device type
# while the other does, and then sends its first TPDO.
TWO = """(1.000000) can0 60A#4000100000000000
(1.000100) can1 60A#4000100000000000
(1.000500) can0 58A#43001000A2010000
(1.000600) can1 58A#43001000A3010000
(1.100000) can0 18A#A00001
(1.100100) can1 18A#01
"""


class DecodeBusesTest(CommandTest):
    def log(self, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "bus.log"
        path.write_text(text)
        return str(path)

    def lines(self, text, *arguments):
        return self.assert_done(run("decode", self.log(text), *arguments)).splitlines()

    def test_a_node_id_stands_for_another_device_on_another_bus(self):
        lines = self.lines(TWO)
        self.assertTrue(lines[2].endswith("=> node 10 (0Ah) is of CiA 418"), lines[2])
        self.assertTrue(lines[3].endswith("=> node 10 (0Ah) is of CiA 419"), lines[3])
        self.assertIn("temperature = 20.000 °C; battery_status = ready", lines[4])
        self.assertIn("charger_status = ready", lines[5])
        self.assertNotIn("[!]", "".join(lines))

    def test_transfers_at_once_on_two_buses_are_two(self):
        # 1008h in segments on can0; on can1 the same server is asked for 1018h:05h, and refuses.
        frames = [
            "can0 60A#4008100000000000", "can1 60A#4018100500000000",
            "can0 58A#410810000A000000", "can1 58A#8018100511000906",
            "can0 60A#6000000000000000", "can1 60A#4000100000000000",
            "can0 58A#0043616E766F7920", "can1 58A#43001000A3010000",
            "can0 60A#7000000000000000", "can0 58A#1942434400000000",
        ]
        lines = self.lines("".join(f"(1.0) {frame}\n" for frame in frames))
        self.assertIn('"Canvoy BCD"', lines[9])
        self.assertIn("1000h:00h Device type", lines[7])
        self.assertNotIn("[!]", "".join(lines))

    def test_node_guarding_alternates_on_each_bus(self):
        frames = [
            "can0 70A#00", "can1 70A#00", "can0 70A#R1", "can1 70A#R1", "can0 70A#05", "can1 70A#05",
            "can0 70A#R1", "can0 70A#85", "can1 70A#R1", "can1 70A#85",
        ]
        lines = self.lines("".join(f"(1.0) {frame}\n" for frame in frames))
        self.assertEqual([line for line in lines if "[!]" in line], [])
        self.assertTrue(lines[9].endswith("operational, toggle bit 1"), lines[9])

    def test_lss_selects_on_each_bus(self):
        ask = ["7E5#40F0020000000000", "7E5#41A3010000000000", "7E5#4200000100000000"]
        lines = self.lines(
            "".join(f"(1.0) {bus} {frame}\n" for frame in ask for bus in ("can0", "can1"))
            + "(1.0) can0 7E5#434D000000000000\n(1.0) can1 7E5#434E000000000000\n"
            + "(1.0) can0 7E4#4400000000000000\n(1.0) can1 7E4#4400000000000000\n"
        )
        self.assertTrue(lines[8].endswith("serial number 0000004Dh"), lines[8])
        self.assertTrue(lines[9].endswith("serial number 0000004Eh"), lines[9])

    def test_json_and_comments_of_packets_know_each_bus(self):
        objects = [json.loads(line) for line in self.lines(TWO, "--json")]
        self.assertEqual((objects[4]["bus"], objects[4]["values"][0]["name"]), ("can0", "temperature"))
        self.assertEqual((objects[5]["bus"], objects[5]["values"][0]["name"]), ("can1", "charger_status"))
        self.assertFalse([each for each in objects if "marks" in each])
        out = self.log("") + ".pcapng"
        self.assert_done(run("decode", self.log(TWO), "--out", out))
        content = pathlib.Path(out).read_bytes()
        self.assertIn(b"charger_status = ready", content)
        self.assertNotIn(b"[!]", content)
        self.assertEqual(self.assert_done(run("decode", out)).splitlines()[5][-22:], "charger_status = ready")

    def test_filters_by_bus(self):
        self.assertEqual(len(self.lines(TWO, "--filter", "bus=can1")), 3)
        self.assertEqual(len(self.lines(TWO, "--filter", "bus=can1", "--filter", "service=TPDO")), 1)
        result = run("decode", self.log(TWO), "--filter", "bus=can")
        self.assertEqual((result.returncode, result.stdout), (DONE, ""))
        self.assertIn("none of 6 frames passes the filter, never true: bus=can", result.stderr)
        self.assertEqual(len(self.lines(TWO, "--filter", "node=10")), 6)

    def test_takes_the_profile_of_a_node_of_one_bus(self):
        frames = "(1.0) can0 18A#01\n(1.0) can1 18A#01\n(1.0) udp:239.74.163.2:43113 18A#01\n"
        for arguments, named in [
            (["--node", "10=419"], [0, 1, 2]),
            (["--node", "can1:10=419"], [1]),
            (["--node", "udp:239.74.163.2:43113:10=419"], [2]),
            (["--profile", "419"], [0, 1, 2]),
            (["--profile", "can0=419", "--profile", "can1=419"], [0, 1]),
            (["--node", "can1:10=401", "--node", "10=419"], [0, 2]),
            (["--profile", "can1=401", "--profile", "419"], [0, 2]),
        ]:
            lines = run("decode", self.log(frames), *arguments).stdout.splitlines()
            self.assertEqual([i for i, line in enumerate(lines) if "charger_status" in line], named, arguments)

    def test_takes_the_data_sheet_of_a_node_of_one_bus(self):
        sheet = self.log("") + ".eds"
        self.assert_done(run("eds", "export", "battery", "--out", sheet))
        log = self.log("(1.0) can0 18A#A00001\n(1.0) can1 18A#A00001\n")
        lines = self.assert_decoded(run("decode", log, "--eds", f"can1:10={sheet}")).splitlines()
        self.assertNotIn("temperature", lines[0])
        self.assertIn("temperature = 20.000 °C", lines[1])

    def test_tells_of_an_option_for_a_bus_that_is_not_in_the_log(self):
        result = run("decode", self.log(TWO), "--node", "can7:5=419")
        self.assertEqual(result.returncode, DONE)
        self.assertRegex(result.stderr, r"\A[^\n]*: no frame in it is of a bus 'can7'\n\Z")
        self.assert_refused(run("decode", self.log(TWO), "--node", "can1:128=419"), USAGE, "'128'", "1 to 127")
        self.assert_refused(run("decode", self.log(TWO), "--profile", "can1=999"), USAGE, "'999'")
        self.assert_refused(run("decode", self.log(TWO), "--eds", "can1:5=/no/such.eds"), FAILED, "/no/such.eds")

    def test_a_log_of_thousands_of_buses_takes_no_more_memory_than_one_of_some(self):
        def decode(buses):
            """What it says, its complaints, and the most memory that it had."""
            frames = (f"(1.0) can{i} {frame}\n" for i in range(buses) for frame in ("70A#05", "18A#01"))
            # Sanitizers keep what is freed.
            environment = {**os.environ, "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1"}
            with tempfile.TemporaryFile("w+") as said, tempfile.TemporaryFile("w+") as complaints:
                arguments = [CANVOY, "decode", self.log("".join(frames)), "--node", "10=419"]
                process = subprocess.Popen(arguments, stdout=said, stderr=complaints, env=environment)
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
                self.assertEqual(process.returncode, DONE)
                said.seek(0)
                complaints.seek(0)
                return said.read(), complaints.read(), usage.ru_maxrss

        _, complaints, some = decode(64)
        self.assertEqual(complaints, "")
        said, complaints, thousands = decode(20_000)
        self.assertEqual(len(re.findall("charger_status = ready", said)), 20_000)
        self.assertIn("more than 64 buses", complaints)
        self.assertLess(thousands, some + 32 * 1024, "KiB")

    def test_the_log_of_two_lifts_and_their_group_has_no_mark(self):
        log = self.log("")
        arguments = ["--lifts", "2", "--floors", "6", "--for", "5min", "--seed", "4"]
        self.assert_done(run("run", "lift", *arguments, "--log", log))
        lines = self.assert_decoded(run("decode", log)).splitlines()
        self.assertGreater(len(lines), 1000)
        self.assertEqual({line.split()[1] for line in lines}, {"lift1", "lift2", "group"})
        self.assertEqual([line for line in lines if "[!]" in line], [])


if __name__ == "__main__":
    unittest.main()
