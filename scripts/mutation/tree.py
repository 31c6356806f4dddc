"""A copy of the project in which sources are broken."""

import pathlib
import shutil
import subprocess


def is_needed(name, folders):
    """False for the tests of a library's other rooms: they would be compiled, and not run."""
    library = pathlib.PurePath(*pathlib.PurePath(name).parts[:2])
    rooms = [pathlib.PurePath(folder) for folder in folders if pathlib.PurePath(folder).is_relative_to(library)]
    is_other_test = name.endswith("_test.cpp") and len(library.parts) == 2
    return not (is_other_test and rooms and not any(pathlib.PurePath(name).is_relative_to(room) for room in rooms))


def copy_tree(root, tree, folders=()):
    """The files of the project as they stand here, without touching those that have not changed; of the tests, those of
    the folders where any are named."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=root, capture_output=True, check=True
    )
    wanted = {name for name in listed.stdout.decode().split("\0") if name and (root / name).is_file()}
    wanted = {name for name in wanted if is_needed(name, folders)}
    for path in list(tree.rglob("*")) if tree.exists() else []:
        name = str(path.relative_to(tree))
        if path.is_file() and not name.startswith("build/") and name not in wanted:
            path.unlink()
    for name in sorted(wanted):
        source, copy = root / name, tree / name
        if copy.exists() and copy.read_bytes() == source.read_bytes():
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, copy)
        shutil.copymode(source, copy)
