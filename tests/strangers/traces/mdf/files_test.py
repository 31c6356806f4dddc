#!/usr/bin/env python3
"""What asammdf and python-can have written as MDF 4 is read frame by frame. The files were made by make_files.py; mdf_test.py has
both at hand, and needs what `make mdf` installs.

    CANVOY=build/canvoy tests/strangers/traces/mdf/files_test.py
"""

import os
import pathlib
import subprocess
import unittest

from frames import frames, line

CANVOY = os.environ.get("CANVOY", "build/canvoy")
here = pathlib.Path(__file__).parent


class FilesTest(unittest.TestCase):
    def read(self, name):
        done = subprocess.run([CANVOY, "decode", here / name], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        others = [line for line in done.stderr.splitlines() if "no node has told its profile" not in line]
        self.assertEqual(others, [])
        return [" ".join(each.split()[:3]) for each in done.stdout.splitlines()]

    def test_each_frame_is_read(self):
        expected = [line(told) for told in frames()]
        for name in ("plain.mf4", "packed.mf4", "packed_in_columns.mf4"):
            with self.subTest(name):
                self.assertEqual(self.read(name), expected)


if __name__ == "__main__":
    unittest.main()
