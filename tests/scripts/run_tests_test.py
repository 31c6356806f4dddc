#!/usr/bin/env python3
"""What scripts/run-tests makes of the cases that ctest reports."""

import unittest
import xml.etree.ElementTree as xml

import script

run_tests = script.load("run-tests")

REPORT = xml.fromstring(
    """<testsuite>
    <testcase name="good" status="run"/>
    <testcase name="bad" status="fail"/>
    <testcase name="left out" status="notrun">
      <skipped message="SKIP_RETURN_CODE=77"/><system-out>here it goes\nskipped: node is missing</system-out>
    </testcase>
    <testcase name="absent" status="notrun"><skipped message="Unable to find executable"/></testcase>
    </testsuite>"""
)


class RunTests(unittest.TestCase):
    def judge(self, may_skip):
        return run_tests.judge("release", list(REPORT.iter("testcase")), may_skip)

    def test_a_skipped_test_is_told_with_its_reason(self):
        passed, failed, skipped = self.judge(may_skip=True)
        self.assertEqual(passed, 1)
        self.assertEqual(failed, ["release: bad", "release: absent"])
        self.assertEqual(skipped, ["release: left out: skipped: node is missing"])

    def test_on_the_machine_that_decides_it_has_failed(self):
        passed, failed, skipped = self.judge(may_skip=False)
        self.assertEqual((passed, skipped), (1, []))
        self.assertIn("release: left out: skipped: skipped: node is missing", failed)

    def test_a_run_without_tests_has_failed(self):
        self.assertEqual(run_tests.judge("style", [], True), (0, ["style: no test was run"], []))


if __name__ == "__main__":
    unittest.main()
