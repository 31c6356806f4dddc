#!/usr/bin/env python3
"""canvoy profile, from outside. What is expected is typed from CiA 419, clause 7, and docs/profile-json.md."""

import json
import unittest

from command import USAGE, CommandTest, run


class ProfileTest(CommandTest):
    def show(self, *arguments):
        return self.assert_done(run("profile", *arguments))

    def test_lists_the_profiles_with_their_titles(self):
        self.assertRegex(self.show(), r"(?m)^419 +\d+ .*battery chargers$")

    def test_gives_an_overview_of_a_profile_by_any_of_its_names(self):
        overview = self.show("419")
        self.assertRegex(overview, r"(?m)^6010h +battery_temperature +INTEGER16 .*7\.2\.3$")
        self.assertRegex(overview, r"RPDO 1 .*battery_temperature, battery_status")
        self.assertEqual(self.show("CiA 419"), overview)

    def test_shows_an_object_by_its_index_its_name_or_a_word(self):
        shown = self.show("419", "battery_temperature")
        self.assertIn("raw x 0.125 °C", shown)
        self.assertIn("7.2.3", shown)
        self.assertEqual(self.show("419", "6010"), shown)
        self.assertEqual(self.show("419", "Temperature"), shown)

    def test_shows_one_entry_where_its_sub_index_or_name_is_given(self):
        whole, one = self.show("852", "6401"), self.show("852", "6401:31")
        self.assertIn("Joystick 1: x-dimension", whole)
        self.assertIn("31h        Foot pedal 1: Position", one)
        self.assertNotIn("Joystick", one.split("in 01h")[0])
        self.assertEqual(self.show("852", "Foot pedal 1: Position"), one)

    def test_lists_all_objects_that_a_word_means(self):
        self.assertEqual([line.split()[1] for line in self.show("419", "state of charge").splitlines()],
                         ["charger_state_of_charge", "battery_state_of_charge"])

    def test_shows_numbers_with_several_scales_and_codes_upward(self):  # CiA 447-3, 4.2.10.1
        shown = self.show("447-3", "GPS current position")
        self.assertIn("raw x -1e-07 + 90 ° south", shown)
        self.assertIn("that is -90 to 90 °", shown)
        self.assertRegex(shown, r"(?s)6B49D201h to FFFFFFFDh Reserved.*FFFFFFFEh +Failure.*FFFFFFFFh +Signal not")

    def test_says_which_specification_describes_an_object(self):
        self.assertIn("CiA 301, 7.5.2.37", self.show("407", "1800"))
        self.assertIn("CiA 419, 4.1", self.show("419", "1017"))

    def test_shows_numbers_as_people_read_them(self):
        shown = self.show("407", "6115")
        self.assertIn("raw 0 to 23 h\n", shown)  # 9.2.6.22
        self.assertIn("raw 6\n", shown)
        self.assertIn("raw 0 to 250, that is 1985 to 2235 year", shown)
        self.assertIn("that is 0 to 210554060.75 h", self.show("407", "648D"))
        self.assertIn("default 1\n", self.show("407", "6105"))
        self.assertIn("default 00h, mandatory\n", self.show("417-4", "63A1"))

    def test_says_what_a_code_means_once(self):
        shown = self.show("417-4", "6500")
        self.assertRegex(shown, r"(?m)80h to FFh +manufacturer-specific$")
        self.assertRegex(shown, r"(?m)sensor is defective \(failure\)$")

    def test_writes_json_lines(self):
        lines = [json.loads(line) for line in self.show("419", "--json").splitlines()]
        temperature = [line for line in lines if line["kind"] == "quantity" and line["index"] == "6010"]
        self.assertEqual([(line["factor"], line["unit"]) for line in temperature], [(0.125, "°C")])

    def test_shows_another_reading(self):
        usual = self.show("447-3", "60F0")
        self.assertNotEqual(self.show("447-3", "60F0", "--reading", "month-above-day"), usual)
        self.assert_refused(run("profile", "447-3", "--reading", "mine"), USAGE, "'mine'", "month-above-day")
        self.assert_refused(run("profile", "419", "--reading", "mine"), USAGE, "there is but one")

    def test_refuses_what_there_is_not(self):
        self.assert_refused(run("profile", "4190"), USAGE, "'4190'", "419")
        self.assert_refused(run("profile", "419", "elevator"), USAGE, "'elevator'", "CiA 419")
        self.assert_refused(run("profile", "--json"), USAGE, "--json needs a profile")


if __name__ == "__main__":
    unittest.main()
