#!/usr/bin/env python3
"""The page's server from outside: what it answers, what it refuses, and who is let go. Clients are sockets by hand, so
that they can be as wrong as they like."""

import base64
import contextlib
import hashlib
import http.client
import json
import os
import re
import signal
import socket
import struct
import subprocess
import tempfile
import time
import unittest
import urllib.parse

from command import CANVOY, CommandTest, USAGE, run

PATIENCE = 60  # seconds
TOKEN = "0123456789abcdef0123"


@contextlib.contextmanager
def served(*arguments):
    """The command, and the port at which it serves."""
    environment = {**os.environ, "CANVOY_WEB_TOKEN": TOKEN}
    process = subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
    try:
        url = process.stdout.readline().strip()
        if not url:
            raise AssertionError(process.communicate(timeout=PATIENCE)[1])
        yield process, int(url.split(":")[2].split("/")[0]), url
    finally:
        process.send_signal(signal.SIGTERM)
        try:
            process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise


def get(port, path, method="GET", body=None, token=TOKEN, **headers):
    if token:
        headers["Authorization"] = f"Bearer {token}"
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=PATIENCE)
    connection.request(method, path, body, headers)
    response = connection.getresponse()
    answer = response.status, response.read(), response.headers
    connection.close()
    return answer


def read(port, path):
    """Reads an object: it sends frames, and so is a POST."""
    return post(port, path + "/read", {})


def post(port, path, members):
    status, body, _ = get(port, path, "POST", json.dumps(members), **{"Content-Type": "application/json"})
    return status, json.loads(body)


def raw(port, data, seconds=10):
    """All that is answered to these bytes until the other end closes."""
    with socket.create_connection(("127.0.0.1", port), timeout=seconds) as sock:
        sock.sendall(data)
        sock.shutdown(socket.SHUT_WR)
        answer = b""
        with contextlib.suppress(ConnectionError, TimeoutError):
            while chunk := sock.recv(65536):
                answer += chunk
        return answer


class WebSocket:
    """RFC 6455, as far as a test takes it."""

    def __init__(self, port, host=None, origin=None, buffer=None, target="/live"):
        self.sock = socket.socket()
        if buffer:
            self.sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer)
        self.sock.settimeout(PATIENCE)
        self.sock.connect(("127.0.0.1", port))
        key = base64.b64encode(os.urandom(16))
        head = f"GET {target} HTTP/1.1\r\nHost: {host or f'127.0.0.1:{port}'}\r\nAuthorization: Bearer {TOKEN}\r\n"
        head += f"Origin: {origin}\r\n" if origin else ""
        head += "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
        self.sock.sendall(head.encode() + b"Sec-WebSocket-Key: " + key + b"\r\n\r\n")
        self.head = b""
        while b"\r\n\r\n" not in self.head:
            chunk = self.sock.recv(1)
            if not chunk:
                break
            self.head += chunk
        self.is_open = self.head.startswith(b"HTTP/1.1 101 ")
        accept = base64.b64encode(hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest())
        if self.is_open and accept not in self.head:
            raise AssertionError("the handshake is wrong")

    def say(self, text, opcode=1, first=0x80):
        data = text if isinstance(text, bytes) else text.encode()
        size = bytes([0x80 | len(data)]) if len(data) < 126 else (
            bytes([0xFE]) + struct.pack(">H", len(data)) if len(data) < 65536 else bytes([0xFF]) + struct.pack(">Q", len(data)))
        mask = b"\x11\x22\x33\x44"
        self.sock.sendall(bytes([first | opcode]) + size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))

    def take(self, size):
        data = b""
        while len(data) < size:
            chunk = self.sock.recv(size - len(data))
            if not chunk:
                raise ConnectionError
            data += chunk
        return data

    def hear(self):
        """The next message as JSON."""
        return json.loads(self.hear_text())

    def hear_text(self):
        """The bytes of the next message; it may come in several frames (5.4)."""
        text = b""
        while True:
            opcode, size = self.take(2)
            if size == 126:
                (size,) = struct.unpack(">H", self.take(2))
            elif size == 127:
                (size,) = struct.unpack(">Q", self.take(8))
            data = self.take(size)
            if opcode & 15 == 8:
                raise ConnectionError("closed")
            if opcode & 15 <= 1:
                text += data
                if opcode & 0x80:
                    return text

    def hear_answer(self, number):
        for _ in range(1000):
            for answer in self.hear().get("answers", []):
                if answer["id"] == number:
                    return answer
        raise AssertionError("no answer")

    def is_let_go(self):
        with contextlib.suppress(ConnectionError):
            for _ in range(1000):
                self.hear()
            return False
        return True


class WebTest(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.stack = contextlib.ExitStack()
        cls.process, cls.port, cls.url = cls.stack.enter_context(
            served("run", "lift", "--floors", "5", "--percent", "0", "--web", "--speed", "20"))

    @classmethod
    def tearDownClass(cls):
        cls.stack.close()

    def test_the_page_is_served_with_what_protects_it(self):
        status, body, headers = get(self.port, "/")
        self.assertEqual(status, 200)
        self.assertIn(b"<title>Canvoy</title>", body)
        self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        self.assertIsNone(headers.get("Access-Control-Allow-Origin"))
        for path, kind in (("/page.js", "text/javascript"), ("/page.css", "text/css"), ("/openapi.json", "application/json")):
            status, body, headers = get(self.port, path)
            self.assertEqual((status, headers["Content-Type"].split(";")[0]), (200, kind))
            self.assertGreater(len(body), 100)
        self.assertEqual(get(self.port, "/nothing")[0], 404)

    def test_head_has_no_body(self):
        answer = raw(self.port, f"HEAD /?token={TOKEN} HTTP/1.1\r\nHost: localhost:{self.port}\r\nConnection: close\r\n\r\n".encode())
        head, _, body = answer.partition(b"\r\n\r\n")
        self.assertTrue(head.startswith(b"HTTP/1.1 200 "))
        self.assertEqual(body, b"")

    def test_other_sites_are_refused(self):
        self.assertEqual(get(self.port, "/", Host=f"evil.example:{self.port}")[0], 403)
        self.assertEqual(get(self.port, "/api/state", Origin="http://evil.example")[0], 403)
        self.assertFalse(WebSocket(self.port, origin="http://evil.example").is_open)
        self.assertFalse(WebSocket(self.port, host=f"evil.example:{self.port}").is_open)
        own = WebSocket(self.port, origin=f"http://127.0.0.1:{self.port}")
        self.assertTrue(own.is_open)

    def test_a_form_of_another_site_cannot_post(self):
        status, _, _ = get(self.port, "/api/run/pause", "POST", '{"paused":true}', **{"Content-Type": "text/plain"})
        self.assertEqual(status, 415)
        self.assertFalse(json.loads(get(self.port, "/api/state")[1])["play"]["paused"])

    def test_what_is_no_request_is_answered_so_or_closed(self):
        host = f"Host: localhost:{self.port}\r\nAuthorization: Bearer {TOKEN}\r\n".encode()
        for data, status in (
            (b"\x00\x01\x02\r\n\r\n", b"400"),
            (b"GET / HTTP/9.9\r\n\r\n", b"400"),
            (b"GET /../etc/passwd HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET /%zz HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET / HTTP/1.1\r\n\r\n", b"400"),
            (b"GET / HTTP/1.1\r\n" + host + host + b"\r\n", b"400"),
            (b"GET / HTTP/1.0\r\n\r\n", b"403"),
            (b"GET / HTTP/1.1\r\n" + host.partition(b"Auth")[0] + b"\r\n", b"403"),
            (b"GET http://evil.example/ HTTP/1.1\r\n" + host + b"\r\n", b"403"),
            (f"GET http://localhost:{self.port}/ HTTP/1.1\r\n".encode() + host + b"\r\n", b"200"),
            (b"GET /api/events?since=abc HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET /api/events?since=-1 HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET /api/networks/lift1/nodes/1.0/objects HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET /api/networks/lift1/nodes/128/objects HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET /api/events?until=1 HTTP/1.1\r\n" + host + b"\r\n", b"400"),
            (b"GET /api/nothing HTTP/1.1\r\n" + host + b"\r\n", b"404"),
            (b"GET /api/state/ HTTP/1.1\r\n" + host + b"\r\n", b"404"),
            (b"GET /api/networks/no/nodes/1/objects HTTP/1.1\r\n" + host + b"\r\n", b"404"),
            (b"DELETE /api/state HTTP/1.1\r\n" + host + b"\r\n", b"405"),
            (b"GET /" + b"a" * 5000 + b" HTTP/1.1\r\n" + host + b"\r\n", b"414"),
            (b"GET / HTTP/1.1\r\n" + b"A: " + b"a" * 20000 + b"\r\n\r\n", b"431"),
            (b"POST /api/run/pause HTTP/1.1\r\n" + host + b"Content-Length: 999999999\r\n\r\n", b"413"),
        ):
            answer = raw(self.port, data)
            self.assertEqual(answer.split(b" ")[1:2], [status], data[:60])
            if status not in (b"200", b"403") and b"/api" in data:
                self.assertIn("error", json.loads(answer.partition(b"\r\n\r\n")[2]), data[:60])
        self.assertEqual(get(self.port, "/")[0], 200)

    def test_a_state_is_whole_and_then_changes(self):
        client = WebSocket(self.port)
        first = client.hear()
        self.assertEqual(first["hello"]["kind"], "lift")
        self.assertEqual(len(first["state"]["snapshot"]["lifts"]), 1)
        second = client.hear()
        self.assertNotIn("state", second)
        self.assertGreater(second["change"]["time"], first["state"]["time"])

    def test_values_come_to_whom_wants_them(self):
        every = WebSocket(self.port).hear()
        self.assertTrue(every["values"], "there is something to leave out")
        client = WebSocket(self.port, target="/live?values=off")
        self.assertNotIn("values", client.hear())
        client.say('{"id":1,"do":"values","on":true}')
        heard = {}
        while "answers" not in heard:
            heard = client.hear()
        told = heard.get("values") or client.hear()["values"]
        self.assertLessEqual(set(every["values"]), set(told), "also those of before")
        client.say('{"id":2,"do":"values","on":false}')
        while not any(each["id"] == 2 for each in client.hear().get("answers", [])):
            continue
        for _ in range(10):
            self.assertNotIn("values", client.hear())

    def test_bad_json_is_answered_or_passed_over(self):
        client = WebSocket(self.port)
        for text in ("", "{", "[]", "null", '"x"', "[" * 30000, '{"id":1', '{"do":1}', '{"id":{},"do":"nothing"}'):
            client.say(text)
        for number, request in enumerate((
            {"do": "nothing"}, {}, {"do": 5}, {"do": "speed"}, {"do": "speed", "speed": "x"}, {"do": "pause", "paused": 7},
            {"do": "seek", "time": -1}, {"do": "seek", "time": 1e300}, {"do": "step", "step_s": "1"}, {"do": "restart", "seed": 0.5},
            {"do": "restart", "faults": [1]}, {"do": "restart", "faults": ["no-such@1s"]}, {"do": "fault", "fault": "x", "duration_s": 1},
            {"do": "visit", "from": 1, "to": 999}, {"do": "visit", "from": 2, "to": 2}, {"do": "frames", "filter": "node="}, {"do": "frames", "filter": 5},
            {"do": "read", "bus": "lift1", "node": 500, "object": "1000"}, {"do": "read", "bus": "no", "node": 1, "object": "1000"},
            {"do": "read", "bus": "lift1", "node": 1, "object": "no such thing"}, {"do": "nmt", "bus": "lift1", "node": 1, "command": "start"},
        ), start=100):
            client.say(json.dumps({"id": number, **request}))
            self.assertRegex(client.hear_answer(number).get("error", ""), r"\A[^\n]+\Z", request)
        self.assertEqual(get(self.port, "/")[0], 200)

    def test_garbage_in_a_websocket_ends_it(self):
        for say in (
            lambda c: c.sock.sendall(b"\xff" * 100),
            lambda c: c.say("x" * 100_000),
            lambda c: c.say(b"\xff\xfe", opcode=1),
            lambda c: c.say(b"{}", opcode=2),
            lambda c: c.sock.sendall(b"\x81\x02{}"),
            lambda c: [c.say('{"do":"x"}') for _ in range(150)],
        ):
            client = WebSocket(self.port)
            with contextlib.suppress(ConnectionError):
                say(client)
            self.assertTrue(client.is_let_go())
        self.assertEqual(get(self.port, "/")[0], 200)

    def test_there_are_so_many_clients_and_no_more(self):
        with contextlib.ExitStack() as stack:
            lookers = []
            for _ in range(20):
                looker = WebSocket(self.port)
                stack.callback(looker.sock.close)
                lookers.append(looker)
            # Those that have said nothing for longest have given way.
            self.assertTrue(lookers[-1].is_open)
            self.assertTrue(lookers[0].is_let_go())
            idle = [stack.enter_context(socket.create_connection(("127.0.0.1", self.port))) for _ in range(100)]
            self.assertEqual(len(idle), 100)
            self.assertEqual(get(self.port, "/api/state")[0], 200)
        until = time.monotonic() + PATIENCE
        while not WebSocket(self.port).is_open:
            self.assertLess(time.monotonic(), until, "who is gone leaves his place")

    def test_who_reads_nothing_costs_little_and_slows_nobody(self):
        def memory():
            with open(f"/proc/{self.process.pid}/status", encoding="ascii") as status:
                return next(int(line.split()[1]) for line in status if line.startswith("VmRSS"))

        client = WebSocket(self.port, buffer=4096)
        client.say('{"id":1,"do":"frames","on":true,"filter":""}')
        time.sleep(0.5)
        before = memory()
        looker = WebSocket(self.port)
        begun = looker.hear()["state"]["time"]
        # Three seconds of the clock, at 20 times its speed.
        end = time.monotonic() + PATIENCE
        now = begun
        while now - begun < 60:
            now = looker.hear().get("change", {}).get("time", now)
            self.assertLess(time.monotonic(), end, "the run stands still")
        self.assertLess(memory() - before, 8192, "KiB, frames that are kept for all among them")
        client.sock.close()

    def test_who_is_gone_without_a_word_is_asked_for(self):
        client = WebSocket(self.port)
        own = client.sock.getsockname()[1]
        with open("/proc/net/tcp", encoding="ascii") as lines:
            timers = [line.split()[5] for line in lines if f":{self.port:04X} " in line.split()[1] + " " and line.split()[2].endswith(f":{own:04X}")]
        # The timer of the server's end: 02 is keep-alive, 01 that something is on the way.
        self.assertIn(timers[0][:2], ("01", "02"))

    def test_no_path_leads_out_of_the_page(self):
        host = f"Host: localhost:{self.port}\r\nAuthorization: Bearer {TOKEN}\r\n\r\n".encode()
        for path in (b"/../../etc/passwd", b"/%2e%2e/%2e%2e/etc/passwd", b"//etc/passwd", b"/page.js/../../etc/passwd", b"/api/../page.js",
                     b"/..%2f..%2fetc%2fpasswd", b"/page.js%00.html", b"file:///etc/passwd", b"*", b"/" + b"a" * 5000):  # fmt: skip
            answer = raw(self.port, b"GET " + path + b" HTTP/1.1\r\n" + host)
            self.assertRegex(answer[:12], rb"HTTP/1.1 4\d\d", path)
            self.assertNotIn(b"root:", answer)

    def test_to_record_takes_leave(self):
        status, answer = post(self.port, "/api/run/record", {"on": True})
        self.assertEqual(status, 403)
        self.assertIn("--allow-record", answer["error"])

    def test_nothing_is_written_without_leave(self):
        status, answer = post(self.port, "/api/networks/lift1/nodes/2/objects/1017", {"value": "500"})
        self.assertEqual(status, 403)
        self.assertIn("--allow-write 2:1017", answer["error"])
        status, answer = post(self.port, "/api/networks/lift1/nodes/2/nmt", {"command": "stop"})
        self.assertEqual(status, 403)

    def test_objects_are_read_by_name(self):
        status, answer = read(self.port, "/api/networks/lift1/nodes/2/objects/1017")
        self.assertEqual((status, answer["index"], answer["unit"]), (200, "1017", "ms"))
        status, answer = read(self.port, "/api/networks/lift1/nodes/99/objects/1000")
        self.assertEqual(status, 502)
        self.assertIn("node 99", answer["error"])

    def test_nothing_that_a_get_asks_for_sends_a_frame(self):
        post(self.port, "/api/run/pause", {"paused": True})
        description = json.loads(get(self.port, "/openapi.json")[1])
        values = {"bus": "lift1", "node": "2", "object": "1018:4"}
        before = get(self.port, "/api/frames.log")[1]
        for path in [*description["paths"], "/api/networks/{bus}/nodes/{node}/objects/{object}"]:
            get(self.port, re.sub(r"{(\w+)}", lambda found: values[found[1]], path))
        self.assertEqual(get(self.port, "/api/networks/lift1/nodes/2/objects/1018:4")[0], 405)
        self.assertEqual(get(self.port, "/api/frames.log")[1], before)
        post(self.port, "/api/run/pause", {"paused": False})

    def test_numbers_that_make_no_sense_are_refused(self):
        for what, members in (("speed", {"speed": -1}), ("seek", {"time": -0.5}), ("step", {"step_s": -1})):
            status, answer = post(self.port, f"/api/run/{what}", members)
            self.assertEqual(status, 400, what)
            self.assertIn("a number from 0 to 1000000", answer["error"])

    def test_what_a_path_takes_stands_in_allow(self):
        for method, path, allowed in (("DELETE", "/api/state", "GET, HEAD"), ("GET", "/api/run/pause", "POST"), ("OPTIONS", "/", "GET, HEAD"),
                                      ("POST", "/openapi.json", "GET, HEAD"), ("PUT", "/api/networks/lift1/nodes/2/nmt", "POST")):  # fmt: skip
            status, body, headers = get(self.port, path, method)
            self.assertEqual((status, headers["Allow"]), (405, allowed), path)
            self.assertIn("error", json.loads(body))

    def test_what_cannot_be_now_and_what_makes_no_sense_are_told_apart(self):
        post(self.port, "/api/run/pause", {"paused": True})
        status, answer = read(self.port, "/api/networks/lift1/nodes/2/objects/1017")
        self.assertEqual((status, "stands still" in answer["error"]), (409, True))
        self.assertEqual(read(self.port, "/api/networks/no/nodes/2/objects/1017")[0], 404, "whatever time does")
        post(self.port, "/api/run/pause", {"paused": False})
        self.assertEqual(post(self.port, "/api/run/fault", {"fault": "no-such", "duration_s": 1})[0], 422)
        self.assertEqual(read(self.port, "/api/networks/lift1/nodes/2/objects/no-such")[0], 404)
        self.assertEqual(read(self.port, "/api/networks/no/nodes/2/objects/1017")[0], 404)

    def test_a_token_by_chance_is_in_the_address_and_none_that_is_short(self):
        environment = {**os.environ, "CANVOY_WEB_TOKEN": "short"}
        told = subprocess.run([CANVOY, "run", "charger", "--web"], capture_output=True, text=True, env=environment, check=False)
        self.assertEqual((told.returncode, told.stderr.count("\n")), (USAGE, 1))
        self.assertIn(f"/?token={TOKEN}", self.url)
        self.assertEqual(get(self.port, "/api/state", token="0" * 20)[0], 403)


class RecordTest(CommandTest):
    def test_a_log_is_written_where_it_is_allowed_and_nothing_is_written_over(self):
        with tempfile.TemporaryDirectory() as folder:
            first = os.path.join(folder, "canvoy-1.log")
            with open(first, "w", encoding="ascii") as out:
                out.write("of yesterday")
            with served("run", "charger", "--web", "--speed", "20", "--allow-record", folder) as (_, port, _):
                self.assertEqual(post(port, "/api/run/record", {"on": True})[0], 200)
                self.assertEqual(post(port, "/api/run/record", {"on": True})[0], 409)
                end = time.monotonic() + PATIENCE
                while json.loads(get(port, "/api/state")[1])["record"]["frames"] < 100 and time.monotonic() < end:
                    time.sleep(0.05)
                self.assertEqual(post(port, "/api/run/record", {"on": False})[0], 200)
                told = json.loads(get(port, "/api/state")[1])["record"]
                kept = get(port, "/api/frames.log")[1].decode()
            self.assertEqual((told["on"], told["file"]), (False, os.path.join(folder, "canvoy-2.log")))
            with open(first, encoding="ascii") as log:
                self.assertEqual(log.read(), "of yesterday")
            with open(told["file"], encoding="ascii") as log:
                lines = log.read()
            self.assertEqual(lines.count("\n"), told["frames"])
            self.assertIn(lines, kept, "the frames are those of the run")

    def test_a_folder_that_is_none_is_refused(self):
        self.assert_refused(run("run", "charger", "--web", "--allow-record", "/no/such"), USAGE, "--allow-record", "/no/such")
        with tempfile.NamedTemporaryFile(suffix=".log") as log:
            log.write(b"(0000000001.000000) can0 70A#05\n")
            log.flush()
            self.assert_refused(run("view", log.name, "--allow-record", "/tmp"), USAGE, "--allow-record")


class WriteTest(CommandTest):
    def test_what_may_be_written_is_and_the_node_has_the_last_word(self):
        with served("run", "lift", "--floors", "3", "--percent", "0", "--web", "--allow-write", "2:1017,2:1000,nmt") as (_, port, _):
            path = "/api/networks/lift1/nodes/2/"
            self.assertEqual(post(port, path + "objects/1017", {"value": "750"}), (200, {"written": True}))
            self.assertEqual(read(port, path + "objects/1017")[1]["value"], 750)
            status, answer = post(port, path + "objects/1000", {"value": "5"})
            self.assertEqual((status, answer["abort"]), (502, "06010002"))
            status, answer = post(port, path + "objects/1017", {"value": "70000"})
            self.assertEqual(status, 422)
            self.assertIn("out of range", answer["error"])
            status, _ = post(port, "/api/networks/lift1/nodes/4/objects/1017", {"value": "750"})
            self.assertEqual(status, 403)
            self.assertEqual(post(port, path + "nmt", {"command": "stop"})[0], 200)
            end = time.monotonic() + PATIENCE
            while time.monotonic() < end:
                nodes = json.loads(get(port, "/api/nodes")[1])
                if next(each for each in nodes if each["node"] == 2)["state"] == "stopped":
                    return
                time.sleep(0.05)
            self.fail("node 2 was not stopped")


class RunTest(CommandTest):
    def test_a_fault_is_put_into_the_run_which_stays_the_same_before_it(self):
        with served("run", "charger", "--web", "--speed", "100") as (_, port, _):
            end = time.monotonic() + PATIENCE
            while json.loads(get(port, "/api/state")[1])["time"] < 20 and time.monotonic() < end:
                time.sleep(0.05)
            post(port, "/api/run/pause", {"paused": True})
            before = json.loads(get(port, "/api/events")[1])["events"]
            frames = get(port, "/api/frames.log")[1].splitlines()
            self.assertEqual(post(port, "/api/run/fault", {"fault": "heartbeat-loss", "duration_s": 30})[0], 200)
            while json.loads(get(port, "/api/state")[1])["play"]["seeking"] and time.monotonic() < end:
                time.sleep(0.05)
            after = json.loads(get(port, "/api/events")[1])["events"]
            self.assertEqual(after[:len(before)], before)
            self.assertEqual(get(port, "/api/frames.log")[1].splitlines()[:len(frames)], frames)
            self.assertIn("fault-begins", [each["event"] for each in after])
            plan = json.loads(get(port, "/api/state")[1])["plan"]
            self.assertIn("--seed 1 --fault heartbeat-loss@", plan["command"])

    def test_what_cannot_be_is_refused_in_one_line(self):
        self.assert_refused(run("run", "charger", "--web", "--json"), USAGE, "--json")
        self.assert_refused(run("run", "charger", "--web", "70000"), USAGE, "70000")
        self.assert_refused(run("run", "charger", "--web", "--allow-write", "x"), USAGE, "--allow-write")
        self.assert_refused(run("view", "no such bus"), USAGE)
        with tempfile.NamedTemporaryFile(suffix=".log") as empty:
            self.assert_refused(run("view", empty.name), 1, empty.name)


class ActsTest(CommandTest):
    """What people do at the page is part of the run: its command, its file and its link play the same frames."""

    def played(self, folder, *words):
        log = os.path.join(folder, "again.log")
        result = run(*words, "--for", "40s", "--log", log)
        self.assertNotEqual(result.returncode, USAGE, result.stderr)
        with open(log, encoding="ascii") as lines:
            return lines.read().splitlines()

    def test_visits_reads_writes_and_commands_are_played_again(self):
        lift = ("run", "lift", "--lifts", "1", "--floors", "6", "--percent", "0")
        with tempfile.TemporaryDirectory() as folder:
            with served(*lift, "--for", "10min", "--web", "--speed", "20", "--allow-write", "all") as (_, port, _):
                path = "/api/networks/lift1/nodes/2/"
                self.assertEqual(post(port, "/api/run/visit", {"from": 2, "to": 5})[0], 200)
                self.assertEqual(read(port, path + "objects/1018:1")[0], 200)
                self.assertEqual(post(port, path + "objects/1017", {"value": "750"})[0], 200)
                self.assertEqual(post(port, path + "nmt", {"command": "enter pre-operational"})[0], 200)
                end = time.monotonic() + PATIENCE
                while json.loads(get(port, "/api/state")[1])["time"] < 41 and time.monotonic() < end:
                    time.sleep(0.05)
                post(port, "/api/run/pause", {"paused": True})
                plan = json.loads(get(port, "/api/state")[1])["plan"]
                frames = get(port, "/api/frames.log")[1].decode().splitlines()
                file = os.path.join(folder, "run.toml")
                with open(file, "wb") as written:
                    written.write(get(port, "/api/run.toml")[1])
            kinds = [act.split(":")[0] for act in plan["acts"]]
            self.assertEqual(kinds, ["visit", "read", "write", "nmt"])
            self.assertIn("visit:from=2:to=5@", plan["acts"][0])
            self.assertIn(":object=1017/00:bytes=EE02@", plan["acts"][2])  # 750, low byte first
            heard = [line for line in frames if float(line[1:].split(")")[0]) < 40]
            self.assertIn("602#2B171000EE020000", " ".join(heard))  # CiA 301: initiate download of 2 bytes
            words = [word for word in plan["command"].split()[1:]]
            at = words.index("--for")
            self.assertEqual(self.played(folder, *words[:at], *words[at + 2:])[:len(heard)], heard)
            self.assertEqual(self.played(folder, "run", file)[:len(heard)], heard)
            link = "http://127.0.0.1/#" + urllib.parse.urlencode([("seed", plan["seed"]), *(("act", act) for act in plan["acts"])])
            self.assertEqual(self.played(folder, *lift, "--link", link)[:len(heard)], heard)
            self.assertNotEqual(self.played(folder, *lift)[:len(heard)], heard)

    def test_another_run_has_the_acts_that_are_given_or_none(self):
        with served("run", "lift", "--web", "--speed", "0") as (_, port, _):
            acts = ["visit:from=2:to=5@1s"]
            self.assertEqual(post(port, "/api/run/restart", {"acts": acts})[0], 200)
            self.assertEqual(json.loads(get(port, "/api/state")[1])["plan"]["acts"], acts)
            self.assertEqual(post(port, "/api/run/restart", {"keep": True})[0], 200)
            self.assertEqual(json.loads(get(port, "/api/state")[1])["plan"]["acts"], acts)
            for wrong in ("visit:from=2:to=99@1s", "read:bus=can7:node=1:object=1000@1s", "visit"):
                status, answer = post(port, "/api/run/restart", {"acts": [wrong]})
                self.assertEqual(status, 422, answer)
            self.assertEqual(json.loads(get(port, "/api/state")[1])["plan"]["acts"], acts)
            self.assertEqual(post(port, "/api/run/restart", {})[0], 200)
            self.assertEqual(json.loads(get(port, "/api/state")[1])["plan"]["acts"], [])

    def test_an_act_that_cannot_be_is_refused(self):
        self.assert_refused(run("run", "charger", "--act", "visit:from=1:to=2@1s"), USAGE, "nobody visits")
        self.assert_refused(run("run", "charger", "--act", "read:bus=can7:node=5:object=1000@1s"), USAGE, "can7")
        self.assert_refused(run("run", "charger", "--act", "read:bus=sim0"), USAGE, "it has no time")


class ViewTest(CommandTest):
    def test_a_log_is_shown_up_to_any_time(self):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "bus.log")
            self.assertEqual(run("run", "charger", "--for", "1min", "--log", log).returncode, 0)
            with open(log, encoding="ascii") as lines:
                heard = lines.read().splitlines()
            with served("view", log) as (_, port, _):
                end = time.monotonic() + PATIENCE
                while len(get(port, "/api/frames.log")[1].splitlines()) < len(heard) and time.monotonic() < end:
                    time.sleep(0.05)
                self.assertEqual(get(port, "/api/frames.log")[1].decode().splitlines(), heard)
                self.assertEqual(post(port, "/api/run/seek", {"time": 10})[0], 200)
                first = float(heard[0][1:18])
                until = sum(float(line[1:18]) <= first + 10 for line in heard)
                while len(get(port, "/api/frames.log")[1].splitlines()) != until and time.monotonic() < end:
                    time.sleep(0.05)
                self.assertEqual(len(get(port, "/api/frames.log")[1].splitlines()), until)

    def test_others_need_the_token(self):
        for address in ("0.0.0.0:0", "127.0.0.1:0"):
            self.check_token(address)

    def check_token(self, address):
        with served("run", "charger", "--web", address) as (_, port, url):
            token = url.split("token=")[1]
            self.assertEqual(get(port, "/", token=None)[0], 403)
            self.assertEqual(get(port, "/api/state", token="0" * 32)[0], 403)
            status, _, headers = get(port, f"/?token={token}", token=None)
            self.assertEqual(status, 200)
            self.assertIn("HttpOnly; SameSite=Strict", headers["Set-Cookie"])
            cookie = headers["Set-Cookie"].split(";")[0]
            self.assertEqual(get(port, "/api/state", token=None, Cookie=cookie)[0], 200)
            self.assertEqual(get(port, "/api/state", token=token)[0], 200)


if __name__ == "__main__":
    unittest.main()
