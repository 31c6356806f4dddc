#!/usr/bin/env python3
"""First lines by the habits of electricians, of users of python-can, can-utils, Wireshark and Windows, of Germans, and of people with
one file in hand: written down before one was tried. What was right at the first try then stands above each table."""

import pathlib
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network
from first_lines_test import OnABus, Row

ABORT = "the object has no such sub-index"
SAFE = "it is canvoy convert-log IN OUT; see canvoy convert-log --help"

# 19 were right when they were first tried.
FIRST = [
    Row("canvoy scan can0 -v", "Canvoy CiA 418 battery"),
    Row("canvoy read can0 node 10 battery temperature", told="'battery' may be battery_status (6000h:00h)"),
    Row("canvoy identify can0 10", "Product code"),
    Row("canvoy reset can0 10 node", "node 10 (0Ah) has booted"),
    Row("canvoy nmt can0 10 reset communication", "node 10 (0Ah) has booted"),
    Row("canvoy errors can0 10", "0"),
    Row("canvoy explain 8130h", "life guard or heartbeat error"),
    Row("canvoy what is 0x06090011", ABORT),
    Row("timeout -s INT 2 canvoy logger -i socketcan -c can0 -f out.asc", "frames in out.asc"),
    Row("timeout -s INT 10 canvoy player -i socketcan -c can0 night.log", "frames sent"),
    Row("timeout -s INT 2 canvoy viewer -i socketcan -c can0", "node object"),
    Row("canvoy logconvert bus.blf bus2.asc", "frames of a Vector BLF"),
    Row("canvoy sdo upload can0 10 0x1018 1", "00000000h"),
    Row("canvoy sdo write can0 10 0x1017 0 1000", "-> 1000 ms"),
    Row("canvoy nmt can0 10 operational", "node 10 (0Ah) is operational"),
    Row("canvoy read can0 10 0x1018.1", "00000000h"),
    Row("canvoy candump -L can0", told="canvoy record BUS heard.log"),
    Row("canvoy cansend can0 000#010A"),
    Row("canvoy cangen can0 -g 100 -n 5", told="canvoy send can0 123#1122 --every 10ms"),
    Row("canvoy canplayer -I night.log -l i", told="canvoy replay night.log can0 --loop;"),
    Row("canvoy log2asc -I night.log -O lift2.asc can0", told=SAFE),
    Row("canvoy canbusload can0@500000", "500 kbit/s"),
    Row("canvoy tshark -r night.log -Y 'canopen.node_id == 10' -c 3", "node 10"),
    Row("canvoy -r night.log", "boot-up"),
    Row("canvoy stats night.log --csv", "bus,id,service,node,frames,per_second"),
    Row("canvoy decode night.log --dbc pump.dbc", told="--eds 10=pump.eds"),
    Row("canvoy graph night.log temperature", "temperature (10)"),
    Row("canvoy hilfe", "Subcommands:"),
    Row("canvoy lesen can0 10 1018h", "Vendor-ID"),
    Row("canvoy read can0 knoten 10 1008h", "Canvoy CiA 418 battery"),
    Row("canvoy /?", "Subcommands:"),
    Row("canvoy bus.blf", "boot-up"),
    Row("canvoy two.asc", "boot-up"),
    Row("canvoy convert bus.trc bus.csv", "frames of a PEAK TRC"),
    Row("canvoy convert bus.trc --to csv", told="canvoy convert-log bus.trc bus-2.csv"),
    Row("canvoy info bus.mf4", "CAN-ID"),
    Row("canvoy show pump.dbc", told="canvoy export dbc pump.eds"),
    Row("canvoy pump.eds", "0 errors"),
    Row("canvoy validate eds pump.eds", "0 errors"),
    Row("canvoy convert pump.xdd pump2.eds"),
    Row("canvoy configure can0 10 battery.dcf", "entries written"),
    Row("canvoy download battery.dcf --node 10 --bus can0", "entries written"),
    Row("canvoy diff pump.eds other.eds", "Canvoy CiA 418 battery | Other"),
    Row("canvoy export pump.eds out.dbc && cat out.dbc", "VERSION"),
    Row("canvoy simulate pump.eds can0 --node 5 --for 1s", "pump.eds node 5 (05h)"),
    Row("canvoy lift --for 10s", "PASS"),
    Row("canvoy charger.toml --for 10s", "PASS"),
    Row("canvoy sim lift --for 10s", "PASS"),
    Row("canvoy -h decode", "Examples:"),
    Row("canvoy decode -i night.log -o values.csv && cat values.csv", "time,bus,node,index"),
    Row("canvoy decode night.log --filter object=temperature", "temperature = "),
    Row("canvoy monitor can0 --filter 'node 10' --for 1s", "node 10"),
    Row("timeout -s INT 2 canvoy read --watch --count 3 can0 10 temperature", "temperature"),
    Row("canvoy read can0 10 6010h sub 0", "20.000 °C"),
    Row("canvoy write can0 10 heartbeat 500ms", told="Producer heartbeat time (1017h:00h)"),
    Row("canvoy heartbeat can0 10 1s", "-> 1000 ms"),
    Row("canvoy convert-log night.log two.asc c.csv", told=SAFE),
]

# 29 of these 40 were right when they were first tried, behind the mending of those above.
FORTY = [
    Row("canvoy lesen can0 10 1008", "Canvoy CiA 418 battery"),
    Row("canvoy scan can0 --table", told="without it: canvoy scan"),
    Row("canvoy analyse bus.blf", "frames of 3 nodes"),
    Row("canvoy decode bus.mf4 --node 10 | head -2", "node 10"),
    Row("canvoy grep heartbeat night.log", "heartbeat"),
    Row("canvoy bus.trc --filter heartbeat --count 2", "heartbeat"),
    Row("canvoy two.asc --json --count 1", '{"time"'),
    Row("canvoy battery.dcf", "0 errors"),
    Row("canvoy taxi --for 20s", "PASS"),
    Row("canvoy run lift.toml", told="neither a built-in network nor a file"),
    Row("canvoy write can0 10 1017h 250 ms", "-> 250 ms"),
    Row("canvoy write can0 10 0x1017 0x1F4", "-> 500 ms"),
    Row("canvoy read can0 0Ah 1018h sub 2", "000001A2h"),
    Row("canvoy read can0 10 0x1018 --sub 2", "000001A2h"),
    Row("canvoy nmt can0 all start", "node 10 (0Ah) is operational"),
    Row("canvoy stop can0 10", "node 10 (0Ah) is stopped"),
    Row("canvoy start can0", told="canvoy nmt BUS 10 start, or canvoy nmt BUS all start"),
    Row("timeout -s INT 2 canvoy logger -c can0 -f rec.blf", "frames in rec.blf"),
    Row("canvoy python -m can.logger", told="see canvoy --help"),
    Row("canvoy convert-log night.log", told="canvoy convert-log night.log night.asc"),
    Row("canvoy convert night.log bus.blf --force", told=SAFE),
    Row("canvoy write can0 10 1017 5 --dry-run", told="NODE OBJECT [VALUE]; see canvoy write --help"),
    Row("canvoy errors night.log"),
    Row("canvoy error history can0 10", "0"),
    Row("canvoy explain 0x185", "TPDO1 of node 5"),
    Row("canvoy what does 05040001 mean", "command specifier"),
    Row("canvoy plot bus.mf4 temperature -o t.svg && head -c 4 t.svg", "<"),
    Row("canvoy dbc pump.eds -o x.dbc && cat x.dbc", "VERSION"),
    Row("canvoy export html pump.eds p.html && cat p.html", "<html"),
    Row("canvoy compare pump.eds other.eds", "Canvoy CiA 418 battery | Other"),
    Row("canvoy lss scan can0", "vendor 0h"),
    Row("canvoy set-node can0 20", told="NODE OBJECT [VALUE]; see canvoy write --help"),
    Row("canvoy replay bus.blf can0 --speed 100", "frames sent"),
    Row("canvoy monitor can0 --filter 'object temperature' --count 1", "temperature = "),
    Row("canvoy stats bus.trc --csv -o s.csv", told="it is canvoy stats SOURCE"),
    Row("canvoy decode night.log --csv", "time,bus,node"),
    Row("canvoy record can0 test.asc --for 1s", "frames in test.asc"),
    Row("canvoy send can0 0x60A 40 18 10 00"),
    Row("canvoy pdo can0 10 tpdo1", "18A#"),
    Row("canvoy hilfe decode", "Examples:"),
]

# Without a bus. 2 were right when they were first tried.
ALONE = [
    Row("canvoy 18A#AC0001", "TPDO1"),
    Row("canvoy devices", "battery"),
    Row("canvoy list devices", "battery"),
    Row("canvoy profiles", "447-3"),
    Row("canvoy info 447-3", "special-purpose car add-on devices"),
    Row("canvoy show 419", "battery_status"),
    Row("canvoy networks", "excavator"),
    Row("canvoy demo --for 10s", "PASS"),
    Row("canvoy describe 6040", "Controlword"),
    Row("canvoy what is 6040", "Controlword"),
    Row("canvoy run lift taxi", told="canvoy run taxi, or canvoy run lift"),
    Row("canvoy decode 0x18A 01 02", "18A#0102"),
    Row("canvoy decode 0x18a 0xAC 0 --json", '"frame":"18A#AC00"'),
    Row("canvoy explain 0x5#0102", "005#0102"),
    Row("canvoy convert night.log to again.asc", "frames of a candump log"),
    Row("canvoy objects 419", "battery_status"),
    Row("canvoy check night.log", "frames of 3 nodes"),
]

# Options in front of the verb: none was right when it was first tried.
IN_FRONT = [
    Row("canvoy --eds 10=pump.eds decode night.log --filter TPDO", "node 10"),
    Row("canvoy --filter heartbeat --count 2 decode night.log", "heartbeat"),
    Row("canvoy --count 2 night.log", "boot-up"),
    Row("canvoy --type u32 read can0 10 1018:2", "418"),
    Row("canvoy --timeout 1s --bus can0 read 10 1018:2", "000001A2h"),
    Row("canvoy --for 10s run lift", "PASS"),
    Row("canvoy --lifts 2 lift --for 10s", "PASS"),
    Row("canvoy --profile 418 eds check pump.eds", "0 errors"),
    Row("canvoy -n 2 monitor can0", "node 10"),
    Row("canvoy --edz 10=pump.eds decode night.log", told="'--edz' is not known here; did you mean '--eds'? See canvoy decode --help"),
    Row("canvoy --eds pump.eds scan can0", told="'--eds' is not known here; without it: canvoy scan BUS"),
    Row("canvoy --eds pump.eds stats", told="canvoy stats --help"),
    Row("canvoy --dbc pump.dbc decode night.log", told="--eds 10=pump.eds"),
]


class UnseenLines(OnABus):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for line in (
            *(f"canvoy convert-log night.log bus.{ending}" for ending in ("blf", "trc", "mf4")),
            "canvoy eds convert pump.eds pump.xdd",
            "canvoy export dbc pump.eds -o pump.dbc",
            "canvoy run charger --print > charger.toml",
        ):
            made = cls.typed(line)
            assert made.returncode == 0, (line, made.stderr)

    def test_most_are_right_and_the_others_lead_on(self):
        self.assertEqual(len(FIRST), 57)
        self.assertGreaterEqual(self.try_all(FIRST), 46)

    def test_those_without_a_bus_are_right(self):
        self.assertEqual(self.try_all(ALONE), 16)

    def test_most_of_forty_others_are_right(self):
        self.assertEqual(len(FORTY), 40)
        self.assertGreaterEqual(self.try_all(FORTY), 31)

    def test_options_in_front_of_the_verb_are_its_own(self):
        self.assertEqual(self.try_all(IN_FRONT), 9)

    def test_what_is_told_overwrites_nothing(self):
        """Each file that a told line would write is not there, and nothing has changed."""
        before = {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()}
        for line in (
            "canvoy convert-log night.log two.asc c.csv",
            "canvoy convert-log night.log two.asc --force",
            "canvoy convert-log night.log",
            "canvoy convert night.log --to asc",
            "canvoy report night.log",
            "canvoy record can0",
            "canvoy eds convert pump.eds",
        ):
            told = self.typed(line)
            self.assertEqual(told.returncode, 2, line)
            # What the told line writes is its last word.
            for part in told.stderr.split("canvoy ")[1:]:
                words = part.split(";")[0].split()
                self.assertNotIn(words[-1] if len(words) > 2 else "", set(before) - {line.split()[-1]}, told.stderr)
        self.assertEqual(before, {path.name: path.read_bytes() for path in self.folder.iterdir() if path.is_file()})


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
