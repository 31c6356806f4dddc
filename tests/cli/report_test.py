#!/usr/bin/env python3
"""canvoy report: a run or a log as one page that loads nothing, with the same run and verdicts as canvoy run."""

import json
import os
import re
import tempfile
import unittest

from command import CommandTest, DONE, FAILED, USAGE, run


def data_of(page):
    """What the page draws: the JSON that stands in it."""
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1])


class Report(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.page = os.path.join(self.folder, "report.html")

    def report(self, *arguments, status=DONE):
        result = run("report", *arguments, "--out", self.page)
        self.assertEqual(result.returncode, status, result.stderr)
        with open(self.page, encoding="utf-8") as page:
            return page.read(), result.stdout

    def test_a_run_is_the_same_as_that_of_canvoy_run(self):
        line = ("run", "charger", "--for", "5min", "--seed", "7", "--fault", "pilot-loss@1min+30s")
        page, said = self.report(*line[1:])
        data = data_of(page)
        told = [json.loads(each) for each in run(*line, "--json").stdout.splitlines()]
        words = [each.pop("words") for each in data["events"]]
        self.assertEqual(data["events"], [each for each in told if each["event"] not in ("snapshot", "summary")])
        for said_in_page, line_of_run in zip(words, run(*line).stdout.splitlines()):
            self.assertTrue(line_of_run.endswith("  " + said_in_page), line_of_run)
        summary = next(each for each in told if each["event"] == "summary")
        self.assertEqual(data["end"]["summary"]["invariants"], summary["invariants"])
        self.assertIn("pilot-loss", said)
        self.assertTrue(run(*line).stdout.endswith(said), "the summary is the same")
        self.assertEqual(data["end"]["plan"]["command"], "canvoy run charger --for 5min --fault pilot-loss@1min+30s --seed 7")

    def test_pictures_go_from_the_start_to_the_end(self):
        page, _ = self.report("lift", "--floors", "4", "--for", "10min")
        pictures = data_of(page)["pictures"]
        self.assertEqual(len(pictures), 120)
        self.assertEqual((pictures[0]["time"], pictures[-1]["time"]), (0, 600))
        self.assertEqual(len(pictures[0]["snapshot"]["lifts"]), 1)
        times = [each["time"] for each in pictures]
        self.assertEqual(times, sorted(times))

    def test_what_is_broken_is_told_by_the_exit_status_too(self):
        # More people come than a lift can carry, and some give up: after ten minutes at the earliest.
        arguments = ("lift", "--for", "15min", "--percent", "40")
        self.assertEqual(run("run", *arguments).returncode, 1)
        page, said = self.report(*arguments, status=1)
        self.assertIn("FAIL", said)
        self.assertFalse(data_of(page)["end"]["summary"]["all_held"])

    def test_nothing_is_loaded_from_elsewhere(self):
        page, _ = self.report("charger", "--for", "1min")
        self.assertIn("default-src 'none'", page)
        self.assertNotRegex(page, r"<(link|img|iframe)\b|<script[^>]* src=|@import|url\((?!#)")

    def test_the_same_run_is_the_same_file(self):
        first, _ = self.report("charger", "--for", "2min")
        self.assertEqual(self.report("charger", "--for", "2min")[0], first)

    def test_a_link_of_the_page_says_which_run(self):
        page, _ = self.report("charger", "--for", "3min", "--link", "http://127.0.0.1:8080/#seed=9&fault=pilot-loss%401min%2B30s")
        plan = data_of(page)["end"]["plan"]
        self.assertEqual(plan["command"], "canvoy run charger --for 3min --fault pilot-loss@1min+30s --seed 9")
        other, _ = self.report("charger", "--for", "3min", "--seed", "9", "--fault", "pilot-loss@1min+30s")
        self.assertEqual(other, page)

    def test_a_network_file(self):
        file = os.path.join(self.folder, "house.toml")
        with open(file, "w", encoding="utf-8") as out:
            out.write(run("run", "lift", "--lifts", "2", "--floors", "4", "--print").stdout)
        page, _ = self.report(file, "--for", "2min")
        self.assertEqual(len(data_of(page)["pictures"][0]["snapshot"]["lifts"]), 2)

    def test_a_log_with_its_nodes_values_and_load(self):
        log = os.path.join(self.folder, "night.log")
        run("run", "charger", "--for", "2min", "--log", log)
        with open(log, encoding="ascii") as lines:
            frames = len(lines.readlines())
        page, _ = self.report(log, "--node", "10=418", "--node", "5=419")
        data = data_of(page)
        self.assertEqual(data["about"]["kind"], "log")
        self.assertEqual(sum(bus["frames"] for bus in data["end"]["counts"].values()), frames)
        voltage = data["values"]["0 10 6060:00"]["values"][0]
        self.assertEqual((voltage["name"], voltage["unit"]), ("battery_voltage", "V"))
        self.assertIn("0 10 6060:00", data["curves"])

    def test_what_a_log_says_ends_no_element(self):
        log = os.path.join(self.folder, "evil.log")
        with open(log, "w", encoding="ascii") as out:
            out.write("(0000000001.000000) </script><b>x 70A#05\n(0000000002.000000) </script><b>x 70A#05\n")
        page, _ = self.report(log)
        self.assertEqual(page.count("</script>"), 2)
        self.assertEqual(data_of(page)["about"]["buses"], ["</script><b>x"])

    def test_what_makes_no_sense_is_refused_in_a_line(self):
        page = ("--out", self.page)
        for arguments, word in (
            (("charger",), "--out"),
            (("nothing", *page), "nothing"),
            (page, "missing"),
            (("charger", "--fault", "no-such@1min", *page), "no-such"),
            (("charger", "--link", "http://127.0.0.1/", *page), "--link"),
            (("charger", "--link", "http://127.0.0.1/#seed=x", *page), "--link"),
        ):
            self.assert_refused(run("report", *arguments), USAGE, word)
        self.assert_refused(run("report", "charger", "--for", "1s", "--out", "/no/such/folder/report.html"), FAILED, "/no/such/folder")
        self.assertFalse(os.path.exists(self.page))


if __name__ == "__main__":
    unittest.main()
