#!/usr/bin/env python3
"""canvoy configure: a battery on a bus of its own gets a configuration, from a text and from a concise DCF."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, FAILED, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.8:43118"

TEXT = """\
# index sub type value
1017 0 u16 500
1015 0h u16 20
"""
# The same two entries, as CiA 302-3 has them, with other values: 700 ms and 30.
CONCISE = bytes.fromhex("02000000" "17100002000000BC02" "15100002000000" "1E00")


class Configure(CommandTest):
    """A battery, node 10, runs as long as the tests."""

    @classmethod
    def setUpClass(cls):
        cls.battery = subprocess.Popen(
            [CANVOY, "device", "battery", BUS, "--node-id", "10"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        for _ in range(100):
            if run("read", BUS, "10", "1000").returncode == 0:
                return
            time.sleep(0.1)
        raise AssertionError("the battery does not come up")

    @classmethod
    def tearDownClass(cls):
        cls.battery.terminate()
        cls.battery.wait()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, content):
        path = pathlib.Path(self.folder.name) / "battery.cdcf"
        path.write_bytes(content if isinstance(content, bytes) else content.encode("ascii"))
        return str(path)

    def heartbeat(self):
        return self.assert_done(run("read", BUS, "10", "1017")).strip()

    def test_a_text_is_written_entry_by_entry(self):
        output = self.assert_done(run("configure", BUS, "10", self.file(TEXT)))
        self.assertEqual(
            output,
            "1/2  1017h:00h  2 bytes\n2/2  1015h:00h  2 bytes\nnode 10 (0Ah) configured: 2 entries written\n",
        )
        self.assertEqual(self.heartbeat(), "500 ms")

    def test_a_concise_dcf_is_written_too(self):
        self.assert_done(run("configure", BUS, "10", self.file(CONCISE)))
        self.assertEqual(self.heartbeat(), "700 ms")

    def test_check_writes_nothing(self):
        before = self.heartbeat()
        output = self.assert_done(run("configure", BUS, "10", self.file("1017 0 u16 900\n"), "--check"))
        self.assertEqual(output, "1017h:00h  2 bytes\n1 entry, nothing written\n")
        self.assertEqual(self.heartbeat(), before)

    def test_what_the_node_refuses_is_named(self):
        result = run("configure", BUS, "10", self.file("1000 0 u32 1\n1017 0 u16 900\n"))
        self.assert_refused(result, FAILED, "node 10 (0Ah)", "1000h:00h", "06010002h", "0 of 2 entries written before")

    def test_a_malformed_file_changes_nothing(self):
        before = self.heartbeat()
        for content, part in (
            (CONCISE[:-1], "in its entry 2"),
            (CONCISE + b"\0", "something follows"),
            ("1017 0 u16 900\n1015 0 u99 1\n", "line 2"),
            ("", "no entry"),
        ):
            with self.subTest(content=content):
                self.assert_refused(run("configure", BUS, "10", self.file(content)), FAILED, "battery.cdcf", part)
        self.assertEqual(self.heartbeat(), before)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
