#!/usr/bin/env python3
"""Error frames in words, held against what tshark reads in them.

    tests/strangers/error_frames/tshark_test.py COMMAND

They are in a pcapng file that the command wrote.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from frames import LOCATIONS, frames, write_log

# By the name of tshark's field, what our text has where the field is true.
CLASSES = {
    "can.err.tx_timeout": "transmit time-out",
    "can.err.lostarb": "arbitration lost",
    "can.err.ctrl": "controller",
    "can.err.prot": "protocol violation",
    "can.err.trx": "transceiver",
    "can.err.ack": "no acknowledgement",
    "can.err.busoff": "bus-off",
    "can.err.buserror": "bus error",
    "can.err.restarted": "controller restarted",
}
DETAILS = {
    "can.err.ctrl.rx_overflow": "receive buffer overflow",
    "can.err.ctrl.tx_overflow": "transmit buffer overflow",
    "can.err.ctrl.rx_warning": "error warning (reception)",
    "can.err.ctrl.tx_warning": "error warning (transmission)",
    "can.err.ctrl.rx_passive": "error-passive (reception)",
    "can.err.ctrl.tx_passive": "error-passive (transmission)",
    "can.err.ctrl.active": "error-active again",
    "can.err.prot.type.bit": "bit error",
    "can.err.prot.type.form": "form error",
    "can.err.prot.type.stuff": "stuff error",
    "can.err.prot.type.bit0": "no dominant bit could be sent",
    "can.err.prot.type.bit1": "no recessive bit could be sent",
    "can.err.prot.type.overload": "overload",
    "can.err.prot.type.active": "active error flag",
    "can.err.prot.type.tx": "on transmission",
}
WIRES = {
    "unspecified": "",
    "no wire": "has no wire",
    "short to BAT": "is shorted to the battery",
    "short to VCC": "is shorted to VCC",
    "short to GND": "is shorted to ground",
    "short to CANH": "is shorted to CANH",
}


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def read_by_tshark(capture):
    """What each packet has: the summary of fields and the whole text of the tree."""
    fields = [*CLASSES, *DETAILS, "can.err.lostarb.bitnum", "can.err.prot.location"]
    output = run("tshark", "-r", capture, "-T", "fields", "-E", "separator=;", *(word for field in fields for word in ("-e", field)))
    rows = [dict(zip(fields, line.split(";"))) for line in output.splitlines()]
    trees = re.split(r"(?m)^Frame \d+:", run("tshark", "-r", capture, "-V"))[1:]
    return list(zip(rows, trees, strict=True))


def is_true(text):
    return text in ("1", "True")


def compare(frame, text, row, tree):
    """What the two disagree in."""
    for field, words in CLASSES.items():
        # Each class is a part of the text of its own, in front of what belongs to it.
        has = any(part == words or part.startswith((words + ":", words + " in bit")) for part in text.split("; "))
        if has != is_true(row[field]):
            yield f"{field} is {row[field]}"
    for field, words in DETAILS.items():
        # None is a part of another: "bit error" is not in "bit error 0".
        if bool(re.search(r"(: |, | )" + re.escape(words) + r"(,|;| on | in |$)", text)) != is_true(row[field]):
            yield f"{field} is {row[field]}"
    bit = row["can.err.lostarb.bitnum"]
    if bit and int(bit) != 0 and f"arbitration lost in bit {bit}" not in text:
        yield f"arbitration is lost in bit {bit}"
    location = row["can.err.prot.location"]
    if location and int(location, 0) != 0 and LOCATIONS[int(location, 0)] not in text:
        yield f"the location is {location}"
    for wire in ("CANH", "CANL"):
        status = re.search(rf"Transceiver {wire} status: (.*) \(", tree)
        said = re.search(rf"{wire} ((has|is) [^,;]*)", text)
        expected = WIRES[status.group(1)] if status else ""
        if (said.group(1) if said else "") != expected:
            yield f"{wire} is {status and status.group(1)}"


def main():
    command = sys.argv[1]
    if shutil.which("tshark") is None:
        print("skipped: there is no tshark")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder) / "errors.log"
        write_log(log, frames())
        capture = str(log) + ".pcapng"
        run(command, "convert-log", str(log), capture)
        lines = run(command, "decode", capture).splitlines()
        read = read_by_tshark(capture)
    assert len(lines) == len(read) == len(list(frames())), "each reads all of them"
    findings = []
    for frame, line, (row, tree) in zip(frames(), lines, read, strict=True):
        text = line.split("error frame", 1)[1].strip()
        findings += [f"{frame} '{text}': but of tshark {finding}" for finding in compare(frame, text, row, tree)]
    for finding in findings:
        print(finding)
    print(f"{len(read)} error frames compared")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
