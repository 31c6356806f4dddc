#!/usr/bin/env python3
"""What scripts/run-tests makes of the cases that ctest reports."""

import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree as xml

import script

run_tests = script.load("run-tests")
passed_programs = sys.modules["passed_programs"]
ROOT = run_tests.presets.ROOT


def included_by(folder):
    """All headers of the project that sources of a folder include, and what implements these; but what the catalogue makes
    by a name is not included."""
    waiting = [path.relative_to(ROOT) for path in folder.rglob("*.[ch]pp")]
    found = set()
    while waiting:
        path = waiting.pop()
        if path in found or path.name.startswith("catalogue.") or not (ROOT / path).exists():
            continue
        found.add(path)
        waiting += [pathlib.Path(each) for each in re.findall(r'^#include "(canvoy/[^"]+)"', (ROOT / path).read_text(), re.MULTILINE)]
        waiting += [path.with_suffix(".cpp")] if path.suffix == ".hpp" else []
    return found


REPORT = xml.fromstring(
    """<testsuite>
    <testcase name="good" status="run"/>
    <testcase name="bad" status="fail"><failure message=""/><system-out>1\n2 is not 3</system-out></testcase>
    <testcase name="left out" status="notrun">
      <skipped message="SKIP_RETURN_CODE=77"/><system-out>here it goes\nskipped: node is missing</system-out>
    </testcase>
    <testcase name="absent" status="notrun"><skipped message="Unable to find executable"/></testcase>
    </testsuite>"""
)

# What GoogleTest 1.12 writes of one part of a program.
PART = """<testsuites><testsuite name="A">
    <testcase name="b" classname="A" status="run" result="skipped">
      <skipped message="/x.cpp:2&#x0A;no vcan"><![CDATA[/x.cpp:2\nno vcan]]></skipped>
    </testcase>
    <testcase name="c" classname="A" status="run" result="completed"><failure message="x"/></testcase>
    <testcase name="q/1" classname="I/P" status="run" result="completed"/>
    </testsuite></testsuites>"""


class RunTests(unittest.TestCase):
    def judge(self, may_skip):
        return run_tests.judge("release", list(REPORT.iter("testcase")), may_skip)

    def test_a_skipped_test_is_told_with_its_reason(self):
        passed, failed, skipped, _ = self.judge(may_skip=True)
        self.assertEqual(passed, 1)
        self.assertEqual(failed, ["release: bad\n    1\n    2 is not 3", "release: absent"])
        self.assertEqual(skipped, ["release: left out: skipped: node is missing"])

    def test_on_the_machine_that_decides_it_has_failed(self):
        passed, failed, skipped, _ = self.judge(may_skip=False)
        self.assertEqual((passed, skipped), (1, []))
        self.assertIn("release: left out: skipped: skipped: node is missing", failed)

    def cases_of_part(self, status, report):
        case = xml.fromstring(f'<testcase name="can.part_1" status="{status}"/>')
        with tempfile.TemporaryDirectory() as folder:
            if report:
                (pathlib.Path(folder) / "can.part_1.xml").write_text(report)
            return run_tests.cases_of_parts([case], pathlib.Path(folder))

    def test_a_part_of_a_program_is_counted_by_its_own_tests(self):
        passed, failed, skipped, _ = run_tests.judge("sanitizers", self.cases_of_part("fail", PART), may_skip=True)
        self.assertEqual(passed, 1)
        self.assertEqual(failed, ["sanitizers: can.A.c\n    x"])
        self.assertEqual(skipped, ["sanitizers: can.A.b: no vcan"])

    def test_a_part_that_broke_off_has_failed(self):
        for report in (None, PART.replace("<failure message=\"x\"/>", "")):
            failed = run_tests.judge("sanitizers", self.cases_of_part("fail", report), may_skip=True)[1]
            self.assertEqual(failed, ["sanitizers: can.part_1"])

    def run_again(self, *again):
        """`bad` and `absent` have failed; returns the cases after the second run, its lines, and what ctest was asked."""
        cases = [xml.fromstring(f'<testcase name="{name}" status="{status}"/>') for name, status in again]
        with unittest.mock.patch.object(run_tests, "run_ctest", return_value=cases) as run_ctest:
            cases, unsteady = run_tests.run_again(None, run_tests.Run("release", "release", ()), list(REPORT.iter("testcase")))
        return cases, unsteady, run_ctest.call_args.args[1].arguments

    def test_what_fails_once_is_told_and_has_not_failed(self):
        cases, unsteady, arguments = self.run_again(("bad", "run"), ("absent", "fail"))
        self.assertEqual(arguments, ("-R", "^(bad|absent)$", "-LE", "unit"))
        self.assertEqual(unsteady, ["release: bad\n    1\n    2 is not 3"])
        self.assertEqual(run_tests.judge("release", cases, True)[:2], (2, ["release: absent"]))

    def test_what_fails_twice_or_cannot_be_run_again_has_failed(self):
        for again in ([("bad", "fail")], []):
            cases, unsteady, _ = self.run_again(*again)
            self.assertEqual(unsteady, [])
            self.assertEqual(run_tests.judge("release", cases, True)[1], ["release: bad\n    1\n    2 is not 3", "release: absent"])

    def test_a_fixture_that_runs_with_what_failed_is_no_verdict(self):
        cases, unsteady, _ = self.run_again(("vm.boots", "run"), ("bad", "fail"), ("absent", "fail"))
        self.assertEqual(unsteady, [])
        self.assertNotIn("vm.boots", [case.get("name") for case in cases])

    def test_where_nothing_but_style_has_failed_nothing_is_run_again(self):
        cases = [xml.fromstring('<testcase name="good" status="run"/>'), xml.fromstring('<testcase name="style.bad" status="fail"/>')]
        with unittest.mock.patch.object(run_tests, "run_ctest") as run_ctest:
            self.assertEqual(run_tests.run_again(None, None, cases), (cases, []))
        run_ctest.assert_not_called()

    def test_nothing_is_run_where_packages_are_missing(self):
        cost = unittest.mock.Mock()
        for status, failed in [(0, None), (1, "scripts/install-packages test has failed")]:
            cost.run.return_value = status
            with unittest.mock.patch.object(run_tests, "build", return_value=None):
                self.assertEqual(run_tests.install_and_build(run_tests.PLANS["test"], cost), failed)
        with unittest.mock.patch.object(run_tests, "build", return_value="release does not build"):
            self.assertEqual(run_tests.install_and_build(run_tests.PLANS["test"], cost), "release does not build")

    def test_a_run_without_tests_has_failed(self):
        self.assertEqual(run_tests.judge("style", [], True), (0, ["style: no test was run"], [], []))

    def run_changed(self, build, *again):
        """What ctest is asked of canopen and formats, which have programs in `build`, where it then says `again`."""
        run = run_tests.Run("check", "check", ("-R", "part_"), once=("canopen", "formats"))
        cases = [xml.fromstring(f'<testcase name="{name}" status="{status}"/>') for name, status in again]
        with unittest.mock.patch.object(run_tests, "run_ctest", return_value=cases) as run_ctest:
            with unittest.mock.patch.object(run_tests.presets, "build_folder", return_value=build):
                run_tests.run_changed(None, run)
        return run_ctest.call_args.args[1].arguments

    def test_a_program_that_passed_as_it_is_is_not_run_again(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(run_tests.os.environ, CI=""):
            build = pathlib.Path(folder)
            for name in ("canopen", "formats"):
                (build / "folders" / name).mkdir(parents=True)
                (build / "folders" / name / f"canvoy_{name}_test").write_text("1")
            everything = ("-R", "part_")
            failed = (("canopen.A.b", "fail"), ("canopen.A.c", "run"), ("formats.A.b", "run"))
            self.assertEqual(self.run_changed(build, *failed), everything)
            self.assertEqual(self.run_changed(build, ("canopen.A.b", "run")), (*everything, "-E", r"^(formats)(\.|$)"))
            self.assertEqual(self.run_changed(build), (*everything, "-E", r"^(canopen|formats)(\.|$)"))
            (build / "folders/formats/canvoy_formats_test").write_text("2")
            self.assertEqual(self.run_changed(build), (*everything, "-E", r"^(canopen)(\.|$)"))
            with unittest.mock.patch.dict(run_tests.os.environ, CI="true"):
                self.assertEqual(self.run_changed(build), everything)

    def test_what_a_program_reads_is_part_of_it(self):
        with tempfile.TemporaryDirectory() as folder:
            root = build = pathlib.Path(folder)
            for path in ("filter_fuzz", "fuzz/corpus/filter_fuzz/a", "folders/can/host/canvoy_host_test"):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text("1")
            programs = ("fuzz.filter_fuzz", "host", "gtfs")
            run_tests.PassedPrograms(root, build, programs).note({"fuzz.filter_fuzz": True, "host": True, "gtfs": True})
            self.assertEqual(run_tests.PassedPrograms(root, build, programs).unchanged, ["fuzz.filter_fuzz", "host"])
            (root / "fuzz/corpus/filter_fuzz/b").write_text("1")
            self.assertEqual(run_tests.PassedPrograms(root, build, programs).unchanged, ["host"])

    def test_what_compiles_sources_itself_is_what_they_are(self):
        name = "embed.add_subdirectory"
        with tempfile.TemporaryDirectory() as folder:
            root = build = pathlib.Path(folder)
            self.assertEqual(run_tests.PassedPrograms(root, build, (name,)).unchanged, [])
            for path in ("canvoy/can/frame/frame.cpp", "canvoy/devices/kit/kit.hpp", "canvoy/devices/cia419/charger.cpp"):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text("1")
            run_tests.PassedPrograms(root, build, (name,)).note({name: True})
            (root / "canvoy/devices/cia419/charger.cpp").write_text("2")
            (root / "canvoy/can/frame/frame_test.cpp").write_text("2")
            self.assertEqual(run_tests.PassedPrograms(root, build, (name,)).unchanged, [name])
            (root / "canvoy/devices/kit/kit.hpp").write_text("2")
            self.assertEqual(run_tests.PassedPrograms(root, build, (name,)).unchanged, [])

    def test_each_test_that_is_what_its_sources_are_is_there(self):
        lines = "".join((ROOT / f"tests/{kind}/CMakeLists.txt").read_text() for kind in ("embed", "strangers"))
        for name, patterns in run_tests.SOURCES.items():
            own = ROOT / f"tests/cli/{name.removeprefix('cli.')}_test.py", ROOT / "canvoy/worlds" / name.removeprefix("worlds_")
            self.assertTrue(re.search(rf"\b{name.removeprefix('strangers.')}\b", lines) or any(path.exists() for path in own), name)
            for pattern in patterns:
                matches = re.fullmatch(r"tests/strangers/[\w.]+(/\*)?", pattern) or any(ROOT.glob(pattern.lstrip("!")))
                self.assertTrue(matches, pattern)

    def test_a_world_includes_no_other_devices_than_those_that_its_tests_are_run_again_for(self):
        for world, folders in passed_programs.DEVICES_OF.items():
            found = {path.parts[2] for path in included_by(ROOT / "canvoy/worlds" / world) if path.parts[:2] == ("canvoy", "devices") and len(path.parts) > 3}
            self.assertLessEqual(found, {"kit", *folders}, world)

    def test_a_world_includes_no_other_libraries_than_those_that_its_tests_are_run_again_for(self):
        for world in passed_programs.DEVICES_OF:
            known = {tuple(pattern.split("/")[:2]) for pattern in run_tests.SOURCES[f"worlds_{world}"] if pattern.endswith(".cpp")}
            found = {path.parts[:2] for path in included_by(ROOT / "canvoy/worlds" / world) if len(path.parts) > 2}
            self.assertLessEqual(found, {*known, ("canvoy", "worlds")}, world)

    def test_a_test_names_no_other_devices_and_worlds_than_those_that_it_is_run_again_for(self):
        folders = {}
        for path in (ROOT / "canvoy/devices").glob("cia*/**/*.hpp"):
            for device in re.findall(r'\.name = "([a-z0-9-]+)"', path.read_text()):
                folders.setdefault(device, set()).add(path.relative_to(ROOT).parts[2])
        self.assertGreater(len(folders), 50)
        for worlds, tests in passed_programs.TESTS_OF.items():
            known = {folder for world in worlds for folder in passed_programs.DEVICES_OF[world]}
            for test in tests:
                own = [path for path in passed_programs.files_of(ROOT, None, test) if path.is_relative_to(ROOT / "tests")]
                own = [path for path in own if path.parent != ROOT / "tests/strangers" and path.name != "command.py" and path.suffix in ("", ".py", ".js", ".cpp", ".toml")]
                self.assertTrue(own, test)
                words = {word for path in own for word in re.findall(r"[\w-]+", path.read_text())}
                run = {word for path in own for word in re.findall(r"""\bdevice['"]?,? ['"]?([a-z0-9-]+)""", path.read_text())}
                strange = {word for word in words | run if folders.get(word) and not folders[word] & known and ("-" in word or word in run)}
                self.assertEqual(strange, set(), test)


if __name__ == "__main__":
    unittest.main()
