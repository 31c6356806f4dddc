#!/usr/bin/env python3
"""`canvoy run FILE`: networks that files describe, and real devices in them."""

import itertools
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, FAILED, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.21:43121"


class RunFile(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, text):
        path = self.folder / "network.toml"
        path.write_text(text)
        return str(path)

    def log_of(self, *arguments):
        path = self.folder / "bus.log"
        self.assert_done(run("run", *arguments, "--log", str(path)))
        return path.read_bytes()

    def test_what_print_shows_is_played_as_the_built_in_network(self):
        chosen = ["charger", "--for", "2min", "--seed", "7", "--ambience", "-3.5", "--fault", "pdo-loss@1min+10s"]
        printed = self.assert_done(run("run", *chosen, "--print"))
        path = self.file(printed)
        self.assertEqual(self.log_of(path), self.log_of(*chosen))
        self.assertEqual(self.assert_done(run("run", path, "--print")), printed)

    def test_the_command_line_goes_before_the_file(self):
        path = self.file('network = "charger"\nfor = "8h"\n')
        output = self.assert_done(run("run", path, "--for", "1min", "--fault", "not-ready@10s+5s"))
        self.assertTrue("FAULT begins: not-ready" in output and "\n1min simulated" in output, output)

    def test_a_file_that_is_wrong_is_refused_with_its_line(self):
        for text, expected in [
            ("network = 'boat'", "network.toml line 1: network: 'boat' is not known"),
            ("seed = 1", "network.toml line 1: write which network it is"),
            ("network = 'charger'\nfoo = 1", "network.toml line 2: foo: is not known here"),
            ("network = 'charger'\nfaults = ['a@1s']", "line 2: faults: fault 'a@1s'"),
            ("network = 'charger'\n[battery]\nid = 5", "two nodes have one node-ID"),
            ("network = 'charger'\n[battery]\nplayed = false", "who is not played is on a real bus"),
            ("network = 'charger'\n[bus]\nreal = 'sim'", "line 3: real: sim"),
            ("network = ", "line 1: Error while parsing"),
        ]:
            with self.subTest(text=text):
                result = run("run", self.file(text))
                self.assertEqual((result.returncode, result.stdout), (FAILED, ""))
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                self.assertIn(expected, result.stderr)

    def test_a_battery_on_a_real_bus_is_charged_by_a_simulated_charger(self):
        path = self.file(f'network = "charger"\n[bus]\nreal = "{BUS}"\n[battery]\nplayed = false\n')
        battery = subprocess.Popen(
            [CANVOY, "device", "battery", "--node-id", "10", BUS], stdout=subprocess.PIPE, text=True
        )
        try:
            output = self.assert_done(run("run", path, "--for", "8s"))
        finally:
            battery.terminate()
            told, _ = battery.communicate(timeout=60)
        self.assertIn("charger: a charge begins", output)
        self.assertIn("battery node 10 (0Ah): operational", told)

    def test_behind_a_pause_of_the_machine_nobody_on_a_real_bus_is_hurried(self):
        for name, options in {"run": ["--json"], "page": ["--web"]}.items():
            with self.subTest(name):
                self.check_that_heartbeats_keep_their_period(name, options)

    def check_that_heartbeats_keep_their_period(self, name, options):
        path = self.file(f'network = "charger"\n[bus]\nreal = "{BUS}"\n')
        log = self.folder / f"{name}.log"
        recorder = subprocess.Popen([CANVOY, "record", BUS, str(log)], stdout=subprocess.DEVNULL)
        player = subprocess.Popen([CANVOY, "run", path, "--for", "600s", *options], stdout=subprocess.DEVNULL)

        def beats_after(count):
            """The times of heartbeats, once there are more than so many."""
            while True:
                self.assertIsNone(player.poll())
                self.assertIsNone(recorder.poll())
                lines = log.read_text().splitlines()[:-1] if log.exists() else []
                beats = [float(line[1:].partition(")")[0]) for line in lines if " 705#05" in line]
                if len(beats) > count:
                    return beats
                time.sleep(0.05)

        try:
            before = len(beats_after(1))
            player.send_signal(signal.SIGSTOP)
            time.sleep(2.5)
            player.send_signal(signal.SIGCONT)
            beats = beats_after(before + 5)
        finally:
            recorder.kill()
            player.kill()
            player.wait()
        gaps = [later - earlier for earlier, later in itertools.pairwise(beats)]
        self.assertGreater(max(gaps), 2.5, "it was stopped")
        self.assertGreater(min(gaps), 0.3, "a period is 1 s, and half a second is caught up with")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
