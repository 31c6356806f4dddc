#!/usr/bin/python3
"""A device of each profile, run from its data sheet, and node-canopen, which reads it by that sheet.

    tests/strangers/eds/device_test.py COMMAND
"""

import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent.parent))
import own_network

own_network.enter_or_skip()
with_node = HERE.parent / "with_node"
os.execv(with_node, [with_node, HERE / "device_test.js", *sys.argv[1:]])
