"""What tests took: each appends a line to test-times.tsv of its build folder (cmake/CanvoyTimedTest.cmake).

    test_times.by_kind(test_times.read(presets.build_folder("asan")))["canopen"].processor
"""

import collections
import dataclasses
import pathlib


@dataclasses.dataclass
class Times:
    """Of some tests: how many, seconds by the clock and of processors."""

    count: int = 0
    clock: float = 0.0
    processor: float = 0.0

    def __iadd__(self, other):
        self.count += other.count
        self.clock += other.clock
        self.processor += other.processor
        return self


def path_in(folder):
    return pathlib.Path(folder) / "test-times.tsv"


def read(folder):
    """Of each test that ran in a build folder, its last run."""
    path = path_in(folder)
    lines = path.read_text().splitlines() if path.exists() else []
    rows = (line.split("\t") for line in lines)
    return {name: Times(1, float(clock), float(user) + float(system)) for clock, user, system, name in rows}


def by_kind(times):
    """The sum of each kind of test, which is what its name says before the first dot."""
    kinds = collections.defaultdict(Times)
    for name, each in times.items():
        kinds[name.partition(".")[0]] += each
    return dict(sorted(kinds.items()))
