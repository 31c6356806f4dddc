#!/usr/bin/env python3
"""What is made of the times that tests have taken, and when a kind of test takes too long."""

import pathlib
import sys
import tempfile
import unittest

import script

import test_times

sys.path.insert(0, str(script.ROOT / "tests/style"))
cpu_time = script.load("../tests/style/cpu_time")

LINES = "1.50\t1.00\t0.25\tcanopen.part_0\n9.00\t0.10\t0.00\tcli.run\n2.00\t3.00\t0.50\tcanopen.part_0\n4.00\t20.00\t1.00\tcanopen.part_1\n"


class TestTimes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        test_times.path_in(self.folder).write_text(LINES)

    def test_the_last_run_of_a_test_counts(self):
        times = test_times.read(self.folder)
        self.assertEqual((times["canopen.part_0"].clock, times["canopen.part_0"].processor), (2.0, 3.5))

    def test_kinds_are_summed(self):
        kinds = test_times.by_kind(test_times.read(self.folder))
        self.assertEqual(list(kinds), ["canopen", "cli"])
        self.assertEqual((kinds["canopen"].count, kinds["canopen"].processor), (2, 24.5))

    def test_a_folder_without_tests_has_no_times(self):
        self.assertEqual(test_times.read(self.folder / "none"), {})

    LIMITS = {"can": 1.0, "canopen": 30.0, "devices": 20.0, "sim": 200.0, "cli": 60.0, "embed": 90.0}

    def kinds(self, scale, **others):
        """As long as their limits are, times `scale`, but for the others."""
        seconds = {kind: limit * scale for kind, limit in self.LIMITS.items()} | others
        return {kind: test_times.Times(2, each, each) for kind, each in seconds.items()}

    def test_a_kind_that_takes_twice_its_time_is_found(self):
        self.assertEqual(cpu_time.complaints(self.kinds(1, devices=40.0, can=9.0), self.LIMITS), [])
        findings = cpu_time.complaints(self.kinds(1, devices=41.0), self.LIMITS)
        self.assertEqual(findings, ["devices: 2 tests took 41 s of a processor, 40 at most"])

    def test_a_slower_machine_has_more_time_and_finds_the_same(self):
        self.assertEqual(cpu_time.complaints(self.kinds(3, cli=359.0), self.LIMITS), [])
        self.assertIn("cli: ", cpu_time.complaints(self.kinds(3, cli=361.0), self.LIMITS)[0])

    def test_a_kind_without_a_line_is_found(self):
        self.assertIn("web: no line", cpu_time.complaints(self.kinds(1, web=1.0), self.LIMITS)[0])


if __name__ == "__main__":
    unittest.main()
