#!/usr/bin/env python3
"""The page's server by the letter of HTTP/1.1 and WebSocket: heads as bytes, and what has to be answered, with the clause."""

import json
import socket
import unittest

from command import CommandTest
from web_test import TOKEN, get, raw, served

OWN = "Authorization: Bearer " + TOKEN
POST = "Content-Type: application/json\r\n"
UPGRADE = "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: "
KEY = "dGhlIHNhbXBsZSBub25jZQ=="  # RFC 6455, 1.3

# Clause, first line, fields, body, status. {at} is the server's address, {own} its token. `Connection: close` is added.
# RFC 9112 where no other is named; what stands behind a slash is RFC 9110 or RFC 6455.
RULES = [
    ("3.2 Host", "GET /api/state HTTP/1.1", "{own}\r\n", "", 400),
    ("3.2 Host", "GET /api/state HTTP/1.1", "Host: {at}\r\nHost: {at}\r\n{own}\r\n", "", 400),
    ("3.2 Host", "GET /api/state HTTP/1.1", "Host: {at}\r\nHost: evil.example\r\n{own}\r\n", "", 400),
    ("3.2 Host", "GET /api/state HTTP/1.1", "Host:\r\n{own}\r\n", "", 403),
    ("3.2 Host", "GET /api/state HTTP/1.1", "hOsT: {at}\r\n{own}\r\n", "", 200),
    ("3.2.1 origin form", "GET api/state HTTP/1.1", "Host: {at}\r\n{own}\r\n", "", 400),
    ("3.2.2 absolute form", "GET http://{at}/api/state HTTP/1.1", "Host: {at}\r\n{own}\r\n", "", 200),
    ("3.2.2 its host counts", "GET http://{at}/api/state HTTP/1.1", "Host: evil.example\r\n{own}\r\n", "", 200),
    ("3.2.2 its host counts", "GET http://evil.example/api/state HTTP/1.1", "Host: {at}\r\n{own}\r\n", "", 403),
    ("3.2.3 authority form", "CONNECT {at} HTTP/1.1", "Host: {at}\r\n{own}\r\n", "", 400),
    ("3 methods have case", "get /api/state HTTP/1.1", "Host: {at}\r\n{own}\r\n", "", 405),
    ("2.3 version", "GET /api/state HTTP/2.0", "Host: {at}\r\n{own}\r\n", "", 400),
    ("2.3 version", "GET /api/state HTTP/1.0", "Host: {at}\r\n{own}\r\n", "", 200),
    ("5.1 blank before a colon", "GET /api/state HTTP/1.1", "Host : {at}\r\n{own}\r\n", "", 400),
    ("5.1 no name", "GET /api/state HTTP/1.1", "Host: {at}\r\n: x\r\n{own}\r\n", "", 400),
    ("6.3 lengths", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Content-Length: 2\r\nContent-Length: 3\r\n", "{}", 400),
    ("6.3 lengths", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Content-Length: x\r\n", "{}", 400),
    ("6.3 lengths", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Content-Length: -2\r\n", "{}", 400),
    ("6.3 chunked and a length", "POST /api/run/pause HTTP/1.1",
     "Host: {at}\r\n{own}\r\n" + POST + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n", "2\r\n{}\r\n0\r\n\r\n", 400),
    ("7.1 chunks", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Transfer-Encoding: chunked\r\n",
     '1\r\n{\r\n11\r\n"paused": false }\r\n0\r\n\r\n', 200),
    ("7.1 chunks", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Transfer-Encoding: chunked\r\n", "x\r\n{}\r\n0\r\n\r\n", 400),
    ("/10.1.1 Expect", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Expect: more\r\nContent-Length: 2\r\n", "{}", 417),
    ("/10.1.1 Expect", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\n" + POST + "Expect: 100-continue\r\nContent-Length: 17\r\n",
     '{"paused": false}', 100),
    ("/10.1.1 Expect of 1.0", "POST /api/run/pause HTTP/1.0", "Host: {at}\r\n{own}\r\n" + POST + "Expect: 100-continue\r\nContent-Length: 17\r\n",
     '{"paused": false}', 200),
    ("/15.5.16 type", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\nContent-Length: 2\r\n", "{}", 415),
    ("/15.5.16 type", "POST /api/run/pause HTTP/1.1", "Host: {at}\r\n{own}\r\nContent-Type: application/jsonp\r\nContent-Length: 2\r\n", "{}", 415),
    ("/8.3.1 type", "POST /api/run/pause HTTP/1.1",
     "Host: {at}\r\n{own}\r\nContent-Type: Application/JSON; charset=utf-8\r\nContent-Length: 17\r\n", '{"paused": false}', 200),
    ("RFC 6454, 7.3 Origin", "GET /api/state HTTP/1.1", "Host: {at}\r\n{own}\r\nOrigin: http://{at}\r\nOrigin: http://{at}\r\n", "", 400),
    ("RFC 6454, 7.3 Origin", "GET /api/state HTTP/1.1", "Host: {at}\r\n{own}\r\nOrigin: null\r\n", "", 403),
    ("two tokens", "GET /api/state HTTP/1.1", "Host: {at}\r\n{own}\r\n{own}\r\n", "", 400),
    ("/15.5.22 no upgrade", "GET /live HTTP/1.1", "Host: {at}\r\n{own}\r\n", "", 426),
    ("6455, 4.2.1 key of 3 bytes", "GET /live HTTP/1.1", "Host: {at}\r\n{own}\r\n" + UPGRADE + "AAAA\r\n", "", 400),
    ("6455, 4.2.1 no key", "GET /live HTTP/1.1", "Host: {at}\r\n{own}\r\n" + UPGRADE + "\r\n", "", 400),
    ("6455, 4.2.1 key of 17 bytes", "GET /live HTTP/1.1", "Host: {at}\r\n{own}\r\n" + UPGRADE + KEY[:22] + "A=\r\n", "", 400),
    ("6455, 4.4 version", "GET /live HTTP/1.1", "Host: {at}\r\n{own}\r\n" + UPGRADE.replace("13", "12") + KEY + "\r\n", "", 426),
    ("6455, 4.2.2", "GET /live HTTP/1.1", "Host: {at}\r\n{own}\r\n" + UPGRADE + KEY + "\r\n", "", 101),
]  # fmt: skip


class HttpTest(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.server = served("run", "charger", "--web")
        cls.process, cls.port, _ = cls.server.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.server.__exit__(None, None, None)

    def filled(self, text):
        return text.replace("{at}", f"127.0.0.1:{self.port}").replace("{own}", OWN)

    def test_each_head_is_answered_as_its_clause_says(self):
        for clause, first, fields, body, status in RULES:
            close = "" if "Upgrade:" in fields else "Connection: close\r\n"
            answer = raw(self.port, self.filled(f"{first}\r\n{fields}{close}\r\n").encode() + body.encode())
            head, _, content = answer.partition(b"\r\n\r\n")
            self.assertEqual(head.split(b" ")[1:2], [str(status).encode()], (clause, first, fields))
            if status not in (100, 101) and b"Sec-WebSocket-Version" not in head:  # Beast's own answer has no Date
                self.assertRegex(head, rb"\r\nDate: \w{3}, \d\d \w{3} \d{4} [\d:]{8} GMT", clause)
            if status == 426:
                self.assertRegex(head, rb"(?i)\r\nupgrade: websocket|\r\nSec-WebSocket-Version: 13", clause)
            if status in (400, 403, 405, 415, 417):
                self.assertIn("error", json.loads(content), clause)

    def test_a_head_has_the_length_of_what_it_stands_for(self):
        def head_of(method):
            first = f"{method} /openapi.json HTTP/1.1\r\nHost: {{at}}\r\n{{own}}\r\nConnection: close\r\n\r\n"
            return raw(self.port, self.filled(first).encode()).partition(b"\r\n\r\n")

        def length_of(head):
            return next(int(line[15:]) for line in head.split(b"\r\n") if line.startswith(b"Content-Length:"))

        (head, _, none), (whole, _, body) = head_of("HEAD"), head_of("GET")
        self.assertEqual((none, length_of(head), length_of(whole)), (b"", len(body), len(body)))

    # RFC 9110, 8.6: a length in an answer of 304 would be that of the file.
    def test_what_is_known_has_no_length(self):
        tag = get(self.port, "/page.css")[2]["ETag"]
        status, body, headers = get(self.port, "/page.css", **{"If-None-Match": tag})
        self.assertEqual((status, body, headers["Content-Length"]), (304, b"", None))

    def test_requests_in_one_packet_are_answered_in_their_order(self):
        one = self.filled("GET {path} HTTP/1.1\r\nHost: {at}\r\n{own}\r\n")
        with socket.create_connection(("127.0.0.1", self.port), timeout=60) as client:
            client.sendall((one.replace("{path}", "/api/nothing") + "\r\n" + one.replace("{path}", "/api") + "Connection: close\r\n\r\n").encode())
            answer = b""
            while chunk := client.recv(65536):
                answer += chunk
        self.assertEqual([part[:3] for part in answer.split(b"HTTP/1.1 ")[1:]], [b"404", b"200"])


if __name__ == "__main__":
    unittest.main()
