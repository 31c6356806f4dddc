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

    def test_a_kind_that_takes_twice_its_time_is_found(self):
        kinds = test_times.by_kind(test_times.read(self.folder))
        self.assertEqual(cpu_time.complaints(kinds, {"canopen": 12.5, "cli": 0.1}, 1.0), [])
        findings = cpu_time.complaints(kinds, {"canopen": 12.0, "cli": 0.1}, 1.0)
        self.assertEqual(len(findings), 1)
        self.assertIn("canopen: 2 tests took 24 s of a processor, 24 at most", findings[0])

    def test_a_slower_machine_has_more_time(self):
        kinds = test_times.by_kind(test_times.read(self.folder))
        self.assertEqual(cpu_time.complaints(kinds, {"canopen": 6.5, "cli": 0.1}, 2.0), [])

    def test_a_kind_without_a_line_is_found(self):
        kinds = test_times.by_kind(test_times.read(self.folder))
        self.assertIn("cli: no line", cpu_time.complaints(kinds, {"canopen": 30.0}, 1.0)[0])


if __name__ == "__main__":
    unittest.main()
