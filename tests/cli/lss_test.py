#!/usr/bin/env python3
"""`canvoy lss` with devices of other processes: finds those without node-ID, names them, and harms no bystander."""

import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import own_network  # noqa: E402

from command import CANVOY, FAILED, USAGE, CommandTest, run

BUS = "udp:239.74.163.2:43113"
FIRST = "vendor 0h, product 1A2h, revision 0h, serial 7h"
SECOND = "vendor 0h, product 1A2h, revision 0h, serial 8h"
SELECT_SECOND = ("--select", "0:0x1A2:0:8")


def lss(*arguments):
    """A busy machine needs its time."""
    return run("lss", BUS, *arguments, "--timeout", "4000ms")


class Battery:
    """A battery that waits for a node-ID, until the end of a with statement."""

    def __init__(self, serial_number, *more):
        self.arguments = ["device", "battery", BUS, "--node-id", "lss", "--serial-number", serial_number, *more]

    def __enter__(self):
        self.process = subprocess.Popen([CANVOY, *self.arguments], stdout=subprocess.PIPE, text=True)
        self.hear("waits for a node-ID by LSS", "pre-operational")
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        self.process.communicate(timeout=60)

    def hear(self, *wanted):
        """Reads on until a line with one of these, which it returns."""
        for line in self.process.stdout:
            if any(text in line for text in wanted):
                return line.strip()
        raise AssertionError(f"the device has ended, and did not say {wanted}")


class Slave:
    """A node with a bit rate to choose, which batteries on UDP have not; until the end of a with statement."""

    # CiA 305: by the first byte of a request, what it answers with: identity 1 to 4, no node-ID, and success.
    ANSWERS = {"5A": "5A01000000000000", "5B": "5B02000000000000", "5C": "5C03000000000000", "5D": "5D04000000000000",
               "5E": "5EFF000000000000", "13": "1300000000000000", "17": "1700000000000000"}  # fmt: skip

    def __enter__(self):
        self.requests = []
        self.bus = subprocess.Popen([CANVOY, "monitor", BUS, "--filter", "id=7E5", "--json"], stdout=subprocess.PIPE, text=True)
        self.thread = threading.Thread(target=self.answer)
        self.thread.start()
        while not self.requests:
            run("send", BUS, "7E5#0400000000000000")  # all to waiting
        return self

    def __exit__(self, *_):
        self.bus.send_signal(signal.SIGTERM)
        self.thread.join()
        self.bus.communicate(timeout=60)

    def answer(self):
        for line in self.bus.stdout:
            data = json.loads(line)["frame"].split("#")[1]
            self.requests.append(data)
            if data[:2] in self.ANSWERS:
                run("send", BUS, f"7E4#{self.ANSWERS[data[:2]]}")


class LssTest(CommandTest):
    def test_a_bit_rate_is_set_and_stored(self):  # CiA 305: table 0, of which 4 is 125 kbit/s, and 9 automatic
        with Slave() as slave:
            told = self.assert_told(lss("set-bit-rate", "125k", "--json"))
            self.assertEqual(told, [{"event": "configured", "bit_rate": 125000, "stored": False}])
            self.assertIn("1300040000000000", slave.requests)
            self.assertNotIn("1700000000000000", slave.requests)
            told = self.assert_told(lss("set-bit-rate", "auto", "--store", "--json"))
            self.assertEqual(told, [{"event": "configured", "bit_rate": None, "stored": True}])
            self.assertIn("1300090000000000", slave.requests)
            self.assertIn("1700000000000000", slave.requests)
            self.assertEqual(self.assert_done(lss("set-bit-rate", "250k")), "250000 bit/s are set\n")

    def test_nobody_there_is_told(self):
        self.assert_refused(run("lss", BUS, "scan"), FAILED, "no node without node-ID answered")
        self.assert_refused(run("lss", BUS, "inquire", "--timeout", "300ms"), FAILED, "no node answered within 0.300s")
        self.assert_refused(run("lss", BUS, "switch", "wating"), USAGE, "did you mean 'waiting'?")

    def test_a_scan_finds_all_and_names_them(self):
        with Battery("7") as first, Battery("8") as second:
            scan = ("scan", "--first-timeout", "1000ms")
            self.assertEqual(self.assert_done(lss(*scan)), f"{FIRST}\n{SECOND}\n")
            named = self.assert_done(lss(*scan, "--assign", "20-30"))
            self.assertEqual(named, f"{FIRST}: node 20 (14h)\n{SECOND}: node 21 (15h)\n")
            first.hear("is node 20 (14h)")
            second.hear("is node 21 (15h)")
            self.assert_refused(lss(*scan), FAILED, "no node without node-ID answered")

    def test_one_of_two_has_to_be_named(self):
        with Battery("7"), Battery("8") as second:
            for command in (["inquire"], ["set-node-id", "10"], ["set-bit-rate", "125k"], ["store"]):
                self.assert_refused(lss(*command), FAILED, "more than one node answers", "--select")
            self.assertEqual(self.assert_done(lss("inquire", *SELECT_SECOND)), f"{SECOND}: no node-ID\n")
            self.assertEqual(self.assert_done(lss("set-node-id", "10", *SELECT_SECOND)), "node 10 (0Ah) is set\n")
            second.hear("is node 10 (0Ah)")
            # The other one is still there, without one.
            self.assertEqual(self.assert_done(lss("scan", "--first-timeout", "1000ms")), f"{FIRST}\n")

    def test_all_is_told_as_json(self):
        address = {"vendor_id": "00000000", "product_code": "000001A2", "revision": "00000000", "serial_number": "00000007"}
        with Battery("7") as battery:

            def tell(*arguments):
                return self.assert_told(lss(*arguments, "--json"))

            self.assertEqual(tell("identify"), [{"event": "identified", "text": "there are nodes without node-ID"}])
            self.assertEqual(tell("scan", "--first-timeout", "1000ms"), [{"event": "found", **address, "duplicate": False, "text": FIRST}])
            self.assertEqual(tell("switch", "configuration"), [{"event": "lss-state", "state": "configuration"}])
            self.assertEqual(tell("set-node-id", "10"), [{"event": "configured", "node": 10, "stored": False}])
            battery.hear("is node 10 (0Ah)")
            self.assertEqual(tell("inquire"), [{"event": "found", **address, "node": 10, "text": f"{FIRST}: node 10 (0Ah)"}])
            self.assertEqual(tell("identify", "--select", "0:0x1A2:0:7"), [{"event": "identified", **address, "text": "a node has this address"}])
            self.assertEqual(tell("set-node-id", "none"), [{"event": "configured", "node": None, "stored": False}])
            self.assertEqual(self.assert_done(lss("switch", "configuration")), "all nodes are in LSS state configuration\n")
            self.assertEqual(self.assert_done(lss("switch", "waiting")), "all nodes are in LSS state waiting\n")
            self.assertEqual(self.assert_done(lss("switch", "configuration", "--select", "0:0x1A2:0:7")), f"{FIRST} is in LSS state configuration\n")
            self.assert_refused(lss("set-bit-rate", "125k", "--json"), FAILED, "the node does not have this bit rate")
            self.assertEqual(tell("activate", "10ms"), [{"event": "switch", "delay_s": 0.01}])

    def test_what_is_stored_is_there_after_a_restart(self):
        with tempfile.TemporaryDirectory() as folder:
            store = ("--store", f"{folder}/store")
            with Battery("7", *store) as battery:
                self.assertEqual(self.assert_done(lss("set-node-id", "11", "--store")), "node 11 (0Bh) is set, stored\n")
                battery.hear("is node 11 (0Bh)")
            with Battery("7", *store):
                self.assertEqual(self.assert_done(lss("inquire")), f"{FIRST}: node 11 (0Bh)\n")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
