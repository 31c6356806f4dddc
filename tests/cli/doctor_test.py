#!/usr/bin/env python3
"""canvoy doctor: what it says of logs with one thing wrong, in which words, and how it ends. Which sickness shows how is tried on
simulated buses by the unit tests of canvoy/text/doctor."""

import json
import pathlib
import tempfile
import unittest

from command import DONE, FAILED, USAGE, CommandTest, run

WARNED = 3
SICK = 4

BEATS = [(i / 2, "705#05") for i in range(40)]
# An error frame as SocketCAN has it: a stuff error, 20000088h.
ERROR = "20000088#0000040000000000"


def log_of(frames, bus="can0"):
    return "".join(f"({1700000000 + time:.6f}) {bus} {frame}\n" for time, frame in sorted(frames))


class Doctor(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, frames, name="a.log"):
        path = self.folder / name
        path.write_text(frames if isinstance(frames, str) else log_of(frames))
        return str(path)

    def told(self, result, status):
        self.assertEqual((result.returncode, result.stderr), (status, ""), result.stdout)
        return [json.loads(line) for line in result.stdout.splitlines()]

    def test_a_healthy_log_is_said_to_be_so(self):
        done = run("doctor", self.path(BEATS), "--bit-rate", "125")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertEqual(done.stdout, "can0: 40 frames of 1 node in 19.5 s\nhealthy: nothing is wrong as far as it shows\n")

    def test_what_is_short_is_not_plainly_healthy(self):
        done = run("doctor", self.path(BEATS[:9]), "--bit-rate", "125")
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))
        self.assertIn("healthy as far as it shows, but 4.0 s are short", done.stdout)
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)

    def test_a_warning_has_words_in_80_columns_and_a_status_of_its_own(self):
        done = run("doctor", self.path([*BEATS, (9.7, "705#00")]))
        self.assertEqual((done.returncode, done.stderr), (WARNED, ""))
        for word in ("warning: ", "unexpected-boot-up", "node 5 (05h)", "  what ", "  when   at 9.700 s", "  why ", "  check ", "  do ", "0 errors, 1 warning"):
            self.assertIn(word, done.stdout)
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80)

    def test_an_error_goes_before_a_warning(self):
        gone = [(time, frame) for time, frame in BEATS if not 5 < time < 9]
        others = [(i / 4, "706#05") for i in range(80)]
        lines = self.told(run("doctor", self.path([*gone, *others, (9.2, "706#00")]), "--json"), SICK)
        self.assertEqual([line.get("kind") for line in lines], ["heartbeat-missing", "unexpected-boot-up", None])
        self.assertEqual((lines[0]["node"], lines[0]["severity"], lines[0]["count"]), (5, "error", 1))
        self.assertEqual((lines[-1]["errors"], lines[-1]["warnings"], lines[-1]["nodes"]), (1, 1, 2))

    def test_error_frames_alone_are_a_wrong_bit_rate(self):
        lines = self.told(run("doctor", self.path([(i / 10, ERROR) for i in range(30)]), "--json"), SICK)
        self.assertEqual([line.get("kind") for line in lines], ["wrong-bit-rate", None])
        self.assertEqual(lines[-1]["error_frames"], 30)

    def test_each_bus_of_a_log_is_judged_for_itself(self):
        both = log_of(BEATS) + log_of([*BEATS, (9.7, "705#00")], "can1")
        lines = self.told(run("doctor", self.path(both), "--json"), WARNED)
        self.assertEqual([(line["bus"], line.get("kind")) for line in lines], [("can0", None), ("can1", "unexpected-boot-up"), ("can1", None)])

    def test_logs_of_other_formats_say_the_same(self):
        path = self.path([*BEATS, (9.7, "705#00")])
        wanted = self.told(run("doctor", path, "--json"), WARNED)[0]["what"]
        for ending in ("blf", "asc", "trc", "pcapng", "csv", "log.gz"):
            other = str(self.folder / f"b.{ending}")
            self.assert_done(run("convert-log", path, other))
            self.assertEqual(self.told(run("doctor", other, "--json"), WARNED)[0]["what"], wanted, ending)

    def test_a_part_of_a_log_is_judged_alone(self):
        path = self.path([*BEATS, (9.7, "705#00")])
        self.assertEqual(run("doctor", path, "--for", "9s").returncode, DONE)
        self.assertEqual(run("doctor", path, "--for", "10s").returncode, WARNED)

    def test_a_device_is_compared_with_its_sheet(self):
        sheet = str(self.folder / "battery.eds")
        self.assert_done(run("eds", "export", "battery", "--out", sheet))
        # 1000h by CiA 418 is 418, 1A2h: the device says 1A3h.
        asked = [*BEATS, (1.01, "605#4000100000000000"), (1.02, "585#43001000A3010000")]
        lines = self.told(run("doctor", self.path(asked), "--eds", f"5={sheet}", "--json"), SICK)
        self.assertEqual(lines[0]["kind"], "sheet-differs")
        self.assertIn("1000h:00h is 000001A3h, and by the sheet 000001A2h", lines[0]["what"])

    def test_bad_input_is_refused_in_a_line(self):
        self.assert_refused(run("doctor"), USAGE, "which bus?")
        self.assert_refused(run("doctor", str(self.folder / "none.log")), FAILED, "none.log")
        self.assert_refused(run("doctor", self.path("", "empty.log")), FAILED, "empty.log")
        self.assert_refused(run("doctor", self.path("no log\n", "text.log")), FAILED, "text.log")
        path = self.path(BEATS)
        self.assert_refused(run("doctor", path, "--for", "soon"), USAGE, "'soon'")
        self.assert_refused(run("doctor", path, "--ask"), USAGE, "--ask")
        self.assert_refused(run("doctor", path, "--bit-rate", "0"), USAGE, "--bit-rate")
        self.assert_refused(run("doctor", path, "--eds", "5=none.eds"), FAILED, "none.eds")
        self.assert_refused(run("doctor", "sim"), USAGE, "sim")


if __name__ == "__main__":
    unittest.main()
