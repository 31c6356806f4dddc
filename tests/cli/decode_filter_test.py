#!/usr/bin/env python3
"""--filter of canvoy decode and monitor, from outside. What is expected is typed from CiA 301, 418 and 419."""

import json
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

from command import CANVOY, DONE, USAGE, CommandTest, run

# A battery (CiA 418) with node-ID 10, which says so, and gets warm: 20, 40.125 and 41 °C.
LOG = """(1700000000.000000) can0 70A#00
(1700000000.100000) can0 60A#4000100000000000
(1700000000.200000) can0 58A#43001000A2010000
(1700000001.000000) can0 18A#A00001
(1700000010.000000) can0 18A#410101
(1700000020.000000) can0 18A#480100
(1700000020.100000) can0 70A#05
(1700000020.200000) can1 705#05
"""


class DecodeFilterTest(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.log = pathlib.Path(folder.name) / "bus.log"
        self.log.write_text(LOG)

    def numbers(self, *filters, verb="decode"):
        """The lines of the log that pass, counted from 1."""
        options = [word for text in filters for word in ("--filter", text)]
        shown = self.assert_done(run(verb, str(self.log), *options))
        frames = [line.split(")")[0] for line in LOG.splitlines()]
        return [frames.index(line.split(")")[0]) + 1 for line in shown.splitlines()]

    def test_passes_what_holds(self):
        for text, expected in [
            ("temperature>40", [5, 6]),
            ("temperature>40degC and not battery_status=ready", [6]),
            ("temperature = 40.125 °C", [5]),
            ("node=10 and (heartbeat or boot-up)", [1, 7]),
            ("bus=can1 or id=58A", [3, 8]),
            ("time>=10s and time<20.15s", [5, 6, 7]),
            ("time<1700000001", [1, 2, 3]),
            ("object=1000..1FFF", [2, 3]),
            ("6010:00=0x148", [6]),
        ]:
            self.assertEqual(self.numbers(text), expected, text)

    def test_an_object_keeps_the_messages_of_its_transfers_on_each_bus_apart(self):
        # On can0 1008h is read in segments, on can1 1009h by the same CAN-IDs, one between the other.
        frames = [
            "can0 60A#4008100000000000", "can1 60A#4009100000000000", "can0 58A#410810000A000000", "can1 58A#410910000A000000",
            "can0 60A#6000000000000000", "can1 60A#6000000000000000", "can0 58A#0043616E766F7920", "can1 58A#0043616E766F7920",
            "can1 60A#8009100000000405", "can0 60A#7000000000000000", "can0 58A#1942434400000000", "can1 60A#7000000000000000",
        ]  # fmt: skip
        self.log.write_text("".join(f"({number}.000000) {frame}\n" for number, frame in enumerate(frames)))
        for verb in ("decode", "monitor"):
            for text, wanted in [("1008h", [0, 2, 4, 6, 9, 10]), ("1009h", [1, 3, 5, 7, 8]), ("1008h!=x", [10])]:
                shown = self.assert_done(run(verb, str(self.log), "--filter", text)).splitlines()
                self.assertEqual([int(line[1:].split(".")[0]) for line in shown], wanted, text)

    def test_several_have_to_hold_all_and_the_log_may_stand_behind(self):
        self.assertEqual(self.numbers("node=10", "service=TPDO", "temperature<30"), [4])
        shown = self.assert_done(run("decode", "--filter", "node=5", str(self.log)))
        self.assertEqual(len(shown.splitlines()), 1)

    def test_monitor_takes_the_same(self):
        self.assertEqual(self.numbers("temperature>40", verb="monitor"), [5, 6])

    def test_holds_for_json_and_for_other_logs(self):
        lines = self.assert_done(run("decode", str(self.log), "--json", "--filter", "temperature>40")).splitlines()
        self.assertEqual([json.loads(line)["values"][0]["value"] for line in lines], [40.125, 41.0])
        out = str(self.log) + ".asc"
        self.assert_done(run("decode", str(self.log), "--out", out, "--filter", "temperature>40"))
        self.assertEqual(len(self.assert_decoded(run("decode", out)).splitlines()), 2)

    def test_knows_the_names_of_a_data_sheet(self):
        sheet = str(self.log) + ".eds"
        self.assert_done(run("eds", "export", "battery", "--out", sheet))
        text = pathlib.Path(sheet).read_text()
        self.assertRegex(text, r"(?m)^\[6010\]$")
        extra = "[2000]\nParameterName=Fan of the rack\nObjectType=7\nDataType=5\nAccessType=rw\nPDOMapping=1\n"
        count = re.search(r"(?s)\[ManufacturerObjects\]\s*SupportedObjects=0", text)
        self.assertTrue(count, "a battery has no objects of its maker")
        text = text.replace(count.group(), "[ManufacturerObjects]\nSupportedObjects=1\n1=0x2000") + "\n" + extra
        pathlib.Path(sheet).write_text(text)
        self.log.write_text("(1.0) can0 58A#4F00200007000000\n(1.1) can0 58A#4F00200008000000\n")
        shown = self.assert_done(run("decode", str(self.log), "--eds", f"10={sheet}", "--filter", "fan of the rack>7"))
        self.assertEqual(len(shown.splitlines()), 1)
        self.assert_refused(run("decode", str(self.log), "--filter", "fan of the rack>7"), USAGE, "no object is called")

    def test_a_node_is_called_as_in_the_file_of_the_network(self):
        network = self.log.with_name("yard.toml")
        network.write_text('[[node]]\nnode = 10\nname = "Pump left"\n')
        for text in ("node=Pump left", "node=pump_left"):
            named = self.assert_done(run("decode", str(self.log), "--network", str(network), "--filter", text))
            self.assertEqual(named, self.assert_done(run("decode", str(self.log), "--filter", "node=10")))
        self.assert_refused(run("decode", str(self.log), "--filter", "node=pump_left"), USAGE, "'pump_left' is no node-ID")

    def test_says_where_it_is_wrong_and_prints_nothing(self):
        for text, parts in [
            ("node=10 and tempersture>40", ["character 13", "did you mean 'temperature'"]),
            ("node", ["character 1", "node=5"]),
            ("nod:5", ["no object is called 'nod:5'"]),
            ("id=18A and id=18B", ["no frame can pass"]),
            ("", ["it is empty"]),
            ("node=10\nor", ["character 11"]),
            ("\x1b[2J", ["\\x1B"]),
        ]:
            for verb in ("decode", "monitor"):
                self.assert_refused(run(verb, str(self.log), "--filter", text), USAGE, *parts)

    def test_a_log_without_a_match_says_so(self):
        for verb in ("decode", "monitor"):
            result = run(verb, str(self.log), "--filter", "node=10 and temperature>90degC")
            self.assertEqual((result.returncode, result.stdout), (DONE, ""))
            self.assertEqual(
                result.stderr, f"{self.log}: none of 8 frames passes the filter, never true: temperature>90degC\n"
            )

    def test_the_examples_of_the_help_can_be_typed(self):
        self.log.with_name("night.log").write_text(LOG)
        for verb in ("decode", "monitor"):
            text = self.assert_done(run(verb, "--help"))
            examples = [line.strip() for line in text[text.index("Examples:") :].splitlines()[1:] if line.strip()]
            self.assertGreater(len(examples), 2)
            for example in examples:
                words = shlex.split(example)
                self.assertEqual(words[:2], ["canvoy", verb])
                if words[2].startswith("can0"):
                    continue  # there is no such interface here
                done = subprocess.run([CANVOY, *words[1:]], cwd=self.log.parent, capture_output=True, text=True, check=False)
                self.assertEqual((done.stderr, done.returncode), ("", DONE), example)
                self.assertTrue(done.stdout or {"--out", "--parquet"} & set(words), example)


if __name__ == "__main__":
    unittest.main()
