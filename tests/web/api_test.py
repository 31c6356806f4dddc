#!/usr/bin/env python3
"""The API is what /openapi.json says, seen from outside: schemathesis calls each operation with what the description has,
and with what it does not have, and compares each answer with it.

    CANVOY=build/canvoy tests/web/api_test.py               as in ctest
    CANVOY=build/canvoy tests/web/api_test.py 2000 7        so many cases for each operation, by this seed

It runs in the environment that scripts/install-packages makes of tests/web/requirements.txt.
"""

import collections
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

HERE = pathlib.Path(__file__).resolve().parent
ENVIRONMENT = HERE.parents[1] / "build" / "web" / "venv"
CANVOY = os.path.abspath(os.environ.get("CANVOY", "build/canvoy"))
TOKEN = "0123456789abcdef0123"
CASES, SEED = (sys.argv[1:] + ["12", "1"][len(sys.argv) - 1 :])[:2]

# What is looked at; names that it has; operations that are never done to it, for which 403, 404 or 409 is the answer.
LIFT = {"bus": ["lift1"], "node": [2, 4], "object": ["1017", "1018:4"], "value": ["500", "hex:01 02"],
        "fault": ["heartbeat-loss"], "from": [1], "to": [3], "faults": [[], ["heartbeat-loss@10s"]], "is_run": True}  # fmt: skip
LOG = {"bus": ["sim0"], "node": [5, 10], "object": ["1000"], "is_run": False}
NOT_OF_A_LOG = {"runFile", "read", "write", "nmt", "fault", "visit", "record"}


class Server:
    """The command, and what it serves."""

    def __init__(self, folder, *arguments):
        environment = {**os.environ, "CANVOY_WEB_TOKEN": TOKEN}
        self.process = subprocess.Popen([CANVOY, *arguments], stdout=subprocess.PIPE, text=True, env=environment, cwd=folder)
        url = self.process.stdout.readline().strip()
        self.address = url.partition("/?")[0]

    def get(self, path):
        request = urllib.request.Request(self.address + path, headers={"Authorization": f"Bearer {TOKEN}"})
        with urllib.request.urlopen(request, timeout=60) as response:
            return json.load(response)

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        return self.process.communicate(timeout=60) and self.process.returncode


def check(name, server, names, never, folder):
    """The findings, a line each."""
    answers = pathlib.Path(folder, "answers")
    answers.write_text("")
    environment = {**os.environ, "SCHEMATHESIS_HOOKS": "api_hooks", "PYTHONPATH": str(HERE), "PYTHONDONTWRITEBYTECODE": "1",
                   "CANVOY_API_NAMES": json.dumps(names), "CANVOY_API_ANSWERS": str(answers),
                   "CANVOY_API": server.address, "CANVOY_API_TOKEN": TOKEN}  # fmt: skip
    done = subprocess.run(
        [ENVIRONMENT / "bin" / "schemathesis", "--config-file", HERE / "schemathesis.toml", "run", server.address + "/openapi.json",
         "--header", f"Authorization: Bearer {TOKEN}", "--checks", "all", "--phases", "coverage,fuzzing", "--workers", "1",
         "--max-examples", CASES, "--seed", SEED, "--generation-database", "none",
         "--generation-with-security-parameters", "false", "--output-truncate", "false", "--warnings", "off"],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment, cwd=folder, check=False)  # fmt: skip
    counts = collections.Counter(tuple(line.split()) for line in answers.read_text().splitlines())
    print(f"{name}: {sum(counts.values())} answers; " + ", ".join(f"{count} of {status}" for status, count in sorted(
        collections.Counter({s: sum(n for (_, status), n in counts.items() if status == s) for _, s in counts}).items())))  # fmt: skip
    findings = [done.stdout] if done.returncode else []
    # A run of schemathesis that never gets through says nothing.
    operations = [each for methods in server.get("/openapi.json")["paths"].values() for each in methods.values()]
    for operation in operations:
        identity = operation["operationId"]
        wanted = set() if identity in never else {"200"}
        wanted |= {"400"} if "requestBody" in operation or "parameters" in operation else set()
        findings += [f"{name}: {identity} was never answered with {status}" for status in wanted if not counts[identity, status]]
    return findings


def main():
    if not (ENVIRONMENT / "bin" / "schemathesis").exists():
        print("skipped: schemathesis is missing; scripts/install-packages test installs it")
        sys.exit(77)
    findings = []
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "bus.log")
        subprocess.run([CANVOY, "run", "charger", "--for", "20s", "--log", log], stdout=subprocess.DEVNULL, check=True)
        os.mkdir(os.path.join(folder, "logs"))
        for name, names, never, arguments in (
            ("lift", LIFT, set(), ("run", "lift", "--floors", "5", "--percent", "0", "--for", "1min", "--web", "--speed", "1",
                                   "--allow-write", "all", "--allow-record", "logs")),
            ("log", LOG, NOT_OF_A_LOG, ("view", log)),
        ):  # fmt: skip
            server = Server(folder, *arguments)
            until = time.monotonic() + 60
            while not server.get("/api/networks") and time.monotonic() < until:
                time.sleep(0.05)
            findings += check(name, server, names, never, folder)
            status = server.end()
            findings += [f"{name}: the command ended with {status}"] if status not in (0, 1) else []
    print("\n".join(findings))
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
