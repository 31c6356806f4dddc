#!/usr/bin/python3
"""A bus behind a socketcand: the protocol's server stands in for it (socketcand_server.py),
python-can's client and the command are two of its clients, and hear each other.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/socketcand_test.py
"""

import pathlib
import select
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path += [str(TESTS), str(TESTS / "cli")]
import own_network
from command import CANVOY, DONE, FAILED, CommandTest, run
from monitor_table_test import Terminal
from socketcand_server import Server

try:
    import can
    from can.interfaces.socketcand import SocketCanDaemonBus
except ImportError as error:
    own_network.skip(f"{error}; scripts/install-packages test installs python3-can")

PATIENCE = 120  # seconds; a lost server is found again within ten


class Socketcand(CommandTest):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.stop)
        self.bus = f"tcp:127.0.0.1:{self.server.port}/can0"
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *arguments):
        program = subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.communicate)
        self.addCleanup(program.terminate)
        return program

    def wait_for_clients(self, count):
        self.wait_until(lambda: len(self.server.clients) >= count, "the command does not come")

    def wait_until(self, holds, complaint):
        give_up = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), give_up, complaint)
            time.sleep(0.01)

    def error_line(self, program):
        self.assertTrue(select.select([program.stderr], [], [], PATIENCE)[0], "no trouble is told")
        return program.stderr.readline()

    def test_a_device_is_asked_over_it(self):
        self.start("device", "battery", self.bus, "--node-id", "10")
        self.wait_for_clients(1)
        self.assertRegex(self.assert_done(run("read", self.bus, "10", "temperature")), r"\A\d\d\.\d+ °C\n\Z")
        self.assertEqual(self.assert_done(run("write", self.bus, "10", "1017", "400ms")),
                         "Producer heartbeat time: 1000 ms -> 400 ms\n")  # fmt: skip
        self.assertEqual(self.assert_done(run("nmt", self.bus, "10", "operational")), "node 10 (0Ah) is operational\n")
        self.assertEqual(self.server.wrong, [])

    def test_python_can_and_the_command_hear_each_other(self):
        peer = SocketCanDaemonBus(channel="can0", host="127.0.0.1", port=self.server.port)
        self.addCleanup(peer.shutdown)
        self.assert_done(run("send", self.bus, "123#1122FF"))
        heard = peer.recv(PATIENCE)
        self.assertEqual((heard.arbitration_id, bytes(heard.data)), (0x123, b"\x11\x22\xff"))
        monitor = self.start("monitor", self.bus, "--count", "1")
        self.wait_for_clients(3)  # python-can, the one that sent, and this
        peer.send(can.Message(arbitration_id=0x70A, is_extended_id=False, data=[5]))
        self.assertIn("70A#05", monitor.communicate(timeout=PATIENCE)[0])
        self.assertEqual(self.server.wrong, [])

    def test_frames_of_all_kinds_are_sent_as_the_protocol_has_them(self):
        self.assert_done(run("send", self.bus, "123#", "1AAAAAAA#01F1", "123#R", "1AAAAAAA#R2", "00000123#42"))
        give_up = time.monotonic() + PATIENCE
        while len(self.server.said) < 5 and time.monotonic() < give_up:
            time.sleep(0.01)
        self.assertEqual(self.server.said, ["< send 123 0 >", "< send 1AAAAAAA 2 01 F1 >", "< sendrtr 123 0 >",
                                            "< sendrtr 1AAAAAAA 2 >", "< send 00000123 1 42 >"])  # fmt: skip

    def test_a_bus_that_is_not_given_is_told_in_one_line(self):
        other = self.bus.replace("can0", "can7")
        self.assert_refused(run("send", other, "123#"), FAILED, other, "could not open bus")

    def test_what_is_no_socketcand_is_told_in_one_line(self):
        listener = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(listener.close)

        def greet():
            client, _ = listener.accept()
            client.sendall(b"220 mail.example.org <ESMTP>\r\n")
            client.recv(1)

        threading.Thread(target=greet, daemon=True).start()
        bus = f"tcp:127.0.0.1:{listener.getsockname()[1]}/can0"
        self.assert_refused(run("send", bus, "123#"), FAILED, bus, "no socketcand")

    def test_a_lost_server_is_found_again(self):
        monitor = self.start("monitor", self.bus, "--filter", "id=7A0", "--count", "1")
        self.wait_for_clients(1)
        self.server.stop()
        again = Server(self.server.port)
        self.addCleanup(again.stop)
        give_up = time.monotonic() + PATIENCE
        while not again.clients:
            self.assertLess(time.monotonic(), give_up, "the command does not come back")
            time.sleep(0.01)
        self.assert_done(run("send", self.bus, "7A0#01"))
        output, errors = monitor.communicate(timeout=PATIENCE)
        self.assertIn("7A0#01", output)
        self.assertIn("the server has closed the connection", errors)
        self.assertEqual(monitor.returncode, DONE)

    def test_what_listens_says_that_the_server_has_gone(self):
        """Each verb that tells of a bus what it heard, or waits for an answer: what it says, and its exit status."""
        log = self.folder / "long.log"
        log.write_text("".join(f"({second}.000000) can0 705#05\n" for second in range(1000, 2000)))
        closed = "the server has closed the connection"
        for arguments, status, said in (
            (("doctor", self.bus, "--for", "3s"), 4, "the connection to the bus was lost"),
            (("stats", self.bus, "--for", "3s"), FAILED, "the bus was lost meanwhile"),
            (("load", self.bus, "--for", "3s", "--bit-rate", "125"), FAILED, "the bus was lost"),
            (("replay", str(log), self.bus), FAILED, closed),
            (("read", self.bus, "10", "1000", "--watch"), FAILED, closed),
            (("monitor", self.bus, "--for", "3s"), DONE, closed),
            (("monitor", self.bus, "--for", "3s", "--table"), DONE, closed),
            (("record", self.bus, "--for", "3s", "--output", str(self.folder / "a.log")), DONE, closed),
            (("report", self.bus, "--for", "3s", "--output", str(self.folder / "a.html")), DONE, closed),
        ):
            with self.subTest(arguments=arguments[0]):
                server = Server()
                bus = f"tcp:127.0.0.1:{server.port}/can0"
                device = self.start("device", "battery", bus, "--node-id", "10")
                self.wait_until(lambda: server.clients, "the device does not come")
                program = self.start(*(bus if word == self.bus else word for word in arguments))
                self.wait_until(lambda: len(server.clients) > 1 and len(server.said) > 1, "the command does not come")
                server.stop()
                output, errors = program.communicate(timeout=PATIENCE)
                device.terminate()
                self.assertIn(said, output + errors)
                self.assertEqual(program.returncode, status, output + errors)

    def test_browse_says_that_the_server_has_gone_and_that_a_write_failed(self):
        if shutil.which("tmux") is None:
            self.skipTest("tmux is missing; scripts/install-packages test installs it")
        device = self.start("device", "battery", self.bus, "--node-id", "10")
        self.wait_for_clients(1)
        terminal = Terminal(self.folder, 80, 24, CANVOY, "browse", self.bus, "10", "--timeout", "1s")
        self.addCleanup(terminal.end)
        terminal.wait_for("q quit")
        self.server.stop()
        self.assertTrue(terminal.comes_to(lambda lines: lines[0].startswith("values are ")), terminal.lines())
        terminal.wait_for("the server has closed the connection")
        terminal.press("/")
        terminal.press("-l", "1017")
        terminal.press("Enter")
        terminal.press("Enter")
        terminal.wait_for("now 1000 ms")
        terminal.press("-l", "300ms")
        terminal.press("Enter")
        before = terminal.wait_for("write failed: ")[0]
        self.assertTrue(terminal.comes_to(lambda lines: lines[0] != before), "the age goes on")
        self.assertTrue(any("write failed: " in line for line in terminal.lines()), "it is told until the next key")
        again = Server(self.server.port)
        self.addCleanup(again.stop)
        self.assertTrue(terminal.comes_to(lambda lines: "node 10 (0Ah)" in lines[0] and "old" not in lines[0]), terminal.lines())
        terminal.press("Escape")
        terminal.wait_for("q quit")
        self.assertIn("1000 ms", terminal.lines()[1])
        terminal.press("q")
        self.assertTrue(terminal.is_over(), "q ends it")
        device.terminate()

    def test_browse_ends_where_the_server_goes_while_it_reads(self):
        self.start("device", "battery", self.bus, "--node-id", "10")
        self.wait_for_clients(1)
        browse = self.start("browse", self.bus, "10", "--timeout", "1s")
        self.wait_until(lambda: len(self.server.said) > 20, "the command does not read")
        self.server.stop()
        output, errors = browse.communicate(timeout=PATIENCE)
        self.assertEqual((output, browse.returncode), ("", FAILED))
        self.assertIn("the server has closed the connection", errors)

    def test_a_server_that_says_nothing_is_asked_anew(self):
        monitor = self.start("monitor", self.bus, "--filter", "id=7A0", "--count", "1")
        self.wait_for_clients(1)
        self.server.is_silent = True
        self.server.drop_clients()
        self.wait_until(lambda: self.server.unanswered, "the command does not come back")
        self.server.is_silent = False
        self.wait_for_clients(2)
        self.assert_done(run("send", self.bus, "7A0#01"))
        self.assertIn("7A0#01", monitor.communicate(timeout=PATIENCE)[0])

    def test_a_server_without_power_is_noticed_and_found_again(self):
        monitor = self.start("monitor", self.bus, "--filter", "id=7A0", "--count", "1")
        self.wait_for_clients(1)
        device = self.start("device", "battery", self.bus, "--node-id", "10")  # always has something to say
        self.wait_for_clients(2)
        subprocess.run(["ip", "link", "set", "lo", "down"], check=True)
        try:
            for program in (monitor, device):
                self.assertIn("timed out", self.error_line(program))
        finally:
            own_network.raise_loopback()
        self.wait_for_clients(4)
        self.assert_done(run("send", self.bus, "7A0#01"))
        self.assertIn("7A0#01", monitor.communicate(timeout=PATIENCE)[0])


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
