#!/usr/bin/env python3
"""Makes the files beside this, by python-can and asammdf: plain, compressed, and compressed in columns.

    build/mdf/venv/bin/python tests/strangers/traces/mdf/make_files.py

`scripts/install-packages mdf` makes the environment. Times of creation are in the files: they differ each time.
"""

import datetime
import os
import pathlib
import time

os.environ["TZ"] = "UTC"
time.tzset()

import can  # noqa: E402
from frames import START, frames  # noqa: E402

here = pathlib.Path(__file__).parent


def write(path, level, told):
    writer = can.MF4Writer(path, compression_level=level)
    writer._mdf.header.start_time = datetime.datetime.fromtimestamp(START)  # pylint: disable=protected-access
    writer._start_time = START  # pylint: disable=protected-access
    for each in told:
        writer.on_message_received(can.Message(**each))
    writer.stop()


if __name__ == "__main__":
    for level, name in ((0, "plain"), (1, "packed"), (2, "packed_in_columns")):
        write(here / f"{name}.mf4", level, frames())
