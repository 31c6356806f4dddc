#!/usr/bin/python3
"""python-can reads the logs that `canvoy convert-log` writes, and we read those that it writes: the same frames, one by
one.

    CANVOY=build/canvoy /usr/bin/python3 tests/strangers/traces/python_can_test.py

It has readers of candump logs, ASC, TRC, BLF, CSV and SQLite, none of pcapng; and writers of all of them, of which TRC, BLF and
CSV are ours to read only. MDF has a test of its own (mdf/mdf_test.py): it needs asammdf.
Without python-can, the test is skipped (77).
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time
import unittest

os.environ["TZ"] = "UTC"
time.tzset()

try:
    import can
except ImportError:
    can = None

CANVOY = os.environ.get("CANVOY", "build/canvoy")
START = 1_700_000_000
COUNT = 500


def convert(source, target):
    done = subprocess.run([CANVOY, "convert-log", source, target], capture_output=True, text=True, timeout=60, check=False)
    if done.returncode != 0 or f"{COUNT} frames" not in done.stdout or "; 0 lines" not in done.stdout:
        raise AssertionError(f"{source}: {done.stdout}{done.stderr}")


def random_frames(remote_share, remote_length_max):
    """Of a bus in which everything occurs: from a seed, the same each time. The first at a whole second, from which ASC
    counts."""
    chance = random.Random(447)
    for number in range(COUNT):
        extended = chance.random() < 0.3
        asks = chance.random() < remote_share
        length = chance.randint(0, remote_length_max if asks else 8)
        yield can.Message(
            timestamp=START + number * 0.001,
            arbitration_id=chance.getrandbits(29 if extended else 11),
            is_extended_id=extended,
            is_remote_frame=asks,
            dlc=length,
            data=None if asks else chance.randbytes(length),
            channel=0,
        )


def seen(message, start):
    """What has to be the same, with the time in microseconds from the first frame on."""
    return (
        round((message.timestamp - start) * 1e6),
        message.arbitration_id,
        message.is_extended_id,
        message.is_remote_frame,
        message.dlc,
        bytes(message.data),
    )


def all_seen(messages):
    messages = list(messages)
    return [seen(message, messages[0].timestamp) for message in messages]


class PythonCanTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def write(self, writer, remote_share=0.1, remote_length_max=8):
        messages = list(random_frames(remote_share, remote_length_max))
        for message in messages:
            writer.on_message_received(message)
        writer.stop()
        return all_seen(messages)

    def ours(self, name):
        """What we read, by way of a candump log that we write."""
        convert(self.path(name), self.path("ours.log"))
        return all_seen(can.CanutilsLogReader(self.path("ours.log")))

    def test_we_read_its_candump_logs(self):
        # Its candump writer leaves out what length a remote frame asks for.
        written = self.write(can.CanutilsLogWriter(self.path("theirs.log"), channel="can0"), remote_length_max=0)
        self.assertEqual(self.ours("theirs.log"), written)

    def test_we_read_its_asc(self):
        written = self.write(can.ASCWriter(self.path("theirs.asc")))
        self.assertEqual(self.ours("theirs.asc"), written)

    def test_we_read_its_trc(self):
        # Its TRC writer has no remote frames.
        written = self.write(can.TRCWriter(self.path("theirs.trc"), channel=1), remote_share=0)
        self.assertEqual(self.ours("theirs.trc"), written)

    def test_we_read_its_blf(self):
        for level in (0, 9):
            with self.subTest(compression=level):
                writer = can.BLFWriter(self.path("theirs.blf"), compression_level=level, max_container_size=4096)
                written = self.write(writer)
                self.assertEqual(self.ours("theirs.blf"), written)

    def test_we_read_its_csv(self):
        written = self.write(can.CSVWriter(self.path("theirs.csv")))
        self.assertEqual(self.ours("theirs.csv"), written)

    def test_we_read_its_sqlite(self):
        writer = can.SqliteWriter(self.path("theirs.db"))
        messages = list(random_frames(0.1, 8))
        for message in messages:
            writer.on_message_received(message)
        # Its thread is told to end whatever still waits.
        end = time.monotonic() + 30
        while writer.num_frames < COUNT and time.monotonic() < end:
            time.sleep(0.01)
        writer.stop()
        self.assertEqual(self.ours("theirs.db"), all_seen(messages))

    def test_it_reads_our_sqlite(self):
        written = self.write(can.ASCWriter(self.path("theirs.asc")))
        convert(self.path("theirs.asc"), self.path("ours.db"))
        self.assertEqual(all_seen(can.SqliteReader(self.path("ours.db"))), written)

    def test_we_read_what_gzip_made_of_its_logs(self):
        for kind, ending in ((can.BLFWriter, "blf"), (can.ASCWriter, "asc"), (can.CSVWriter, "csv")):
            with self.subTest(ending=ending):
                written = self.write(kind(self.path(f"theirs.{ending}")))
                subprocess.run(["gzip", self.path(f"theirs.{ending}")], check=True)
                self.assertEqual(self.ours(f"theirs.{ending}.gz"), written)

    def test_it_reads_our_asc(self):
        written = self.write(can.CanutilsLogWriter(self.path("theirs.log"), channel="can0"), remote_length_max=0)
        convert(self.path("theirs.log"), self.path("ours.asc"))
        self.assertEqual(all_seen(can.ASCReader(self.path("ours.asc"))), written)

    def test_it_reads_our_candump_logs_of_its_asc(self):
        written = self.write(can.ASCWriter(self.path("theirs.asc")))
        convert(self.path("theirs.asc"), self.path("again.log"))
        convert(self.path("again.log"), self.path("again.asc"))
        self.assertEqual(all_seen(can.CanutilsLogReader(self.path("again.log"))), written)
        self.assertEqual(all_seen(can.ASCReader(self.path("again.asc"))), written)


if __name__ == "__main__":
    if can is None:
        print("skipped: python-can is not installed")
        sys.exit(77)
    unittest.main()
