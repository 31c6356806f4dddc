#!/usr/bin/env python3
"""canopen-python reads the oddities of tests/sheets as we do (canvoy/formats/sheet/sheet_oddities_test.cpp): the same values
of the same entries. Where it has another one, the table says so and why, and that is checked as well.

    tests/strangers/with_python tests/strangers/eds/canopen_python_test.py
"""

import io
import logging
import pathlib
import re
import unittest

import canopen

logging.disable(logging.CRITICAL)
SHEETS = pathlib.Path(__file__).resolve().parents[2] / "sheets"
NODE_ID = 5
# What a dictionary of canopen-python has to have around an object.
LISTS = "[FileInfo]\n[DeviceInfo]\n[MandatoryObjects]\nSupportedObjects=0\n[OptionalObjects]\nSupportedObjects=0\n[ManufacturerObjects]\nSupportedObjects=0\n"
USUAL = {"ParameterName": "Speed", "ObjectType": "0x7", "DataType": "0x0006", "AccessType": "rw"}


def split(text, separator):
    """`\\;` is no separator."""
    return [part.replace("\\" + separator, separator) for part in re.split(r"(?<!\\)" + re.escape(separator), text)]


def section(keys):
    lines = dict(USUAL)
    for part in split(keys, ";"):
        line = part.strip()
        if line.startswith("-") and "=" not in line:
            lines = {key: value for key, value in lines.items() if key.lower() != line[1:].lower()}
            continue
        key, value = line.split("=", 1)
        lines = {each: kept for each, kept in lines.items() if each.lower() != key.strip().lower()}
        lines[key] = value
    return "[2000]\n" + "".join(f"{key}={value}\n" for key, value in lines.items())


def dictionary(text):
    file = io.StringIO(LISTS + text)
    file.name = "oddity.eds"
    return canopen.import_od(file, NODE_ID)


def python_bytes(variable):
    """Those of the default: 0 where there is none."""
    value = variable.default
    if value is None:
        numbers = canopen.objectdictionary.datatypes.NUMBER_TYPES
        return bytes(len(variable) // 8) if variable.data_type in numbers else b""
    return variable.encode_raw(value)


def expected(checks):
    """What the table says is right, of what both can tell."""
    right = {}
    for check in (each.strip() for each in split(checks, ";")):
        key, _, value = check.partition("=")
        if key in ("bytes", "type", "name", "access"):
            right[key] = value
    return right


def told(variable, key):
    return {
        "bytes": lambda: python_bytes(variable).hex(" ").upper(),
        "type": lambda: f"{variable.data_type:04X}",
        "name": lambda: variable.name,
        "access": lambda: variable.access_type,
    }[key]()


class Oddities(unittest.TestCase):
    def test_entries_have_the_values_that_it_reads(self):
        compared = 0
        for line in (SHEETS / "entries.txt").read_text().splitlines():
            if not line or line.startswith("#"):
                continue
            columns = split(line, "|")
            right = expected(columns[2])
            if not right or len(columns) > 3:
                continue
            with self.subTest(columns[0].strip()):
                variable = dictionary(section(columns[1]))[0x2000]
                for key, value in right.items():
                    wanted = value.lower() if key == "access" else value
                    self.assertEqual(told(variable, key), wanted, columns[1])
                    compared += 1
        self.assertGreater(compared, 45)

    def test_sheets_have_the_entries_that_it_reads(self):
        compared = 0
        for block in (SHEETS / "sheets.txt").read_text().split("\n## ")[1:]:
            title, *lines = block.splitlines()
            checks = [line[2:] for line in lines if line.startswith("? ")]
            if any(check.startswith("python-differs") for check in checks) or "\\x" in block:
                continue
            text = "".join(line + "\n" for line in lines if line and not line.startswith("? "))
            text = "".join(part for part in re.split(r"(?=^\[)", text, flags=re.M) if part.split("]")[0].strip("[") not in LISTS)
            with self.subTest(title):
                od = dictionary(text.replace("\\\n", ""))
                for check in checks:
                    place = re.match(r"([0-9A-F]{4}):([0-9A-F]+) (bytes|type|name|access)=(.*)", check)
                    if not place:
                        continue
                    found = od[int(place[1], 16)]
                    variable = found[int(place[2], 16)] if hasattr(found, "subindices") else found
                    self.assertEqual(told(variable, place[3]), place[4], check)
                    compared += 1
        self.assertGreater(compared, 8)


if __name__ == "__main__":
    unittest.main()
