#!/usr/bin/env python3
"""canvoy record and replay, on a UDP bus of their own: what was sent is recorded, in any format and in parts, and sent again."""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUS = "udp:239.74.163.11:43121"
PATIENCE = 60  # seconds
LOG = "".join(f"(1700000000.{number * 1000:06}) can0 18A#{number:02X}000{number % 2}\n" for number in range(20)) + "(1700000000.900000) can0 185#01\n"


class Record(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.log = self.folder / "night.log"
        self.log.write_text(LOG)

    def record(self, name, *arguments, first=None):
        """Runs until it listens: the file is there."""
        path = self.folder / name
        program = subprocess.Popen([CANVOY, "record", BUS, str(path), *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.kill)
        give_up = time.monotonic() + PATIENCE
        while not (self.folder / (first or name)).exists():
            self.assertLess(time.monotonic(), give_up, "no file is made")
            self.assertIsNone(program.poll(), "it has ended")
            time.sleep(0.01)
        return program, path

    def frames(self, path):
        told = run("decode", str(path), "--json").stdout  # some PDOs are of nodes without a profile
        return [json.loads(line)["frame"] for line in told.splitlines()]

    def test_what_is_replayed_is_recorded_in_any_format(self):
        wanted = [line.split()[-1] for line in LOG.splitlines()]
        for name in ("a.log", "a.blf", "a.asc.gz"):
            with self.subTest(name):
                program, path = self.record(name, "--count", "21")
                told = self.assert_done(run("replay", str(self.log), BUS, "--speed", "0"))
                self.assertIn("21 frames sent, 0 left out", told)
                output, errors = program.communicate(timeout=PATIENCE)
                self.assertEqual((output, errors, program.returncode), (f"21 frames in {path}\n", "", DONE))
                self.assertEqual(self.frames(path), wanted)

    def test_a_part_ends_by_its_size_and_the_oldest_goes(self):
        program, _ = self.record("part.log", "--rotate", "100kB", "--keep", "2", "--count", "8400", first="part-001.log")
        # Of a burst, a busy machine loses frames: it goes on until all are recorded.
        replay = subprocess.Popen([CANVOY, "replay", str(self.log), BUS, "--speed", "0", "--loop", "1000000000"], stdout=subprocess.DEVNULL)
        self.addCleanup(replay.wait)
        self.addCleanup(replay.terminate)
        program.communicate(timeout=PATIENCE)
        parts = sorted(path.name for path in self.folder.glob("part-*.log"))
        self.assertEqual(len(parts), 2, parts)
        self.assertNotIn("part-001.log", parts)

    def test_a_replay_without_pauses_ends_when_it_is_told_to(self):
        witness, _ = self.record("begun.log", "--count", "1")
        replay = subprocess.Popen([CANVOY, "replay", str(self.log), BUS, "--speed", "0", "--loop", "1000000"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(replay.kill)
        witness.communicate(timeout=PATIENCE)
        replay.terminate()
        told, _ = replay.communicate(timeout=PATIENCE)
        self.assertRegex(told, r"^\d+ frames sent, 0 left out")
        self.assertEqual(replay.returncode, FAILED)

    def test_only_chosen_nodes_are_replayed(self):
        program, path = self.record("b.log", "--count", "1")
        told = json.loads(self.assert_done(run("replay", str(self.log), BUS, "--speed", "0", "--node", "5", "--json")))
        self.assertEqual((told["event"], told["sent"], told["left_out"]), ("replayed", 1, 20))
        program.communicate(timeout=PATIENCE)
        self.assertEqual(self.frames(path), ["185#01"])

    def test_times_are_kept(self):
        begun = time.monotonic()
        told = json.loads(self.assert_done(run("replay", str(self.log), BUS, "--speed", "2", "--json")))
        self.assertGreaterEqual(time.monotonic() - begun, 0.44)
        self.assertEqual(told["sent"], 21)

    def test_what_makes_no_sense_is_refused(self):
        self.assert_refused(run("record", BUS, "a.txt"), USAGE, "a.txt: its end says no format")
        self.assert_refused(run("record", BUS, "a.log", "--rotate", "0MB"), USAGE, "'0MB' is no size")
        self.assert_refused(run("record", BUS, "a.log", "--keep", "2"), USAGE, "--keep is for --rotate")
        self.assert_refused(run("replay", str(self.folder / "none.log"), BUS), FAILED, "No such file")


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
