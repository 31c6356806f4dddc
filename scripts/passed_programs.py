"""Unit test programs, fuzz targets and tests of sources that are what they were when they passed: they would pass again.

    passed = PassedPrograms(presets.ROOT, presets.build_folder("check"), ("canopen", "formats"))
    passed.unchanged        # ["formats"]
    passed.note({"canopen": True})

A program is named as its tests are for ctest: `canopen` of canopen.part_0, `fuzz.filter_fuzz`. Tests that compile
sources themselves, and those of one world, are what the sources are that SOURCES names.
"""

import functools
import hashlib
import json

# What a program reads, beside what is compiled into it.
DATA = {"profiles": "canvoy/profiles/clauses", "formats": "tests/sheets"}
FUZZ = "fuzz."
WORLDS = "worlds_"
# The folders of devices that each world has, beside the kit: what another profile's devices do, its tests do not reach.
DEVICES_OF = {
    "bus_line": ("cia407", "cia447"), "charger": ("cia418", "cia419"), "excavator": ("cia401", "cia852"), "lift": ("cia417",),
    "police": ("cia447",), "taxi": ("cia447",),
}  # fmt: skip
# What a test reads that compiles sources of the project itself.
HEADERS = tuple(f"canvoy/{library}/**/*.hpp" for library in ("can", "canopen", "profiles", "devices"))
NODE = (*HEADERS, "canvoy/can/**/*.cpp", "canvoy/canopen/**/*.cpp", "canvoy/profiles/**/*.cpp")
SOURCES = {
    "embed.wrong_descriptions": (*HEADERS, "tests/embed/wrong_descriptions"),
    "embed.add_subdirectory": (*NODE, "CMakeLists.txt", "canvoy/**/CMakeLists.txt", "cmake/*", "tests/embed/build_consumer", "tests/embed/consumer/*"),
    "embed.fits_a_cortex_m0": (
        *NODE, "canvoy/devices/cia401/**/*.cpp", "canvoy/devices/cia852/**/*.cpp", "bench/size/*", "ports/common/*",
        "examples/cortex_m/*", "tests/embed/fits_a_cortex_m0"),
}  # fmt: skip
# What the tests of one world read: all libraries below the devices with their headers, and what is its own.
BELOW = ("CMakePresets.json", "cmake/*", "canvoy/*/**/*.hpp", *(f"canvoy/{library}/**/*.cpp" for library in ("can", "canopen", "profiles", "formats", "sim")))
SOURCES |= {
    f"{WORLDS}{world}": (
        *BELOW, *(f"canvoy/devices/{folder}/**/*.cpp" for folder in ("kit", *profiles)), f"canvoy/worlds/{world}/**/*",
        "canvoy/worlds/*.cpp", "canvoy/worlds/car/*", "canvoy/devices/*.cpp")
    for world, profiles in DEVICES_OF.items()
}  # fmt: skip
# Tests of the command in which no devices run but those of these worlds (a battery is one of the charger's), and their files.
TESTS_OF = {
    (): {
        "strangers.socketcan": ("socketcan_test.cpp",), "strangers.sdo": ("sdo",), "strangers.services": ("services",), "strangers.nmt": ("nmt",),
        "strangers.pdo": ("pdo",), "strangers.storage": ("storage",), "strangers.boot": ("boot",), "strangers.gateway": ("gateway",),
        "strangers.lss": ("lss",), "strangers.tshark_lss": ("lss", "tshark_agrees"), "strangers.candump_error_frames": ("error_frames",),
        "strangers.traces": ("traces",), "strangers.python_can_traces": ("traces",), "strangers.frame_bits": ("frame_bits",)},
    ("charger",): {
        "strangers.controllers": ("controllers",), "strangers.socketcand": ("socketcand_test.py",), "strangers.check_canopen_python": ("check",),
        "strangers.check_node_canopen": ("check",),
        "cli.run_charger": (), "cli.run_yard": (), "strangers.charging": ("charging", "in_machine"), "strangers.tshark_charging": ("charging", "tshark_agrees")},
    ("lift",): {
        "cli.run_lift": (), "cli.run_lift_parts": (), "strangers.lift": ("lift", "in_machine"), "strangers.lift_units": ("lift",),
        "strangers.lift_drive": ("lift_drive",), "strangers.lift_panel": ("lift_panel",), "strangers.doors": ("doors",)},
    ("taxi", "police"): {
        "cli.run_taxi": (), "cli.run_police": (), "cli.run_car_parts": (), "cli.car_objects": (), "strangers.car": ("car",),
        "strangers.car_socketcan": ("car", "in_machine"), "strangers.car_processes": ("car",), "strangers.car_conformance": ("car",),
        "strangers.taxi": ("taxi",)},
    ("excavator", "charger"): {"cli.operator": ()},
    ("bus_line",): {
        "cli.run_bus": (), "cli.bus_objects": (), "strangers.bus": ("bus", "in_machine"), "strangers.bus_processes": ("bus",)},
    ("excavator",): {
        "cli.run_excavator": (), "cli.operator_objects": (), "strangers.operator": ("operator", "in_machine"),
        "strangers.operator_processes": ("operator",)},
}  # fmt: skip


def sources_of_test(worlds, name, own):
    """All but the devices and worlds that it does not reach, and unit tests; without `own` files, it stands in tests/cli."""
    devices = {folder for world in worlds for folder in DEVICES_OF[world]}
    others = {folder for folders in DEVICES_OF.values() for folder in folders} - devices
    absent = [f"!canvoy/devices/{folder}/**/*.cpp" for folder in sorted(others)]
    absent += [f"!canvoy/worlds/{world}/**/*.cpp" for world in sorted({*DEVICES_OF} - {*worlds})]
    kind, _, stem = name.partition(".")
    tests = [f"tests/strangers/{each}{end}" for each in own for end in ("", "/*")] or [f"tests/{kind}/{stem}_test.py", "tests/cli/command.py"]
    common = ("CMakeLists.txt", "CMakePresets.json", "cmake/*", "tests/*.py", "tests/strangers/*", "canvoy/**/*.[ch]pp", "!canvoy/**/*_test.cpp")
    return (*common, *absent, *tests)


SOURCES |= {test: sources_of_test(worlds, test, own) for worlds, tests in TESTS_OF.items() for test, own in tests.items()}


@functools.cache
def glob(root, pattern):
    return frozenset(root.glob(pattern))


@functools.cache
def digest_of(path):
    return hashlib.sha256(path.read_bytes()).digest()


def program_of(test):
    """The program of a test of ctest."""
    return test if test.startswith(FUZZ) or test in SOURCES else test.partition(".")[0]


def files_of(root, build, name):
    """The program, and all that it reads; none where it is not built."""
    if name in SOURCES:
        found = {path for pattern in SOURCES[name] if pattern[0] != "!" for path in glob(root, pattern)}
        found -= {path for pattern in SOURCES[name] if pattern[0] == "!" for path in glob(root, pattern[1:])}
        return sorted(path for path in found if path.is_file() and (not path.name.endswith("_test.cpp") or name.startswith(WORLDS)))
    if name.startswith(FUZZ):
        target = name.removeprefix(FUZZ)
        programs, data = [build / target], f"fuzz/corpus/{target}"
    else:
        file = f"canvoy_{name}_test"
        programs, data = [*build.glob(f"folders/*/{file}"), *build.glob(f"folders/*/*/{file}")], DATA.get(name)
    programs = [path for path in programs if path.is_file()]
    return programs + (sorted(path for path in (root / data).rglob("*") if path.is_file()) if programs and data else [])


def content_of(files):
    """A hash of files; none of no files."""
    if not files:
        return None
    return hashlib.sha256(b"".join(map(digest_of, files))).hexdigest()


class PassedPrograms:
    """Kept in passed.json of the build folder, by program: the content that has passed."""

    def __init__(self, root, build, programs):
        self.path = build / "passed.json"
        self.passed = json.loads(self.path.read_text()) if self.path.exists() else {}
        for kept in (glob, digest_of):
            kept.cache_clear()  # of what the files were before
        self.now = {name: content_of(files_of(root, build, name)) for name in programs}

    @property
    def unchanged(self):
        return [name for name, content in self.now.items() if content and self.passed.get(name) == content]

    def note(self, have_passed):
        """Keeps or forgets the programs whose tests were run."""
        for name, has_passed in have_passed.items():
            self.passed.pop(name, None)
            if has_passed and self.now[name]:
                self.passed[name] = self.now[name]
        self.path.write_text(json.dumps(self.passed))
