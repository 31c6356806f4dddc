#!/usr/bin/env python3
"""What verbs that listen must not pass over: a bus that is lost, a node that falls silent, frames that were lost before they
were read, a log that ends in the middle, values that are old. Each is taken away in turn, and what is printed is read."""

import contextlib
import json
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from command import CANVOY, CommandTest, run
from monitor_table_test import Terminal

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.44:43144"
PATIENCE = 60  # seconds


class Server:
    """A socketcand with one bus, by hand, that can be taken away and given back at the same port."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.clients = []
        self.thread = threading.Thread(target=self.serve, args=(self.listener,), daemon=True)
        self.thread.start()

    def serve(self, listener):
        with contextlib.suppress(OSError):
            while True:
                client = listener.accept()[0]
                client.sendall(b"< hi >")
                for _ in ("open", "rawmode"):
                    client.recv(1000)
                    client.sendall(b"< ok >")
                self.clients.append(client)

    def take_away(self):
        # Closing alone does not end an accept() of another thread.
        with contextlib.suppress(OSError):
            self.listener.shutdown(socket.SHUT_RDWR)
        self.listener.close()
        for client in self.clients:
            client.close()
        self.clients.clear()

    def give_back(self):
        self.listener = socket.create_server(("127.0.0.1", self.port))
        threading.Thread(target=self.serve, args=(self.listener,), daemon=True).start()


class Listening(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def begin(self, *words):
        """The verb, with what it says on standard error in a file."""
        errors = self.folder / f"errors-{len(list(self.folder.iterdir()))}"
        with errors.open("w", encoding="utf-8") as stderr:
            program = subprocess.Popen([CANVOY, *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=stderr, text=True)
        lines = []
        # What is printed is taken: the program would wait for the pipe else, and lose frames by that.
        reader = threading.Thread(target=lambda: lines.extend(program.stdout), daemon=True)
        reader.start()

        def end():
            program.send_signal(signal.SIGINT)
            program.wait(PATIENCE)
            reader.join(PATIENCE)
            program.stdout.close()
            return "".join(lines)

        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        return program, errors, lines, end

    def wait_until(self, holds, what):
        give_up = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), give_up, what)
            time.sleep(0.02)

    def wait_for(self, path, wanted):
        self.wait_until(lambda: path.exists() and wanted in path.read_text(encoding="utf-8"), f"{wanted!r} is not in {path}")

    def battery(self):
        device = subprocess.Popen([CANVOY, "device", "battery", BUS, "--heartbeat", "100ms"], stdout=subprocess.DEVNULL)
        self.addCleanup(device.wait)
        self.addCleanup(device.kill)
        self.assert_done(run("wait", BUS, "heartbeat and node=10", "--timeout", "30s"))
        return device


class News(Listening):
    def listeners(self, bus):
        """Each verb that listens, as words and whether it names the number of lost frames at its end."""
        yield "monitor", ("monitor", bus, "--no-sheets")
        yield "monitor --json", ("monitor", bus, "--no-sheets", "--json")
        yield "record", ("record", bus, str(self.folder / "heard.log"))

    def test_a_lost_server_is_told_and_its_return(self):
        for name, words in self.listeners("tcp:127.0.0.1:{}/can0"):
            with self.subTest(name):
                server = Server()
                _, errors, _, end = self.begin(*[word.format(server.port) for word in words])
                self.wait_until(lambda: server.clients, "nobody connects")
                server.take_away()
                self.wait_for(errors, "the server has closed the connection")
                self.wait_for(errors, "is bus-off")
                server.give_back()
                self.wait_for(errors, "is back")
                end()
                server.take_away()

    def test_a_silent_node_is_told_and_its_return(self):
        for name, words in self.listeners(BUS):
            with self.subTest(name):
                device = self.battery()
                _, errors, lines, end = self.begin(*words)
                heard = self.folder / "heard.log"
                beats = lambda: heard.read_text(encoding="ascii").count("70A#") if name == "record" else sum("70A#" in line for line in lines)
                self.wait_until(lambda: (name != "record" or heard.exists()) and beats() > 2, "no heartbeat is heard")
                device.kill()
                device.wait()
                self.wait_for(errors, "node 10 (0Ah): no heartbeat any more")
                device = self.battery()
                self.wait_for(errors, "node 10 (0Ah): its heartbeat is back")
                end()
                device.kill()
                device.wait()

    def flood(self, program, errors):
        """More frames than the kernel keeps, while the program does not read."""
        program.send_signal(signal.SIGSTOP)
        log = self.folder / "many.log"
        log.write_text("".join(f"(1700000000.{number:06}) can0 18A#{number % 256:02X}0001\n" for number in range(40_000)))
        self.assert_done(run("replay", str(log), BUS, "--speed", "0"))
        program.send_signal(signal.SIGCONT)
        # The kernel tells what it dropped with the next frame that it keeps: as soon as there is room again.
        self.wait_until(lambda: run("send", BUS, "123#").returncode == 0 and "lost before they were read" in errors.read_text(encoding="utf-8"), "nothing is told")
        self.wait_for(errors, "lost before they were read")

    def test_frames_lost_in_the_carrier_are_told(self):
        for name, words in self.listeners(BUS):
            with self.subTest(name):
                program, errors, lines, end = self.begin(*words)
                if name == "record":
                    self.wait_until((self.folder / "heard.log").exists, "it does not listen")
                else:
                    device = self.battery()
                    self.wait_until(lambda: lines, "it does not listen")
                    device.kill()
                self.flood(program, errors)
                told = end()
                if name == "record":
                    self.assertRegex(told, r"^\d+ frames in .*heard.log; \d+ more were lost before they were read\n$")

    def test_frames_lost_between_a_network_and_a_real_bus_are_told(self):
        network = self.folder / "net.toml"
        network.write_text(f'network = "charger"\n[bus]\nreal = "{BUS}"\n[battery]\nplayed = false\n')
        program, errors, lines, end = self.begin("run", str(network), "--for", "1h", "--json")
        self.wait_until(lambda: lines, "it does not run")
        self.flood(program, errors)
        told = [json.loads(line) for line in end().splitlines()]
        self.assertGreater(told[-1]["frames_lost"], 0)

    def test_a_record_says_how_many_frames_it_lacks(self):
        _, _, _, end = self.begin("record", BUS, str(self.folder / "a.log"), "--json")
        self.wait_until((self.folder / "a.log").exists, "it does not listen")
        told = json.loads(end())
        self.assertEqual((told["frames"], told["frames_lost"]), (0, 0))

    def test_a_log_that_ends_in_the_middle_is_told(self):
        whole = self.folder / "whole.log"
        self.assert_done(run("run", "charger", "--for", "60s", "--log", str(whole)))
        for ending in ("log.gz", "blf", "mf4"):
            packed = self.folder / f"whole.{ending}"
            self.assert_done(run("convert-log", str(whole), str(packed)))
            cut = self.folder / f"cut.{ending}"
            cut.write_bytes(packed.read_bytes()[:packed.stat().st_size // 2])
            for words in (("monitor", str(cut)), ("monitor", str(cut), "--table"), ("stats", str(cut)), ("decode", str(cut))):
                with self.subTest(words=words):
                    told = run(*words)
                    self.assertIn(cut.name, told.stderr)
                    self.assertRegex(told.stderr, "end|cut|incomplete|could not be read|not whole|damaged")


class NewsOnATerminal(Listening):
    """The same on the screens of monitor --table and browse, which have no room for lines in between."""

    def setUp(self):
        super().setUp()
        self.device = self.battery()

    def terminal(self, *words):
        screen = Terminal(self.folder, 110, 24, CANVOY, *words)
        self.addCleanup(screen.end)
        return screen

    def test_the_table_says_what_is_wrong_and_old_values_fade(self):
        screen = self.terminal("monitor", BUS, "--table", "--no-sheets")
        screen.wait_for("operational")
        self.device.kill()
        self.device.wait()
        screen.wait_for("node 10 (0Ah) is silent for ")
        faint = lambda: [line for line in screen.call("capture-pane", "-p", "-e").splitlines() if "\x1b[2m" in line]
        self.wait_until(faint, "nothing is faint")
        self.battery()
        self.assertTrue(screen.comes_to(lambda lines: not any("is silent" in line for line in lines)))

    def test_browse_says_that_its_values_are_old(self):
        screen = self.terminal("browse", BUS, "10")
        screen.wait_for("q quit")  # all is read
        self.device.kill()
        self.device.wait()
        screen.wait_for("s old, the node does not answer")
        self.battery()
        self.assertTrue(screen.comes_to(lambda lines: not any("does not answer" in line for line in lines)))



if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
