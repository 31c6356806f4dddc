#!/usr/bin/env python3
"""canvoy convert-log, from outside."""

import gzip
import json
import pathlib
import subprocess
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

LOG = "(1700000000.000000) can0 185#1E2F\n(1700000001.500125) can1 701#05\n"
ASC = """date Tue Nov 14 22:13:20 2023
base hex  timestamps absolute
no internal events logged
   0.000000 1  185             Rx   d 2 1E 2F
   1.500125 2  701             Rx   d 1 05
"""


class ConvertLogTest(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name, text=None):
        path = self.folder / name
        if text is not None:
            path.write_text(text)
        return str(path)

    def test_converts_and_tells_what_it_read(self):
        told = self.assert_done(run("convert-log", self.path("bus.log", LOG), self.path("bus.asc")))
        self.assertEqual(told, "2 frames of a candump log; 0 lines or blocks could not be read, 0 CAN FD frames left out\n")
        self.assertEqual((self.folder / "bus.asc").read_text(), ASC)

    def test_it_tells_as_json_what_it_read(self):
        result = run("convert-log", self.path("bus.log", LOG + "junk\n"), self.path("bus.asc"), "--json")
        self.assertEqual(json.loads(result.stdout), {"event": "converted", "file": self.path("bus.asc"), "format": "candump log", "frames": 2, "bad": 1, "fd_skipped": 0})
        self.assertEqual((self.folder / "bus.asc").read_text(), ASC)

    def test_there_and_back_is_the_same(self):
        first = self.path("bus.log", LOG)
        for name in ["a.pcapng", "b.asc", "c.log"]:
            self.assert_done(run("convert-log", first, self.path(name)))
            first = self.path(name)
        self.assertEqual((self.folder / "c.log").read_text(), LOG)

    def test_times_that_jump_back_are_kept(self):
        jump = LOG + "junk\n(1699990000.250000) can0 18A#01\n"
        log = self.path("jump.log", jump)
        result = run("convert-log", log, self.path("jump.asc"))
        self.assertEqual(len(result.stderr.splitlines()), 1, "the bad line is told once")
        self.assertIn("3 frames of a candump log; 1 lines", result.stdout)
        self.assertTrue((self.folder / "jump.asc").read_text().startswith("date Tue Nov 14 19:26:40 2023\n"))
        self.assert_done(run("convert-log", self.path("jump.asc"), self.path("back.log")))
        self.assertEqual((self.folder / "back.log").read_text(), jump.replace("junk\n", ""))

    def test_times_that_a_file_cannot_say_are_told_of(self):
        jump = (LOG + "(1699990000.250000) can0 18A#01\n").encode()
        command = [CANVOY, "convert-log", "-", self.path("jump.asc")]
        told = "jump.asc: 1 frame was earlier than its beginning, and got the time of that; a .log keeps all times\n"
        result = subprocess.run(command, input=jump, capture_output=True, timeout=60)
        self.assertTrue(result.stderr.decode().endswith(told), result.stderr)
        self.assertEqual(result.returncode, DONE)
        result = subprocess.run([*command, "--json"], input=jump, capture_output=True, timeout=60)
        self.assertEqual(json.loads(result.stdout)["early"], 1)
        result = run("decode", self.path("jump.log", jump.decode()), "--out", self.path("jump.asc"))
        self.assertTrue(result.stderr.endswith(told), result.stderr)

    def test_shows_bad_lines_with_their_number_and_goes_on(self):
        result = run("convert-log", self.path("bus.log", LOG + "junk\n" + LOG), self.path("out.log"))
        self.assertRegex(result.stderr, r"\A[^\n]*bus.log, line 3: [^\n]+\n\Z")
        self.assertIn("4 frames of a candump log; 1 lines", result.stdout)
        self.assertEqual((self.folder / "out.log").read_text(), LOG + LOG)
        self.assertEqual(result.returncode, DONE)

    def test_shows_no_more_bad_lines_than_help(self):
        result = run("convert-log", self.path("bus.log", LOG + "junk\n" * 1000), self.path("out.log"))
        self.assertEqual(len(result.stderr.splitlines()), 20)
        self.assertIn("1000 lines or blocks could not be read", result.stdout)

    def test_reads_what_gzip_pipes(self):
        packed = gzip.compress(LOG.encode())
        result = subprocess.run([CANVOY, "convert-log", "-", self.path("out.log")], input=packed, capture_output=True, timeout=60)
        self.assertEqual((result.stderr, result.returncode), (b"", DONE))
        self.assertEqual((self.folder / "out.log").read_text(), LOG)

    def test_refuses_a_log_without_a_frame(self):
        kept = self.path("kept.asc", "kept")
        header = self.path("header.asc", ASC[: ASC.index("   0.0")])
        self.assert_refused(run("decode", self.path("empty.log", "")), FAILED, "empty.log: it is empty")
        fd = self.path("fd.log", "(1700000000.000000) can0 185##01E2F\n")
        for arguments in (["convert-log", header, kept], ["decode", header]):
            self.assert_refused(run(*arguments), FAILED, "header.asc: no frame can be read in it", "Vector ASC")
        self.assert_refused(run("convert-log", fd, kept), FAILED, "fd.log: all 1 frames in it are of CAN FD")
        self.assertEqual((self.folder / "kept.asc").read_text(), "kept")

    def test_refuses_what_it_cannot_do_and_changes_nothing(self):
        log = self.path("bus.log", LOG)
        letter = self.path("letter.txt", "Dear reader,\n")
        kept = self.path("kept.asc", "kept")
        self.assert_refused(run("convert-log", log, self.path("bus.xls")), USAGE, "bus.xls", "these are written: candump log (.log), Vector ASC (.asc)")
        self.assert_refused(run("convert-log", log, self.path("bus")), USAGE, "its end says no format")
        self.assert_refused(run("convert-log", log, log), USAGE, "bus.log", "name another")
        self.assert_refused(run("convert-log", letter, kept), FAILED, "letter.txt", "looks like text without frames")
        self.assert_refused(run("convert-log", "/no/such.log", kept), FAILED, "/no/such.log", "check the path")
        self.assert_refused(run("convert-log", log, "/no/such/folder/a.asc"), FAILED, "/no/such/folder/a.asc")
        self.assert_refused(run("convert-log", log), USAGE, "which file is to be written")
        self.assertEqual((self.folder / "kept.asc").read_text(), "kept")
        self.assertEqual((self.folder / "bus.log").read_text(), LOG)


if __name__ == "__main__":
    unittest.main()
