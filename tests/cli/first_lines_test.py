#!/usr/bin/env python3
"""First lines as a newcomer types them: accepted where it is plain what was meant, else refused with the line to type."""

import csv
import dataclasses
import io
import json
import os
import pathlib
import pty
import re
import sqlite3
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.43:43143"

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
        self.assertIn("185##1AABB            CAN FD", self.assert_decoded(run("decode", self.path("a.log"))))
        last = self.assert_decoded(run("decode", self.path("a.log"), "--json")).splitlines()[-1]
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
        for shell, file in (("bash", "canvoy.bash"), ("zsh", "_canvoy"), ("fish", "canvoy.fish")):
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
            (("decode", log, "-t", "EMCY"), ("'-t' is not known here; did you mean '--transfers'?",)),
            (("decode", log, "--dbc", "a.dbc"), ("--eds 10=pump.eds",)),
            (("decode", log, "--parquet"), ("--parquet: its value is missing, as in canvoy decode bus.log --parquet values.parquet",)),
            (("decode", log, "--hex", "--json"), (f"without it: canvoy decode {log} --json; see canvoy decode --help",)),
            (("stats", log, "--table"), (f"without it: canvoy stats {log}; see",)),
            (("eds", "convert", "pump.eds"), (": canvoy eds convert pump.eds pump.xdd; see canvoy eds convert --help",)),
            (("doctor", log, "--node", "10"), ("which profile has node 10? --node 10=418",)),
            (("run", "charger", "--for", "10"), ("'10' has no unit: 10ms, 10s or 10min",)),
            (("read", "can0", "10", "1017", "--timeout", "2000000h"), ("'2000000h' is more than a hundred years",)),
            (("nmt", "can0", "start"), ("which node? canvoy nmt can0 10 start, or canvoy nmt can0 all start",)),
            (("send", "can0", "18A", "2", "A0", "00"), ("canvoy send can0 18A#A000, or 18A#02A000",)),
            (("decode", log, "10"), (f"canvoy decode {log} --filter node=10",)),
            (("candump",), ("canvoy monitor can0",)),
            (("download", "can0", "10", "app.bin"), ("canvoy write can0 10 app.bin",)),
            (("record", "can0"), ("canvoy record can0 night.log",)),
            (("replay", "can0"), ("canvoy replay night.log can0",)),
            (("read", log), (f"of a log there are canvoy decode {log}",)),
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

    def test_lines_for_programs_go_into_a_file(self):
        log = self.path("a.log")
        for option, name in (("--json", "out.jsonl"), ("--csv", "out.csv")):
            out = self.folder / name
            self.assertEqual(self.assert_decoded(run("decode", log, option, "--out", str(out))), "")
            self.assertEqual(out.read_text(), self.assert_decoded(run("decode", log, option)))
        self.assert_refused(run("decode", log, "--json", "--out", log), USAGE, "a.log is a log: leave one of them out")
        self.assertEqual(pathlib.Path(log).read_text(), LOG)

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


@dataclasses.dataclass
class Row:
    """A line as it was typed, and what is seen where it is right; of another, the line that it is told."""

    line: str
    seen: str = ""
    told: str = ""


# Written down by what `canvoy --help` and `canvoy help VERB` say, by habits of candump, cansend and canplayer, canopend (CiA 309-3),
# python-canopen, and tools of Vector and PEAK, before one of them was tried. 13 of the 50 were right then.
FIFTY = [
    Row("canvoy monitor can0 -n 5", "heartbeat"),
    Row("canvoy monitor can0,180:780 --count 2", "TPDO1"),
    Row("canvoy monitor can0 --count 3 --filter 70A", "heartbeat"),
    Row("canvoy monitor any --count 2", told="one bus has to be named"),
    Row("canvoy send can0 000#0100"),
    Row("canvoy send can0 60A#40.18.10.01.00.00.00.00"),
    Row("canvoy send can0 60A 40 18 10 01 00 00 00 00"),
    Row("canvoy send can0 18A#A000 --every 100 --count 3", told="100ms, 100s or 100min"),
    Row("canvoy replay night.log can0=sim0 --speed 0", "frames sent"),
    Row("canvoy record can0 --out night2.log --count 3", "3 frames in night2.log"),
    Row("canvoy record can0 night3.blf --for 1", told="1ms, 1s or 1min"),
    Row("canvoy decode night.log --filter 'id==18A' --count 2", "TPDO1"),
    Row("canvoy decode night.log --filter 'id=0x18A' --count 2", "TPDO1"),
    Row("canvoy decode night.log --filter 18A:7FF --count 2", "TPDO1"),
    Row("canvoy decode night.log --node 10 --count 2", "node 10"),
    Row("canvoy decode night.log --dbc battery.dbc", told="--eds 10=pump.eds"),
    Row("canvoy stats night.log --bit-rate 500000", "% of 500 kbit/s"),
    Row("canvoy load night.log --bitrate 125k", "at 125 kbit/s"),
    Row("canvoy read can0 10 0x1017 0 u16", "00"),
    Row("canvoy write can0 10 0x1017 0 u16 1000", "-> 1000"),
    Row("canvoy read can0 10 1018 1", "00000000h"),
    Row("canvoy read can0 10 'Manufacturer device name'", "Canvoy CiA 418 battery"),
    Row("canvoy read can0 10 'Identity object.Serial number'", "00000000h"),
    Row("canvoy read can0 10 0x1018/1", "00000000h"),
    Row("canvoy write can0 10 'Producer heartbeat time' 500", "-> 500 ms"),
    Row("canvoy write can0 10 1017 500 ms", "-> 500 ms"),
    Row("canvoy write can0 10 1017=500", "-> 500 ms"),
    Row("canvoy read can0 10 0x1018:0x04", "00000000h"),
    Row("canvoy nmt can0 10 OPERATIONAL", "node 10 (0Ah) is operational"),
    Row("canvoy nmt can0 10 reset node", "node 10 (0Ah) has booted"),
    Row("canvoy nmt can0 0 preop", "node 10 (0Ah) is pre-operational"),
    Row("canvoy nmt can0 start", told="canvoy nmt BUS 10 start, or canvoy nmt BUS all start"),
    Row("timeout -s INT 1 canvoy sync can0 100ms"),
    Row("canvoy sync can0 --period 10ms --count 3"),
    Row("canvoy lss can0 fastscan", "vendor 0h, product 1A2h"),
    Row("canvoy lss can0 set-bit-rate 250"),  # it is told that there are two
    Row("canvoy eds pump.eds", "0 errors"),
    Row("canvoy eds read can0 10 node10.dcf", "node10.dcf"),
    Row("canvoy device battery can0 11 --for 1s", "battery node 11 (0Bh)"),
    Row("canvoy device battery can0 --node 11 --for 1s", "battery node 11 (0Bh)"),
    Row("canvoy expect can0 10 temperature in 15 .. 30", "PASS node 10 (0Ah): temperature"),
    Row("canvoy wait can0 10 heartbeat", "heartbeat        node 10"),
    Row("canvoy plot night.log 6010 --node 10", "temperature (10)"),
    Row("canvoy pdo can0 10 tpdo 1", "18A#"),
    Row("canvoy explain 0x05040000", "SDO time-out"),
    Row("canvoy explain 58A#8010180100000206", "06020000h"),
    Row("canvoy profile CiA418", "CiA 418"),
    Row("canvoy run charger --duration 60s", "PASS"),
    Row("canvoy configure can0 10 battery.dcf --dry-run", "entries"),
    Row("canvoy convert-log night.log -o night.asc", "frames of a candump log"),
]


# Written down before the fifty were mended, and tried behind that: 17 were right.
TWENTY_FIVE = [
    Row("canvoy monitor can0 --node 10 --count 3", "node 10"),
    Row("canvoy monitor can0 --id 18A --count 1", "TPDO1"),
    Row("canvoy send can0 0x123#11223344"),
    Row("canvoy send can0 123 DEADBEEF"),
    Row("canvoy record can0 night2.asc 1s", "frames in night2.asc"),
    Row("canvoy read can0 10 1018.4", "00000000h"),
    Row("canvoy read can0 10 1008 --type string", "Canvoy CiA 418 battery"),
    Row("canvoy read can0 --node 10 --index 0x1018 --subindex 1", "00000000h"),
    Row("canvoy write can0 10 0x1017 0x00 0x03E8", "-> 1000 ms"),
    Row("canvoy write can0 10 1017 1000 u16", "-> 1000"),
    Row("canvoy nmt can0 10 reset-comm", "node 10 (0Ah) has booted"),
    Row("canvoy nmt can0 all reset", told="canvoy nmt BUS all reset-node, or reset-communication"),
    Row("canvoy nmt can0 10 pre_operational", "node 10 (0Ah) is pre-operational"),
    Row("canvoy lss can0 scan --assign 20 --timeout 100", told="100ms, 100s or 100min"),
    Row("canvoy lss can0 set-node-id 20 --save"),  # it is told that there are two
    Row("canvoy decode night.log --node-id 10", "node 10"),
    Row("canvoy convert-log night.log --to asc", told="canvoy convert-log night.log night"),
    Row("canvoy stats can0 1s", "heartbeat 10"),
    Row("canvoy wait can0 --timeout 5s heartbeat", "heartbeat"),
    Row("canvoy expect can0 10 temperature '>' 15", "PASS node 10 (0Ah): temperature"),
    Row("canvoy scan can0 --nodes 1-20", told="see canvoy scan --help"),
    Row("canvoy export dbc can0 --node 10", "BO_ 1802"),
    Row("canvoy store can0 10 all --timeout 10", told="10ms, 10s or 10min"),
    Row("timeout -s INT 2 canvoy view night.log --port 8080", "http://127.0.0.1:8080/"),
    Row("canvoy emcy can0 10 0x8130 0x11 01 02 03 04 05"),
]

# Written down and tried behind that: 19 were right.
LAST = [
    Row("canvoy monitor can0 -f EMCY --for 1s"),
    Row("canvoy candump can0 -n 2", "node 10"),
    Row("canvoy cansend can0 123#DEADBEEF"),
    Row("canvoy monitor can0,700:780,100:7FF -n 2", "heartbeat"),
    Row("canvoy send can0 701#05 --interval 100ms --count 2"),
    Row("canvoy decode night.log --node 5,10 -n 3", "node 10"),
    Row("canvoy decode --node 10=418 night.log -n 1", "boot-up"),
    Row("canvoy decode night.log | head -2", "boot-up"),
    Row("canvoy get can0 10 0x1000 0", "000001A2h"),
    Row("canvoy read can0 10 0x100A 0x00", '"'),
    Row("canvoy read can0 10 6060 --watch --count 1", "battery_voltage"),
    Row("canvoy read can0 10 temperature -n 1 --interval 200ms", "20.000 °C"),
    Row("canvoy set can0 10 0x1017 500ms", "-> 500 ms"),
    Row("canvoy write can0 0x0A 1017:00 1000", "-> 1000 ms"),
    Row("canvoy start can0 10", "node 10 (0Ah) is operational"),
    Row("canvoy reset node can0 10", "node 10 (0Ah) has booted"),
    Row("canvoy nmt can0 0x0A start", "node 10 (0Ah) is operational"),
    Row("canvoy plot night.log battery_voltage -o v.svg && grep -c '<svg' v.svg", "1"),
    Row("canvoy plot night.log 0x6060 0x6070", "battery_voltage (10)"),
    Row("canvoy eds info pump.eds", "0 errors"),
    Row("canvoy eds convert pump.eds xdd", told="name it .eds, .dcf, .xdd or .xdc"),
    Row("canvoy export dbc pump.eds pump.dbc && grep -c VERSION pump.dbc", "1"),
    Row("canvoy profile 418 0x6010", "6010h temperature"),
    Row("canvoy search 'charge current'", "charge_current_requested"),
    Row("canvoy device pump.eds can0 --nodeid 12 --for 1s", "pump.eds node 12 (0Ch)"),
]


class OnABus(CommandTest):
    """Lines of a table, each typed once, in a folder with a log and a data sheet, at a bus with a battery and one without a node-ID."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        (cls.folder / "canvoy").symlink_to(pathlib.Path(CANVOY).resolve())
        cls.environment = {**os.environ, "PATH": f"{cls.folder}:{os.environ['PATH']}"}
        for node in ("10", "lss"):
            battery = subprocess.Popen([CANVOY, "device", "battery", BUS, "--node-id", node, "--heartbeat", "100ms"], stdout=subprocess.DEVNULL)
            cls.addClassCleanup(battery.wait)
            cls.addClassCleanup(battery.terminate)
        for line in (
            "canvoy wait can0 'heartbeat and node=10'",
            "canvoy run charger --for 60s --log night.log",
            "canvoy eds export battery --out pump.eds",
            "canvoy eds export battery --node-id 10 --out battery.dcf",
            "canvoy convert-log night.log two.asc",
            "sed 's/^ProductName=.*/ProductName=Other/' pump.eds > other.eds",
            "printf '[[slave]]\nnode = 10\n' > network.toml",
        ):
            cls.typed(line)

    @classmethod
    def typed(cls, line):
        line = re.sub(r"\bcan0\b", BUS, line)
        # A DBC is no UTF-8.
        return subprocess.run(["bash", "-c", line], cwd=cls.folder, env=cls.environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", timeout=120, check=False)

    def try_all(self, rows):
        """How many of them are right; each other one leads on."""
        wrong = []
        for row in rows:
            self.typed("canvoy nmt can0 10 start --unchecked")
            result = self.typed(row.line)
            is_told = result.returncode == USAGE and row.told.replace("BUS", BUS) in result.stderr
            is_seen = result.returncode not in (USAGE, 139) and row.seen in result.stdout
            if not (is_told if row.told else is_seen):
                wrong.append((row.line, result.returncode, result.stdout[-300:], result.stderr))
        self.assertEqual(wrong, [])
        return sum(not row.told for row in rows)


class FirstLinesOnABus(OnABus):
    def test_at_least_45_of_50_are_right_at_the_first_try(self):
        self.assertEqual(len(FIFTY), 50)
        self.assertGreaterEqual(self.try_all(FIFTY), 45)

    def test_most_of_fifty_others_are_right(self):
        self.assertEqual(len(TWENTY_FIVE + LAST), 50)
        self.assertGreaterEqual(self.try_all(TWENTY_FIVE + LAST), 43)


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
