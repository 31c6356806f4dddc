"""Compiles the application layer and a program for a Cortex-M0+, as a maker would: arm-none-eabi-g++ -Os."""

import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CROSS = "arm-none-eabi-"
FLAGS = ["-std=c++20", "-Os", "-mcpu=cortex-m0plus", "-mthumb", "-ffunction-sections", "-fdata-sections",
         "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics", "-Wno-psabi", "-DCANVOY_SMALL_MACHINE", f"-I{ROOT}"]
SHARED = "canvoy/canopen/node/node.hpp"
FEW = 8  # number of sources below which precompiling takes longer
LINK = ["--specs=nano.specs", "-nostartfiles", "-Wl,--gc-sections"]


def is_there():
    return shutil.which(f"{CROSS}g++") is not None


# Linked beside the library and the node: the board is empty, the memory functions are counted.
BESIDE = [HERE / "board.cpp", HERE / "memory.cpp"]


def library_sources(*folders):
    """What is compiled for a board of these folders of canvoy/."""
    return [path for folder in folders for path in sorted((ROOT / "canvoy" / folder).glob("**/*.cpp"))
            if not path.stem.endswith("_test") and "host" not in path.parts]


def seat_sources():
    """What an operator seat takes beside the application layer: nothing of it has a heap."""
    return [path for path in library_sources("devices/cia401", "devices/cia852") if path.stem != "kinds"]


def precompile(folder, flags):
    """The header that most sources include, compiled once for this folder; returns what makes the compiler take it."""
    header = folder / "shared.hpp"
    if not header.exists():
        header.write_text(f'#include "{SHARED}"\n')
        subprocess.run([f"{CROSS}g++", *FLAGS, *flags, "-x", "c++-header", header, "-o", f"{header}.gch"], check=True)
    return ["-include", header]


def compile_all(sources, folder, flags):
    """Compiles two at a time; returns the objects."""
    objects, running = [], []
    if len(sources) > FEW:
        flags = [*flags, *precompile(folder, flags)]
    for source in sources:
        objects.append(folder / f"{source.parent.name}-{source.stem}.o")
        running.append(subprocess.Popen([f"{CROSS}g++", *FLAGS, *flags, "-c", source, "-o", objects[-1]]))
        if len(running) == 2 and running.pop(0).wait() != 0:
            sys.exit(f"{source.name} does not compile for a Cortex-M0+")
    if any([process.wait() != 0 for process in running]):
        sys.exit("a source does not compile for a Cortex-M0+")
    return objects


def link(objects, program, flags, entry="main"):
    subprocess.run([f"{CROSS}g++", *FLAGS, *flags, *LINK, f"-Wl,-e,{entry}", *objects, "-o", program], check=True)


def read_symbols(program):
    """(size, kind, name) of each symbol."""
    listed = subprocess.run([f"{CROSS}nm", "-S", "-C", program], capture_output=True, text=True, check=True).stdout
    found = {}
    for line in listed.splitlines():
        match = re.match(r"([0-9a-f]{8}) ([0-9a-f]{8}) (\w) (.*)", line)
        if match:
            found[match[1], match[4]] = (int(match[2], 16), match[3].lower(), match[4])
    return list(found.values())


def read_sizes(program):
    """Bytes of text, data and bss."""
    output = subprocess.run([f"{CROSS}size", program], capture_output=True, text=True, check=True).stdout
    return [int(number) for number in output.splitlines()[1].split()[:3]]


def measure(program, own):
    """Bytes of code, tables, RAM and values of a node; `own` are the symbols of its program alone."""
    text, data, bss = read_sizes(program)
    tables, values = (sum(size for size, _, symbol in own if symbol.endswith(names))
                      for names in ((">::folded", ">::tables"), ("node_value_bytes",)))
    # Initialised data takes flash as well.
    return text + data - tables, tables, data + bss - values, values
