#!/usr/bin/env python3
"""`canvoy run excavator` from outside."""

import json
import pathlib
import re
import tempfile
import unittest

from command import USAGE, FAILED, CommandTest, run


class RunExcavator(CommandTest):
    """A shift in virtual time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_same_seed_gives_the_same_log_and_another_seed_another(self):
        logs = []
        for name, seed in (("first", "1"), ("again", "1"), ("other", "2")):
            path = self.folder / f"{name}.log"
            arguments = ["--for", "4min", "--seed", seed, "--log", str(path)]
            self.assert_done(run("run", "excavator", *arguments, "--fault", "corrupted-frames@1min+1min"))
            logs.append(path.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertNotEqual(logs[0], logs[2])

    def test_what_is_printed_plays_the_same(self):
        arguments = ["--for", "7min", "--seed", "7", "--fault", "restart:node=10@2min", "--fault", "stuck-axis:axis=1@5min+5s"]
        path = self.folder / "excavator.toml"
        path.write_text(self.assert_done(run("run", "excavator", *arguments, "--print")))
        self.assertEqual(self.assert_done(run("run", str(path))), self.assert_done(run("run", "excavator", *arguments)))
        path.write_text(path.read_text().replace("# sensing_period", "sensing_period"))
        self.assertIn('sensing_period = "2ms"', self.assert_done(run("run", str(path), "--print")))
        self.assert_done(run("run", str(path)))

    def test_json_tells_earth_presses_and_what_held(self):
        output = self.assert_done(run("run", "excavator", "--for", "15min", "--json"))
        lines = [json.loads(line) for line in output.splitlines()]
        summary = lines[-1]
        self.assertIs(summary["all_held"], True)
        self.assertEqual([(node["bus"], node["node"]) for node in summary["nodes"]], [("sim0", 1), ("sim0", 10), ("sim0", 33), ("sim1", 7)])
        dumped = [line for line in lines if line["event"] == "dumped"]
        self.assertAlmostEqual(sum(line["m3"] for line in dumped), summary["statistics"]["heaped_m3"], delta=1.3)
        presses = sum(line["event"] == "press" for line in lines)
        self.assertEqual(presses, summary["statistics"]["presses"])
        switched = sum(line["event"] == "switch" and (line["on"] or line["output"] != "horn") for line in lines)
        self.assertEqual(switched, presses, "each press has one effect")

    def test_a_lost_host_stops_the_machine_and_is_seen(self):
        output = self.assert_done(run("run", "excavator", "--for", "5min", "--fault", "lost-node@2min+10s"))
        self.assertIn("FAULT begins: lost-node at host (1)", output)
        self.assertIn("lamps: fault\n", output)
        self.assertIn("seat (10): EMERGENCY 8130h", output)

    def test_an_armrest_that_vanishes_stops_the_machine_and_is_seen(self):
        arguments = ["--for", "5min", "--fault", "vanished-armrest@2min+10s"]
        output = self.assert_done(run("run", "excavator", *arguments))
        begun = output[output.index("FAULT begins: vanished-armrest at armrest (7)"):output.index("fault ends: vanished-armrest")]
        self.assertIn("hydraulics off\n", begun)
        self.assertRegex(begun, r"lamps: (light, )?(beacon, )?(fast, )?locked, fault, ready\n")
        self.assertIn("hydraulics on\n", output[output.index("fault ends: vanished-armrest"):])

    def test_a_recorded_shift_is_played_again(self):
        shift, first, second = (str(self.folder / name) for name in ("shift.csv", "first.log", "second.log"))
        recorded = self.assert_done(run("run", "excavator", "--for", "5min", "--seed", "3", "--record-shift", shift, "--log", first))
        self.assertTrue(pathlib.Path(shift).read_text().startswith("seconds,input,value\n0.500000,lever,1\n"))
        again = ["--for", "5min", "--seed", "3", "--shift", shift]
        self.assertEqual(self.assert_done(run("run", "excavator", *again, "--log", second)), recorded)
        self.assertEqual(pathlib.Path(second).read_bytes(), pathlib.Path(first).read_bytes())
        path = self.folder / "played.toml"
        path.write_text(self.assert_done(run("run", "excavator", *again, "--print")))
        self.assertEqual(self.assert_done(run("run", str(path))), recorded)
        self.assert_refused(run("run", "excavator", "--shift", str(self.folder / "none.csv")), FAILED, "none.csv")
        pathlib.Path(shift).write_text("seconds,input,value\n1,lever,1\n0.5,lever,0\n")
        self.assert_refused(run("run", "excavator", "--shift", shift), FAILED, "line 3", "before")

    def test_the_referee_looks_at_the_lamps_of_a_recorded_shift(self):
        """Nobody else does: the hydraulics stay locked after the fault, and the lamp says why nothing is dug."""
        shift = str(self.folder / "shift.csv")
        self.assert_done(run("run", "excavator", "--for", "6min", "--record-shift", shift))
        output = self.assert_done(run("run", "excavator", "--for", "6min", "--shift", shift, "--fault", "lost-node@3min+20s"))
        after = output[output.index("fault ends: lost-node"):]
        self.assertRegex(after, r"lamps: (light, )?(beacon, )?(fast, )?locked, ready\n")
        self.assertNotIn("broken", output)

    def test_a_log_names_every_frame(self):
        path = self.folder / "bus.log"
        self.assert_done(run("run", "excavator", "--for", "12min", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--node", "10=852", "--node", "33=401", "--node", "7=401"))
        self.assertIn("node 7 (07h) of network 2: read 6000h:01h", output)
        # Lever down, somebody in the seat, emergency stop not pressed.
        self.assertIn("node 7 (07h) of network 2: 6000h:01h = 07", output)
        services = {json.loads(line)["service"] for line in output.splitlines()}
        known = re.compile(r"NMT|[RT]?PDO ?\d*|SDO request|SDO response|heartbeat|boot-up|emergency")
        self.assertEqual([service for service in services if not known.fullmatch(service)], [])
        self.assertEqual(output.count("\n"), path.read_bytes().count(b"\n"))
        self.assertNotIn('"marks"', output)

    def test_bad_input_is_refused_in_one_line(self):
        for arguments, status, part in (
            (["--fault", "lost-node:node=12@1min"], USAGE, "10 (seat)"),
            (["--fault", "stuck-axis:node=10@1min"], USAGE, "not one of a node"),
            (["--fault", "lost-node:axis=1@1min"], USAGE, "not one of an axis"),
            (["--fault", "stuck-axis:axis=5@1min"], USAGE, "axis"),
            (["--fault", "flat-tyre@1min"], USAGE, "flat-tyre"),
            (["--for", "1min", "--fault", "restart@2min"], USAGE, "after the end"),
        ):
            self.assert_refused(run("run", "excavator", *arguments), status, part)
        path = self.folder / "bad.toml"
        for text, part in (
            ('network = "excavator"\n[seat]\nsensing_period = "long"\n', "line 3"),
            ('network = "excavator"\n[bus]\nbit_rate = 50000\n', "bit_rate"),
            ('network = "excavator"\n[seat]\nplayed = false\n', "real"),
            ('network = "excavator"\n[armrest]\nplayed = false\n[bus]\nreal = "can0"\n', "[embedded]"),
            ('network = "excavator"\n[bucket]\n', "bucket"),
        ):
            path.write_text(text)
            self.assert_refused(run("run", str(path)), FAILED, part)


if __name__ == "__main__":
    unittest.main()
