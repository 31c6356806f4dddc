"""A network for one test: nothing but a loopback interface that carries multicast. Needs root.

    own_network.enter_or_skip()

As a program it runs another one there: `python3 tests/own_network.py COMMAND...`.
"""

import ctypes
import os
import shutil
import subprocess
import sys

CLONE_NEWNET = 0x40000000


def skip(reason):
    """Ends the whole test as skipped."""
    print(f"skipped: {reason}")
    sys.exit(77)


def enter_or_skip():
    """Moves this process, and the programs that it starts from then on, into a network of their own."""
    if shutil.which("ip") is None:
        skip("iproute2 is missing; scripts/install-packages test installs it")
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNET) != 0:
        skip(f"a network of its own needs root: {os.strerror(ctypes.get_errno())}")
    raise_loopback()


def raise_loopback():
    """Also where a test has taken it down."""
    subprocess.run(["ip", "link", "set", "lo", "up", "multicast", "on"], check=True)
    subprocess.run(["ip", "route", "add", "224.0.0.0/4", "dev", "lo"], check=True)


if __name__ == "__main__":
    enter_or_skip()
    os.execvp(sys.argv[1], sys.argv[1:])
