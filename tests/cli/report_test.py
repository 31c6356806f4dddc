#!/usr/bin/env python3
"""canvoy report: a run or a log as one page that loads nothing, with the same run and verdicts as canvoy run."""

import base64
import gzip
import html
import json
import os
import re
import subprocess
import tempfile
import unittest

from command import CANVOY, CommandTest, DONE, FAILED, USAGE, run


def pictures_of(page):
    """What is drawn by the script: JSON, packed by gzip and base64."""
    packed = re.search(r'<script type="text/plain" id="data">(.*?)</script>', page, re.DOTALL)[1]
    return json.loads(gzip.decompress(base64.b64decode(packed)))["pictures"]


def words_of(page, element):
    """What is read without a script, of each element of the kind."""
    all_of = re.findall(rf"<{element}\b[^>]*>(.*?)</{element}>", page, re.DOTALL)
    return [html.unescape(re.sub(r"<[^>]*>", " ", each)).strip() for each in all_of]


class Report(CommandTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.page = os.path.join(self.folder, "report.html")

    def report(self, *arguments, status=DONE):
        result = run("report", *arguments, "--out", self.page)
        self.assertEqual(result.returncode, status, result.stderr)
        with open(self.page, encoding="utf-8") as page:
            return page.read(), result.stdout

    def test_a_run_is_the_same_as_that_of_canvoy_run(self):
        line = ("run", "charger", "--for", "5min", "--seed", "7", "--fault", "pilot-loss@1min+30s")
        page, said = self.report(*line[1:])
        told = [each for each in run(*line).stdout.splitlines() if re.match(r" +[0-9].*?  ", each)]
        events = [html.unescape(each) for each in re.findall(r"<li\b[^>]*><b>.*?</b> (.*)", page)]
        self.assertEqual(len(events), len(told))
        for in_page, of_run in zip(events, told):
            self.assertEqual(in_page, of_run.strip().split("  ", 1)[1])
        summary = json.loads(run(*line, "--json").stdout.splitlines()[-1])
        verdicts = [each for each in words_of(page, "tr") if each.split()[0] in ("PASS", "FAIL", "open")]
        self.assertEqual(len(verdicts), len(summary["invariants"]))
        self.assertIn("pilot-loss", said)
        self.assertTrue(run(*line).stdout.endswith(said), "the summary is the same")
        self.assertIn("canvoy run charger --for 5min --fault pilot-loss@1min+30s --seed 7", words_of(page, "code"))

    def test_verdicts_say_what_is_worst_and_when_and_what_is_allowed(self):
        page, _ = self.report("lift", "--for", "15min", "--percent", "40", status=1)
        broken = [each for each in words_of(page, "tr") if each.startswith("FAIL")]
        self.assertNotEqual(broken, [])
        for each in broken:
            self.assertRegex(each, r"^FAIL +.*: [0-9.]+( [a-zA-Z%/°]+)?, at [0-9:.]+; ([0-9.]+( [a-zA-Z%/°]+)?|none) allowed\.$")

    def test_statistics_have_words_and_units(self):
        page, _ = self.report("charger", "--for", "5min")
        rows = words_of(page, "tr")
        self.assertTrue(any(re.match(r"^Energy +[0-9.]+ Wh$", each) for each in rows), rows)
        self.assertFalse(any("_" in each.split("  ")[0] for each in rows if not each.startswith(("battery", "charger"))), rows)

    def test_faults_are_marks_in_the_curves(self):
        page, _ = self.report("charger", "--for", "5min", "--fault", "pilot-loss@1min+30s")
        curves = re.findall(r'<figure class="curve">.*?</figure>', page, re.DOTALL)
        self.assertNotEqual(curves, [])
        for curve in curves:
            # 540 of 600 units are 5 minutes: the fault begins after a fifth, and takes a tenth.
            self.assertIn('<rect class="fault-band" x="164.0" y="8" width="54.0" height="90"><title>pilot-loss</title></rect>', curve)

    def test_emergencies_are_marks_in_the_curves(self):
        log = os.path.join(self.folder, "emergency.log")
        with open(log, "w", encoding="ascii") as out:
            for second in range(11):  # the temperature of a battery (CiA 418, 6010h) changes each second
                out.write(f"({second}.000000) can0 18A#{second:02X}0001\n")
                if second == 5:
                    out.write("(5.000000) can0 08A#0010010000000000\n(7.500000) can0 08A#0000000000000000\n")
        page, _ = self.report(log, "--node", "10=418")
        curves = re.findall(r'<figure class="curve">.*?</figure>', page, re.DOTALL)
        self.assertNotEqual(curves, [])
        for curve in curves:
            # 540 of 600 units are ten seconds; that an error is over is no emergency.
            self.assertEqual(re.findall('<path class="emergency-mark" d="([^"]*)"', curve), ["M326.0 8v8"])

    def curve_of_a_log(self, frames, name, *options):
        log = os.path.join(self.folder, "curve.log")
        with open(log, "w", encoding="ascii") as out:
            out.writelines(f"({time:.6f}) can0 {frame}\n" for time, frame in frames)
        page, _ = self.report(log, *options)
        curves = re.findall(r'<figure class="curve">.*?</figure>', page, re.DOTALL)
        curve = next(each for each in curves if f": {name} " in each)
        return page, curve, re.search('<path class="line" d="([^"]*)"', curve)[1]

    def test_a_peak_between_two_pictures_is_in_the_curve(self):
        # The temperature of a battery (CiA 418, 6010h in TPDO1, in 0.125 degrees): 20 and 21 degrees, and 60 for 0.1 s.
        frames = [(second, "18A#A00001" if second % 100 else "18A#A80001") for second in range(1001)]
        frames += [(432.1, "18A#E00101"), (432.2, "18A#A00001")]
        page, curve, _ = self.curve_of_a_log(sorted(frames), "temperature", "--node", "10=418")
        self.assertIn('temperature, 20 °C to 60 °C"', curve)
        self.assertIn("canvoy view curve.log --node 10=418", words_of(page.replace(self.folder + "/", ""), "code"))

    def test_a_closed_door_is_0_mm_wide_and_an_unknown_one_has_no_width(self):
        # Door 1 of a lift (CiA 417-4, 6301h and 6302h in 201h), each two seconds: closed is 0000h, not available FFFFh.
        widths = [900, 0, 450, 0xFFFF, 900, 450]
        frames = [(2 * i, f"201#0000{width & 0xFF:02X}{width >> 8:02X}") for i, width in enumerate(widths)]
        _, _, line = self.curve_of_a_log(frames, "Door position, Door 1", "--profile", "417-4")
        # 540 of 600 units are ten seconds, 90 of 120 are 900 mm.
        self.assertEqual(line, "M56.0 8.0H164.0V98.0H272.0V53.0H380.0M488.0 8.0H596.0V53.0H596.0")

    def test_what_a_log_does_not_have_is_said_first(self):
        log = os.path.join(self.folder, "cut.log")
        with open(log, "w", encoding="ascii") as out:
            out.write("(1.000000) can0 705#05\n(2.000000) can0 705#05\n(3.0000")
        page, _ = self.report(log)
        gaps = re.search(r'<div class="lost">(.*?)</div>', page, re.DOTALL)
        self.assertRegex(gaps[1], r"1 line of this log could not be read, and is missing here: .*line 3: it does not begin")
        self.assertLess(page.index('<div class="lost">'), page.index("<section"), "before all else")

    def test_a_log_whose_times_jump_back_takes_no_more_memory(self):
        def peak(*seconds):
            """KiB, of the report of a log with half of its frames at each time."""
            log = os.path.join(self.folder, "long.log")
            with open(log, "w", encoding="ascii") as text:
                for second in seconds:
                    text.write(f"({second}.000000) can0 705#05\n" * 1_000_000)
            with open(os.devnull, "w", encoding="ascii") as nothing:
                process = subprocess.Popen([CANVOY, "report", log, "--out", self.page], stdout=nothing)
                _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, DONE)
            return usage.ru_maxrss

        in_order = peak(1, 2)
        self.assertLess(peak(2, 1), in_order + 20 * 1024, "KiB")

    def test_pictures_go_from_the_start_to_the_end(self):
        page, _ = self.report("lift", "--floors", "4", "--for", "10min")
        pictures = pictures_of(page)
        self.assertEqual(len(pictures), 120)
        self.assertEqual((pictures[0]["time"], pictures[-1]["time"]), (0, 600))
        self.assertEqual(len(pictures[0]["snapshot"]["lifts"]), 1)
        times = [each["time"] for each in pictures]
        self.assertEqual(times, sorted(times))

    def test_an_hour_of_a_lift_is_200_kb(self):
        self.report("lift", "--for", "1h")
        self.assertLess(os.path.getsize(self.page), 200_000)

    def test_what_is_broken_is_told_by_the_exit_status_too(self):
        # More people come than a lift can carry, and some give up: after ten minutes at the earliest.
        arguments = ("lift", "--for", "15min", "--percent", "40")
        self.assertEqual(run("run", *arguments).returncode, 1)
        page, said = self.report(*arguments, status=1)
        self.assertIn("FAIL", said)
        self.assertRegex(words_of(page, "h1")[0], "[0-9]+ broken")

    def test_nothing_is_loaded_from_elsewhere(self):
        page, _ = self.report("charger", "--for", "1min")
        self.assertIn("default-src 'none'", page)
        self.assertNotRegex(page, r"<(link|img|iframe)\b|<script[^>]* src=|@import|url\((?!#)")

    def test_the_same_run_is_the_same_file(self):
        first, _ = self.report("charger", "--for", "2min")
        self.assertEqual(self.report("charger", "--for", "2min")[0], first)

    def test_a_link_of_the_page_says_which_run(self):
        page, _ = self.report("charger", "--for", "3min", "--link", "http://127.0.0.1:8080/#seed=9&fault=pilot-loss%401min%2B30s")
        self.assertIn("canvoy run charger --for 3min --fault pilot-loss@1min+30s --seed 9", words_of(page, "code"))
        other, _ = self.report("charger", "--for", "3min", "--seed", "9", "--fault", "pilot-loss@1min+30s")
        self.assertEqual(other, page)

    def test_a_network_file(self):
        file = os.path.join(self.folder, "house.toml")
        with open(file, "w", encoding="utf-8") as out:
            out.write(run("run", "lift", "--lifts", "2", "--floors", "4", "--print").stdout)
        page, _ = self.report(file, "--for", "2min")
        self.assertEqual(len(pictures_of(page)[0]["snapshot"]["lifts"]), 2)

    def test_a_log_with_its_nodes_values_and_load(self):
        log = os.path.join(self.folder, "night.log")
        run("run", "charger", "--for", "2min", "--log", log)
        with open(log, encoding="ascii") as lines:
            frames = len(lines.readlines())
        page, _ = self.report(log, "--node", "10=418", "--node", "5=419")
        self.assertIn("Report: night.log", words_of(page, "h1"))
        self.assertNotIn("<script", page, "a log has no picture")
        self.assertNotIn("JavaScript", page, "nothing is missing without it")
        rows = words_of(page, "tr")
        self.assertTrue(any(re.match(rf"sim0 +{frames} ", each) for each in rows), rows)
        self.assertTrue(any("battery_voltage" in each and each.split()[-2] == "V" for each in rows), rows)
        self.assertTrue(any("battery_voltage" in each for each in words_of(page, "figcaption")))

    def test_what_a_log_says_ends_no_element(self):
        log = os.path.join(self.folder, "evil.log")
        with open(log, "w", encoding="ascii") as out:
            out.write("(0000000001.000000) </script><b>x 70A#05\n(0000000002.000000) </script><b>x 70A#05\n")
        page, _ = self.report(log)
        self.assertEqual(page.count("</script>"), 0)
        self.assertIn("</script><b>x", " ".join(words_of(page, "td")))

    def test_what_makes_no_sense_is_refused_in_a_line(self):
        page = ("--out", self.page)
        for arguments, word in (
            (("charger",), "--out"),
            (("nothing", *page), "nothing"),
            (page, "missing"),
            (("charger", "--fault", "no-such@1min", *page), "no-such"),
            (("charger", "--link", "http://127.0.0.1/", *page), "--link"),
            (("charger", "--link", "http://127.0.0.1/#seed=x", *page), "--link"),
        ):
            self.assert_refused(run("report", *arguments), USAGE, word)
        self.assert_refused(run("report", "udp:239.74.163.99:43199", *page), USAGE, "--for")
        self.assert_refused(run("report", "charger", "--for", "1s", "--out", "/no/such/folder/report.html"), FAILED, "/no/such/folder")
        self.assertFalse(os.path.exists(self.page))


if __name__ == "__main__":
    unittest.main()
