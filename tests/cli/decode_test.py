#!/usr/bin/env python3
"""canvoy decode, from outside. What is expected is typed from CiA 301, 407, 418 and 419."""

import contextlib
import json
import os
import pathlib
import pty
import re
import signal
import subprocess
import tempfile
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

LOG = """(1.000000) can0 60A#4000100000000000
(1.000500) can0 58A#43001000A2010000
(1.100000) can0 18A#A00001
(1.200000) can0 605#4008100000000000
(1.200500) can0 585#4108100007000000
(1.201000) can0 605#6000000000000000
(1.201500) can0 585#0143616E766F7921
"""

JSON = r"""{"time":1.0,"bus":"can0","frame":"60A#4000100000000000","service":"SDO request","node":10,"text":"read 1000h:00h Device type"}
{"time":1.0005,"bus":"can0","frame":"58A#43001000A2010000","service":"SDO response","node":10,"text":"1000h:00h Device type = 000001A2h","values":[{"index":"1000","sub":"00","name":"Device type","raw":"A2010000","value":418}],"news":"node 10 (0Ah) is of CiA 418"}
{"time":1.1,"bus":"can0","frame":"18A#A00001","service":"TPDO1","node":10,"text":"temperature = 20.000 °C; battery_status = ready","values":[{"index":"6010","sub":"00","name":"temperature","raw":"A000","value":20.0,"unit":"°C"},{"index":"6000","sub":"00","name":"battery_status","raw":"01","value":"ready"}]}
{"time":1.2,"bus":"can0","frame":"605#4008100000000000","service":"SDO request","node":5,"text":"read 1008h:00h Manufacturer device name"}
{"time":1.2005,"bus":"can0","frame":"585#4108100007000000","service":"SDO response","node":5,"text":"1008h:00h Manufacturer device name, 7 bytes in segments"}
{"time":1.201,"bus":"can0","frame":"605#6000000000000000","service":"SDO request","node":5,"text":"read a segment"}
{"time":1.2015,"bus":"can0","frame":"585#0143616E766F7921","service":"SDO response","node":5,"text":"segment: read 1008h:00h Manufacturer device name = \"Canvoy!\"","values":[{"index":"1008","sub":"00","name":"Manufacturer device name","raw":"43616E766F7921","value":"Canvoy!"}]}
{"time":1.3,"bus":"Pr�f\"1","frame":"605#4008100000000000","service":"SDO request","node":5,"text":"read 1008h:00h Manufacturer device name"}
{"time":1.4,"bus":"can0","frame":"585#4F08100022000000","service":"SDO response","node":5,"text":"1008h:00h Manufacturer device name = \"\"\"","values":[{"index":"1008","sub":"00","name":"Manufacturer device name","raw":"22","value":"\""}],"marks":["out of place"]}
{"time":1.5,"bus":"can0","frame":"70A#R","service":"guarding request","node":10}
"""


def all_of(terminal):
    """What was written to a terminal whose other side is closed: it comes in pieces."""
    shown = b""
    with contextlib.suppress(OSError):  # the end of a terminal
        while piece := os.read(terminal, 65536):
            shown += piece
    return shown.decode()


class DecodeTest(CommandTest):
    def log(self, text=LOG):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "bus.log"
        path.write_text(text)
        return str(path)

    def lines(self, *arguments, log=LOG):
        return self.assert_done(run("decode", self.log(log), *arguments)).splitlines()

    def test_learns_the_profile_and_shows_pdos_in_units(self):
        line = self.lines()[2]
        self.assertTrue(line.startswith("(1.100000) can0 18A#A00001 "), line)
        self.assertIn("TPDO1", line)
        self.assertTrue(line.endswith("node 10 (0Ah): temperature = 20.000 °C; battery_status = ready"), line)

    def test_shows_a_transfer_in_one_line(self):
        transfers = [line for line in self.lines("--transfers") if "SDO" in line]
        self.assertEqual(len(transfers), 2)
        self.assertIn('read 1008h:00h Manufacturer device name = "Canvoy!"', transfers[1])

    def test_writes_json(self):
        objects = [json.loads(line) for line in self.lines("--json")]
        self.assertEqual(objects[2]["values"][0], {"index": "6010", "sub": "00", "name": "temperature", "raw": "A000", "value": 20.0, "unit": "°C"})
        self.assertEqual(objects[2]["service"], "TPDO1")
        self.assertEqual(objects[2]["node"], 10)

    def test_writes_json_byte_for_byte(self):
        # The log has no name for a bus in UTF-8, and a text with what JSON escapes.
        log = LOG.encode() + b'(1.300000) Pr\xfcf"1 605#4008100000000000\n(1.400000) can0 585#4F08100022000000\n(1.500000) can0 70A#R\n'
        path = self.log()
        pathlib.Path(path).write_bytes(log)
        output = subprocess.run([CANVOY, "decode", path, "--json"], capture_output=True, check=True).stdout.decode()
        self.assertEqual(output, JSON)

    def test_filters(self):
        self.assertEqual(len(self.lines("--filter", "node=5")), 4)
        self.assertEqual(len(self.lines("--filter", "service=sdo")), 6)
        self.assertEqual(len(self.lines("--filter", "object=temperature")), 1)
        self.assertEqual(len(self.lines("--filter", "object=6010h")), 1)
        self.assertEqual(len(self.lines("--filter", "node=5", "--filter", "object=1008")), 4, "all messages of the transfer")
        self.assertEqual(len(self.lines("--filter", "object=1008", "--transfers")), 1)

    def test_takes_the_profile_of_a_node_from_the_user(self):
        line = self.lines("--node", "10=419", log="(1.0) can0 18A#02\n")[0]
        self.assertIn("charger_status", line)
        self.assertTrue(line.endswith("[!] reserved"), line)

    def test_takes_the_data_sheet_of_a_node(self):
        sheet = self.log("") + ".eds"
        self.assert_done(run("eds", "export", "battery", "--out", sheet))
        line = self.lines("--eds", f"10={sheet}", log="(1.0) can0 18A#A00001\n")[0]
        self.assertIn("temperature = 20.000 °C", line)

    def test_takes_a_data_sheet_for_all_nodes_that_tell_its_product(self):
        sheet = self.log("") + ".eds"
        self.assert_done(run("eds", "export", "battery", "--out", sheet))
        text = pathlib.Path(sheet).read_text()
        for sub, value in ((1, "0x2F0"), (2, "0x1A2")):
            text = re.sub(f"(\\[1018sub{sub}\\](?s:.*?)DefaultValue=)[^\n]*", f"\\g<1>{value}", text, count=1)
        pathlib.Path(sheet).write_text(text)
        answers = ["(1.0) can0 58A#43181001F0020000\n", "(1.0) can0 58A#43181002A2010000\n"]
        lines = self.lines("--eds", sheet, log="".join(answers) + "(1.1) can0 18A#A00001\n")
        self.assertIn("=> node 10 (0Ah) is of CiA 418, by the data sheet", lines[1])
        self.assertIn("temperature = 20.000 °C", lines[2])

    def test_takes_one_profile_for_all_nodes(self):
        lines = self.lines("--profile", "419", log="(1.0) can0 18A#01\n(1.0) can0 18B#01\n")
        for line in lines:
            self.assertIn("charger_status = ready", line)

    def test_reads_a_profile_as_it_is_told(self):
        # CiA 447-3, 60F0h, errata Z02: month in bits 27 to 24 and day in bits 23 to 16; 14 August.
        log = "(1.0) can0 587#43F0600000000E08\n"
        line = self.lines("--profile", "447-3", "--reading", "447-3=month-above-day", log=log)[0]
        self.assertIn("RTC date day: 14 d, RTC date month: 8 month", line)

    def test_names_the_device_that_lss_gives_a_node_id(self):
        log = "".join(
            f"(1.0) can0 {frame}\n"
            for frame in (
                "7E5#40F0020000000000", "7E5#41A3010000000000", "7E5#4200000100000000", "7E5#434D000000000000",
                "7E4#4400000000000000", "7E5#1105000000000000", "7E4#1100000000000000", "705#00",
            )
        )
        identity = "vendor-ID 000002F0h, product code 000001A3h, revision number 00010000h, serial number 0000004Dh"
        lines = self.lines(log=log)
        self.assertTrue(lines[4].endswith("selected: " + identity), lines[4])
        self.assertTrue(lines[6].endswith("node-ID done: node 5 (05h) is " + identity), lines[6])
        self.assertTrue(lines[7].endswith("boot-up          node 5 (05h): " + identity), lines[7])

    def test_shows_how_far_a_long_log_is_read_to_who_waits_at_a_terminal(self):
        frame = "(1.0) can0 70A#05\n"
        log = self.log((frame + "#" + "-" * 3500 + "\n") * 20_000)
        terminal, side = pty.openpty()
        with open("/dev/null", "wb") as nowhere:
            done = subprocess.run([CANVOY, "decode", log], stdout=nowhere, stderr=side, check=False, timeout=120)
        os.close(side)
        shown = all_of(terminal)
        os.close(terminal)
        self.assertEqual(done.returncode, DONE)
        self.assertIn("\r 50 % ", shown)
        self.assertTrue(shown.endswith("\r      \r"), "nothing of it stays")
        self.assertEqual(len(self.assert_done(run("decode", log)).splitlines()), 20_000, "and nothing to a pipe")

    def test_monitor_reads_what_decode_reads(self):
        for ending in ("asc", "pcapng"):
            log = self.log() + "." + ending
            self.assert_done(run("convert-log", self.log(), log))
            shown = self.assert_done(run("monitor", log))
            self.assertEqual(shown, self.assert_done(run("decode", log)))
            self.assertIn("temperature = 20.000 °C", shown)
        trc = self.log("").replace("bus.log", "bus.trc")
        pathlib.Path(trc).write_text(";$FILEVERSION=1.1\n;$STARTTIME=43008.5\n     1)         1.0  Rx         070A  1  05\n")
        self.assertIn("operational", self.assert_done(run("monitor", trc)))

    def test_writes_the_meaning_as_comments_of_packets(self):
        out = self.log("") + ".pcapng"
        self.assert_done(run("decode", self.log(), "--out", out))
        content = pathlib.Path(out).read_bytes()
        self.assertIn("TPDO1 node 10 (0Ah): temperature = 20.000 °C; battery_status = ready".encode(), content)
        again = self.assert_done(run("decode", out))
        self.assertEqual(len(again.splitlines()), 7)
        self.assertIn("temperature = 20.000 °C", again)

    def test_writes_the_frames_that_pass_the_filters_as_another_log(self):
        out = self.log("") + ".log"
        self.assert_done(run("decode", self.log(), "--filter", "object=temperature", "--out", out))
        self.assertEqual(pathlib.Path(out).read_text(), "(0000000001.100000) can0 18A#A00001\n")

    def test_what_is_refused_leaves_the_log_of_before(self):
        for out in (self.log("") + ".log", self.log("") + ".pcapng"):
            for content in ("", "Dear reader,\n", ";$FILEVERSION=1.1\n;$STARTTIME=43008.5\n", "(1.000000) can0 185##01E2F\n"):
                with self.subTest(content):
                    pathlib.Path(out).write_text("kept")
                    self.assertEqual(run("decode", self.log(content), "--out", out).returncode, FAILED)
                    self.assertEqual(pathlib.Path(out).read_text(), "kept")
            # Nothing of the new one is left beside it.
            self.assertEqual([path.name for path in pathlib.Path(out).parent.iterdir() if path.name.endswith(".part")], [])

    def test_a_log_from_a_pipe_does_not_become_itself(self):
        log = self.log()
        for verb in (["decode", "-", "--out", log], ["convert-log", "-", log]):
            with open(log, encoding="ascii") as standard_input:
                result = subprocess.run([CANVOY, *verb], stdin=standard_input, capture_output=True, text=True, timeout=60, check=False)
            self.assert_refused(result, USAGE, log)
            self.assertEqual(pathlib.Path(log).read_text(), LOG)

    def test_what_came_by_a_pipe_is_kept_when_it_is_interrupted(self):
        out = self.log("") + ".log"
        with subprocess.Popen([CANVOY, "decode", "-", "--out", out], stdin=subprocess.PIPE, bufsize=0) as process:
            many = LOG * 2000
            process.stdin.write(many.encode())  # more than a pipe holds: it has been begun with
            process.send_signal(signal.SIGINT)
            process.stdin.close()
        self.assertEqual(process.returncode, DONE)
        lines = pathlib.Path(out).read_text().splitlines()
        self.assertGreater(len(lines), 0)
        self.assertLessEqual(len(lines), 14_000)

    def test_counts_bad_lines_and_goes_on(self):
        result = run("decode", self.log(LOG + "junk\n" + LOG))
        self.assertEqual(result.returncode, DONE)
        self.assertEqual(len(result.stdout.splitlines()), 14)
        self.assertIn("line 8: ", result.stderr)
        self.assertIn("1 lines or blocks could not be read", result.stderr)

    def test_refuses_what_it_does_not_understand(self):
        log = self.log()
        nameless = log + ".nameless.eds"
        pathlib.Path(nameless).write_text("[2000]\nParameterName=Fan\nObjectType=7\nDataType=5\nAccessType=rw\n")
        for arguments, parts in [
            (["--node", "128"], ["'128'", "1 to 127"]),
            (["--node", "128=419"], ["'128'", "1 to 127"]),
            (["--node", "5=999"], ["'999'", "447-3"]),
            (["--profile", "999"], ["'999'", "447-3"]),
            (["--reading", "852"], ["'852'", "852=wide-displays"]),
            (["--reading", "852=narrow"], ["'narrow'", "wide-displays"]),
            (["--reading", "419=any"], ["'any'", "there is but one"]),
            (["--eds", nameless], ["vendor-ID", "5="]),
            (["--eds", "5="], ["'5='", "5=FILE"]),
            (["--eds", "0=x.eds"], ["'0'", "1 to 127"]),
            (["--out", "bus.xml"], ["bus.xml: its end says no format", ".pcapng"]),
            (["--out", "bus.pcapng", "--json"], ["--json", "--out"]),
            (["--count", "0"], ["--count"]),
        ]:
            self.assert_refused(run("decode", log, *arguments), USAGE, *parts)
        self.assert_refused(run("decode", log, "--out", log), USAGE, "is the log itself")
        self.assertEqual(pathlib.Path(log).read_text(), LOG)
        self.assert_refused(run("decode", log, "--eds", "5=/no/such.eds"), FAILED, "/no/such.eds")
        self.assert_refused(run("decode", log, "--eds", "no.eds"), FAILED, "no.eds")
        self.assert_refused(run("decode", "/no/such/file"), FAILED, "/no/such/file")


if __name__ == "__main__":
    unittest.main()
