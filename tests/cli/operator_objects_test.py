#!/usr/bin/env python3
"""docs/cia401.md and docs/cia852.md have each object of CiA 401 and of CiA 852 in a table, with what it does."""

import json
import pathlib
import re
import unittest

from command import CommandTest, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANNERS = ("behave", "computed", "data only", "not there")


def rows_of(text):
    """(indices, the whole line) of each row of a table that begins with objects."""
    rows = []
    for line in text.splitlines():
        if not re.match(r"\| (objects of CiA \d+: )?[1-9][0-9A-F]{3}h", line):
            continue
        cell = line.strip("|").split("|")[0]
        indices = set()
        for first, last in re.findall(r"\b([0-9A-F]{4})h(?: to ([0-9A-F]{4})h)?", cell):
            indices |= set(range(int(first, 16), int(last or first, 16) + 1))
        rows.append((indices, line))
    return rows


class OperatorObjects(CommandTest):
    def indices_of(self, *arguments):
        """Of all objects of a profile: a range of like ones by each of them."""
        lines = [json.loads(line) for line in self.assert_done(run("profile", *arguments, "--json")).splitlines()]
        return {int(line["index"].rstrip("h"), 16) for line in lines if line["kind"] in ("object", "entry")}

    def check(self, profile, document):
        rows = rows_of((ROOT / "docs" / document).read_text())
        indices = self.indices_of(profile)
        self.assertGreater(len(indices), 20)
        for index in sorted(indices):
            with self.subTest(index=f"{index:04X}h"):
                told = [line for known, line in rows if index in known]
                self.assertTrue(told, f"no row of docs/{document} has it")
                self.assertTrue(any(manner in line for line in told for manner in MANNERS), told)

    def test_each_object_of_cia_401_is_there(self):
        self.check("401", "cia401.md")

    def test_each_object_of_cia_852_is_there(self):
        self.check("852", "cia852.md")

    def test_each_test_that_is_named_there_is(self):
        folders = ("devices/cia401", "devices/cia852", "canopen/remote", "profiles", "profiles/cia852", "tools/device", "sim/excavator")
        sources = "".join(path.read_text() for folder in folders for path in (ROOT / "canvoy" / folder).glob("*_test.cpp"))
        there_are = set(re.findall(r"(?m)^TEST(?:_F|_P)?\(\w+,\s*(\w+)\)", sources))
        headers = "".join(path.read_text() for path in (ROOT / "canvoy").rglob("*.hpp"))
        types = set(re.findall(r"(?m)^(?:class|struct) (\w+)", headers))
        for document in ("cia401.md", "cia852.md"):
            text = (ROOT / "docs" / document).read_text()
            table = text[text.index("| objects"):]
            named = re.findall(r"`(?:\w+\.)?([A-Z]\w+?)(\.\.\.)?`", table)
            self.assertGreater(len(named), 1, document)
            for name, is_beginning in named:
                if re.search("[a-z][A-Z]", name) and name not in types:
                    found = any(there.startswith(name) if is_beginning else there == name for there in there_are)
                    self.assertTrue(found, f"docs/{document}: {name}")


if __name__ == "__main__":
    unittest.main()
