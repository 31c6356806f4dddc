#!/usr/bin/env python3
"""`canvoy run police` from outside."""

import json
import pathlib
import tempfile
import unittest

from command import USAGE, FAILED, CommandTest, run


class RunPolice(CommandTest):
    """A patrol in virtual time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_same_seed_gives_the_same_log_and_another_seed_another(self):
        logs = []
        for name, seed in (("first", "1"), ("again", "1"), ("other", "2")):
            path = self.folder / f"{name}.log"
            arguments = ["--for", "20min", "--seed", seed, "--log", str(path)]
            self.assert_done(run("run", "police", *arguments, "--fault", "corrupted-frames@1min+1min"))
            logs.append(path.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertNotEqual(logs[0], logs[2])

    def test_what_is_printed_plays_the_same(self):
        arguments = ["--for", "40min", "--seed", "7", "--fault", "restart:node=2@12min", "--fault", "burnt-lamp@5min"]
        path = self.folder / "police.toml"
        path.write_text(self.assert_done(run("run", "police", *arguments, "--print")))
        self.assertEqual(self.assert_done(run("run", str(path))), self.assert_done(run("run", "police", *arguments)))

    def test_json_tells_calls_and_what_held(self):
        output = self.assert_done(run("run", "police", "--for", "2h", "--json"))
        lines = [json.loads(line) for line in output.splitlines()]
        summary = lines[-1]
        self.assertIs(summary["all_held"], True)
        made = [line for line in lines if line["event"] == "call"]
        self.assertEqual([call["destination"] for call in made], [call["destination"] for call in summary["calls"]])
        for call in summary["calls"]:
            self.assertLess(call["made"], call["heard"])
            self.assertLess(call["acknowledged"], call["arrived"])
            self.assertLess(call["arrived"], call["reported"])
        self.assertEqual([node["node"] for node in summary["nodes"]], list(range(1, 12)))
        clients = {line["client"] for line in lines if line["event"] == "terminal"}
        self.assertEqual(clients, {"radio", "signals", "navigation", "car"})
        shown = [line for line in lines if line["event"] == "snapshot" and line["crew"] == "drives to the call"]
        self.assertTrue(shown)
        for snapshot in shown:
            self.assertIs(snapshot["plant"]["blue_light"], True)
            self.assertNotEqual(snapshot["plant"]["siren"], "none")
            self.assertEqual(snapshot["terminal"]["display_2"], "BLUE SIREN")

    def test_a_holder_that_dies_does_not_stop_the_others(self):
        output = self.assert_done(run("run", "police", "--for", "1h", "--fault", "dead-client@10min+5min"))
        self.assertIn("gateway: radio (6) is lost", output)

    def test_a_log_names_every_frame(self):
        path = self.folder / "bus.log"
        self.assert_done(run("run", "police", "--for", "3h", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--profile", "447-3"))
        services = {json.loads(line)["service"] for line in output.splitlines()}
        known = {"NMT", "PDO", "LSS", "SDO request", "SDO response", "heartbeat", "boot-up", "sleep"}
        self.assertLessEqual(services, known)
        self.assertEqual(output.count("\n"), path.read_bytes().count(b"\n"))
        self.assertNotIn('"marks"', output)

    def test_bad_input_is_refused_in_one_line(self):
        for arguments, status, part in (
            (["--fault", "lost-node:node=12@1min"], USAGE, "nodes 1 to 11"),
            (["--fault", "burnt-lamp:node=5@1min"], USAGE, "not one of a node"),
            (["--fault", "flat-tyre@1min"], USAGE, "flat-tyre"),
            (["--for", "1min", "--fault", "restart@2min"], USAGE, "after the end"),
        ):
            self.assert_refused(run("run", "police", *arguments), status, part)
        path = self.folder / "bad.toml"
        for text, part in (
            ('network = "police"\n[power-supply]\nradio_after_run = "long"\n', "line 3"),
            ('network = "police"\n[radio]\nplayed = false\n', "real"),
            ('network = "police"\n[submarine]\n', "submarine"),
        ):
            path.write_text(text)
            self.assert_refused(run("run", str(path)), FAILED, part)


if __name__ == "__main__":
    unittest.main()
