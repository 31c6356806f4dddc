#!/usr/bin/env python3
"""What the verdict of a world's run rests on: each rule has been decided, and a fault that was not mended is told."""

import json
import unittest

from command import CommandTest, run


class Verdicts(CommandTest):
    def test_a_run_without_faults_decides_all_that_it_lists(self):
        """Each rule is one that the run could have broken; what takes an occasion of its own is listed once it was there."""
        runs = [
            ["charger", "--for", "20min"],
            ["charger", "--chargers", "2", "--batteries", "3", "--battery", "lithium,plain", "--goal", "80@06:00"],
            ["lift", "--for", "10min"],
            ["lift", "--lifts", "3", "--floors", "6", "--destination-control", "--for", "20min"],
            ["excavator", "--for", "5min"],
            ["taxi", "--for", "3h"],
            ["police", "--for", "3h"],
            ["bus", "--for", "45min"],
        ]
        self.assertEqual({world for world, *_ in runs}, set(self.worlds()))
        for arguments in runs:
            with self.subTest(" ".join(arguments)):
                *_, summary = self.assert_told(run("run", *arguments, "--json", "--require-decided"))
                self.assertEqual([each for each in summary["invariants"] if not each["decided"]], [])
                self.assertTrue(summary["all_held"] and summary["all_decided"])
                self.assertTrue(all(each["bound"] for each in summary["invariants"]))
                self.assertEqual(summary["faults_left"], [])

    def test_a_fault_that_is_not_mended_is_told_at_the_end(self):
        for world, fault, lasted in (
            ("charger", "heartbeat-loss@4min", "6min"),
            ("lift", "dead-encoder@4min", "6min"),
            ("excavator", "stuck-axis:axis=2@4min", "6min"),
            ("taxi", "lost-node:node=5@4min", "6min"),
            ("police", "lost-node:node=5@4min", "6min"),
            ("bus", "lost-node:node=5@4min", "6min"),
        ):
            with self.subTest(world):
                mended = ["--fault", fault.replace("4min", "1min+1min")]
                result = run("run", world, "--for", "10min", "--fault", fault, *mended)
                notes = [line for line in result.stdout.splitlines() if line.startswith("  NOTE  ")]
                self.assertEqual(notes, [f"  NOTE  {fault} was not mended, and is there for {lasted}: what it can cause is excused"])
                *_, summary = [json.loads(line) for line in run("run", world, "--for", "10min", "--fault", fault, *mended, "--json").stdout.splitlines()]
                self.assertEqual(summary["faults_left"], [{"fault": fault, "since": 240.0, "lasted": 360.0, "excused": True}])


if __name__ == "__main__":
    unittest.main()
