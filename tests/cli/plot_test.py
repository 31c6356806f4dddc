#!/usr/bin/env python3
"""canvoy plot, from outside: of a log with a battery's temperature (CiA 418, 6010h: 0.125 degrees a bit)."""

import json
import pathlib
import struct
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

from command import FAILED, USAGE, CommandTest, run

SVG = "{http://www.w3.org/2000/svg}"


def dots_of(png):
    """Rows of red, green and blue of a PNG of 8 bits each (ISO/IEC 15948, 9: a filter for each row)."""
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    place, packed = 8, b""
    while place < len(png):
        length, kind = struct.unpack(">I4s", png[place : place + 8])
        body = png[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            assert (depth, colours, interlaced) == (8, 2, 0)
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    size = 3 * width
    raw = zlib.decompress(packed)
    above, rows = bytes(size), []
    for y in range(height):
        kind, line = raw[y * (size + 1)], bytearray(raw[y * (size + 1) + 1 : (y + 1) * (size + 1)])
        for x in range(size):
            left, up, corner = line[x - 3] if x >= 3 else 0, above[x], above[x - 3] if x >= 3 else 0
            nearest = min((left, up, corner), key=lambda each: abs(left + up - corner - each))
            line[x] = (line[x] + (0, left, up, (left + up) // 2, nearest)[kind]) & 0xFF
        above = bytes(line)
        rows.append([tuple(line[x : x + 3]) for x in range(0, size, 3)])
    return rows


class Plot(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.log = str(cls.folder / "hour.log")
        # SDO answers of node 10 with 6010h: from 20 to 40 degrees, and one at 60; then "invalid" (FFFFh).
        raw = [160 + i % 161 for i in range(3600)]
        raw[1800] = 480
        raw[-1] = 0xFFFF
        lines = (f"({1700000000 + i:010d}.000000) can0 58A#4B106000{value & 0xFF:02X}{value >> 8:02X}0000\n" for i, value in enumerate(raw))
        pathlib.Path(cls.log).write_text("".join(lines))

    def plot(self, *arguments):
        return run("plot", self.log, *arguments, "--node", "10=418")

    def test_curves_of_one_node_id_on_two_buses_say_which_is_which(self):
        log, picture = self.folder / "two.log", self.folder / "two.svg"
        log.write_text("".join(f"({i}.0) {bus} 18A#{value}0001\n" for i in (1, 2) for bus, value in (("can0", "A0"), ("can1", "50"))))
        names = ["temperature (10 on can0)", "temperature (10 on can1)"]
        self.assert_done(run("plot", str(log), "temperature", "--node", "10=418", "--out", str(picture)))
        texts = [text.text for text in xml.etree.ElementTree.parse(picture).getroot().iter(SVG + "text")]
        self.assertEqual([text for text in texts if text.startswith("temperature")], names)
        shown = self.assert_done(run("plot", str(log), "temperature", "--node", "10=418"))
        self.assertTrue(shown.startswith("".join(f"{mark} {name}, °C\n" for mark, name in zip("AB", names))), shown)
        one = self.assert_done(run("plot", str(log), "temperature", "--node", "10=418", "--filter", "bus=can1"))
        self.assertTrue(one.startswith("temperature (10), °C\n"), one)

    def test_each_value_is_told_as_json(self):
        lines = [json.loads(line) for line in self.assert_done(self.plot("6010", "--json")).splitlines()]
        self.assertEqual(len(lines), 3599, "what is invalid is no value")
        self.assertEqual(lines[0], {"time": 1700000000.0, "bus": "can0", "node": 10, "index": "6010", "sub": "00", "name": "temperature", "value": 20.0, "unit": "°C"})
        self.assertEqual(max(line["value"] for line in lines), 60.0)

    def test_a_picture_has_axes_in_units_and_keeps_the_peak(self):
        path = self.folder / "hour.svg"
        self.assertEqual(self.assert_done(self.plot("temperature", "--out", str(path))), "")
        picture = xml.etree.ElementTree.parse(path).getroot()
        texts = [text.text for text in picture.iter(SVG + "text")]
        for wanted in ("°C", "temperature (10)", "20", "60", "0 s", "3500 s"):
            self.assertIn(wanted, texts)
        (line,) = picture.iter(SVG + "polyline")
        points = [tuple(map(float, point.split(","))) for point in line.get("points").split()]
        highest = min(points, key=lambda point: point[1])
        # The peak of 60 is in the middle of the hour, on the line of the mark "60".
        marks = {text.text: float(text.get("y")) - 4 for text in picture.iter(SVG + "text") if text.get("text-anchor") == "end"}
        self.assertAlmostEqual(highest[1], marks["60"], delta=0.2)
        self.assertAlmostEqual((highest[0] - points[0][0]) / (points[-1][0] - points[0][0]), 0.5, delta=0.01)

    def test_a_picture_of_dots_is_the_same(self):
        path = self.folder / "hour.png"
        self.assertEqual(self.assert_done(self.plot("temperature", "--out", str(path))), "")
        rows = dots_of(path.read_bytes())
        self.assertEqual(len(rows[0]), 960)
        blue = [(x, y) for y, row in enumerate(rows) for x, dot in enumerate(row) if dot == (0x00, 0x72, 0xB2) and y > 48]
        grey = [y for y, row in enumerate(rows) if row.count((0xDD, 0xDD, 0xDD)) > 400]
        first, last = min(blue)[0], max(blue)[0]
        x, y = min(blue, key=lambda dot: dot[1])
        self.assertAlmostEqual(y, grey[0], delta=1, msg="the peak of 60 degrees is on the line of the mark 60")
        self.assertAlmostEqual((x - first) / (last - first), 0.5, delta=0.003)
        # The sign of Celsius as GNU Unifont has it (00B0: 18 24 24 18; 0043: 3C 42 42 40), at the left, in black.
        wanted = ["...##.....####..", "..#..#...#....#.", "..#..#...#....#.", "...##....#......"]
        black = ["".join("#" if dot == (0, 0, 0) else "." for dot in row[4:20]) for row in rows]
        self.assertIn(wanted, [black[y : y + 4] for y in range(60)], "\n".join(black[20:60]))

    def test_a_terminal_shows_it_in_eighty_columns(self):
        lines = self.assert_done(self.plot("temperature")).splitlines()
        self.assertEqual(lines[0], "temperature (10), °C")
        self.assertLessEqual(len(lines), 24)
        self.assertLessEqual(max(map(len, lines)), 80)
        self.assertTrue(any("\u2801" <= sign <= "\u28ff" for sign in "".join(lines)))
        self.assertTrue(lines[1].lstrip().startswith("60 "))

    def test_what_is_not_there_is_refused(self):
        self.assert_refused(self.plot("pressure"), FAILED, "'pressure'", "--table")
        self.assert_refused(self.plot("6010", "--out", "x.jpg"), USAGE, ".svg", ".png")
        self.assert_refused(self.plot("--", "-:-"), USAGE, "'-:-'")
        self.assert_refused(run("plot", str(self.folder / "none.log"), "6010"), FAILED, "none.log")
        self.assert_refused(run("plot", self.log), USAGE)


if __name__ == "__main__":
    unittest.main()
