#!/usr/bin/env python3
"""Each world plays some minutes, and its invariants hold."""

import json
import unittest

from command import CommandTest, run

MINUTES = 5


class Worlds(CommandTest):
    def test_each_plays_and_holds(self):
        self.assertGreaterEqual(len(self.worlds()), 6)
        for name in self.worlds():
            with self.subTest(name):
                *_, summary = self.assert_told(run("run", name, "--for", f"{MINUTES}min", "--json"))
                self.assertTrue(summary["all_held"], json.dumps(summary["invariants"]))
                self.assertGreater(sum(bus["frames"] for bus in summary["buses"]), 1000)


if __name__ == "__main__":
    unittest.main()
