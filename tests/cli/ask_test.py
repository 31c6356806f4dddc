#!/usr/bin/python3
"""What asks and tells on one bus: read, write, nmt, send, sync, time, emcy, pdo, store, restore, expect, wait, configure --diff,
with a battery (node 10) and a charger (node 5), and a socket of the test's own as the other end. Frames are as CiA 301 has them."""

import datetime
import json
import os
import pathlib
import pty
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

try:
    import msgpack
except ImportError as error:
    own_network.skip(f"{error}; scripts/install-packages test installs python3-msgpack")

GROUP, PORT = "239.74.163.21", 43121
BUS = f"udp:{GROUP}:{PORT}"
PATIENCE = 60  # seconds


class Listener:
    """All frames on the bus, as `123#1122`."""

    def __init__(self):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.bind((GROUP, PORT))
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP,
                               struct.pack("4s4s", socket.inet_aton(GROUP), socket.inet_aton("127.0.0.1")))  # fmt: skip
        self.socket.settimeout(PATIENCE)

    def frames(self):
        while True:
            message = msgpack.unpackb(self.socket.recv(4096))
            width = 8 if message["is_extended_id"] else 3
            kind = "R" if message["is_remote_frame"] else bytes(message["data"] or b"").hex().upper()
            yield f"{message['arbitration_id']:0{width}X}#{kind}"

    def next(self, prefix):
        return next(frame for frame in self.frames() if frame.startswith(prefix))

    def send(self, identifier, data):
        """A frame of another node."""
        message = {"timestamp": 0.0, "arbitration_id": identifier, "is_extended_id": False, "is_remote_frame": False, "is_error_frame": False,
                   "channel": None, "dlc": len(data), "data": data, "is_fd": False, "bitrate_switch": False, "error_state_indicator": False}
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
        self.socket.sendto(msgpack.packb(message), (GROUP, PORT))


class Ask(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.start("battery", "10", "--heartbeat", "100ms", "--store", str(cls.folder / "battery.store"))
        cls.start("charger", "5", "--no-manage")

    @classmethod
    def start(cls, kind, node, *options):
        device = subprocess.Popen([CANVOY, "device", kind, BUS, "--node-id", node, *options], stdout=subprocess.DEVNULL)
        cls.addClassCleanup(device.wait)
        cls.addClassCleanup(device.terminate)
        for _ in range(100):
            if run("read", BUS, node, "1000", "--timeout", "200ms").returncode == DONE:
                return device
        raise AssertionError(f"the {kind} does not come up")

    def done(self, *arguments):
        return self.assert_done(run(*arguments))

    def listen(self):
        listener = Listener()
        self.addCleanup(listener.socket.close)
        return listener

    # -- nodes and objects

    def test_what_is_printed_of_a_node_is_accepted(self):
        wanted = self.done("read", BUS, "10", "1017")
        for node in ("0x0A", "0Ah", "10 (0Ah)", "node 10 (0Ah)"):
            self.assertEqual(self.done("read", BUS, node, "1017"), wanted)

    def test_a_name_of_the_network_is_a_node(self):
        network = self.folder / "network.toml"
        network.write_text('[[slave]]\nnode = 10\nname = "battery left"\n')
        wanted = self.done("read", BUS, "10", "1017")
        self.assertEqual(self.done("read", BUS, "battery_left", "1017", "--network", str(network)), wanted)
        named = dict(os.environ, CANVOY_NETWORK=str(network))
        self.assertEqual(self.assert_done(run("read", BUS, "battery left", "1017", env=named)), wanted)
        self.assert_refused(run("read", BUS, "batery_left", "1017", env=named), USAGE, "did you mean 'battery left'?")

    def test_a_dbc_is_made_of_a_node_however_it_is_named(self):
        network = self.folder / "dbc.toml"
        network.write_text('[[node]]\nnode = 10\nname = "pump"\n')
        for node in ("10", "0Ah", "0x0A", "10 (0Ah)", "pump"):
            with self.subTest(node=node):
                self.assertIn("\nBO_ 394 ", self.assert_done(run("export", "dbc", BUS, node, "--network", str(network), encoding="latin-1")), "18Ah")
        self.assertIn("\nBO_ 394 ", self.assert_done(run("export", "dbc", f"{BUS}?ttl=0", "10", encoding="latin-1")), "a sign in the bus")
        self.assert_refused(run("export", "dbc", "charger", "pump", "--network", str(network)), USAGE, "'pump' is neither a file nor a device")

    def test_what_is_printed_of_an_object_is_accepted(self):
        self.assertEqual(self.done("read", BUS, "10", "identity_object:vendor_id"), self.done("read", BUS, "10", "1018h:01h"))
        self.assertEqual(self.done("read", BUS, "10", "Identity object, Vendor-ID"), self.done("read", BUS, "10", "1018:1"))
        self.assertEqual(self.done("read", BUS, "5", "battery_state_of_charge"), self.done("read", BUS, "5", "6081"))

    def test_the_partners_name_is_accepted_too(self):
        self.assertRegex(self.done("read", BUS, "10", "battery_temperature"), r"\A\d\d\.\d+ °C\n\Z")
        self.assertEqual(self.done("read", BUS, "5", "temperature"), self.done("read", BUS, "5", "6010"))

    def test_of_a_part_of_a_name_the_choices_are_listed(self):
        self.assert_refused(run("read", BUS, "10", "state_of_charge"), USAGE,
                            "charger_state_of_charge (6080h:00h)", "battery_state_of_charge (6081h:00h)")  # fmt: skip
        self.assertEqual(self.done("read", BUS, "10", "current_requested"), self.done("read", BUS, "10", "6070"))
        self.assertEqual(self.done("read", BUS, "10", "charger_state_of_charge (6080h:00h)"), self.done("read", BUS, "10", "6080"), "a choice as it is told")

    def test_a_profile_is_named_alike_everywhere(self):
        for name in ("418", "CiA 418", "419"):
            self.assertEqual(self.done("read", BUS, "10", "6010", "--profile", name), "20.000 °C\n")
        self.assertEqual(self.done("read", BUS, "10", "6010", "--profile", "417-4", "--type", "i16"), "160\n")
        self.assert_refused(run("read", BUS, "10", "6010", "--profile", "999"), USAGE, "'999' is no profile", "417-4")

    # -- read and write

    def test_several_objects_are_read_with_their_names(self):
        lines = self.done("read", BUS, "10", "1017", "1018:4", "temperature").splitlines()
        self.assertEqual(lines[0], "Producer heartbeat time         100 ms")
        self.assertEqual(len(lines), 3)
        self.assertRegex(lines[2], r"\Atemperature +\d+\.\d+ °C\Z")
        records = [json.loads(line) for line in self.done("read", BUS, "10", "1017", "1000", "--json").splitlines()]
        self.assertEqual([record["index"] for record in records], ["1017", "1000"])
        self.assertEqual(records[0], {"node": 10, "index": "1017", "sub": "00", "name": "Producer heartbeat time", "raw": "6400",
                                      "value": 100, "unit": "ms"})  # fmt: skip

    def test_watch_tells_what_changes(self):
        output = self.done("read", BUS, "10", "1017", "--watch", "50ms", "--for", "300ms")
        self.assertRegex(output, r"\A +0\.\d{3}s  Producer heartbeat time  100 ms\n\Z", "once: it does not change")
        counted = self.done("read", BUS, "10", "1017", "1000", "--watch", "--count", "2", "--json")
        self.assertEqual(len(counted.splitlines()), 2)
        self.assertIn('{"time":', counted)

    def test_write_tells_the_old_and_the_new_value(self):
        self.assertEqual(self.done("write", BUS, "5", "1017", "1s 500ms"), "Producer heartbeat time: 1000 ms -> 1500 ms\n")
        self.assertEqual(json.loads(self.done("write", BUS, "5", "1017", "1s", "--json")),
                         {"node": 5, "index": "1017", "sub": "00", "name": "Producer heartbeat time", "old": 1500, "raw": "E803",
                          "value": 1000, "unit": "ms"})  # fmt: skip
        self.assertEqual(self.done("write", BUS, "5", "1017", "1000", "--blind"), "Producer heartbeat time: ? -> 1000 ms\n")
        self.assertEqual(json.loads(self.done("write", BUS, "5", "1017", "1000", "--blind", "--json")),
                         {"node": 5, "index": "1017", "sub": "00", "name": "Producer heartbeat time", "old": None, "raw": "E803",
                          "value": 1000, "unit": "ms"})  # fmt: skip

    def test_write_tells_how_much_of_a_file_it_has_written(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "time.bin"
            file.write_bytes(b"\xe8\x03")
            self.assertEqual(self.done("write", BUS, "5", "1017", "--file", str(file)), "Producer heartbeat time: 2 bytes written\n")
            self.assertEqual(json.loads(self.done("write", BUS, "5", "1017", "--file", str(file), "--json")),
                             {"node": 5, "index": "1017", "sub": "00", "bytes": 2})  # fmt: skip

    def test_a_misspelt_state_is_answered_with_a_known_one(self):  # CiA 419, 6000h: not ready, ready
        for verb, *value in (("write", "5", "battery_status", "redy"), ("expect", "5", "battery_status = redy"), ("pdo", "10", "tpdo1", "battery_status=redy")):
            with self.subTest(verb=verb):
                self.assert_refused(run(verb, BUS, *value), USAGE, "'redy' is no value here: give a number, or one of: not ready, ready; did you mean 'ready'?\n")
        self.assert_refused(run("write", BUS, "10", "6001", "5", "--type", "b"), USAGE, "5 is out of range: 0 to 1\n")

    def test_nothing_is_rounded_in_silence(self):
        before = self.done("read", BUS, "5", "1017")
        self.assert_refused(run("write", BUS, "5", "1017", "500.5"), USAGE, "'500.5'", "500 ms or 501 ms")
        self.assertEqual(self.done("read", BUS, "5", "1017"), before)

    # -- NMT

    def test_nmt_sees_by_the_heartbeat_that_the_state_was_reached(self):
        self.assertEqual(self.done("nmt", BUS, "10", "stopped"), "node 10 (0Ah) is stopped\n")
        self.assertEqual(self.done("nmt", BUS, "10", "start"), "node 10 (0Ah) is operational\n")
        self.assertEqual(json.loads(self.done("nmt", BUS, "10", "preop", "--json")),
                         {"event": "nmt-state", "node": 10, "state": "pre-operational", "text": "is pre-operational"})  # fmt: skip
        self.assertEqual(self.done("nmt", BUS, "10", "reset-communication"), "node 10 (0Ah) has booted\n")
        self.assertEqual(self.done("nmt", BUS, "10", "Pre_operational"), "node 10 (0Ah) is pre-operational\n", "as any name")
        self.assertEqual(self.done("nmt", BUS, "10", "operational", "--unchecked"), "")
        self.assert_refused(run("nmt", BUS, "10", "operatinal"), USAGE, "did you mean 'operational'?")

    def test_nmt_tells_of_all_nodes_that_are_heard(self):
        output = self.done("nmt", BUS, "all", "pre-operational", "--timeout", "3s")
        self.assertEqual(output, "node 5 (05h) is pre-operational\nnode 10 (0Ah) is pre-operational\n")
        listener = self.listen()
        self.done("nmt", BUS, "0", "pre-operational", "--unchecked")
        self.assertEqual(listener.next("000#"), "000#8000", "node-ID 0 are all of them (CiA 301, 7.2.8.3.1)")

    def test_a_state_that_is_not_reached_fails(self):
        listener = self.listen()
        stubborn = subprocess.Popen([CANVOY, "send", BUS, "707#7F", "--every", "50ms"])
        self.addCleanup(stubborn.wait)
        self.addCleanup(stubborn.terminate)
        listener.next("707")
        result = run("nmt", BUS, "7", "operational", "--timeout", "2s")
        self.assertEqual((result.stdout, result.returncode), ("node 7 (07h) is still pre-operational\n", FAILED))

    # -- frames by hand

    def heard(self, prefix, *arguments):
        """The first frame with this prefix that the command brings onto the bus, and what it prints."""
        listener = self.listen()
        output = self.done(*arguments)
        return listener.next(prefix), output

    def test_send_has_the_notation_of_cansend(self):
        self.assertEqual(self.heard("123", "send", BUS, "123#DEADBEEF"), ("123#DEADBEEF", ""))
        self.assertEqual(self.heard("00000123", "send", BUS, "00000123#11.22")[0], "00000123#1122")
        frame, output = self.heard("7F1", "send", BUS, "7F1#R", "--json")
        self.assertEqual((frame, json.loads(output)["frame"], json.loads(output)["bus"]), ("7F1#R", "7F1#R", BUS))
        output = self.done("send", BUS, "7F2#01", "--every", "20ms", "--count", "3", "--json")
        times = [json.loads(line)["time"] for line in output.splitlines()]
        self.assertEqual(len(times), 3)
        self.assertTrue(0.02 < times[2] - times[0] < 1, times)

    def test_sync_counts_where_wanted(self):  # CiA 301, 7.2.5
        listener = self.listen()
        self.done("sync", BUS)
        self.done("sync", BUS, "--every", "5ms", "--count", "5", "--counter", "3")
        syncs = (frame for frame in listener.frames() if frame.startswith("080"))
        self.assertEqual([next(syncs) for _ in range(6)], ["080#", "080#01", "080#02", "080#03", "080#01", "080#02"])

    def test_time_is_ms_of_the_day_and_days_since_1984(self):  # CiA 301, 7.2.6; the same as in value_argument_test.cpp
        self.assertEqual(self.heard("100", "time", BUS, "2026-11-21 12:00:00")[0], "100#002E9302313D")
        frame, _ = self.heard("100", "time", BUS)
        milliseconds, days = struct.unpack("<IH", bytes.fromhex(frame[4:]))
        told = datetime.datetime(1984, 1, 1) + datetime.timedelta(days=days, milliseconds=milliseconds)
        now = datetime.datetime.now(datetime.timezone.utc).replace(tzinfo=None)
        self.assertLess(abs((now - told).total_seconds()), PATIENCE)

    def test_emcy_has_code_register_and_data(self):  # CiA 301, 7.2.7.3
        self.assertEqual(self.heard("0A", "emcy", BUS, "33", "8130h")[0], "0A1#3081010000000000")
        self.assertEqual(self.heard("0A", "emcy", BUS, "33", "0x5000", "11", "--data", "01 02 03 04 05")[0], "0A1#0050110102030405")
        self.assertEqual(self.heard("0A", "emcy", BUS, "33", "0")[0], "0A1#0000000000000000")
        for code, register in (("8130", "11h"), ("8130H", "0x11"), ("0X8130", "11")):
            self.assertEqual(self.heard("0A", "emcy", BUS, "33", code, register)[0], "0A1#3081110000000000")
        for code in ("x", "81300", "8130 generic", "-1", ""):
            self.assert_refused(run("emcy", BUS, "33", code), USAGE, f"'{code}' is no error code: write 0000 to FFFF")
        for register in ("x", "111", "generic"):
            self.assert_refused(run("emcy", BUS, "33", "8130", register), USAGE, f"'{register}' is no error register: write 00 to FF")
        self.assert_refused(run("emcy", BUS, "33", "8130", "--data", "x"), USAGE, "--data: 'x'", "'01 02 AB'")
        self.assert_refused(run("emcy", BUS, "33", "8130", "--data", "010203040506"), USAGE, "five bytes")

    def test_a_pdo_is_made_as_the_node_maps_it(self):  # CiA 418: TPDO1 is temperature and battery status, RPDO1 the charger's status
        frame, output = self.heard("18A", "pdo", BUS, "10", "tpdo1")
        self.assertRegex(frame, r"\A18A#[0-9A-F]{6}\Z")
        self.assertIn("temperature = ", output)
        listener = self.listen()
        output = self.done("pdo", BUS, "10", "tpdo1", "battery_temperature=21.5 degC", "battery_status=ready")
        self.assertEqual(listener.next("18A#AC00"), "18A#AC0001", "0.125 °C a step")
        self.assertIn("temperature = 21.500 °C, battery_status = ready", output)
        self.assertEqual(self.heard("20A", "pdo", BUS, "10", "rpdo1", "charger_status=ready"), ("20A#01", "20A#01  charger_status = ready\n"))
        self.assert_refused(run("pdo", BUS, "5", "rpdo1"), FAILED, "1400h:01h", "not used")
        self.assertEqual(self.heard("18A#R", "pdo", BUS, "10", "tpdo1", "--request")[0], "18A#R")
        self.assert_refused(run("pdo", BUS, "10", "tpdo1", "battery_voltage=48"), USAGE, "'battery_voltage'", "temperature")
        self.assert_refused(run("pdo", BUS, "10", "tpdo99"), FAILED, "1862h:01h")

    def test_fields_of_a_pdo_that_are_not_named_stay_as_the_node_has_them(self):  # CiA 407, 6488h:02h: four doors, all valid and closed
        gateway = self.start("vehicle-gateway", "11")
        self.addCleanup(gateway.wait)
        self.addCleanup(gateway.terminate)
        doors = "state_of_doors, specific_state_1_to_4"
        self.assertRegex(self.done("pdo", BUS, "11", "tpdo1"), r"\A18B#0000000055 ")
        one = f"{doors}=door N: door open"
        self.assertRegex(self.done("pdo", BUS, "11", "tpdo1", one), r"\A18B#00000000D5 ")
        self.assertRegex(self.done("pdo", BUS, "11", "tpdo1", one, f"{doors}=door N+1: door open"), r"\A18B#00000000F5 ")

    # -- parameters

    def test_store_and_restore_write_the_signatures(self):  # CiA 301, 7.5.2.13 and 7.5.2.14
        listener = self.listen()
        self.assertEqual(self.done("store", BUS, "10"), "node 10 (0Ah) has stored all parameters\n")
        self.assertEqual(listener.next("60A#23"), "60A#2310100173617665")  # save
        self.assertEqual(self.done("restore", BUS, "10", "communication"),
                         "node 10 (0Ah) takes its defaults at the next reset of communication parameters\n")  # fmt: skip
        self.assertEqual(listener.next("60A#23"), "60A#231110026C6F6164")  # load
        told = json.loads(self.done("store", BUS, "10", "--json"))
        self.assertEqual((told["event"], told["node"], told["index"], told["sub"]), ("store", 10, "1010", "01"))
        self.assert_refused(run("store", BUS, "10", "77"), FAILED, "1010h:4Dh", "06090011h")

    def test_a_node_that_writes_its_memory_may_answer_late(self):
        listener = self.listen()
        environment = {name: value for name, value in os.environ.items() if name != "CANVOY_TIMEOUT"}
        command = subprocess.Popen([CANVOY, "store", BUS, "40"], stdout=subprocess.PIPE, text=True, env=environment)
        self.addCleanup(command.kill)
        self.assertEqual(listener.next("628#"), "628#2310100173617665")
        with self.assertRaises(subprocess.TimeoutExpired):  # other answers have a second
            command.wait(timeout=1.5)
        listener.send(0x5A8, bytes.fromhex("6010100100000000"))
        self.assertEqual(command.communicate(timeout=PATIENCE)[0], "node 40 (28h) has stored all parameters\n")

    def test_the_environment_says_how_long_to_wait(self):
        self.assert_refused(run("read", BUS, "99", "1000", env=dict(os.environ, CANVOY_TIMEOUT="100ms")), FAILED, "no answer within 0.100s")
        self.assert_refused(run("read", BUS, "99", "1000", env=dict(os.environ, CANVOY_TIMEOUT="soon")), USAGE, "'soon' is no time")

    def test_configure_diff_tells_names_and_both_values(self):
        file = self.folder / "charger.txt"
        file.write_text("1017 0 u16 700\n1014 0 u32 0x85\n2fff 0 u8 1\n")
        self.done("write", BUS, "5", "1017", "1s", "--blind")
        result = run("configure", BUS, "5", str(file), "--diff")
        self.assertEqual(result.stdout, "1017h:00h  Producer heartbeat time: 1000 ms -> 700 ms\n"
                                        "2FFFh:00h: not there -> 01\n"
                                        "node 5 (05h): 2 of 3 entries differ\n")  # fmt: skip
        self.assertEqual((result.stderr, result.returncode), ("", FAILED))
        self.assertEqual(self.done("read", BUS, "5", "1017"), "1000 ms\n", "nothing was written")
        line = json.loads(run("configure", BUS, "5", str(file), "--diff", "--json").stdout.splitlines()[0])
        self.assertEqual((line["event"], line["old"], line["value"], line["unit"]), ("difference", 1000, 700, "ms"))
        file.write_text("1017 0 u16 1000\n")
        self.assertEqual(self.done("configure", BUS, "5", str(file), "--diff"), "node 5 (05h): 0 of 1 entry differs\n")
        # A PDO is made invalid, and valid again: what counts is what is there in the end.
        self.done("write", BUS, "5", "1400:1", "0x80000285", "--blind")
        file.write_text("1400 1 u32 0x80000000\n1400 2 u8 255\n1400 1 u32 0x80000285\n")
        self.assertEqual(self.done("configure", BUS, "5", str(file), "--diff"), "node 5 (05h): 0 of 2 entries differ\n")
        self.done("write", BUS, "5", "1400:1", "0x80000000", "--blind")

    # -- expectations

    def test_an_expectation_is_told_or_fails(self):
        self.assertRegex(self.done("expect", BUS, "10", "temperature > 5degC"), r"\APASS node 10 \(0Ah\): temperature = \d+\.\d+ °C, expected temperature > 5degC\n\Z")
        self.assert_refused(run("expect", BUS, "10", "temperature > 90degC", "within", "150ms"), FAILED,
                            "temperature = ", "after 0.", "expected temperature > 90degC within 150ms")  # fmt: skip
        failed = run("expect", BUS, "10", "temperature < 5", "--json")
        self.assertEqual((json.loads(failed.stdout)["held"], failed.returncode), (False, FAILED))
        self.done("expect", BUS, "10", "temperature < 90 for 150ms")
        self.done("expect", BUS, "10", "temperature", "in", "5..90degC", "within", "2s")
        self.assert_refused(run("expect", BUS, "10", "temperature in 90..95degC"), FAILED, "temperature = ", "expected temperature in 90..95degC")
        self.assert_refused(run("expect", BUS, "10", "temperature in 5..90V"), USAGE, "'5..90V' is no range of numbers in °C")
        self.assert_refused(run("expect", BUS, "10", "temperature > 5V"), USAGE, "'5V' is no number in °C")

    def test_an_expectation_comes_true_in_time(self):
        self.done("write", BUS, "5", "1017", "1s", "--blind")
        waiting = subprocess.Popen([CANVOY, "expect", BUS, "5", "1017 = 900 ms within 60s"], stdout=subprocess.PIPE, text=True)
        time.sleep(0.2)
        self.done("write", BUS, "5", "1017", "900ms", "--blind")
        self.assertEqual(waiting.communicate(timeout=PATIENCE)[0], "PASS node 5 (05h): Producer heartbeat time = 900 ms, expected 1017 = 900 ms within 60s\n")
        self.assertEqual(waiting.returncode, DONE)

    def test_wait_ends_with_the_frame(self):
        self.assertIn("70A#", self.done("wait", BUS, "heartbeat and node=10 within 60s"))
        self.assertEqual(self.done("wait", BUS, "50ms"), "")

    # -- on a terminal

    def on_terminal(self, *arguments, **environment):
        ours, theirs = pty.openpty()
        subprocess.run(["stty", "cols", "40"], stdin=theirs, check=True)
        variables = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        done = subprocess.run([CANVOY, *arguments], stdout=theirs, stderr=subprocess.DEVNULL, env=dict(variables, **environment), timeout=60)
        os.close(theirs)
        output = b""
        try:
            while data := os.read(ours, 4096):
                output += data
        except OSError:  # all of it was read
            pass
        os.close(ours)
        self.assertEqual(done.returncode, DONE)
        return output.decode().replace("\r\n", "\n")

    def test_colour_and_wrapped_lines_are_for_terminals(self):
        log = self.folder / "colour.log"
        log.write_text("(0000000000.000001) can0 08A#3081110000000000\n")
        plain = self.done("decode", str(log))
        self.assertGreater(len(plain), 60)
        self.assertNotIn("\x1b", plain)
        shown = self.on_terminal("decode", str(log))
        self.assertIn("\x1b[31m", shown)
        lines = shown.replace("\x1b[31m", "").replace("\x1b[0m", "").splitlines()
        self.assertLessEqual(max(map(len, lines)), 40)
        self.assertIn("8130h life guard or heartbeat error, error register 11h (generic, communication), 00 00 00 00 00",
                      " ".join(line.strip() for line in lines), "nothing of it is cut")  # fmt: skip
        self.assertNotIn("\x1b", self.on_terminal("decode", str(log), NO_COLOR="1"))
        self.assertNotIn("\x1b", self.on_terminal("decode", str(log), "--colour", "never"))
        self.assertNotIn("\x1b", self.on_terminal("decode", str(log), "--json"))
        self.assertIn("\x1b[31m", self.done("decode", str(log), "--colour", "always"))
        self.assert_refused(run("decode", str(log), "--colour", "blue"), USAGE, "'blue'", "always")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
