#!/usr/bin/env python3
"""`canvoy device --store` and `canvoy program`: what a device is told to keep is there when it starts again."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import own_network  # noqa: E402

from command import CANVOY, FAILED, USAGE, CommandTest, run

BUS = "udp:239.74.163.2:43113"


class Device:
    """A device of the command, as a process, until the end of a with statement."""

    def __init__(self, *arguments):
        self.arguments = arguments

    def __enter__(self):
        self.process = subprocess.Popen(
            [CANVOY, "device", *self.arguments, BUS],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.lines = []
        for line in self.process.stdout:
            self.lines.append(line.strip())
            if "pre-operational" in line or "operational" in line:
                return self
        raise AssertionError(f"the device has not started: {self.process.stderr.read()}")

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        out, self.stderr = self.process.communicate(timeout=60)
        self.lines += out.splitlines()


class StorageTest(CommandTest):
    """Devices on UDP multicast, in a network of their own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.store = str(self.folder / "device.store")

    def read(self, node, *object_and_options):
        return self.assert_done(run("read", BUS, str(node), *object_and_options, "--timeout", "10000ms")).strip()

    def write(self, node, *object_and_value):
        self.assert_done(run("write", BUS, str(node), *object_and_value, "--timeout", "10000ms"))

    def test_what_is_saved_is_there_after_a_restart_and_what_is_not_is_not(self):
        with Device("battery", "--store", self.store):
            self.write(10, "1017", "700")
            self.write(10, "1010:1", "save")
            self.write(10, "1017", "800")
        with Device("battery", "--store", self.store):
            self.assertTrue(self.read(10, "1017").startswith("700"))

    def test_load_gives_the_defaults_back_after_a_restart(self):
        with Device("battery", "--store", self.store):
            self.write(10, "1017", "700")
            self.write(10, "1010:1", "save")
        with Device("battery", "--store", self.store):
            self.write(10, "1011:1", "load")
            self.assertTrue(self.read(10, "1017").startswith("700"))
        with Device("battery", "--store", self.store):
            self.assertTrue(self.read(10, "1017").startswith("1000"))

    def test_a_wrong_signature_is_refused(self):
        with Device("battery", "--store", self.store):
            result = run("write", BUS, "10", "1010:1", "hex:01 02 03 04", "--timeout", "10000ms")
            self.assert_refused(result, FAILED, "1010h")

    def test_a_set_that_was_damaged_is_told_and_the_defaults_hold(self):
        with Device("battery", "--store", self.store):
            self.write(10, "1017", "700")
            self.write(10, "1010:1", "save")
        content = bytearray(pathlib.Path(self.store).read_bytes())
        content[64 + 32 + 5] ^= 1
        pathlib.Path(self.store).write_bytes(content)
        with Device("battery", "--store", self.store) as device:
            self.assertTrue(self.read(10, "1017").startswith("1000"))
            self.assertIn("6300h", self.read(10, "1003:1"))
        self.assertRegex(device.stderr, r"\Acanvoy: [^\n]*device.store: what was stored is damaged[^\n]*\n\Z")

    def test_the_set_of_a_charger_is_foreign_to_a_battery(self):
        with Device("charger", "--store", self.store):
            self.write(5, "1010:1", "hex:73 61 76 65")
        with Device("battery", "--store", self.store) as device:
            pass
        self.assertIn("of another kind of device", device.stderr)

    def test_a_file_of_somebody_else_is_refused_and_stays_as_it_is(self):
        pathlib.Path(self.store).write_text("my thesis\n")
        result = run("device", "battery", "sim", "--store", self.store, "--for", "1s")
        self.assert_refused(result, FAILED, "device.store", "left as it is")
        self.assertEqual(pathlib.Path(self.store).read_text(), "my thesis\n")

    def test_bad_arguments_are_refused(self):
        missing = str(self.folder / "missing" / "device.store")
        self.assert_refused(run("device", "battery", "sim", "--store", missing, "--for", "1s"), FAILED,
                            "No such file or directory")
        self.assert_refused(run("device", "battery", "charger", "sim", "--store", self.store), USAGE,
                            "one --store for each")
        self.assert_refused(run("device", "bootloader", "sim"), USAGE, "--store")
        self.assert_refused(run("program", BUS, "20", missing), FAILED, "cannot be read")
        empty = self.folder / "empty"
        empty.write_bytes(b"")
        self.assert_refused(run("program", BUS, "20", str(empty)), FAILED, "empty")
        self.assert_refused(run("program", BUS, "200", str(empty)), USAGE, "node-ID")
        self.assert_refused(run("program", "sim", "20", self.store), FAILED, "cannot be read")
        self.assert_refused(run("program", BUS, "20", str(empty), "--slot", "0"), USAGE)

    def test_a_program_is_downloaded_and_is_there_after_a_restart(self):
        image = self.folder / "image.bin"
        image.write_bytes(bytes(i * 7 % 256 for i in range(30_000)))
        crc = f"{zlib.crc32(image.read_bytes()):08X}"
        with Device("bootloader", "--store", self.store) as device:
            done = run("program", BUS, "20", str(image), "--timeout", "10000ms", "--no-start", "--json")
            self.assertEqual(self.assert_told(done), [{"event": "programmed", "node": 20, "program": 1, "bytes": 30000, "started": False, "text": "30000 bytes are program 1"}])
            for options in ([], ["--segmented", "--no-start"]):
                done = run("program", BUS, "20", str(image), "--check-crc", "--timeout", "10000ms", *options)
                self.assertIn("30000 bytes are program 1", self.assert_done(done))
        self.assertIn(f"bootloader: program 1 came, 30000 bytes, {crc}h", device.lines)
        self.assertIn("bootloader: program 1 started", device.lines)
        with Device("bootloader", "--store", self.store) as device:
            pass
        self.assertIn(f"bootloader: program 1 is valid, 30000 bytes, {crc}h", device.lines)

    def test_a_program_that_does_not_fit_is_refused_and_there_is_none(self):
        image = self.folder / "image.bin"
        image.write_bytes(bytes(2_000_000))
        with Device("bootloader", "--store", self.store):
            result = run("program", BUS, "20", str(image), "--timeout", "10000ms")
            self.assert_refused(result, FAILED, "node 20", "the download failed")

    def test_a_node_without_program_download_says_so(self):
        image = self.folder / "image.bin"
        image.write_bytes(b"123456789")
        with Device("battery"):
            result = run("program", BUS, "10", str(image), "--timeout", "10000ms")
            self.assert_refused(result, FAILED, "node 10", "could not be stopped")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
