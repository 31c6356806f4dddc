#!/usr/bin/env python3
"""packaging/container/Containerfile installs the libraries that the command is linked with, by their packages of Debian 12."""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from command import CANVOY

CONTAINERFILE = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "container" / "Containerfile"
# Of an image of Debian: libc6 and what apt is linked with.
IN_EACH_IMAGE = {"libc6", "libgcc-s1", "libstdc++6"}
NEEDED = re.compile(r"\(NEEDED\).*\[(.+)\]")


def packages_of(library):
    """The packages that own a shared library; dpkg says `libfmt9:amd64: /usr/lib/x86_64-linux-gnu/libfmt.so.9`."""
    said = subprocess.run(["dpkg-query", "--search", f"*/{library}"], capture_output=True, text=True).stdout
    return {line.partition(":")[0] for line in said.splitlines()}


class Container(unittest.TestCase):
    def test_the_image_has_the_libraries_of_the_command(self):
        said = subprocess.run(["readelf", "-d", CANVOY], capture_output=True, text=True, check=True).stdout
        libraries = NEEDED.findall(said)
        self.assertIn("libc.so.6", libraries)
        last_stage = CONTAINERFILE.read_text().rpartition("\nFROM ")[2]
        installed = set(re.search(r"--no-install-recommends ([^\\]+)", last_stage).group(1).split()) | IN_EACH_IMAGE
        for library in libraries:
            with self.subTest(library):
                owners = packages_of(library)
                self.assertTrue(owners, "no package of this machine has it")
                self.assertTrue(owners & installed, f"the image needs one of {sorted(owners)}")


if __name__ == "__main__":
    for program in ("readelf", "dpkg-query"):
        if not shutil.which(program):
            print(f"skipped: {program} is missing")
            sys.exit(77)
    unittest.main()
