#!/usr/bin/env python3
"""Logs that are written while somebody follows them (`tail -f`), and when the terminal goes away."""

import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request

from command import CANVOY, DONE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.10:43120"
PATIENCE = 60  # seconds
LINE = re.compile(rb"\(\d{10}\.\d{6}\) \S+ [0-9A-F]{3}#[0-9A-FR]*")


class Log(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.log = self.folder / "bus.log"

    def start(self, *arguments, **options):
        """Until it has printed its first line, which is returned."""
        program = subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, text=True, **options)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program, program.stdout.readline()

    def start_monitor(self, **options):
        program, _ = self.start("device", "battery", BUS, "--node-id", "10")  # that there is a first line
        monitor, _ = self.start("monitor", BUS, "--log", str(self.log), **options)
        program.kill()
        return monitor

    def wait_for(self, text, path=None):
        """Until the log has it, while the command runs."""
        give_up = time.monotonic() + PATIENCE
        while text not in (path or self.log).read_bytes():
            self.assertLess(time.monotonic(), give_up, "who follows the log does not see it")
            time.sleep(0.01)

    def assert_whole(self):
        for line in self.log.read_bytes().splitlines():
            self.assertRegex(line, LINE)
        self.assertTrue(self.log.read_bytes().endswith(b"\n"))

    def test_who_follows_the_log_of_a_monitor_sees_it_grow(self):
        self.start_monitor()
        self.assert_done(run("send", BUS, "7A0#01"))
        self.wait_for(b" 7A0#01\n")
        self.assert_done(run("send", BUS, "7A0#02"))
        self.wait_for(b" 7A0#02\n")

    def test_who_follows_the_log_of_a_page_sees_it_grow(self):
        self.start("view", BUS, "--record", str(self.log))
        self.assert_done(run("send", BUS, "7A0#01"))
        self.wait_for(b" 7A0#01\n")

    def test_who_follows_the_log_of_a_run_sees_it_grow(self):
        for arguments in (["--speed", "1"], ["--speed", "1", "--web", "0"]):
            self.start("run", "charger", "--for", "1h", "--log", str(self.log), *arguments)
            self.wait_for(b" 705#05\n")

    def test_who_follows_what_is_recorded_at_the_page_sees_it_grow(self):
        _, url = self.start("run", "charger", "--web", "0", "--speed", "1", "--allow-record", str(self.folder))
        page, _, token = url.strip().partition("?token=")
        request = urllib.request.Request(page + "api/run/record", json.dumps({"on": True}).encode(),
                                         {"Content-Type": "application/json", "Authorization": f"Bearer {token}"})  # fmt: skip
        with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
            self.assertEqual(answer.status, 200)
        self.wait_for(b" 705#05\n", self.folder / "canvoy-1.log")

    def test_a_terminal_that_goes_away_loses_nothing(self):
        monitor = self.start_monitor()
        self.assert_done(run("send", BUS, "7A0#01"))
        while "7A0#01" not in monitor.stdout.readline():
            continue
        monitor.send_signal(signal.SIGHUP)
        monitor.send_signal(signal.SIGHUP)  # the terminal tells it, and then the shell
        monitor.communicate(timeout=PATIENCE)
        self.assertEqual(monitor.returncode, DONE)
        self.assertIn(b" 7A0#01\n", self.log.read_bytes())
        self.assert_whole()

    def test_a_run_whose_terminal_goes_away_ends_with_a_whole_log(self):
        for arguments in ([], ["--web", "0"]):
            program, _ = self.start("run", "charger", "--for", "1000h", "--speed", "1", "--log", str(self.log), *arguments)
            self.wait_for(b" 705#05\n")
            program.send_signal(signal.SIGHUP)
            program.send_signal(signal.SIGHUP)
            program.communicate(timeout=PATIENCE)
            self.assertEqual(program.returncode, DONE)
            self.assert_whole()

    def test_nohup_is_heeded(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        monitor = self.start_monitor(preexec_fn=ignore)
        monitor.send_signal(signal.SIGHUP)
        self.assert_done(run("send", BUS, "7A0#01"))
        self.wait_for(b" 7A0#01\n")
        program, _ = self.start("run", "charger", "--for", "1h", "--speed", "1", "--log", str(self.log), preexec_fn=ignore)
        program.send_signal(signal.SIGHUP)
        self.wait_for(b" 705#05\n")
        self.assertIsNone(program.poll())


if __name__ == "__main__":
    own_network.enter_or_skip()
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # whoever runs the tests by nohup
    unittest.main()
