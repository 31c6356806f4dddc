"""What the style tests have in common: the project's files, and how a test ends."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def skip(reason):
    """Ends the test as skipped."""
    print(f"skipped: {reason}")
    sys.exit(77)


def committed_files(*patterns):
    """The files that git knows and that still exist, relative to the root; patterns are git's, as '*.cpp'."""
    try:
        listed = subprocess.run(
            ["git", "ls-files", "-z", "--", *patterns], cwd=ROOT, capture_output=True, check=True
        ).stdout
    except (OSError, subprocess.CalledProcessError):
        skip("this is no git work tree, so there is no telling which files are the project's")
    paths = [pathlib.Path(name) for name in listed.decode().split("\0") if name]
    return [path for path in paths if (ROOT / path).is_file()]


def end(findings, advice):
    """Ends the test: prints each finding and what to do, or nothing."""
    for finding in findings:
        print(finding)
    if findings:
        print(advice)
    sys.exit(1 if findings else 0)
