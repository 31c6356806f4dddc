"""A server of socketcand's protocol, as its doc/protocol.md and state_raw.c have it: a bus of its own between its clients.

    server = Server()
    bus = f"tcp:127.0.0.1:{server.port}/can0"
    server.stop()
"""

import re
import socket
import threading
import time

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
