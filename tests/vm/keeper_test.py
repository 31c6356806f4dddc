#!/usr/bin/env python3
"""What scripts/socketcan-vm does where a machine dies, hangs or is not wanted any more, by a stand-in for the emulator that
does so when it is told to.

    tests/vm/keeper_test.py
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts"
sys.path.append(str(SCRIPTS))
import vm_keeper
from vm_image import Unavailable, require_programs

PATIENCE = 60  # seconds
DIED, TIMED_OUT, SKIPPED = 125, 124, 77

# Its command line names the folder of jobs; it is ready at once, and does what stands in the job's last line.
EMULATOR = r"""#!/usr/bin/env python3
import os, re, sys
jobs = re.search("local,path=([^,]*),mount_tag=job", " ".join(sys.argv))[1]
print("this is the console", file=open("console", "w"))
if os.environ.get("EMULATOR") == "does not boot":
    sys.exit(1)
print("ready", flush=True)
for line in sys.stdin:
    verb, number = line.split()
    if verb == "kill" and job != "hang":
        print("done", number, 137, flush=True)
    elif verb == "run":
        words = open(f"{jobs}/{number}/command").read()
        job = next((each for each in ("die", "hang", "work", "wait") if f"JOB={each}" in words), "")
        if job == "die":
            sys.exit(1)
        if job == "work":
            print("worked", file=open(f"{jobs}/{number}/stdout", "w"))
            print("done", number, 5, flush=True)
"""


class Machine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        emulator = self.root / "bin" / "qemu-system-x86_64"
        emulator.parent.mkdir()
        emulator.write_text(EMULATOR)
        emulator.chmod(0o755)
        path = f"{emulator.parent}:{os.environ['PATH']}"
        self.environment = {**os.environ, "PATH": path, "CANVOY_VM_MACHINE": str(self.root / "machine")}
        self.folder = vm_keeper.Folder(self.root / "machine")

    def until(self, what, holds):
        give_up = time.monotonic() + PATIENCE
        while not holds():
            self.assertLess(time.monotonic(), give_up, what)
            time.sleep(0.01)


class Keeper(Machine):
    """The keeper alone, in a thread."""

    def setUp(self):
        super().setUp()
        self.folder.jobs.mkdir(parents=True)
        before = (os.environ["PATH"], vm_keeper.KILL_SECONDS, vm_keeper.IDLE_SECONDS)
        self.addCleanup(self.restore, *before)
        os.environ["PATH"] = self.environment["PATH"]
        self.keeper = vm_keeper.Keeper(self.folder, "kernel")
        self.thread = threading.Thread(target=self.keeper.run)
        self.starters = [self.process(), self.process()]
        self.keeper.stay(self.starters[0].pid)

    def restore(self, path, kill, idle):
        self.keeper.is_ending = True
        if self.thread.ident is not None:
            self.thread.join()
        os.environ["PATH"], vm_keeper.KILL_SECONDS, vm_keeper.IDLE_SECONDS = path, kill, idle

    def process(self):
        program = subprocess.Popen(["sleep", "1000"])
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        return program

    def ask(self, **request):
        client = self.folder.connect()
        client.sendall(vm_keeper.json.dumps(request).encode() + b"\n")
        return client

    def answer(self, client):
        client.settimeout(PATIENCE)
        words = vm_keeper.json.loads(client.makefile().readline())
        client.close()
        return words

    def job(self, does, seconds=1000):
        return self.ask(command=f"JOB={does}", controllers=False, seconds=seconds)

    def has_ended(self):
        return not self.thread.is_alive() and self.keeper.qemu.poll() is not None

    def test_a_job_that_ends_is_answered(self):
        self.thread.start()
        answer = self.answer(self.job("work"))
        self.assertEqual(answer["status"], 5)
        self.assertEqual((pathlib.Path(answer["folder"]) / "stdout").read_text(), "worked\n")

    def test_a_machine_that_dies_is_told_of_and_its_folder_stays(self):
        self.thread.start()
        waiting = self.job("wait")
        self.until("the job", lambda: self.keeper.jobs)
        for client in (self.job("die"), waiting):
            answer = self.answer(client)
            self.assertEqual((answer["status"], answer["error"]), (DIED, "the machine died before the command ended"))
        self.until("the end", self.has_ended)
        self.assertEqual(self.folder.last_words(), "this is the console")
        self.assertIsNone(self.folder.connect())

    def test_a_job_whose_time_is_over_is_killed(self):
        self.thread.start()
        self.assertEqual(self.answer(self.job("wait", seconds=0.1))["status"], TIMED_OUT)
        self.assertEqual(self.answer(self.job("work"))["status"], 5)

    def test_a_job_that_nobody_waits_for_is_killed_and_forgotten(self):
        self.thread.start()
        client = self.job("wait")
        self.until("the job", lambda: self.keeper.jobs)
        client.close()
        self.until("its end", lambda: not self.keeper.jobs and not any(self.folder.jobs.iterdir()))
        self.assertEqual(self.answer(self.job("work"))["status"], 5)

    def test_a_machine_that_hangs_is_told_of(self):
        vm_keeper.KILL_SECONDS = 0.1
        self.thread.start()
        answer = self.answer(self.job("hang", seconds=0.1))
        self.assertEqual((answer["status"], answer["error"]), (DIED, "the machine does not answer any more"))
        self.until("the end", self.has_ended)

    def test_it_stays_until_all_who_want_it_are_gone(self):
        self.thread.start()
        first, second = self.starters
        self.answer(self.ask(stay=second.pid))
        first.kill()
        first.wait()
        self.assertEqual(self.answer(self.job("work"))["status"], 5)
        waiting = self.job("wait")
        self.until("the job", lambda: self.keeper.jobs)
        second.kill()
        self.assertEqual(self.answer(waiting)["error"], "the machine was told to end")
        self.until("the end", lambda: self.has_ended() and not self.folder.path.exists())

    def test_who_leaves_is_told_whether_it_ends(self):
        self.thread.start()
        first, second = self.starters
        self.answer(self.ask(stay=second.pid))
        self.assertFalse(self.answer(self.ask(leave=first.pid))["is_ending"])
        self.assertTrue(self.answer(self.ask(leave=second.pid))["is_ending"])
        self.until("the end", self.has_ended)

    def test_it_ends_where_nobody_asks_for_anything(self):
        vm_keeper.IDLE_SECONDS = 0.1
        self.thread.start()
        self.until("the end", lambda: self.has_ended() and not self.folder.path.exists())


class Script(Machine):
    """scripts/socketcan-vm itself."""

    def vm(self, *arguments, **environment):
        """Its status, and what it printed."""
        done = subprocess.run([SCRIPTS / "socketcan-vm", *arguments], env={**self.environment, **environment},
                              capture_output=True, text=True, timeout=PATIENCE, check=False)  # fmt: skip
        return done.returncode, done.stdout, done.stderr

    def test_a_command_boots_a_machine_for_itself(self):
        self.assertEqual(self.vm("env", "JOB=work"), (5, "worked\n", ""))
        self.assertFalse(self.folder.path.exists())

    def test_a_machine_that_does_not_boot_is_told_of(self):
        status, _, errors = self.vm("true", EMULATOR="does not boot")
        self.assertEqual(status, DIED)
        self.assertIn("this is the console", errors)

    def test_commands_run_in_the_machine_that_was_started(self):
        self.assertEqual(self.vm("--start")[0], 0)
        console = self.folder.console.stat()
        self.assertEqual(self.vm("env", "JOB=work")[:2], (5, "worked\n"))
        self.assertEqual(self.vm("--start")[0], 0)
        self.assertEqual(self.folder.console.stat(), console, "it is the same")
        self.assertEqual(self.vm("--timeout", "1", "env", "JOB=wait")[0], TIMED_OUT)
        self.assertEqual(self.vm("--stop")[0], 0)
        self.assertFalse(self.folder.path.exists())
        self.assertEqual(self.vm("--stop")[0], SKIPPED)

    def test_a_dead_machine_is_told_of_and_the_next_command_has_its_own(self):
        self.assertEqual(self.vm("--start")[0], 0)
        status, _, errors = self.vm("env", "JOB=die")
        self.assertEqual(status, DIED)
        self.assertIn("the machine died before the command ended", errors)
        status, printed, errors = self.vm("env", "JOB=work")
        self.assertEqual((status, printed), (5, "worked\n"))
        self.assertIn("has died", errors)
        self.assertEqual(self.vm("--stop")[0], DIED)
        self.assertEqual(self.vm("--stop")[0], SKIPPED)

    def test_a_machine_ends_with_who_started_it_however_that_ends(self):
        starter = subprocess.Popen([f"{SCRIPTS}/socketcan-vm --start && echo up && read end"], shell=True, text=True,
                                   env=self.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE)  # fmt: skip
        self.addCleanup(starter.communicate)
        self.assertEqual(starter.stdout.readline(), "up\n")
        starter.send_signal(signal.SIGKILL)
        starter.wait()
        self.until("the end of the machine", lambda: not self.folder.path.exists())

    def test_wrong_usage_is_refused(self):
        for arguments in ((), ("--timeout", "0", "true"), ("--timeout", "x", "true"), ("--start", "true"), ("--what", "true")):
            self.assertEqual(self.vm(*arguments)[0], 2, arguments)


if __name__ == "__main__":
    try:
        require_programs()
    except Unavailable as reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    unittest.main()
