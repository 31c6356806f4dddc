"""What an emulated machine boots (scripts/socketcan-vm): Debian's stock kernel, and a first program of our own."""

import contextlib
import fcntl
import os
import pathlib
import platform
import shutil
import subprocess
import tempfile
import time

# In the order in which they are loaded. Some are built into some kernels: a missing one is no mistake.
MODULES = (
    "virtio_ring virtio virtio_pci_modern_dev virtio_pci_legacy_dev virtio_pci netfs fscache 9pnet 9pnet_virtio 9p "
    "can can-raw can-dev vcan sja1000 kvaser_pci evdev uinput"
)
PROGRAMS = ("qemu-system-x86_64", "busybox", "cpio", "ip", "apt-get", "dpkg-deb", "setpriv")

# Mounts this machine's root, and serves jobs: their files are in /job, and the second serial port says which is to run or
# to be killed, and is told how each has ended. Names of files are looked up anew for each job, since the root is cached
# and others change it; what programs have in memory stays.
INIT = r"""#!/bin/busybox sh
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs dev /dev
for module in $(cat /modules/order); do
  [ ! -f /modules/$module.ko ] || insmod /modules/$module.ko
done
mount -t 9p -o trans=virtio,version=9p2000.L,msize=262144,cache=loose hostroot /h || poweroff -f
mount -t 9p -o trans=virtio,version=9p2000.L job /job || poweroff -f
mount -t devtmpfs dev /h/dev
mkdir -p /h/dev/pts /h/dev/shm
mount -t devpts devpts /h/dev/pts

run_job() {
  echo 2 >/proc/sys/vm/drop_caches
  unshare -n -m -p -f /enter $1 </dev/null >/job/$1/stdout 2>/job/$1/stderr
  status=$?
  sync
  rm /running/$1
  echo "done $1 $status"
}

# The first process of a job takes all others with it.
kill_job() {
  while [ -e /running/$1 ] && [ ! -s /running/$1 ]; do usleep 100000; done
  [ ! -e /running/$1 ] || kill -9 $(cat /running/$1)
}

stty -F /dev/ttyS1 raw -echo
exec </dev/ttyS1 >/dev/ttyS1
echo ready
while read -r verb job; do
  case $verb in
    run) : >/running/$job; run_job $job & ;;
    kill) kill_job $job & ;;
  esac
done
poweroff -f
"""

# The first process of a job, in a network of its own and with processes and mounts of its own. A controller comes back to
# the machine's network a moment after the job that had it.
ENTER = r"""#!/bin/busybox sh
read -r pid rest </proc/self/stat
echo $pid >/running/$1
if [ -e /job/$1/controllers ]; then
  for controller in can0 can1; do
    for i in $(seq 100); do
      nsenter -n/proc/1/ns/net ip link set $controller netns 1 2>/dev/null && break || usleep 100000
    done
    ip link show $controller >/dev/null || exit 125
  done
fi
mount -t proc proc /h/proc && mount -t sysfs sysfs /h/sys && mount -t tmpfs run /h/run || exit 125
mount -t tmpfs shm /h/dev/shm || exit 125
ip link set lo up
for bus in vcan0 vcan1; do ip link add $bus type vcan && ip link set $bus up || exit 125; done
exec chroot /h /bin/bash -c "$(cat /job/$1/command)"
"""


class Unavailable(Exception):
    """There is no such machine to be had, and why."""


def require_programs():
    if platform.machine() != "x86_64":
        raise Unavailable(f"only an x86_64 machine is emulated, this is {platform.machine()}")
    for program in PROGRAMS:
        if shutil.which(program) is None:
            raise Unavailable(f"{program} is missing; scripts/install-packages test installs it")
    if subprocess.run(["ldd", shutil.which("busybox")], capture_output=True, check=False).returncode == 0:
        raise Unavailable("busybox is not the static one of the package busybox-static")


@contextlib.contextmanager
def locked(path):
    with open(path, "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def kernel_package():
    """linux-image-6.1.0-<n>-amd64, or nothing."""
    words = ["apt-cache", "depends", "linux-image-amd64"]
    lines = subprocess.run(words, capture_output=True, text=True, check=False).stdout.splitlines()
    found = (line.partition("Depends: ")[2].strip() for line in lines)
    return next((name for name in found if name.startswith("linux-image-")), None)


def download_kernel(folder, log):
    """Whether the kernel's package is in the folder. The mirrors' lists may be too old to name one that still is."""
    for attempt in range(1, 4):
        package = kernel_package()
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        words = ["apt-get", "download", "-qq", "-o", f"APT::Sandbox::User={user}", package or ""]
        if package and subprocess.run(words, cwd=folder, stdout=log, stderr=log, check=False).returncode == 0:
            return True
        time.sleep(attempt * 2)
        if os.geteuid() == 0:
            subprocess.run(["apt-get", "update", "-qq"], stdout=log, stderr=log, check=False)
    return False


def unpack_kernel(folder, cache):
    kernel = folder / "kernel"
    kernel.mkdir()
    wanted = ["./boot/vmlinuz-*", *(f"*/{module}.ko" for module in MODULES.split())]
    (package,) = folder.glob("*.deb")
    contents = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", package], stdout=subprocess.PIPE)
    # tar complains of patterns that match nothing: the modules that are built in.
    words = ["tar", "-x", "-C", kernel, "--wildcards", *wanted]
    subprocess.run(words, stdin=contents.stdout, stderr=subprocess.DEVNULL, check=False)
    contents.communicate()
    shutil.rmtree(cache / "modules", ignore_errors=True)
    (cache / "modules").mkdir()
    for module in kernel.rglob("*.ko"):
        module.rename(cache / "modules" / module.name)
    (cache / "modules" / "list").write_text(MODULES + "\n")
    (image,) = (kernel / "boot").glob("vmlinuz-*")
    image.rename(cache / "vmlinuz")


def fetch_kernel(cache):
    """Fills the cache with the kernel and the modules that it needs, unless they are there: those of an older list of
    modules serve where no other can be had."""
    cache.mkdir(parents=True, exist_ok=True)
    is_there = (cache / "vmlinuz").exists()
    listed = cache / "modules" / "list"
    with locked(cache / "lock"):
        if is_there and listed.exists() and listed.read_text().strip() == MODULES:
            return
        with tempfile.TemporaryDirectory(prefix="fetch.", dir=cache) as name:
            with (cache / "fetch.log").open("w") as log:
                is_downloaded = download_kernel(name, log)
            if is_downloaded:
                unpack_kernel(pathlib.Path(name), cache)
            elif not is_there:
                last = (cache / "fetch.log").read_text().strip().rpartition("\n")[2]
                raise Unavailable(f"no kernel could be downloaded: {last}")


def build_initramfs(cache, path):
    with tempfile.TemporaryDirectory(prefix="tree.", dir=cache) as name:
        tree = pathlib.Path(name)
        for folder in ("bin", "dev", "h", "job", "modules", "proc", "running", "sys"):
            (tree / folder).mkdir()
        shutil.copy(shutil.which("busybox"), tree / "bin" / "busybox")
        for module in (cache / "modules").glob("*.ko"):
            shutil.copy(module, tree / "modules")
        (tree / "modules" / "order").write_text("\n".join(MODULES.split()) + "\n")
        for script, text in (("init", INIT), ("enter", ENTER)):
            (tree / script).write_text(text)
            (tree / script).chmod(0o755)
        with path.open("wb") as file:
            subprocess.run("find . | cpio -o -H newc --quiet", shell=True, cwd=tree, stdout=file, check=True)
