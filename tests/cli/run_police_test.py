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
            arguments = ["--for", "8min", "--seed", seed, "--log", str(path)]
            self.assert_done(run("run", "police", *arguments, "--fault", "corrupted-frames@1min+1min"))
            logs.append(path.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertNotEqual(logs[0], logs[2])

    def test_what_is_printed_plays_the_same(self):
        arguments = ["--for", "15min", "--seed", "7", "--fault", "restart:node=2@12min", "--fault", "burnt-lamp@5min"]
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
            sounds = snapshot["plant"]["siren"] != "none"
            self.assertEqual(snapshot["terminal"]["display_2"], "BLUE SIREN" if sounds else "BLUE")
        # Some calls are driven to without the siren, most with it.
        self.assertIn("BLUE SIREN", [snapshot["terminal"]["display_2"] for snapshot in shown])

    def test_a_holder_that_dies_does_not_stop_the_others(self):
        output = self.assert_done(run("run", "police", "--for", "25min", "--fault", "dead-client@10min+5min"))
        self.assertIn("gateway: radio (6) is lost", output)

    def test_a_log_names_every_frame(self):
        path = self.folder / "bus.log"
        # The patrol ends after half of it; then power runs after, the network sleeps, and wakes up.
        self.assert_done(run("run", "police", "--for", "100min", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--profile", "447-3"))
        services = {json.loads(line)["service"] for line in output.splitlines()}
        known = {"NMT", "PDO", "LSS", "SDO request", "SDO response", "heartbeat", "boot-up", "sleep"}
        self.assertEqual(services, known)
        self.assertEqual(output.count("\n"), path.read_bytes().count(b"\n"))
        self.assertNotIn('"marks"', output)

    def test_in_a_log_with_faults_nothing_is_marked_but_what_they_did(self):
        faults = [
            ("lost-node:node=3@12min+30s", 720, 750),
            ("cable-cut@20min+20s", 1200, 1220),
            ("babbling-node@25min+3s", 1500, 1503),
            ("corrupted-frames@30min+2min", 1800, 1920),
            ("burnt-lamp@35min+5min", 2100, 2400),
            ("overload@40min+2min", 2400, 2520),
            ("dead-client@45min+5min", 2700, 3000),
            ("restart:node=1@52min", 3120, 3120),
        ]
        path = self.folder / "bus.log"
        arguments = [word for fault, _, _ in faults for word in ("--fault", fault)]
        self.assert_done(run("run", "police", "--for", "1h", *arguments, "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--profile", "447-3"))
        lines = [json.loads(line) for line in output.splitlines()]
        self.assertEqual(len(lines), path.read_bytes().count(b"\n"))
        marked = [line["time"] for line in lines if "marks" in line]
        self.assertTrue(marked, "a stranger has filled the bus with frames that are none")
        for time in marked:
            # 20 s after its end all are back.
            self.assertTrue(any(begin <= time <= end + 20 for _, begin, end in faults), time)
        for line in lines:
            if "marks" not in line and line["service"] == "PDO":
                self.assertTrue(line["values"] and all(value["name"] for value in line["values"]), line)

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
