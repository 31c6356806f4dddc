#!/usr/bin/env python3
"""docs/cia447.md has each object of CiA 447-3 in the table of its virtual device, with what it does and a test."""

import collections
import json
import pathlib
import re
import unittest

from command import CommandTest, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANNERS = ("behave", "reported", "sensed", "setting", "data only")


def sections_of(text):
    """The rows of tables with tests, by the clauses in the headings: (indices, what is said, tests)."""
    found = collections.defaultdict(list)
    clauses = []
    for line in text.splitlines():
        if line.startswith("## "):
            clauses = [clause for clause in re.findall(r"4\.2\.\d+", line)]
            if "4.2.2 to 4.2.4" in line:
                clauses = ["4.2.2", "4.2.3", "4.2.4"]
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        tests = re.findall(r"`(\w+\.\w+)`", cells[-1])
        if line.startswith("| 6") and tests and "(consumed)" not in cells[0]:
            for clause in clauses:
                found[clause].append((set(re.findall(r"\b6[0-9A-F]{3}(?=h)", cells[0])), " ".join(cells[1:-1]), tests))
    return found


class CarObjects(CommandTest):
    def setUp(self):
        self.text = (ROOT / "docs" / "cia447.md").read_text()
        self.rows = sections_of(self.text)

    def test_each_object_of_each_device_is_there(self):
        lines = [json.loads(line) for line in self.assert_done(run("profile", "447-3", "--json")).splitlines()]
        entries = [line for line in lines if line["kind"] == "entry" and line["index"].startswith("6")]
        clauses = {line["index"]: line["clause"] for line in entries}
        self.assertEqual(len(clauses), 164, "Part 3 has so many")
        for index, clause in clauses.items():
            with self.subTest(index=index):
                device = ".".join(clause.split(".")[:3])
                rows = [row for row in self.rows[device] if index in row[0]]
                self.assertEqual(len(rows), 1, clause)
                self.assertTrue(any(manner in rows[0][1] for manner in MANNERS), rows[0][1])

    def test_each_test_that_it_names_there_is(self):
        sources = "".join(path.read_text() for path in (ROOT / "canvoy" / "devices" / "cia447").rglob("*_test.cpp"))
        there_are = {f"{suite}.{name}" for suite, name in re.findall(r"(?m)^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", sources)}
        named = set(re.findall(r"`(\w+\.[A-Z]\w+)`", self.text))
        self.assertGreater(len(named), 60)
        self.assertEqual(named - there_are, set())


if __name__ == "__main__":
    unittest.main()
