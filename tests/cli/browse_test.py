#!/usr/bin/env python3
"""canvoy browse on terminals of two sizes (tmux): tree, live value, edit with checks, save to a DCF, load one with the difference
first. A battery (CiA 418) is node 10; its producer heartbeat time (1017h, in ms) is changed."""

import configparser
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, CommandTest, run
from monitor_table_test import Terminal

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.27:43127"


class Browse(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.start()

    def start(self):
        self.device = subprocess.Popen([CANVOY, "device", "battery", BUS], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(self.device.wait)
        self.addCleanup(self.device.terminate)
        for _ in range(200):
            if run("read", BUS, "10", "1000").returncode == DONE:
                break
            time.sleep(0.1)

    def read(self):
        return self.assert_done(run("read", BUS, "10", "1017")).strip()

    def write(self, value):
        self.assert_done(run("write", BUS, "10", "1017", value))

    def wait_for_row(self, terminal, place, value):
        wanted = lambda lines: any(place in line and value in line for line in lines)
        self.assertTrue(terminal.comes_to(wanted), f"{place} {value}: {terminal.lines()}")

    def answer(self, terminal, question, text, erase=0):
        terminal.wait_for(question)
        terminal.press(*["BSpace"] * erase, "")
        terminal.press("-l", text)
        terminal.press("Enter")

    def look_and_change(self, columns, rows):
        self.write("500ms")
        terminal = Terminal(self.folder, columns, rows, CANVOY, "browse", BUS, "10")
        self.addCleanup(terminal.end)
        lines = terminal.wait_for("q quit")
        self.assertEqual(len(lines), rows)
        self.assertIn("q quit", lines[-1])
        self.assertLessEqual(max(map(len, lines)), columns)
        self.assertIn("node 10 (0Ah)", lines[0])
        self.wait_for_row(terminal, "1000h", "000001A2h")
        # A record is closed at first, and has its entries below it when it is opened. Long values take several rows.
        self.assertFalse(any("\u2026" in line for line in lines[1:]), lines)
        for _ in range(8):
            if any("1018h" in line for line in terminal.lines()):
                break
            terminal.press("NPage")
            terminal.comes_to(lambda now: now[1:] != lines[1:])
            lines = terminal.lines()
        self.assertTrue(any("1018h" in line and "+ " in line for line in terminal.lines()), terminal.lines())
        self.assertFalse(any("1018h:01h" in line for line in terminal.lines()))
        terminal.press("/")
        self.answer(terminal, "search:", "Identity")
        self.wait_for_row(terminal, "1018h:02h", "1A2h")
        # Live: somebody else changes it.
        terminal.press("/")
        self.answer(terminal, "search:", "1017", erase=len("Identity"))
        self.wait_for_row(terminal, "1017h", "500 ms")
        self.write("700ms")
        self.wait_for_row(terminal, "1017h", "700 ms")
        return terminal

    def edit(self, terminal):
        terminal.press("Enter")
        self.answer(terminal, "now 700 ms", "500.5")
        terminal.wait_for("cannot be stored exactly")
        terminal.press("Enter")
        self.answer(terminal, "now 700 ms", "20 \u00b0C")
        terminal.wait_for("'20 \u00b0C'")
        self.assertEqual(self.read(), "700 ms", "what is refused changes nothing")
        terminal.press("Enter")
        # A character of two bytes is taken back by one key.
        terminal.wait_for("now 700 ms")
        terminal.press("-l", "300m\u00b5")
        terminal.press("BSpace")
        terminal.press("-l", "s")
        terminal.press("Enter")
        self.wait_for_row(terminal, "1017h", "300 ms")
        self.assertEqual(self.read(), "300 ms")

    def save_and_load(self, terminal, path):
        terminal.press("w")
        self.answer(terminal, "save to", str(path), erase=len("node.dcf"))
        terminal.wait_for("written to")
        sheet = configparser.ConfigParser(interpolation=None)
        sheet.read(path)
        self.assertEqual(int(sheet["1017"]["ParameterValue"], 0), 300)
        # What was saved just now is no difference, and a PDO that differs stays valid.
        terminal.press("l")
        self.answer(terminal, "load from", str(path), erase=len("node.dcf"))
        terminal.wait_for("the node is as")
        self.load_a_pdo(terminal, path)
        self.write("900ms")
        for key, value in (("n", "900 ms"), ("y", "300 ms")):
            terminal.press("l")
            self.answer(terminal, "load from", str(path), erase=len("node.dcf"))
            self.wait_for_row(terminal, "1017h", "900 ms -> 300 ms")
            terminal.wait_for("to the node? y, n")
            self.assertEqual(self.read(), "900 ms", "nothing is written before the answer")
            terminal.press(key)
            self.assertTrue(terminal.comes_to(lambda lines: not any("->" in line for line in lines)))
            self.assertEqual(self.read(), value)

    def load_a_pdo(self, terminal, path):
        """Its event timer differs; a file says its COB-ID twice, invalid and then as it is (CiA 301, 7.5.2.38)."""
        cob_id = self.assert_done(run("read", BUS, "10", "1800:1"))
        before = self.assert_done(run("read", BUS, "10", "1800:5"))
        self.assert_done(run("write", BUS, "10", "1800:5", "321ms"))
        terminal.press("l")
        self.answer(terminal, "load from", str(path), erase=len("node.dcf"))
        terminal.wait_for("write these 1 to the node? y, n")
        terminal.wait_for("1800h:05h")
        terminal.press("y")
        terminal.wait_for("written")
        self.assertEqual(self.assert_done(run("read", BUS, "10", "1800:5")), before)
        self.assertEqual(self.assert_done(run("read", BUS, "10", "1800:1")), cob_id)

    def test_it_is_looked_at_and_changed_on_terminals_of_two_sizes(self):
        for columns, rows in ((80, 24), (200, 60)):
            with self.subTest(columns=columns):
                terminal = self.look_and_change(columns, rows)
                self.edit(terminal)
                self.save_and_load(terminal, self.folder / f"{columns}.dcf")
                terminal.press("q")
                self.assertTrue(terminal.is_over(), "q ends it")

    def test_a_node_that_is_gone_is_said_to_be_until_it_answers(self):
        terminal = Terminal(self.folder, 120, 24, CANVOY, "browse", BUS, "10", "--timeout", "1s")
        self.addCleanup(terminal.end)
        terminal.wait_for("q quit")
        self.device.terminate()
        self.device.wait()
        terminal.wait_for("no answer within 1.000s")
        # Objects that are opened are not asked for: they say nothing of the node. All rows are looked at once.
        until = time.monotonic() + 3
        while time.monotonic() < until:
            last = terminal.lines()[-1]
            self.assertIn("no answer within", last)
            self.assertNotIn("bytes", last)
        self.start()
        terminal.wait_for("q quit")

    def test_more_differences_than_the_terminal_has_rows_are_scrolled(self):
        path = self.folder / "changes.txt"
        path.write_text("1017 0 u16 1234\n1016 1 u32 0x000501F4\n")
        before = self.read()
        terminal = Terminal(self.folder, 80, 3, CANVOY, "browse", BUS, "10")
        self.addCleanup(terminal.end)
        terminal.wait_for("q quit")
        terminal.press("l")
        self.answer(terminal, "load from", str(path), erase=len("node.dcf"))
        terminal.wait_for("write these 2 to the node? y, n  (arrows show the others)")
        terminal.wait_for("-> 1234 ms")
        terminal.press("Down", "Down")
        self.assertNotIn("1234", "".join(terminal.wait_for("1016h:01h")))
        terminal.press("Up")
        terminal.wait_for("-> 1234 ms")
        terminal.press("n")
        terminal.wait_for("q quit")
        self.assertEqual(self.read(), before)


if __name__ == "__main__":
    if shutil.which("tmux") is None:
        print("skipped: tmux is missing; scripts/install-packages test installs it")
        sys.exit(77)
    own_network.enter_or_skip()
    unittest.main()
