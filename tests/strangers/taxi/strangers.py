"""Add-on devices of CiA 447-3 on canopen-python, of a maker of their own (1018h): they have no node-ID, answer LSS Fastscan
(CiA 305), and serve objects to each node on the channel that CiA 447 gives the two. Their time is that of the simulated
taxi, to which they are wired by pipes (peer.cpp).

    taxi = Taxi(peer, 2400, ["3"])
    printer = Printer(taxi)
    taxi.run_until(2400)
"""

import struct
import subprocess

import canopen
from canopen.objectdictionary import ODArray, ODVariable, ObjectDictionary, datatypes

VENDOR = 0x2F0
LSS_MASTER, LSS_SLAVE = 0x7E5, 0x7E4
SLEEP, SET_SLEEP_MODE, WAKE_UP = 0x690, 0x02, 0x82
HEARTBEAT_MS = 500
NEVER = 1 << 60
NODES = 16
STOPPED, OPERATIONAL, PRE_OPERATIONAL = 4, 5, 127


def sdo_request(client, server):
    n = client - 1
    return 0x240 + ((n & 0x0C) << 6) + ((n & 0x03) << 4) + server - 1


def pdo_base(node):
    n = node - 1
    return 0x180 + ((n & 7) << 7) + ((n & 8) << 2)


# Where the pre-defined PDOs stand in the 32 CAN-IDs of their sender.
PDO_NUMBERS = [*range(1, 8), 17, 18, 19, *range(65, 85)]


class Wire(canopen.Network):
    """The network of canopen-python without a bus of its own."""

    def __init__(self, taxi):
        super().__init__()
        self.taxi = taxi

    def send_message(self, can_id, data, remote=False):
        self.taxi.send(can_id, data)


class Taxi:
    def __init__(self, peer, seconds, real):
        self.peer = subprocess.Popen([peer, str(seconds), *real], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
        self.now = 0
        self.devices = []
        self.frames = []  # all of them, as (time in ms, CAN-ID, bytes)
        self.driver = "off_duty"

    def send(self, can_id, data):
        self.frames.append((self.now, can_id, bytes(data)))
        self.tell(f"{can_id:03X}#{bytes(data).hex().upper()}")

    def tell(self, line):
        self.peer.stdin.write(line + "\n")

    def run_until(self, seconds):
        end = int(seconds * 1000)
        while self.now < end:
            due = min([end, *(device.due for device in self.devices)])
            self.tell(f"until {max(due, self.now + 1)}")
            heard = []
            while not (line := self.peer.stdout.readline()).startswith("now "):
                assert line, f"the taxi has ended: {self.peer.wait()}"
                heard.append(line.strip())
            self.now = int(line[4:])
            for each in heard:
                self.take(each)
            for device in self.devices:
                device.advance()

    def take(self, line):
        if line.startswith("driver "):
            self.driver = line[7:]
        else:
            can_id, data = line.split("#")
            if data.startswith("R"):
                return
            self.frames.append((self.now, int(can_id, 16), bytes.fromhex(data)))
            for device in self.devices:
                device.hear(int(can_id, 16), bytes.fromhex(data))

    def end(self):
        """What is broken, what is undecided, what was paid for each trip."""
        self.tell("end")
        lines = []
        while (line := self.peer.stdout.readline().strip()) != "end":
            assert line, "the taxi has ended"
            lines.append(line.split())
        self.peer.stdin.close()
        self.peer.wait()
        said = {word: [line[1:] for line in lines if line[0] == word] for word in ("broken", "undecided", "trip")}
        return [name for name, in said["broken"]], [name for name, in said["undecided"]], [float(paid) for paid, _ in said["trip"]]


class LssSlave:
    """CiA 305: Fastscan while it has no node-ID, selective switch, inquiries, configuration of the node-ID."""

    def __init__(self, identity, answer, named):
        self.identity, self.answer, self.named = identity, answer, named
        self.has_id = False
        self.is_in_configuration = False
        self.position = 0
        self.selected = []

    def hear(self, data):
        command, value = data[0], struct.unpack_from("<L", data, 1)[0]
        if command == 0x51 and not self.has_id and not self.is_in_configuration:
            self.fastscan(value, *data[5:8])
        elif command == 0x04:
            self.is_in_configuration = data[1] == 1
        elif 0x40 <= command <= 0x43:
            self.selected = [*self.selected, value] if command != 0x40 else [value]
            if command == 0x43 and self.selected == self.identity:
                self.is_in_configuration = True
                self.answer([0x44])
        elif self.is_in_configuration and 0x5A <= command <= 0x5D:
            self.answer(struct.pack("<BL", command, self.identity[command - 0x5A]))
        elif self.is_in_configuration and command == 0x11:
            self.answer([0x11, 0, 0])
            self.has_id = True
            self.named(data[1])

    def fastscan(self, value, bit, sub, following):
        if bit == 0x80:
            self.position = 0
        elif sub != self.position or (self.identity[sub] ^ value) >> bit:
            return
        else:
            self.position = following
            if bit == 0 and following < sub:
                self.is_in_configuration = True
        self.answer([0x4F])


def variable(name, index, subindex, data_type, value=None, access="rw"):
    entry = ODVariable(name, index, subindex)
    entry.data_type, entry.access_type, entry.default = data_type, access, value
    return entry


class Device:
    """A node with the objects that every one has. `pdo` is the pre-defined TPDO that shows what it provides."""

    PDO = 0

    def __init__(self, taxi, serial, product):
        self.taxi = taxi
        self.od = ObjectDictionary()
        self.add(0x1000, 0, datatypes.UNSIGNED32, 447)
        identity = ODArray("identity", 0x1018)
        for sub, (kind, value) in enumerate(
            [(datatypes.UNSIGNED8, 4), *((datatypes.UNSIGNED32, each) for each in (VENDOR, product, 1, serial))]
        ):
            identity.add_member(variable(str(sub), 0x1018, sub, kind, value, "ro"))
        self.od.add_object(identity)
        self.lss = LssSlave([VENDOR, product, 1, serial], self.lss_answer, self.is_named)
        self.pending = 0
        self.node = None
        self.state = 0
        self.due = NEVER
        self.clients = {}
        self.network = Wire(taxi)
        self.writer = 0  # the node-ID of whose request is under way
        taxi.devices.append(self)

    def add(self, index, subindex, data_type, value=None, access="rw"):
        entry = variable(f"{index:04X}", index, subindex, data_type, value, access)
        self.od.add_object(entry)
        return entry

    def add_record(self, index, data_type, subindices):
        record = ODArray(f"{index:04X}", index)
        record.add_member(variable("highest", index, 0, datatypes.UNSIGNED8, max(subindices), "const"))
        for sub in subindices:
            record.add_member(variable(str(sub), index, sub, data_type, 0xFFFFFFFF, "ro"))
        self.od.add_object(record)

    def lss_answer(self, data):
        self.taxi.send(LSS_SLAVE, bytes(data).ljust(8, b"\0"))

    # The first node-ID is taken at once; another one with the next reset of the communication.
    def is_named(self, node_id):
        self.pending = node_id
        if self.node is None:
            self.boot()

    def boot(self):
        self.network = Wire(self.taxi)
        node_id = self.pending
        if self.PDO:
            parameter = ODArray("TPDO", 0x1800 + self.PDO - 1)
            parameter.add_member(variable("highest", parameter.index, 0, datatypes.UNSIGNED8, 2, "const"))
            parameter.add_member(variable("COB-ID", parameter.index, 1, datatypes.UNSIGNED32, self.pdo_id(node_id), "ro"))
            parameter.add_member(variable("type", parameter.index, 2, datatypes.UNSIGNED8, 255, "ro"))
            self.od[parameter.index] = parameter
            mapping = ODArray("mapping", 0x1A00 + self.PDO - 1)
            mapping.add_member(variable("highest", mapping.index, 0, datatypes.UNSIGNED8, 0, "ro"))
            self.od[mapping.index] = mapping
        self.node = canopen.LocalNode(node_id, self.od)
        self.node.associate_network(self.network)
        self.node.add_read_callback(self.read)
        self.node.add_write_callback(self.written)
        for client in range(1, NODES + 1):
            if client == node_id:
                continue
            request = sdo_request(client, node_id)
            server = canopen.sdo.SdoServer(request, request - 0x80, self.node)
            server.network = self.network
            self.network.subscribe(request, self.channel_of(client, server))
        self.state = PRE_OPERATIONAL
        self.taxi.send(0x700 + node_id, [0])
        self.due = self.taxi.now + HEARTBEAT_MS

    def channel_of(self, client, server):
        def came(can_id, data, timestamp):
            self.writer = client
            server.on_request(can_id, data, timestamp)

        return came

    def pdo_id(self, node_id):
        return pdo_base(node_id) + PDO_NUMBERS.index(self.PDO)

    def send_pdo(self, data):
        if self.state == OPERATIONAL:
            self.taxi.send(self.pdo_id(self.node.id), data)

    def hear(self, can_id, data):
        if can_id == LSS_MASTER:
            return self.lss.hear(data)
        if self.node is None:
            return None
        if SLEEP < can_id <= SLEEP + NODES:
            return self.sleep(data[0])
        if can_id == 0 and data[1] in (0, self.node.id):
            return self.command(data[0])
        self.network.notify(can_id, bytearray(data), self.taxi.now / 1000)
        return self.came(can_id, data)

    def command(self, command):
        if command == 0x82 or command == 0x81:
            self.boot()
        else:
            self.state = {1: OPERATIONAL, 2: STOPPED, 0x80: PRE_OPERATIONAL}[command]
            if self.state == OPERATIONAL:
                self.started()

    def sleep(self, command):
        if command == SET_SLEEP_MODE:
            self.due = NEVER
        elif command == WAKE_UP and self.due == NEVER:
            self.due = self.taxi.now

    def advance(self):
        if self.taxi.now < self.due:
            return
        self.due = self.taxi.now + HEARTBEAT_MS
        self.taxi.send(0x700 + self.node.id, [self.state])

    # What a device adds.
    def came(self, can_id, data):
        pass

    def started(self):
        pass

    def read(self, **what):
        return None

    def written(self, index, subindex, od, data):
        pass
