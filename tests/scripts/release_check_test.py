#!/usr/bin/env python3
"""What scripts/release-check refuses."""

import contextlib
import datetime
import io
import json
import pathlib
import tempfile
import unittest
from unittest import mock

import script

release_check = script.load("release-check")
import release_facts

TODAY = datetime.date(2026, 11, 28)
GOOD = """# Changelog\n\n## [Unreleased]\n\n## [0.2.0] - 2026-11-28\n\n### Added\n\n- All of it.\n"""


class ReleaseFacts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(canvoy VERSION 0.2.0 LANGUAGES CXX)\n")
        for path in (*release_facts.PLACES_OF_STATUS, *release_facts.MINOR_COPIES):
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text("find_package(canvoy 0.2 CONFIG)\n")

    def changelog(self, text):
        (self.root / "CHANGELOG.md").write_text(text)
        return release_facts.changelog_findings(self.root, TODAY)

    def test_a_changelog_of_this_release_is_good(self):
        self.assertEqual(self.changelog(GOOD), [])

    def test_lines_under_unreleased_are_refused(self):
        self.assertIn("[Unreleased]", self.changelog(GOOD.replace("ed]\n", "ed]\n\n### Added\n\n- More.\n", 1))[0])

    def test_a_release_without_a_date_or_of_tomorrow_is_refused(self):
        self.assertIn("2026-11-29", self.changelog(GOOD.replace("11-28", "11-29"))[0])
        self.assertIn("soon", self.changelog(GOOD.replace("2026-11-28", "soon"))[0])
        self.assertIn("heading", self.changelog(GOOD.replace(" - 2026-11-28", ""))[0])

    def test_another_version_is_told_with_its_file(self):
        for path, text in {
            "CHANGELOG.md": GOOD,
            "debian/changelog": "canvoy (0.2.0) unstable; urgency=medium\n",
            "packaging/vcpkg/ports/canvoy/vcpkg.json": '{"version": "0.2.0"}',
            "library.json": '{"version": "0.1.9"}',
            "ports/esp-idf/idf_component.yml": "description: x\n",
        }.items():
            (self.root / path).parent.mkdir(parents=True, exist_ok=True)
            (self.root / path).write_text(text)
        self.assertEqual(
            release_facts.wrong_copies(self.root),
            ["library.json: names 0.1.9, expected 0.2.0", "ports/esp-idf/idf_component.yml: names no version, expected 0.2.0"],
        )

    def test_a_page_that_says_that_nothing_is_released_is_refused(self):
        self.assertEqual(release_facts.stale_status(self.root), [])
        (self.root / "SECURITY.md").write_text("Nothing has been released yet: fixes go to main.")
        self.assertEqual(release_facts.stale_status(self.root), ["SECURITY.md: says 'Nothing has been released'"])

    def report(self, **changes):
        report = {"commit": "c0ffee", "changed": False, "passed": 9, "failed": 0, "unsteady": 0, "skipped": []} | changes
        (self.root / "test-all.json").write_text(json.dumps(report))
        return release_facts.report_findings(self.root, "c0ffee", self.root)

    def test_tests_have_to_have_passed_at_this_commit(self):
        self.assertEqual(release_facts.report_findings(self.root, "c0ffee", self.root), ["make test-all has not been run here"])
        self.assertEqual(self.report(), [])
        self.assertIn("was run at", self.report(commit="decade")[0])
        self.assertIn("not committed", self.report(changed=True)[0])
        self.assertIn("1 failed", self.report(failed=1)[0])
        self.assertIn("1 failed once", self.report(unsteady=1)[0])
        self.assertIn("0 passed", self.report(passed=0)[0])
        self.assertIn("node is missing", self.report(skipped=["x: node is missing"])[0])


class ReleaseCheck(unittest.TestCase):
    def run_steps(self, *checks, only=()):
        steps = tuple(release_check.Step(f"step{number}", "", check) for number, check in enumerate(checks))
        said = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(said), mock.patch.object(release_check, "STEPS", steps), \
                mock.patch.object(release_check, "LOGS", pathlib.Path(folder)), \
                mock.patch("sys.argv", ["release-check", *(["--only", ",".join(only)] if only else [])]):  # fmt: skip
            return release_check.main(), said.getvalue()

    def refuse(self, _):
        raise release_check.Refused("one\ntwo")

    def test_all_steps_have_to_pass(self):
        self.assertEqual(self.run_steps(lambda log: "good")[0], 0)
        status, said = self.run_steps(lambda log: "good", self.refuse, lambda log: "good as well")
        self.assertEqual(status, 1)
        self.assertRegex(said, r"(?s)PASS  step0 .*FAIL  step1 +one\n +two.*PASS  step2 .*not to be released")

    def test_a_part_is_no_release(self):
        status, said = self.run_steps(lambda log: "good", self.refuse, only=["step0"])
        self.assertEqual(status, 1)
        self.assertNotIn("step1", said)

    def test_a_step_that_is_not_there_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "'step7' is no step: say step0"):
            self.run_steps(lambda log: "good", only=["step7"])

    def test_a_command_that_fails_or_is_missing_is_refused(self):
        with tempfile.NamedTemporaryFile("w") as log:
            with self.assertRaisesRegex(release_check.Refused, "false ended with 1"):
                release_check.run(["false"], log)
            with self.assertRaisesRegex(release_check.Refused, "is missing"):
                release_check.run(["no-such-program-here"], log)


if __name__ == "__main__":
    unittest.main()
