#!/usr/bin/env python3
"""Which sources tests/style/clang_tidy looks at again."""

import math
import pathlib
import shutil
import sys
import tempfile
import time
import unittest

import script

sys.path.insert(0, str(script.ROOT / "tests/style"))
clang_tidy = script.load("../tests/style/clang_tidy")

SOURCES = {
    "low.hpp": "",
    "middle.hpp": '#include "low.hpp"\n',
    "one.cpp": '#include "middle.hpp"\n',
    "two.cpp": '#include "low.hpp"\n',
    "three.cpp": "",
}


class ClangTidy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in SOURCES.items():
            (self.folder / name).write_text(text)
        self.arguments = [f"-I{self.folder}", "-std=c++20"]

    def concerned(self, *changed):
        commands = {self.folder / name: self.arguments for name in SOURCES if name.endswith(".cpp")}
        return {path.name for path in clang_tidy.concerned(commands, {self.folder / name for name in changed})}

    def test_what_has_changed_is_looked_at(self):
        self.assertEqual(self.concerned("two.cpp", "three.cpp"), {"two.cpp", "three.cpp"})
        self.assertEqual(self.concerned(), set())

    def test_of_a_header_one_source_that_includes_it(self):
        self.assertEqual(self.concerned("low.hpp"), {"one.cpp"})
        self.assertEqual(self.concerned("middle.hpp", "low.hpp"), {"one.cpp"})

    def test_a_source_that_has_changed_stands_for_its_headers(self):
        self.assertEqual(self.concerned("two.cpp", "low.hpp"), {"two.cpp"})
        self.assertEqual(self.concerned("two.cpp", "middle.hpp"), {"two.cpp", "one.cpp"})

    def test_a_header_that_is_gone_or_that_nobody_includes_is_none(self):
        (self.folder / "alone.hpp").write_text("")
        self.assertEqual(self.concerned("gone.hpp", "alone.hpp"), set())

    def test_what_differs_from_the_noted_contents_has_changed(self):
        clang_tidy.PASSED = self.folder / "passed"
        self.assertIsNone(clang_tidy.changed_files(), "nothing is noted")
        noted = clang_tidy.contents()
        self.assertGreater(len(noted), 1000)
        (self.folder / "passed").write_text("\n".join(noted))
        self.assertEqual(clang_tidy.changed_files(), set())
        (self.folder / "passed").write_text("\n".join(line for line in noted if ".clang-tidy" not in line))
        self.assertEqual(clang_tidy.changed_files(), {clang_tidy.ROOT / ".clang-tidy"})

    def test_what_was_clean_is_noted_with_its_headers_beside_what_was_noted_before(self):
        clang_tidy.PASSED = self.folder / "passed"
        arguments = [f"-I{clang_tidy.ROOT}"]
        sources = {path for path in (clang_tidy.ROOT / "canvoy/can").glob("*.cpp") if not path.name.endswith("_test.cpp")}
        first, second = sorted(sources)[:2]
        commands = dict.fromkeys(sources, arguments)
        for clean in (first, second):
            clang_tidy.record(commands, [clean])
        wanted = {clang_tidy.ROOT / ".clang-tidy"} | {path for each in (first, second) for path in clang_tidy.project_headers(each, arguments)}
        noted = {clang_tidy.ROOT / line.split(maxsplit=1)[1] for line in clang_tidy.PASSED.read_text().splitlines()}
        self.assertEqual(noted, wanted)
        self.assertEqual(clang_tidy.changed_files() & wanted, set())
        noted_before = clang_tidy.PASSED.read_text().replace("0", "1").replace("a", "b")
        clang_tidy.PASSED.write_text(noted_before)
        clang_tidy.record(commands, [first])
        self.assertNotIn(str(second.relative_to(clang_tidy.ROOT)), clang_tidy.PASSED.read_text(), "its contents have changed since")

    def test_a_clean_result_holds_as_long_as_all_that_it_rests_on(self):
        def mark():
            clang_tidy.included.cache_clear()
            return clang_tidy.content_hash(b"16", self.folder / "one.cpp", self.arguments)

        before = mark()
        self.assertEqual(before, mark())
        (self.folder / "two.cpp").write_text("int two();\n")
        self.assertEqual(before, mark())
        (self.folder / "low.hpp").write_text("int low();\n")
        self.assertNotEqual(before, mark())

    @unittest.skipUnless(shutil.which("clang-tidy-16"), "clang-tidy-16 is missing")
    def test_what_another_source_includes_is_missed_by_one_that_is_compiled_by_itself(self):
        clang_tidy.CACHE = self.folder
        (self.folder / "named.hpp").write_text("#pragma once\ninline int named() { return 1; }\n")
        sources = {self.folder / "first.cpp": '#include "named.hpp"\n', self.folder / "second.cpp": ""}
        for source, include in sources.items():
            source.write_text(f"{include}int {source.stem}() {{ return named(); }}\n")
        marks = {source: source.with_suffix(".clean") for source in sources}
        end_of_a_day = time.monotonic() + 60
        self.assertEqual(clang_tidy.Look(dict(marks), end_of_a_day, False)(list(sources), self.arguments), [])
        for mark in marks.values():
            mark.unlink()
        found = clang_tidy.Look(dict(marks), math.inf, True)(list(sources), self.arguments)
        self.assertEqual(len(found), 1)
        self.assertIn("second.cpp:1", found[0])
        self.assertEqual([mark.stem for mark in marks.values() if mark.exists()], ["first"])


if __name__ == "__main__":
    unittest.main()
