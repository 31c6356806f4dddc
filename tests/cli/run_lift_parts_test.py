#!/usr/bin/env python3
"""`canvoy run FILE` with the drive and the position unit of a lift as processes of their own on a real bus."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.22:43122"


class RunLiftParts(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def network(self):
        """A lift with one passenger, of which two devices are elsewhere."""
        text = self.assert_done(run("run", "lift", "--lifts", "1", "--floors", "5", "--print"))
        for before, after in [
            ('# real = "can0"', f'real = "{BUS}"'),
            ('device = "drive"', 'device = "drive"\nplayed = false'),
            ('device = "position"', 'device = "position"\nplayed = false'),
            ("# list =", "list ="),
        ]:
            self.assertIn(before, text)
            text = text.replace(before, after, 1)
        (self.folder / "people.csv").write_text("seconds,from,to,kg\n2,3,1,75\n")
        path = self.folder / "house.toml"
        path.write_text(text)
        return str(path)

    def test_brings_a_passenger_down_by_a_drive_and_an_encoder_on_the_bus(self):
        parts = [
            subprocess.Popen([CANVOY, "device", kind, "--bus", BUS], stdout=subprocess.PIPE, text=True)
            for kind in ("lift-drive", "lift-position")
        ]
        try:
            result = run("run", self.network(), "--for", "50s", "--json")
        finally:
            told = []
            for part in parts:
                part.terminate()
                told.append(part.communicate(timeout=60)[0])
        self.assertIn("lift-drive node 2 (02h): operational", told[0])
        self.assertIn("lift-position node 4 (04h): operational", told[1])
        self.assertIn("stops at floor 3", result.stdout, result.stderr)
        self.assertIn("stops at floor 1", result.stdout, result.stderr)
        self.assertIn('"served":1', result.stdout)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
