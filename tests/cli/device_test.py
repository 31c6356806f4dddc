#!/usr/bin/env python3
"""`canvoy device`: the catalogue, and each device of it as a process."""

import json
import subprocess
import tempfile
import unittest

from command import CANVOY, USAGE, CommandTest, run


class Device(CommandTest):
    def catalogue(self):
        return [json.loads(line) for line in self.assert_done(run("device", "--list", "--json")).splitlines()]

    def test_the_catalogue_is_for_people_and_for_programs(self):
        devices = self.catalogue()
        load = next(device for device in devices if device["name"] == "lift-load")
        self.assertEqual(
            load,
            {
                "name": "lift-load",
                "title": "load measuring unit of a car",
                "profile": "417-4",
                "virtual_devices": ["load measuring unit"],
                "node_id": 13,
            },
        )
        lines = self.assert_done(run("device", "--list")).splitlines()
        self.assertEqual([line.split()[0] for line in lines], [device["name"] for device in devices])

    def test_each_device_runs_and_has_a_data_sheet(self):
        with tempfile.TemporaryDirectory() as folder:
            for device in self.catalogue():
                name = device["name"]
                store = ["--store", f"{folder}/{name}"] if name == "bootloader" else []
                said = self.assert_done(run("device", name, "sim", "--for", "300ms", *store))
                self.assertIn(f"{name} node {device['node_id']} ({device['node_id']:02X}h): pre-operational", said)
                said = self.assert_done(run("device", name, "sim", "--node-id", "99", "--for", "50ms", *store))
                self.assertIn(f"{name} node 99 (63h)", said)
                sheet = f"{folder}/{name}.eds"
                self.assert_done(run("eds", "export", name, "--out", sheet))
                checked = self.assert_done(run("eds", "check", sheet, "--profile", device["profile"]))
                self.assertIn("0 errors, 0 warnings", checked, name)

    def test_who_starts_himself_does(self):
        said = self.assert_done(run("device", "lift-controller", "sim", "--for", "1s"))
        self.assertIn("lift-controller node 1 (01h): operational", said)

    def test_hands_are_listed_refused_with_what_there_is_and_taken_from_stdin(self):
        paper = next(json.loads(line) for line in self.assert_done(run("device", "printer", "--hands", "--json")).splitlines())
        self.assertEqual((paper["name"], paper["changes"], paper["clause"]), ("paper", "60E1h", "4.2.13.2"))
        result = run("device", "terminal", "sim", "--press", "13@1s")
        self.assertEqual(result.returncode, USAGE)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("there is key-1, ", result.stderr)
        self.assert_done(run("device", "terminal", "sim", "--press", "1@100ms", "--for", "200ms"))
        lines = "sign-on\n\n# a passenger\nhire@100ms\nshout\nsupplement=2.50@200ms\n"
        command = [CANVOY, "device", "taximeter", "sim", "--stdin", "--for", "400ms"]
        result = subprocess.run(command, input=lines, capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 1)
        self.assertTrue(result.stderr.startswith("canvoy: standard input: line 5: 'shout"), result.stderr)
        fares = [float(line.rsplit(" ", 1)[1]) for line in result.stdout.splitlines() if ": hired, " in line]
        self.assertAlmostEqual(fares[1] - fares[0], 2.50)


if __name__ == "__main__":
    unittest.main()
