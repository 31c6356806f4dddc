"""The frames that the files beside this hold: of a bus in which everything occurs, from a seed, the same each time."""

import random

START = 1_700_000_000
COUNT = 200


def frames(count=COUNT, seed=447):
    """Each as what python-can's Message is made of."""
    chance = random.Random(seed)
    for number in range(count):
        kind = chance.random()
        extended = chance.random() < 0.3
        told = {
            "timestamp": START + (number * 1_000_000 + chance.randrange(1_000_000)) / 1e6,
            "channel": chance.randrange(3),
            "is_rx": chance.random() < 0.7,
            "arbitration_id": chance.getrandbits(29 if extended else 11),
            "is_extended_id": extended,
        }
        if kind < 0.1:
            told |= {"is_remote_frame": True, "dlc": chance.randint(0, 8)}
        elif kind < 0.15:  # a stuff error in transmission, as SocketCAN tells it
            data = bytes([0, 0, 0x84, 2, 0, 0, 0, 0])
            told |= {"arbitration_id": 0x88, "is_extended_id": False, "is_error_frame": True, "data": data, "dlc": 8}
        elif kind < 0.2:
            data = bytes(chance.getrandbits(8) for _ in range(chance.choice([12, 16, 24, 32, 48, 64])))
            told |= {"is_fd": True, "bitrate_switch": True, "data": data, "dlc": len(data)}
        else:
            data = bytes(chance.getrandbits(8) for _ in range(chance.randint(0, 8)))
            told |= {"data": data, "dlc": len(data)}
        yield told


def line(told):
    """As `canvoy decode` names time, bus and frame."""
    number = f"{told['arbitration_id']:0{8 if told['is_extended_id'] else 3}X}"
    data = told.get("data", b"").hex().upper()
    if told.get("is_error_frame"):
        shown = f"{told['arbitration_id'] | 0x20000000:08X}#{data}"
    elif told.get("is_remote_frame"):
        shown = f"{number}#R{told['dlc'] or ''}"
    elif told.get("is_fd"):
        shown = f"{number}##1{data}"
    else:
        shown = f"{number}#{data}"
    return f"({told['timestamp']:.6f}) can{told['channel']} {shown}"
