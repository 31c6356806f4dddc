"""All drawn mutations in one build, each of which is on in runs of its own.

Each test program is run suite by suite without a mutation first: that tells which suites reach which mutation, and what
they take. A mutation is then tried with the suites that reach it, the quickest first, until one fails.
"""

import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import threading

import presets
from mutation import places, schemata

ROUNDS_MAX = 8
MEMORY_MAX = 8 << 30  # bytes: a mutation may make a program take all there is
TIMES_USUAL = 10  # what takes longer hangs
SECONDS_MIN = 2
# What is compiled anew takes half the time so. All else has the preset's flags, so that ccache has it.
QUICKLY = """function(canvoy_compile_quickly)
  foreach(library IN ITEMS LIBRARIES)
    target_compile_options(${library} PRIVATE -O1)
  endforeach()
endfunction()
cmake_language(DEFER CALL canvoy_compile_quickly)
"""


@dataclasses.dataclass
class Mutant:
    """A mutation that is in the build, by its number."""

    number: int
    mutation: places.Mutation
    edit: schemata.Edit
    line_text: str
    verdict: str = ""
    killer: str = ""
    suites: int = 0

    def as_json(self):
        return json.dumps(
            {"number": self.number, "verdict": self.verdict, "killer": self.killer, "suites": self.suites,
             "line_text": self.line_text, "mutation": dataclasses.asdict(self.mutation)}
        )  # fmt: skip


@dataclasses.dataclass
class Suite:
    """Tests that run in one process."""

    name: str
    command: tuple
    seconds: float = 0  # of a processor, without a mutation
    reaches: frozenset = frozenset()


class Schemata:
    """The sources of a tree, with the mutations in them that the compiler takes."""

    def __init__(self, tree, drawn, count):
        self.tree = tree
        self.numbers_max = min(len(drawn), 2 * count + 50)
        self.waiting = list(enumerate(drawn[: self.numbers_max], 1))[::-1]
        self.originals = {}
        self.mutants = []
        self.refused = 0
        self.left_out = 0
        self.memory = tree / "build" / "refused-mutations"
        self.known_refused = set(self.memory.read_text().splitlines()) if self.memory.exists() else set()
        (tree / schemata.HEADER).parent.mkdir(parents=True, exist_ok=True)
        write(tree / schemata.HEADER, schemata.HEADER_TEXT.replace("COUNT", str(self.numbers_max + 1)))

    def original(self, path):
        if path not in self.originals:
            self.originals[path] = (self.tree / path).read_text()
        return self.originals[path]

    def fill(self, count):
        """Takes the next of the drawn ones until there are so many."""
        while self.waiting and len(self.mutants) < count:
            number, mutation = self.waiting.pop()
            text = self.original(mutation.path)
            if key_of(mutation, text) in self.known_refused:
                self.refused += 1
                continue
            edit = schemata.edit_of(mutation, number, text)
            others = [mutant.edit for mutant in self.mutants if mutant.mutation.path == mutation.path]
            if edit is None or schemata.overlaps(edit, others):
                self.left_out += 1
                continue
            self.mutants.append(Mutant(number, mutation, edit, text.split("\n")[mutation.line]))

    def write(self):
        for path, text in self.originals.items():
            edits = [mutant.edit for mutant in self.mutants if mutant.mutation.path == path]
            write(self.tree / path, schemata.with_choices(text, edits) if edits else text)

    def take_out(self, output):
        """Takes out what the compiler complains of, and says whether there was any."""
        refused = refused_by(output, self.mutants, self.tree)
        self.refused += len(refused)
        self.memory.parent.mkdir(exist_ok=True)
        with open(self.memory, "a", encoding="utf-8") as file:
            file.writelines(f"{key_of(each.mutation, self.original(each.mutation.path))}\n" for each in refused)
        self.mutants = [mutant for mutant in self.mutants if mutant not in refused]
        return bool(refused)

    def restore(self):
        for path, text in self.originals.items():
            write(self.tree / path, text)
        (self.tree / schemata.HEADER).unlink(missing_ok=True)


def key_of(mutation, text):
    """By which the compiler's refusal is remembered: the next run does not compile a batch of sources for it in vain."""
    return f"{mutation.path}:{mutation.column}:{mutation.new.strip()}:{text.split(chr(10))[mutation.line].strip()}"


def write(path, text):
    """A file that is as it should be keeps its time, and what is made of it is not made anew."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def refused_by(output, mutants, tree):
    """Those whose lines the compiler's errors name; where an object's errors name none, those that anything names; and all
    of an object's sources where nothing does."""
    refused = []
    for failure in output.split("FAILED: ")[1:] or [output]:
        errors = "\n".join(line for line in failure.split("\n") if "error:" in line)
        found = named_in(errors, mutants) or named_in(failure, mutants)
        if not found:
            sources = sources_of_object(failure, tree)
            found = [mutant for mutant in mutants if mutant.mutation.path in sources]
        refused += [mutant for mutant in found if mutant not in refused]
    return refused


def named_in(text, mutants):
    lines = {(path, int(line) - 1) for path, line in re.findall(r"([\w./-]+\.cpp):(\d+)", text)}
    return [
        mutant
        for mutant in mutants
        for path, line in lines
        if path.endswith(mutant.mutation.path) and mutant.edit.first_line <= line <= mutant.edit.last_line
    ]


def sources_of_object(failure, tree):
    found = re.search(r"-c (\S+\.cxx|\S+\.cpp)", failure)
    if not found or not pathlib.Path(found.group(1)).exists():
        return set()
    batch = pathlib.Path(found.group(1))
    included = re.findall(r'#include "(.*\.cpp)"', batch.read_text()) or [str(batch)]
    return {os.path.relpath(source, tree) for source in included}


class Programs:
    """The project's unit test programs, as a preset builds them; or the user's own command."""

    def __init__(self, tree, options):
        self.tree = tree
        self.options = options
        if options.build:
            return
        self.folder = presets.build_folder(options.preset, tree)
        self.libraries = sorted({f"canvoy_{pathlib.PurePath(folder).parts[1]}" for folder in options.folders})
        self.folder.mkdir(parents=True, exist_ok=True)
        quickly = self.folder / "mutation.cmake"
        write(quickly, QUICKLY.replace("LIBRARIES", " ".join(self.libraries)))
        # What is otherwise in a small machine is tested in a program of its own, which compiles can and canopen once more.
        small = "ON" if {"canvoy_can", "canvoy_canopen"} & set(self.libraries) else "OFF"
        command = ["cmake", "--preset", options.preset, "--log-level=WARNING", "-DCANVOY_PROJECT_TESTS=OFF",
                   f"-DCANVOY_SMALL_MACHINE_TESTS={small}", f"-DCMAKE_PROJECT_INCLUDE={quickly}"]  # fmt: skip
        result = subprocess.run(command, cwd=tree, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"mutate: {result.stderr.strip()}")
        wanted = re.compile(options.programs)
        targets = self.ninja("-t", "targets", "all").stdout
        known = re.findall(r"^(folders/\S*/canvoy_\w+_test): CXX_EXECUTABLE_LINKER", targets, re.MULTILINE)
        self.programs = [program for program in sorted(known) if wanted.search(program)]
        if not self.programs:
            sys.exit(f"mutate: no test program is called {options.programs}")

    def ninja(self, *arguments):
        command = ["ninja", "-C", str(self.folder), *arguments]
        return subprocess.run(command, cwd=self.tree, capture_output=True, text=True, errors="replace", check=False)

    def build(self):
        """The libraries of the folders first: the compiler has something to say about them. Then what tests them."""
        if self.options.build:
            command = shlex.split(self.options.build)
            return subprocess.run(command, cwd=self.tree, capture_output=True, text=True, check=False)
        keep_going = ("-k", "0", "-j", str(self.options.jobs))
        result = self.ninja(*keep_going, *self.libraries)
        return self.ninja(*keep_going, *self.programs) if result.returncode == 0 else result

    def suites(self):
        if self.options.build:
            return [Suite("the tests", tuple(shlex.split(self.options.test)))]
        suites = []
        absent = presets.left_out_tests(self.folder)
        for program in self.programs:
            command = str(self.folder / program)
            without = absent.get(pathlib.PurePath(program).name, "")
            listed = subprocess.run([command, "--gtest_list_tests"], capture_output=True, text=True, check=True)
            names = re.findall(r"^(\w\S*\.)", listed.stdout, re.MULTILINE)
            arguments = ("--gtest_brief=1", "--gtest_fail_fast")
            suites += [Suite(name, (command, f"--gtest_filter={name}*{without}", *arguments)) for name in names]
        return suites


def run_suite(suite, tree, environment, seconds_max=None):
    """Why the suite fails, or nothing; and the seconds of a processor that it took."""
    limits = ["prlimit", f"--as={MEMORY_MAX}", "--core=0", *([f"--cpu={seconds_max}:{seconds_max + 1}"] if seconds_max else [])]
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(
            [*limits, *suite.command], cwd=tree, stdout=output, stderr=subprocess.STDOUT,
            env={**os.environ, "RC_PARAMS": "seed=301", **environment},
        )  # fmt: skip
        # What waits takes no time of a processor: the clock ends it, late enough for a machine that is busy.
        timer = threading.Timer(60 + 20 * (seconds_max or 600), process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        said = output.read().decode(errors="replace")
    seconds = usage.ru_utime + usage.ru_stime
    if process.returncode == 0:
        return None, seconds
    failed = re.search(r"\[  FAILED  \] (\S+?)[,.]? ", said + " ")
    why = failed.group(1) if failed else suite.name.rstrip(".")
    if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return f"{why}, the time is over", seconds
    return why if process.returncode == 1 else f"{why}, exit status {process.returncode}", seconds


def look(suite, tree):
    """Runs a suite without a mutation, and notes what it reaches and takes."""
    with tempfile.TemporaryDirectory() as folder:
        reached = pathlib.Path(folder) / "reached"
        reason, suite.seconds = run_suite(suite, tree, {"CANVOY_REACHED": str(reached)})
        if reason:
            return reason
        suite.reaches = frozenset(int(line) for line in reached.read_text().split()) if reached.exists() else frozenset()
    return None


def judge(mutant, suites, tree):
    """Runs the suites that reach a mutant, the quickest first, until one fails."""
    reaching = sorted((suite for suite in suites if mutant.number in suite.reaches), key=lambda suite: suite.seconds)
    mutant.suites = len(reaching)
    mutant.verdict = "survived" if reaching else "not reached"
    for suite in reaching:
        seconds_max = int(SECONDS_MIN + TIMES_USUAL * suite.seconds)
        reason, _ = run_suite(suite, tree, {"CANVOY_MUTANT": str(mutant.number)}, seconds_max)
        if reason:
            mutant.verdict, mutant.killer = "killed", reason
            return mutant
    return mutant


def drawn_again(tree, path):
    """The survivors that a results file has, where they stand in this tree."""
    found = []
    for result in map(json.loads, pathlib.Path(path).read_text().splitlines()):
        if result["verdict"] == "killed":
            continue
        mutation = places.Mutation(**result["mutation"])
        source = tree / mutation.path
        moved = places.moved(mutation, result["line_text"], source.read_text()) if source.exists() else None
        if moved is None:
            print(f"not here     {mutation}")
        else:
            found.append(moved)
    return found


def build(sources, programs, options):
    """Builds until the compiler takes all that is left. There are some more at first, in place of what it refuses: a batch
    of sources takes long to be compiled, and is not to be compiled again for another mutation."""
    sources.fill(options.count + options.count // 10)
    for _ in range(ROUNDS_MAX):
        sources.fill(options.count)
        sources.write()
        built = programs.build()
        if built.returncode == 0:
            del sources.mutants[options.count :]
            return
        output = built.stdout + built.stderr
        if not sources.take_out(output):
            errors = [line for line in output.splitlines() if "error:" in line] or output.splitlines()[-20:]
            sys.exit("mutate: the tests do not build:\n" + "\n".join(errors[:20]))
        print(f"the compiler has refused {sources.refused} so far", flush=True)
    sys.exit(f"mutate: after {ROUNDS_MAX} rounds, the compiler still refuses some; try another --seed")


def run(options, tree):
    if options.survivors_of:
        drawn = drawn_again(tree, options.survivors_of)
        options.count = len(drawn)
    else:
        drawn = places.drawn(tree, options.folders, options.seed)[options.skip :]
        print(f"{len(drawn)} places in {' '.join(options.folders)}, seed {options.seed}", flush=True)
    programs = Programs(tree, options)
    sources = Schemata(tree, drawn, options.count)
    try:
        build(sources, programs, options)
    finally:
        texts = dict(sources.originals)
        sources.restore()
    left_out = f"{sources.left_out} (constant, or within another)"
    print(f"{len(sources.mutants)} mutations are in; left out {left_out}, refused {sources.refused} by the compiler", flush=True)
    suites = programs.suites()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for suite, reason in zip(suites, pool.map(lambda suite: look(suite, tree), suites)):
            if reason:
                sys.exit(f"mutate: {reason} fails without a mutation already")
        seconds = sum(suite.seconds for suite in suites)
        print(f"{len(suites)} suites pass without a mutation, in {seconds:.0f} s of a processor", flush=True)
        for mutant in pool.map(lambda mutant: judge(mutant, suites, tree), sources.mutants):
            tell(mutant, texts[mutant.mutation.path])
            if options.results:
                with open(options.results, "a", encoding="utf-8") as file:
                    file.write(mutant.as_json() + "\n")
    killed = sum(mutant.verdict == "killed" for mutant in sources.mutants)
    return {"killed": killed, "survived": len(sources.mutants) - killed}


def tell(mutant, text):
    why = f"  [{mutant.killer}]" if mutant.killer else "\n" + mutant.mutation.diff(text)
    print(f"{mutant.verdict:12}{mutant.number:4} {mutant.mutation}{why}", flush=True)
