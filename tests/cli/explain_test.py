#!/usr/bin/env python3
"""`canvoy explain` and `canvoy search`: a number has all meanings that CiA 301 gives it; values come first."""

import unittest

from command import USAGE, CommandTest, run


class Explain(CommandTest):
    def kinds(self, word):
        """The meanings of a number by their kind."""
        return {each["kind"]: each["text"] for each in self.assert_told(run("explain", word, "--json"))}

    def test_a_short_number_may_be_a_can_id(self):
        # CiA 301, pre-defined connection set: 000h NMT, 080h SYNC, 081h to 0FFh EMCY
        for word, meant in (("0x80", "SYNC"), ("80", "SYNC"), ("0", "NMT"), ("85", "EMCY of node 5 (05h)")):
            self.assertEqual(self.kinds(word)["CAN-ID, as pre-defined"], meant, word)
        self.assertNotIn("CAN-ID, as pre-defined", self.kinds("7F"))
        self.assertEqual(self.kinds("7F")["NMT state"], "pre-operational")

    def test_three_digits_are_a_can_id_or_a_decimal_node_id(self):
        self.assertEqual(self.kinds("18A"), {"CAN-ID, as pre-defined": "TPDO1 of node 10 (0Ah)"})
        self.assertEqual(self.kinds("127"), {"node-ID, decimal": "node 127 (7Fh)"})
        self.assertEqual(self.kinds("100"), {"node-ID, decimal": "node 100 (64h)", "CAN-ID, as pre-defined": "TIME"})
        self.assertEqual(self.kinds("6FF"), {"CAN-ID, as pre-defined": "of no service"})

    def test_what_is_no_number_is_refused(self):
        for word in ("battery", "0x", "800", "123456789", "h"):
            self.assert_refused(run("explain", word), USAGE, f"'{word}'")


class Search(CommandTest):
    def test_values_come_before_their_mapping(self):
        found = self.assert_told(run("search", "battery", "voltage", "--json"))
        is_communication = [int(each["index"], 16) < 0x2000 for each in found]
        self.assertIn(False, is_communication)
        self.assertIn(True, is_communication)
        self.assertEqual(is_communication, sorted(is_communication))


if __name__ == "__main__":
    unittest.main()
