#!/usr/bin/env python3
"""canvoy load: responses by the analysis, of lists, networks and logs. Expected times are arithmetic: bits by the paper, over the bit rate."""

import json
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree as xml

from command import DONE, FAILED, USAGE, CommandTest, run

# The example of Davis, Burns, Bril and Lukkien (2007): three frames of 125 bits, a millisecond each.
PAPER = """bit_rate = 125000
[[message]]
id = 0x101
name = "A"
bytes = 7
period = "2500us"
[[message]]
id = 0x102
name = "B"
bytes = 7
period = "3500us"
deadline = "3250us"
[[message]]
id = 0x103
name = "C"
bytes = 7
period = "3500us"
deadline = "3250us"
"""
# A producer of SYNC each 10 ms with a heartbeat; TPDO1 with each second SYNC, TPDO2 by events, TPDO3 with neither inhibit nor event time.
SHEET = """[FileInfo]
FileName=pump.eds
[DeviceInfo]
VendorName=Maker
"""


def entry(place, data_type, value):
    return f"[{place}]\nParameterName=x\nObjectType=0x7\nDataType={data_type}\nAccessType=rw\nDefaultValue={value}\n"


def record(index, *values):
    """The entries of an object behind its number of them: data type and value each."""
    text = f"[{index}]\nParameterName=x\nObjectType=0x9\nSubNumber={len(values) + 1}\n" + entry(f"{index}sub0", "0x5", len(values))
    return text + "".join(entry(f"{index}sub{sub}", *value) for sub, value in enumerate(values, 1))


def pump():
    lists = "[MandatoryObjects]\nSupportedObjects=2\n1=0x1000\n2=0x1001\n[OptionalObjects]\nSupportedObjects=9\n" + "".join(
        f"{number}=0x{index}\n" for number, index in enumerate(("1005", "1006", "1017", "1800", "1801", "1802", "1A00", "1A01", "1A02"), 1)
    )
    objects = entry("1000", "0x7", "0") + entry("1001", "0x5", "0") + entry("1005", "0x7", "0x40000080") + entry("1006", "0x7", "10000") + entry("1017", "0x6", "500")
    for number, kind, inhibit in ((0, 2, 0), (1, 255, 50), (2, 255, 0)):
        objects += record(f"180{number}", ("0x7", f"$NODEID+0x{number + 1}80"), ("0x5", kind), ("0x6", inhibit))
        objects += record(f"1A0{number}", ("0x7", "0x20000020"), ("0x7", "0x20010010"))
    return SHEET + lists + objects


class LoadTest(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name, text):
        (self.folder / name).write_text(text)
        return str(self.folder / name)

    def told(self, *arguments, status=DONE):
        """Messages by their identifiers, and what is said of the bus."""
        done = run("load", *arguments, "--json")
        self.assertEqual((done.stderr, done.returncode), ("", status))
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        return {line["id"]: line for line in lines if "id" in line}, lines[-1]

    def test_the_example_of_the_paper_misses_a_deadline(self):
        messages, bus = self.told(self.path("a.toml", PAPER), status=FAILED)
        self.assertEqual([messages[each]["response_s"] for each in ("101", "102", "103")], [0.002, 0.003, 0.0035])
        self.assertEqual([messages[each]["met"] for each in ("101", "102", "103")], [True, True, False])
        self.assertEqual((messages["103"]["instances"], bus["late"]), (2, 1))
        self.assertAlmostEqual(bus["load_percent"], 100 / 2.5 + 200 / 3.5)

    def test_another_bit_rate_and_errors_are_tried(self):
        messages, bus = self.told(self.path("a.toml", PAPER), "--bit-rate", "250")
        self.assertEqual([messages[each]["response_s"] for each in ("101", "102", "103")], [0.001, 0.0015, 0.0015])
        self.assertEqual(bus["late"], 0)
        # An error is 31 bits and a frame, 0.624 ms; then A has the bus once more (at 2.124 ms, before 2.5 ms it has not).
        messages, _ = self.told(self.path("a.toml", PAPER), "--bit-rate", "250", "--errors", "1")
        self.assertEqual([messages[each]["response_s"] for each in ("101", "102", "103")], [0.001624, 0.002124, 0.002124])
        messages, _ = self.told(self.path("a.toml", PAPER), "--bit-rate", "250", "--error-each", "1500us")
        self.assertEqual(messages["101"]["response_s"], 0.001 + 2 * 0.000624)

    def test_a_message_more_is_tried(self):
        more = self.path("more.toml", '[[message]]\nid = 0x100\nbytes = 7\nperiod = "100ms"\n')
        messages, _ = self.told(self.path("a.toml", PAPER), "--bit-rate", "250", "--add", more)
        self.assertEqual(messages["101"]["response_s"], 0.0015)
        self.assertEqual((messages["100"]["response_s"], messages["100"]["bits_max"]), (0.001, 125))
        messages, _ = self.told(self.path("a.toml", PAPER), "--bit-rate", "250", "--add", "20=battery")
        self.assertIn(20, {each.get("node") for each in messages.values()})

    def test_breakdown_is_where_the_first_is_late(self):
        # 2 ms of each period of 10 for its own and a blocking frame: it is late below 2 ms.
        two = '[[message]]\nid = 1\nbytes = 7\nperiod = "10ms"\n[[message]]\nid = 2\nbytes = 7\nperiod = "40ms"\n'
        _, bus = self.told(self.path("a.toml", "bit_rate = 125000\n" + two))
        self.assertAlmostEqual(bus["breakdown_scale"], 0.2, delta=0.0004)
        self.assertAlmostEqual(bus["breakdown_percent"], 62.5, delta=0.2)

    def test_deadlines_stand_in_a_file(self):
        deadlines = self.path("d.toml", '[[deadline]]\nid = 0x101\ndeadline = "999us"\n')
        messages, bus = self.told(self.path("a.toml", PAPER), "--bit-rate", "250", "--deadlines", deadlines, status=FAILED)
        self.assertEqual((messages["101"]["met"], bus["late"]), (False, 1))

    def test_a_log_tells_periods_and_load(self):
        # 181h each 10 ms, once 2 ms late; 120 bits of the first frame with the intermission, as canbusload counts them.
        times = [0, 10_000, 22_000, 30_000, 40_000]
        log = "".join(f"(1700000000.{each:06}) can0 181#0102030405060708\n" for each in times)
        messages, bus = self.told(self.path("a.log", log), "--bit-rate", "125")
        told = messages["181"]
        self.assertEqual((told["period_s"], told["ahead_s"], told["distance_s"], told["frames"]), (0.01, 0.002, 0.008, 5))
        self.assertAlmostEqual(bus["load_percent"], 5 * 120 / 125_000 / 0.04 * 100)
        self.assertEqual((told["service"], told["node"], told["response_s"]), ("TPDO1", 1, 0.00108))  # 135 bits
        for name in ("b.asc", "b.trc", "b.blf", "b.pcapng", "b.log.gz", "b.csv"):
            self.assert_done(run("convert-log", str(self.folder / "a.log"), str(self.folder / name)))
            again, _ = self.told(str(self.folder / name), "--bit-rate", "125")
            self.assertEqual({**again["181"], "bus": "can0"}, told, name)

    def test_a_burst_is_no_more_than_its_distance_allows(self):
        log = "".join(f"(1700000000.{each:06}) can0 181#01020304050607\n" for each in (0, 2000, 4000))
        log += "(1700000000.900000) can0 182#01020304050607\n"
        messages, _ = self.told(self.path("a.log", log), "--bit-rate", "125")
        self.assertEqual(messages["182"]["response_s"], 0.002)

    def test_more_than_a_bus_carries_is_no_load(self):
        # 120 bits each millisecond are 12 % at 1 Mbit/s, and 120 % at 100 kbit/s.
        log = self.path("a.log", "".join(f"(1.{each:03}000) can0 181#0102030405060708\n" for each in range(100)))
        self.assertIn("is 100 kbit/s its bit rate", run("load", log, "--bit-rate", "100").stdout)
        self.assertNotIn("its bit rate", run("load", log, "--bit-rate", "1000").stdout)

    def test_buses_of_a_log_are_told_apart(self):
        log = self.path("a.log", "(1.000000) can0 181#00\n(1.500000) can1 182#00\n(2.000000) can0 181#00\n")
        done = self.assert_done(run("load", log, "--bit-rate", "125"))
        self.assertIn("can0 at 125 kbit/s, 2 frames heard in 1.000 s", done)
        self.assertIn("can1 at 125 kbit/s, 1 frame heard in 1.000 s", done)
        messages, _ = self.told(log, "--bit-rate", "125", "--bus", "can1")
        self.assertEqual(list(messages), ["182"])
        self.assert_refused(run("load", log, "--bit-rate", "125", "--bus", "can2"), USAGE, "there is no bus can2; there are can0, can1")
        self.assert_refused(run("load", log, "--bit-rate", "125", "--add", "20=battery"), USAGE, "say --bus NAME")

    def test_nodes_are_described_by_their_sheets(self):
        self.path("pump.eds", pump())
        network = self.path("n.toml", '[[node]]\nid = 5\nsheet = "pump.eds"\n')
        messages, bus = self.told(network, "--bit-rate", "125")
        self.assertEqual(set(messages), {"080", "185", "285", "705"})
        # SYNC: its 55 bits behind the longest other frame, of 6 bytes: 34 + 48 + 13 + 20 = 115 bits.
        self.assertEqual(messages["080"]["response_s"], 0.00136)  # 8 us a bit
        # TPDO1 comes with each second SYNC, and is queued when SYNC is there.
        self.assertEqual((messages["185"]["period_s"], messages["185"]["offset_s"], messages["185"]["jitter_s"]), (0.02, 0, 0.00136))
        self.assertEqual((messages["285"]["period_s"], messages["705"]["period_s"]), (0.005, 0.5))
        self.assertEqual(bus["left_out"], ["385h, TPDO3 5, has neither inhibit nor event time"])
        self.assert_refused(run("load", network), USAGE, "--bit-rate 125")

    def test_a_network_that_is_played_is_heard_as_its_log_has_it(self):
        path = self.path("lift.toml", run("run", "lift", "--print").stdout)
        run("run", path, "--for", "5s", "--log", str(self.folder / "run.log"))
        frames = (self.folder / "run.log").read_text().count("\n")
        done = run("load", path, "--for", "5s", "--json")
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(sum(line["frames"] for line in lines if "id" in line), frames)
        self.assertEqual({line["bit_rate"] for line in lines if "bit_rate" in line}, {250_000})
        later = sum(float(line[1 : line.index(")")]) > 2 for line in (self.folder / "run.log").read_text().splitlines())
        done = run("load", path, "--after", "2s", "--for", "3s", "--json")
        self.assertEqual(sum(line.get("frames", 0) for line in map(json.loads, done.stdout.splitlines())), later)

    def test_a_picture_has_a_bar_for_each_message(self):
        path = str(self.folder / "a.svg")
        run("load", self.path("a.toml", PAPER), "--svg", path)
        rects = xml.parse(path).getroot().findall("{http://www.w3.org/2000/svg}rect")
        self.assertEqual(len(rects), 1 + 2 * 3)  # the page, and of each a bar and a deadline
        self.assertEqual(len({each.get("fill") for each in rects}), 4)  # white, met, late, deadlines

    def test_tables_have_80_columns(self):
        done = run("load", self.path("a.toml", PAPER.replace('"A"', '"Geschwindigkeit über Grund"')))
        self.assertEqual(done.returncode, FAILED)
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)
        self.assertIn("1 of 3 deadlines are missed", done.stdout)

    def test_what_is_wrong_is_told_in_one_line(self):
        def refused(text, *parts, arguments=(), status=FAILED):
            self.assert_refused(run("load", self.path("a.toml", text), *arguments), status, *parts)

        refused(PAPER.replace("0x102", "0x101"), "101h is sent twice: by A and by B")
        refused(PAPER.replace('period = "2500us"\n', ""), "line 2: say how often it comes")
        refused(PAPER.replace("0x101", "0x20000000"), "line 3: id: 536870912 is not from 0 to 536870911")
        refused(PAPER.replace("bytes = 7", "bytes = 9", 1), "line 5: bytes: 9 is not from 0 to 8")
        refused(PAPER.replace("2500us", "25 years"), "line 6: period: '25 years' is no time")
        refused(PAPER + 'offset = "4ms"\n', "offset: is not below the period")
        refused(PAPER + "speed = 1\n", "speed: is not known here")
        refused(PAPER.replace("bit_rate = 125000\n", ""), "say it in kbit/s, as --bit-rate 125", status=USAGE)
        refused(PAPER, "are for what is listened to", arguments=("--for", "1s"), status=USAGE)
        refused(PAPER, "ends like no picture", arguments=("--svg", "a.png"), status=USAGE)
        refused('network = "house"\n', "'house' is not known")
        refused("", "no node stands in it")
        self.assert_refused(run("load", str(self.folder / "no.toml")), FAILED, "no.toml")
        self.assert_refused(run("load", self.path("a.log", "")), FAILED, "a.log")
        one = self.path("one.log", "(1.0) can0 705#05\n")
        self.assert_refused(run("load", one, "--bit-rate", "125"), FAILED, "its frames have one time")
        self.assert_refused(run("load", one, "--bit-rate", "125", "--after", "9s"), FAILED, "nothing was heard after 9s")
        errors = "".join(f"({each}.0) can0 20000088#0000040000000000\n" for each in range(9))
        self.assert_refused(run("load", self.path("a.log", errors), "--bit-rate", "125"), FAILED, "error frames alone", "canvoy doctor")
        many = "".join(f"(1.{each:06}) can0 {each:08X}#\n" for each in range(1025))
        self.assert_refused(run("load", self.path("a.log", many), "--bit-rate", "125"), FAILED, "more than 1024 identifiers")


if __name__ == "__main__":
    unittest.main()
