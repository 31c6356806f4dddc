#!/usr/bin/env python3
"""Each world plays some minutes, and its invariants hold."""

import json
import re
import unittest

from command import CommandTest, run

MINUTES = 5


class Worlds(CommandTest):
    def names(self):
        """The worlds that the help of `run` lists below its subcommands."""
        listed = self.assert_done(run("run", "--help")).partition("Subcommands:")[2].partition("\n\n")[0]
        return re.findall(r"^  ([a-z-]+) ", listed, re.MULTILINE)

    def test_each_plays_and_holds(self):
        self.assertGreaterEqual(len(self.names()), 6)
        for name in self.names():
            with self.subTest(name):
                *_, summary = self.assert_told(run("run", name, "--for", f"{MINUTES}min", "--json"))
                self.assertTrue(summary["all_held"], json.dumps(summary["invariants"]))
                self.assertGreater(sum(bus["frames"] for bus in summary["buses"]), 1000)


if __name__ == "__main__":
    unittest.main()
