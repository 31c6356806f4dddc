#!/usr/bin/env python3
"""Where the scripts look for what a preset has built, and which of its tests they leave out."""

import json
import pathlib
import tempfile
import unittest

import script

import presets

PRESETS = {
    "configurePresets": [
        {"name": "base", "binaryDir": "${sourceDir}/out/${presetName}"},
        {"name": "clang", "inherits": "base"},
        {"name": "plain", "inherits": ["clang"]},
        {"name": "own", "inherits": "clang", "binaryDir": "${sourceDir}/out"},
    ]
}


class Presets(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "CMakePresets.json").write_text(json.dumps(PRESETS))

    def test_a_preset_builds_where_it_says(self):
        self.assertEqual(presets.build_folder("own", self.root), self.root / "out")

    def test_or_where_one_says_that_it_inherits_from_by_its_own_name(self):
        self.assertEqual(presets.build_folder("base", self.root), self.root / "out/base")
        self.assertEqual(presets.build_folder("plain", self.root), self.root / "out/plain")

    def test_there_is_no_folder_of_a_preset_that_is_not_there(self):
        self.assertRaises(KeyError, presets.build_folder, "fast", self.root)

    def test_the_scripts_ask_the_presets_of_this_project(self):
        # CMakePresets.json: the release is built in build itself, all others beside it.
        self.assertEqual(presets.build_folder("release"), script.ROOT / "build")
        self.assertEqual(presets.build_folder("asan"), script.ROOT / "build/asan")
        self.assertEqual(presets.build_folder("bench"), script.ROOT / "build/bench")

    def test_what_ctest_leaves_out_of_a_program_is_left_out(self):
        # The timed command line of canvoy_add_test, a program with no filter, a test that is not built (no command).
        tests = [{"command": ["/usr/bin/time", "-q", "/b/canvoy_small_machine_test", "--gtest_brief=1", "--gtest_filter=-A.*:B.Is"]},
                 {"command": ["/b/canvoy_can_test", "--gtest_brief=1"]},
                 {"command": ["/b/canvoy_only_test", "--gtest_filter=C.*"]},
                 {}]  # fmt: skip
        self.assertEqual(presets.filters_of({"tests": tests}), {"canvoy_small_machine_test": "-A.*:B.Is"})


if __name__ == "__main__":
    unittest.main()
