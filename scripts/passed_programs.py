"""Unit test programs, fuzz targets and tests of sources that are what they were when they passed: they would pass again.

    passed = PassedPrograms(presets.ROOT, presets.build_folder("check"), ("canopen", "formats"))
    passed.unchanged        # ["formats"]
    passed.note({"canopen": True})

A program is named as its tests are for ctest: `canopen` of canopen.part_0, `fuzz.filter_fuzz`. Tests that compile
sources themselves, and those of one world, are what the sources are that SOURCES names.
"""

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


def program_of(test):
    """The program of a test of ctest."""
    return test if test.startswith(FUZZ) or test in SOURCES else test.partition(".")[0]


def files_of(root, build, name):
    """The program, and all that it reads; none where it is not built."""
    if name in SOURCES:
        found = {path for pattern in SOURCES[name] for path in root.glob(pattern)}
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
    return hashlib.sha256(b"".join(hashlib.sha256(path.read_bytes()).digest() for path in files)).hexdigest()


class PassedPrograms:
    """Kept in passed.json of the build folder, by program: the content that has passed."""

    def __init__(self, root, build, programs):
        self.path = build / "passed.json"
        self.passed = json.loads(self.path.read_text()) if self.path.exists() else {}
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
