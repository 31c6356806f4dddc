"""Each drawn mutation in a build of its own, tried with the tests of its folder."""

import pathlib
import re
import resource
import shlex
import subprocess
import sys
import time

from mutation import places

MEMORY_MAX = 8 << 30  # bytes: a mutation may make a program take all there is


def suites_of(tree, folder):
    """The names of the suites in a folder's tests, as a filter of GoogleTest."""
    names = set()
    for path in sorted((tree / folder).rglob("*_test.cpp")):
        for macro, suite in re.findall(r"^(TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(\s*(\w+)", path.read_text(), re.MULTILINE):
            names.add(f"*/{suite}.*" if macro == "TEST_P" else f"{suite}.*")
    return ":".join(sorted(names))


def program_of(path):
    """Where the tests of a source are built: a library's, or those of its part that needs an operating system."""
    parts = pathlib.PurePath(path).parts
    library = parts[1]
    if parts[:3] == ("canvoy", "formats", "gtfs"):
        return "folders/formats/gtfs/canvoy_gtfs_test"
    if parts[2] != "host":
        return f"folders/{library}/canvoy_{library}_test"
    return f"folders/{library}/host/canvoy_{'host' if library == 'can' else library + '_host'}_test"


class Program:
    """How a folder is built and tested: as CMake has it, or by the user's own commands."""

    def __init__(self, tree, folders, options):
        self.tree = tree
        self.options = options
        if options.build:
            self.build_command, self.test_commands = shlex.split(options.build), [shlex.split(options.test)]
            return
        build = tree / "build"
        self.configure(build)
        sources = [str(path.relative_to(tree)) for folder in folders for path in places.sources_of(tree / folder)]
        programs = sorted({program_of(path) for path in sources})
        targets = [pathlib.PurePath(program).name for program in programs]
        self.build_command = ["ninja", "-C", str(build), "-j", str(options.jobs), *targets]
        only = options.filter or ":".join(suites_of(tree, folder) for folder in folders)
        self.test_commands = [
            [str(build / program), "--gtest_brief=1", "--gtest_fail_fast", f"--gtest_filter={only}"] for program in programs
        ]

    def configure(self, build):
        # The flags of the release, so that ccache has what is not mutated.
        command = ["cmake", "-S", str(self.tree), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"mutate: {result.stderr.strip()}")

    def build(self):
        return subprocess.run(self.build_command, cwd=self.tree, capture_output=True, text=True, check=False)

    def test(self, time_out, path=None):
        """Why the tests fail, or nothing; of the program that has the tests of `path`, or of all."""
        for command in self.test_commands:
            if path and not self.options.test and not command[0].endswith("/" + program_of(path)):
                continue
            try:
                result = subprocess.run(
                    command, cwd=self.tree, capture_output=True, text=True, errors="replace", timeout=time_out,
                    preexec_fn=limit_memory, check=False
                )  # fmt: skip
            except subprocess.TimeoutExpired:
                return "the time is over"
            if result.returncode != 0:
                failed = re.search(r"\[  FAILED  \] (\S+?)[,.]? ", result.stdout + " ")
                return failed.group(1) if failed else f"exit status {result.returncode}"
        return None


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_MAX, MEMORY_MAX))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def try_one(program, tree, mutation, time_out):
    """killed, survived or refused (by the compiler), and why."""
    path = tree / mutation.path
    before = path.read_text()
    try:
        path.write_text(mutation.apply(before))
        if program.build().returncode != 0:
            return "refused", ""
        reason = program.test(time_out, mutation.path)
        return ("killed", reason) if reason else ("survived", mutation.diff(before))
    finally:
        path.write_text(before)


def run(options, tree):
    program = Program(tree, options.folders, options)
    built = program.build()
    if built.returncode != 0:
        sys.exit(f"mutate: the folder does not build as it is:\n{(built.stdout + built.stderr)[-2000:]}")
    begin = time.monotonic()
    if reason := program.test(None):
        sys.exit(f"mutate: the folder's tests fail as it is: {reason}")
    time_out = 20 + 10 * (time.monotonic() - begin)
    drawn = places.drawn(tree, options.folders, options.seed)
    print(f"{len(drawn)} places in {' '.join(options.folders)}, seed {options.seed}", flush=True)
    counts = {"killed": 0, "survived": 0}
    for mutation in drawn[options.skip :]:
        if sum(counts.values()) == options.count:
            break
        verdict, reason = try_one(program, tree, mutation, time_out)
        if verdict == "refused":
            continue
        counts[verdict] += 1
        print(f"{verdict:9}{mutation}" + (f"  [{reason}]" if verdict == "killed" else f"\n{reason}"), flush=True)
    return counts
