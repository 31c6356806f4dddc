#!/usr/bin/env python3
"""`canvoy run lift` from outside: what it prints, what decides its log, and how it ends."""

import json
import pathlib
import tempfile
import unittest

from command import FAILED, USAGE, CommandTest, run

SMALL = ["run", "lift", "--floors", "5", "--for", "3min"]


class RunLift(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def log_of(self, *arguments):
        path = self.folder / "bus.log"
        self.assert_done(run(*arguments, "--log", str(path)))
        return path.read_bytes()

    def test_people_are_carried_and_all_invariants_hold(self):
        output = self.assert_done(run(*SMALL, "--seed", "3", "--percent", "12"))
        self.assertIn("lift1: lift-drive (2): NMT state operational", output)
        self.assertRegex(output, r"3min simulated: [1-9]\d* came, [1-9]\d* were carried, 0 gave up")
        self.assertNotIn("FAIL", output)

    def test_who_began_to_wait_in_a_fault_gives_up_because_of_it(self):
        # Patience is 10 to 20 min: some give up five minutes after the fault and later, whom its crowd kept from a car.
        output = self.assert_done(run("run", "lift", "--fault", "babbling-node@1min+50min"))
        self.assertRegex(output, r"1h simulated: \d+ came, \d+ were carried, 2\d\d gave up")
        self.assertNotIn("FAIL", output)

    def test_what_print_shows_is_played_as_the_built_in_network(self):
        chosen = [*SMALL, "--seed", "7", "--traffic", "lunch", "--fault", "lost-node@1min+10s"]
        printed = self.assert_done(run(*chosen, "--print"))
        path = self.folder / "house.toml"
        path.write_text(printed)
        self.assertEqual(self.assert_done(run("run", str(path), "--print")), printed)
        self.assertEqual(self.log_of("run", str(path)), self.log_of(*chosen))

    def test_another_seed_gives_another_log(self):
        self.assertNotEqual(self.log_of(*SMALL, "--seed", "1"), self.log_of(*SMALL, "--seed", "2"))

    def test_people_come_as_a_list_says(self):
        people = self.folder / "people.csv"
        people.write_text("seconds,from,to,kg\n10,1,4,80\n10,3,1\n")
        output = self.assert_done(run(*SMALL, "--people", str(people)))
        self.assertIn("2 came, 2 were carried", output)
        people.write_text("10,1,9\n")
        result = run(*SMALL, "--people", str(people))
        self.assertEqual((result.returncode, result.stdout), (FAILED, ""))
        self.assertIn("people.csv line 1: '9' is no floor from 1 to 5", result.stderr)

    def test_every_line_of_json_is_an_object_and_the_last_says_what_held(self):
        output = self.assert_done(run(*SMALL, "--json"))
        objects = [json.loads(line) for line in output.splitlines()]
        self.assertTrue(any("lifts" in entry and len(entry["lifts"]) == 1 for entry in objects))
        self.assertIs(objects[-1]["all_held"], True)

    def test_what_makes_no_sense_is_refused_in_one_line(self):
        for arguments, expected in [
            (["--lifts", "9"], "--lifts"),
            (["--people", "list.csv", "--traffic", "lunch"], "--traffic excludes --people"),
            (["--people", "list.csv", "--percent", "3"], "--percent excludes --people"),
            (["--floors", "1"], "--floors"),
            (["--traffic", "rush"], "'rush' is no traffic: up-peak, down-peak, interfloor, lunch"),
            (["--fault", "flood@1s"], "no such fault; there are lost-node"),
            (["--fault", "lost-node:lift=2@1s"], "fault lost-node: there is no lift 2"),
            (["--fault", "cable-cut:node=99@1s"], "fault cable-cut: lift 1 has no node 99"),
            (["--fault", "stuck-button:floor=6@1s"], "fault stuck-button: the floor is not there"),
            (["--fault", "light-barrier:node=9@1s"], "fault light-barrier: it has no node"),
            (["--fault", "dead-encoder:floor=2@1s"], "fault dead-encoder: it has no floor"),
            (["--fault", "finger-protector:node=9@1s"], "node 9 of lift 1 is no lift-door"),
            (["--fault", "door-lock:node=99@1s"], "fault door-lock: lift 1 has no node 99"),
            (["--fault", "brake:node=2@1s"], "fault brake: it has no node"),
            (["--fault", "rope-slip:floor=2@1s"], "fault rope-slip: it has no floor"),
            (["--fault", "smoke:group@1s", "--lifts", "2"], "it is no fault of a group"),
            (["--fault", "lost-node:group@1s"], "fault lost-node: there is no group"),
            (["--fault", "fire-brigade:group@1s", "--lifts", "2"], "it is no fault of a group"),
            (["--fault", "babbling-node:node=x@1s"], "'x' is no number from 1 to 127"),
            (["--fault", "fire-alarm"], "when? write fire-alarm@20min"),
            (["--fault", "lost-node@4min"], "begins after the end"),
        ]:
            with self.subTest(arguments=arguments):
                result = run(*SMALL, *arguments)
                self.assertEqual((result.returncode, result.stdout), (USAGE, ""))
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                self.assertIn(expected, result.stderr)


if __name__ == "__main__":
    unittest.main()
