#!/usr/bin/env python3
"""`canvoy gateway` from outside: a client over TCP, commands from a pipe and from a file, and how it ends."""

import pathlib
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, CommandTest

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.2:43113"
PATIENCE = 30  # seconds


class Client:
    """A program that speaks the protocol: a socket and lines."""

    def __init__(self, address):
        host, _, port = address.rpartition(":")
        self.socket = socket.create_connection((host, int(port)), timeout=PATIENCE)
        self.lines = self.socket.makefile("r", newline="\r\n")
        # From its first answer on it hears all events.
        self.ask(0, "info version")

    def close(self):
        self.lines.close()
        self.socket.close()

    def say(self, line):
        self.socket.sendall(line.encode("ascii") + b"\r\n")

    def hear(self, wanted):
        """The next line that is no event, or begins with what is wanted."""
        while True:
            line = self.lines.readline()
            assert line.endswith("\r\n"), f"no {wanted}"
            if line.startswith(wanted):
                return line.rstrip("\r\n")

    def ask(self, sequence, command):
        self.say(f"[{sequence}] {command}")
        return self.hear(f"[{sequence}] ").partition(" ")[2]


class Gateway(CommandTest):
    """A battery and a charger, and the gateway to them."""

    @classmethod
    def setUpClass(cls):
        cls.devices = subprocess.Popen(
            [CANVOY, "device", "charger", "battery", BUS], stdout=subprocess.PIPE, text=True
        )
        cls.devices.stdout.readline()
        cls.gateway = subprocess.Popen(
            [CANVOY, "gateway", BUS, "--node-id", "9", "--listen", "127.0.0.1:0"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        first = cls.gateway.stdout.readline()
        assert first.startswith("listening at 127.0.0.1:") and first.endswith(f"networks 1 = {BUS}\n"), first
        cls.address = first.split()[2].rstrip(",")

    @classmethod
    def tearDownClass(cls):
        cls.gateway.send_signal(signal.SIGINT)
        cls.gateway.communicate(timeout=PATIENCE)
        cls.devices.terminate()
        cls.devices.communicate(timeout=PATIENCE)
        assert cls.gateway.returncode == DONE, cls.gateway.returncode

    def client(self):
        client = Client(self.address)
        self.addCleanup(client.close)
        return client

    def test_objects_are_read_and_written(self):
        client = self.client()
        self.assertEqual(client.ask(1, "set node 10"), "OK")
        self.assertEqual(client.ask(2, "r 0x1000 0 u32"), "418")
        self.assertEqual(client.ask(3, "r 0x1008 0 vs"), '"Canvoy CiA 418 battery"')
        self.assertEqual(client.ask(4, "w 0x1017 0 u16 250"), "OK")
        self.assertEqual(client.ask(5, "r 0x1017 0 u16"), "250")
        self.assertEqual(client.ask(6, "r 0x5FFF 0 u8"), "ERROR:0x06020000")
        self.assertEqual(client.ask(7, "w 0x1018 1 u32 1"), "ERROR:0x06010002")

    def test_long_values_go_in_blocks(self):
        client = self.client()
        self.assertEqual(client.ask(1, "set sdo_block 1"), "OK")
        self.assertEqual(client.ask(2, "10 r 0x1008 0 vs"), '"Canvoy CiA 418 battery"')
        self.assertEqual(client.ask(3, "set sdo_block 0"), "OK")

    def test_a_node_that_is_reset_boots(self):
        clients = [self.client(), self.client()]
        self.assertEqual(clients[0].ask(1, "10 reset comm"), "OK")
        for client in clients:
            self.assertEqual(client.hear("1 10 BOOT_UP"), "1 10 BOOT_UP")
        self.assertEqual(clients[1].ask(1, "10 start"), "OK")

    def test_process_data_of_a_node_is_told(self):
        client = self.client()
        self.assertEqual(client.ask(1, "set rpdo 1 0x18A event 2 u8 i16"), "OK")
        self.assertRegex(client.hear("1 pdo 1 2 "), r"^1 pdo 1 2 0x[0-9a-f]+ 0x[0-9a-f]+$")

    def test_commands_come_from_a_pipe(self):
        result = self.from_stdin(input="[1] 10 r 0x1000 0 u32\n# a comment\n[2] 5 r 0x1000 0 u32")
        self.assertEqual((result.stdout, result.stderr, result.returncode), ("[1] 418\n[2] 419\n", "", DONE))

    def test_commands_come_from_a_file(self):
        with tempfile.TemporaryFile("w+") as script:
            script.write("".join(f"[{number}] 10 r 0x1000 0 u32\r\n" for number in range(1000)))
            script.seek(0)
            result = self.from_stdin(stdin=script)
        self.assertEqual(result.stdout, "".join(f"[{number}] 418\n" for number in range(1000)))
        self.assertEqual((result.stderr, result.returncode), ("", DONE))

    def test_a_pipe_whose_writer_is_gone_costs_no_time_while_answers_are_awaited(self):
        script = "[1] set sdo_timeout 2000\n" + "[2] 77 r 0x1000 0 u32\n" + "[3] 10 r 0x1000 0 u32"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        result = self.from_stdin(input=script)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertEqual(result.stdout, "[1] OK\n[2] ERROR:0x05040000\n[3] 418\n")
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.assertLess(spent, 1, "seconds of the processor, of two that it waits")

    def test_more_commands_than_are_held_come_from_a_pipe_whose_writer_is_gone(self):
        count = 1000
        result = self.from_stdin(input="".join(f"[{number}] 10 r 0x1000 0 u32\n" for number in range(count)))
        self.assertEqual(result.stdout, "".join(f"[{number}] 418\n" for number in range(count)))
        self.assertEqual((result.stderr, result.returncode), ("", DONE))

    def test_a_command_that_fails_is_told_by_the_exit_status(self):
        result = self.from_stdin(input="[1] 10 r 0x5FFF 0 u8\n[2] 10 r 0x1000 0 u32\n")
        self.assertEqual(result.stdout, "[1] ERROR:0x06020000\n[2] 418\n")
        self.assertEqual(result.returncode, FAILED)

    @staticmethod
    def from_stdin(**options):
        return subprocess.run(
            [CANVOY, "gateway", BUS, "--stdin"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            timeout=PATIENCE * 4,
            check=False,
            **options,
        )


class BootingGateway(CommandTest):
    """A gateway with an NMT master beside it, on a bus of its own."""

    BUS = "udp:239.74.163.3:43114"
    PLAN = """
        [master]
        boot-time = "1s"
        [[slave]]
        node = 10
        [[slave]]
        node = 11
        """

    def test_it_tells_how_the_boot_up_of_each_slave_ended(self):
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as plan:
            plan.write(self.PLAN)
            plan.flush()
            devices = subprocess.Popen(
                [CANVOY, "device", "battery", self.BUS], stdout=subprocess.PIPE, text=True
            )
            gateway = subprocess.Popen(
                [CANVOY, "gateway", self.BUS, "--listen", "127.0.0.1:0", "--boot", plan.name],
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
            )
            try:
                devices.stdout.readline()
                client = Client(gateway.stdout.readline().split()[2].rstrip(","))
                self.assertEqual(client.hear("1 11 USER"), "1 11 USER BOOT B")
                self.assertEqual(client.ask(1, "10 reset node"), "OK")
                self.assertEqual(client.hear("1 10 USER"), "1 10 USER BOOT OPER")
                client.close()
            finally:
                for process in (gateway, devices):
                    process.terminate()
                    process.communicate()


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
