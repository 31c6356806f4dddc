#!/usr/bin/env python3
"""What the pages have a newcomer do with an installed library, done as they say it: files are written, commands typed, outputs compared.

    tests/embed/newcomer_test.py PREFIX COMPILER

A page's blocks are taken in order. `file:` names the file that a block becomes, as in tests/cli/docs_test.py; beside that,

    <!-- newcomer: runs -->     the commands of this block are run to their end, which has to be a good one
    <!-- newcomer: stays -->    this command goes on, in a terminal of its own, until the next one that stays

Transcripts are played and compared, also those that docs_test.py leaves out for want of a compiled program.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
ROOT = TESTS.parent
sys.path += [str(TESTS), str(TESTS / "cli")]
import docs_test
import own_network

PREFIX, COMPILER = (pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]) if len(sys.argv) > 2 else (None, None)
BUS = docs_test.BUS
UP = re.compile(r"(?m)^\d+ nodes?$")


def environment():
    folders = os.pathsep.join([str(PREFIX / "bin"), os.environ["PATH"]])
    package_files = next(PREFIX.rglob("canvoy.pc")).parent
    return dict(os.environ, PATH=folders, CMAKE_PREFIX_PATH=str(PREFIX), CXX=COMPILER, CMAKE_GENERATOR="Ninja", PKG_CONFIG_PATH=str(package_files))


class Newcomer:
    """Somebody with a terminal or two in a folder, who does what a page says."""

    def __init__(self, test, folder):
        self.test, self.folder, self.other = test, folder, None
        test.addCleanup(self.interrupt)

    def interrupt(self):
        """Ctrl+C in the other terminal."""
        if self.other:
            self.other.terminate()
            self.other.wait()
        self.other = None

    def types(self, line):
        done = subprocess.run(["bash", "-c", line], cwd=self.folder, env=environment(), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=docs_test.SECONDS_MOST)  # fmt: skip
        return done.stdout, done.returncode

    def runs(self, line):
        said, status = self.types(line)
        self.test.assertEqual(status, 0, f"$ {line}\n{said[-3000:]}")
        return said

    def starts(self, line):
        """In the other terminal, in place of what runs there; goes on when it is a node of the bus."""
        self.interrupt()
        self.other = subprocess.Popen(shlex.split(line), cwd=self.folder, env=environment(), stdout=subprocess.DEVNULL)
        for _ in range(200):
            if UP.search(self.types(f"canvoy scan {BUS}")[0]):
                return
            time.sleep(0.05)
        self.test.fail(f"$ {line}\nis no node of the bus")

    def writes(self, block, name):
        (self.folder / name).write_text("\n".join(block.lines) + "\n")

    def plays(self, block):
        for command, expected in docs_test.commands_of(block):
            said = self.types(command)[0].splitlines()
            self.test.assertTrue(docs_test.agrees(docs_test.comparable(expected, False), docs_test.comparable(said, False)),
                                 f"{block.place}: $ {command}\nprinted: {expected}\nnow: {said}")  # fmt: skip

    def does(self, page):
        """All blocks of a page; the number of commands."""
        count = 0
        for block in docs_test.blocks_of(page):
            what, _, rest = block.mark.partition(":")
            if what == "file":
                self.writes(block, rest.strip())
            elif block.language == "console":
                self.plays(block)
                count += len(docs_test.commands_of(block))
            elif what == "newcomer":
                text = "\n".join(block.lines)
                self.starts(text) if rest.strip() == "stays" else self.runs(text)
                count += 1
        return count


def blocks(page, language, word):
    return [block for block in docs_test.blocks_of(ROOT / page) if block.language == language and any(word in line for line in block.lines)]


class NewcomerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.sut = Newcomer(self, self.folder)

    def test_the_first_device_and_its_data_sheet(self):
        self.assertGreater(self.sut.does(ROOT / "docs" / "tutorials" / "first-device.md"), 6)

    def test_own_objects_are_used_in_the_program(self):
        self.assertGreater(self.sut.does(ROOT / "docs" / "how-to" / "own-objects.md"), 4)

    def test_the_device_of_the_readme_is_linked_as_the_pages_say(self):
        [device] = blocks("README.md", "cpp", "int main")
        self.sut.writes(device, "my_device.cpp")
        for page in ("README.md", "docs/how-to/embed-the-library.md"):
            [lines] = blocks(page, "cmake", "find_package")
            told = [line for line in lines.lines if "add_subdirectory" not in line]
            at = next(i for i, line in enumerate(told) if line.startswith("target_link_libraries"))
            told.insert(at, "add_executable(my_device my_device.cpp)")
            text = "\n".join(["cmake_minimum_required(VERSION 3.22)", "project(mine LANGUAGES CXX)", *told])
            (self.folder / "CMakeLists.txt").write_text(text)
            with self.subTest(page):
                self.sut.runs("rm -rf build && cmake -S . -B build && cmake --build build")

    def test_the_device_of_the_readme_is_linked_by_pkg_config(self):
        [device] = blocks("README.md", "cpp", "int main")
        self.sut.writes(device, "my_device.cpp")
        [lines] = blocks("docs/how-to/embed-the-library.md", "sh", "pkg-config")
        self.sut.runs("\n".join(lines.lines))

    def test_the_workflow_has_what_its_last_commands_need(self):
        page = "docs/tutorials/test-bench.md"
        [acceptance] = [block for block in docs_test.blocks_of(ROOT / page) if block.mark == "file: acceptance.canvoy"]
        self.sut.writes(acceptance, "acceptance.canvoy")  # by the first checkout
        (self.folder / "canvoy" / "build").mkdir(parents=True)  # by the second one, and make
        (self.folder / "canvoy" / "build" / "canvoy").symlink_to(PREFIX / "bin" / "canvoy")
        [workflow] = blocks(page, "yaml", "acceptance.canvoy")
        text = "\n".join(workflow.lines)
        self.assertRegex(text, r"uses: actions/checkout@v4 +# your repository")
        commands = re.search(r"(?m)^ *- run: \|\n((?: {10}.*\n)+)", text + "\n").group(1)
        said = self.sut.runs(f"set -e\ntrap 'kill %1' EXIT\n{commands}")
        self.assertIn("7 of 7 lines passed", said)
        self.assertIn('failures="0"', (self.folder / "report.xml").read_text())


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main(argv=sys.argv[:1])
