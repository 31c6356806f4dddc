#!/usr/bin/env python3
"""The logs of can-utils and Wireshark: what they write we read, and what we write they read, with the same frames.

    CANVOY=build/canvoy tests/strangers/traces/traces_test.py COMMENTS

COMMENTS writes a pcapng with comments. Missing programs skip the test (77).
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CANVOY = os.environ.get("CANVOY", "build/canvoy")
NEEDED = ["log2asc", "asc2log", "tshark", "editcap"]

# The first at a whole second, from which log2asc counts. An error frame has no details in ASC: a bus error is written.
LOG = """(1700000000.000000) can0 185#1E2F
(1700000001.500125) can1 18DAF110#0102030405060708
(1700000002.500125) can0 00000185#11
(1700000002.600125) can0 701#R4
(1700000003.500125) can0 20000080#0000000000000000
(1700000004.500125) can1 000#0105
(1700000004.999999) can0 7FF#
"""


def run(*command):
    environment = {**os.environ, "TZ": "UTC", "LC_ALL": "C"}
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command}: {done.stderr}")
    return done.stdout


class TracesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "bus.log").write_text(LOG)

    def path(self, name):
        return str(self.folder / name)

    def text(self, name):
        return (self.folder / name).read_text()

    def convert(self, source, target):
        run(CANVOY, "convert-log", self.path(source), self.path(target))

    def shown(self, name, *fields):
        chosen = [part for field in fields for part in ("-e", field)]
        return [line.split("\t") for line in run("tshark", "-r", self.path(name), "-T", "fields", *chosen).splitlines()]

    def test_writes_the_asc_that_log2asc_writes(self):
        self.convert("bus.log", "ours.asc")
        run("log2asc", "-I", self.path("bus.log"), "-O", self.path("theirs.asc"), "can0", "can1")
        self.assertEqual(self.text("ours.asc"), self.text("theirs.asc"))

    def test_reads_the_asc_of_log2asc(self):
        run("log2asc", "-I", self.path("bus.log"), "-O", self.path("theirs.asc"), "can0", "can1")
        self.convert("theirs.asc", "again.log")
        self.assertEqual(self.text("again.log"), LOG)

    def test_asc2log_reads_our_asc(self):
        self.convert("bus.log", "ours.asc")
        run("asc2log", "-I", self.path("ours.asc"), "-O", self.path("again.log"))
        again = [line.split()[1:3] for line in self.text("again.log").splitlines()]
        self.assertEqual(again, [line.split()[1:3] for line in LOG.splitlines()])

    def test_tshark_reads_our_pcapng(self):
        self.convert("bus.log", "ours.pcapng")
        lines = self.shown("ours.pcapng", "frame.time_epoch", "frame.interface_name", "can.id", "can.len", "data.data")
        self.assertEqual(len(lines), 7)
        self.assertEqual(lines[0], ["1700000000.000000000", "can0", str(0x185), "2", "1e2f"])
        self.assertEqual(lines[1], ["1700000001.500125000", "can1", str(0x18DAF110), "8", "0102030405060708"])
        self.assertEqual(lines[5][:4], ["1700000004.500125000", "can1", "0", "2"])
        flags = self.shown("ours.pcapng", "can.flags.xtd", "can.flags.rtr")
        self.assertEqual([flags[0], flags[2], flags[3]], [["0", "0"], ["1", "0"], ["0", "1"]])

    def test_reads_what_editcap_writes(self):
        self.convert("bus.log", "ours.pcapng")
        for kind in ["pcapng", "pcap", "nsecpcap"]:
            run("editcap", "-F", kind, self.path("ours.pcapng"), self.path("theirs." + kind))
            self.convert("theirs." + kind, f"{kind}.log")
            again = [line.split()[::2] for line in self.text(f"{kind}.log").splitlines()]
            self.assertEqual(again, [line.split()[::2] for line in LOG.splitlines()], kind)

    def test_tshark_shows_our_comments(self):
        run(COMMENTS, self.path("comments.pcapng"))
        self.assertEqual(
            self.shown("comments.pcapng", "can.id", "frame.comment"),
            [[str(0x185), "node 5: temperature = 20.000 °C"], ["128", ""], [str(0x705), "node 5: operational"]],
        )

    def test_tshark_shows_what_decode_says(self):
        # CiA 418: temperature 0.125 degrees a step, status ready; a heartbeat has nothing more to say than its state.
        (self.folder / "battery.log").write_text("(1700000000.000000) can0 18A#A00001\n(1700000000.100000) can0 70A#05\n")
        run(CANVOY, "decode", self.path("battery.log"), "--node", "10=418", "--out", self.path("battery.pcapng"))
        self.assertEqual(
            self.shown("battery.pcapng", "can.id", "frame.comment"),
            [
                [str(0x18A), "TPDO1 node 10 (0Ah): temperature = 20.000 °C; battery_status = ready"],
                [str(0x70A), "heartbeat node 10 (0Ah): operational"],
            ],
        )


if __name__ == "__main__":
    missing = [program for program in NEEDED if shutil.which(program) is None]
    if missing:
        print("not installed:", *missing)
        sys.exit(77)
    COMMENTS = sys.argv.pop()
    unittest.main()
