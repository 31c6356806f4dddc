#!/usr/bin/python3
"""A node of python-can on its UDP multicast bus: it answers each frame by one with the next identifier.

It says hello by 7FE#, and ends at 7FF#.
"""

import can

with can.Bus(interface="udp_multicast", channel="239.74.163.2", port=43113, hop_limit=0, fd=True) as bus:
    bus.send(can.Message(arbitration_id=0x7FE, is_extended_id=False))
    # Frames that it sent come back to it, and those that answer them may do so before.
    own = [0x7FE]
    while True:
        message = bus.recv(30)
        assert message is not None, "nothing was heard for 30 s"
        if message.arbitration_id in own:
            own.remove(message.arbitration_id)
            continue
        if message.arbitration_id == 0x7FF:
            break
        message.arbitration_id += 1
        own.append(message.arbitration_id)
        bus.send(message)
    bus.send(can.Message(arbitration_id=0x123, is_extended_id=False, is_fd=True, data=bytes(12)))
