#!/usr/bin/env python3
"""scripts/mutate --at-once: how a place becomes a choice, and the verdicts on a small program."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import script

script.load("mutate")
from mutation import at_once, places, schemata  # noqa: E402: script makes it known

FOLDER = "canvoy/small"
SOURCE = """#include <cstdlib>
bool is_high(int level) {
  return level >= 10;
}
int tries(int wanted) {
  int count = 0;
  while (count != wanted) count += 1;
  return count;
}
int table[2] = {};
int twice(int value) { return value + value; }
bool is_far(int value) { return value == 77; }
void end() { std::exit(0); }
"""
TEST = """bool is_high(int);
int tries(int);
int twice(int);
int main() {
  twice(1);
  return is_high(11) && tries(3) == 3 ? 0 : 1;
}
"""
# A statement, what stands in its place, and the first of what is broken in it.
CHOICES = (
    ("return a + b * c < d && e;", "<", "return (canvoy_mutant(7) ? (a + b * c <= d) : (a + b * c < d)) && e;"),
    ("return a < b && c || d;", "||", "return (canvoy_mutant(7) ? (a < b && c && d) : (a < b && c || d));"),
    ("if (x) total += a ? b : c;", "+=", "if (x) (canvoy_mutant(7) ? (total -= a ? b : c) : (total += a ? b : c));"),
    ("const int x = f(a - b, {c}) - d - e;", "- e", "const int x = (canvoy_mutant(7) ? (f(a - b, {c}) - d + e) : (f(a - b, {c}) - d - e));"),
    ("f(\"a, (b\" + c, d);", "+", "f((canvoy_mutant(7) ? (\"a, (b\" - c) : (\"a, (b\" + c)), d);"),
    ("if (!a.b(c, d) && e) return;", "!", "if ((canvoy_mutant(7) ? (a.b(c, d)) : (!a.b(c, d))) && e) return;"),
    ("g(std::min<int>(a, b), c);", "std::min", "g((canvoy_mutant(7) ? (std::max<int>(a, b)) : (std::min<int>(a, b))), c);"),
    ("x = 0x10U << y;", "0x10", "x = (canvoy_mutant(7) ? (0x11U) : (0x10U)) << y;"),
    ("x = 2.5;", "2", "x = (canvoy_mutant(7) ? (3.5) : (2.5));"),
    ("wait(100ms);", "100ms", "wait((canvoy_mutant(7) ? (201ms) : (100ms)));"),
    ("is_on_ = now;", "is_on_ = now;", "if (!canvoy_mutant(7)) { is_on_ = now; }"),
    ("return a ||  // why\n  b;", "||", "return (canvoy_mutant(7) ? (a && b) : (a ||  // why\n  b));"),
    ("if constexpr (a) { return b < c; }", "<", "if constexpr (a) { return (canvoy_mutant(7) ? (b <= c) : (b < c)); }"),
    ("if constexpr (b < c) return;", "<", None),
    ("constexpr int f() { return g({1, 2}, 3); }", "3", None),
    ("constexpr Row rows[] = {{1, 2}, {3, 4}};", "4", None),
    ("consteval int f() { return 4; }", "4", None),
)  # fmt: skip


class Choices(unittest.TestCase):
    def test_each_place_becomes_a_choice_of_the_whole_expression(self):
        for code, old, expected in CHOICES:
            with self.subTest(code=code, old=old):
                column = code.index(old)
                kinds = places.mutations_of_line(places.without_comments(code.split("\n")[0], literal=" "))
                _, at, old, new = next(found for found in kinds if found[1] == column)
                edit = schemata.edit_of(places.Mutation("x.cpp", 0, at, "", old, new), 7, code)
                whole = schemata.with_choices(code, [edit]).split("\n", 2)[2] if edit else None
                self.assertEqual(whole, expected)

    def test_the_compiler_names_what_it_refuses(self):
        def mutant(path, line):
            place = places.Mutation(path, line - 1, 0, "", "", "")
            return at_once.Mutant(line, place, schemata.Edit(0, 0, "", line - 1, line), "")

        mutants = [mutant("canvoy/a.cpp", 4), mutant("canvoy/a.cpp", 30), mutant("canvoy/b.cpp", 4)]
        for output, lines in (
            ("FAILED: x.o\n/t/canvoy/a.cpp:5:1: error: no\n/t/canvoy/a.cpp:30:1: note: x", [4]),
            ("FAILED: x.o\nx.hpp:5:1: error: no\n/t/canvoy/a.cpp:30:1: required", [30]),
            ("FAILED: x.o\nx.hpp:5:1: error: no", []),
        ):
            refused = at_once.refused_by(output, mutants, pathlib.Path("/t"))
            self.assertEqual([each.number for each in refused if each.mutation.path == "canvoy/a.cpp"], lines)

    def test_a_place_is_found_where_its_line_has_moved(self):
        place = places.Mutation("x.cpp", 1, 2, "toggle", "true", "false")
        self.assertEqual(places.moved(place, "b true", "a\n\n\nb true\n").line, 3)
        self.assertIsNone(places.moved(place, "b true", "a\n\n\nb false\n"))


class AtOnce(unittest.TestCase):
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
            [sys.executable, script.ROOT / "scripts" / "mutate", FOLDER, "--at-once", "--tree", self.tree,
             "--build", f"c++ -std=c++20 -O1 -I. -o program {files}", "--test", "./program", *options],
            capture_output=True, text=True, check=False,
        )  # fmt: skip

    def test_it_says_killed_survived_or_not_reached_and_restores_the_source(self):
        results = self.tree / "results"
        result = self.run_tool("--count", "100", "--results", results, "--at-least", "10")
        self.assertEqual((result.stderr, result.returncode), ("", 0))
        self.assertRegex(result.stdout, r"\nkilled +\d+ canvoy/small/level.cpp:7: comparison: != -> ==  \[the tests\]\n")
        self.assertRegex(result.stdout, r"level.cpp:7: bound: 1 -> 2  \[the tests, the time is over\]\n")
        self.assertRegex(result.stdout, r"\nsurvived +\d+ canvoy/small/level.cpp:3: comparison: >= -> >\n")
        self.assertIn("    +  return level > 10;", result.stdout)
        self.assertRegex(result.stdout, r"\nnot reached +\d+ canvoy/small/level.cpp:12: comparison: == -> !=\n")
        self.assertIn(", refused 1 by the compiler\n", result.stdout)
        self.assertNotIn("level.cpp:10: bound: 2 -> 3", result.stdout)
        self.assertEqual(self.source.read_text(), SOURCE)
        self.assertEqual(list((self.tree / "canvoy").rglob("*.hpp")), [])

        self.assertIn("\nthe compiler has refused 1 so far\n", result.stdout)

        # What is refused once is not compiled again. The survivors alone, with a test that sees one of them, and a line more above it.
        self.source.write_text("\n" + SOURCE)
        test = self.tree / FOLDER / "level_test.cpp"
        test.write_text(TEST.replace("is_high(11)", "is_high(10)"))
        survivors = [json.loads(line) for line in results.read_text().splitlines()]
        survivors = [each for each in survivors if each["verdict"] != "killed"]
        result = self.run_tool("--survivors-of", results)
        self.assertNotIn("the compiler has refused", result.stdout)
        self.assertRegex(result.stdout, r"\nkilled +\d+ canvoy/small/level.cpp:4: comparison: >= -> >  \[the tests\]\n")
        self.assertRegex(result.stdout, rf"\n{len(survivors)} mutations: \d killed, \d survived ")
        self.assertEqual(result.returncode, 1)

    def test_tests_that_fail_already_are_told(self):
        self.source.write_text(SOURCE.replace("10;", "12;"))
        result = self.run_tool()
        self.assertEqual(result.stderr, "mutate: the tests fails without a mutation already\n")
        self.assertEqual(result.returncode, 1)


if __name__ == "__main__":
    unittest.main()
