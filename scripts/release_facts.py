"""What a release says of itself, wherever it stands: read by scripts/release-check.

Each function takes the root of the project and returns findings, a line each; none where all is well.
"""

import datetime
import json
import re

# Where the version of CMakeLists.txt stands a second time, since another tool reads it there: a pattern whose group is the version.
COPIES = {
    "CHANGELOG.md": r"(?m)^## \[(\d[^\]]*)\]",
    "debian/changelog": r"\Acanvoy \(([^)]+)\)",
    "packaging/vcpkg/ports/canvoy/vcpkg.json": r'"version": "([^"]+)"',
    "library.json": r'"version": "([^"]+)"',
    "ports/esp-idf/idf_component.yml": r'(?m)^version: "([^"]+)"',
}
# Where its first two numbers stand.
MINOR_COPIES = {
    "README.md": r"find_package\(canvoy ([\d.]+)",
    "docs/stability.md": r"find_package\(canvoy ([\d.]+)",
    "docs/tutorials/first-device.md": r"find_package\(canvoy ([\d.]+)",
}
PLACES_OF_STATUS = ("README.md", "SECURITY.md", "docs/index.md", "docs/stability.md", "CHANGELOG.md")


def version_of(root):
    """The version of the project, which stands in CMakeLists.txt."""
    return re.search(r"(?m)^project\(canvoy VERSION (\d+\.\d+\.\d+)", (root / "CMakeLists.txt").read_text())[1]


def wrong_copies(root):
    """Files that name another version than CMakeLists.txt, or none."""
    version = version_of(root)
    wanted = {path: (pattern, version) for path, pattern in COPIES.items()}
    wanted |= {path: (pattern, version.rpartition(".")[0]) for path, pattern in MINOR_COPIES.items()}
    findings = []
    for path, (pattern, expected) in wanted.items():
        found = re.search(pattern, (root / path).read_text()) if (root / path).exists() else None
        if not found or found[1] != expected:
            findings.append(f"{path}: names {found[1] if found else 'no version'}, expected {expected}")
    return findings


def changelog_findings(root, today):
    """Whether the changelog is that of a release: nothing under Unreleased, and the newest release with a date that has come."""
    text = (root / "CHANGELOG.md").read_text()
    unreleased = re.search(r"(?ms)^## \[Unreleased\]\n(.*?)(?=^## \[|\Z)", text)
    findings = []
    if not unreleased:
        findings.append("CHANGELOG.md: has no section [Unreleased]")
    elif re.search(r"(?m)^- ", unreleased[1]):
        findings.append("CHANGELOG.md: lines stand under [Unreleased]: move them to the release")
    newest = re.search(r"(?m)^## \[(\d[^\]]*)\] - (\S+)$", text)
    if not newest:
        findings.append("CHANGELOG.md: no release has a heading `## [VERSION] - YYYY-MM-DD`")
    elif not is_past_date(newest[2], today):
        findings.append(f"CHANGELOG.md: {newest[1]} is dated {newest[2]}: give the day of the release as YYYY-MM-DD")
    return findings


def is_past_date(text, today):
    try:
        return datetime.date.fromisoformat(text) <= today
    except ValueError:
        return False


def stale_status(root):
    """Pages that say that nothing is released."""
    said = re.compile(r"(?i)nothing has been released|no release yet|before the first release")
    return [f"{path}: says '{said.search((root / path).read_text())[0]}'" for path in PLACES_OF_STATUS if said.search((root / path).read_text())]


def report_findings(root, commit, folder):
    """Whether `make test-all` has passed at this commit: it leaves a report of what it ran."""
    path = folder / "test-all.json"
    if not path.exists():
        return ["make test-all has not been run here"]
    report = json.loads(path.read_text())
    findings = [] if report["commit"] == commit else [f"make test-all was run at {report['commit'][:12]}, not at {commit[:12]}"]
    if report["changed"]:
        findings.append("make test-all was run with changes that are not committed")
    if report["failed"] or not report["passed"]:
        findings.append(f"make test-all: {report['passed']} passed, {report['failed']} failed")
    if report["unsteady"]:
        findings.append(f"make test-all: {report['unsteady']} failed once, and passed when run again")
    return findings + [f"make test-all: skipped {line}" for line in report["skipped"]]
