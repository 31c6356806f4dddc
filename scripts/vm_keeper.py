"""Keeps an emulated machine (scripts/socketcan-vm) in a folder, and hands it jobs.

Who wants something connects to the folder's socket and sends a line of JSON:

    {"command": TEXT, "controllers": BOOLEAN, "seconds": N}
                                      a job for bash, answered when it has ended, with a folder that has its `stdout`
                                      and `stderr`: {"folder": PATH, "status": N}, and "error" where it has not ended
                                      by itself. A job whose client goes away is killed
    {"stay": PID}                     the machine stays until this process is gone, or says:
    {"leave": PID}                    answered by whether the machine ends: {"is_ending": true}

The machine ends when all who asked it to stay are gone, and after IDLE_SECONDS in which nobody has asked for anything;
then the folder is gone too. That of a machine that died is still there.
"""

import json
import os
import pathlib
import selectors
import shutil
import socket
import subprocess
import sys
import time

IDLE_SECONDS = 1800
# From the kill of a job to its end, which takes less than a second.
KILL_SECONDS = 30
DIED = "the machine died before the command ended"

QEMU = (
    "setpriv --pdeathsig KILL qemu-system-x86_64 -accel tcg,thread=multi -cpu max -M q35 -smp 2 -m 1024 -display none "
    "-monitor none -nic none -no-reboot "
    "-object can-bus,id=bus -device kvaser_pci,canbus=bus -device kvaser_pci,canbus=bus "
    "-virtfs local,path=/,mount_tag=hostroot,security_model=none,multidevs=remap -serial file:console -serial stdio"
)
# no_timer_check: on a busy machine, the first ticks come too late for the kernel's trial of its timer, and it gives up.
# Not tsc=reliable: on a busy machine, the kernel has measured the emulated counter of cycles wrong, and its clock ran at four
# times its speed.
KERNEL_OPTIONS = "console=ttyS0 quiet nokaslr mitigations=off panic=-1 no_timer_check rcupdate.rcu_expedited=1"


class Folder:
    """What a machine has on this one. The socket is named by way of a descriptor: sockets have short names only."""

    def __init__(self, path):
        self.path = pathlib.Path(path).absolute()
        self.jobs = self.path / "jobs"
        self.console = self.path / "console"

    def named(self, do):
        folder = os.open(self.path, os.O_PATH)
        try:
            return do(f"/proc/self/fd/{folder}/socket")
        finally:
            os.close(folder)

    def listen(self):
        listener = socket.socket(socket.AF_UNIX)
        self.named(listener.bind)
        listener.listen(50)
        return listener

    def connect(self):
        """A connection to the keeper; None where there is none."""
        client = socket.socket(socket.AF_UNIX)
        try:
            self.named(client.connect)
        except (FileNotFoundError, ConnectionRefusedError):
            client.close()
            return None
        return client

    def last_words(self):
        """What the machine printed last."""
        text = self.console.read_text(errors="replace") if self.console.exists() else ""
        return "\n".join(text.splitlines()[-20:])


class Job:
    def __init__(self, client, folder, seconds):
        self.client = client
        self.folder = folder
        self.deadline = time.monotonic() + seconds
        self.kill_deadline = None


class Keeper:
    def __init__(self, folder, kernel):
        self.folder = folder
        self.jobs = {}  # by their numbers
        self.count = 0
        self.stays = {}  # descriptors of processes, by their numbers
        self.is_ending = False
        self.trouble = ""  # why it is no machine any more
        self.selector = selectors.DefaultSelector()
        self.listener = folder.listen()
        self.selector.register(self.listener, selectors.EVENT_READ, self.accept)
        self.qemu = self.start(kernel)
        self.selector.register(self.qemu.stdout, selectors.EVENT_READ, self.hear)
        self.rest = b""
        self.last_asked = time.monotonic()

    def start(self, kernel):
        share = f"local,path={self.folder.jobs},mount_tag=job,security_model=none"
        words = [*QEMU.split(), "-kernel", kernel, "-initrd", self.folder.path / "initramfs", "-virtfs", share]
        words += ["-append", KERNEL_OPTIONS]
        return subprocess.Popen(words, cwd=self.folder.path, stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def run(self):
        """Until the machine ends."""
        while not (self.is_ending or self.trouble):
            for key, _ in self.selector.select(timeout=1):
                key.data(key.fileobj)
            self.look_at_the_clock()
        self.qemu.kill()
        self.qemu.communicate()
        for number in list(self.jobs):
            self.answer(number, status=125, error=self.trouble or "the machine was told to end")
        self.listener.close()
        if not self.trouble:
            shutil.rmtree(self.folder.path)

    def look_at_the_clock(self):
        now = time.monotonic()
        for number, job in self.jobs.items():
            if job.kill_deadline is None and now > job.deadline:
                self.kill(number)
            elif job.kill_deadline is not None and now > job.kill_deadline:
                self.trouble = "the machine does not answer any more"
        if self.jobs:
            self.last_asked = now
        self.is_ending |= now - self.last_asked > IDLE_SECONDS

    def tell(self, text):
        try:
            self.qemu.stdin.write(text.encode() + b"\n")
            self.qemu.stdin.flush()
        except BrokenPipeError:
            self.trouble = DIED

    def hear(self, pipe):
        """`ready`, or `done NUMBER STATUS`."""
        data = os.read(pipe.fileno(), 4096)
        if not data:
            self.trouble = DIED
        *lines, self.rest = (self.rest + data).split(b"\n")
        for line in lines:
            match line.decode(errors="replace").split():
                case ["ready"]:
                    print("ready", flush=True)
                case ["done", number, status]:
                    self.ended(int(number), int(status))

    def ended(self, number, status):
        job = self.jobs[number]
        if job.kill_deadline is not None and job.client is not None:
            self.answer(number, status=124, error="the command was still running after its time")
        else:
            self.answer(number, status=status)

    def accept(self, listener):
        client, _ = listener.accept()
        self.selector.register(client, selectors.EVENT_READ, self.ask)

    def ask(self, client):
        request = client.makefile().readline()
        self.last_asked = time.monotonic()
        self.selector.unregister(client)
        match json.loads(request) if request else None:
            case {"command": command, "controllers": controllers, "seconds": seconds}:
                self.begin(client, command, controllers, seconds)
            case {"stay": process}:
                self.stay(process)
                self.send(client, {})
            case {"leave": process}:
                self.leave(process)
                self.send(client, {"is_ending": self.is_ending})
            case None:
                client.close()

    def begin(self, client, command, controllers, seconds):
        self.count += 1
        folder = self.folder.jobs / str(self.count)
        folder.mkdir()
        (folder / "command").write_text(command)
        if controllers:
            (folder / "controllers").touch()
        self.jobs[self.count] = Job(client, folder, seconds)
        number = self.count
        self.selector.register(client, selectors.EVENT_READ, lambda client: self.gone(client, number))
        self.tell(f"run {number}")

    def kill(self, number):
        self.jobs[number].kill_deadline = time.monotonic() + KILL_SECONDS
        self.tell(f"kill {number}")

    def gone(self, client, number):
        """Who asked for a job does not wait for it any more."""
        self.selector.unregister(client)
        client.close()
        self.jobs[number].client = None
        self.kill(number)

    def answer(self, number, **words):
        job = self.jobs.pop(number)
        if job.client is None:
            shutil.rmtree(job.folder)
            return
        self.selector.unregister(job.client)
        self.send(job.client, {"folder": str(job.folder), **words})

    @staticmethod
    def send(client, words):
        try:
            client.sendall(json.dumps(words).encode() + b"\n")
        except BrokenPipeError:
            pass
        client.close()

    def stay(self, process):
        try:
            self.stays[process] = os.pidfd_open(process)
        except ProcessLookupError:
            return
        self.selector.register(self.stays[process], selectors.EVENT_READ, lambda _: self.leave(process))

    def leave(self, process):
        if process in self.stays:
            self.selector.unregister(self.stays[process])
            os.close(self.stays.pop(process))
        self.is_ending |= not self.stays


def main():
    """vm_keeper.py FOLDER KERNEL PROCESS: stays until the process is gone, and says on its standard output that it is
    ready."""
    path, kernel, process = sys.argv[1:]
    keeper = Keeper(Folder(path), kernel)
    keeper.stay(int(process))
    keeper.is_ending = not keeper.stays
    keeper.run()


if __name__ == "__main__":
    main()
