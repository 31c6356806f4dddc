"""Printer, terminal and taximeter of another maker, on canopen-python, each in the place of one that is not played: they are
named by LSS, and a shift goes on with them. One that is named by its vendor-ID, one that is whoever provides the virtual
device, and three at once, which say what they are.

    tests/strangers/with_python tests/strangers/taxi/shift_test.py PEER
"""

import pathlib
import re
import struct
import sys
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from canopen.objectdictionary import datatypes
from strangers import OPERATIONAL, VENDOR, Device, Taxi

PEER = sys.argv.pop(1)
SECONDS = 2400
TAXIMETER, PRINTER, TERMINAL = 2, 3, 6


class Printer(Device):
    """4.2.13: status (60E0h), errors (60E1h), and the text of the transport object (60EBh)."""

    PDO = 72

    def __init__(self, taxi):
        super().__init__(taxi, serial=70, product=900)
        self.add(0x60E0, 0, datatypes.UNSIGNED8, 0)
        self.add(0x60E1, 0, datatypes.UNSIGNED8, 0)
        self.add(0x60EB, 0, datatypes.DOMAIN, access="wo")
        self.paper = []

    def written(self, index, subindex, od, data):
        if index == 0x60EB:
            self.paper.append(bytes(data).decode("ascii", "replace"))


class Terminal(Device):
    """4.2.9.18 to 4.2.9.21: who has display 1 (6097h), the command for it (6098h), its text (6099h) and title (609Ah)."""

    PDO = 81

    def __init__(self, taxi):
        super().__init__(taxi, serial=60, product=800)
        self.holders = {0x6097: 0, 0x609C: 0}  # status of displays 1 and 2: 0 nobody, 1 + node-ID
        for index in (0x6097, 0x609C, 0x6098, 0x609D):
            self.add(index, 0, datatypes.UNSIGNED8)
        for index in (0x6099, 0x609A, 0x609E):
            self.add(index, 0, datatypes.DOMAIN)
        self.texts = []

    def read(self, index, **what):
        return self.holders.get(index)

    def written(self, index, subindex, od, data):
        if index in (0x6098, 0x609D) and data[0] & 3 < 2:
            self.holders[index - 1] = 1 + self.writer if data[0] & 3 == 1 else 0
            self.send_pdo(bytes([0, 0, 0, 0, 0, 0, self.holders[0x6097], self.holders[0x609C]]))
        elif index == 0x6099:
            self.texts.append((self.taxi.now, bytes(data).decode("utf-8")))


FOR_HIRE, HIRED, STOPPED, SIGNED_OFF = range(4)


class Taximeter(Device):
    """4.2.12: a trip by wheel pulses (PDO 17) and time, mode S, in the tariff of the simulated town by day: 3.90, 2.30 a km,
    33.00 an hour, in steps of 10 cents. The driver's hands press what he does next."""

    PDO = 80
    PULSES_PER_KM = 24000
    INITIAL, PER_KM, PER_HOUR, STEP = 3900, 2300, 33000, 100

    def __init__(self, taxi):
        super().__init__(taxi, serial=20, product=700)
        self.state_of_meter = SIGNED_OFF
        self.add(0x60D8, 0, datatypes.UNSIGNED8)
        self.add(0x60DB, 0, datatypes.UNSIGNED8)
        self.add(0x60D1, 0, datatypes.UNSIGNED32)
        self.add(0x60D3, 0, datatypes.UNSIGNED16)
        self.add_record(0x60D0, datatypes.UNSIGNED32, range(1, 7))
        self.add_record(0x60D2, datatypes.UNSIGNED32, range(1, 3))
        self.add_record(0x60D4, datatypes.UNSIGNED32, range(1, 3))
        self.add_record(0x60D9, datatypes.UNSIGNED32, range(1, 13))
        self.counted = None
        self.pulses = self.slice_pulses = 0
        self.used = 0.0
        self.began = self.ended = self.slice_began = 0
        self.sequence = 0
        self.income = 0
        self.trips = []

    def fare(self):
        return self.INITIAL + int(self.used / self.STEP + 1e-9) * self.STEP

    def read(self, index, subindex, **what):
        self_trip = {
            (0x60D0, 1): self.fare(), (0x60D0, 2): 0, (0x60D0, 3): self.fare(), (0x60D0, 4): 0, (0x60D0, 5): 0,
            (0x60D0, 6): self.INITIAL, (0x60D1, 0): self.pulses * 1000 // self.PULSES_PER_KM,
            (0x60D2, 1): ((self.taxi.now if self.state_of_meter == HIRED else self.ended) - self.began) // 1000,
            (0x60D3, 0): ord("1"), (0x60D4, 1): self.PER_HOUR, (0x60D4, 2): self.PER_KM,
            (0x60D8, 0): 0xC0 | self.state_of_meter, (0x60D9, 6): self.income, (0x60DB, 0): self.sequence,
        }  # fmt: skip
        return self_trip.get((index, subindex))

    def enter(self, state):
        self.state_of_meter = state
        self.send_pdo(bytes([0xC0 | state]))

    def started(self):
        self.enter(self.state_of_meter)

    def came(self, can_id, data):
        if can_id != 0x187 or len(data) < 7:  # PDO 17 of node 1
            return
        count, = struct.unpack_from("<H", data, 4)
        if data[6] & 3 != 1:
            self.counted = None
            return
        if self.counted is not None and self.state_of_meter == HIRED:
            turned = (count - self.counted) % 0x10000
            self.pulses += turned
            self.slice_pulses += turned
            self.sequence = (self.sequence + 1) % 0xFE
        self.counted = count

    def advance(self):
        super().advance()
        if self.state_of_meter == HIRED and self.taxi.now - self.slice_began >= 1000:
            self.close_slice()
        self.press(self.taxi.driver)

    # Above the cross-over speed a slice costs by distance, below it by time (mode S).
    def close_slice(self):
        seconds = (self.taxi.now - self.slice_began) / 1000
        by_distance = self.slice_pulses / self.PULSES_PER_KM * self.PER_KM
        by_time = seconds / 3600 * self.PER_HOUR
        self.used += max(by_distance, by_time)
        self.slice_pulses, self.slice_began = 0, self.taxi.now

    def press(self, driver):
        state = self.state_of_meter
        if self.node is None or self.state != OPERATIONAL:
            return
        if driver == "signing_on" and state == SIGNED_OFF:
            self.enter(FOR_HIRE)
        elif driver == "hiring" and state == FOR_HIRE:
            self.pulses = self.slice_pulses = 0
            self.used = 0.0
            self.began = self.slice_began = self.taxi.now
            self.enter(HIRED)
        elif driver == "stopping" and state == HIRED:
            self.close_slice()
            self.ended = self.taxi.now
            self.enter(STOPPED)
        elif driver == "releasing" and state == STOPPED:
            self.income += self.fare()
            self.trips.append(self.fare() / 1000)
            self.enter(FOR_HIRE)
        elif driver == "signing_off" and state == FOR_HIRE:
            self.enter(SIGNED_OFF)


class Shift(unittest.TestCase):
    def play(self, real, *makers):
        taxi = Taxi(PEER, SECONDS, real)
        self.addCleanup(taxi.peer.kill)
        devices = [maker(taxi) for maker in makers]
        taxi.run_until(SECONDS)
        broken, undecided, trips = taxi.end()
        self.assertEqual(broken, [])
        self.assertGreaterEqual(len(trips), 2)
        return taxi, devices, undecided, trips

    def assert_named(self, device, node):
        self.assertEqual(device.node.id, node)
        self.assertEqual(device.state, OPERATIONAL)

    def assert_printed(self, printer, trips):
        totals = [re.search(r"TOTAL +([0-9]+\.[0-9]{2})", text) for text in printer.paper]
        self.assertEqual([float(total[1]) for total in totals if total], trips)

    def assert_shown(self, terminal, trips):
        fares = [float(fare[1]) for _, text in terminal.texts if (fare := re.search(r"FARE +([0-9]+\.[0-9]{2})", text))]
        # Extras are shown apart: the fare of a trip is what was paid, or less.
        for paid in trips:
            self.assertTrue(paid in fares or round(paid - 1, 2) in fares, (paid, fares))

    def test_a_printer_that_is_named_by_its_vendor_prints_each_receipt(self):
        _, [printer], undecided, trips = self.play([f"{PRINTER}:vendor={VENDOR}"], Printer)
        self.assert_named(printer, PRINTER)
        self.assert_printed(printer, trips)
        self.assertNotIn("fare", undecided)

    def test_a_terminal_whoever_has_made_it_shows_each_fare(self):
        _, [terminal], undecided, trips = self.play([str(TERMINAL)], Terminal)
        self.assert_named(terminal, TERMINAL)
        self.assert_shown(terminal, trips)
        self.assertNotIn("fare", undecided)

    def test_a_meter_whoever_has_made_it_is_what_passengers_read_and_pay(self):
        _, [meter], undecided, trips = self.play([str(TAXIMETER)], Taximeter)
        self.assert_named(meter, TAXIMETER)
        self.assertEqual(trips, meter.trips)
        for judged in ("fare", "distance", "duration", "totals"):
            self.assertNotIn(judged, undecided)

    def test_three_at_once_say_what_they_are_and_get_their_places(self):
        places = [str(node) for node in (TAXIMETER, PRINTER, TERMINAL)]
        taxi, [terminal, printer, meter], _, trips = self.play(places, Terminal, Printer, Taximeter)
        self.assert_named(terminal, TERMINAL)
        self.assert_named(printer, PRINTER)
        self.assert_named(meter, TAXIMETER)
        self.assertEqual(trips, meter.trips)
        asked = [can_id for _, can_id, data in taxi.frames if 0x601 <= can_id <= 0x610 and data[1:4] == bytes([0x4F, 0x18, 1])]
        self.assertTrue(asked, "1800h + 79, which a meter has, is asked for")
        resets = {data[1] for _, can_id, data in taxi.frames if can_id == 0 and data[0] == 0x82}
        self.assertEqual(len(resets), 3, "each was named twice")


if __name__ == "__main__":
    unittest.main(verbosity=2)
