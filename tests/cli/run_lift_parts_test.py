#!/usr/bin/env python3
"""`canvoy run FILE` with devices of a lift as processes of their own on a real bus."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network
import side_by_side

BUSES = side_by_side.buses("udp:239.74.163.22", 43122)


class RunLiftParts(CommandTest):
    def setUp(self):
        self.bus = next(BUSES)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def network(self, *elsewhere):
        """A lift with one passenger, of which these devices are elsewhere."""
        text = self.assert_done(run("run", "lift", "--lifts", "1", "--floors", "5", "--print"))
        changes = [
            (kind, f"{kind}\nplayed = false") if "=" in kind else (f'device = "{kind}"', f'device = "{kind}"\nplayed = false')
            for kind in elsewhere
        ]
        for before, after in [('# real = "can0"', f'real = "{self.bus}"'), ("# list =", "list ="), *changes]:
            self.assertIn(before, text)
            text = text.replace(before, after, 1)
        (self.folder / "people.csv").write_text("seconds,from,to,kg\n2,3,1,75\n")
        path = self.folder / "house.toml"
        path.write_text(text)
        return str(path)

    def play(self, network, devices, *arguments):
        """What the rest says, and what each process of devices has said."""
        parts = [
            subprocess.Popen([CANVOY, "device", *device, self.bus], stdout=subprocess.PIPE, text=True)
            for device in devices
        ]
        try:
            result = run("run", network, "--json", *arguments)
        finally:
            told = []
            for part in parts:
                part.terminate()
                told.append(part.communicate(timeout=60)[0])
        self.assertEqual(result.stderr, "")
        return result.stdout, told

    def assert_served(self, output):
        self.assertIn("stops at floor 3", output)
        self.assertIn("stops at floor 1", output)
        self.assertIn('"served":1', output)

    def test_brings_a_passenger_down_by_a_drive_and_an_encoder_on_the_bus(self):
        network = self.network("lift-drive", "lift-position")
        output, told = self.play(network, [["lift-drive"], ["lift-position"]], "--for", "60s")
        self.assertIn("lift-drive node 2 (02h): operational", told[0])
        self.assertIn("lift-position node 4 (04h): operational", told[1])
        self.assert_served(output)

    def test_a_passenger_boards_through_a_door_on_the_bus_past_a_light_barrier_and_onto_a_scale(self):
        network = self.network("lift-door", "lift-light-barrier", "lift-load")
        units = [["lift-door"], ["lift-light-barrier"], ["lift-load"]]
        output, told = self.play(network, units, "--for", "60s")
        for line, text in zip(["lift-door node 6", "lift-light-barrier node 9", "lift-load node 13"], told):
            self.assertRegex(text, line + r" \(0.h\): operational")
        self.assert_served(output)

    def test_a_scale_that_weighs_too_much_keeps_the_car_at_its_floor(self):
        network = self.network("lift-load")
        output, _ = self.play(network, [["lift-load", "--load", "1200@1s"]], "--for", "15s")
        self.assertNotIn("stops at floor", output)
        self.assertIn('"load_kg":1100', output, "so much it is at least, since the scale says so")
        self.assertIn('"served":0', output)

    def test_who_stands_in_a_door_on_the_bus_keeps_it_open(self):
        network = self.network("lift-door", "lift-light-barrier")
        units = [["lift-door", "lift-light-barrier", "--in-door", "1s+1h"]]
        output, _ = self.play(network, units, "--for", "25s")
        self.assertIn("is open at floor 3", output)
        self.assertNotIn("stops at floor 1", output)

    def test_a_hand_on_a_panel_on_the_bus_calls_the_car_for_a_passenger(self):
        network = self.network("floors = [3]")
        panel = ["lift-landing-panel", "--node-id", "23", "--floor", "3", "--floors", "5", "--press", "down@10s"]
        output, told = self.play(network, [panel], "--for", "60s")
        self.assertIn("lift-landing-panel: Standard hall call acknowledgement 2: on", told[0])
        self.assert_served(output)

    def test_panels_and_people_are_left_where_all_else_is_on_the_bus(self):
        kinds = ["lift-controller", "lift-drive", "lift-position", "lift-door", "lift-light-barrier", "lift-load"]
        devices = [kind if kind.startswith("lift-") else f"lift-{kind}" for kind in kinds]
        network = self.network(*kinds)
        output, told = self.play(network, [[*devices, "--floors", "5"]], "--for", "60s")
        self.assertIn("lift-controller node 1 (01h): operational", told[0])
        self.assert_served(output)

    def test_says_what_is_wrong_with_a_unit(self):
        for arguments, *parts in [
            (["lift-door", "--door", "5"], "--door", "1 to 4"),
            (["lift-door", "--in-door", "5s"], "--in-door", "'5s'", "20s+5s"),
            (["lift-load", "--load", "heavy@5s"], "--load", "'heavy@5s'", "300@10s"),
            (["lift-load", "--load", "300"], "--load", "'300'", "300@10s"),
            (["lift-load", "--store", "x"], "lift-load keeps nothing"),
            (["lift-controller", "--node-id", "lss"], "lift-controller gets no node-ID by LSS"),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(run("device", *arguments, "sim", "--for", "1s"), USAGE, *parts)


def load_tests(loader, tests, pattern):
    return side_by_side.Suite(tests)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
