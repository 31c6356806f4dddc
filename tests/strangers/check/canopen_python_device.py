"""A LocalNode of canopen-python on a bus behind a socketcand, by python-can's client.

    tests/strangers/with_python tests/strangers/check/canopen_python_device.py PORT NODE SHEET

What the package leaves to a program is done here: it boots when it is started, and after each reset, with the values of its
data sheet.
"""

import logging
import sys
import threading

import canopen

RESETS = (129, 130)  # NMT: reset node, reset communication

port, node_id, sheet = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
logging.disable(logging.CRITICAL)  # of frames that a client sends on purpose

network = canopen.Network()
network.connect(interface="socketcand", host="127.0.0.1", port=port, channel="can0", tcp_tune=True)
node = canopen.LocalNode(node_id, sheet)
network.add_node(node)


def boot():
    node.data_store.clear()
    node.nmt.state = "INITIALISING"
    node.nmt.state = "PRE-OPERATIONAL"


def hear_command(can_id, data, timestamp):
    if len(data) == 2 and data[0] in RESETS and data[1] in (0, node_id):
        boot()


network.subscribe(0, hear_command)
boot()
print("ready", flush=True)
threading.Event().wait()
