#!/usr/bin/env python3
"""One emulated machine serves many commands: none hears, sees or leaves anything of another.

    tests/vm/shared_test.py
"""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

SOCKETCAN_VM = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "socketcan-vm"
PATIENCE = 120  # seconds
TIMED_OUT, SKIPPED = 124, 77
# Goes on for ever in processes of its own, and shows that it does.
ENDLESS = "setsid bash -c 'while sleep 0.3; do echo $RANDOM$RANDOM >beat; done' & wait"


def words(*arguments):
    return [SOCKETCAN_VM, *arguments]


class Shared(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "cwd": self.folder}
        return subprocess.Popen(words(*arguments), **options)

    def run_to_end(self, *arguments):
        program = self.start(*arguments)
        printed, errors = program.communicate(timeout=PATIENCE * 3)
        return program.returncode, printed, errors

    def until(self, what, holds):
        give_up = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), give_up, what)
            time.sleep(0.1)

    def beats(self):
        """Whether the endless command of this folder runs."""
        beat = self.folder / "beat"
        before = beat.read_text() if beat.exists() else None
        self.until("a beat", lambda: beat.exists() and beat.read_text() not in ("", before))

    def is_silent(self):
        """It would beat some times while another command runs."""
        last = (self.folder / "beat").read_text()
        self.run_to_end("sleep", "2")
        return (self.folder / "beat").read_text() == last

    def test_output_and_status_are_those_of_the_command(self):
        status, printed, errors = self.run_to_end("sh", "-c", "echo 'one  word'; ls /sys/class/net; echo other >&2; exit 5")
        self.assertEqual((status, printed, errors), (5, "one  word\nlo\nvcan0\nvcan1\n", "other\n"))

    def test_a_bus_is_heard_by_its_own_command_only(self):
        listening = self.start("sh", "-c", "candump -L vcan0 & while ! [ -e end ]; do sleep 0.3; done; kill $!")
        self.assertEqual(self.run_to_end("cangen", "vcan0", "-I", "123", "-g", "50", "-n", "40")[0], 0)
        (self.folder / "end").touch()
        self.assertEqual(listening.communicate(timeout=PATIENCE)[0], "")

    def test_controllers_are_there_for_who_asks_and_again_for_the_next(self):
        for _ in range(2):
            self.assertEqual(self.run_to_end("--controllers", "ls", "/sys/class/net")[:2], (0, "can0\ncan1\nlo\nvcan0\nvcan1\n"))

    def test_files_that_changed_meanwhile_are_read_anew(self):
        file = self.folder / "file"
        for text in (None, "one\n", "of other length\n", None):
            file.unlink(missing_ok=True)
            if text is not None:
                file.write_text(text)
            status, printed, _ = self.run_to_end("cat", "file")
            self.assertEqual((status, printed), (0, text) if text else (1, ""))

    def test_a_command_whose_time_is_over_leaves_nothing_behind(self):
        program = self.start("--timeout", "15", "bash", "-c", ENDLESS)
        self.beats()
        _, errors = program.communicate(timeout=PATIENCE)
        self.assertEqual(program.returncode, TIMED_OUT)
        self.assertIn("still running", errors)
        self.until("silence", self.is_silent)

    def test_a_command_that_is_killed_leaves_nothing_behind(self):
        program = self.start("bash", "-c", ENDLESS)
        self.beats()
        program.send_signal(signal.SIGKILL)
        program.communicate()
        self.until("silence", self.is_silent)


if __name__ == "__main__":
    if subprocess.run(words("true"), check=False).returncode == SKIPPED:
        sys.exit(SKIPPED)
    unittest.main()
