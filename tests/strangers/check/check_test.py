#!/usr/bin/python3
"""The conformance test on a device of others, with our battery's data sheet: it finds what stands in an approved file, and
nothing else. Each line of that file has a case, its clause, and what the device does.

    CANVOY=build/canvoy tests/strangers/check/check_test.py APPROVED PROGRAM...

PROGRAM, with the port of a socketcand, a node-ID and the data sheet behind it, is the device: it says `ready` when it has
booted. Classes are tried at the same time, each on a device and a bus of its own, since most of a class is waiting.
"""

import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

TESTS = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path += [str(TESTS / "cli"), str(TESTS / "strangers")]
from command import CANVOY, CommandTest, run
from socketcand_server import Server

NODE = "10"
CLASSES = ["eds", "sdo", "dictionary", "nmt", "heartbeat", "emergency", "rpdo", "tpdo", "sync", "guarding", "store", "can-id",
           "lss", "302", "profile"]  # fmt: skip
CONFORMS, DOES_NOT_CONFORM = 0, 4
# How punctual an interpreter is on a busy machine says nothing of the package; what is approved has another reason.
PUNCTUALITY = {"heartbeat-01", "heartbeat-02", "sync-01", "sync-04"}
LINE = re.compile(r"(\S+) +(CiA [^:]+): (\S.*)")

approved_file = pathlib.Path(sys.argv[1])
program = sys.argv[2:]


def approved():
    """Of each case its clause; comments begin with #."""
    clauses = {}
    for line in approved_file.read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        match = LINE.fullmatch(line)
        assert match, f"{approved_file.name}: no case with a clause and a reason: {line}"
        assert match[1] not in clauses, f"{approved_file.name}: {match[1]} stands there twice"
        clauses[match[1]] = match[2]
    return clauses


def try_class(name, folder):
    """What came of each of its cases, and what the test could not put back."""
    server = Server()
    report = folder / f"{name}.json"
    with subprocess.Popen([*program, str(server.port), NODE, folder / "battery.eds"], stdout=subprocess.PIPE, text=True) as device:
        try:
            assert device.stdout.readline() == "ready\n", f"{program} does not start"
            bus = f"tcp:127.0.0.1:{server.port}/can0"
            done = run("check", bus, NODE, "--eds", folder / "battery.eds", "--only", name, "--json", report)
            assert done.returncode in (CONFORMS, DOES_NOT_CONFORM), f"{name}: {done.stderr}"
        finally:
            server.stop()
            device.kill()
    *cases, _ = map(json.loads, report.read_text().splitlines())
    return cases


def failures(cases):
    """Of each case that failed its clause."""
    passed_over = PUNCTUALITY - approved().keys()
    failed = (case for case in cases if case["verdict"] == "FAIL" and case["case"] not in passed_over)
    return {case["case"]: case["clause"] for case in failed}


def try_again(name, cases, folder):
    """Some cases measure times, and the machine may stand still: what is not known and is not found again, alone, is its doing."""
    for _ in range(3):
        unknown = failures(cases).keys() - approved().keys()
        if not unknown:
            break
        again = try_class(name, folder)
        gone = unknown - failures(again).keys()
        cases = [other if case["case"] in gone else case for case, other in zip(cases, again, strict=True)]
    return cases


class Check(CommandTest):
    def test_what_is_found_is_known_with_its_clause(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.assert_done(run("eds", "export", "battery", "--out", folder / "battery.eds"))
            with concurrent.futures.ThreadPoolExecutor(len(CLASSES)) as pool:
                tried = list(pool.map(lambda each: try_class(each, folder), CLASSES))
            tried = [try_again(name, cases, folder) for name, cases in zip(CLASSES, tried, strict=True)]
        cases = [case for of_class in tried for case in of_class]
        self.assertEqual(len({case["case"] for case in cases}), len(cases), "each case once")
        counts = {verdict: sum(case["verdict"] == verdict for case in cases) for verdict in ("PASS", "FAIL", "n/a")}
        print(f"{len(cases)} cases: {counts}")
        self.maxDiff = None
        why = "\n".join(f"{case['case']}: {case.get('why')}" for case in cases if case["verdict"] == "FAIL")
        self.assertEqual(failures(cases), approved(), why)


if __name__ == "__main__":
    # What runs the program says whether it can.
    probe = subprocess.run([program[0], "--version"], stdout=subprocess.PIPE, text=True)
    if probe.returncode != 0:
        print(probe.stdout, end="")
        sys.exit(probe.returncode)
    unittest.main(argv=sys.argv[:1])
