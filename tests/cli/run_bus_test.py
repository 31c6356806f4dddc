#!/usr/bin/env python3
"""`canvoy run bus` from outside."""

import contextlib
import http.client
import json
import pathlib
import re
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import zipfile

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

FEED = {
    "agency.txt": "agency_id,agency_name,agency_url,agency_timezone\nA,Town,http://town.example,Europe/Berlin\n",
    "stops.txt": (
        "stop_id,stop_name,stop_lat,stop_lon,zone_id\n"
        "S1,Bahnhof,50.1000,8.5000,1\nS2,Löwenplatz,50.1050,8.5000,1\nS3,Hafen,50.1120,8.5000,2\n"
    ),
    "routes.txt": "route_id,agency_id,route_short_name,route_long_name,route_type\nR7,A,7,,3\n",
    "trips.txt": "route_id,service_id,trip_id,trip_headsign,direction_id\nR7,W,T1,Hafen,0\nR7,W,T2,Bahnhof,1\n",
    "stop_times.txt": (
        "trip_id,arrival_time,departure_time,stop_id,stop_sequence\n"
        "T1,08:00:00,08:00:00,S1,1\nT1,08:03:00,08:03:00,S2,2\nT1,08:06:00,08:06:00,S3,3\n"
        "T2,08:20:00,08:20:00,S3,1\nT2,08:23:00,08:23:00,S2,2\nT2,08:26:00,08:26:00,S1,3\n"
    ),
    "calendar.txt": (
        "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n"
        "W,1,1,1,1,1,0,0,20261101,20261231\n"
    ),
}

# All of a bus (docs/bus.md). Node-IDs are of one car alone; the pre-defined messages are those of node 1.
DEVICES = [
    "sim0:1=on-board-computer", "2=identification", "4=destination-indicator-text", "5=next-stop-indicator-text",
    "6=ticket-canceller", "7=ticket-printer", "8=information-indicator-text", "9=acoustic-announcer",
    "10=destination-indicator-text", "11=vehicle-gateway", "12=tachograph", "13=driver-display",
    "16=geographical-positioning+time-fixing", "20=passenger-counter", "21=passenger-counting-manager",
    "22=passenger-counter", "30=train-bus-gateway", "sim1:31=train-bus-gateway", "34=destination-indicator-text",
    "35=next-stop-indicator-text", "39=acoustic-announcer",
]


class RunBus(CommandTest):
    """A day of service in virtual time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def feed(self, zone="Europe/Berlin"):
        path = self.folder / "feed.zip"
        with zipfile.ZipFile(path, "w") as archive:
            for name, text in FEED.items():
                archive.writestr(name, text.replace("Europe/Berlin", zone))
        return path

    def test_clocks_are_those_of_the_feeds_zone(self):
        # Newfoundland, in winter: 3 h 30 min behind UTC. Five minutes before the first departure of 2026-11-02.
        log = self.folder / "bus.log"
        feed = ["--gtfs", str(self.feed("America/St_Johns")), "--route", "7"]
        output = self.assert_done(run("run", "bus", *feed, "--for", "2min", "--json", "--log", str(log)))
        snapshot = next(line for line in map(json.loads, output.splitlines()) if line["event"] == "snapshot")
        self.assertEqual(snapshot["local_time"], "2026-11-02 07:56:00")
        frames = [line.split()[-1] for line in log.read_text().splitlines()]
        # 6680h: hours and minutes of the zone, years since 1985 and the day in 16 bits, month, hour, minute, seconds.
        universal = next(frame for frame in frames if frame.startswith("390#"))
        self.assertEqual(universal, "390#FDE229080B0B1900")
        # 610Eh, the same of the local time, which the first minute shows.
        local = [frame for frame in frames if frame.startswith("181#") and not frame.startswith("181#FF")]
        self.assertEqual(local[0], "181#29080B073700")
        self.assertEqual(local[-1][:14], "181#29080B0738")

    def test_a_zone_that_nobody_knows_is_refused(self):
        for zone in ("Europe/Atlantis", "../../etc/passwd"):
            feed = ["--gtfs", str(self.feed(zone)), "--route", "7"]
            self.assert_refused(run("run", "bus", *feed), FAILED, f"agency_timezone '{zone}'")

    def test_the_same_seed_gives_the_same_log_and_another_seed_another(self):
        logs = []
        for name, seed in (("first", "1"), ("again", "1"), ("other", "2")):
            path = self.folder / f"{name}.log"
            arguments = ["--for", "8min", "--seed", seed, "--log", str(path)]
            self.assert_done(run("run", "bus", *arguments, "--fault", "corrupted-frames@1min+1min"))
            logs.append(path.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertNotEqual(logs[0], logs[2])

    def test_what_is_printed_plays_the_same(self):
        arguments = ["--for", "15min", "--seed", "7", "--fault", "restart:node=5@12min", "--fault", "no-paper@5min"]
        path = self.folder / "bus.toml"
        path.write_text(self.assert_done(run("run", "bus", *arguments, "--print")))
        self.assertEqual(self.assert_done(run("run", str(path))), self.assert_done(run("run", "bus", *arguments)))

    def test_json_tells_what_is_read_and_what_held(self):
        output = self.assert_done(run("run", "bus", "--for", "30min", "--json"))
        lines = [json.loads(line) for line in output.splitlines()]
        summary = lines[-1]
        self.assertIs(summary["all_held"], True)
        self.assertEqual(len(summary["nodes"]), 21)
        journeys = [line for line in lines if line["event"] == "journey"]
        self.assertEqual([line["destination"] for line in journeys], ["Central Station"])
        for car in (1, 2):
            announced = [line["stop"] for line in lines if line["event"] == "announcement" and line["car"] == car]
            self.assertEqual(announced[:3], ["Central Station", "Market Square", "Town Hall"])
        for snapshot in (line for line in lines if line["event"] == "snapshot"):
            texts = {display["display"]: display["text"] for display in snapshot["displays"]}
            self.assertEqual(texts["destination-front"], "407\n" + snapshot["plant"]["destination"])
            self.assertEqual(texts["second-destination"], texts["destination-front"])
            self.assertEqual(snapshot["plant"]["aboard"], snapshot["statistics"]["in"] - snapshot["statistics"]["out"])

    def test_a_feed_is_driven_to_its_end(self):
        feed = self.feed()
        realtime = self.folder / "realtime.pb"
        output = self.assert_done(
            run("run", "bus", "--gtfs", str(feed), "--route", "7", "--gtfs-rt", str(realtime), "--json")
        )
        lines = [json.loads(line) for line in output.splitlines()]
        self.assertIs(lines[-1]["all_held"], True)
        self.assertEqual(sum(line["event"] == "block-over" for line in lines), 1)
        read = [line["text"] for line in lines if line["event"] == "display" and line["node"] == 5]
        self.assertIn("Löwenplatz", read)
        outside = {line["text"] for line in lines if line["event"] == "display" and line["node"] == 4}
        self.assertEqual(outside - {""}, {"7\nHafen", "7\nBahnhof"})
        # gtfs-realtime.proto: FeedMessage.header (field 1) with gtfs_realtime_version (field 1) "2.0".
        self.assertEqual(realtime.read_bytes()[0], 0x0A)
        self.assertEqual(realtime.read_bytes()[2:7], b"\x0a\x032.0")
        self.assertIn(b"T2", realtime.read_bytes())
        # The file of this run plays the same.
        path = self.folder / "bus.toml"
        path.write_text(self.assert_done(run("run", "bus", "--gtfs", str(feed), "--route", "7", "--print")))
        self.assertIn('date = "2026-11-02"', path.read_text(), "the first Monday on which it runs")
        self.assertEqual(self.assert_done(run("run", str(path), "--json")), output)

    @contextlib.contextmanager
    def served(self, where):
        """The host and port at which a bus that is played by the clock tells where it is."""
        command = [CANVOY, "run", "bus", "--gtfs-rt", where, "--speed", "60", "--for", "2h"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as bus:
            told = bus.stderr.readline()
            match = re.fullmatch(r"canvoy: GTFS-Realtime is served at http://(\S+):(\d+)/\n", told)
            self.assertTrue(match, told)
            try:
                yield match[1], int(match[2])
            finally:
                bus.send_signal(signal.SIGTERM)
                rest = bus.communicate(timeout=60)[1]
            self.assertEqual((rest, bus.returncode), ("", DONE), "it ends as without it")

    def ask(self, address, method="GET", path="/", body=None):
        connection = http.client.HTTPConnection(*address, timeout=60)
        self.addCleanup(connection.close)
        connection.request(method, path, body)
        response = connection.getresponse()
        return response, response.read()

    def test_where_the_bus_is_is_served_by_http(self):
        with self.served("127.0.0.1:0") as address:
            response, content = self.ask(address, path="/vehicle-positions.pb")
            self.assertEqual(response.status, 200)
            self.assertEqual(response.headers["Content-Type"], "application/x-protobuf")
            self.assertEqual(response.headers["Content-Length"], str(len(content)))
            self.assertEqual(content[2:7], b"\x0a\x032.0")
            # Before anything was heard of the bus it is the header alone.
            end = time.monotonic() + 60
            length = 0
            while length <= 50 and time.monotonic() < end:
                response, content = self.ask(address, "HEAD")
                self.assertEqual((response.status, content), (200, b""))
                length = int(response.headers["Content-Length"])
            self.assertGreater(length, 50)
            response, _ = self.ask(address, "POST", body=b"x" * 10_000)
            self.assertEqual((response.status, response.headers["Allow"]), (405, "GET, HEAD"))
            with socket.create_connection(address, timeout=60) as other:
                other.sendall(b"\x16\x03\x01\x02\x00")  # TLS
                self.assertEqual(other.recv(12), b"HTTP/1.1 400")
            taken = run("run", "bus", "--gtfs-rt", f"127.0.0.1:{address[1]}", "--for", "1min")
            self.assert_refused(taken, FAILED, "--gtfs-rt", "in use")

    def test_a_port_alone_is_of_all_addresses(self):
        with self.served(":0") as (_, port):
            self.assertEqual(self.ask(("127.0.0.1", port))[0].status, 200)

    def test_a_lost_computer_leaves_displays_dark(self):
        output = self.assert_done(run("run", "bus", "--for", "20min", "--fault", "lost-node:node=1@10min+2min"))
        self.assertIn("next-stop (5): dark", output)

    def test_a_log_names_every_frame(self):
        path = self.folder / "bus.log"
        self.assert_done(run("run", "bus", "--for", "45min", "--log", str(path)))
        output = self.assert_done(run("decode", str(path), "--json", "--profile", "407"))
        services = {json.loads(line)["service"] for line in output.splitlines()}
        # PDOs that are not pre-defined (8.1.5) by the connection set alone.
        own = {"TPDO1", "TPDO2", "TPDO3"}
        known = {"NMT", "PDO", "SDO request", "SDO response", "heartbeat", "boot-up"} | own
        self.assertLessEqual(services, known)
        self.assertEqual(output.count("\n"), path.read_bytes().count(b"\n"))
        self.assertNotIn('"marks"', output)

    def test_with_its_devices_named_each_frame_has_its_meaning(self):
        log = self.folder / "bus.log"
        self.assert_done(run("run", "bus", "--for", "45min", "--log", str(log)))
        options = [word for device in DEVICES for word in ("--node", device)]
        output = self.assert_done(run("decode", str(log), "--json", "--profile", "407", *options))
        frames = [json.loads(line) for line in output.splitlines()]
        self.assertEqual(len(frames), log.read_bytes().count(b"\n"))

        def has_meaning(frame):
            if "PDO" in frame["service"]:
                values = frame.get("values", [])
                # By the pre-defined connection set alone a message has a number, and bytes of no object.
                return bool(values) and all("name" in value and "value" in value for value in values)
            return bool(frame.get("text"))

        self.assertEqual([frame for frame in frames if not has_meaning(frame) or "marks" in frame], [])
        stops = [frame for frame in frames if frame["frame"].startswith("1C1#")]
        self.assertEqual({frame["node"] for frame in stops if frame["bus"] == "sim0"}, {1})
        meanings = {(value["index"], value["value"]) for frame in stops for value in frame["values"]}
        self.assertEqual(meanings, {("6204", "bus stop requested"), ("6204", "bus stop not requested")})
        # Each SDO transfer ends with its object and value.
        output = self.assert_done(
            run("decode", str(log), "--json", "--transfers", "--filter", "SDO", "--profile", "407", *options))
        transfers = [json.loads(line) for line in output.splitlines()]
        self.assertGreater(len(transfers), 100)
        self.assertEqual([each for each in transfers if not all("name" in value for value in each["values"])], [])

    def test_application_specific_messages_have_values_where_the_devices_are_named(self):
        log = self.folder / "bus.log"
        self.assert_done(run("run", "bus", "--for", "10min", "--log", str(log)))
        devices = ["11=vehicle-gateway", "16=geographical-positioning+time-fixing", "sim0:21=passenger-counting-manager"]
        options = [word for device in devices for word in ("--node", device)]
        lines = self.assert_done(run("decode", str(log), "--profile", "407", *options)).splitlines()
        # 6480h ... of CiA 407 are parameters of SAE J1939: 1/256 km/h, 5 m; 6660h of degrees.
        for frame, meanings in [("18B#", ("km/h", "doors")), ("28B#", ("mileage", " m;")), ("190#", ("latitude", "°")),
                                ("295#", ("passenger_sum", "%"))]:
            line = [line for line in lines if f" {frame}" in line][-1]
            for meaning in meanings:
                self.assertIn(meaning, line)
        self.assert_refused(run("decode", str(log), "--node", "11=vehicle-gatewy"), USAGE, "vehicle-gatewy")

    def test_displays_are_pictures(self):
        folder = self.folder / "displays"
        arguments = ["run", "bus", "--for", "12min", "--displays", str(folder)]
        events = [json.loads(line) for line in self.assert_done(run(*arguments, "--json")).splitlines()]
        shown = [event for event in events if event["event"] == "display" and event["node"] == 35]
        signs = [event["lit"] for event in events if event["event"] == "stop-sign" and event["car"] == 2]
        self.assertEqual(signs, [True, False], "somebody gets out")
        pictures = sorted(path.name for path in folder.glob("second-next-stop-*.png"))
        # It was dark before.
        self.assertEqual(pictures, [f"second-next-stop-{i + 1:04}.png" for i in range(len(shown) + len(signs) + 1)])
        self.assertGreater(len(shown), 3)
        self.assert_refused(run(*arguments), USAGE, "there are pictures", str(folder))
        self.assert_refused(run(*arguments, "--vehicles", "2"), USAGE, "--displays is of one bus")

    def test_a_depot_is_the_same_whatever_the_number_of_threads(self):
        arguments = ["--vehicles", "5", "--for", "10min", "--seed", "9", "--fault", "restart:node=5@8min", "--json"]
        one = self.assert_done(run("run", "bus", *arguments, "--threads", "1"))
        self.assertEqual(self.assert_done(run("run", "bus", *arguments, "--threads", "4")), one)
        self.assertEqual(self.assert_done(run("run", "bus", *arguments)), one)
        *vehicles, summary = [json.loads(line) for line in one.splitlines()]
        self.assertEqual([line["vehicle"] for line in vehicles], [1, 2, 3, 4, 5])
        self.assertEqual([line["seed"] for line in vehicles], [9, 10, 11, 12, 13])
        self.assertEqual((summary["vehicles"], summary["played"], summary["failed"]), (5, 5, []))
        self.assertIs(summary["all_held"], True)
        self.assertEqual(summary["frames"], sum(line["frames"] for line in vehicles))
        for name in ("stops", "in", "out"):
            total = sum(line["statistics"][name] for line in vehicles)
            self.assertEqual(summary["statistics"][name], total)
        # Each is the bus that its seed gives alone.
        alone = run("run", "bus", *arguments[2:4], "--seed", "11", *arguments[6:])
        third = json.loads(self.assert_done(alone).splitlines()[-1])
        self.assertEqual(third["statistics"], vehicles[2]["statistics"])
        self.assertEqual(third["invariants"], vehicles[2]["invariants"])
        self.assertEqual(sum(bus["frames"] for bus in third["buses"]), vehicles[2]["frames"])

    def test_vehicles_of_a_feed_drive_its_blocks_in_turn(self):
        feed = ["--gtfs", str(self.feed()), "--route", "7"]
        output = self.assert_done(run("run", "bus", *feed, "--vehicles", "2", "--json"))
        *vehicles, summary = [json.loads(line) for line in output.splitlines()]
        self.assertEqual([line["block"] for line in vehicles], [1, 1], "there is one")
        self.assertEqual([line["statistics"]["journeys"] for line in vehicles], [2, 2])
        self.assertEqual(summary["time"], vehicles[0]["time"], "until ten minutes after the block")

    def test_a_depot_that_is_interrupted_says_how_far_it_came(self):
        command = [CANVOY, "run", "bus", "--vehicles", "1000", "--for", "1h", "--json"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as depot:
            self.assertEqual(json.loads(depot.stdout.readline())["vehicle"], 1)
            depot.send_signal(signal.SIGTERM)
            output, _ = depot.communicate(timeout=60)
        summary = json.loads(output.splitlines()[-1])
        self.assertEqual(summary["event"], "summary")
        self.assertLess(summary["played"], summary["vehicles"])
        self.assertEqual((summary["failed"], summary["all_held"]), ([], False), "not all has been judged")
        self.assertEqual(depot.returncode, FAILED)

    def test_bad_input_is_refused_in_one_line(self):
        for arguments, status, part in (
            (["--fault", "lost-node:node=3@1min"], USAGE, "nodes 1, 2, 4"),
            (["--fault", "no-paper:node=5@1min"], USAGE, "not one of a node"),
            (["--fault", "flat-tyre@1min"], USAGE, "flat-tyre"),
            (["--for", "1min", "--fault", "restart@2min"], USAGE, "after the end"),
            (["--route", "7"], USAGE, "--gtfs"),
            (["--date", "2026-02-30"], USAGE, "2026-02-30"),
            (["--block", "2"], USAGE, "block 2"),
            (["--gtfs", "/nowhere"], FAILED, "/nowhere"),
            (["--for", "1min", "--gtfs-rt", "/nowhere/file"], FAILED, "--gtfs-rt"),
            (["--for", "1min", "--gtfs-rt", ":65536"], USAGE, "':65536' is no port"),
            (["--for", "1min", "--gtfs-rt", ":http"], USAGE, "':http' is no port"),
            (["--for", "1min", "--gtfs-rt", "192.0.2.1:0"], FAILED, "192.0.2.1:0"),
            (["--vehicles", "0"], USAGE, "1 to 1000"),
            (["--vehicles", "-1"], USAGE, "--vehicles"),
            (["--vehicles", "100000"], USAGE, "1 to 1000"),
            (["--vehicles", "many"], USAGE, "--vehicles"),
            (["--vehicles", "2", "--threads", "0"], USAGE, "1 to 256"),
            (["--threads", "2"], USAGE, "give --vehicles"),
            (["--vehicles", "2", "--log", "x.log"], USAGE, "--log is of one bus"),
            (["--vehicles", "2", "--print"], USAGE, "--print is of one bus"),
            (["--vehicles", "2", "--speed", "1"], USAGE, "--speed is of one bus"),
            (["--vehicles", "2", "--gtfs-rt", "x"], USAGE, "--gtfs-rt is of one bus"),
            (["--vehicles", "2", "--block", "1"], USAGE, "--block is of one bus"),
            (["--vehicles", "2", "--for", "1min", "--fault", "restart@2min"], USAGE, "after the end"),
        ):
            self.assert_refused(run("run", "bus", *arguments), status, part)
        self.assert_refused(run("run", "bus", "--gtfs", str(self.feed()), "--date", "2027-05-03"), FAILED, "2027-05-03")
        path = self.folder / "bad.toml"
        for text, part in (
            ('network = "bus"\n[bus]\nbit_rate = 3\n', "line 3"),
            ('network = "bus"\n[next-stop]\nplayed = false\n', 'real = "can0" in [bus]'),
            ('network = "bus"\n[bus]\nreal = "can0"\n[second-next-stop]\nplayed = false\n', "[second_bus]"),
            ('network = "bus"\n[line]\ndate = "tomorrow"\n', "bad.toml"),
            ('network = "bus"\n[submarine]\n', "submarine"),
        ):
            path.write_text(text)
            self.assert_refused(run("run", str(path)), FAILED, part)


if __name__ == "__main__":
    unittest.main()
