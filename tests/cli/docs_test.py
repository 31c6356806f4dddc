#!/usr/bin/env python3
"""The transcripts of README.md and docs are what the command prints, and their C++ compiles.

A block fenced as `console` is a transcript: a line that begins with `$ ` is a command, those below it are its output; a line of
`...` stands for any number of lines. What holds for a block stands in a comment on the line before its fence:

    <!-- bus: battery charger -->       these devices are on can0 meanwhile; another block of the page with the same ones goes on with them
    <!-- numbers vary -->               numbers and the blanks between columns are not compared (behind `bus: ...;` as well)
    <!-- file: acceptance.canvoy -->    the block is written into this file, for the blocks below it
    <!-- not run: REASON -->            it is counted, and no more

Blocks of a page run in one folder, in order. C++ with an `#include "canvoy` is compiled (-fsyntax-only); other pieces of
C++ are by tests/embed/samples_compile.

    CANVOY_APPROVE=1 CANVOY=build/canvoy python3 tests/cli/docs_test.py    writes outputs anew that differ: read what has changed
"""

import concurrent.futures
import contextlib
import dataclasses
import difflib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
README_LINES_MOST = 150
TIMED_OUT = 124  # exit status of timeout
SECONDS_MOST = 300  # of one command; the longest takes 2 s of a processor
BUS = "udp:239.74.163.2:43113"
FENCE = re.compile(r"^```(\S*)\s*$")
MARK = re.compile(r"^<!-- (.*) -->$")


@dataclasses.dataclass
class Block:
    """What stands between two fences."""

    page: pathlib.Path
    line: int  # of its first line, from 1
    language: str
    mark: str
    lines: list

    @property
    def place(self):
        return f"{self.page.relative_to(ROOT)}:{self.line}"

    @property
    def numbers_vary(self):
        return self.mark.endswith("numbers vary")

    @property
    def devices(self):
        return self.mark.removeprefix("bus:").partition(";")[0].split() if self.mark.startswith("bus:") else []


def blocks_of(page):
    """All fenced blocks of a page."""
    lines = page.read_text().splitlines()
    found, begin = [], None
    for number, line in enumerate(lines):
        fence = FENCE.match(line)
        if fence and begin is None:
            mark = MARK.match(lines[number - 1]) if number else None
            begin = number + 1
            found.append(Block(page, begin + 1, fence.group(1), mark.group(1) if mark else "", []))
        elif fence:
            begin = None
        elif begin is not None:
            found[-1].lines.append(line)
    return found


def commands_of(block):
    """The commands of a transcript, as they stand there, each with its output."""
    found = []
    for line in block.lines:
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found and not found[-1][1] and found[-1][0].endswith("\\"):
            found[-1] = (f"{found[-1][0]}\n{line}", [])
        elif found:
            found[-1][1].append(line)
    return found


def comparable(lines, numbers_vary):
    if not numbers_vary:
        return [line.rstrip() for line in lines]
    return [re.sub(r"\s+", " ", re.sub(r"\d+(\.\d+)?", "0", line)).strip() for line in lines]


def agrees(expected, actual):
    """Whether the output is as printed, with `...` for what was left out."""
    chunks, chunk = [], []
    for line in expected:
        if line.strip() == "...":
            chunks.append(chunk)
            chunk = []
        else:
            chunk.append(line)
    chunks.append(chunk)
    if len(chunks) == 1:
        return expected == actual
    first, *middle, last = chunks
    if len(first) + len(last) > len(actual) or actual[: len(first)] != first or (last and actual[-len(last) :] != last):
        return False
    place, end = len(first), len(actual) - len(last)
    for chunk in middle:
        while actual[place : place + len(chunk)] != chunk:
            place += 1
            if place + len(chunk) > end:
                return False
        place += len(chunk)
    return place <= end


def refit(expected, actual):
    """The output anew: whole, or where lines were left out, those that are still there, with `...` between what is apart."""
    if all(line.strip() != "..." for line in expected):
        return actual
    shape = [comparable([line], True)[0] for line in actual]
    found, place = [], 0
    for line in comparable([line for line in expected if line.strip() != "..."], True):
        at = next((i for i in range(place, len(shape)) if shape[i] == line), None)
        if at is None:
            continue
        found += (["..."] if at > place else []) + [actual[at]]
        place = at + 1
    return found + (["..."] if place < len(actual) else [])


class Page:
    """Plays the transcripts of one page, in a folder of its own."""

    def __init__(self, page, folder):
        self.page, self.folder = page, folder
        self.devices, self.process = None, None
        self.findings, self.left_out, self.played = [], [], 0

    def play(self):
        with contextlib.ExitStack() as stack:
            stack.callback(self.put_on_bus, [])
            for block in blocks_of(self.page):
                if block.mark.startswith("file:"):
                    (self.folder / block.mark.removeprefix("file:").strip()).write_text("\n".join(block.lines) + "\n")
                elif block.language == "console":
                    self.play_block(block)

    def play_block(self, block):
        if block.mark.startswith("not run:"):
            self.left_out.append(f"{block.place}: {block.mark.removeprefix('not run:').strip()}")
            return
        if block.devices:
            self.put_on_bus(block.devices)
        output, same = [], True
        for command, expected in commands_of(block):
            actual = self.shell(command)
            agreed = agrees(comparable(expected, block.numbers_vary), comparable(actual, block.numbers_vary))
            output += [*f"$ {command}".split("\n"), *(expected if agreed else refit(expected, actual))]
            same = same and agreed
            self.played += 1
        if not same:
            self.findings.append((block, output))

    def shell(self, command):
        """What a command prints, on both streams, with can0 for the bus."""
        line = re.sub(r"\bcan0\b", BUS, command)
        path = f"{self.folder.parent}/bin:{os.environ['PATH']}"
        done = subprocess.run(["timeout", str(SECONDS_MOST), "bash", "-c", line], cwd=self.folder, env=dict(os.environ, PATH=path), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)  # fmt: skip
        if done.returncode == TIMED_OUT:
            return [f"{command}: does not end"]
        return (done.stdout.replace(BUS, "can0") if line != command else done.stdout).splitlines()

    def put_on_bus(self, devices):
        if devices == self.devices:
            return
        if self.process:
            self.process.terminate()
            self.process.wait()
        self.devices, self.process = devices, None
        if not devices:
            return
        stores = [word for device in devices for word in ("--store", str(self.folder / f".{device}"))]
        self.process = subprocess.Popen([CANVOY, "device", *devices, BUS, *stores], stdout=subprocess.DEVNULL)
        for _ in range(200):
            if all(run("read", BUS, node, "1000", "--timeout", "100ms").returncode == DONE for node in self.nodes(devices)):
                break
            time.sleep(0.05)
        if "charger" in devices:  # it starts the network
            run("wait", BUS, "heartbeat and node=10 and not text=pre-operational within 10s")

    @staticmethod
    def nodes(devices):
        listed = run("device", "--list").stdout
        return [re.search(rf"(?m)^{device} .*? node +(\d+)", listed).group(1) for device in devices]


class Docs(unittest.TestCase):
    def test_the_readme_can_be_read(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text().splitlines()), README_LINES_MOST)

    def test_transcripts_are_what_the_command_prints(self):
        played, left_out = 0, []
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            (folder / "bin").mkdir()
            (folder / "bin" / "canvoy").symlink_to(pathlib.Path(CANVOY).resolve())
            for number, path in enumerate(PAGES):
                (folder / str(number)).mkdir()
                page = Page(path, folder / str(number))
                page.play()
                played += page.played
                left_out += page.left_out
                if os.environ.get("CANVOY_APPROVE"):
                    approve(page)
                for block, output in page.findings:
                    with self.subTest(block.place):
                        self.fail("\n" + "\n".join(difflib.unified_diff(block.lines, output, "printed", "now", lineterm="", n=1)))
        print(f"{played} commands were run; {len(left_out)} blocks are not run:", *left_out, sep="\n  ")
        self.assertGreater(played, 100)
        self.assertLess(len(left_out), played / 4)

    def test_the_picture_is_of_a_run(self):
        picture = ROOT / "docs" / "pictures" / "lift.svg"
        with tempfile.TemporaryDirectory() as temporary:
            drawn = pathlib.Path(temporary) / "lift.svg"
            subprocess.run([ROOT / "scripts" / "make-picture", CANVOY, drawn], check=True)
            if os.environ.get("CANVOY_APPROVE"):
                picture.write_text(drawn.read_text())
            self.assertTrue(picture.read_text() == drawn.read_text(), "scripts/make-picture draws another one")
            self.assertLess(drawn.stat().st_size, 200_000)

    def test_links_lead_somewhere(self):
        for path in [*PAGES, *ROOT.glob("*.md")]:
            text = re.sub(r"`[^`\n]*`", "", re.sub(r"(?ms)^```.*?^```", "", path.read_text()))
            for target, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)", text):
                with self.subTest(f"{path.relative_to(ROOT)}: {target}#{anchor}"):
                    if "://" in target:
                        continue
                    page = (path.parent / target).resolve() if target else path
                    self.assertTrue(page.exists())
                    if anchor:
                        self.assertIn(anchor, anchors_of(page))

    def test_the_site_has_every_page(self):
        named = set(re.findall(r"[\w/-]+\.md", (ROOT / "mkdocs.yml").read_text().partition("nav:")[2])) - {"reference/index.md"}
        named = {path for path in named if not path.startswith(("objects/", "cases/"))}  # made by scripts/
        self.assertEqual(named, {str(path.relative_to(ROOT / "docs")) for path in PAGES[1:]})

    def test_no_transcript_is_fenced_as_something_else(self):
        for path in PAGES:
            for block in blocks_of(path):
                with self.subTest(block.place):
                    if block.language != "console":
                        self.assertFalse([line for line in block.lines if line.startswith("$ ")], "fence it as console")
            with self.subTest(str(path)):
                self.assertNotRegex(path.read_text(), r"(?m)^    \$ ", "fence it as console")

    def test_each_verb_that_is_named_there_is(self):
        known = set(re.findall(r"(?m)^  ([a-z-]+) ", run("--help").stdout)) | {"man", "--version", "--help", "VERB"}
        for path in PAGES:
            for block in blocks_of(path):
                if block.language in ("sh", "console"):
                    named = set(re.findall(r"(?m)^(?:\$ )?(?:build/)?canvoy ([a-zA-Z-]+)", "\n".join(block.lines)))
                    with self.subTest(block.place):
                        self.assertEqual(named - known - {"raed", "frobnicate"}, set())

    def test_code_compiles(self):
        programs = [block for path in PAGES for block in blocks_of(path) if any('#include "canvoy' in line for line in block.lines)]
        self.assertTrue(any(block.page.name == "README.md" for block in programs))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for block, said in zip(programs, pool.map(compile_block, programs)):
                with self.subTest(block.place):
                    self.assertEqual(said, "")


def anchors_of(page):
    """The headings of a page, as links name them."""
    headings = re.findall(r"(?m)^#+ (.*)$", re.sub(r"(?ms)^```.*?^```", "", page.read_text()))
    return {re.sub(r"[^\w\- ]", "", re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading)).strip().lower().replace(" ", "-") for heading in headings}


def compile_block(block):
    """What the compiler says of a block of C++."""
    command = [os.environ.get("CXX", "c++"), "-std=c++20", "-Wall", "-Wextra", "-fsyntax-only", f"-I{ROOT}", f"-I{ROOT}/ports/common", "-xc++", "-"]
    return subprocess.run(command, input="\n".join(block.lines) + "\n", capture_output=True, text=True).stderr


def approve(page):
    """Writes the outputs that differ anew."""
    lines = page.page.read_text().splitlines()
    for block, output in reversed(page.findings):
        lines[block.line - 1 : block.line - 1 + len(block.lines)] = output
    page.page.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
