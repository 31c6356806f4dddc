#!/usr/bin/env python3
"""`canvoy run charger --chargers N`: a charging yard from outside, by options and by files."""

import json
import pathlib
import tempfile
import unittest

from command import DONE, FAILED, USAGE, CommandTest, run

NIGHT = ["run", "charger", "--chargers", "2", "--batteries", "3", "--battery", "lithium,plain", "--goal", "80@06:00", "--seed", "3"]
UNDECIDED = 3


class RunYard(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, text):
        path = self.folder / "yard.toml"
        path.write_text(text)
        return str(path)

    def test_one_charger_and_one_battery_are_what_they_were(self):
        short = ["run", "charger", "--for", "2min", "--fault", "pdo-loss@1min+10s"]
        for form in (["--json"], ["--print"], []):
            self.assertEqual(self.assert_done(run(*short, *form)), self.assert_done(run(*short, "--chargers", "1", "--batteries", "1", *form)))

    def test_a_night_is_judged_of_each_charger_and_each_battery(self):
        output = self.assert_done(run(*NIGHT))
        self.assertIn("\n12h 10min simulated: 2 chargers, 3 batteries, goal 80 % after 12h; ", output)
        for bay in (1, 2):
            self.assertRegex(output, rf"\n  PASS  bay {bay}: missing of a battery of its bay at the time of the goal 0\S* %, 0\S* % allowed\n")
        for battery in (1, 2, 3):
            self.assertRegex(output, rf"\n  PASS  battery {battery}: missing of its charge at the time of the goal 0")
        self.assertRegex(output, r"\n  PASS  battery 2: missing of the time of equalising ")
        self.assertIn("  PASS  bay 2: ampere-hours of charger and plant differ by ", output)

    def test_a_goal_that_is_missed_fails_with_what_is_missing(self):
        path = self.file('network = "charger"\nfor = "30min"\n[charger]\nbegin = 2026-11-21T18:00:00\n'
                         '[yard]\nchargers = 1\ngoal = "80@18:20"\n[[vehicle]]\nstate_of_charge = 20\n')  # fmt: skip
        result = run("run", path)
        self.assertEqual(result.returncode, FAILED)
        # 20 minutes of 60 A, of which 92 % remain, are 4.6 % of 400 Ah.
        self.assertRegex(result.stdout, r"\n  FAIL  battery 1: missing of its charge at the time of the goal 55\.\d+ %, 0\S* % allowed\n")
        self.assertRegex(result.stdout, r"\n +20min +FAIL: battery 1: missing of its charge ")

    def test_a_goal_after_the_end_is_not_decided(self):
        result = run(*NIGHT, "--for", "10min", "--require-decided")
        self.assertEqual(result.returncode, UNDECIDED)
        self.assertIn("\n  ----  battery 1: not decided: missing of its charge at the time of the goal\n", result.stdout)

    def test_where_nothing_is_charged_nothing_is_decided(self):
        end = self.assert_told(run("run", "charger", "--chargers", "2", "--for", "10s", "--json"))[-1]
        self.assertEqual([each["invariant"] for each in end["invariants"] if each["decided"]], [])

    def test_vehicles_come_with_the_state_of_charge_that_is_asked_for(self):
        lines = self.assert_told(run("run", "charger", "--chargers", "4", "--state-of-charge", "50", "--for", "40min", "--json"))
        came = [line["state_of_charge_percent"] for line in lines if line["event"] == "battery-comes"]
        self.assertEqual(len(came), 4)
        self.assertTrue(all(50 <= each <= 80 for each in came), came)

    def test_json_has_bays_and_vehicles(self):
        lines = self.assert_told(run(*NIGHT, "--for", "1h", "--json"))
        end = lines[-1]
        self.assertEqual([bay["battery_kind"] for bay in end["bays"]], ["lithium", "plain"])
        self.assertEqual([vehicle["bay"] for vehicle in end["vehicles"]], [1, 2, 1])
        self.assertEqual(end["goal"], {"state_of_charge_percent": 80.0, "at": 43200.0})
        self.assertAlmostEqual(end["mains_wh"], sum(bay["plant"]["energy_wh"] for bay in end["bays"]) / 0.93, delta=end["mains_wh"] / 100)
        self.assertEqual({line["bay"] for line in lines if line["event"] == "battery-plugged"}, {1, 2})
        self.assertEqual([node["bus"] for node in end["nodes"]], ["sim0", "sim0", "sim1", "sim1"])
        of = {(each["invariant"], each.get("bay"), each.get("battery")): each for each in end["invariants"]}
        self.assertFalse(of["battery_goal", None, 3]["decided"])
        self.assertTrue(of["energy", 2, None]["held"])

    def test_all_bays_are_on_one_bus_where_it_is_said(self):
        end = self.assert_told(run(*NIGHT, "--one-bus", "--for", "45min", "--json"))[-1]
        self.assertEqual([bus["bus"] for bus in end["buses"]], ["sim0"])
        self.assertEqual([(node["node"], node["device"]) for node in end["nodes"]],
                         [(5, "charger"), (10, "battery"), (6, "charger"), (11, "battery")])  # fmt: skip
        self.assertTrue(all(bay["plant"]["charge_ah"] > 1 for bay in end["bays"]), end["bays"])

    def test_a_fault_is_in_its_bay(self):
        lines = self.assert_told(run(*NIGHT, "--for", "1h", "--fault", "battery-silent:bay=2@40min+1min", "--json"))
        self.assertEqual([line["bay"] for line in lines if line["event"].startswith("fault-")], [2, 2])
        seen = [each for each in lines[-1]["invariants"] if each["invariant"] == "fault_seen"]
        self.assertEqual([(each["bay"], each["fault"], each["held"]) for each in seen], [(2, "battery-silent", True)])

    def test_what_print_shows_is_played_alike(self):
        chosen = [*NIGHT, "--supply", "9", "--for", "20min", "--fault", "pdo-loss:bay=2@15min+10s"]
        printed = self.assert_done(run(*chosen, "--print"))
        path = self.file(printed)
        self.assertEqual(self.assert_done(run("run", path, "--json")), self.assert_done(run(*chosen, "--json")))
        self.assertEqual(self.assert_done(run("run", path, "--print")), printed)

    def test_vehicles_of_a_file_come_and_go(self):
        path = self.file('network = "charger"\nfor = "2h"\n[yard]\nchanged = 1\n')
        self.assert_refused(run("run", path), FAILED, "changed")
        path = self.file('network = "charger"\nfor = "2h"\n[yard]\n[[vehicle]]\nstate_of_charge = 50\nleaves = "30min"\nreturns = "90min"\nused = 10\n')
        lines = self.assert_told(run("run", path, "--json"))
        moves = [(line["event"], round(line["time"])) for line in lines if line["event"].startswith("battery-")]
        self.assertEqual(moves, [("battery-comes", 0), ("battery-plugged", 0), ("battery-leaves", 1800), ("battery-comes", 5400), ("battery-plugged", 5400)])

    def test_a_hand_acts_in_its_bay(self):
        path = self.file('network = "charger"\nfor = "20min"\n'
                         '[[hands]]\nat = "10min"\ndevice = "battery"\nbay = 2\nset = "ready=no"\n'
                         '[[hands]]\nat = "15min"\ndevice = "charger"\nset = "pilot-signal=lost"\n'
                         '[yard]\nchargers = 2\n[[vehicle]]\n[[vehicle]]\nbay = 2\n')  # fmt: skip
        lines = self.assert_told(run("run", path, "--json"))
        hands = [(line["time"], line["bay"], line["node"], line["hand"]) for line in lines if line["event"] == "hand"]
        self.assertEqual(hands, [(600.0, 2, 10, "ready=no"), (900.0, 1, 5, "pilot-signal=lost")])
        reasons = [(int(line["time"]), line["bay"], line["reason"]) for line in lines if line["event"] == "reason" and line["time"] > 590]
        self.assertEqual(reasons, [(600, 2, "the battery is not ready"), (900, 1, "no pilot signal")])
        self.assertEqual(lines[-1]["bays"][1]["reason"], "the battery is not ready")
        printed = self.assert_done(run("run", path, "--print"))
        self.assertEqual(self.assert_told(run("run", self.file(printed), "--json")), lines)

    def test_what_cannot_be_is_refused_in_a_line(self):
        for arguments, *parts in (
            (["--goal", "80"], "'80' is no goal", "80@06:00"),
            (["--goal", "120@06:00"], "is no goal"),
            (["--goal", "80@24:00"], "is no goal"),
            (["--chargers", "2", "--battery", "lithium,plain,lead-acid"], "3 kinds of batteries for 2 bays"),
            (["--battery", "lithium,plain"], "2 kinds of batteries for 1 bay:"),
            (["--goal", "nan@06:00"], "is no goal"),
            (["--goal", "inf@06:00"], "is no goal"),
            (["--goal", "1e999@06:00"], "is no goal"),
            (["--goal", "80@1e1:00"], "is no goal"),
            (["--goal", "80@06:60"], "is no goal"),
            (["--battery", "lead"], "there is no battery 'lead'", "lead-acid, lithium, plain"),
            (["--chargers", "17"], "--chargers"),
            (["--chargers", "0"], "--chargers"),
            (["--batteries", "65"], "--batteries"),
            (["--chargers", "2", "--fault", "pdo-loss:bay=0@1min"], "'0' is no number from 1 to 16"),
            (["--chargers", "2", "--fault", "pdo-loss:bay=1:bay=2@1min"], "'bay=2'", "named before"),
            (["--fault", "pdo-loss:bay=2@1min"], "pdo-loss:bay=2@1min", "one bay"),
            (["--chargers", "3", "--fault", "pdo-loss:bay=4@1min"], "bays 1 to 3"),
        ):
            self.assert_refused(run("run", "charger", *arguments), USAGE, *parts)

    def test_what_cannot_be_in_a_file_is_refused_in_a_line(self):
        head = 'network = "charger"\n'
        for text, *parts in (
            ("[yard]\n[[vehicle]]\nbay = 2\n", "bay 2", "bays 1 to 1"),
            ('[yard]\n[[vehicle]]\narrives = "2h"\nleaves = "1h"\n', "leaves before it arrives"),
            ('[yard]\n[[vehicle]]\nreturns = "1h"\n', "returns before it leaves"),
            ('[yard]\n[[vehicle]]\narrives = "0s"\nleaves = "0s"\n', "leaves: 0s is too short"),
            ('[yard]\nbattery = ["plain", "plain"]\n', "2 kinds of batteries for 1 bay:"),
            ("[yard]\nbatteries = 2\n[[vehicle]]\n", "2 batteries and 1 vehicles"),
            ("[battery]\nid = 7\n[yard]\nchargers = 3\none_bus = true\n", "on one bus, 3 chargers"),
            ('[bus]\nreal = "can0"\n[yard]\nchargers = 2\n', "real in [[bay]]", "one_bus"),
            ("[battery]\nplayed = false\n[yard]\nchargers = 2\n", "which bay", "[[bay]]", "battery_played"),
            ("[yard]\nchargers = 2\n[[bay]]\nbay = 2\nbattery_played = false\n", "bay 2", "[[bay]]", "can0"),
            ("[yard]\nchargers = 2\none_bus = true\n[[bay]]\nbay = 2\ncharger_played = false\n", "bay 2", "[bus]"),
            ('[yard]\nchargers = 2\none_bus = true\n[[bay]]\nreal = "can0"\n', "on one bus", "[bus]"),
            ("[yard]\nchargers = 2\n[[bay]]\nbay = 3\n", "bay 3", "bays 1 to 2"),
            ("[yard]\nchargers = 2\n[[bay]]\n[[bay]]\n", "bay 1 twice"),
            ('faults = ["pdo-loss:bay=2@1min"]\n[yard]\nchargers = 2\n[[bay]]\nbay = 2\nreal = "can0"\nbattery_played = false\n', "bay 2", "both played"),
            ('[[hands]]\nat = "1min"\ndevice = "battery"\nset = "ready=no"\n[yard]\n[[bay]]\nreal = "can0"\nbattery_played = false\n', "hands", "not played here"),
            ('[[hands]]\nat = "1min"\ndevice = "battery"\nbay = 3\nset = "ready=no"\n[yard]\nchargers = 2\n', "hands", "bays are 1 to 2"),
            ('[[hands]]\nat = "1min"\ndevice = "battery"\nbay = 2\nset = "ready=no"\n', "hands", "there is one bay"),
        ):
            self.assert_refused(run("run", self.file(head + text)), FAILED, *parts)


if __name__ == "__main__":
    unittest.main()
