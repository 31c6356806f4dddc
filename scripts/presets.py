"""Where the presets of CMakePresets.json build, and how ctest runs what is there: those files are the only ones that know.

    presets.build_folder("asan")  # .../build/asan
    presets.left_out_tests(folder)  # {"canvoy_small_machine_test": "-DictionaryChanges.*"}
"""

import json
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def build_folder(name, root=ROOT):
    """The folder of a configure preset; KeyError where there is none of this name."""
    known = {each["name"]: each for each in json.loads((root / "CMakePresets.json").read_text())["configurePresets"]}
    folder = _inherited(known, name, "binaryDir")
    return pathlib.Path(folder.replace("${sourceDir}", str(root)).replace("${presetName}", name))


def _inherited(known, name, key):
    """What a preset says, or the first of those that it inherits from."""
    preset = known[name]
    if key in preset:
        return preset[key]
    parents = preset.get("inherits", [])
    for parent in [parents] if isinstance(parents, str) else parents:
        found = _inherited(known, parent, key)
        if found is not None:
            return found
    return None


def left_out_tests(folder):
    """Of each unit test program the negative filter of GoogleTest with which ctest runs it, where it has one."""
    listed = subprocess.run(["ctest", "--test-dir", str(folder), "--show-only=json-v1"], capture_output=True, text=True, check=True)
    return filters_of(json.loads(listed.stdout))


def filters_of(tests):
    """The same of what ctest tells as JSON."""
    found = {}
    for command in (test.get("command", []) for test in tests["tests"]):
        programs = [pathlib.PurePath(word).name for word in command if word.endswith("_test")]
        filters = [match[1] for match in (re.match(r"--gtest_filter=(-.+)", word) for word in command) if match]
        if programs and filters:
            found[programs[0]] = filters[0]
    return found
