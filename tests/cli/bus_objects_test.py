#!/usr/bin/env python3
"""docs/cia407-objects.md has each object of CiA 407 in the table of its virtual device, and each cell of the matrix of passenger information."""

import collections
import json
import pathlib
import re
import unittest

from command import CommandTest, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
INFORMATION = "03"


def rows_of(text):
    """The cells of tables of objects, by the code in the heading above."""
    found = collections.defaultdict(list)
    code = None
    for line in text.splitlines():
        if line.startswith("## "):
            heading = re.search(r"\(([0-9A-F]{2})h, 6\.\d+\)", line)
            code = heading.group(1) if heading else None
        elif code and line.startswith("| 6"):
            found[code].append([cell.strip() for cell in line.strip("|").split("|")])
    return found


def indices_of(cell):
    return re.findall(r"\b6[0-9A-F]{3}(?=h)", cell)


class BusObjects(CommandTest):
    def setUp(self):
        self.text = (ROOT / "docs" / "cia407-objects.md").read_text()
        self.rows = rows_of(self.text)
        lines = [json.loads(line) for line in self.assert_done(run("profile", "407", "--json")).splitlines()]
        self.devices = [line for line in lines if line["kind"] == "device"]
        self.codes = {line["code"] for line in self.devices}
        self.objects = [line for line in self.devices if "index" in line]

    def test_all_virtual_devices_are_there(self):
        self.assertEqual(len(self.codes), 24)
        with_objects = {line["code"] for line in self.objects}
        self.assertEqual(set(self.rows), with_objects)
        by_code = self.text.split("## By their code alone")[1].split("##")[0]
        self.assertEqual(set(re.findall(r"\(([0-9A-F]{2})h, 6", by_code)), self.codes - with_objects)

    def test_each_object_of_each_device_behaves_or_it_is_said_why_not(self):
        for code in self.rows.keys() - {INFORMATION}:
            wanted = sorted({line["index"] for line in self.objects if line["code"] == code})
            told = sorted(index for row in self.rows[code] for index in indices_of(row[0]))
            self.assertEqual(told, wanted, code)
            for row in self.rows[code]:
                self.assertIn(row[1], ("behaves", "data only"), row)
                self.assertTrue(row[1] == "behaves" or row[2], f"no reason: {row}")

    def test_each_cell_of_the_matrix_is_as_the_clause_has_it(self):
        cells = {
            (line["index"], line["class"], line["subclass"]): line["category"][0].upper()
            for line in self.objects
            if line["code"] == INFORMATION
        }
        rows = {indices_of(row[0])[0]: row[1:] for row in self.rows[INFORMATION]}
        self.assertEqual(set(rows), {index for index, _, _ in cells})
        for index, row in rows.items():
            for column in range(12):
                with self.subTest(index=index, column=column):
                    wanted = cells.get((index, column // 4 + 1, column % 4 + 1))
                    told = row[column].split()
                    self.assertEqual(told[0], wanted or "-")
                    self.assertTrue(wanted is None or told[1] in ("b", "d"))
            self.assertTrue(row[12] or not any(cell.endswith("d") for cell in row[:12]), f"no reason: {index}")

    def test_each_row_names_a_test_that_there_is(self):
        folders = [ROOT / "canvoy" / "devices" / "cia407", ROOT / "canvoy" / "worlds" / "bus_line"]
        sources = "".join(path.read_text() for folder in folders for path in folder.rglob("*_test.cpp"))
        there_are = {f"{suite}.{name}" for suite, name in re.findall(r"(?m)^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", sources)}
        for rows in self.rows.values():
            for row in rows:
                self.assertTrue(re.findall(r"`(\w+\.[A-Z]\w+)`", row[-1]), row)
        named = set(re.findall(r"`(\w+\.[A-Z]\w+)`", self.text))
        self.assertGreater(len(named), 50)
        self.assertEqual(named - there_are, set())


if __name__ == "__main__":
    unittest.main()
