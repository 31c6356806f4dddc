#!/usr/bin/env python3
"""pyarrow reads the table of values that `canvoy decode --parquet` writes: what `--csv` prints of the same log, with types.

    CANVOY=build/canvoy tests/strangers/with_python tests/strangers/traces/parquet_test.py
"""

import csv
import datetime
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import pyarrow
    import pyarrow.parquet
except ImportError:
    pyarrow = None

CANVOY = os.environ.get("CANVOY", "build/canvoy")
COUNT = 70_000  # more than a group of rows has


def run(*arguments):
    return subprocess.run([CANVOY, *arguments], capture_output=True, text=True, timeout=120, check=False)


class ParquetTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def log(self, lines):
        path = self.folder / "a.log"
        path.write_text("".join(lines))
        return path

    def table(self, log, *arguments):
        done = run("decode", log, "--parquet", self.folder / "a.parquet", *arguments)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        return pyarrow.parquet.read_table(self.folder / "a.parquet")

    def rows_of_csv(self, log, *arguments):
        return list(csv.DictReader(io.StringIO(run("decode", log, "--csv", *arguments).stdout)))

    def test_it_has_what_csv_has(self):
        log = self.log(f"({1_700_000_000 + n // 1000}.{n % 1000:03}250) can{n % 2} 18A#{n % 250:02X}00{n % 3:02X}\n" for n in range(COUNT // 2))
        rows = self.rows_of_csv(log, "--node", "10=418")
        table = self.table(log, "--node", "10=418")
        self.assertGreater(len(rows), COUNT - 1)
        self.assertEqual(table.num_rows, len(rows))
        columns = {name: table.column(name).to_pylist() for name in table.column_names}
        for name, csv_name in (("bus", "bus"), ("index", "index"), ("sub", "sub"), ("name", "name"), ("text", "value")):
            self.assertEqual(columns[name], [row[csv_name] for row in rows], name)
        self.assertEqual(columns["node"], [int(row["node"]) for row in rows])
        self.assertEqual(columns["unit"], [row["unit"] or None for row in rows])
        self.assertEqual([f"{time.timestamp():.6f}" for time in columns["time"]], [row["time"] for row in rows])
        temperatures = [(value, row["value"]) for value, row in zip(columns["value"], rows) if row["name"] == "temperature"]
        self.assertEqual(len(temperatures), COUNT // 2)
        self.assertTrue(all(number == float(text) for number, text in temperatures))
        states = {value for value, row in zip(columns["value"], rows) if row["name"] != "temperature" and not row["value"][0].isdigit()}
        self.assertEqual(states, {None})

    def test_its_columns_have_types(self):
        table = self.table(self.log(["(1700000000.000125) can0 18A#A00001\n"]), "--node", "10=418")
        self.assertEqual(table.schema.field("time").type, pyarrow.timestamp("us", tz="UTC"))
        self.assertEqual(table.schema.field("value").type, pyarrow.float64())
        self.assertEqual(table.schema.field("node").type, pyarrow.int32())
        self.assertFalse(table.schema.field("time").nullable)
        self.assertTrue(table.schema.field("unit").nullable)
        first = table.column("time")[0].as_py()
        self.assertEqual(first, datetime.datetime(2023, 11, 14, 22, 13, 20, 125, tzinfo=datetime.timezone.utc))

    def test_without_values_it_is_an_empty_table(self):
        table = self.table(self.log(["(1700000000.000000) can0 70A#05\n"]))
        self.assertEqual((table.num_rows, len(table.column_names)), (0, 9))

    def test_what_cannot_be_written_is_said(self):
        log = self.log(["(1700000000.000000) can0 70A#05\n"])
        self.assertEqual(run("decode", log, "--parquet", "/nowhere/a.parquet").returncode, 1)
        self.assertEqual(run("decode", log, "--parquet", log).returncode, 2)
        self.assertEqual(log.read_text(), "(1700000000.000000) can0 70A#05\n")


if __name__ == "__main__":
    if pyarrow is None:
        print("skipped: pyarrow is missing; scripts/install-packages test installs it")
        sys.exit(77)
    unittest.main()
