#!/usr/bin/env python3
"""Pictures of canvoy run, on terminals of three sizes (tmux): they fit, say their keys, and heed them."""

import pathlib
import shutil
import sys
import tempfile
import unittest

from command import CANVOY
from monitor_table_test import Terminal


class RunPicture(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def show(self, columns, rows, *arguments):
        terminal = Terminal(self.folder, columns, rows, CANVOY, "run", *arguments)
        self.addCleanup(terminal.end)
        return terminal

    def test_eight_lifts_of_forty_floors_fit(self):
        for columns, rows in ((80, 24), (200, 60), (100, 30)):
            terminal = self.show(columns, rows, "lift", "--lifts", "8", "--floors", "40", "--for", "1h", "--speed", "10")
            self.assertTrue(terminal.comes_to(lambda lines: len(lines) == rows and "q ends" in lines[-1]), terminal.lines())
            lines = terminal.lines()
            edges = {line.count("|") for line in lines if "|" in line}
            self.assertEqual(edges, {9}, "all eight are there")
            self.assertTrue(any("bus load" in line for line in lines))
            terminal.press("q")
            self.assertTrue(terminal.is_over(), "q ends it")

    def test_the_last_events_stay_in_sight_and_keys_change_the_pace(self):
        terminal = self.show(80, 24, "charger", "--for", "8h", "--speed", "60")
        terminal.wait_for("tells the time")
        terminal.press("+")
        terminal.wait_for("(x120)")
        terminal.press("-", "-")
        terminal.wait_for("(x30)")
        terminal.press("Space")
        before = terminal.wait_for("PAUSED")
        self.assertEqual(terminal.lines()[2], before[2], "time stands still")
        terminal.press("Space")
        self.assertTrue(terminal.comes_to(lambda lines: "pauses" in lines[-1] and lines[2] != before[2]))
        terminal.press("q")
        self.assertTrue(terminal.is_over(), "q ends it")


if __name__ == "__main__":
    if shutil.which("tmux") is None:
        print("skipped: tmux is missing; scripts/install-packages test installs it")
        sys.exit(77)
    unittest.main()
