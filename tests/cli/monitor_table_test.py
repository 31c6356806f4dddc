#!/usr/bin/env python3
"""canvoy monitor --table: of a log, at the end of a while, and on terminals of three sizes (tmux)."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.16:43119"
OTHER = "udp:239.74.163.16:43219"


class Terminal:
    """A terminal of its own, of so many columns and rows."""

    def __init__(self, folder, columns, rows, *command):
        self.socket = str(folder / f"tmux-{columns}")
        self.call("-f", "/dev/null", "new-session", "-d", "-x", str(columns), "-y", str(rows), " ".join(command))

    def call(self, *arguments):
        return subprocess.run(["tmux", "-S", self.socket, *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, timeout=30).stdout

    def lines(self):
        return self.call("capture-pane", "-p").splitlines()

    def press(self, *keys):
        self.call("send-keys", *keys)

    def wait_for(self, wanted):
        for _ in range(600):
            lines = self.lines()
            if any(wanted in line for line in lines):
                return lines
            time.sleep(0.1)
        raise AssertionError(f"{wanted!r} is not shown: {lines}")

    def comes_to(self, wanted):
        for _ in range(600):
            if wanted(self.lines()):
                return True
            time.sleep(0.1)
        return False

    def is_over(self):
        for _ in range(600):
            if self.call("list-sessions") == "":
                return True
            time.sleep(0.1)
        return False

    def end(self):
        self.call("kill-server")


class MonitorTable(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.log = str(cls.folder / "two.log")
        # A battery says 20 and then 20.125 degrees (CiA 418, 6010h in TPDO 1), on two buses.
        pathlib.Path(cls.log).write_text(
            "(0.000000) can0 70A#05\n(1.000000) can0 58A#4B106000A0000000\n(1.500000) can1 58A#4B106000A0000000\n(2.000000) can0 58A#4B106000A1000000\n(3.000000) can0 183#01\n")
        device = subprocess.Popen([CANVOY, "device", "battery", BUS], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(200):
            if run("read", BUS, "10", "1000").returncode == DONE:
                break
            time.sleep(0.1)

    def test_a_log_ends_in_a_row_for_each_object_of_each_bus(self):
        lines = [json.loads(line) for line in self.assert_done(run("monitor", self.log, "--table", "--json", "--node", "10=418")).splitlines()]
        rows = {(line["bus"], line.get("index")): line for line in lines}
        first = rows["can0", "6010"]
        self.assertEqual((first["value"], first["unit"], first["count"], first["age_s"], first["rate_hz"]), (20.125, "°C", 2, 1.0, 1.0))
        self.assertEqual(rows["can1", "6010"]["value"], 20.0)
        text = self.assert_done(run("monitor", self.log, "--table", "--node", "10=418"))
        self.assertRegex(text, r"(?m)^can0 +10 6010:00 +temperature +20\.125 °C +1\.0s +1\.00/s$")
        self.assertIn("not known: node 3. Say a profile, --node 3=418", text)
        self.assertLessEqual(max(map(len, text.splitlines()[:-1])), 80)

    def test_rows_may_be_frames_or_nodes(self):
        frames = [json.loads(line)["can_id"] for line in self.assert_done(run("monitor", self.log, "--table", "--by", "frame", "--json")).splitlines()]
        self.assertEqual(sorted(frames), ["183", "58A", "58A", "70A"])
        nodes = [json.loads(line) for line in self.assert_done(run("monitor", self.log, "--table", "--by", "node", "--json")).splitlines()]
        self.assertEqual(sorted(line.get("node", 0) for line in nodes), [3, 10, 10])

    def test_what_makes_no_sense_is_refused(self):
        self.assert_refused(run("monitor", self.log, "--by", "node"), USAGE, "--table")
        self.assert_refused(run("monitor", self.log, "--table", "--by", "colour"), USAGE, "colour")
        self.assert_refused(run("monitor", self.log, "--ask"), USAGE, "--ask")

    def test_whoever_joins_late_asks_the_nodes(self):
        told = self.assert_done(run("monitor", BUS, "--table", "--json", "--ask", "--for", "3s"))
        rows = [json.loads(line) for line in told.splitlines()]
        self.assertIn("Device type", [row.get("name") for row in rows])

    def test_nodes_are_asked_on_the_bus_that_they_are_on(self):
        for buses in (f"{OTHER},{BUS}", f"{BUS},{OTHER}"):
            told = self.assert_done(run("monitor", buses, "--json", "--ask", "--for", "2s"))
            frames = [json.loads(line) for line in told.splitlines()]
            self.assertIn("58A#43001000A2010000", [frame["frame"] for frame in frames if frame["bus"] == BUS], buses)
            self.assertEqual([frame for frame in frames if frame["bus"] != BUS], [], "nobody is on the other one")

    def test_several_buses_stand_in_one_table(self):
        text = self.assert_done(run("monitor", f"{OTHER},{BUS}", "--table", "--by", "frame", "--for", "3s"))
        self.assertIn("70A", text)

    def test_a_node_that_is_known_on_one_bus_is_unknown_on_another(self):
        log = self.folder / "known.log"
        log.write_text("(1.0) can0 58A#43001000A2010200\n(1.2) can1 18A#A00001\n(1.3) can0 18A#A00001\n")
        text = self.assert_done(run("monitor", str(log), "--table"))
        self.assertIn("not known: node can1:10. Say a profile, --node can1:10=418", text)
        text = self.assert_done(run("monitor", str(log), "--table", "--node", "can1:10=418"))
        self.assertNotIn("not known", text)

    @unittest.skipIf(shutil.which("tmux") is None, "tmux is not installed")
    def test_it_fits_terminals_of_three_sizes_and_heeds_keys(self):
        for columns, rows in ((80, 24), (200, 60), (40, 8)):
            terminal = Terminal(self.folder, columns, rows, CANVOY, "monitor", BUS, "--table", "--ask")
            try:
                lines = terminal.wait_for("10")
                self.assertLessEqual(max(map(len, lines)), columns)
                self.assertIn("q quit", terminal.wait_for("q quit")[-1])
                if columns == 80:
                    terminal.press("/")
                    terminal.press("-l", "heart")
                    terminal.press("Enter")
                    terminal.wait_for("search: heart")
                    self.assertEqual([line for line in terminal.lines() if "Device type" in line], [])
                    terminal.press("s")
                    terminal.wait_for("sort: name")
                    terminal.press("Space")
                    terminal.wait_for("PAUSED")
                    terminal.call("resize-window", "-x", "100", "-y", "30")
                    self.assertTrue(terminal.comes_to(lambda lines: len(lines) == 30 and "q quit" in lines[-1]), "it is drawn anew")
                terminal.press("q")
                self.assertTrue(terminal.is_over(), "q ends it")
            finally:
                terminal.end()


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
