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

# As llvm-cov export has it of one program: lines, and the rest by file. A place is line, column, line, column; a branch adds how
# often it was true and false, and its kind is last; a segment begins at its line and column, and has a count.
SOURCE = "canvoy/can/a.hpp"
TEXT = "bool f(int a) {\n  return a > 3 && g(a);\n}\nvoid h();\n"
FIRST, SECOND = [2, 10, 2, 15], [2, 19, 2, 23]
UNUSED = [[1, 15, 0, True, True, False], [3, 2, 0, False, False, False]]
USED = [[1, 15, 7, True, True, False], [2, 19, 5, True, True, False], [3, 2, 0, False, False, False]]


def program(root, lines, segments=(), branches=(), decisions=(), path=SOURCE):
    lcov = f"SF:{root}/{path}\n" + "".join(f"DA:{line},{count}\n" for line, count in lines.items()) + "end_of_record\n"
    rows = [[*place, yes, no, 0, 0, 6] for place, yes, no in branches]
    conditions = [[*place, 0, 5, told] for place, told in decisions]
    return lcov, {"data": [{"files": [{"filename": f"{root}/{path}", "segments": list(segments), "branches": rows, "mcdc_records": conditions}]}]}


def reached_by(*programs):
    places = coverage.Places("/root")
    for each in programs:
        places.add(*program("/root", **each))
    return places


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
        places = reached_by(*({"path": path, "lines": {1: count, 2: 1}} for path, count in (
            ("canvoy/can/a.cpp", 0), ("canvoy/can/b.hpp", 1), ("canvoy/can/a_test.cpp", 0), ("canvoy/can/testing/c.hpp", 0),
            ("../usr/include/vector", 0), ("canvoy/can/host/d.cpp", 0))))  # fmt: skip
        rooms = places.rooms()
        self.assertEqual({name: room["lines"] for name, room in rooms.items()}, {"can": [3, 4], "can/host": [1, 2]})
        self.assertEqual(rooms["can"]["mcdc"], [0, 0])

    def unreached(self, *programs):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            (root / SOURCE).parent.mkdir(parents=True)
            (root / SOURCE).write_text(TEXT)
            return [(each["line"], each["what"], each["condition"]) for each in reached_by(*programs).unreached(root)]

    def test_what_no_program_reaches_is_told(self):
        used = {"lines": {1: 7, 2: 7, 4: 0}, "segments": USED, "branches": [(FIRST, 7, 0), (SECOND, 2, 3)]}
        self.assertEqual(self.unreached(used), [(2, "never false", "a > 3"), (4, "line", "")])

    def test_a_line_is_reached_if_one_program_does(self):
        used, unused = {"lines": {1: 7, 2: 7}}, {"lines": {1: 0, 2: 0}}
        self.assertEqual(self.unreached(used, unused), [])
        self.assertEqual(self.unreached(unused, used), [])
        self.assertEqual(self.unreached(unused, unused), [(1, "line", ""), (2, "line", "")])

    def test_a_branch_is_reached_on_each_side_by_any_instantiation_and_any_program(self):
        lines = {1: 7, 2: 7}
        twice = {"lines": lines, "segments": USED, "branches": [(FIRST, 7, 0), (FIRST, 0, 0), (FIRST, 0, 1)]}
        self.assertEqual(self.unreached(twice), [])
        one, other = ({"lines": lines, "segments": USED, "branches": [(FIRST, *counts)]} for counts in ((7, 0), (0, 7)))
        self.assertEqual(self.unreached(one), [(2, "never false", "a > 3")])
        self.assertEqual(self.unreached(one, other), [])
        rooms = reached_by(one, other, one).rooms()
        self.assertEqual(rooms["can"]["branches"], [2, 2])

    def test_a_condition_that_the_compiler_decides_has_no_branches(self):
        constant = {"lines": {1: 7, 2: 7}, "segments": USED, "branches": [(FIRST, 0, 0), (SECOND, 1, 1)]}
        self.assertEqual(self.unreached(constant), [])
        self.assertEqual(reached_by(constant).rooms()["can"]["branches"], [2, 2])
        not_asked = {"lines": {1: 7, 2: 7}, "segments": [*USED[:1], [2, 19, 0, True, True, False], USED[2]], "branches": [(SECOND, 0, 0)]}
        self.assertEqual(self.unreached(not_asked), [(2, "never asked", "g(a)")])
        self.assertEqual(self.unreached(not_asked, constant), [])

    def test_comments_and_closing_brackets_are_no_places(self):
        for line in ("", "  // a comment", "}", "  });", "      }"):
            self.assertFalse(coverage.is_code(line), line)
        for line in ("  return;", "} else {  // a comment", "++i;", ": a_(b) {", "!a) {", "(void)a;", "a / b;"):
            self.assertTrue(coverage.is_code(line), line)

    def test_a_line_that_nothing_reaches_is_told_once(self):
        unused = {"lines": {1: 0, 2: 0}, "segments": UNUSED, "branches": [(FIRST, 0, 0)]}
        self.assertEqual(self.unreached(unused), [(1, "line", ""), (2, "line", "")])

    def test_conditions_are_united_too_without_those_that_the_compiler_decides(self):
        both, decision = {"lines": {1: 7, 2: 7}, "segments": USED}, [2, 10, 2, 23]
        asked = [(FIRST, 7, 1), (SECOND, 2, 3)]
        one, other = ({**both, "branches": asked, "decisions": [(decision, told)]} for told in ([True, False], [False, True]))
        self.assertEqual(reached_by(one).rooms()["can"]["mcdc"], [1, 2])
        self.assertEqual(reached_by(one, other).rooms()["can"]["mcdc"], [2, 2])
        constant = {**both, "branches": [(FIRST, 0, 0), (SECOND, 2, 3)], "decisions": [(decision, [False, True])]}
        self.assertEqual(reached_by(constant).rooms()["can"]["mcdc"], [1, 1])

    def test_headers_of_the_project_must_not_be_precompiled(self):
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name) / "folders" / "canvoy_a.dir" / "cmake_pch.hxx"
            file.parent.mkdir(parents=True)
            file.write_text("#pragma clang system_header\n#include <array>\n")
            self.assertEqual(coverage.hidden_headers(pathlib.Path(name)), [])
            file.write_text(f'#pragma clang system_header\n#include <canvoy/a.hpp>\n#include "{ROOT}/canvoy/b.hpp"\n#include <array>\n')
            self.assertEqual(coverage.hidden_headers(pathlib.Path(name)), ["canvoy/a.hpp", "canvoy/b.hpp"])

    def test_executions_are_those_of_the_log(self):
        self.assertEqual(evidence.fuzzing_of(LOG), {"nmea": {"executions": 123456, "edges": 345}})

    def test_bounds_are_those_that_were_printed(self):
        line = ("at critical instants: 9500 messages, 1200 with several instances in the busy period, 3 without a bound; "
                "each bound was reached to 99.125 % at least\n")  # fmt: skip
        self.assertEqual(evidence.response_times_of(line), [{"what": "at critical instants", "messages": 9500, "unbounded": 3, "least": 99.125}])

    def test_hours_are_those_that_the_campaigns_printed(self):
        text = ("lift, seed 3: a door\nlift: 20 seeds, 40.0 h with 1234 faults, 0.0 h with a sabotage as well, 1 seeds with a wrong verdict\n"
                "bus-places: 5 seeds, 832.5 h with 1110 faults, 123.8 h with a sabotage as well, 0 seeds with a wrong verdict\n")  # fmt: skip
        rows = evidence.soak_of(text)
        self.assertEqual(rows, [{"campaign": "lift", "seeds": 20, "hours": 40.0, "faults": 1234, "sabotaged_hours": 0.0, "wrong": 1},
                                {"campaign": "bus-places", "seeds": 5, "hours": 832.5, "faults": 1110, "sabotaged_hours": 123.8, "wrong": 0}])  # fmt: skip
        self.assertEqual(evidence.stopped_of(text), [])
        self.assertEqual(evidence.wrong_of("bus, seed 3: late\n" + text + "bus, seed 4: a lie\n")[0], "bus, seed 3: late")
        self.assertNotIn("bus, seed 4: a lie", evidence.wrong_of(text + "bus, seed 4: a lie\n"))
        self.assertIn("- `bus, seed 3: late`", evidence.soak_text({"commit": "abc", "campaigns": rows, "wrong": ["bus, seed 3: late"]}))
        self.assertEqual(evidence.stopped_of(text + "bus, seed 4: a lie\n"), ["bus, seed 4: a lie"])
        self.assertIn("- `bus, seed 4: a lie`", evidence.soak_text({"commit": "abc", "campaigns": rows, "stopped": ["bus, seed 4: a lie"]}))
        self.assertIn("| **all** | 25 | 872.5 | 2,344 | 123.8 | 1 |", evidence.soak_text({"commit": "abc", "campaigns": rows}))

    def test_each_release_keeps_its_row(self):
        room = {"lines": [9, 10], "branches": [3, 4], "mcdc": [1, 2]}
        data = {"coverage": {"rooms": {"can": room, "canopen": room}}, "fuzzing": {"targets": {"a": {"executions": 7000}, "b": {"executions": 1}}},
                "corpora": {"a": {"files": 2, "bytes": 10}}, "soak": {"campaigns": [{"hours": 872.5, "faults": 2344}]},
                "cases": {"301": 197, "419": {"data": 99, "behaviour": 33}}, "response_times": [{"messages": 9369}, {"messages": 1}]}  # fmt: skip
        row = evidence.release_row(data)
        self.assertEqual(row, {"branches_canopen": 75.0, "branches": 75.0, "mcdc": 50.0, "fuzz_targets": 2, "fuzz_executions": 7001, "fuzz_seeds": 2,
                               "hours": 872.5, "faults": 2344, "response_times": 9370, "cases": 329})  # fmt: skip
        text = evidence.releases_text({"0.3.0": row, "0.2.0": {"cases": 100}})
        self.assertIn("| 0.3.0 | 75.0 | 75.0 | 50.0 | 2 | 7,001 | 2 | 872.5 | 2,344 | 9,370 | 329 |", text)
        self.assertIn("| 0.2.0 | - | - | - | - | - | - | - | - | - | 100 |", text)

    def test_what_is_behind_a_release_is_a_row_of_its_own(self):
        self.assertEqual(evidence.release_of("# Changelog\n\n## [Unreleased]\n\n### Added\n\n- More.\n\n## [0.2.0] - 2026-11-28\n"), "after 0.2.0")
        self.assertEqual(evidence.release_of("# Changelog\n\n## [Unreleased]\n\n## [0.3.0] - 2026-12-28\n\n## [0.2.0]\n"), "0.3.0")

    def test_what_was_not_measured_is_said_to_be_so(self):
        page = evidence.page_of({})
        self.assertEqual(page.lower().count("not measured"), 6, page)


if __name__ == "__main__":
    unittest.main()
