"""Where the presets of CMakePresets.json build: that file is the only one that knows.

    presets.build_folder("asan")  # .../build/asan
"""

import json
import pathlib

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
