#!/usr/bin/env python3
"""canvoy export, from outside. What is expected is typed from CiA 301 and 418; that others can read the DBC is seen by
tests/strangers/dbc."""

import csv
import html.parser
import io
import pathlib
import tempfile
import unittest

from command import FAILED, USAGE, CommandTest, run


class Texts(html.parser.HTMLParser):
    """All texts of a page, and whether each tag that is to be closed was."""

    def __init__(self):
        super().__init__()
        self.texts = []

    def handle_data(self, data):
        self.texts.append(data)


class Export(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def export(self, *arguments):
        return self.assert_done(run("export", *arguments, encoding="latin-1" if arguments[0] == "dbc" else "utf-8"))

    def test_a_device_says_its_scales_units_and_states(self):
        dbc = self.assert_done(run("export", "dbc", "10=battery", encoding="latin-1"))
        self.assertRegex(dbc, r"BO_ 394 \w+: \d battery\n( SG_ .*\n)* SG_ temperature : \d+\|16@1- \(0\.125,0\) \[.*\] \"°C\"", "CiA 418, 6010h in TPDO 1")
        self.assertIn('VAL_ 1802 NMT_state 0 "boot-up" 4 "stopped" 5 "operational" 127 "pre-operational" ;', dbc)
        for line in dbc.splitlines():
            if line.startswith(" SG_ "):
                self.assertLessEqual(len(line.split()[1]), 32, line)

    def test_transfers_are_told_by_command_index_and_sub_index(self):
        dbc = self.assert_done(run("export", "dbc", "10=battery", "--sdo", encoding="latin-1"))
        # 4Bh: an expedited upload of two bytes (CiA 301, 7.2.4.3.5); 2Bh: the download.
        selector = 0x4B | 0x6010 << 8
        self.assertRegex(dbc, rf" SG_ temperature\w* m{selector} : 32\|16@1- \(0\.125,0\)")
        self.assertRegex(dbc, r"BO_ 1418 battery_SDO_response: 8 battery")

    def test_nodes_of_a_car_have_a_channel_of_sdo_to_each_other_one(self):
        dbc = self.assert_done(run("export", "dbc", "1=ivn-gateway", "3=printer", "--sdo", encoding="latin-1"))
        # Node n asks node m on 240h + 100h * ((n - 1) / 4) + 10h * ((n - 1) % 4) + m - 1, and hears 80h below (docs/cia447.md).
        for can_id, name in ((0x242, "ivn_gateway_SDO_asks_3"), (0x1C2, "printer_SDO_tells_1"), (0x260, "printer_SDO_asks_1"), (0x1E0, "ivn_gateway_SDO_tells_3")):
            self.assertIn(f"\nBO_ {can_id} {name}: 8 {name[: name.index('_SDO')]}\n", dbc)
        for default in (0x601, 0x583):
            self.assertIn(f"\nBO_ {default} ", dbc)
        # 1008h has a text; 1000h:00h is read by 43h, four bytes (CiA 301, 7.2.4.3.5).
        selector = 0x43 | 0x1000 << 8
        self.assertRegex(dbc[dbc.index("BO_ 450 ") :], rf"\A.*\n(?: SG_ .*\n)*? SG_ Device_type\S* m{selector} : 32\|")
        lone = self.assert_done(run("export", "dbc", "5=charger", "10=battery", "--sdo", encoding="latin-1"))
        self.assertNotIn("battery_to_charger", lone, "only CiA 447 has that")

    def test_csv_has_a_line_for_each_number_and_where_it_is_sent(self):
        rows = list(csv.DictReader(io.StringIO(self.export("csv", "10=battery"))))
        row = next(row for row in rows if row["index"] == "6010")
        self.assertEqual((row["type"], row["unit"], row["factor"], row["can_id"]), ("INTEGER16", "°C", "0.125", "18A"))
        self.assertTrue(all(None not in row.values() and None not in row for row in rows), "all lines have all columns")
        self.assertTrue([row for row in rows if row["index"] == "1018" and row["sub"] == "01"])

    def test_html_is_a_page_of_its_own(self):
        page = self.export("html", "10=battery")
        texts = Texts()
        texts.feed(page)
        self.assertIn("6010h:00h", texts.texts)
        self.assertNotIn("http", page.replace("http-equiv", ""), "it loads nothing")

    def test_what_a_file_says_does_not_command_the_page(self):
        sheet = self.folder / "evil.eds"
        sheet.write_text("[DeviceInfo]\nProductName=<script>alert(1)</script>\n[2000]\nParameterName=<b>\"x\"\nDataType=5\nAccessType=rw\nDefaultValue=<i>\n")
        page = self.export("html", str(sheet))
        self.assertNotIn("<script", page)
        self.assertNotIn("<i>", page)
        self.assertNotIn("<b>\"x", page)
        self.assertNotIn('"<', self.export("dbc", str(sheet)).replace('"<script>', ""))

    def test_a_network_file_is_of_one_bus(self):
        network = self.folder / "house.toml"
        network.write_text(self.assert_done(run("run", "lift", "--lifts", "2", "--print")))
        self.assert_refused(run("export", "dbc", str(network)), USAGE, "--bus", "lift1", "lift2")
        self.assert_refused(run("export", "dbc", str(network), "--bus", "lift9"), USAGE, "lift9", "lift1")
        self.assertIn("BO_ ", self.export("dbc", str(network), "--bus", "lift1"))

    def rows(self, *arguments):
        return list(csv.DictReader(io.StringIO(self.export("csv", *arguments))))

    def printed(self, network):
        file = self.folder / f"{network}.toml"
        file.write_text(self.assert_done(run("run", network, "--print")))
        return file

    def test_a_bus_is_as_its_network_sets_it_up(self):
        rows = self.rows(str(self.printed("bus")), "--bus", "sim0")
        speed = [row for row in rows if (row["node_id"], row["index"]) == ("1", "6481")]
        # The on-board computer takes the vehicle's speed from the gateway, node 11: 180h + 11 (CiA 301, 7.3.3).
        self.assertEqual([(row["can_id"], row["message"]) for row in speed], [("18B", "vehicle-gateway TPDO1")])
        consumed = [row["value"] for row in rows if (row["node_id"], row["index"], row["sub"]) == ("11", "1016", "01")]
        self.assertTrue(consumed and all(int(value, 16) >> 16 == 1 for value in consumed), "node 11 supervises node 1")

    def test_an_excavator_is_as_its_file_says(self):
        file = self.printed("excavator")
        self.assertTrue(self.rows(str(file), "--bus", "sim1"), "the armrest behind the seat")
        text = file.read_text().replace("[seat]\nplayed = true", "[seat]\nplayed = false")
        file.write_text(text.replace('# real = "can0"', 'real = "can0"'))
        self.assert_refused(run("export", "csv", str(file), "--bus", "sim1"), USAGE, "sim1", "sim0")

    def test_what_run_refuses_in_a_file_is_refused(self):
        for network in ("bus", "excavator"):
            file = self.printed(network)
            file.write_text(file.read_text().replace("seed = 1 ", 'seed = "one" '))
            self.assert_refused(run("export", "csv", str(file)), FAILED, f"{network}.toml line ", "seed")

    def test_a_network_file_may_name_sheets(self):
        self.assert_done(run("eds", "export", "battery", "--out", str(self.folder / "b.eds")))
        network = self.folder / "own.toml"
        network.write_text('[[node]]\nid = 11\nname = "left"\nsheet = "b.eds"\n[[node]]\nid = 12\nsheet = "b.eds"\n')
        dbc = self.assert_done(run("export", "dbc", str(network), encoding="latin-1"))
        self.assertRegex(dbc, r"\nBU_: left \w+\n")
        self.assertIn("BO_ 395 ", dbc)
        self.assertIn("BO_ 396 ", dbc)
        network.write_text('[[node]]\nid = 200\nsheet = "b.eds"\n')
        self.assert_refused(run("export", "dbc", str(network)), FAILED, "own.toml line 1", "200")
        network.write_text("[[node]]\nid = 2\n")
        self.assert_refused(run("export", "dbc", str(network)), FAILED, "no node stands in it")

    def test_what_there_is_not_is_refused(self):
        self.assert_refused(run("export", "dbc", "boat"), USAGE, "'boat'")
        self.assert_refused(run("export", "xls", "charger"), USAGE, "xls")
        self.assert_refused(run("export", "dbc", "5=charger", "5=battery"), USAGE, "node-ID 5")
        self.assert_refused(run("export", "dbc", "900=charger"), USAGE, "900")
        self.assert_refused(run("export", "dbc", "419"), USAGE, "CiA 419")
        self.assert_refused(run("export", "dbc", "417-4", "--sdo"), USAGE, "--sdo")
        self.assert_refused(run("export", "dbc"), USAGE)

    def test_the_same_device_twice_has_two_names(self):
        dbc = self.assert_done(run("export", "dbc", "10=battery", "11=battery", encoding="latin-1"))
        self.assertIn("\nBU_: battery_10 battery_11\n", dbc)


if __name__ == "__main__":
    unittest.main()
