#!/usr/bin/env python3
"""cantools reads the DBC files that `canvoy export` writes, as strictly as it can, and decodes a charge by one: the same
values as `canvoy decode --json`, one by one.

    CANVOY=build/canvoy tests/strangers/with_python tests/strangers/dbc/cantools_test.py
"""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import cantools

CANVOY = os.environ.get("CANVOY", "build/canvoy")


def run(*arguments, encoding="utf-8"):
    done = subprocess.run([CANVOY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, check=False)
    if done.returncode != 0 or done.stderr:
        raise AssertionError(f"{arguments}: {done.returncode} {done.stderr.decode()}")
    return done.stdout.decode(encoding)


def identifier(name):
    """What a DBC calls it."""
    return re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")


class Cantools(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read_dbc(self, *what):
        return cantools.database.load_string(run("export", "dbc", *what, encoding="cp1252"), "dbc", strict=True)

    def test_a_charge_is_decoded_by_both_alike(self):
        log = str(self.folder / "charge.log")
        subprocess.run([CANVOY, "run", "charger", "--for", "1min", "--log", log], stdout=subprocess.DEVNULL, check=True, timeout=120)
        database = self.read_dbc("5=charger", "10=battery")
        compared = {}
        for line in run("decode", log, "--json", "--node", "5=419", "--node", "10=418").splitlines():
            told = json.loads(line)
            can_id, data = told["frame"].split("#")
            if not told.get("values") or told.get("marks") or int(can_id, 16) not in database._frame_id_to_message:
                continue
            values = database.decode_message(int(can_id, 16), bytes.fromhex(data), decode_choices=False)
            for value in told["values"]:
                name = identifier(value.get("name", ""))
                if name in values and isinstance(value["value"], float | int):
                    self.assertAlmostEqual(values[name], value["value"], places=9, msg=line)
                    compared[name] = compared.get(name, 0) + 1
        for name in ("temperature", "battery_voltage", "charge_current_requested"):
            self.assertGreater(compared.get(name, 0), 20, compared)

    def test_a_name_with_a_number_sign_is_its_own(self):
        """`#` is a placeholder of the profiles of CiA: in a maker's name it stands for itself."""
        sheet = self.folder / "motor.eds"
        sheet.write_text(
            "[DeviceInfo]\nProductName=Motor\n[1000]\nParameterName=Device type\nObjectType=7\nDataType=7\nAccessType=ro\nDefaultValue=0\n"
            "[2000]\nParameterName=Motor #2\nObjectType=7\nDataType=6\nAccessType=ro\nPDOMapping=1\n"
            "[1800]\nParameterName=TPDO\nObjectType=9\nSubNumber=2\n[1800sub0]\nParameterName=Highest\nDataType=5\nAccessType=ro\nDefaultValue=1\n"
            "[1800sub1]\nParameterName=COB-ID\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n"
            "[1A00]\nParameterName=Mapping\nObjectType=9\nSubNumber=2\n[1A00sub0]\nParameterName=Number\nDataType=5\nAccessType=rw\nDefaultValue=1\n"
            "[1A00sub1]\nParameterName=One\nDataType=7\nAccessType=rw\nDefaultValue=0x20000010\n"
        )
        database = self.read_dbc(f"5={sheet}")
        names = [signal.name for signal in database.get_message_by_frame_id(0x185).signals]
        self.assertEqual(names, ["Motor_2"])

    def test_every_device_of_the_catalogue_is_read(self):
        for line in run("device", "--list", "--json").splitlines():
            name = json.loads(line)["name"]
            self.assertGreater(len(self.read_dbc(name).messages), 1, name)


if __name__ == "__main__":
    unittest.main()
