"""Tests that wait for devices in real time, all at a time: each has a bus of its own, and none waits for another.

    BUSES = side_by_side.buses("udp:239.74.163.22", 43122)
    ... setUp: self.bus = next(BUSES)

    def load_tests(loader, tests, pattern):
        return side_by_side.Suite(tests)
"""

import concurrent.futures
import itertools
import unittest


def buses(group, first_port):
    """Buses of one multicast group, told apart by their ports."""
    return (f"{group}:{port}" for port in itertools.count(first_port, 10))


def tests_of(suite):
    for test in suite:
        yield from tests_of(test) if isinstance(test, unittest.TestSuite) else (test,)


class Suite(unittest.TestSuite):
    """Runs its tests in threads. What is set up for a class or a module is not run."""

    def run(self, result, debug=False):
        tests = list(tests_of(self))
        with concurrent.futures.ThreadPoolExecutor(len(tests)) as pool:
            for job in [pool.submit(test, result) for test in tests]:
                job.result()
        return result
