#!/usr/bin/env python3
"""MDF 4 in both directions against python-can and asammdf, on many random buses: what they write we read, what we write they
read.

    make mdf        # installs both into build/mdf/venv; SEEDS=20
"""

import os
import pathlib
import subprocess
import tempfile
import time
import unittest

os.environ["TZ"] = "UTC"
time.tzset()

import can  # noqa: E402
from frames import frames, line  # noqa: E402
from make_files import write  # noqa: E402

CANVOY = os.environ.get("CANVOY", "build/canvoy")
SEEDS = int(os.environ.get("SEEDS", "5"))


def run(*arguments):
    return subprocess.run([CANVOY, *arguments], capture_output=True, text=True, timeout=60, check=True).stdout


def seen(message, start):
    """What has to be the same; of python-can's two readers one says that it is not of CAN FD where the other says nothing."""
    return (
        round((message.timestamp - start) * 1e6),
        message.channel,
        message.arbitration_id,
        message.is_extended_id,
        message.is_remote_frame,
        message.is_error_frame,
        message.dlc,
        bytes(message.data),
        message.is_rx,
    )


class MdfTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_we_read_what_they_write(self):
        for seed in range(SEEDS):
            for level in range(3):
                with self.subTest(seed=seed, level=level):
                    told = list(frames(500, seed))
                    write(self.folder / "theirs.mf4", level, told)
                    lines = [" ".join(each.split()[:3]) for each in run("decode", self.folder / "theirs.mf4").splitlines()]
                    self.assertEqual(lines, [line(each) for each in told])

    def test_they_read_what_we_write(self):
        for seed in range(SEEDS):
            with self.subTest(seed=seed):
                told = [each for each in frames(500, seed) if not each.get("is_fd")]
                write(self.folder / "theirs.mf4", 0, told)
                run("convert-log", self.folder / "theirs.mf4", self.folder / "ours.mf4")
                ours = [seen(each, 0) for each in can.MF4Reader(self.folder / "ours.mf4")]
                expected = [seen(can.Message(**each), 0) for each in told]
                # Error frames have no direction with us.
                self.assertEqual([each[:-1] if each[5] else each for each in ours], [each[:-1] if each[5] else each for each in expected])


if __name__ == "__main__":
    unittest.main()
