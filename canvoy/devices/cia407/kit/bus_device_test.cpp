// Common duties of every device of CiA 407 in its network, at the wire: device types, events,
// access rights, pre-defined PDOs. Frames are those of 8.1.1, 9.2.4, 9.2.5 and the tables of
// 8.1.4.3.
#include "canvoy/devices/cia407/kit/bus_device.hpp"

#include <gtest/gtest.h>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/identification_unit.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/cia407/passenger_information/passenger_information_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_canceller_unit.hpp"
#include "canvoy/devices/cia407/ticket/ticket_printer_unit.hpp"

namespace canvoy::cia407::bus_device_test {
namespace {

using DestinationText =
    PassengerInformationKind<InformationClass::destination, InformationSubclass::text>;
using NextStopText =
    PassengerInformationKind<InformationClass::next_stop, InformationSubclass::text>;

constexpr const BusUnit* canceller_alone[] = {&bus_unit<TicketCancellerKind>};
constexpr const BusUnit* printer_alone[] = {&bus_unit<TicketPrinterKind>};
constexpr const BusUnit* display_and_canceller[] = {&bus_unit<DestinationText>,
                                                    &bus_unit<TicketCancellerKind>};
constexpr const BusUnit* computer_alone[] = {&bus_unit<MainOnBoardComputerKind>};
constexpr const BusUnit* computer_and_announcer[] = {&bus_unit<MainOnBoardComputerKind>,
                                                     &bus_unit<AcousticAnnouncerKind>};
constexpr const BusUnit* identification_alone[] = {&bus_unit<IdentificationKind>};
constexpr const BusUnit* next_stop_alone[] = {&bus_unit<NextStopText>};
constexpr const BusUnit* destination_alone[] = {&bus_unit<DestinationText>};

BusSegment minimum() {
  return {.configuration = Configuration::minimum};
}
void in_minimum(Environment& environment) {
  environment.provide(Callback<BusSegment()>([](void*) { return minimum(); }, nullptr));
}

TEST(BusDevice, OneVirtualDeviceIsSaidBy1000h) {
  BusBench bench(canceller_alone);
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 97 01 00 04");
  EXPECT_EQ(bench.ask("40 00 60 00 00 00 00 00"), "80 00 60 00 00 00 02 06") << "no 6000h";
  EXPECT_EQ(bench.ask("40 FF 67 00 00 00 00 00"), "80 FF 67 00 00 00 02 06") << "no 67FFh";
}

TEST(BusDevice, SeveralAreListedIn6000h) {
  BusBench bench(display_and_canceller);
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 97 01 00 00");
  EXPECT_EQ(bench.ask("40 00 60 00 00 00 00 00"), "4F 00 60 00 02 00 00 00");
  EXPECT_EQ(bench.ask("40 00 60 01 00 00 00 00"), "4B 00 60 01 12 03 00 00");
  EXPECT_EQ(bench.ask("40 00 60 02 00 00 00 00"), "4B 00 60 02 00 04 00 00");
  EXPECT_EQ(bench.ask("40 FF 67 00 00 00 00 00"), "43 FF 67 00 97 01 00 00");
  bench.cable.send("000#81 05");
  EXPECT_EQ(bench.ask("40 00 60 02 00 00 00 00"), "4B 00 60 02 00 04 00 00") << "after a reset";
}

/// Values that only the application of a device sets.
struct Application {
  Application(VirtualDevice& /*device*/, const NoHardware& /*hardware*/,
              const NoSettings& /*settings*/) {}
};
struct ApplicationKind : BusKind<Application, NoHardware> {
  static constexpr DeviceInfo info = {.name = "application", .title = "of a canceller"};
  static constexpr const VirtualDeviceInfo& provides = application;
};
constexpr const BusUnit* canceller_with_application[] = {&bus_unit<TicketCancellerKind>,
                                                         &bus_unit<ApplicationKind>};

TEST(BusDevice, AnApplicationIsNoVirtualDevice) {
  BusBench bench(canceller_with_application);
  EXPECT_EQ(bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 97 01 00 04");
  EXPECT_EQ(bench.ask("40 00 60 00 00 00 00 00"), "80 00 60 00 00 00 02 06") << "no 6000h";
  EXPECT_EQ(bench.ask("40 01 60 00 00 00 00 00"), "4F 01 60 00 02 00 00 00")
      << "6001h: the summary, and one device";
}

TEST(BusDevice, AnEventSetsItsEntryAndTheBitOfTheSummary) {
  BusBench bench(display_and_canceller);
  // The canceller, the second device, gets a request for its state: 6002h:02h, 6001h:03h, bit 1.
  EXPECT_EQ(bench.ask("23 02 60 02 01 00 00 04"), "60 02 60 02 00 00 00 00");
  EXPECT_EQ(bench.ask("40 01 60 03 00 00 00 00"), "43 01 60 03 01 00 00 04");
  EXPECT_EQ(bench.ask("40 01 60 01 00 00 00 00"), "43 01 60 01 02 00 00 00");
  EXPECT_EQ(bench.ask("40 01 60 02 00 00 00 00"), "43 01 60 02 00 00 00 00");
  // And the display, which is the first.
  bench.ask("23 02 60 01 03 00 00 03");
  EXPECT_EQ(bench.ask("40 01 60 02 00 00 00 00"), "43 01 60 02 03 00 00 03");
  EXPECT_EQ(bench.ask("40 01 60 01 00 00 00 00"), "43 01 60 01 03 00 00 00");
  bench.ask("23 02 60 02 00 00 00 00");
  EXPECT_EQ(bench.ask("40 01 60 01 00 00 00 00"), "43 01 60 01 01 00 00 00");
  bench.cable.send("000#81 05");
  EXPECT_EQ(bench.ask("40 01 60 01 00 00 00 00"), "43 01 60 01 00 00 00 00") << "after a reset";
}

TEST(BusDevice, AnEventIsSentAsItArises) {
  BusBench bench(canceller_alone);
  bench.cable.clear();
  bench.ask("23 02 60 01 01 00 00 04");
  EXPECT_EQ(bench.cable.last(0x185), "185#01 00 00 00 01 00 00 04");
  bench.ask("23 02 60 01 01 00 00 04");
  EXPECT_EQ(bench.cable.count(0x185), 1u) << "once";
}

TEST(BusDevice, AnEventForAnotherVirtualDeviceIsRefused) {
  BusBench bench(canceller_alone);
  EXPECT_EQ(bench.ask("23 02 60 01 01 00 00 03"), "80 02 60 01 30 00 09 06");
  EXPECT_EQ(bench.ask("40 01 60 01 00 00 00 00"), "43 01 60 01 00 00 00 00");
  EXPECT_EQ(bench.ask("23 02 60 02 01 00 00 04"), "80 02 60 02 11 00 09 06")
      << "there is no second";
}

TEST(BusDevice, WhatIsConsumedIsWrittenAndWhatIsProvidedIsRead) {
  BusBench canceller(canceller_alone);
  EXPECT_EQ(canceller.ask("2F 11 61 00 02 00 00 00"), "60 11 61 00 00 00 00 00");
  EXPECT_EQ(canceller.ask("40 11 61 00 00 00 00 00"), "80 11 61 00 01 00 01 06") << "wo";
  BusBench computer(computer_alone, 1);
  EXPECT_EQ(computer.ask("40 11 61 00 00 00 00 00"), "4F 11 61 00 00 00 00 00");
  EXPECT_EQ(computer.ask("2F 11 61 00 02 00 00 00"), "80 11 61 00 02 00 01 06") << "ro";
}

TEST(BusDevice, WhoProvidesTheTextsOfIdentificationIsTheSegmentsChoice) {
  const auto by_identification = [](Environment& environment) {
    environment.provide(Callback<BusSegment()>(
        [](void*) { return BusSegment{.identification_provides_texts = true}; }, nullptr));
  };
  BusBench usual(identification_alone, 2);
  EXPECT_EQ(usual.ask("40 96 61 00 00 00 00 00"), "80 96 61 00 01 00 01 06");
  EXPECT_EQ(usual.ask("23 96 61 00 32 33 61 00").substr(0, 2), "60");
  BusBench other(identification_alone, by_identification, 2);
  EXPECT_EQ(other.ask("23 96 61 00 32 33 61 00"), "80 96 61 00 02 00 01 06");
  BusBench computer(computer_alone, by_identification, 1);
  EXPECT_EQ(computer.ask("23 96 61 00 32 33 61 00").substr(0, 2), "60");
}

/// COB-ID, mapping and type of a PDO, as printed in 8.1.4.3.
void expect_pdo(BusBench& bench, unsigned index, const std::string& can_id,
                const std::vector<std::string>& mapped) {
  const auto low = [](unsigned number) {
    char text[16];
    std::snprintf(text, sizeof text, "%02X %02X", number & 0xFF, number >> 8);
    return std::string(text);
  };
  EXPECT_EQ(bench.ask("40 " + low(index) + " 01 00 00 00 00"),
            "43 " + low(index) + " 01 " + can_id + " 00 00");
  EXPECT_EQ(bench.ask("40 " + low(index) + " 02 00 00 00 00"),
            "4F " + low(index) + " 02 FF 00 00 00");
  const std::string count = std::string("0") + static_cast<char>('0' + mapped.size());
  EXPECT_EQ(bench.ask("40 " + low(index + 0x200) + " 00 00 00 00 00"),
            "4F " + low(index + 0x200) + " 00 " + count + " 00 00 00");
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    const std::string sub = std::string("0") + static_cast<char>('1' + i);
    EXPECT_EQ(bench.ask("40 " + low(index + 0x200) + " " + sub + " 00 00 00 00"),
              "43 " + low(index + 0x200) + " " + sub + " " + mapped[i]);
  }
}

TEST(BusDevice, TheMainComputerHasFiveMessagesAndTakesThree) {
  BusBench bench(computer_alone, 1);
  expect_pdo(
      bench, 0x1800, "81 01",
      {"08 01 0E 61", "08 02 0E 61", "08 03 0E 61", "08 04 0E 61", "08 05 0E 61", "08 06 0E 61"});
  EXPECT_EQ(bench.ask("40 00 18 05 00 00 00 00"), "4B 00 18 05 60 EA 00 00") << "1 min";
  expect_pdo(bench, 0x1801, "81 03",
             {"10 00 10 61", "08 00 11 61", "08 00 16 61", "08 00 08 61", "08 00 0A 61"});
  EXPECT_EQ(bench.ask("40 01 18 05 00 00 00 00"), "4B 01 18 05 00 00 00 00");
  expect_pdo(bench, 0x1802, "01 04", {"20 00 09 61", "20 01 01 60"});
  expect_pdo(bench, 0x1803, "81 04",
             {"08 01 0B 61", "08 02 0B 61", "08 03 0B 61", "08 04 0B 61", "08 05 0B 61",
              "08 06 0B 61", "08 07 0B 61", "08 08 0B 61"});
  expect_pdo(bench, 0x1804, "01 05",
             {"08 01 18 61", "08 02 18 61", "08 03 18 61", "08 04 18 61", "08 05 18 61",
              "08 06 18 61", "08 07 18 61", "08 08 18 61"});
  expect_pdo(bench, 0x1400, "01 03", {"20 00 91 61", "10 00 93 61"});
  expect_pdo(bench, 0x1401, "01 02", {"20 00 90 61"});
  expect_pdo(bench, 0x1402, "81 02", {"20 00 94 61", "10 00 92 61", "10 00 95 61"});
}

TEST(BusDevice, IdentificationHasThree) {
  BusBench bench(identification_alone, 2);
  expect_pdo(bench, 0x1800, "01 02", {"20 00 90 61"});
  expect_pdo(bench, 0x1801, "81 02", {"20 00 94 61", "10 00 92 61", "10 00 95 61"});
  expect_pdo(bench, 0x1802, "01 03", {"20 00 91 61", "10 00 93 61"});
}

TEST(BusDevice, DisplaysCancellerAndPrinterTakeTheirColumns) {
  BusBench destination(destination_alone);
  expect_pdo(destination, 0x1400, "01 03", {"20 00 91 61", "10 00 93 61"});
  expect_pdo(destination, 0x1401, "81 03",
             {"10 00 10 61", "08 00 05 00", "08 00 05 00", "08 00 05 00", "08 00 05 00"});
  expect_pdo(destination, 0x1402, "81 02", {"20 00 07 00", "10 00 92 61", "10 00 06 00"});
  BusBench next_stop(next_stop_alone);
  expect_pdo(next_stop, 0x1403, "01 04", {"20 00 09 61", "20 00 07 00"});
  BusBench canceller(canceller_alone);
  expect_pdo(
      canceller, 0x1400, "81 01",
      {"08 01 0E 61", "08 02 0E 61", "08 03 0E 61", "08 04 0E 61", "08 05 0E 61", "08 06 0E 61"});
  expect_pdo(canceller, 0x1401, "81 03",
             {"10 00 10 61", "08 00 11 61", "08 00 16 61", "08 00 08 61", "08 00 0A 61"});
  expect_pdo(canceller, 0x1402, "81 02", {"20 00 94 61", "10 00 92 61", "10 00 06 00"});
  BusBench printer(printer_alone);
  expect_pdo(printer, 0x1403, "01 04", {"20 00 09 61", "20 00 07 00"});
  expect_pdo(printer, 0x1405, "01 05",
             {"08 01 18 61", "08 02 18 61", "08 03 18 61", "08 04 18 61", "08 05 18 61",
              "08 06 18 61", "08 07 18 61", "08 08 18 61"});
}

TEST(BusDevice, TheMinimumConfigurationHasThreeMessages) {
  BusBench computer(computer_alone, in_minimum, 1);
  expect_pdo(
      computer, 0x1800, "81 01",
      {"08 01 0E 61", "08 02 0E 61", "08 03 0E 61", "08 04 0E 61", "08 05 0E 61", "08 06 0E 61"});
  const std::string second = computer.ask("40 01 1A 01 00 00 00 00");
  EXPECT_NE(second, "43 01 1A 01 10 00 10 61") << "no route message";
  BusBench canceller(canceller_alone, in_minimum);
  expect_pdo(canceller, 0x1402, "81 02", {"20 00 94 61", "10 00 92 61", "10 00 06 00"});
  EXPECT_NE(canceller.ask("40 01 14 01 00 00 00 00"), "43 01 14 01 81 03 00 00");
}

TEST(BusDevice, SeveralVirtualDevicesTakeAMessageOnceAndWhole) {
  BusBench bench(display_and_canceller);
  unsigned of_route = 0;
  for (unsigned i = 0; i < 12; ++i) {
    const char* digits = "0123456789AB";
    const std::string at = std::string("0") + digits[i];
    if (bench.ask("40 " + at + " 14 01 00 00 00 00").substr(12) != "81 03 00 00") continue;
    ++of_route;
    EXPECT_EQ(bench.ask("40 " + at + " 16 02 00 00 00 00").substr(12), "08 00 11 61")
        << "the fare zone, which the display alone would pass over";
  }
  EXPECT_EQ(of_route, 1u);
}

struct Voice {
  std::vector<std::uint32_t> said;
  bool announce(std::uint32_t stop, std::string_view /*text*/) {
    said.push_back(stop);
    return stop != 13;
  }
  AcousticAnnouncerHardware hardware() { return {.announce = callback<&Voice::announce>(*this)}; }
};

class ComputerAndAnnouncer : public testing::Test {
 protected:
  using Event = std::pair<unsigned, std::uint32_t>;

  void heard(unsigned number, std::uint32_t event) { events.emplace_back(number, event); }
  MainOnBoardComputerHardware hardware() {
    return {.on_event = callback<&ComputerAndAnnouncer::heard>(*this)};
  }

  Voice voice;
  std::vector<Event> events;
  MainOnBoardComputerUnit* computer = nullptr;
  BusBench bench{computer_and_announcer,
                 [this](Environment& environment) {
                   environment.provide(callback<&Voice::hardware>(voice));
                   environment.provide(callback<&ComputerAndAnnouncer::hardware>(*this));
                   environment.watch(computer);
                 },
                 1};
};

TEST_F(ComputerAndAnnouncer, VirtualDevicesOfOneDeviceHearEachOther) {
  computer->set_position({.stop_point_id = 17});
  EXPECT_EQ(voice.said, (std::vector<std::uint32_t>{17}));
}

/// 9.2.4, 9.2.5: the announcer is the second one, 6002h:02h and 6001h:03h.
TEST_F(ComputerAndAnnouncer, CommandsAndEventsOfOneDeviceAreHeardWithin) {
  computer->command(2, DeviceCode::acoustic_announcer, 1);
  EXPECT_EQ(bench.ask("40 02 60 02 00 00 00 00"), "43 02 60 02 01 00 00 07");
  EXPECT_EQ(bench.ask("40 01 60 03 00 00 00 00"), "43 01 60 03 01 00 00 07") << "it lives";
  EXPECT_EQ(bench.cable.last(0x401), "401#00 00 00 00 02 00 00 00");
  EXPECT_EQ(events, (std::vector<Event>{{2, 0x07000001}}));
  computer->command(2, DeviceCode::acoustic_announcer, 0);
  EXPECT_EQ(events, (std::vector<Event>{{2, 0x07000001}, {2, 0}}));
  bench.cable.run_for(0s);
  EXPECT_EQ(bench.cable.last(0x401), "401#00 00 00 00 00 00 00 00");
}

/// The second one of the network may be in another device: its code shows that.
TEST_F(ComputerAndAnnouncer, ACommandForAnotherCodeIsNotTakenWithin) {
  computer->command(2, DeviceCode::tachograph, 1);
  EXPECT_EQ(bench.ask("40 02 60 02 00 00 00 00"), "43 02 60 02 01 00 00 0C");
  EXPECT_EQ(events, std::vector<Event>{});
}

TEST(BusDevice, AHeartbeatThatIsLostLeavesOperational) {
  BusBench bench(canceller_alone);
  bench.ask("23 16 10 01 F4 01 01 00");  // node 1, 500 ms
  bench.cable.send("701#05");
  bench.cable.run_for(499ms);
  EXPECT_EQ(bench.node().state(), NmtState::operational);
  bench.cable.run_for(2ms);
  EXPECT_EQ(bench.node().state(), NmtState::pre_operational);
  EXPECT_EQ(bench.ask("40 29 10 02 00 00 00 00"), "4F 29 10 02 00 00 00 00");
  EXPECT_EQ(bench.ask("2F 29 10 02 03 00 00 00").substr(0, 2), "80");
}

}  // namespace
}  // namespace canvoy::cia407::bus_device_test
