#!/usr/bin/env python3
"""Error frames in words, held against what `candump -e` says of them on the same CAN interface.

    scripts/socketcan-vm python3 tests/strangers/error_frames/candump_test.py COMMAND

canplayer sends them to vcan0; candump and `canvoy monitor` listen. What candump writes is then read as a log.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import time

from frames import LOCATIONS, frames, parts_of, write_log

# The candump of can-utils 2020.11 does not know the class of counters, and shows what its buffer had before.
SENT = [frame for frame in frames() if not frame.startswith("20000200")]

SENTENCES = {
    "tx-timeout": "transmit time-out",
    "controller-problem": "controller",
    "transceiver-status": "transceiver",
    "no-acknowledgement-on-tx": "no acknowledgement",
    "bus-off": "bus-off",
    "bus-error": "bus error",
    "restarted-after-bus-off": "controller restarted",
}
CONTROLLER = {
    "rx-overflow": "receive buffer overflow",
    "tx-overflow": "transmit buffer overflow",
    "rx-error-warning": "error warning (reception)",
    "tx-error-warning": "error warning (transmission)",
    "rx-error-passive": "error-passive (reception)",
    "tx-error-passive": "error-passive (transmission)",
    "back-to-error-active": "error-active again",
}
VIOLATIONS = {
    "single-bit-error": "bit error",
    "frame-format-error": "form error",
    "bit-stuffing-error": "stuff error",
    "tx-dominant-bit-error": "no dominant bit could be sent",
    "tx-recessive-bit-error": "no recessive bit could be sent",
    "bus-overload": "overload",
    "active-error": "active error flag",
}
PLACES = {
    "id.28-to-id.21": 0x02, "start-of-frame": 0x03, "bit-srtr": 0x04, "bit-ide": 0x05, "id.20-to-id.18": 0x06,
    "id.17-to-id.13": 0x07, "crc-sequence": 0x08, "reserved-bit-0": 0x09, "data-field": 0x0A, "data-length-code": 0x0B,
    "bit-rtr": 0x0C, "reserved-bit-1": 0x0D, "id.4-to-id.0": 0x0E, "id.12-to-id.5": 0x0F, "intermission": 0x12,
    "crc-delimiter": 0x18, "acknowledge-slot": 0x19, "end-of-frame": 0x1A, "acknowledge-delimiter": 0x1B,
}  # fmt: skip


def words_of(details, table):
    return [table[word] for word in details.split(",") if word]


def violation_of(types, place):
    """`stuff error on transmission in the data field`"""
    text = ", ".join(words_of(types.replace("error-on-tx", ""), VIOLATIONS))
    for more in ("on transmission" if "error-on-tx" in types else "", LOCATIONS[PLACES[place]] if place else ""):
        text = (text + " " + more).strip()
    return text


def expected_of(line):
    """The class and the details that we are to say for a line of candump."""
    if match := re.fullmatch(r"lost-arbitration\{at bit (\d+)\}", line):
        bit = int(match.group(1))
        return (f"arbitration lost in bit {bit}" if bit else "arbitration lost", "")
    if match := re.fullmatch(r"controller-problem\{(.*)\}", line):
        return ("controller", ", ".join(words_of(match.group(1), CONTROLLER)))
    if match := re.fullmatch(r"protocol-violation\{\{(.*)\}\{(.*)\}\}", line):
        return ("protocol violation", violation_of(*match.groups()))
    if match := re.fullmatch(r"error-counter-tx-rx\{\{(\d+)\}\{(\d+)\}\}", line):
        return ("error counters", f"{match.group(1)} transmit, {match.group(2)} receive")
    return (SENTENCES[line], "")


def sayings(output):
    """For each error frame that candump shows, its lines."""
    blocks = re.split(r"(?m)^.*ERRORFRAME\n", output)[1:]
    return [[line.strip() for line in block.splitlines() if line.startswith("\t")] for block in blocks]


def compare(text, lines):
    """What the two disagree in."""
    ours = parts_of(text)
    for line in lines:
        if line.startswith("lost-arbitration{") and "at bit" not in line:
            line = "lost-arbitration{at bit 0}"
        title, details = expected_of(line)
        if title not in ours:
            yield line
        # candump does not say what is the matter with the wires.
        elif title != "transceiver" and ours[title] != details:
            yield line
    if len(ours) != len(lines):
        yield f"{len(lines)} classes"


def listen(command, log, folder):
    """What candump and we say, in text of all frames."""
    count = str(len(SENT))
    outputs = [folder / "candump.txt", folder / "monitor.txt"]
    listeners = (["candump", "-e", "-n", count, "vcan0,0:0,#FFFFFFFF"], [command, "monitor", "vcan0", "--count", count])
    with outputs[0].open("w") as first, outputs[1].open("w") as second:
        running = [subprocess.Popen(words, stdout=file) for words, file in zip(listeners, (first, second), strict=True)]
        time.sleep(5)  # emulated code is slow
        subprocess.run(["canplayer", "-g", "20", "-t", "-I", log, "vcan0=vcan0"], check=True)
        for process in running:
            process.wait(timeout=120)
    return outputs[0], outputs[1].read_text()


def main():
    command = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        log = folder / "errors.log"
        write_log(log, SENT)
        screen, monitored = listen(command, log, folder)
        said = sayings(screen.read_text())
        read = subprocess.run([command, "decode", screen], capture_output=True, text=True, check=True).stdout
    ours = [line.split("error frame", 1)[1].strip() for line in monitored.splitlines()]
    findings = [] if len(ours) == len(said) == len(SENT) else [f"{len(ours)} and {len(said)} frames were heard"]
    for frame, text, lines in zip(SENT, ours, said, strict=False):
        findings += [f"{frame} '{text}': but candump says {finding}" for finding in compare(text, lines)]
    if [line.split("error frame", 1)[1].strip() for line in read.splitlines()] != ours:
        findings.append("what candump showed is read as something else")
    for finding in findings:
        print(finding)
    print(f"{len(said)} error frames compared")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
