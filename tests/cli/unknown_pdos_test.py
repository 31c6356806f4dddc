#!/usr/bin/env python3
"""Logs whose nodes never told their profile: every verb that decodes says so, and which profile would explain them."""

import html
import os
import re
import tempfile
import unittest

from command import DONE, FAILED, CommandTest, run

# CAN-IDs of lift 1 (CiA 417-3): the car's position, load, velocity, and door 1.
LIFT = """(1.000000) can0 18C#10270000
(1.100000) can0 188#01
(1.200000) can0 185#370210000000
(1.300000) can0 201#37020000
(1.400000) can0 18C#20270000
"""
# Five bytes in TPDO1 of four nodes: no profile has them.
NONE = "".join(f"({node}.000000) can0 18{node}#0102030405\n" for node in range(1, 5))
LIKE_A_LIFT = "they look like CiA 417-4: --profile 417-4"
LIKE_NOTHING = "; --profile or --node NODE=PROFILE says which"


class UnknownPdos(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name, text=None):
        path = os.path.join(self.folder, name)
        if text is not None:
            with open(path, "w", encoding="ascii") as out:
                out.write(text)
        return path

    def told(self, *arguments, status=DONE):
        result = run(*arguments)
        self.assertEqual(result.returncode, status, result.stderr)
        return result.stderr

    def test_decode_and_monitor_say_which_profile_they_look_like(self):
        log = self.path("lift.log", LIFT)
        for verb in ("decode", "monitor"):
            told = self.told(verb, log)
            self.assertEqual(told, f"{log}: no node has told its profile (1000h): 5 PDOs are shown as bytes; {LIKE_A_LIFT}\n")
        for more in (("--json",), ("--csv",), ("--parquet", self.path("lift.parquet"))):
            self.assertIn(LIKE_A_LIFT, self.told("decode", log, *more), more)
        self.assertIn("5 PDOs are left out", self.told("decode", log, "--csv"))
        self.assertIn(LIKE_A_LIFT, self.told("monitor", log, "--table"))

    def test_only_what_is_shown_counts(self):
        log = self.path("lift.log", LIFT)
        self.assertIn("2 PDOs are shown as bytes", self.told("decode", log, "--filter", "id=18C"))

    def test_what_is_told_is_used_and_nothing_is_said(self):
        log = self.path("lift.log", LIFT)
        shown = self.assert_done(run("decode", log, "--profile", "417-4"))
        self.assertEqual(shown.count("Position value"), 2, shown)

    def test_a_guess_is_never_used(self):
        shown = run("decode", self.path("lift.log", LIFT)).stdout
        self.assertNotIn("osition", shown)

    def test_no_guess_is_made_where_no_profile_explains_the_frames(self):
        log = self.path("none.log", NONE)
        told = self.told("decode", log)
        self.assertEqual(told, f"{log}: no node has told its profile (1000h): 4 PDOs are shown as bytes{LIKE_NOTHING}\n")

    def test_each_bus_of_a_log_has_a_line(self):
        log = self.path("two.log", LIFT + NONE.replace("can0", "can1"))
        told = self.told("decode", log).splitlines()
        self.assertEqual(len(told), 2, told)
        self.assertIn(": can0: no node", told[0])
        self.assertTrue(told[0].endswith("--profile can0=417-4"), told)
        self.assertTrue(told[1].endswith(LIKE_NOTHING), told)

    def test_plot_says_it_beside_what_it_does_not_find(self):
        told = self.told("plot", self.path("lift.log", LIFT), "position", status=FAILED)
        self.assertIn(f"5 PDOs are left out; {LIKE_A_LIFT}\n", told)
        self.assertIn("no value in it is called 'position'", told)

    def test_a_report_says_it_among_what_it_does_not_have(self):
        page = self.path("report.html")
        self.assert_done(run("report", self.path("lift.log", LIFT), "--out", page))
        with open(page, encoding="utf-8") as text:
            gaps = html.unescape(re.search(r'<div class="lost">(.*?)</div>', text.read(), re.DOTALL)[1])
        self.assertIn(f"No node has told its profile (1000h): 5 PDOs are not decoded; {LIKE_A_LIFT}.", gaps)

    def test_the_log_of_a_lift_looks_like_its_profile(self):
        log = self.path("lift.log")
        run("run", "lift", "--for", "5min", "--log", log)
        self.assertIn(LIKE_A_LIFT, self.told("decode", log, "--filter", "time<3min", "--out", self.path("out.log")))

    def test_the_log_of_a_network_of_two_profiles_looks_like_none(self):
        # Drives of CiA 402 and controls of CiA 852 among I/O of CiA 401, of which nobody has read 1000h.
        log = self.path("excavator.log")
        run("run", "excavator", "--for", "1min", "--log", log)
        told = self.told("decode", log, "--out", self.path("out.log"))
        self.assertRegex(told, rf"sim0: no node has told its profile \(1000h\): [0-9]+ PDOs are shown as bytes{LIKE_NOTHING}\n")


if __name__ == "__main__":
    unittest.main()
