#!/usr/bin/env python3
"""scripts/mutate on a small program: what it breaks, what it leaves alone, and its verdicts."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import script

script.load("mutate")
from mutation import one_by_one, places  # noqa: E402: script makes it known

SOURCE = """// a comment with a < b, 1 and true
#include <vector>

bool is_high(int level) {
  if (level < 0) return false;
  return level >= 10;  // "10" < 11
}
const char* name() { return "1 < 2 && true"; }
int unused(int a) { return a + 1; }
"""
TEST = """bool is_high(int);
const char* name();
int main() {
  return !is_high(9) && is_high(10) && !is_high(-1) && name()[0] == '1' ? 0 : 1;
}
"""
FOLDER = "canvoy/small"


class Mutate(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.tree = pathlib.Path(temporary.name)
        (self.tree / FOLDER).mkdir(parents=True)
        self.source = self.tree / FOLDER / "level.cpp"
        self.source.write_text(SOURCE)
        (self.tree / FOLDER / "level_test.cpp").write_text(TEST)

    def run_tool(self, *options):
        files = f"{FOLDER}/level.cpp {FOLDER}/level_test.cpp"
        return subprocess.run(
            [sys.executable, script.ROOT / "scripts" / "mutate", FOLDER, "--tree", self.tree,
             "--build", f"c++ -o program {files}", "--test", "./program", *options],
            capture_output=True, text=True, check=False,
        )  # fmt: skip

    def test_code_is_broken_and_comments_strings_and_includes_are_not(self):
        found = [(each.line + 1, each.kind, each.old, each.new) for each in places.mutations_of("level.cpp", SOURCE)]
        self.assertIn((5, "comparison", "<", "<="), found)
        self.assertIn((5, "bound", "0", "1"), found)
        self.assertIn((5, "toggle", "false", "true"), found)
        self.assertIn((5, "bound", "  if (level < 0) return false;", ";"), found)
        self.assertIn((6, "comparison", ">=", ">"), found)
        self.assertIn((9, "sum", "+", "-"), found)
        self.assertEqual({line for line, *_ in found}, {5, 6, 9})

    def test_timers_durations_flags_and_logic_are_broken_too(self):
        code = "  timers.arm(timer_, now + 100ms);\n  flags |= bit;\n  ready_ = x && !y;\n  mask = 0x80'00;\n"
        found = {(each.kind, each.old.strip(), each.new) for each in places.mutations_of("x.cpp", code)}
        self.assertTrue(
            found >= {
                ("timer", "100ms", "201ms"), ("timer", "timers.arm(timer_, now + 100ms);", ";"), ("flag", "|=", "&="),
                ("logic", "&&", "||"), ("toggle", "!", ""), ("flag", "ready_ = x && !y;", ";"), ("bound", "0x80'00", "0x8001"),
            }  # fmt: skip
        )

    def test_each_source_has_the_program_of_its_tests(self):
        for path, program in (
            ("canvoy/devices/cia419/charger.cpp", "folders/devices/canvoy_devices_test"),
            ("canvoy/canopen/lss/lss_slave.cpp", "folders/canopen/canvoy_canopen_test"),
            ("canvoy/canopen/host/file_flash.cpp", "folders/canopen/host/canvoy_canopen_host_test"),
            ("canvoy/can/host/socketcan.cpp", "folders/can/host/canvoy_host_test"),
        ):
            self.assertEqual(one_by_one.program_of(path), program)

    def test_a_seed_gives_the_same_places_and_another_one_others(self):
        first, again, other = (places.drawn(self.tree, [FOLDER], seed) for seed in (1, 1, 2))
        self.assertEqual(first, again)
        self.assertNotEqual(first, other)
        self.assertCountEqual(first, other)

    def test_it_says_killed_or_survived_and_restores_the_source(self):
        result = self.run_tool("--count", "100", "--at-least", "30")
        self.assertIn("level.cpp:6: comparison: >= -> >  [exit status 1]", result.stdout)
        self.assertIn("survived canvoy/small/level.cpp:9: sum: + -> -\n", result.stdout)
        self.assertIn("    +int unused(int a) { return a - 1; }", result.stdout)
        self.assertRegex(result.stdout, r"\n\d+ mutations: \d+ killed, \d+ survived \([\d.]+ % killed\)\n\Z")
        self.assertEqual((result.stderr, result.returncode), ("", 0))
        self.assertEqual(self.source.read_text(), SOURCE)

    def test_too_many_survivors_are_a_failure(self):
        self.assertEqual(self.run_tool("--count", "100").returncode, 1)

    def test_tests_that_fail_already_are_told(self):
        self.source.write_text(SOURCE.replace("10;", "11;"))
        result = self.run_tool()
        self.assertEqual(result.stderr, "mutate: the folder's tests fail as it is: exit status 1\n")
        self.assertEqual(result.returncode, 1)


if __name__ == "__main__":
    unittest.main()
