#!/usr/bin/env python3
"""Whatever is wrong on the command line or with what it names: one line that says what and what to do, status 1 or 2."""

import pathlib
import re
import socket
import sys
import tempfile
import unittest

from command import DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

# A bus on which nobody is.
QUIET = "udp:239.74.163.9:43119"
ASKING = (["read", "10", "1000"], ["write", "10", "1017", "5s"], ["nmt", "10", "start"], ["sync"], ["expect", "10", "6010 > 5"])

# Arguments, and parts of the line that refuses them: what is wrong, and what would be right.
WRONG_USAGE = [
    # no verb, an unknown one, unknown options
    ([], "which verb?", "canvoy --help"),
    (["boat"], "'boat'", "did you mean 'boot'?", "canvoy --help"),
    (["raed", QUIET, "10", "6010"], "'raed'", "did you mean 'read'?"),
    (["nmt", QUIET, "10", "stopped", "--uncheked"], "'--uncheked'", "did you mean '--unchecked'?"),
    (["--fast"], "'--fast'", "canvoy --help"),
    (["decode", "a.log", "--", "--eds", "9=a.eds"], "'--eds' stands after '--'", "without it: canvoy decode a.log --eds 9=a.eds"),
    (["read", QUIET, "10", "6010", "--", "--json"], "'--json' stands after '--'", "6010 --json"),
    (["run"], "network", "canvoy run --help"),
    (["run", "boat"], "'boat'", "canvoy run --help"),
    (["run", "charger", "--fast"], "'--fast'", "canvoy run charger --help"),
    (["read", QUIET, "10", "6010", "--fast"], "'--fast'", "canvoy read --help"),
    (["read", QUIET, "10", "6010", "more_of_it"], "'more_of_it'", "no object"),
    (["run", "charger", "--for"], "--for"),
    # something is missing
    (["read"], "bus", "canvoy read --help"),
    (["read", QUIET, "10"], "object"),
    (["write", QUIET, "10", "1017"], "value"),
    (["nmt", QUIET], "node"),
    (["nmt", QUIET, "10"], "state"),
    (["monitor"], "which bus?", "canvoy monitor can0"),
    (["device"], "device is required"),
    (["device", "sim"], "bus is missing"),
    (["device", "charger"], "bus is missing", "canvoy device charger can0"),
    # buses
    (["monitor", "sim"], "sim", "can0 or udp:"),
    (["read", "sim", "10", "6010"], "sim", "can0 or udp:"),
    (["write", "sim", "10", "1017", "5"], "sim", "can0 or udp:"),
    (["nmt", "sim", "10", "start"], "sim", "can0 or udp:"),
    (["monitor", ""], "empty", "can0"),
    (["monitor", "any"], "any"),
    (["read", "can0,can1", "10", "6010"], "can0,can1", "one bus at a time"),
    (["monitor", "can0,sim"], "sim", "can0 or udp:"),
    (["send", "tcp:10.0.0.1", "123#"], "tcp:10.0.0.1", "behind a /"),
    (["send", "tcp:10.0.0.1:0/can0", "123#"], "1 to 65535"),
    (["monitor", "udp:10.0.0.1:43113"], "multicast"),
    (["monitor", "udp:239.74.163.2:0"], "1 to 65535"),
    (["monitor", "udp:239.74.163.2:43113?ttl=256"], "ttl", "0 to 255"),
    (["monitor", "an-interface-with-a-long-name"], "15 characters"),
    (["device", "charger", "udp:10.0.0.1"], "multicast"),
    (["read", "tpc:127.0.0.1:29536/can0", "10", "1000"], "tpc:127.0.0.1:29536/can0", "kind of bus is not known"),
    # the gateway
    (["gateway"], "which bus?", "canvoy gateway can0"),
    (["gateway", "sim"], "sim", "can0 or udp:"),
    (["gateway", f"0={QUIET}"], "numbered from 1"),
    (["gateway", f"2={QUIET}", f"2={QUIET}"], "network 2", "twice"),
    (["gateway", QUIET, "--node-id", "128"], "'128'", "1 to 127"),
    (["gateway", QUIET, "--version", "4"], "'4'", "3.0 or 2.1"),
    (["gateway", QUIET, "--stdin", "--listen", "127.0.0.1:0"], "--stdin"),
    # nodes
    (["read", QUIET, "0", "6010"], "'0'", "1 to 127"),
    (["read", QUIET, "128", "6010"], "'128'", "1 to 127"),
    (["read", QUIET, "0x80", "6010"], "'0x80'", "1 to 127"),
    (["read", QUIET, "ten", "6010"], "'ten'", "1 to 127"),
    (["nmt", QUIET, "300", "start"], "'300'", "1 to 127"),
    (["device", "battery", "sim", "--node-id", "0"], "'0'", "1 to 127"),
    (["device", "battery", "sim", "--node-id", "1", "--node-id", "2"], "--node-id"),
    (["device", "charger", "battery", "sim", "--node-id", "5"], "--node-id"),
    (["device", "charger", "battery", "sim", "--node-id", "5", "--node-id", "0x05"], "node 5", "twice"),
    (["device", "charger", "--node-id", "5", "battery", "--node-id", "5", "sim"], "node 5", "twice"),
    # devices
    (["device", "boat", "sim"], "'boat'", "`canvoy device --list`"),
    (["device", "charger", "charger", "sim"], "one charger"),
    (["device", "lift-drive", "lift-drive", "sim"], "one lift-drive"),
    (["device", "lift-drive", "lift-position", "sim", "--node-id", "2"], "--node-id"),
    (["device", "lift-landing-panel", "sim", "--press", "sideways@2s"], "'sideways@2s'", "there is up"),
    (["device", "lift-landing-panel", "sim", "--press", "up@soon"], "'soon'"),
    (["device", "lift-landing-panel", "sim", "--floor", "1", "--press", "down@2s"], "'down@2s'"),
    (["device", "io-401", "sim", "--set", "input65=on@1s"], "'input65'", "input1 to input64"),
    (["device", "io-401", "sim", "--set", "input5=high@1s"], "'input=high'", "off, on"),
    (["device", "io-401", "sim", "--move", "joystick1.x=1@1s"], "--move", "operator"),
    (["device", "lift-controller", "sim", "--press", "up@1s"], "'up@1s'", "no hands"),
    (["device", "lift-sensors", "sim", "--set", "smoke@1s"], "smoke=", "no-signal, signal"),
    (["device", "operator", "sim", "--set", "encoder1=0xG@1s"], "'encoder=0xG'", "0 to 4294967295"),
    (["device", "lift-landing-panel", "sim", "--floor", "11"], "--floor", "1 to 10"),
    (["device", "lift-landing-panel", "sim", "--lift", "9"], "--lift", "1 to 8"),
    (["device", "lift-landing-panel", "sim", "--store", "x"], "panel"),
    (["device", "lift-car-panel", "sim", "--press", "11@2s"], "'11@2s'", "1 to 10, open, close"),
    (["device", "lift-car-panel", "sim", "--floors", "65"], "--floors", "2 to 64"),
    (["device", "charger", QUIET, "--bit-rate", "250000"], "--bit-rate", "sim"),
    (["device", "charger", "sim", "--bit-rate", "9999"], "--bit-rate", "10000"),
    (["device", "charger", "sim", "--heartbeat", "65536ms"], "--heartbeat", "65535"),
    (["device", "charger", "sim", "--heartbeat", "soon"], "'soon'"),
    (["device", "battery", "sim", "--state-of-charge", "101"], "--state-of-charge", "100"),
    # objects
    (["read", QUIET, "10", "nonsense"], "'nonsense'", "6010 or 1018:4"),
    (["read", QUIET, "10", "12345"], "'12345'", "6010 or 1018:4"),
    (["read", QUIET, "10", "1018:"], "'1018:'", "6010 or 1018:4"),
    (["read", QUIET, "10", "1018:100"], "'1018:100'", "6010 or 1018:4"),
    (["read", QUIET, "10", ""], "''", "6010 or 1018:4"),
    (["read", QUIET, "10", "temperature", "--profile", "999"], "'999' is no profile", "417-4"),
    (["read", QUIET, "10", "water_level_status", "--profile", "419"], "'water_level_status'", "CiA 419"),
    (["run", "lift", "--percent", "nan"], "--percent", "nan is no finite number"),
    (["run", "charger", "--supply", "nan"], "--supply", "nan is no finite number"),
    (["run", "charger", "--ambience", "-inf"], "--ambience", "-inf is no finite number"),
    (["read", QUIET, "10", "6010", "--timeout", "0ms"], "'0ms'", "30s"),
    # values and units
    (["write", QUIET, "10", "1017", "65536"], "65536", "0 to 65535 ms"),
    (["write", QUIET, "10", "1017", "-1"], "-1", "0 to 65535 ms"),
    (["write", QUIET, "10", "1017", "500.5"], "'500.5'", "exactly", "500 ms or 501 ms"),
    (["write", QUIET, "10", "1017", "1.0005s"], "'1.0005s'", "1000 ms or 1001 ms"),
    (["write", QUIET, "10", "1017", "0x10000"], "0x10000", "0 to 65535 ms"),
    (["write", QUIET, "10", "2000", "1.5", "--type", "u8"], "'1.5'", "1 or 2"),
    (["write", QUIET, "10", "1017", "soon"], "'soon'", "ms"),
    (["write", QUIET, "10", "1017", "5 V"], "'5 V'", "ms"),
    (["write", QUIET, "10", "1017", "hex:1"], "'1'", "hex:01 02"),
    (["write", QUIET, "10", "2000", "1"], "2000h:00h", "--type"),
    (["write", QUIET, "10", "2000", "noon", "--type", "t"], "'noon'", "2026-11-21 12:00:00"),
    (["write", QUIET, "10", "2000", "2026-02-29 12:00", "--type", "t"], "'2026-02-29 12:00'"),
    (["write", QUIET, "10", "2000", "1 h", "--type", "td"], "'1 h'", "3 d 12:00:00"),
    (["write", QUIET, "10", "2000", "1", "--type", "u99"], "'u99'", "u64"),
    (["write", QUIET, "10", "2000", "256", "--type", "u8"], "256", "0 to 255"),
    (["write", QUIET, "10", "2000", "1", "--file", "some.bin"], "--file", "value"),
    (["write", QUIET, "10", "2000", "--block", "--segmented"], "--segmented", "--block"),
    (["read", QUIET, "10", "2000", "--block", "--segmented"], "--segmented", "--block"),
    (["read", QUIET, "10", "2000", "--out", "some.bin", "--json"], "--json", "--out"),
    # LSS
    (["lss"], "bus", "canvoy lss --help"),
    (["lss", QUIET], "command"),
    (["lss", "sim", "scan"], "sim", "can0 or udp:"),
    (["lss", "-", "scan"], "'-'", "only be listened to"),
    (["lss", QUIET, "discover"], "'discover'", "scan, inquire"),
    (["lss", QUIET, "scan", "now"], "'now'", "scan"),
    (["lss", QUIET, "scan", "--store"], "--store", "--assign"),
    (["lss", QUIET, "scan", "--assign", "20-10"], "'20-10'", "10-20"),
    (["lss", QUIET, "scan", "--assign", "10,10"], "10", "twice"),
    (["lss", QUIET, "scan", "--assign", "0-10"], "'0'", "1 to 127"),
    (["lss", QUIET, "scan", "--only", "1:2:3:4:5"], "'1:2:3:4:5'", "VENDOR:PRODUCT"),
    (["lss", QUIET, "inquire", "--select", "1:2:3"], "'1:2:3'", "VENDOR:PRODUCT"),
    (["lss", QUIET, "set-node-id"], "node-ID"),
    (["lss", QUIET, "set-node-id", "128"], "'128'", "1 to 127"),
    (["lss", QUIET, "set-bit-rate", "100k"], "'100k'", "125k"),
    (["lss", QUIET, "activate", "65536ms"], "'65536ms'", "65535"),
    (["lss", QUIET, "switch", "sideways"], "'sideways'", "waiting or configuration"),
    (["lss", QUIET, "switch", "waiting", "--select", "1:2:3:4"], "--select"),
    (["device", "charger", "sim", "--bit-rate", "auto"], "--bit-rate", "'auto'"),
    (["device", "bootloader", "sim", "--node-id", "lss", "--store", "x"], "bootloader", "LSS"),
    (["device", "charger", "sim", "--serial-number", "-1"], "--serial-number"),
    # configurations
    (["configure"], "bus", "canvoy configure --help"),
    (["configure", QUIET, "10"], "file"),
    (["configure", QUIET, "128", "some.cdcf"], "'128'", "1 to 127"),
    (["configure", QUIET, "10", "some.cdcf", "--timeout", "0ms"], "'0ms'", "30s"),
    # NMT commands
    (["nmt", QUIET, "10", "go"], "'go'", "operational (or start)"),
    (["nmt", QUIET, "10", "opertional"], "did you mean 'operational'?"),
    # frames, PDOs, parameters by hand
    (["send", QUIET], "frame"),
    (["send", QUIET, "123"], "'123'", "123#DEADBEEF"),
    (["send", QUIET, "123#1"], "'123#1'", "pairs"),
    (["send", QUIET, "20000004#00"], "error frame"),
    (["send", QUIET, "123#", "--count", "3"], "--every"),
    (["sync", QUIET, "--counter", "1"], "--counter"),
    (["sync", QUIET, "--every", "soon"], "'soon'"),
    (["time", QUIET, "noon"], "'noon'", "2026-11-21 12:00:00"),
    (["emcy", QUIET, "10", "code"], "'code'"),
    (["emcy", QUIET, "10", "8130", "01", "--data", "01 02 03 04 05 06"], "five bytes"),
    (["emcy", QUIET, "all", "8130"], "'all'", "1 to 127"),
    (["pdo", QUIET, "10", "pdo1"], "'pdo1'", "rpdo1"),
    (["pdo", QUIET, "10", "rpdo0"], "'rpdo0'", "rpdo512"),
    (["pdo", QUIET, "10", "rpdo1", "temperature"], "OBJECT=VALUE"),
    (["pdo", QUIET, "10", "rpdo1", "--request"], "TPDO"),
    (["store", QUIET, "10", "everything"], "'everything'", "communication"),
    (["restore", QUIET, "10", "aplication"], "did you mean 'application'?"),
    # a log is no bus
    *[([verb, source, *rest], f"'{source}'", "can only be listened to", "name a bus")
      for source in ("-", "night.log", "./night")
      for verb, *rest in (["scan"], ["browse", "10"], ["clone", "10"], ["boot", "--node", "5"], ["gateway"])],
    *[([verb, source, *rest], f"'{source}'", "can only be listened to", "name a bus")
      for source in ("-", "./night") for verb, *rest in ASKING],
    *[([verb, "night.log", *rest], f"'{verb}' is of a bus", "canvoy decode night.log") for verb, *rest in ASKING],
    *[(["device", "charger", source], f"'{source}'", "can only be listened to", "name a bus") for source in ("-", "night.log", "./night")],
    # options of lines, where there are none
    (["view", "night.log", "--transfers"], "'--transfers' is not known"),
    (["view", "night.log", "--json"], "'--json' is not known"),
    (["report", "night.log", "--transfers"], "'--transfers' is not known"),
    (["plot", "night.log", "temperature", "--transfers"], "'--transfers' is not known"),
    # expectations and scripts
    (["expect", QUIET, "10", "temperature"], "OBJECT > VALUE"),
    (["expect", QUIET, "10", "tempersture > 5"], "'tempersture'", "did you mean 'temperature'?"),
    (["expect", QUIET, "10", "temperature > 5 within soon"], "'soon'"),
    (["expect", QUIET, "10", "temperature in 5"], "OBJECT in FROM..TO"),
    (["wait", QUIET, "tempersture > 5"], "did you mean 'temperature'?"),
    (["wait", QUIET, "heartbeat within soon"], "'soon'"),
    (["script", QUIET], "file"),
    (["script", QUIET, "-"], "stdin", "no line"),
    (["read", QUIET, "10", "6010", "--count", "3"], "--watch"),
    (["read", QUIET, "10", "6010", "--watch", "soon"], "'soon'"),
    (["read", QUIET, "10", "6010", "6011", "--out", "x"], "--out"),
    # times
    (["run", "charger", "--for", "8"], "'8' has no unit", "8min"),
    (["run", "charger", "--for", "0s"], "'0s'", "8h"),
    (["run", "charger", "--for", "-5s"], "-5s"),
    (["run", "charger", "--for", "8 parsec"], "'8 parsec'", "8h"),
    (["device", "charger", "sim", "--for", "soon"], "'soon'", "8h"),
    (["device", "charger", QUIET, "--for", "soon"], "'soon'", "8h"),
    (["monitor", QUIET, "--for", "soon"], "'soon'", "8h"),
    (["monitor", QUIET, "--count", "many"], "--count"),
    # a network to boot
    (["boot", QUIET], "--node 5"),
    (["boot", QUIET, "--node", "0"], "'0'", "1 to 127"),
    (["boot", QUIET, "--node", "5:urgent"], "'urgent'", "mandatory"),
    (["boot", QUIET, "--node", "5:vendor=4294967296"], "vendor=4294967296", "32 bits"),
    (["boot", QUIET, "--node", "5:heartbeat=66s"], "heartbeat=66s", "65535ms"),
    (["boot", QUIET, "--node", "5:guard=1s*0"], "guard=1s*0", "1 to 255"),
    (["boot", QUIET, "--node", "5", "--node", "0x05"], "node 5", "twice"),
    (["boot", QUIET, "--node", "5", "--node-id", "5"], "node 5", "master"),
    (["boot", QUIET, "--node", "5", "--start", "soon"], "soon", "each, all or none"),
    (["boot", QUIET, "--node", "5:restore=255"], "restore=255", "1011h"),
    (["boot", QUIET, "--node", "5:program-id=crc"], "program-id=crc", "32 bits"),
    (["boot", QUIET, "--node", "5:configuration-date=today"], "configuration-date=today", "2026-11-21 12:00:00"),
    (["run", "charger", "--begin", "noon"], "noon", "2026-11-21 18:00:00"),
    (["gateway", QUIET, "udp:239.74.163.9:43119", "--boot", "x.toml"], "--boot", "one network"),
    (["lss", QUIET, "activate", "100ms", "--bit-rate", "auto"], "--bit-rate", "125k"),
    (["boot", QUIET, "--node", "5", "--boot-time", "10"], "'10'", "10s"),
    # what is left to chance, and how fast
    (["run", "charger", "--seed", "one"], "--seed"),
    (["run", "charger", "--seed", "-1"], "'-1' is no whole number from 0 to 18446744073709551615"),
    (["run", "charger", "--speed", "-1"], "--speed", "0"),
    (["run", "charger", "--state-of-charge", "-1"], "--state-of-charge", "100"),
    (["run", "charger", "--ambience", "200"], "--ambience", "85"),
    # faults
    (["run", "charger", "--fault", "earthquake@1min"], "'earthquake@1min'", "heartbeat-loss"),
    (["run", "charger", "--fault", "heartbeat-loss"], "'heartbeat-loss'", "@20min"),
    (["run", "charger", "--fault", "heartbeat-loss@"], "'heartbeat-loss@'", "@20min"),
    (["run", "charger", "--fault", "heartbeat-loss@soon"], "'heartbeat-loss@soon'", "@20min"),
    (["run", "charger", "--fault", "heartbeat-loss@1min+0s"], "'heartbeat-loss@1min+0s'", "+30s"),
    (["run", "charger", "--fault", "heartbeat-loss@1min+"], "'heartbeat-loss@1min+'", "+30s"),
    (["run", "charger", "--for", "10min", "--fault", "too-hot@1h"], "'too-hot@1h'", "--for"),
    # a log is read, not logged
    (["monitor", "some.log", "--log", "other.log"], "--log"),
]

# What is said well, but cannot be done.
FAILURES = [
    (["monitor", "nocan0"], "nocan0"),
    (["device", "charger", "nocan0"], "nocan0"),
    (["read", "nocan0", "10", "6010"], "nocan0"),
    (["nmt", "nocan0", "10", "start"], "nocan0"),
    (["nmt", QUIET, "10", "start", "--timeout", "100ms"], "no heartbeat of node 10 (0Ah)", "--unchecked"),
    (["nmt", QUIET, "all", "start", "--timeout", "100ms"], "no heartbeat of any node"),
    (["send", "tcp:127.0.0.1:1/can0", "123#"], "tcp:127.0.0.1:1/can0", "refused", "socketcand"),
    (["wait", QUIET, "heartbeat within 100ms"], "no frame passes 'heartbeat'"),
    (["expect", QUIET, "10", "6010 > 5", "--timeout", "100ms"], "no answer within"),
    (["script", QUIET, "/no/such/script"], "/no/such/script", "check the path"),
    (["read", QUIET, "pump", "6010", "--network", "/no/such/file.toml"], "/no/such/file.toml"),
    (["gateway", "nocan0"], "nocan0"),
    (["gateway", QUIET, "--listen", "localhost"], "localhost", "127.0.0.1:60000"),
    (["gateway", QUIET, "--listen", "192.0.2.1:0"], "192.0.2.1:0", "choose another"),
    (["read", QUIET, "10", "6010", "--timeout", "100ms"], "node 10 (0Ah)", "no answer within", "power"),
    (["read", QUIET, "10", "temperature", "--timeout", "100ms"], "node 10 (0Ah)", "no answer within"),
    (["write", QUIET, "10", "1017", "500 ms", "--timeout", "100ms"], "node 10 (0Ah)", "no answer within"),
    (["boot", "nocan0", "--node", "5"], "nocan0"),
    (["boot", QUIET, "--config", "/no/such/file.toml"], "/no/such/file.toml", "check the path"),
    (["boot", QUIET, "--node", "5:configuration=/no/such/file"], "/no/such/file"),
    (["gateway", QUIET, "--boot", "/no/such/file.toml"], "/no/such/file.toml", "check the path"),
    (["lss", QUIET, "activate", "100ms", "--bit-rate", "250k"], "no bit rate to switch", "leave --bit-rate out"),
    (["boot", QUIET, "--node", "5:program=/no/such/file"], "/no/such/file"),
    (["read", QUIET, "10", "2000", "--out", "some.bin", "--timeout", "100ms"], "node 10 (0Ah)", "no answer within"),
    (["write", QUIET, "10", "2000", "--file", "/no/such/file"], "/no/such/file", "check the path"),
    (["write", QUIET, "10", "2000", "--file", "/"], "/:", "directory"),
    (["lss", QUIET, "scan", "--first-timeout", "10ms"], "no node without node-ID"),
    (["lss", QUIET, "identify", "--timeout", "100ms"], "no node without node-ID"),
    (["lss", QUIET, "identify", "--select", "1:2:3:4", "--timeout", "100ms"], "no node has this address"),
    (["lss", QUIET, "inquire", "--select", "1:2:3:4", "--timeout", "100ms"], "no node answered", "power"),
    (["lss", QUIET, "set-node-id", "5", "--timeout", "100ms"], "no node answered", "power"),
    (["lss", "nocan0", "scan"], "nocan0"),
    (["configure", QUIET, "10", "/no/such/folder/node.cdcf"], "/no/such/folder/node.cdcf", "check the path"),
    (["configure", QUIET, "10", "/"], "/:", "directory"),
    (["configure", QUIET, "10", "/dev/null"], "/dev/null", "no entry"),
    (["configure", QUIET, "10", "/dev/zero"], "/dev/zero", "16 MiB"),
    (["device", "charger", "nocan0", "--bit-rate", "auto"], "nocan0"),
    (["run", "charger", "--for", "5min", "--log", "/dev/full"], "/dev/full", "No space", "make room"),
    (["run", "charger", "--log", "/no/such/folder/bus.log"], "/no/such/folder/bus.log", "check the path"),
    (["run", "charger", "--log", "/"], "/:", "directory"),
    (["monitor", QUIET, "--log", "/no/such/folder/bus.log"], "/no/such/folder/bus.log", "check the path"),
    (["monitor", "/no/such/folder/bus.log"], "/no/such/folder/bus.log", "check the path"),
    (["monitor", "/"], "/:", "folder"),
]


class BadInput(CommandTest):
    """Each row of the tables is a test."""

    def test_wrong_usage_is_refused_in_one_line_with_status_2(self):
        for arguments, *parts in WRONG_USAGE:
            with self.subTest(command=" ".join(arguments)):
                self.assert_refused(run(*arguments), USAGE, *parts)

    def test_what_cannot_be_done_is_told_in_one_line_with_status_1(self):
        for arguments, *parts in FAILURES:
            with self.subTest(command=" ".join(arguments)):
                self.assert_refused(run(*arguments), FAILED, *parts)

    def test_output_that_cannot_be_written_is_told(self):
        with tempfile.NamedTemporaryFile("w", suffix=".log") as log, open("/dev/full", "w", encoding="ascii") as full:
            log.write("(0000000001.000000) can0 70A#05\n" * 1000)
            log.flush()
            for arguments in (["run", "charger", "--for", "1min"], ["monitor", log.name], ["decode", log.name]):
                with self.subTest(command=" ".join(arguments)):
                    self.assert_refused(run(*arguments, stdout=full), FAILED, "output", "room")

    def test_a_malformed_line_of_a_log_is_told_with_its_number_and_passed_over(self):
        with tempfile.NamedTemporaryFile("w", suffix=".log") as log:
            log.write("(0000000001.000000) can0 70A#0\n(0000000001.000000) can0 70A#05\n")
            log.flush()
            for command in ("monitor", "decode"):
                result = run(command, log.name)
                self.assertEqual(result.returncode, 0)
                self.assertIn(f"{log.name}, line 1: ", result.stderr)
                self.assertIn("operational", result.stdout)

    def test_nothing_is_written_where_the_command_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder, socket.create_server(("127.0.0.1", 0)) as other:
            taken = str(other.getsockname()[1])
            network = pathlib.Path(folder) / "charger.toml"
            network.write_text('network = "charger"\n[bus]\nreal = "nocan0"\n[battery]\nplayed = false\n', encoding="ascii")
            log = pathlib.Path(folder) / "precious.log"
            for arguments in (
                ["run", "charger", "--fault", "earthquake@1min", "--log", log],
                ["run", "charger", "--for", "soon", "--log", log],
                ["monitor", QUIET, "--for", "soon", "--log", log],
                ["monitor", "nocan0", "--log", log],
                ["run", "charger", "--web", "99999", "--log", log],
                ["run", "charger", "--web", taken, "--log", log],
                ["run", "charger", "--web", "--allow-record", "/no/such", "--log", log],
                ["run", network, "--log", log],
                ["run", network, "--web", "--log", log],
                ["view", QUIET, "--web", "99999", "--record", log],
                ["view", QUIET, "--web", taken, "--record", log],
                ["view", QUIET, "--allow-record", "/no/such", "--record", log],
            ):
                with self.subTest(" ".join(map(str, arguments))):
                    log.write_text("a night's work\n", encoding="ascii")
                    self.assertNotEqual(run(*map(str, arguments)).returncode, DONE)
                    self.assertEqual(log.read_text(encoding="ascii"), "a night's work\n")

    def test_help_is_no_error(self):
        names = ["run", "device", "monitor", "read", "write", "configure", "nmt", "boot", "lss", "gateway", "program",
                 "send", "sync", "time", "emcy", "pdo", "store", "restore", "expect", "wait", "script"]
        commands = [[], ["run", "charger"], *([name] for name in names)]
        for command in commands:
            self.assertIn("Usage:", self.assert_done(run(*command, "--help")))


# What is read as a number by strtod() or std::from_chars(), or almost, and is none that can be meant.
NO_NUMBERS = ["nan", "-nan", "nan(5)", "inf", "-inf", "infinity", "1e999", "-1e999", "99999999999999999999999", "0x", ""]

# Where a number is part of a text: {} stands for it.
TEXTS_WITH_NUMBERS = [
    ["run", "charger", "--goal", "{}@06:00"],
    ["run", "charger", "--goal", "80@{}:00"],
    ["run", "charger", "--goal", "80@06:{}"],
    ["run", "charger", "--supply", "{}"],
    ["run", "charger", "--state-of-charge", "{}"],
    ["run", "charger", "--chargers", "{}"],
    ["run", "lift", "--percent", "{}"],
    ["run", "lift", "--lifts", "{}"],
    ["run", "charger", "--for", "{}min"],
    ["run", "charger", "--seed", "{}"],
    ["run", "charger", "--speed", "{}"],
    ["run", "charger", "--fault", "too-hot@{}min"],
    ["run", "charger", "--fault", "too-hot@1min+{}s"],
    ["device", "battery", "sim", "--set", "temperature={}@1s"],
    ["device", "battery", "sim", "--set", "temperature=20@{}s"],
    ["device", "battery", "sim", "--state-of-charge", "{}"],
    ["device", "lift-load", "sim", "--load", "{}@10s"],
    ["device", "lift-light-barrier", "sim", "--in-door", "{}s+5s"],
    ["device", "ivn-gateway", "sim", "--speed", "{}@3s"],
    ["device", "navigation", "sim", "--set", "destination={},11@1s"],
    ["device", "navigation", "sim", "--set", "destination=48,{}@1s"],
    ["write", QUIET, "10", "2000", "{}", "--type", "i16"],
    ["monitor", QUIET, "--count", "{}"],
]


class NoNumbers(CommandTest):
    """What is no finite number is refused wherever one is taken, and so is a place of a fault that is not there."""

    def test_in_each_text_that_has_one(self):
        for arguments in TEXTS_WITH_NUMBERS:
            for number in NO_NUMBERS:
                words = [word.format(number) for word in arguments]
                with self.subTest(words=words):
                    self.assert_refused(run(*words), USAGE)

    def test_in_a_value_of_an_object(self):
        for number in NO_NUMBERS:
            # A real has 1e23; what is greater than a REAL32 is none.
            if number.startswith("9"):
                continue
            with self.subTest(number=number):
                self.assert_refused(run("write", QUIET, "10", "2000", number, "--type", "r32"), USAGE)

    def test_in_each_hand_of_each_device_that_takes_one(self):
        devices = [line.split()[0] for line in self.assert_done(run("device", "--list")).splitlines()]
        hands = 0
        for device in devices:
            for line in run("device", device, "--hands").stdout.splitlines():
                name = re.match(rf"{device} +([a-z0-9.-]+)(?: to [a-z0-9.-]+)?= .*[0-9] to -?[0-9]", line)
                if not name:
                    continue
                hands += 1
                for number in ("nan", "-inf", "1e999"):
                    with self.subTest(device=device, hand=name[1], number=number):
                        self.assert_refused(run("device", device, "sim", "--set", f"{name[1]}={number}@1s"), USAGE, name[1].rstrip("0123456789"))
        self.assertGreater(hands, 40)

    def test_in_each_place_of_each_fault_of_each_world(self):
        worlds = re.findall(r"^  ([a-z-]+) ", run("run", "--help").stdout.partition("Subcommands:")[2].partition("\n\n")[0], re.MULTILINE)
        beyond = {"lift": "8", "floor": "200", "node": "127", "bay": "16", "axis": "5"}
        faults = 0
        for world in worlds:
            help_of_faults = run("run", world, "--help").stdout.partition("--fault")[2].partition("--link")[0]
            places = re.findall(r":([a-z]+)=NUMBER", help_of_faults)
            kinds = re.findall(r"^ {36}([a-z-]+): ", help_of_faults, re.MULTILINE)
            self.assertTrue(places and kinds, help_of_faults)
            faults += len(kinds)
            for kind in kinds:
                for place in places:
                    more = ["-1", "256", "1.5", "4294967297", *NO_NUMBERS] if kind == kinds[0] else []
                    for value in ["0", "255", beyond[place], *more]:
                        text = f"{kind}:{place}={value}@1min"
                        with self.subTest(world=world, fault=text):
                            self.assert_refused(run("run", world, "--fault", text), USAGE, kind)
        self.assertGreater(faults, 70)


class Misspelt(CommandTest):
    def test_a_word_that_is_nearly_one_is_answered_with_it(self):
        for line, meant in (
            ("run chargr", "charger"),
            ("report chargr --out x.html", "charger"),
            ("eds export chargr", "charger"),
            ("export dbc lift-dor", "lift-door"),
            ("man raed", "read"),
            ("run taxi --fault paper-ot@1s", "paper-out"),
            ("device chargr sim", "charger"),
            ("raed can0 1", "read"),
            ("profile 418 tempersture", "temperature"),
            ("boot can0 --node 10:mandatry", "mandatory"),
        ):
            with self.subTest(line=line):
                self.assert_refused(run(*line.split()), USAGE, f"did you mean '{meant}'?")

    def test_the_name_of_an_object_in_a_log(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder) / "one.log"
            log.write_text("(1.0) can0 58A#4B106000A0000000\n")
            self.assert_refused(run("plot", str(log), "temprature", "--node", "10=418"), FAILED, "did you mean 'temperature'?")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
