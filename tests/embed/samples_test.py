#!/usr/bin/env python3
"""What tests/embed/samples_compile takes for a sample, and for one that is wrong: against a few declarations in place of all headers."""

import importlib.machinery
import importlib.util
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import samples

loader = importlib.machinery.SourceFileLoader("samples_compile", str(HERE / "samples_compile"))
samples_compile = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
loader.exec_module(samples_compile)
COMPILER = next(filter(shutil.which, ("clang++-16", "clang++")), None)

HEADER = """// A counter of frames.
//
//     Counter counter({.limit = 5});
//     counter.add(frame);
//     if (counter.is_full()) ...
#pragma once

namespace canvoy {

/// How it counts.
///
///     Counter::add
struct Options { int limit; };
struct Counter {
  Counter(Options);
  void add(int);
  bool is_full();
};

}  // namespace canvoy
"""


class Small(samples_compile.Compiler):
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.flags = [COMPILER, "-std=c++20", "-w", "-ferror-limit=0", "-fno-spell-checking", "-fno-caret-diagnostics"]
        self.precompiled = self.folder / "all.pch"
        (self.folder / "all.hpp").write_text(HEADER)
        samples_compile.subprocess.run([*self.flags, "-x", "c++-header", self.folder / "all.hpp", "-o", self.precompiled], check=True)


class Samples(unittest.TestCase):
    def test_what_is_indented_in_comments_is_a_sample(self):
        found = samples.samples_of_header("x.hpp", HEADER)
        self.assertEqual([(each.line, each.text.splitlines()[0], each.namespace) for each in found],
                         [(3, "Counter counter({.limit = 5});", "canvoy"), (12, "Counter::add", "canvoy")])  # fmt: skip

    def test_pieces_of_a_page_are_samples_and_programs_are_not(self):
        page = "```cpp\nint x;\n```\n\n```cpp\n#include \"canvoy/x.hpp\"\n```\n"
        self.assertEqual([(each.line, each.text) for each in samples.samples_of_page("x.md", page)], [(2, "int x;")])

    def left(self, *texts):
        found = [samples.Sample("x.hpp", 10, text, "canvoy") for text in texts]
        with tempfile.TemporaryDirectory() as folder:
            return samples_compile.compile_all(Small(folder), found)

    @unittest.skipIf(COMPILER is None, "clang is missing")
    def test_names_that_it_does_not_declare_are_the_readers(self):
        self.assertEqual(self.left("Counter counter({.limit = 5});\ncounter.add(frame);\nif (counter.is_full()) ...", "Counter counter(options);\nshow(counter.is_full())",
                                   "struct Mine : Counter {\n  using Counter::Counter;\n};", ".limit = node.count()"), {})  # fmt: skip

    @unittest.skipIf(COMPILER is None, "clang is missing")
    def test_what_the_library_does_not_have_is_found(self):
        left = self.left("Counter counter({.limit = 5});\ncounter.subtract(frame);", "Counter counter({.bound = 5});", "Teller teller;", "counter.add(frame;")
        self.assertEqual(sorted(left), [0, 1, 2, 3])
        self.assertIn("subtract", left[0][0][1])
        self.assertEqual(left[0][0][0], 11)

    @unittest.skipIf(COMPILER is None, "clang is missing")
    def test_a_sample_is_what_stands_in_a_function_or_in_a_class(self):
        self.assertEqual(self.left("struct Mine {\n  static constexpr int limit = 5;\n};\n\nCounter counter({.limit = Mine::limit});",
                                   "if (ended) return fail(error);\ncounter.each([](int frame) { show(frame); });",
                                   "int frame = first_of(frame);", "void told() { show(frame); }", "Options options = {.limit = 5, ...};",
                                   "time[Mine{}] = read.now();"), {})  # fmt: skip
        self.assertEqual(sorted(self.left("struct Mine {\n  Counter counter{bound()};\n};\n\nCounter::substract(5);", "return Counter().add(5);")), [0, 1])

    @unittest.skipIf(COMPILER is None, "clang is missing")
    def test_a_compiler_that_fails_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            small = Small(folder)
            small.precompiled.write_text("no header")
            with self.assertRaises(SystemExit):
                small.errors_of("int x;")


if __name__ == "__main__":
    unittest.main()
