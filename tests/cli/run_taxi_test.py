#!/usr/bin/env python3
"""`canvoy run taxi` from outside, and devices of CiA 447 that share a node."""

import json
import pathlib
import struct
import tempfile
import unittest

from command import USAGE, FAILED, CommandTest, run


DRIVE = pathlib.Path(__file__).parents[2] / "examples" / "town.nmea"


def ways_of(path):
    """Metres of each way between two stops of two minutes, by the speeds of RMC, second by second."""
    speeds = [float(line.split(",")[7]) * 1852 / 3600 for line in path.read_text().splitlines() if line[3:6] == "RMC"]
    speeds = [speed if speed >= 0.3 else 0 for speed in speeds]
    ways, stands = [0.0], 0
    for speed in speeds:
        stands = 0 if speed else stands + 1
        if stands == 120:
            ways.append(0.0)
        ways[-1] += speed
    return [way for way in ways if way]


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
            arguments = ["--for", "8min", "--seed", seed, "--log", str(path)]
            self.assert_done(run("run", "taxi", *arguments, "--fault", "corrupted-frames@1min+1min"))
            logs.append(path.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertNotEqual(logs[0], logs[2])

    def test_what_is_printed_plays_the_same(self):
        arguments = ["--for", "12min", "--seed", "7", "--fault", "restart:node=2@5min"]
        path = self.folder / "taxi.toml"
        path.write_text(self.assert_done(run("run", "taxi", *arguments, "--print")))
        self.assertEqual(self.assert_done(run("run", str(path))), self.assert_done(run("run", "taxi", *arguments)))

    def test_a_tariff_of_the_file_is_what_people_pay(self):
        path = self.folder / "taxi.toml"
        path.write_text(
            'network = "taxi"\nfor = "140min"\n[shift]\nwaiting_max = "1min"\ntrip_max_m = 2000\n'
            '[[tariff]]\nlevel = "A"\ninitial_fare = 10\nstep = 0.5\n'
            '[[tariff]]\nlevel = "N"\ninitial_fare = 20\nstep = 0.5\n'
            '[[tariff_hours]]\nlevel = "N"\nfrom = "19:00"\nto = "6:00"\n'
        )
        lines = [json.loads(line) for line in self.assert_done(run("run", str(path), "--json")).splitlines()]
        self.assertIs(lines[-1]["all_held"], True)
        for trip in lines[-1]["trips"]:
            # Nothing but what it costs to begin: by day, and at night from 19:00 on, an hour after the start.
            self.assertEqual(trip["fare"], 10 if trip["begin"] < 3600 else 20)
        self.assertEqual({line["level"] for line in lines if line.get("event") == "tariff"}, {"A", "N"})
        printed = self.assert_done(run("run", str(path), "--print"))
        (self.folder / "again.toml").write_text(printed)
        self.assertEqual(self.assert_done(run("run", str(self.folder / "again.toml"), "--print")), printed)

    def test_other_assumptions_of_the_network_are_what_is_on_the_bus(self):
        offsets = [31 - place for place in range(30)]
        path = self.folder / "taxi.toml"
        path.write_text(
            f'network = "taxi"\nfor = "1min"\n[car_network]\npdo_offsets = {offsets}\nscan_period = "200ms"\n'
            'heartbeat = "250ms"\n'
        )
        log = self.folder / "bus.log"
        self.assert_done(run("run", str(path), "--log", str(log)))
        frames = [line.split()[2].split("#") for line in log.read_text().splitlines()]
        # PDO 17 is the eighth of the list: 180h + 31 - 7 of the gateway; by default 187h.
        self.assertGreater(sum(name == "198" for name, _ in frames), 500)
        self.assertFalse(any(name == "187" for name, _ in frames))
        self.assertAlmostEqual(sum(name == "701" for name, _ in frames), 240, delta=2)
        started = {data for name, data in frames if name == "000"}
        self.assertEqual(started, {f"010{node}" for node in range(2, 9)}, "in spite of it all are found")

    def test_json_tells_trips_and_what_held(self):
        output = self.assert_done(run("run", "taxi", "--for", "70min", "--json"))
        summary = [json.loads(line) for line in output.splitlines()][-1]
        self.assertIs(summary["all_held"], True)
        trip = summary["trips"][0]
        self.assertLessEqual(trip["fare_low"], trip["fare"])
        self.assertLessEqual(trip["fare"], trip["fare_high"])
        self.assertAlmostEqual(trip["distance_m"], trip["metered_distance_m"], delta=0.002 * trip["distance_m"] + 4)
        self.assertEqual([node["node"] for node in summary["nodes"]], list(range(1, 9)))

    def test_the_report_has_each_trip_with_its_limits_and_each_loss_of_power(self):
        arguments = ["--for", "2h", "--fault", "lost-node:node=2@15min+10s"]
        path = self.folder / "report.json"
        self.assert_done(run("run", "taxi", *arguments, "--report", str(path)))
        report = json.loads(path.read_text())
        self.assertEqual(report["interruptions"], [{"begin": 900.0, "end": 910.0}])
        for trip in report["trips"]:  # the first one has lost what it could have in those ten seconds
            self.assertEqual(trip["verdict"], "within")
            self.assertEqual(trip["distance_limit_m"], max(4, 0.002 * trip["distance_m"]))
        paid = sum(trip["paid"] for trip in report["trips"])
        self.assertAlmostEqual(report["totals"]["income"]["shift"], paid)
        text = self.folder / "report.txt"
        self.assert_done(run("run", "taxi", *arguments, "--report", str(text)))
        self.assertIn("at 15min for 10.000s", text.read_text())
        self.assert_refused(run("run", "taxi", "--for", "1s", "--report", "/nowhere/report"), USAGE, "/nowhere")

    def test_a_file_of_a_taxi_has_a_report_and_receipts_as_well(self):
        path = self.folder / "taxi.toml"
        path.write_text('network = "taxi"\nfor = "2h"\nseed = 7\n')
        report, receipts = self.folder / "report.json", self.folder / "receipts"
        output = self.assert_done(run("run", str(path), "--json", "--report", str(report)))
        trips = json.loads(output.splitlines()[-1])["trips"]
        self.assertEqual([trip["paid"] for trip in json.loads(report.read_text())["trips"]], [trip["paid"] for trip in trips])
        self.assert_done(run("run", str(path), "--receipts", str(receipts)))
        self.assertEqual(len(list(receipts.iterdir())), len(trips) + 1, "and the slip of the shift")
        self.assert_refused(run("run", str(path), "--for", "1s", "--report", "/nowhere/report"), USAGE, "/nowhere")
        other = self.folder / "police.toml"
        other.write_text('network = "police"\nfor = "1min"\n')
        self.assert_refused(run("run", str(other), "--report", str(report)), USAGE, "of a taxi")
        self.assert_refused(run("run", "police", "--for", "1s", "--report", str(report)), USAGE, "of a file of a taxi")

    def test_a_drive_that_was_recorded_is_what_the_meter_charges_for(self):
        output = self.assert_done(run("run", "taxi", "--nmea", str(DRIVE), "--for", "3h", "--json"))
        lines = [json.loads(line) for line in output.splitlines()]
        summary = lines[-1]
        self.assertIs(summary["all_held"], True)
        ways = ways_of(DRIVE)
        self.assertEqual(len(ways), 2)
        self.assertEqual(len(summary["trips"]), 2, "then the driver goes home")
        for trip, way in zip(summary["trips"], ways):
            self.assertAlmostEqual(trip["distance_m"], way, delta=0.01 * way)
            self.assertAlmostEqual(trip["metered_distance_m"], trip["distance_m"], delta=0.002 * way + 4)
        self.assertIn("shift-ends", [line.get("event") for line in lines])

    def test_the_gps_says_what_was_recorded(self):
        path = self.folder / "bus.log"
        self.assert_done(run("run", "taxi", "--nmea", str(DRIVE), "--for", "40min", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--profile", "447-3", "--filter", "service=PDO"))
        self.assertIn("48.140", output, "Munich")
        self.assertNotIn("!", output)

    def test_a_drive_in_a_network_file_stands_beside_it(self):
        (self.folder / "drive.nmea").write_bytes(DRIVE.read_bytes())
        path = self.folder / "taxi.toml"
        path.write_text('network = "taxi"\nfor = "40min"\nnmea = "drive.nmea"\n')
        output = self.assert_done(run("run", str(path)))
        self.assertEqual(self.assert_done(run("run", "taxi", "--nmea", str(DRIVE), "--for", "40min")), output)
        self.assertIn('nmea = "drive.nmea"', self.assert_done(run("run", str(path), "--print")))

    def test_broken_lines_of_a_drive_are_counted_and_none_that_is_right_is_refused(self):
        lines = DRIVE.read_bytes().splitlines(keepends=True)
        lines[100] = lines[100].replace(b"*", b"1*")
        lines[200] = b"noise\n"
        path = self.folder / "drive.nmea"
        path.write_bytes(b"".join(lines))
        result = run("run", "taxi", "--nmea", str(path), "--for", "20min")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(
            result.stderr,
            f"canvoy: {path}: 2 of {len(lines)} lines are passed over: 1 with a wrong checksum, or none, "
            "1 that are no sentence\n",
        )
        path.write_text("hello\n")
        self.assert_refused(run("run", "taxi", "--nmea", str(path)), FAILED, str(path), "no car moves", "1 of 1 lines")
        self.assert_refused(run("run", "taxi", "--nmea", str(self.folder / "none")), FAILED, "none")

    def test_each_receipt_is_a_picture(self):
        folder = self.folder / "receipts"
        arguments = ["--for", "2h", "--receipts", str(folder)]
        output = self.assert_done(run("run", "taxi", *arguments, "--json"))
        trips = json.loads(output.splitlines()[-1])["trips"]
        names = sorted(path.name for path in folder.iterdir())
        self.assertEqual(names, [f"receipt-{i + 1:04}.png" for i in range(len(trips) + 1)], "and the slip")
        self.assertGreater(len(names), 2)
        pictures = [(folder / name).read_bytes() for name in names]
        for picture in pictures:
            self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
            width, height = struct.unpack(">II", picture[16:24])
            self.assertEqual(width, 384)
            # Fourteen lines of 16 dots at least; the slip has nineteen.
            self.assertGreater(height, 14 * 16)
            self.assertLess(height, 28 * 16)
        self.assertEqual(len(set(pictures)), len(pictures), "each is another one")
        self.assert_refused(run("run", "taxi", *arguments), USAGE, "there are receipts", str(folder))
        path = self.folder / "file"
        path.write_text("")
        self.assert_refused(run("run", "taxi", "--receipts", str(path)), USAGE, str(path))

    def test_a_log_names_every_frame(self):
        path = self.folder / "bus.log"
        # The shift ends after half of it; then the network sleeps, and wakes up.
        self.assert_done(run("run", "taxi", "--for", "70min", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--profile", "447-3"))
        services = {json.loads(line)["service"] for line in output.splitlines()}
        known = {"NMT", "PDO", "LSS", "SDO request", "SDO response", "heartbeat", "boot-up", "sleep"}
        self.assertEqual(services, known)
        self.assertEqual(output.count("\n"), path.read_bytes().count(b"\n"))
        self.assertNotIn('"marks"', output)

    def test_in_a_log_with_faults_nothing_is_marked_but_what_they_did(self):
        faults = [
            ("lost-node:node=2@15min+30s", 900, 930),
            ("cable-cut@20min+20s", 1200, 1220),
            ("babbling-node@25min+3s", 1500, 1503),
            ("corrupted-frames@30min+2min", 1800, 1920),
            ("wheel-signal@35min+2min", 2100, 2220),
            ("paper-out@40min+5min", 2400, 2700),
            ("no-fix@40min+5min", 2400, 2700),
            ("restart:node=1@50min", 3000, 3000),
        ]
        path = self.folder / "bus.log"
        arguments = [word for fault, _, _ in faults for word in ("--fault", fault)]
        self.assert_done(run("run", "taxi", "--for", "1h", *arguments, "--log", str(path)))
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

    def test_a_shift_without_a_trip_has_a_report(self):
        path = self.folder / "report.json"
        self.assert_done(run("run", "taxi", "--for", "1s", "--report", str(path)))
        self.assertEqual(json.loads(path.read_text())["trips"], [])

    def test_bad_input_is_refused_in_one_line(self):
        for arguments, status, part in (
            (["--fault", "lost-node:node=9@1min"], USAGE, "nodes 1 to 8"),
            (["--fault", "paper-out:node=2@1min"], USAGE, "not one of a node"),
            (["--fault", "flat-tyre@1min"], USAGE, "flat-tyre"),
            (["--for", "1min", "--fault", "restart@2min"], USAGE, "after the end"),
        ):
            self.assert_refused(run("run", "taxi", *arguments), status, part)
        path = self.folder / "bad.toml"
        for text, part in (
            ('network = "taxi"\n[taximeter]\nk = 0\n', "line 3"),
            ('network = "taxi"\n[printer]\nplayed = false\n', "real"),
            ('network = "taxi"\n[submarine]\n', "submarine"),
            ('network = "taxi"\n[shift]\nwaiting_max = "2days"\n', "line 3"),
            ('network = "taxi"\n[shift]\nwaiting_max = "25h"\n', "not from 1s to 24h"),
            ('network = "taxi"\n[shift]\ntrip_max_m = 20\n', "less than trip_min_m"),
            ('network = "taxi"\n[car_network]\nlost_after = "1s"\n', "not from 1500ms to 10s"),
            ('network = "taxi"\n[car_network]\nheartbeat = "3s"\n', "longer than from one heartbeat to the next"),
            ('network = "taxi"\n[car_network]\nheartbeat = "100.5ms"\n', "whole milliseconds"),
            ('network = "taxi"\n[car_network]\npdo_offsets = [1, 2]\n', "30 whole numbers"),
            (f'network = "taxi"\n[car_network]\npdo_offsets = {[0] * 30}\n', "each another"),
            ('network = "taxi"\n[[tariff]]\nlevel = "long"\n', "one or two characters"),
            ('network = "taxi"\n[[tariff]]\nlevel = "1"\nper_km = 0.0001\n', "thousandths"),
            ('network = "taxi"\n[[tariff]]\nlevel = "1"\nstep = 0.001\n', "line 4: step: 0.001 is not from 0.01"),
            ('network = "taxi"\n[[tariff]]\nlevel = "1"\nstep = 0.015\n', "multiple of 0.01"),
            ('network = "taxi"\n[[tariff]]\nlevel = "1"\ninitial_fare = 3.905\n', "multiple of 0.01"),
            ('network = "taxi"\n[[tariff]]\nlevel = "1"\n[[tariff]]\nlevel = "1"\n', "already"),
            ('network = "taxi"\n[[tariff_hours]]\nlevel = "1"\n', "no such level"),
            ('network = "taxi"\n[[tariff]]\nlevel = "1"\n[[tariff_hours]]\nlevel = "1"\nto = "24:01"\n', "22:00"),
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
