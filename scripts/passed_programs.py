"""Unit test programs that are what they were when they passed: they would pass again.

    passed = PassedPrograms(presets.ROOT, presets.build_folder("check"), ("canopen", "formats"))
    passed.unchanged        # ["formats"]
    passed.note({"canopen": True})
"""

import hashlib
import json

# What the tests of a library read, beside what is compiled into them.
DATA = {"profiles": "canvoy/profiles/clauses", "formats": "tests/sheets"}


def content_of(program, data):
    """A hash of a program and the files of the folders that it reads."""
    files = [program, *(path for folder in data for path in sorted(folder.rglob("*")) if path.is_file())]
    return hashlib.sha256(b"".join(hashlib.sha256(path.read_bytes()).digest() for path in files)).hexdigest()


class PassedPrograms:
    """Kept in passed.json of the build folder, by library: the content that has passed."""

    def __init__(self, root, build, libraries):
        self.path = build / "passed.json"
        self.passed = json.loads(self.path.read_text()) if self.path.exists() else {}
        self.now = {
            name: content_of(build / "folders" / name / f"canvoy_{name}_test", [root / DATA[name]] if name in DATA else [])
            for name in libraries
        }

    @property
    def unchanged(self):
        return [name for name, content in self.now.items() if self.passed.get(name) == content]

    def note(self, have_passed):
        """Keeps or forgets the libraries whose tests were run."""
        for name, has_passed in have_passed.items():
            self.passed.pop(name, None)
            if has_passed:
                self.passed[name] = self.now[name]
        self.path.write_text(json.dumps(self.passed))
