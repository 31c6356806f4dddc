#!/usr/bin/env python3
"""`canvoy device`: the catalogue, and each device of it as a process."""

import json
import tempfile
import unittest

from command import CommandTest, run


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


if __name__ == "__main__":
    unittest.main()
