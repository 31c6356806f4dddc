"""The command under test: runs it, and says what it is to say where something is wrong.

    CANVOY=build/canvoy python3 tests/cli/bad_input_test.py
"""

import json
import os
import re
import subprocess
import unittest

CANVOY = os.environ.get("CANVOY", "build/canvoy")
os.environ.setdefault("CANVOY_TIMEOUT", "10s")  # a device of a loaded machine answers late
DONE, FAILED, USAGE = 0, 1, 2


def run(*arguments, **options):
    """Runs the command to its end; its output as text."""
    options.setdefault("stdout", subprocess.PIPE)
    if "input" not in options:
        options.setdefault("stdin", subprocess.DEVNULL)
    return subprocess.run([CANVOY, *arguments], stderr=subprocess.PIPE, text=True, timeout=120, **options)


class CommandTest(unittest.TestCase):
    """Assertions on a run of the command."""

    def assert_refused(self, result, status, *parts):
        """One line on stderr with all `parts` in it, nothing on stdout, and the exit status."""
        self.assertFalse(result.stdout, "what is refused prints nothing")
        self.assertRegex(result.stderr, r"\Acanvoy: [^\n]+\n\Z", "one line says what is wrong")
        for part in parts:
            self.assertIn(part, result.stderr)
        self.assertEqual(result.returncode, status, result.stderr)

    def assert_told(self, result):
        """The same of a run with --json: its lines as objects."""
        return [json.loads(line) for line in self.assert_done(result).splitlines()]

    def assert_done(self, result):
        """Exit status 0, and no complaint."""
        self.assertEqual((result.stderr, result.returncode), ("", DONE))
        return result.stdout

    def assert_decoded(self, result):
        """Exit status 0, and no complaint but that nodes have told no profile."""
        self.assertRegex(result.stderr, r"\A([^\n]+ told (its|their) profile \(1000h\)[^\n]+\n)+\Z")
        self.assertEqual(result.returncode, DONE)
        return result.stdout

    def worlds(self):
        """The worlds that the help of `run` lists below its subcommands."""
        listed = self.assert_done(run("run", "--help")).partition("Subcommands:")[2].partition("\n\n")[0]
        return re.findall(r"^  ([a-z-]+) ", listed, re.MULTILINE)
