#!/usr/bin/env python3
"""`canvoy run charger` from outside: what decides its log, what it prints, and how it ends."""

import json
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest

from command import CANVOY, DONE, CommandTest, run

FAULTS = [
    "heartbeat-loss",
    "pdo-loss",
    "battery-silent",
    "battery-restart",
    "not-ready",
    "too-hot",
    "too-cold",
    "invalid-temperature",
    "invalid-voltage",
    "pilot-loss",
    "cable-cut",
    "corrupted-frames",
    "babbling-node",
    "duplicate-node-id",
    "wrong-bit-rate",
    "clock-drift",
]


class RunCharger(CommandTest):
    """A network in virtual time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def log_of(self, name, *arguments):
        path = self.folder / name
        self.assert_done(run("run", "charger", "--log", str(path), *arguments))
        return path.read_bytes()

    def test_the_same_seed_gives_the_same_log_and_another_seed_another(self):
        arguments = ["--for", "5min", "--fault", "corrupted-frames@1min", "--seed"]
        first = self.log_of("first.log", *arguments, "1")
        self.assertGreater(first.count(b"\n"), 1000)
        self.assertEqual(first, self.log_of("again.log", *arguments, "1"))
        self.assertNotEqual(first, self.log_of("other.log", *arguments, "2"))

    def test_the_same_seed_prints_the_same(self):
        arguments = ["run", "charger", "--for", "5min", "--fault", "corrupted-frames@1min"]
        for form in ([], ["--json"]):
            self.assertEqual(self.assert_done(run(*arguments, *form)), self.assert_done(run(*arguments, *form)))

    def test_the_log_is_one_of_candump_in_the_order_of_time(self):
        lines = self.log_of("bus.log", "--for", "2min").decode("ascii").splitlines()
        times = []
        for line in lines:
            found = re.fullmatch(r"\((\d{10}\.\d{6})\) sim0 [0-9A-F]{3}#(R\d?|([0-9A-F]{2}){0,8})", line)
            self.assertTrue(found, line)
            times.append(float(found.group(1)))
        self.assertEqual(times, sorted(times))
        self.assertLess(times[-1], 120)
        self.assertGreater(times[-1], 119)

    def test_every_line_of_json_is_an_object_and_the_last_says_what_held(self):
        output = self.assert_done(run("run", "charger", "--for", "10min", "--json"))
        objects = [json.loads(line) for line in output.splitlines()]
        self.assertTrue(all(isinstance(entry, dict) for entry in objects))
        self.assertGreaterEqual(len(objects), 10)
        summary = objects[-1]
        self.assertIs(summary["all_held"], True)
        self.assertGreater(summary["charge_ah"], 5)
        self.assertAlmostEqual(summary["charge_ah"], summary["plant"]["charge_ah"], delta=0.1)

    def test_a_whole_night_ends_with_all_invariants_held(self):
        output = self.assert_done(run("run", "charger", "--for", "8h", "--seed", "1"))
        self.assertTrue("a charge begins" in output and "the battery is full" in output, output[-1000:])

    def test_each_fault_alone_breaks_no_invariant(self):
        for fault in FAULTS:
            for end in ("", "+2min"):
                with self.subTest(fault=fault + end):
                    result = run("run", "charger", "--for", "10min", "--fault", f"{fault}@4min{end}")
                    self.assertEqual((result.stderr, result.returncode), ("", DONE), result.stdout[-1000:])
                    self.assertTrue(f"FAULT begins: {fault}" in result.stdout, "the fault is not told of")

    def test_all_faults_are_listed_where_one_is_unknown(self):
        listed = run("run", "charger", "--fault", "earthquake@1min").stderr.partition("there are ")[2]
        self.assertEqual(listed.strip().split(", "), FAULTS)

    def test_an_interrupted_run_ends_with_its_summary_and_a_whole_log(self):
        log = self.folder / "bus.log"
        arguments = ["run", "charger", "--for", "1000h", "--speed", "1", "--log", str(log)]
        with subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, text=True) as process:
            process.stdout.readline()
            time.sleep(0.2)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)
        self.assertEqual(process.returncode, DONE)
        self.assertTrue(log.read_bytes().endswith(b"\n"))


if __name__ == "__main__":
    unittest.main()
