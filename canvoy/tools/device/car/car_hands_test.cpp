// Hands of devices of CiA 447-3: their values, and the resulting frames.
#include "canvoy/tools/device/car/car_hands.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia447/discrete_inputs/discrete_inputs_unit.hpp"
#include "canvoy/devices/cia447/driver_identification/driver_identification_unit.hpp"
#include "canvoy/devices/cia447/fire_extinguishing/fire_extinguishing_unit.hpp"
#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"
#include "canvoy/devices/cia447/real_time_clock/real_time_clock_unit.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/profiles/cia447.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/car/car_hand_tables.hpp"
#include "canvoy/tools/device/car/device_car_panel.hpp"
#include "canvoy/tools/device/hand/hand_lines.hpp"
#include "canvoy/tools/device/hand_list.hpp"

namespace canvoy::tools::car_hands_test {
namespace {

using cia447::CarUnit, cia447::FieldPlace;

std::vector<const CarUnit*> all_units() {
  std::vector<const CarUnit*> units;
  for (const DeviceKind* kind : device_catalogue()) {
    if (kind->car_unit != nullptr) units.push_back(kind->car_unit);
  }
  return units;
}

/// A device on a cable, with node-ID 5, and its hands.
class Hosted {
 public:
  explicit Hosted(const CarUnit* unit, const CarPanelOptions& options = {})
      : units_{unit}, car_({}, output_) {
    bench_ = std::make_unique<cia447::CarBench>(units_, [&](Environment& environment) {
      car_.join(environment);
      panel_ = std::make_unique<CarPanel>(units_, options, car_, environment, output_);
    });
    pass(Duration{});
  }

  void take(std::string_view order) { panel_->take(order); }
  /// Lets this time pass, in steps of 10 ms, and keeps what is reported.
  void pass(Duration time) {
    testing::internal::CaptureStdout();
    for (const Time end = bench_->cable.now + time;;) {
      car_.step(bench_->cable.now);
      panel_->step(bench_->node(), bench_->cable.now);
      bench_->cable.run_until(std::min(end, bench_->cable.now + 10ms));
      if (bench_->cable.now >= end) break;
    }
    said += testing::internal::GetCapturedStdout();
  }
  /// Value of an entry, by an SDO upload of at most 4 bytes.
  std::uint32_t read(std::uint16_t index, unsigned sub = 0) {
    const std::string answer = bench_->ask(
        fmt::format("40 {:02X} {:02X} {:02X} 00 00 00 00", index & 0xFFU, index >> 8U, sub));
    unsigned bytes[4] = {};
    unsigned command = 0;
    std::sscanf(answer.c_str(), "%2x %*2x %*2x %*2x %2x %2x %2x %2x", &command, &bytes[0],
                &bytes[1], &bytes[2], &bytes[3]);
    EXPECT_EQ(command & 0xE2U, 0x42U) << answer << " is no expedited answer";
    return bytes[0] | bytes[1] << 8U | bytes[2] << 16U | bytes[3] << 24U;
  }
  std::uint32_t read(const FieldPlace& place) {
    return static_cast<std::uint32_t>(std::uint64_t{read(place.index, place.sub)} >>
                                          place.first_bit &
                                      ((std::uint64_t{1} << place.bits) - 1));
  }
  cia447::CarBench& bench() { return *bench_; }

  std::string said;

 private:
  std::vector<const CarUnit*> units_;
  DeviceOutput output_;
  DeviceCar car_;
  std::unique_ptr<CarPanel> panel_;
  std::unique_ptr<cia447::CarBench> bench_;
};

std::string complaint_about(const CarUnit* unit, std::string_view order) {
  const std::vector<const CarUnit*> units = {unit};
  try {
    parse_hand_order(hand_tables(units), order);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

// -- all of the catalogue

TEST(CarHands, EachStatusOfEachDeviceHasAHandOrAReasonWhyNot) {
  EXPECT_EQ(all_units().size(), 20u);
  for (const CarUnit* unit : all_units()) {
    each_car_status(*unit, [&](const FieldPlace& place) {
      const auto is_it = [&place](const FieldPlace& other) {
        return other.index == place.index && other.sub == place.sub &&
               (other.bits == 0 || other == place);
      };
      const bool has_one = std::ranges::any_of(car_hands(*unit), [&](const DeviceHand& hand) {
        return std::ranges::any_of(hand.changes, is_it);
      });
      const bool has_reason =
          std::ranges::any_of(without_hands(*unit), [&](const WithoutHand& without) {
            return without.index == place.index && !without.why.empty() &&
                   (without.sub == WithoutHand::all || without.sub == place.sub) &&
                   (without.first_bit == WithoutHand::all || without.first_bit == place.first_bit);
          });
      EXPECT_TRUE(has_one || has_reason)
          << unit->info.name
          << fmt::format(" {:04X}h:{:02X}h bit {}", place.index, place.sub, place.first_bit);
    });
  }
}

TEST(CarHands, NamesAreTheirOwnAndEachHasAClause) {
  for (const CarUnit* unit : all_units()) {
    std::set<std::string> names;
    EXPECT_FALSE(car_hands(*unit).empty()) << unit->info.name;
    for (const DeviceHand& hand : car_hands(*unit)) {
      EXPECT_TRUE(names.insert(hand.name).second) << unit->info.name << ' ' << hand.name;
      EXPECT_EQ(hand.name.find_first_of(".=@# "), std::string::npos) << hand.name;
      EXPECT_TRUE(hand.clause.starts_with("4.2.")) << unit->info.name << ' ' << hand.name;
      const bool takes_nothing = hand.form == HandForm::action;
      EXPECT_EQ(hand_values_text(hand).empty(), takes_nothing) << hand.name;
    }
  }
}

/// For each hand, each word of a field of codes gives its code on the bus.
TEST(CarHands, EachWordOfAStatusIsItsCodeOnTheBus) {
  unsigned tried = 0;
  for (const CarUnit* unit : all_units()) {
    Hosted hosted(unit);
    hosted.pass(10ms);
    for (const DeviceHand& hand : car_hands(*unit)) {
      const FieldPlace& place = hand.changes.front();
      const ValueInfo* const value = cia447::find_value_info(place);
      const bool is_status = hand.form == HandForm::word && place.bits != 0 && value != nullptr &&
                             hand.words.back().word != "working" &&
                             hand.words.front().word != "working";
      // Lamps that a sign does not have stay "not available".
      const bool is_missing =
          unit->info.name == "tariff-display" && hand.name.starts_with("lamp-failure-") &&
          std::stoi(hand.name.substr(std::string_view("lamp-failure-").size())) > 3;
      if (!is_status || is_missing) continue;
      for (const HandWord& word : hand.words) {
        hosted.take(fmt::format("{}={}@0s", hand.name, word.word));
        hosted.pass(10ms);
        EXPECT_EQ(hosted.read(place), word.code)
            << unit->info.name << ' ' << hand.name << '=' << word.word;
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 900u);
}

TEST(CarHands, StandInTheDocumentation) {
  constexpr const char* path = "docs/hands.md";
  if (const char* approve = std::getenv("CANVOY_APPROVE"); approve != nullptr) {
    std::ofstream(path) << hand_page();
  }
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), hand_page()) << "CANVOY_APPROVE=1 with this test writes " << path;
}

// -- some of them, byte by byte

TEST(CarHands, AThingThatADeviceDoesNotHaveIsRefusedWithWhatItHas) {
  const CarUnit* const printer = &cia447::car_unit<cia447::PrinterKind>;
  EXPECT_EQ(complaint_about(printer, "paperr=no@1s"),
            "'paperr=no@1s': nothing here is 'paperr'; did you mean 'paper'?: there is paper=, "
            "mechanism=");
  EXPECT_EQ(complaint_about(printer, "paper=torn@1s"), "'paper=torn': paper takes no, yes");
  EXPECT_EQ(complaint_about(printer, "paper@1s"),
            "'paper@1s': paper takes no, yes: write paper=no@2s");
  EXPECT_EQ(complaint_about(printer, "paper=no"), "'paper=no' has no time: write paper=no@2s");
  EXPECT_EQ(complaint_about(printer, "paper=no@0s"), "");
  const CarUnit* const meter = &cia447::car_unit<cia447::TaximeterKind>;
  EXPECT_EQ(complaint_about(meter, "hire=yes@1s"),
            "'hire=yes@1s': hire takes no value: write "
            "hire@2s");
  EXPECT_EQ(complaint_about(meter, "supplement=-1@1s"),
            "'supplement=-1': supplement takes 0 to 1000000 of the currency");
  EXPECT_NE(complaint_about(meter, "supplement=nan@1s"), "");
}

/// Bits 0 and 1 of 60E1h, 01b: no paper; the others are reserved, and 1 (CiA 447-3, 4.2.13.2).
TEST(CarHands, PaperRunsOutAtTheTimeThatWasSaid) {
  Hosted printer(&cia447::car_unit<cia447::PrinterKind>);
  printer.take("paper=no@2s");
  printer.pass(1990ms);
  EXPECT_EQ(printer.read(0x60E1) & 3U, 0u);
  printer.pass(20ms);
  EXPECT_EQ(printer.read(0x60E1) & 3U, 1u);
}

/// Key 1 of the number pad is code 1 of 6082h; 0 means that none is pressed (CiA 447-3, 4.2.9.3).
TEST(CarHands, AKeyIsPressedFor300Milliseconds) {
  Hosted terminal(&cia447::car_unit<cia447::TerminalKind>);
  terminal.take("1@1s");
  terminal.pass(1010ms);
  EXPECT_EQ(terminal.read(0x6082) & 0x1FU, 1u);
  terminal.pass(280ms);
  EXPECT_EQ(terminal.read(0x6082) & 0x1FU, 1u);
  terminal.pass(20ms);
  EXPECT_EQ(terminal.read(0x6082) & 0x1FU, 0u);
}

/// Two bits for each contact; the second one is PTT. Bits 10 to 15 are reserved, and 1 (CiA 447-3,
/// 4.2.8.1).
TEST(CarHands, AContactIsActiveOrItsSensorFails) {
  Hosted inputs(&cia447::car_unit<cia447::DiscreteInputsKind>);
  inputs.pass(10ms);
  EXPECT_EQ(inputs.read(0x6078), 0xFC00u);
  inputs.take("ptt-di=input-active@20ms");
  inputs.take("beacon-sdi=failure@20ms");
  inputs.pass(20ms);
  EXPECT_EQ(inputs.read(0x6078), 0xFE04u) << "PTT 01b, beacon 10b";
}

/// Automatic start by smoke is code 4; bits 4 to 7 are 1 (CiA 447-3, 4.2.5.1).
TEST(CarHands, TheExtinguishersStart) {
  Hosted fire(&cia447::car_unit<cia447::FireExtinguishingKind>);
  fire.take("fire-extinguishing-system=automatic-started@4s");
  fire.pass(3990ms);
  EXPECT_EQ(fire.read(0x6069), 0xF1u) << "standby without limitation";
  fire.pass(20ms);
  EXPECT_EQ(fire.read(0x6069), 0xF4u);
}

/// Logged in, data valid, no failure: two bits each (CiA 447-3, 4.2.15.2).
TEST(CarHands, ADriverComesWithACardAndGoes) {
  Hosted reader(&cia447::car_unit<cia447::DriverIdentificationKind>);
  reader.take("card=4711:A. Driver@10ms");
  reader.take("remove-card@100ms");
  reader.take("unreadable-card@200ms");
  reader.pass(20ms);
  EXPECT_EQ(reader.read(0x60FA) & 0x3FU, 0x05u);
  reader.pass(100ms);
  EXPECT_EQ(reader.read(0x60FA) & 0x3FU, 0x00u);
  reader.pass(100ms);
  EXPECT_EQ(reader.read(0x60FA) & 0x3FU, 0x10u);
  EXPECT_NE(complaint_about(&cia447::car_unit<cia447::DriverIdentificationKind>, "card=x@1s"), "");
}

/// The date that was set, also after the clock has read its chip, which it does every minute (CiA
/// 447-3, 4.2.14.1).
TEST(CarHands, AClockThatIsSetStaysSet) {
  Hosted clock(&cia447::car_unit<cia447::RealTimeClockKind>);
  clock.take("time=2031-02-28T23:59:00@10ms");
  clock.pass(20ms);
  const std::uint32_t date = clock.read(0x60F0);
  clock.take("time=2031-02-28T23:57:30@30ms");
  clock.pass(62s);
  EXPECT_EQ(clock.read(0x60F0), date);
  EXPECT_EQ(
      complaint_about(&cia447::car_unit<cia447::RealTimeClockKind>, "time=2031-02-29T00:00:00@1s"),
      "'2031-02-29T00:00:00' is no time: write it as 2026-10-25T00:59:50");
}

/// Four bits for the visible satellites, four for the tracked ones (CiA 447-3, 4.2.10.2).
TEST(CarHands, AReceiverSaysWhatItIsTold) {
  Hosted gps(&cia447::car_unit<cia447::GpsKind>);
  gps.take("visible-satellites=9@10ms");
  gps.take("tracked-satellites=5@10ms");
  gps.pass(20ms);
  EXPECT_EQ(gps.read(0x60B1), 0x59u);
  gps.take("tracked-satellites=not-available@30ms");
  gps.pass(20ms);
  EXPECT_EQ(gps.read(0x60B1), 0xF9u);
  gps.take("receiver=failure@50ms");
  gps.pass(20ms);
  EXPECT_EQ(gps.read(0x60B1), 0xEEu);
}

/// As in a simulated world, which has its own car and seals.
TEST(CarHands, OneThatDoesNotNeedWhatIsAroundTheUnitWorksWithoutIt) {
  std::size_t tried = 0;
  for (const CarUnit* unit : all_units()) {
    const CarUnit* const units[] = {unit};
    cia447::CarBench bench(units);
    for (const DeviceHand& hand : car_hands(*unit)) {
      if (hand.is_around) continue;
      const std::string value = hand.form == HandForm::action   ? ""
                                : hand.name == "card"           ? "4711"
                                : hand.form == HandForm::text   ? std::string(hand.example)
                                : hand.form == HandForm::number ? fmt::format("{}", hand.most)
                                                                : hand.words.back().word;
      HandTarget target{.unit = bench.device().unit(*unit)};
      const HandValue parsed =
          hand.form == HandForm::action ? HandValue{} : parse_hand_value(hand, value);
      hand.act(target, parsed);
      bench.cable.run_for(1ms);
      ++tried;
    }
  }
  EXPECT_GT(tried, 300u);
}

// -- the keys of the meter (4.2.12)

TEST(CarHands, AMeterReachesServiceStandbyAndChangingToOffMode) {
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>);
  for (const char* order : {"sign-on@10ms", "standby@100ms", "wake@200ms", "turn-off@300ms"}) {
    meter.take(order);
  }
  meter.pass(150ms);
  EXPECT_EQ(meter.read(0x60D8) & 0xFU, 5u) << "standby mode";
  meter.pass(100ms);
  EXPECT_EQ(meter.read(0x60D8) & 0xFU, 0u) << "for hire";
  meter.pass(100ms);
  EXPECT_EQ(meter.read(0x60D8) >> 4U & 3U, 1u) << "ticof";
  for (const char* order : {"wake@400ms", "open-seal@450ms", "enter-service@500ms"}) {
    meter.take(order);
  }
  meter.pass(200ms);
  EXPECT_EQ(meter.read(0x60D8) & 0xFU, 4u) << "service mode";
}

/// 60DAh:02h (CiA 447-3, 4.2.12.8).
TEST(CarHands, TheModeOfAMeterIsBehindTheSeal) {
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>);
  meter.take("mode=odometer@10ms");
  meter.pass(50ms);
  EXPECT_EQ(meter.read(0x60DA, 2), 0u) << "taximeter operation";
  EXPECT_NE(meter.said.find("mode: not in this state"), std::string::npos) << meter.said;
  for (const char* order : {"open-seal@60ms", "enter-service@70ms", "mode=odometer@80ms"}) {
    meter.take(order);
  }
  meter.pass(50ms);
  EXPECT_EQ(meter.read(0x60DA, 2), 1u) << "odometer operation";
  EXPECT_NE(meter.said.find("UTC: mode set, 0 to 1"), std::string::npos) << meter.said;
}

/// The driver sees "for hire", so the reason for the refusal is reported.
TEST(CarHands, AKeyThatIsRefusedForTamperingSaysSo) {
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>);
  for (const char* order :
       {"hire@10ms", "sign-on@20ms", "open-seal@30ms", "close-seal@1500ms", "hire@1600ms"}) {
    meter.take(order);
  }
  meter.pass(1700ms);
  EXPECT_EQ(meter.read(0x60D8) & 0xFU, 0u) << "for hire";
  EXPECT_NE(meter.said.find("hire: not in this state"), std::string::npos) << "signed off";
  EXPECT_NE(meter.said.find("hire: refused for tampering: the seal was opened; it is to be sealed "
                            "anew in service mode"),
            std::string::npos)
      << meter.said;
}

TEST(CarHands, SeveralOrdersAreSaidInOne) {
  EXPECT_EQ(separate_orders({"sign-on@1s,hire@2.5s", "stop@3s"}),
            (std::vector<std::string>{"sign-on@1s", "hire@2.5s", "stop@3s"}));
  EXPECT_EQ(separate_orders({"destination=48.137,11.575@1s,cancel@0s"}),
            (std::vector<std::string>{"destination=48.137,11.575@1s", "cancel@0s"}));
  EXPECT_EQ(separate_orders({"clock=2026-10-25T00:59:50@1s", "hire,stop@2s", "@", ","}),
            (std::vector<std::string>{"clock=2026-10-25T00:59:50@1s", "hire,stop@2s", "@", ","}));
}

TEST(CarHands, SupplementsAndAnAgreedPriceAreInThePayment) {
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>);
  for (const char* order : {"sign-on@10ms", "agreed-price=25@20ms", "hire@30ms",
                            "supplement=2.50@40ms", "supplement=1@50ms"}) {
    meter.take(order);
  }
  meter.pass(60ms);
  EXPECT_EQ(meter.read(0x60D0, 4), 2u) << "fixed price";
  EXPECT_EQ(meter.read(0x60D0, 2), 3500u) << "thousandths";
  EXPECT_EQ(meter.read(0x60D0, 3), 25'000u + 3500u);
  meter.take("clear-supplements@70ms");
  meter.pass(20ms);
  EXPECT_EQ(meter.read(0x60D0, 2), 0u);
}

/// Tariff of the example: luggage 1,00, a booking 1,50, the airport 5,00.
TEST(CarHands, AServiceOfTheTariffIsPressedByItsName) {
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>);
  for (const char* order : {"service=luggage@10ms", "sign-on@20ms", "hire@30ms",
                            "service=luggage@40ms", "service=AIRPORT@50ms", "service=pets@60ms"}) {
    meter.take(order);
  }
  meter.pass(70ms);
  EXPECT_EQ(meter.read(0x60D0, 2), 6000u);
  EXPECT_NE(meter.said.find("service: not in this state"), std::string::npos) << meter.said;
  EXPECT_NE(meter.said.find("service: the tariff has no such supplement; there are Luggage, "
                            "Booking, Airport"),
            std::string::npos)
      << meter.said;
}

TEST(CarHands, ADoubleCalculationAnOdometerAndAFutureTariffAreSaid) {
  CarPanelOptions options;
  options.calculation = "double";
  options.mode = "odometer";
  options.future_tariff = "7@2099-12-01T00:00:00";
  Hosted odometer(&cia447::car_unit<cia447::TaximeterKind>, options);
  EXPECT_EQ(odometer.read(0x60DA, 2), 1u) << "odometer operation";
  EXPECT_EQ(odometer.read(0x60DA, 7) & 0xFFFFFFU, 7u);
  options.mode = "taximeter";
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>, options);
  meter.take("sign-on@10ms");
  meter.take("hire@20ms");
  meter.pass(30ms);
  EXPECT_EQ(meter.read(0x60D0, 4), 1u) << "double calculation mode";
  EXPECT_EQ(meter.read(0x60DA, 2), 0u);
}

TEST(CarHands, AKeyOfAnotherStateSaysSo) {
  Hosted meter(&cia447::car_unit<cia447::TaximeterKind>);
  meter.take("stop@10ms");
  meter.pass(20ms);
  EXPECT_NE(meter.said.find("taximeter: stop: not in this state\n"), std::string::npos)
      << meter.said;
}

// -- a car

/// Before the car drives, the driver has turned the key, started the engine and put the lever to D
/// (code 5); the parking brake is off (CiA 447-3, 4.2.2.3, 4.2.4).
TEST(CarHands, ACarThatIsToDriveIsReadyForIt) {
  Hosted car(&cia447::car_unit<cia447::IvnGatewayKind>);
  EXPECT_EQ(car.read(0x6007), 0x00u) << "parked";
  EXPECT_EQ(car.read(0x6051), 0u);
  car.take("speed=50@1s");
  car.pass(1s);
  EXPECT_EQ(car.read(0x6007), 0x00u);
  car.pass(30s);
  EXPECT_EQ(car.read(0x6007), 0x15u) << "lock, accessory, ignition: 01b each";
  EXPECT_EQ(car.read(0x6051), 3u) << "the engine runs";
  EXPECT_EQ(car.read(0x6052) & 0xFU, 5u) << "D";
  EXPECT_EQ(car.read(0x6052) >> 7U & 3U, 0u) << "the parking brake is disengaged";
  EXPECT_GT(car.read(0x6052) >> 11U & 0xFU, 0u) << "a gear is in";
  EXPECT_EQ(car.read(0x6009) & 0xFU, 1u) << "locked from inside";
  EXPECT_GE(car.read(0x6050) & 0x3FFFU, 800u);
  EXPECT_EQ(car.read(0x605A), 500u) << "tenths of a km/h";
  EXPECT_EQ(car.read(0x6040) >> 2U & 3U, 0u) << "the brake light is off";
  car.take("speed=0@32s");
  car.pass(2s);
  EXPECT_EQ(car.read(0x6040) >> 2U & 3U, 1u) << "it brakes";
}

TEST(CarHands, ACarSaysWhatIsMissingAndDrivesWhenItIsThere) {
  Hosted car(&cia447::car_unit<cia447::IvnGatewayKind>);
  for (const char* order : {"parking-brake=engaged@10ms", "ignition-on=off@10ms", "speed=50@20ms",
                            "ignition-on=on@1s", "parking-brake=disengaged@2s"}) {
    car.take(order);
  }
  car.pass(900ms);
  EXPECT_NE(car.said.find("ivn-gateway: the car does not drive: the ignition is off, the parking "
                          "brake is engaged\n"),
            std::string::npos)
      << car.said;
  EXPECT_EQ(car.read(0x605A), 0u);
  car.pass(1s);
  EXPECT_NE(car.said.find("does not drive: the parking brake is engaged\n"), std::string::npos);
  EXPECT_EQ(car.read(0x605A), 0u);
  car.pass(2s);
  EXPECT_GT(car.read(0x605A), 0u);
}

TEST(CarHands, ASensorOfTheCarFailsAndWorksAgain) {
  Hosted car(&cia447::car_unit<cia447::IvnGatewayKind>);
  car.take("tank-level=12@10ms");
  car.pass(200ms);
  EXPECT_EQ(car.read(0x605C) & 0xFFU, 12u);
  car.take("tank-level=failure@210ms");
  car.pass(200ms);
  EXPECT_EQ(car.read(0x605C) & 0xFFU, 0xFEu);
  car.take("tank-level=6@500ms");
  car.pass(300ms);
  EXPECT_EQ(car.read(0x605C) & 0x3FFU, 0x106u) << "6 l, and the minimum is reached";
}

}  // namespace
}  // namespace canvoy::tools::car_hands_test
