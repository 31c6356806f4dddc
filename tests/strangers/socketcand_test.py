#!/usr/bin/python3
"""A bus behind a socketcand: the protocol's server stands in for it as doc/protocol.md and state_raw.c of socketcand have it,
python-can's client and the command are two of its clients, and hear each other.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/socketcand_test.py
"""

import pathlib
import re
import select
import socket
import subprocess
import sys
import threading
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent
sys.path += [str(TESTS), str(TESTS / "cli")]
import own_network
from command import CANVOY, DONE, FAILED, CommandTest, run

try:
    import can
    from can.interfaces.socketcand import SocketCanDaemonBus
except ImportError as error:
    own_network.skip(f"{error}; scripts/install-packages test installs python3-can")

PATIENCE = 120  # seconds; a lost server is found again within ten
# As socketcand's sscanf reads it: a number in hexadecimal, a length, as many bytes.
SEND = re.compile(r"< send ([0-9a-fA-F]+) (\d)((?: [0-9a-fA-F]{1,2})*) >")
REMOTE = re.compile(r"< sendrtr ([0-9a-fA-F]+) (\d) >")


class Server:
    """One bus, can0. What a client sends, the others hear; it does not come back, as a raw socket's own frames do not."""

    def __init__(self, port=0):
        self.listener = socket.create_server(("127.0.0.1", port))
        self.port = self.listener.getsockname()[1]
        self.clients = []
        self.is_silent = False
        self.unanswered = []  # clients who came while it was silent
        self.said = []  # by all clients in raw mode
        self.wrong = []
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            try:
                client, _ = self.listener.accept()
            except OSError:
                return
            threading.Thread(target=self.serve, args=(client,), daemon=True).start()

    @staticmethod
    def messages(client):
        rest = ""
        while True:
            try:
                data = client.recv(1024)
            except OSError:
                return
            if not data:
                return
            rest += data.decode("ascii")
            while ">" in rest:
                message, rest = rest.split(">", 1)
                yield message + ">"

    def serve(self, client):
        if self.is_silent:
            self.unanswered.append(client)
            return
        client.sendall(b"< hi >")
        for message in self.messages(client):
            if message == "< open can0 >" or message == "< rawmode >":
                client.sendall(b"< ok >")
                if message == "< rawmode >":
                    self.clients.append(client)
            elif message.startswith("< open "):
                client.sendall(b"< error could not open bus >")
                client.close()
                return
            else:
                self.said.append(message)
                self.pass_on(client, message)

    def pass_on(self, sender, message):
        now = f"{time.time():.6f}"
        sent, remote = SEND.fullmatch(message), REMOTE.fullmatch(message)
        if sent and len(sent[3].split()) == int(sent[2]):
            data = "".join(f"{int(byte, 16):02X}" for byte in sent[3].split())
            answer = f"< frame {self.identifier(sent[1])} {now} {data} >"
        elif remote:
            answer = f"< rtr {self.identifier(remote[1])} {now} {remote[2]} >"
        else:
            self.wrong.append(message)
            return
        for client in self.clients:
            if client is not sender:
                try:
                    client.sendall(answer.encode("ascii"))
                except OSError:
                    pass

    @staticmethod
    def identifier(digits):
        """Eight digits are a 29-bit identifier."""
        return f"{int(digits, 16):0{8 if len(digits) == 8 else 3}X}"

    def stop(self):
        if self.listener.fileno() < 0:
            return
        # To wake who waits in accept().
        self.listener.shutdown(socket.SHUT_RDWR)
        self.listener.close()
        self.drop_clients()

    def drop_clients(self):
        for client in self.clients + self.unanswered:
            try:
                client.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            client.close()


class Socketcand(CommandTest):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.stop)
        self.bus = f"tcp:127.0.0.1:{self.server.port}/can0"

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
