#!/usr/bin/env python3
"""The pages of evidence are those of what was measured; and what coverage and fuzzing say is read right."""

import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))


def script(name):
    loader = importlib.machinery.SourceFileLoader(name, str(ROOT / "scripts" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


coverage, evidence = script("coverage"), script("evidence")

# As llvm-cov export -format=lcov has it.
LCOV = """SF:{root}/canvoy/can/a.cpp
DA:1,3
DA:2,0
BRDA:3,0,0,2
BRDA:3,0,1,0
end_of_record
SF:{root}/canvoy/can/a_test.cpp
DA:1,0
end_of_record
SF:{root}/canvoy/text/b.cpp
DA:1,0
end_of_record
"""
# As ctest and libFuzzer have it.
LOG = """1/2 Testing: fuzz.nmea_fuzz
#1024 pulse  cov: 12 ft: 20 corp: 3/9b
#4096 DONE   cov: 345 ft: 800 corp: 20/1Kb
stat::number_of_executed_units: 123456
2/2 Testing: canopen.part_1
nothing
"""


class Evidence(unittest.TestCase):
    def test_the_pages_are_those_of_what_was_measured(self):
        done = subprocess.run([ROOT / "scripts" / "evidence", "--check"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_rooms_are_folders_and_tests_are_none(self):
        def file(path, covered):
            counts = {"count": 10, "covered": covered}
            return {"filename": f"/root/{path}", "summary": {"lines": counts, "branches": counts}}

        files = [file("canvoy/can/a.cpp", 9), file("canvoy/can/b.hpp", 10), file("canvoy/can/a_test.cpp", 1), file("canvoy/can/testing/c.hpp", 1),
                 file("../usr/include/vector", 1), file("canvoy/can/host/d.cpp", 0)]  # fmt: skip
        rooms = coverage.rooms_of({"data": [{"files": files}]}, "/root")
        self.assertEqual({name: room["lines"] for name, room in rooms.items()}, {"can": [19, 20], "can/host": [0, 10]})
        self.assertEqual(rooms["can"]["mcdc"], [0, 0])

    def test_what_is_not_reached_is_told_by_line(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            for path in ("canvoy/can/a.cpp", "canvoy/can/a_test.cpp", "canvoy/text/b.cpp"):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text("one\n  two\nthree\n")
            told = coverage.unreached_in(LCOV.format(root=root), root)
        self.assertEqual([(each["path"], each["line"], each["what"], each["text"]) for each in told],
                         [("canvoy/can/a.cpp", 2, "line", "two"), ("canvoy/can/a.cpp", 3, "branch", "three")])  # fmt: skip

    def test_executions_are_those_of_the_log(self):
        self.assertEqual(evidence.fuzzing_of(LOG), {"nmea": {"executions": 123456, "edges": 345}})

    def test_bounds_are_those_that_were_printed(self):
        line = ("at critical instants: 9500 messages, 1200 with several instances in the busy period, 3 without a bound; "
                "each bound was reached to 99.125 % at least\n")  # fmt: skip
        self.assertEqual(evidence.response_times_of(line), [{"what": "at critical instants", "messages": 9500, "unbounded": 3, "least": 99.125}])

    def test_what_was_not_measured_is_said_to_be_so(self):
        page = evidence.page_of({})
        self.assertEqual(page.lower().count("not measured"), 5, page)


if __name__ == "__main__":
    unittest.main()
