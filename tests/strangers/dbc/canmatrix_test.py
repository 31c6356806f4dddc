#!/usr/bin/env python3
"""canmatrix reads the DBC files that `canvoy export` writes, and decodes logs by them: the same values as
`canvoy decode --json`, one by one.

    CANVOY=build/canvoy tests/strangers/.venv/bin/python tests/strangers/dbc/canmatrix_test.py

Without canmatrix, the test is skipped (77).
"""

import contextlib
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

warnings.simplefilter("ignore")
try:
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        import logging

        logging.disable(logging.CRITICAL)
        import canmatrix.formats
except ImportError:
    canmatrix = None

CANVOY = os.environ.get("CANVOY", "build/canvoy")


def run(*arguments):
    done = subprocess.run([CANVOY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
    if done.returncode != 0 or done.stderr:
        raise AssertionError(f"{arguments}: {done.returncode} {done.stderr.decode()}")
    return done.stdout


def identifier(name):
    """What a DBC calls it."""
    return re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")


class Dbc(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read_dbc(self, *what):
        path = str(self.folder / "network.dbc")
        run("export", "dbc", *what, "--out", path)
        matrix = canmatrix.formats.loadp_flat(path)
        self.assertEqual(matrix.load_errors, [])
        return matrix

    def agrees(self, matrix, log, *arguments):
        """Compares each value of each frame that both know; how many of which name there were."""
        compared = {}
        for line in run("decode", log, "--json", *arguments).decode().splitlines():
            told = json.loads(line)
            can_id, data = told["frame"].split("#")
            message = matrix.frame_by_id(canmatrix.ArbitrationId(int(can_id, 16)))
            if message is None or not told.get("values") or told.get("marks"):
                continue
            signals = message.decode(bytearray(bytes.fromhex(data)))
            for value in told["values"]:
                self.compare_value(signals, value, compared, line)
        return compared

    def compare_value(self, signals, value, compared, line):
        name = identifier(value.get("name", ""))
        parts = value["value"] if isinstance(value["value"], dict) else {"": value["value"]}
        for field, wanted in parts.items():
            signal = signals.get(identifier(f"{name}_{field}") if field else name)
            if signal is None:
                continue
            # Its own look-up goes by the scaled number; the states of a DBC are of raw ones.
            said = signal.signal.values.get(int(signal.raw_value)) if signal.signal.values else None
            if wanted is None:
                self.assertIsInstance(said, str, (name, line))
            elif isinstance(wanted, str) and said is not None:
                self.assertEqual(said, wanted.replace('"', "'"), (name, line))
            elif isinstance(wanted, str):
                # A code of many digits, or a state among more than a DBC lists: as it is in `raw`.
                continue
            elif "its scale depends on the number" in (signal.signal.comment or ""):
                # A DBC has one scale for all numbers: north and south of CiA 447's coordinates are the number that is sent.
                self.assertEqual(int(signal.phys_value), int.from_bytes(bytes.fromhex(value["raw"]), "little"), (name, line))
            else:
                self.assertAlmostEqual(float(signal.phys_value), wanted, places=9, msg=(name, field, line))
                unit = value.get("unit")
                if unit:
                    self.assertEqual(signal.signal.unit, unit, name)
            compared[f"{name}.{field}"] = compared.get(f"{name}.{field}", 0) + 1

    def test_a_charge_is_decoded_by_both_alike(self):
        log = str(self.folder / "charge.log")
        subprocess.run([CANVOY, "run", "charger", "--for", "1min", "--log", log], stdout=subprocess.DEVNULL, check=True, timeout=120)
        matrix = self.read_dbc("5=charger", "10=battery", "--sdo")
        compared = self.agrees(matrix, log, "--node", "5=419", "--node", "10=418")
        # Of PDOs each tenth of a second or more, and of SDO the charger's questions at the start.
        for name in ("temperature.", "battery_status.", "battery_voltage.", "charger_status.", "charge_current_requested."):
            self.assertGreater(compared.get(name, 0), 20, compared)
        self.assertEqual(compared.get("Device_type."), 1, "by SDO")

    def test_a_lift_with_its_fields_is_decoded_by_both_alike(self):
        log = str(self.folder / "lift.log")
        network = str(self.folder / "house.toml")
        pathlib.Path(network).write_bytes(run("run", "lift", "--for", "20s", "--print"))
        subprocess.run([CANVOY, "run", network, "--log", log], stdout=subprocess.DEVNULL, timeout=120)
        matrix = self.read_dbc(network)
        compared = self.agrees(matrix, log, "--profile", "417-4")
        self.assertGreater(len(compared), 30, compared)
        self.assertGreater(sum(compared.values()), 1000, compared)

    def world(self, name, *arguments):
        """Its network file as it is printed, and the log of a run of it."""
        network, log = str(self.folder / f"{name}.toml"), str(self.folder / f"{name}.log")
        pathlib.Path(network).write_bytes(run("run", name, "--print"))
        subprocess.run([CANVOY, "run", name, *arguments, "--log", log], stdout=subprocess.DEVNULL, check=True, timeout=120)
        return network, log

    def test_the_nodes_of_a_taxi_are_there(self):
        network, _ = self.world("taxi", "--for", "1min")
        matrix = self.read_dbc(network)
        names = ("ivn_gateway", "taximeter", "printer", "driver_and_clock", "tariff_display", "terminal", "gps_navigation", "taxi_alarm")
        for node, name in enumerate(names, 1):
            heartbeat = matrix.frame_by_id(canmatrix.ArbitrationId(0x700 + node))
            self.assertEqual(heartbeat.transmitters, [name])
            self.assertEqual(heartbeat.decode(bytearray([5]))["NMT_state"].named_value, "operational")

    def test_the_pdos_of_a_taxi_and_a_police_car_are_decoded_by_both_alike(self):
        """CiA 447: each node has 32 CAN-IDs; node 1 from 180h, node 2 from 200h on."""
        wanted = {
            "taxi": ("Ignition_switch_status", "Taximeter_status", "Printer_status", "Driver_ID_status", "Number_pad_status",
                     "GPS_current_position_Position_latitude", "Tariff_display_inputs_status", "Taxi_alarm_system_status"),
            "police": ("Ignition_switch_status", "Blue_light_flasher_status", "Radio_device_status", "GPS_current_position_Position_latitude",
                       "Discrete_inputs_status", "Number_pad_status"),
        }  # fmt: skip
        for name, values in wanted.items():
            with self.subTest(car=name):
                network, log = self.world(name, "--for", "20min")
                matrix = self.read_dbc(network)
                wheels = matrix.frame_by_id(canmatrix.ArbitrationId(0x187))
                self.assertEqual(wheels.transmitters, ["ivn_gateway"], "the eighth of the pre-defined PDOs of node 1")
                compared = self.agrees(matrix, log, "--profile", "447-3")
                seen = {value.split(".")[0] for value in compared}
                self.assertEqual([value for value in values if value not in seen], [], seen)
                self.assertGreater(compared["Wheel_pulse_counter.wheel pulse counter"], 5000, "each 100 ms while the car is awake")

    def test_what_the_nodes_of_a_car_ask_each_other_is_decoded_by_both_alike(self):
        """CiA 447: node n asks node m by a CAN-ID of their own, and hears it 80h below."""
        network, log = self.world("taxi", "--for", "2min")
        asked = str(self.folder / "asked.log")
        subprocess.run([CANVOY, "decode", log, "--profile", "447-3", "--filter", "service=SDO and not id=580..67F", "--out", asked], check=True, timeout=120)
        compared = self.agrees(self.read_dbc(network, "--sdo"), asked, "--profile", "447-3")
        self.assertGreater(sum(compared.values()), 10, compared)

    def test_pdos_of_a_car_are_where_its_file_has_them(self):
        network = self.folder / "other.toml"
        printed = run("run", "taxi", "--print").decode()
        offsets = ", ".join(map(str, range(30)))
        self.assertIn(f"pdo_offsets = [{offsets}]", printed)
        network.write_text(printed.replace(f"[{offsets}]", f"[{', '.join(map(str, range(31, 1, -1)))}]"))
        names = {frame.arbitration_id.id: frame.name for frame in self.read_dbc(str(network)).frames}
        self.assertEqual((names[0x180 + 31], names[0x200 + 31 - 25]), ("ivn_gateway_TPDO1", "taximeter_TPDO80"), "the first and the 26th")

    def test_an_excavator_is_decoded_by_both_alike(self):
        network, log = self.world("excavator", "--for", "10min")
        own = str(self.folder / "sim0.log")
        subprocess.run([CANVOY, "decode", log, "--filter", "bus=sim0", "--out", own], check=True, timeout=120)
        compared = self.agrees(self.read_dbc(network, "--bus", "sim0"), own, "--node", "10=operator", "--node", "33=io-401")
        # What the seat says by its usual PDOs and by those that the host maps anew, and what valves and sensors of CiA 401 say and take.
        for wanted in ("Read_analogue_input_16_bit_Joystick_1_x_dimension.", "Read_analogue_input_16_bit_Wheel_1_Position.",
                       "Write_analogue_output_16_bit_Write_analogue_output_16_bit_1.", "Read_analogue_input_16_bit_Read_analogue_input_16_bit_1."):  # fmt: skip
            self.assertGreater(compared.get(wanted, 0), 1000, sorted(compared))
        behind = self.read_dbc(network, "--bus", "sim1")
        self.assertEqual({ecu.name for ecu in behind.ecus}, {"armrest"}, "what is behind the seat")
        self.assertIsNotNone(behind.frame_by_id(canmatrix.ArbitrationId(0x707)))

    def test_both_cars_of_a_bus_are_decoded_by_both_alike(self):
        network, log = self.world("bus", "--for", "10min")
        for bus, node in (("sim0", "on_board_computer"), ("sim1", "second_next_stop")):
            matrix = self.read_dbc(network, "--bus", bus)
            self.assertIn(node, {ecu.name for ecu in matrix.ecus})
            self.assertEqual(len({frame.arbitration_id.id for frame in matrix.frames}), len(matrix.frames))
            own = str(self.folder / f"{bus}.log")
            subprocess.run([CANVOY, "decode", log, "--filter", f"bus={bus}", "--out", own], check=True, timeout=120)
            compared = self.agrees(matrix, own, "--profile", "407")
            self.assertGreater(sum(compared.values()), 100, compared)

    def test_numbers_and_states_are_those_of_the_specification(self):
        """CiA 418: 6010h is INTEGER16 in 0.125 degrees; 6000h bit 0: the battery is ready or not."""
        matrix = self.read_dbc("10=battery")
        signal = next(each for frame in matrix.frames for each in frame.signals if each.name == "temperature")
        self.assertEqual((signal.size, signal.is_signed, float(signal.factor), signal.unit), (16, True, 0.125, "°C"))
        heartbeat = matrix.frame_by_id(canmatrix.ArbitrationId(0x70A))
        self.assertEqual(heartbeat.decode(bytearray([127]))["NMT_state"].named_value, "pre-operational")

    def test_every_device_of_the_catalogue_and_every_profile_with_messages_is_read(self):
        for line in run("device", "--list", "--json").decode().splitlines():
            name = json.loads(line)["name"]
            matrix = self.read_dbc(name, "--sdo")
            self.assertGreater(len(matrix.frames), 2, name)
        self.assertEqual(len(self.read_dbc("407").frames), 8, "CiA 407, 8.1.4.3")
        self.assertGreater(len(self.read_dbc("417-4").frames), 10)


if __name__ == "__main__":
    if canmatrix is None:
        print("skipped: canmatrix is not installed (python3-canmatrix)")
        sys.exit(77)
    unittest.main()
