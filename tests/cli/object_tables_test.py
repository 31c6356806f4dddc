#!/usr/bin/env python3
"""docs/cia417.md, cia418.md and cia419.md have each object of their profile in one row of a table, with what it does and a test."""

import json
import pathlib
import re
import unittest

from command import CommandTest, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = {"417-4": "cia417.md", "418": "cia418.md", "419": "cia419.md"}
MANNERS = ("behave", "settings", "data only", "not there")


def rows_of(page):
    """(indices, manner, what is said, tests) of each row that begins with an object."""
    rows = []
    for line in (ROOT / "docs" / page).read_text().splitlines():
        if not re.match(r"\| [16][0-9A-F]{3}h", line):
            continue
        objects, manner, said, tests = (cell.strip() for cell in line.strip("|").split("|"))
        indices = set()
        for first, last in re.findall(r"\b([0-9A-F]{4})h(?: to ([0-9A-F]{4})h)?", objects):
            indices |= set(range(int(first, 16), int(last or first, 16) + 1))
        rows.append((indices, manner, said, re.findall(r"`(\w+\.\w+)`", tests)))
    return rows


class ObjectTables(CommandTest):
    def lines_of(self, profile):
        return [json.loads(line) for line in self.assert_done(run("profile", profile, "--json")).splitlines()]

    def test_each_object_is_in_one_row_that_says_what_it_does(self):
        for profile, page in PAGES.items():
            rows = rows_of(page)
            entries = [line for line in self.lines_of(profile) if line["kind"] == "entry"]
            wanted = {index for line in entries for index in range(int(line["index"], 16), int(line.get("index_last", line["index"]), 16) + 1)}
            self.assertGreater(len(wanted), 20, profile)
            for index in sorted(wanted):
                with self.subTest(profile=profile, index=f"{index:04X}h"):
                    self.assertEqual(len([row for row in rows if index in row[0]]), 1)
            for indices, manner, said, tests in rows:
                with self.subTest(profile=profile, row=f"{min(indices):04X}h"):
                    self.assertTrue(indices & wanted, "the profile has none of them")
                    self.assertTrue(manner.startswith(MANNERS), manner)
                    self.assertTrue(said)
                    self.assertTrue(tests)

    def test_devices_have_the_objects_that_are_said_to_be_there_and_no_others(self):
        listed = re.findall(r"(?m)^(\S+) +CiA (\S+)", self.assert_done(run("device", "--list")))
        for profile, page in PAGES.items():
            sheets = [self.assert_done(run("eds", "export", name)) for name, of in listed if of == profile]
            self.assertTrue(sheets, profile)
            there = {int(index, 16) for sheet in sheets for index in re.findall(r"(?m)^\[([0-9A-Fa-f]{4})\]", sheet)}
            for indices, manner, _, _ in rows_of(page):
                if ", in a device with" not in manner:
                    with self.subTest(profile=profile, row=f"{min(indices):04X}h"):
                        self.assertEqual(bool(indices & there), manner != "not there")

    def test_each_test_that_is_named_there_is(self):
        sources = "".join(path.read_text() for folder in ("devices", "profiles") for path in (ROOT / "canvoy" / folder).rglob("*_test.cpp"))
        there_are = {f"{suite}.{name}" for suite, name in re.findall(r"(?m)^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", sources)}
        for page in PAGES.values():
            named = set(re.findall(r"`([A-Z]\w+\.[A-Z]\w+)`", (ROOT / "docs" / page).read_text()))
            self.assertGreater(len(named), 15, page)
            self.assertEqual(named - there_are, set(), page)


if __name__ == "__main__":
    unittest.main()
