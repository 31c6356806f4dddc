#!/usr/bin/env python3
"""Each port of ports/ compiles against stub headers of its system, for a computer and a Cortex-M0+, and its sample does what a
node does: it boots, answers an SDO request, and obeys the NMT master.

    tests/ports/ports_test.py COMPILER ARCHIVE...    the archives of the libraries, the one that needs the others first

One of them is tried; with CANVOY_TESTS=all, all are.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SAMPLES = {
    "zephyr": "zephyr/sample/src/main.cpp",
    "freertos": "freertos/sample.cpp",
    "esp-idf": "esp-idf/sample/main/main.cpp",
    "platformio": "platformio/sample/src/main.cpp",
}
if os.environ.get("CANVOY_TESTS") != "all":
    SAMPLES = {"freertos": SAMPLES["freertos"]}
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"]
CROSS = "arm-none-eabi-g++"
# CiA 301: the boot-up message (7.2.8.3.3), the answer to an SDO upload of 2 bytes, 100 (7.2.4.3.6), a heartbeat of a node that is
# operational (7.2.8.3.2.2).
EXPECTED = ["709#00", "589#4B00200064000000", "709#05"]


def flags(port):
    folders = [ROOT, ROOT / "ports" / "common", ROOT / "ports" / port, HERE, HERE / "stubs" / port]
    return ["-std=c++20", "-fno-exceptions", "-fno-rtti", *WARNINGS, *(f"-I{folder}" for folder in folders)]


class Ports(unittest.TestCase):
    compiler, archives = "c++", []

    def test_each_sample_is_a_node(self):
        with tempfile.TemporaryDirectory() as folder:
            for port, sample in SAMPLES.items():
                with self.subTest(port):
                    program = pathlib.Path(folder) / port
                    part = pathlib.Path(folder) / f"{port}.o"
                    define = f"-DPORT_{port.upper().replace('-', '_')}"
                    rename = ["-Dmain=sample_main"] if port == "zephyr" else []
                    subprocess.run([self.compiler, *flags(port), *rename, "-c", ROOT / "ports" / sample, "-o", part], check=True)
                    subprocess.run([self.compiler, *flags(port), define, HERE / "harness.cpp", part, *self.archives, "-o", program], check=True)
                    said = subprocess.run([program], capture_output=True, text=True, timeout=60)
                    self.assertEqual((said.stdout.split(), said.returncode), (EXPECTED, 0))

    @unittest.skipIf(shutil.which(CROSS) is None, f"{CROSS} is missing")
    def test_each_sample_compiles_for_a_microcontroller(self):
        for port, sample in SAMPLES.items():
            with self.subTest(port):
                subprocess.run([CROSS, "-mcpu=cortex-m0plus", "-mthumb", "-fsyntax-only", "-fno-threadsafe-statics", "-DCANVOY_SMALL_MACHINE", *flags(port), ROOT / "ports" / sample],
                               check=True)  # fmt: skip


if __name__ == "__main__":
    Ports.compiler, *Ports.archives = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
