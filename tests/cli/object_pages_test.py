#!/usr/bin/env python3
"""The pages of the site about objects (scripts/object_pages.py): each object of each profile has one, and says what the profile says."""

import json
import pathlib
import re
import sys
import unittest

from command import CANVOY, CommandTest, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))
import check_pages
import object_pages


class ObjectPages(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.pages = {**object_pages.make(CANVOY), **check_pages.make(CANVOY)}

    def objects(self, profile):
        rows = map(json.loads, run("profile", profile, "--json").stdout.splitlines())
        return [row for row in rows if row["kind"] == "entry"]

    def test_each_object_of_each_profile_has_a_page(self):
        for profile in object_pages.PROFILES:
            firsts = sorted(int(path.rpartition("/")[2][:-3], 16) for path in self.pages if re.fullmatch(rf"objects/{profile}/[0-9A-F]{{4}}\.md", path))
            for row in self.objects(profile):
                first = max(each for each in firsts if each <= int(row["index"], 16))
                page = self.pages[f"objects/{profile}/{first:04X}.md"]
                with self.subTest(f"{profile} {row['index']} {row['sub']}"):
                    self.assertIn(row["entry"], page.replace("\\|", "|"))
                    self.assertIn(row["type"], page)

    def test_each_case_of_the_conformance_test_stands_on_a_page_once(self):
        for profile in check_pages.PROFILES:
            text = self.pages["cases/index.md"] + self.pages[f"cases/{profile}.md"]
            listed = run("check", "--list", "--profile", profile).stdout
            for case in re.findall(r"(?m)^(\S+) +\S.*\n(?: .*\n)*? {17}clause", listed):
                self.assertEqual(text.count(f"| `{case}` |"), 1, case)

    def test_a_page_says_what_the_clauses_say(self):
        # CiA 419, 7.2.1: 6000h, bit 0 of an UNSIGNED8; 6.2.3.2: in RPDO 1.
        page = self.pages["objects/419/6000.md"]
        self.assertIn("# 6000h battery_status", page)
        self.assertIn("CiA 419, 7.2.1", page)
        self.assertIn("| 00h | 0 | readiness | `0` not ready, `1` ready |", page)
        self.assertIn("`charger` (RPDO 1, RPDO 2)", page)
        # CiA 447-3, 4.2.2.8; what ours does stands in docs/cia447.md.
        page = self.pages["objects/447-3/600D.md"]
        self.assertIn("IVN gateway (00h)", page)
        self.assertIn("`CarCommands.ADoorOpens`", page)

    def test_tables_are_whole_and_links_lead_somewhere(self):
        for path, page in self.pages.items():
            with self.subTest(path):
                for block in re.findall(r"(?m)(?:^\|.*\n)+", page):
                    widths = {len(re.findall(r"(?<!\\)\|", line)) for line in block.splitlines()}
                    self.assertEqual(len(widths), 1)
                for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page):
                    if "://" not in target:
                        place = (pathlib.PurePosixPath(path).parent / target).as_posix()
                        parts = []
                        for part in place.split("/"):
                            parts = parts[:-1] if part == ".." else [*parts, part]
                        self.assertTrue("/".join(parts) in self.pages or (ROOT / "docs" / "/".join(parts)).exists(), target)


if __name__ == "__main__":
    unittest.main()
