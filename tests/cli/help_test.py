#!/usr/bin/env python3
"""The help of every verb ends with examples, and all of them run: on a bus with a battery (node 10) and a charger (node 5), in a
folder with the files that they name. So do completion and the pages of man, which are made of the same."""

import concurrent.futures
import os
import pathlib
import pty
import re
import select
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from command import CANVOY, DONE, FAILED, USAGE, CommandTest, run

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
import own_network

BUSES = {"can0": "udp:239.74.163.23:43123", "can1": "udp:239.74.163.23:43124", "udp:239.74.163.2:43113": "udp:239.74.163.23:43123"}
BUS = BUSES["can0"]

# Those that end with something to tell: nobody is on the bus who could do it, there is a difference, or a node (the charger, which
# is an NMT master itself) has its own will, or a node stores nothing while it is operational (08000022h).
FAILING = (
    "lss can0 scan", "lss can0 inquire", "lss can0 set-node-id", "program can0", "--diff", "boot sim", "eds diff", "nmt can0 all", "store can0",
    "script can0,can1",
)  # fmt: skip
# Of canvoy check, where a case fails.
NOT_CONFORMING = 4
# Those that go on until they are interrupted.
ENDLESS = re.compile(r"canvoy (device (?!--list)(?!.*--for)|gateway (?!.*--stdin)|monitor can(?!.*--(for|count))|view |run .*--web)")
ENDLESS_FOR_LONG = re.compile(r"--for 8h|--stay")


def verbs(*path):
    """Each verb with those below it, as its words."""
    text = run(*path, "--help").stdout
    listed = text.split("Subcommands:\n", 1)[1] if "Subcommands:\n" in text else ""
    yield path
    for name in re.findall(r"^  ([a-z][a-z-]*)(?: |$)", listed.split("\n\n")[0], re.MULTILINE):
        yield from verbs(*path, name)


def examples(verb):
    text = run(*verb, "--help").stdout
    _, found, lines = text.partition("Examples:\n")
    return [line.strip() for line in lines.splitlines() if line.strip()] if found else []


class Help(CommandTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        (cls.folder / "bin").mkdir()
        (cls.folder / "bin" / "canvoy").symlink_to(pathlib.Path(CANVOY).resolve())
        # Some examples ask where nothing answers: they do not wait for long.
        cls.variables = dict(os.environ, PATH=f"{cls.folder}/bin:{os.environ['PATH']}", CANVOY_TIMEOUT="3s")
        devices = subprocess.Popen([CANVOY, "device", "charger", "battery", BUS, "--heartbeat", "200ms", "--store", str(cls.folder / "charger.store"),
                                    "--store", str(cls.folder / "battery.store")], stdout=subprocess.DEVNULL)  # fmt: skip
        cls.addClassCleanup(devices.wait)
        cls.addClassCleanup(devices.terminate)
        for _ in range(100):
            if run("read", BUS, "10", "1000", "--timeout", "200ms").returncode == DONE:
                break
        cls.write_files()

    @staticmethod
    def wait_for_the_link():
        """The charger has its battery, and its RPDOs are in use."""
        for _ in range(100):
            if run("read", BUS, "5", "1401:1", "--timeout", "200ms").stdout.startswith("0"):
                return
            time.sleep(0.1)

    @classmethod
    def write_files(cls):
        def make(*arguments):
            assert run(*arguments, cwd=cls.folder).returncode == DONE, arguments

        make("run", "charger", "--for", "2min", "--log", "bus.log")
        shutil.copy(cls.folder / "bus.log", cls.folder / "night.log")
        make("eds", "export", "charger", "--out", "pump.eds")
        make("eds", "export", "battery", "--out", "battery.eds")
        for file in ("battery.dcf", "pump.dcf"):
            make("eds", "export", "battery", "--node-id", "10", "--out", file)
        (cls.folder / "house.toml").write_text(run("run", "lift", "--lifts", "2", "--floors", "4", "--print").stdout)
        (cls.folder / "charging.toml").write_text(run("run", "charger", "--print").stdout)
        (cls.folder / "network.toml").write_text('[master]\nnode = 127\nboot-time = "3s"\n[[slave]]\nnode = 10\nname = "battery"\n')
        (cls.folder / "acceptance.canvoy").write_text("sync\nexpect 10 temperature > -20 within 2s\n")
        (cls.folder / "pump.bin").write_bytes(b"a program")

    def test_every_verb_has_examples(self):
        for verb in verbs():
            if verb in ((), ):
                continue
            with self.subTest(verb=" ".join(verb)):
                self.assertTrue(examples(verb), "no example")

    @staticmethod
    def wait_until_it_can_be_ended(process):
        """It has come to where it catches SIGTERM, or has blocked it to read it from a descriptor."""
        for _ in range(600):
            try:
                status = pathlib.Path(f"/proc/{process}/status").read_text()
            except OSError:
                return
            masks = [int(mask, 16) for mask in re.findall(r"Sig(?:Cgt|Blk):\t(\w+)", status)]
            if not masks or any(mask >> (signal.SIGTERM - 1) & 1 for mask in masks):
                return
            time.sleep(0.1)

    def run_example(self, line):
        # Each in a folder of its own: some write the same file.
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            for file in self.folder.iterdir():
                if file.is_file():
                    shutil.copy(file, folder)
            # Another battery on a bus of its own.
            there = line.replace("can0", "can1") if line.startswith("canvoy device") else line
            command = re.sub("|".join(map(re.escape, BUSES)), lambda found: BUSES[found[0]], there)
            command = command.replace("127.0.0.1:60000", "127.0.0.1:0")
            if "gateway" in command and "--listen" not in command and "--stdin" not in command:
                command += " --listen 127.0.0.1:0"
            shell = subprocess.Popen(["bash", "-c", f"exec {command}" if "|" not in command else command], cwd=folder, env=self.variables,
                                     stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")  # fmt: skip
            if ENDLESS.search(line) or ENDLESS_FOR_LONG.search(line):
                if "|" not in command:
                    self.wait_until_it_can_be_ended(shell.pid)
                time.sleep(1)
                shell.send_signal(signal.SIGTERM)
            output, errors = shell.communicate(timeout=120)
            return line, shell.returncode, output, errors

    def test_all_examples_run(self):
        lines = [line for verb in verbs() for line in examples(verb)]
        self.assertGreater(len(lines), 60)
        # A node answers one SDO client at a time, and who resets or stops it is in the way of those that ask.
        alone = [line for line in lines if re.search("can0|udp:", line) and not re.match("canvoy (monitor|device)", line)]
        # A conformance test comes last: the charger has followed what it has tried.
        alone.sort(key=lambda line: ("pdo" not in line, line.startswith("canvoy check")))
        beside = [line for line in lines if line not in alone]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            done = list(pool.map(self.run_example, beside))
        for line in alone:
            if "rpdo2" in line:
                self.wait_for_the_link()
            done.append(self.run_example(line))
            if "nmt" in line:  # awake again
                run("nmt", BUS, "all", "start", "--unchecked")
        for line, status, output, errors in done:
            with self.subTest(example=line):
                allowed = (DONE, FAILED) if any(word in line for word in FAILING) else (DONE,)
                if line.startswith("canvoy check can0"):
                    allowed = (DONE, NOT_CONFORMING)  # the charger starts the battery when it likes
                self.assertIn(status, allowed, f"{output[-500:]}\n{errors}")

    def test_options_of_each_example_may_stand_in_front_of_its_verb(self):
        tried = 0
        for verb in verbs():
            for line in examples(verb):
                words = shlex.split(line)
                at = next((i for i, word in enumerate(words) if word.startswith("-") and word != "-"), None)
                if at is None or words[0] != "canvoy" or "|" in words or "--help" in words:
                    continue
                with self.subTest(example=line):
                    moved = run(*words[at:], *words[1:at], "--help")
                    # What excludes an option has no order.
                    first, other = (sorted(text.split()) for text in (moved.stdout, run(*words[1:at], "--help").stdout))
                    self.assertEqual(first, other, moved.stderr)
                    tried += 1
        self.assertGreater(tried, 60)

    # -- completion

    def complete(self, *words):
        return self.assert_done(run("complete", "--", *words)).splitlines()

    def test_completion_knows_verbs_options_objects_and_states(self):
        self.assertEqual(self.complete("rea"), ["read"])
        self.assertIn("charger", self.complete("run", ""))
        self.assertEqual(self.complete("read", "can0", "10", "1017", "--prof"), ["--profile"])
        self.assertIn("battery_parameters:ah_capacity", self.complete("read", "can0", "10", "battery_par"))
        self.assertEqual(self.complete("read", "can0", "10", "1017", "water_level"), ["water_level_status"])
        self.assertEqual(self.complete("nmt", "can0", "10", "sto"), ["stopped"])
        self.assertEqual(self.complete("write", "can0", "10", "battery_status", "rea"), ["ready"])
        self.assertIn("lift-drive", self.complete("device", "lift-d"))
        self.assertIn("udp:", self.complete("read", "ud"))
        self.assertEqual(self.complete("decode", "bus.log", "--colour", "al"), ["always"])
        self.assertEqual(self.complete("monitor", "can0", "--table", "--by", ""), ["frame", "node", "object"])
        self.assertEqual(self.complete("profile", "447"), ["447-3"])
        self.assertEqual(self.complete("read", "can0", "10", "--profile", "41"), ["417-4", "418", "419"])
        self.assertEqual(self.complete("export", ""), ["csv", "dbc", "html"])
        self.assertEqual(self.complete("decode", "bus"), [], "files are the shell's")
        self.assertNotIn("complete", self.complete(""))

    def test_completion_knows_the_nodes_of_the_network(self):
        network = str(self.folder / "network.toml")
        self.assertEqual(self.complete("read", "--network", network, "can0", "b"), ["battery"])
        # A blank in a name would be two words to a shell; without it the node is found just so.
        (self.folder / "yard.toml").write_text('[[node]]\nnode = 10\nname = "Pump left"\n')
        yard = str(self.folder / "yard.toml")
        self.assertEqual(self.complete("read", "--network", yard, "can0", "pump"), ["Pump_left"])
        self.assertEqual(self.assert_done(run("read", BUS, "Pump_left", "1000", "--network", yard)), self.assert_done(run("read", BUS, "10", "1000")))
        for verb in ("write", "nmt", "expect", "configure", "store", "restore", "emcy", "pdo", "program", "clone", "browse"):
            self.assertIn("battery", self.complete(verb, "--network", network, "can0", "b"), verb)
        self.assertEqual(self.complete("eds", "read", "--network", network, "can0", "b"), ["battery"])
        self.assertEqual(run("complete", "--", "read", "--network", "/no/such", "can0", "b").returncode, FAILED)

    def test_bash_completes(self):
        def bash(line):
            script = (
                f"source scripts/completion/canvoy.bash; COMP_LINE='{line}'; COMP_POINT=${{#COMP_LINE}}; _canvoy; "
                'printf "%s\\n" "${COMPREPLY[@]}"'
            )
            return subprocess.run(["bash", "-c", script], env=self.variables, capture_output=True, text=True, check=True).stdout.split()

        self.assertEqual(bash("canvoy monit"), ["monitor"])
        self.assertEqual(bash("canvoy nmt can0 10 oper"), ["operational"])
        self.assertEqual(bash("canvoy read can0 10 battery_parameters:ah"), ["ah_capacity"], "bash parts words at colons")
        self.assertIn("write", bash("canvoy "))

    @unittest.skipIf(shutil.which("fish") is None, "fish is not installed; scripts/install-packages test installs it")
    def test_fish_completes(self):
        def fish(line):
            script = f"source scripts/completion/canvoy.fish; complete --do-complete '{line}'"
            variables = dict(self.variables, HOME=str(self.folder))
            return subprocess.run(["fish", "--no-config", "-c", script], env=variables, capture_output=True, text=True, check=True).stdout.splitlines()

        self.assertEqual(fish("canvoy monit"), ["monitor"])
        self.assertEqual(fish("canvoy nmt can0 10 oper"), ["operational"])
        self.assertEqual(fish("canvoy read can0 10 battery_parameters:ah"), ["battery_parameters:ah_capacity"])
        self.assertIn("write", fish("canvoy "))

    @unittest.skipIf(shutil.which("zsh") is None, "zsh is not installed; scripts/install-packages test installs it")
    def test_zsh_completes(self):
        network = str(self.folder / "network.toml")
        master, slave = pty.openpty()
        shell = subprocess.Popen(["zsh", "-f", "-i"], env=dict(self.variables, TERM="xterm", CANVOY_NETWORK=network), stdin=slave, stdout=slave, stderr=slave, start_new_session=True)
        os.close(slave)
        self.addCleanup(os.close, master)
        self.addCleanup(shell.wait)
        self.addCleanup(shell.kill)

        def type_in(keys, wanted):
            os.write(master, keys.encode())
            shown = b""
            while not re.search(wanted, shown):
                ready, _, _ = select.select([master], [], [], 30)
                self.assertTrue(ready, f"{wanted} is not shown: {shown}")
                shown += os.read(master, 65536)
            return re.search(wanted, shown)[1].decode()

        # What is asked for completion goes to the command; what is called in the end is shown.
        type_in("unsetopt prompt_sp; PS1=; RPS1=; fpath=($PWD/scripts/completion $fpath); autoload -U compinit; compinit -u -D; echo rea''dy\n", rb"(ready)")
        type_in('canvoy() { if [[ $1 == complete ]]; then command canvoy "$@"; else print -r -- "<<$*>>"; fi }; echo defi''ned\n', rb"(defined)")
        for typed, wanted in (
            ("canvoy monit\t", "monitor"),
            ("canvoy nmt can0 10 oper\t", "nmt can0 10 operational"),
            ("canvoy read can0 batt\t", "read can0 battery"),
            ("canvoy read can0 10 battery_parameters:ah\t", "read can0 10 battery_parameters:ah_capacity"),
            ("canvoy write can0 10 battery_status rea\t", "write can0 10 battery_status ready"),
            ("canvoy decode --colour alw\t", "decode --colour always"),
        ):
            with self.subTest(typed=typed):
                self.assertEqual(type_in(typed + "\n", rb"<<([^$*>\r\n]*)>>").strip(), wanted)

    # -- man

    def test_every_verb_has_a_page(self):
        pages = self.folder / "pages"
        pages.mkdir()
        self.assert_done(run("man", "--all", str(pages)))
        wanted = {"-".join(("canvoy", *verb)) + ".1" for verb in verbs()}
        self.assertEqual({page.name for page in pages.iterdir()}, wanted)
        page = (pages / "canvoy-read.1").read_text()
        for part in (".TH CANVOY\\-READ 1\n", ".SH NAME\ncanvoy\\-read \\- Read objects", ".SH SYNOPSIS\n", "\\-\\-watch", ".SH EXAMPLES\n"):
            self.assertIn(part, page)
        self.assertEqual(self.assert_done(run("man", "read")), page)
        self.assert_refused(run("man", "raed"), USAGE, "'raed'")
        if shutil.which("groff"):
            shown = subprocess.run(["groff", "-man", "-Tutf8", "-ww", str(pages / "canvoy-read.1")], capture_output=True, text=True, check=True)
            self.assertEqual(shown.stderr, "")
            self.assertIn("canvoy read can0 10 temperature", re.sub("\x1b\\[[0-9;]*m|.\x08", "", shown.stdout).replace("‐", "-"))


if __name__ == "__main__":
    own_network.enter_or_skip()
    unittest.main()
