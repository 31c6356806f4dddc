#!/usr/bin/env python3
"""What the main verbs print, word for word: as it stands in tests/cli/approved, which somebody has read with the clause at hand.

    CANVOY_APPROVE=1 ctest --preset release -R cli.approved    writes the files anew: read what has changed
"""

import difflib
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

APPROVED = pathlib.Path(__file__).resolve().parent / "approved"
BUS = "udp:239.74.163.28:43128"


class Approved(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        (cls.folder / "changes.txt").write_text("1017 0 u16 700\n1016 1 u32 0x000501F4\n")
        device = subprocess.Popen([CANVOY, "device", "battery", BUS, "--serial-number", "7"], stdout=subprocess.DEVNULL)
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(200):
            if run("read", BUS, "10", "1000").returncode == DONE:
                return
            time.sleep(0.1)

    def compare(self, name, *lines):
        """Each of the command lines with all that it prints, against the file."""
        text = ""
        for line in lines:
            words = [str(APPROVED / word) if word.endswith(".log") else word.replace("BUS", BUS) for word in line]
            done = run(*words, cwd=self.folder)
            shown = " ".join(f"'{word}'" if " " in word else word for word in line)
            output = (done.stdout + done.stderr).replace(BUS, "BUS").replace(str(APPROVED) + "/", "")
            text += f"$ canvoy {shown}\n{output}[{done.returncode}]\n"
        path = APPROVED / f"{name}.txt"
        if os.environ.get("CANVOY_APPROVE"):
            path.write_text(text)
        wanted = path.read_text()
        difference = "\n".join(difflib.unified_diff(wanted.splitlines(), text.splitlines(), "approved", "now", lineterm=""))
        self.assertEqual(difference, "", f"{path}: read both; CANVOY_APPROVE=1 writes it anew\n{difference}")

    def test_decode(self):
        self.compare("decode", ("decode", "small.log"), ("decode", "small.log", "--node", "10=418"), ("decode", "small.log", "--filter", "SDO and temperature"))

    def test_monitor_table(self):
        self.compare("monitor-table", ("monitor", "small.log", "--table"), ("monitor", "small.log", "--table", "--by", "frame"), ("monitor", "small.log", "--table", "--by", "node"))

    def test_scan(self):
        self.compare("scan", ("scan", "BUS"))

    def test_read_and_write(self):
        self.compare("read-write",
                     ("read", "BUS", "10", "temperature"), ("read", "BUS", "10", "1018:4", "battery_parameters:ah_capacity", "6000"), ("read", "BUS", "10", "6001:7"),
                     ("read", "BUS", "10", "tempersture"), ("read", "BUS", "10", "state_of_charge"), ("read", "BUS", "11", "1000", "--timeout", "100ms"),
                     ("write", "BUS", "10", "1017", "500ms"), ("write", "BUS", "10", "1017", "500.5"), ("write", "BUS", "10", "temperature", "20"), ("write", "BUS", "10", "1017", "1000ms"))  # fmt: skip

    def test_configure_diff(self):
        self.compare("configure-diff", ("configure", "BUS", "10", "changes.txt", "--diff"))

    def test_run_charger(self):
        self.compare("run-charger", ("run", "charger", "--for", "8h", "--seed", "1"))


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
