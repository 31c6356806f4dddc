#!/usr/bin/env python3
"""First lines as a newcomer types them: accepted where it is plain what was meant, else refused with the line to type."""

import csv
import io
import json
import os
import pathlib
import pty
import sqlite3
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

LOG = "(1700000000.000000) can0 18A#A00001\n(1700000000.100000) can0 18A#A80001\n(1700000000.300000) can0 70A#05\n(1700000000.400000) can0 185##1AABB\n"


def piped(text, *arguments):
    return subprocess.run([CANVOY, *arguments], input=text, capture_output=True, text=True, timeout=60, check=False)


def on_terminal(columns, *arguments, of="stdout"):
    """What it prints there on a terminal of so many columns."""
    main, other = pty.openpty()
    subprocess.run(["stty", "cols", str(columns), "rows", "40"], stdin=other, check=True)
    environment = {**os.environ, "NO_COLOR": "1", "TERM": "xterm"}
    streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, of: other}
    program = subprocess.Popen([CANVOY, *arguments], env=environment, **streams)
    os.close(other)
    shown = b""
    while True:
        try:
            read = os.read(main, 65536)
        except OSError:
            break
        if not read:
            break
        shown += read
    os.close(main)
    program.wait(60)
    return shown.decode().replace("\r\n", "\n")


class FirstLines(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name, text=LOG):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def test_a_pipe_and_a_frame_are_decoded(self):
        told = piped("(1700000000.000000) can0 70A#05\n", "decode")
        self.assertEqual((told.returncode, told.stderr), (DONE, ""))
        self.assertIn("node 10 (0Ah): operational", told.stdout)
        self.assertIn("temperature = 20", self.assert_done(run("decode", "18A#A00001", "--node", "10=418")))
        self.assertEqual(len(self.assert_done(run("decode", "70A#05", "705#04")).splitlines()), 2)
        self.assert_refused(run("decode", "18A#A"), USAGE, "'18A#A' is no frame")
        self.assert_refused(run("decode", "a.log", "b.log"), USAGE, "one log at a time")

    def test_frames_of_can_fd_are_shown_raw(self):
        self.assertIn("185##1AABB            CAN FD", self.assert_done(run("decode", self.path("a.log"))))
        last = self.assert_done(run("decode", self.path("a.log"), "--json")).splitlines()[-1]
        self.assertEqual(json.loads(last)["service"], "CAN FD")

    def test_values_are_a_table(self):
        table = self.assert_done(run("decode", self.path("a.log"), "--csv", "--node", "10=418"))
        rows = list(csv.DictReader(io.StringIO(table)))
        values = [(row["time"], row["bus"], row["node"], row["index"], row["value"], row["unit"]) for row in rows if row["name"] == "temperature"]
        self.assertEqual([each[1:4] + each[5:] for each in values], [("can0", "10", "6010", "°C")] * 2)
        self.assertEqual([float(each[4]) for each in values], [20.0, 21.0])

    def test_on_eighty_columns_each_value_is_whole(self):
        log = self.path("a.log")
        wide = self.assert_done(run("decode", log, "--node", "10=418"))
        values = wide.splitlines()[0].split(": ", 1)[1].split(", ")
        for columns in (40, 80, 100):
            shown = on_terminal(columns, "decode", log, "--node", "10=418")
            self.assertLessEqual(max(len(line) for line in shown.splitlines()), columns)
            joined = " ".join(line.strip() for line in shown.splitlines())
            for value in values:
                self.assertIn(value, joined, columns)
            self.assertNotIn("can0", shown, "there is one bus")
            self.assertTrue(shown.startswith("   0.000 18A#A00001"), shown)
        self.assertIn("(1700000000.000000) can0", on_terminal(200, "decode", log, "--node", "10=418"))

    def test_codes_are_explained_and_objects_found(self):
        self.assertIn("06090011h: the object has no such sub-index", self.assert_done(run("explain", "06090011")))
        self.assertIn("emergency code", self.assert_done(run("explain", "8130")))
        self.assertIn("TPDO1 of node 10 (0Ah)", self.assert_done(run("explain", "18A")))
        self.assertIn("pre-operational", self.assert_done(run("explain", "7F")))
        self.assertIn("NMT state: 05h in a heartbeat", self.assert_done(run("explain", "operational")))
        self.assertIn("object (CiA 301): 1017h", self.assert_done(run("explain", "0x1017")))
        self.assert_refused(run("explain", "fast"), USAGE, "canvoy search fast looks for names")
        found = self.assert_done(run("search", "temperature"))
        self.assertIn("CiA 418", found)
        self.assertEqual(len(found.splitlines()), len(set(found.splitlines())))
        told = self.assert_told(run("search", "battery_temperature", "--json"))
        self.assertIn("°C", {each.get("unit") for each in told})
        self.assert_refused(run("search", "nothing like that"), FAILED, "no object")

    def test_help_completion_and_out(self):
        self.assertEqual(self.assert_done(run("help", "decode")), self.assert_done(run("decode", "--help")))
        for shell, file in (("bash", "canvoy.bash"), ("zsh", "_canvoy")):
            packaged = pathlib.Path("scripts/completion", file).read_text()
            self.assertEqual(self.assert_done(run("completion", shell)), packaged)
        out = str(self.folder / "battery.eds")
        self.assert_done(run("eds", "export", "battery", "-o", out))
        self.assertIn("[DeviceInfo]", pathlib.Path(out).read_text())

    def test_lines_of_help_are_at_most_100_columns(self):
        for verb in ("device", "decode", "monitor", "convert-log", "run", "record", "export"):
            for line in self.assert_done(run(verb, "--help")).split("Examples:")[0].splitlines():
                self.assertLessEqual(len(line), 100, (verb, line))
        self.assertIn("Lifts (CiA 417):", self.assert_done(run("device", "--help")))

    def test_help_fits_the_terminal(self):
        for verb in ((), ("device",), ("decode",), ("monitor",), ("check",), ("run", "lift"), ("record",)):
            whole = self.assert_done(run(*verb, "--help"))
            for columns in (40, 60, 80, 100, 200):
                shown = on_terminal(columns, *verb, "--help")
                options, _, examples = shown.partition("Examples:\n")
                for line in shown.splitlines():
                    # Names of options and their choices stay whole, and so does what is in quotes.
                    is_name = columns < 80 and line.startswith("  ") and (line.strip().count(" ") < 2 or line.strip().startswith("'"))
                    self.assertTrue(is_name or len(line) <= min(columns, 100), (verb, columns, line))
                # Lists are parted behind their commas.
                self.assertEqual("".join(options.split()), "".join(whole.partition("Examples:\n")[0].split()))
                # What goes on in the next line is one line for a shell.
                self.assertEqual(examples.replace(" \\\n      ", " "), whole.partition("Examples:\n")[2], (verb, columns))

    def test_messages_fit_the_terminal(self):
        log = self.path("a.log")
        for line in (("read", "10", "1018"), ("decode", log, "--filter", "tempersture>40"), ("run", "charger", "--for", "soon"), ("decode", log, "--filter", "node=99")):
            whole = run(*line).stderr
            for columns in (40, 80):
                shown = on_terminal(columns, *line, of="stderr")
                self.assertEqual(shown.split(), whole.split())
                for each in shown.splitlines():
                    self.assertTrue(len(each) <= columns or " " not in each.strip(), (columns, each))
                for each in shown.splitlines()[1:]:
                    self.assertTrue(each.startswith("  "), each)
        self.assertIn("\n  ", on_terminal(40, "read", "10", "1018", of="stderr"))

    def test_without_a_bus_the_line_to_type_is_told(self):
        self.assert_refused(run("read", "10", "1018"), USAGE, "which bus? canvoy read can0 10 1018; or export CANVOY_BUS=can0")
        self.assert_refused(run("script", "a.canvoy"), USAGE, "which bus? canvoy script can0 a.canvoy")
        self.assert_refused(run("nmt", "start", "10"), USAGE, "which bus? canvoy nmt can0 10 start")
        self.assert_refused(run("lss", "scan"), USAGE, "which bus? canvoy lss can0 scan")
        self.assert_refused(run("monitor"), USAGE, "which bus? canvoy monitor can0")
        self.assert_refused(run("device", "battery"), USAGE, "the bus is missing: canvoy device battery can0")

    def test_what_was_meant_is_told(self):
        log = self.path("a.log")
        for line, parts in (
            ((), ("which verb?", "canvoy --help")),
            (("decode", log, "-f", "EMCY"), ("'-f' is not known here; did you mean '--filter'?",)),
            (("decode", log, "--parquet"), ("--parquet: its value is missing",)),
            (("decode", log, "--filter", "0x18A"), ("did you mean 'id=18A'?",)),
            (("decode", log, "10"), (f"canvoy decode {log} --filter node=10",)),
            (("candump", "can0"), ("canvoy monitor can0",)),
            (("record", "can0"), ("canvoy record can0 night.log",)),
            (("replay", "can0"), ("canvoy replay night.log can0",)),
            (("export", "csv", log), (f"canvoy decode {log} --csv",)),
            (("nmt", "can0", "reset", "10"), ("canvoy nmt can0 10 reset-node, or reset-communication",)),
        ):
            self.assert_refused(run(*line), USAGE, *parts)
        self.assertTrue(self.assert_done(run("version")).startswith("canvoy "))

    def test_a_log_is_one_by_any_of_its_names(self):
        for name in ("b.csv", "b.log.gz", "b.blf", "b.trc", "b.pcap", "b.mf4", "b.db", "b.db.gz"):
            self.assert_done(run("convert-log", self.path("a.log"), str(self.folder / name)))
            shown = subprocess.run([pathlib.Path(CANVOY).resolve(), "monitor", name], cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual((shown.returncode, len(shown.stdout.splitlines())), (DONE, 3), (name, shown.stderr))

    def test_logs_beside_go_by_the_end_of_the_name(self):
        logs = [str(self.folder / name) for name in ("a.log", "a.mf4", "a.db")]
        for log in logs:
            self.assert_done(run("run", "charger", "--for", "20s", "--log", log))
        lines = [self.assert_done(run("decode", log)).replace(" sim ", " can0 ").splitlines() for log in logs]
        self.assertEqual([len(each) for each in lines], [len(lines[0])] * 3)
        self.assertEqual([each.split()[0] for each in lines[0]], [each.split()[0] for each in lines[1]])
        self.assertEqual([each.split()[2] for each in lines[0]], [each.split()[2] for each in lines[2]])
        odd = self.path("a.txt")
        self.assert_done(run("run", "charger", "--for", "1s", "--log", odd))
        self.assertTrue(pathlib.Path(odd).read_text().startswith("("), "any other name is a log of candump")

    def test_a_database_of_others_gets_one_line(self):
        path = str(self.folder / "people.db")
        with sqlite3.connect(path) as database:
            database.execute("CREATE TABLE people(name)")
        self.assert_refused(run("decode", path), FAILED, "it has no table 'messages', only people")

    def test_values_are_a_parquet_file(self):
        table = self.folder / "a.parquet"
        self.assertEqual(self.assert_done(run("decode", self.path("a.log"), "--parquet", str(table), "--node", "10=418")), "")
        self.assertEqual((table.read_bytes()[:4], table.read_bytes()[-4:]), (b"PAR1", b"PAR1"))
        self.assert_refused(run("decode", self.path("a.log"), "--parquet", self.path("a.log")), USAGE, "is the log itself")
        self.assert_refused(run("decode", self.path("a.log"), "--parquet", "a", "--csv"), USAGE, "--csv")

    def test_what_a_format_does_not_keep_is_told(self):
        two = LOG.replace("can0 70A", "can1 70A")
        told = self.assert_done(run("convert-log", self.path("a.log", two), str(self.folder / "b.csv")))
        self.assertTrue(told.endswith("; not kept: which bus a frame is of\n"), told)

    def test_statistics_of_a_log(self):
        rows = [json.loads(line) for line in self.assert_done(run("stats", self.path("a.log"), "--json")).splitlines()]
        first = next(row for row in rows if row["id"] == "18A")
        self.assertEqual((first["frames"], first["node"], first["service"]), (2, 10, "TPDO1"))
        self.assertAlmostEqual(first["cycle_s"], 0.1)
        self.assertLessEqual(max(map(len, self.assert_done(run("stats", self.path("a.log"))).splitlines())), 80)

    def test_a_template_is_said_to_be_one(self):
        sheet = self.path("empty.eds", "[FileInfo]\nFileName=empty.eds\n[DeviceInfo]\nVendorName=Maker\n")
        self.assert_refused(run("eds", "check", sheet), FAILED, "it is a template without objects: describe those of the device")


if __name__ == "__main__":
    unittest.main()
