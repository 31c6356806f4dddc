#!/usr/bin/env python3
"""Logs that are broken in the middle: cut off, with bytes changed, with parts of others in them. Whatever reads them tells
it and ends, with status 0 or 1, in little time and memory; what was whole before the break is still read."""

import gzip
import pathlib
import random
import resource
import subprocess
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, CommandTest, run

FORMATS = ("log", "asc", "pcapng")
FRAMES = 200


def frames():
    """Two buses, interleaved: SDO answers of node 10 with 6010h, of which the values count."""
    for i in range(FRAMES):
        yield f"({1700000000 + i / 100:017.6f}) can{i % 2} 58A#4B106000{i % 256:02X}000000\n"


class BrokenLogs(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        whole = cls.folder / "whole.log"
        whole.write_text("".join(frames()))
        cls.whole = {"log": whole.read_bytes()}
        for ending in FORMATS[1:]:
            path = cls.folder / f"whole.{ending}"
            if run("convert-log", str(whole), str(path)).returncode != DONE:
                raise AssertionError(ending)
            cls.whole[ending] = path.read_bytes()
        cls.whole["log.gz"] = gzip.compress(cls.whole["log"])

    def decode(self, content, name="broken.log"):
        """What the command says of it, under a limit of 512 MiB and 20 s."""
        path = self.folder / name
        path.write_bytes(content)
        limit = 512 * 1024 * 1024
        result = subprocess.run(
            [CANVOY, "decode", str(path), "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=20,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        self.assertIn(result.returncode, (DONE, FAILED), result.stderr)
        complaint = result.stderr.decode()
        self.assertFalse([sign for sign in complaint if ord(sign) < 32 and sign != "\n"], repr(complaint))
        return result

    def test_what_was_whole_before_the_end_is_read(self):
        for ending, content in self.whole.items():
            for share in (0.0, 0.01, 0.3, 0.5, 0.9, 0.999):
                result = self.decode(content[: int(len(content) * share)])
                lines = result.stdout.decode().splitlines()
                # Compressed, the last bytes are worth many frames.
                least = int(FRAMES * share * 0.9) - 20 if ending != "log.gz" else 0
                self.assertGreaterEqual(len(lines), least, (ending, share))
                if not lines:
                    self.assertEqual(result.returncode, FAILED, (ending, share))

    def test_changed_bytes_cost_no_more_than_what_they_are_in(self):
        chance = random.Random(18)
        for ending, content in self.whole.items():
            for _ in range(12):
                broken = bytearray(content)
                for _ in range(chance.choice((1, 5, 50))):
                    broken[chance.randrange(len(broken))] = chance.randrange(256)
                self.decode(bytes(broken))

    def test_a_text_log_goes_on_behind_what_is_broken(self):
        lines = self.whole["log"].splitlines(keepends=True)
        for wrong in (b"\0" * 5000, b"(1.0) can0 58A#4B10600\n", b"x" * 3_000_000 + b"\n", b"\x1b[2J\n", b"(nan) can0 1#\n", b"(1e99) can0 1#00\n",
                      b"(1.0) can0 FFFFFFFF#00\n", b"(1.0) can0 58A#001122334455667788\n", b"\xff\xfe\n", b"\r\n\r\n"):
            result = self.decode(b"".join(lines[:100]) + wrong + b"\n" + b"".join(lines[100:]))
            self.assertGreaterEqual(len(result.stdout.decode().splitlines()), FRAMES - 1, wrong[:30])

    def test_two_logs_in_one_file_are_read_as_far_as_they_are_of_one_kind(self):
        both = self.decode(self.whole["log"] + self.whole["asc"]).stdout.decode().splitlines()
        self.assertGreaterEqual(len(both), FRAMES)
        self.assertEqual(len(self.decode(self.whole["log"] + self.whole["log"]).stdout.decode().splitlines()), 2 * FRAMES)
        self.assertEqual(len(self.decode(self.whole["log.gz"] + self.whole["log.gz"], "twice.log.gz").stdout.decode().splitlines()), 2 * FRAMES)


if __name__ == "__main__":
    unittest.main()
