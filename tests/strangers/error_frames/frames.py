"""Error frames as candump writes them: each class, each detail, each place, and what two wires may have."""

# In which part of a frame an error may be, by the number that SocketCAN and the SJA1000 give it.
LOCATIONS = {
    0x02: "in ID bits 28 to 21",
    0x03: "in the start of frame",
    0x04: "in the SRTR bit",
    0x05: "in the IDE bit",
    0x06: "in ID bits 20 to 18",
    0x07: "in ID bits 17 to 13",
    0x08: "in the CRC sequence",
    0x09: "in reserved bit 0",
    0x0A: "in the data field",
    0x0B: "in the data length code",
    0x0C: "in the RTR bit",
    0x0D: "in reserved bit 1",
    0x0E: "in ID bits 4 to 0",
    0x0F: "in ID bits 12 to 5",
    0x12: "in the intermission",
    0x18: "in the CRC delimiter",
    0x19: "in the ACK slot",
    0x1A: "in the end of frame",
    0x1B: "in the ACK delimiter",
}


def frames():
    for bit in range(10):
        yield f"{0x20000000 | 1 << bit:08X}#0000000000000000"
    for bit in range(7):
        yield f"20000004#00{1 << bit:02X}000000000000"
    for bit in range(8):
        yield f"20000088#0000{1 << bit:02X}0000000000"
    for location in LOCATIONS:
        yield f"20000008#000001{location:02X}00000000"
    for number in (1, 12, 31):
        yield f"20000002#{number:02X}00000000000000"
    for status in (0x04, 0x05, 0x06, 0x07, 0x40, 0x50, 0x60, 0x70, 0x80):
        yield f"20000010#00000000{status:02X}000000"
    yield "200001FF#0C7FFF1945008007"
    yield "20000040#0C7F7F1945000000"


def write_log(path, errors):
    path.write_text("".join(f"({i}.000000) vcan0 {frame}\n" for i, frame in enumerate(errors)))


def parts_of(text):
    """The classes in our text, each with its details."""
    return dict((part.split(": ", 1) + [""])[:2] for part in text.split("; ") if part)
