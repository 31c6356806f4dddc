#!/usr/bin/env python3
"""`canvoy run taxi` from outside, and devices of CiA 447 that share a node."""

import json
import pathlib
import tempfile
import unittest

from command import USAGE, FAILED, CommandTest, run


class RunTaxi(CommandTest):
    """A shift in virtual time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_same_seed_gives_the_same_log_and_another_seed_another(self):
        logs = []
        for name, seed in (("first", "1"), ("again", "1"), ("other", "2")):
            path = self.folder / f"{name}.log"
            arguments = ["--for", "20min", "--seed", seed, "--log", str(path)]
            self.assert_done(run("run", "taxi", *arguments, "--fault", "corrupted-frames@1min+1min"))
            logs.append(path.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertNotEqual(logs[0], logs[2])

    def test_what_is_printed_plays_the_same(self):
        arguments = ["--for", "40min", "--seed", "7", "--fault", "restart:node=2@5min"]
        path = self.folder / "taxi.toml"
        path.write_text(self.assert_done(run("run", "taxi", *arguments, "--print")))
        self.assertEqual(self.assert_done(run("run", str(path))), self.assert_done(run("run", "taxi", *arguments)))

    def test_json_tells_trips_and_what_held(self):
        output = self.assert_done(run("run", "taxi", "--for", "2h", "--json"))
        summary = [json.loads(line) for line in output.splitlines()][-1]
        self.assertIs(summary["all_held"], True)
        trip = summary["trips"][0]
        self.assertLessEqual(trip["fare_low"], trip["fare"])
        self.assertLessEqual(trip["fare"], trip["fare_high"])
        self.assertAlmostEqual(trip["distance_m"], trip["metered_distance_m"], delta=0.002 * trip["distance_m"] + 4)
        self.assertEqual([node["node"] for node in summary["nodes"]], list(range(1, 9)))

    def test_the_report_has_each_trip_with_its_limits_and_each_loss_of_power(self):
        arguments = ["--for", "3h", "--fault", "lost-node:node=2@15min+10s"]
        path = self.folder / "report.json"
        self.assert_done(run("run", "taxi", *arguments, "--report", str(path)))
        report = json.loads(path.read_text())
        self.assertEqual(report["interruptions"], [{"begin": 900.0, "end": 910.0}])
        self.assertEqual(report["trips"][0]["verdict"], "not judged", "the meter had no power in it")
        for trip in report["trips"][1:]:
            self.assertEqual(trip["verdict"], "within")
            self.assertEqual(trip["distance_limit_m"], max(4, 0.002 * trip["distance_m"]))
        paid = sum(trip["paid"] for trip in report["trips"])
        self.assertAlmostEqual(report["totals"]["income"]["shift"], paid)
        text = self.folder / "report.txt"
        self.assert_done(run("run", "taxi", *arguments, "--report", str(text)))
        self.assertIn("at 15min for 10.000s", text.read_text())
        self.assert_refused(run("run", "taxi", "--for", "1s", "--report", "/nowhere/report"), USAGE, "/nowhere")

    def test_a_log_names_every_frame(self):
        path = self.folder / "bus.log"
        self.assert_done(run("run", "taxi", "--for", "20min", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--profile", "447-3"))
        services = {json.loads(line)["service"] for line in output.splitlines()}
        known = {"NMT", "PDO", "LSS", "SDO request", "SDO response", "heartbeat", "boot-up", "sleep"}
        self.assertLessEqual(services, known)
        self.assertEqual(output.count("\n"), path.read_bytes().count(b"\n"))
        self.assertNotIn('"marks"', output)

    def test_bad_input_is_refused_in_one_line(self):
        for arguments, status, part in (
            (["--fault", "lost-node:node=9@1min"], USAGE, "nodes 1 to 8"),
            (["--fault", "cable-cut:node=2@1min"], USAGE, "not one of a node"),
            (["--fault", "flat-tyre@1min"], USAGE, "flat-tyre"),
            (["--for", "1min", "--fault", "restart@2min"], USAGE, "after the end"),
        ):
            self.assert_refused(run("run", "taxi", *arguments), status, part)
        path = self.folder / "bad.toml"
        for text, part in (
            ('network = "taxi"\n[taximeter]\nk = 0\n', "line 3"),
            ('network = "taxi"\n[printer]\nplayed = false\n', "real"),
            ('network = "taxi"\n[submarine]\n', "submarine"),
        ):
            path.write_text(text)
            self.assert_refused(run("run", str(path)), FAILED, part)

    def test_several_virtual_devices_make_one_node_and_one_data_sheet(self):
        sheet = self.assert_done(run("eds", "export", "taximeter+printer"))
        for index in ("60D0", "60EB", "1201"):
            self.assertIn(f"[{index}]", sheet)
        self.assert_refused(run("device", "taximeter+submarine", "sim"), USAGE, "submarine")
        self.assert_refused(run("device", "printer+printer", "sim"), USAGE, "twice")


if __name__ == "__main__":
    unittest.main()
