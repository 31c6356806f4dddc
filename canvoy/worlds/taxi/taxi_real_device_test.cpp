// Real devices in the simulated taxi: each is a simulated device that the test puts on the bus,
// with its own hardware; car and driver follow its reports.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>

#include "canvoy/worlds/car/real_device_test.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::taxi::taxi_real_device_test {
namespace {

constexpr Duration shift_over = 32min;

TaxiOptions with_real(NodeId id, std::initializer_list<NodeId> others = {}) {
  TaxiOptions options;
  options.length = 40min;  // the last trip begins before half of it
  options.shift.waiting_max = 1min;
  options.shift.trip_max_metres = 2000;
  options.real = others;
  options.real.push_back(id);
  return options;
}

/// The world has eight nodes and one listener.
class Stranger : public car::RealDevice {
 public:
  Stranger(TaxiNetwork& network, std::span<const cia447::CarUnit* const> units, NodeId id)
      : RealDevice(network.world(), units,
                   {.name = "real",
                    .id = id,
                    .serial_number = 1000U + id,
                    .is_named_by_lss = id != cia447::gateway_node_id},
                   device_names.size() + 1) {}
  Stranger(TaxiNetwork& network, std::span<const cia447::CarUnit* const> units,
           const car::CarNode::Place& place)
      : RealDevice(network.world(), units, place, device_names.size() + 1) {}
};

constexpr std::uint32_t other_maker = 0x2F0;
/// A device of another manufacturer, of which nothing is known here.
constexpr car::CarNode::Place of_other_maker(NodeId id) {
  return {.name = "real", .id = id, .serial_number = 77, .vendor_id = other_maker};
}

template <class What>
std::size_t count(const TaxiNetwork& network) {
  return static_cast<std::size_t>(std::ranges::count_if(
      network.events(),
      [](const TaxiEvent& event) { return std::holds_alternative<What>(event.what); }));
}

/// A meter with hands that follow the driver.
class RealMeter {
 public:
  /// Errors in its receipts and its totals.
  struct Fraud {
    bool prints = false;
    std::uint32_t on_paper = 0;      ///< beyond the payment, in 0.001 of the currency unit
    std::uint32_t after_paying = 0;  ///< a supplement that no passenger pays
  };
  explicit RealMeter(std::uint32_t k = 24'000, std::initializer_list<NodeId> others = {})
      : RealMeter(k, others, Fraud{}) {}
  explicit RealMeter(const Fraud& fraud) : RealMeter(24'000, {}, fraud) {}
  RealMeter(std::uint32_t k, std::initializer_list<NodeId> others, const Fraud& fraud)
      : k_(k), fraud_(fraud), network_(with_real(taximeter_id, others)) {
    stranger_.provide(callback<&RealMeter::hardware>(*this));
    stranger_.watch(car_network_);
    stranger_.provide(callback<&RealMeter::settings>(*this));
    stranger_.watch(meter_);
    stranger_.join();
  }
  /// The outputs have a timer of its node.
  ~RealMeter() { outputs_.reset(); }
  RealMeter(const RealMeter&) = delete;
  RealMeter& operator=(const RealMeter&) = delete;

  void run_until(Time until) {
    while (network_.now() < until) {
      network_.run_until(network_.now() + 1s);
      press();
      stranger_.touched();
    }
  }
  TaxiNetwork& network() { return network_; }
  cia447::TaximeterUnit& meter() { return *meter_; }

 private:
  cia447::TaximeterSettings settings() { return {.k = k_, .clock_node = driver_id}; }
  void press() {
    switch (network_.snapshot().driver) {
      case Activity::signing_on:
        meter_->sign_on();
        break;
      case Activity::hiring:
        meter_->hire();
        break;
      case Activity::stopping:
        meter_->stop();
        break;
      case Activity::releasing:
        if (fraud_.after_paying != 0) meter_->add_supplement(fraud_.after_paying);
        if (meter_->for_hire() && fraud_.prints) print();
        break;
      case Activity::signing_off:
        meter_->sign_off();
        break;
      default:
        break;
    }
  }

  void print() {
    if (!outputs_)
      outputs_.emplace(*car_network_, cia447::MeterOutputs::Settings{.printer = printer_id});
    const std::uint32_t cents = (trip_.total + fraud_.on_paper) / 10;
    outputs_->print("Summe " + std::to_string(cents / 100) + "," + std::to_string(cents / 10 % 10) +
                    std::to_string(cents % 10) + " EUR\n");
  }
  cia447::TaximeterHardware hardware() { return {.show = callback<&RealMeter::show>(*this)}; }
  void show(const cia447::TaximeterDisplay& display) { trip_ = display.trip; }

  std::uint32_t k_;
  Fraud fraud_;
  TaxiNetwork network_;
  cia447::TaximeterUnit* meter_ = nullptr;
  cia447::TripData trip_;
  cia447::CarNetwork* car_network_ = nullptr;
  std::optional<cia447::MeterOutputs> outputs_;
  Stranger stranger_{network_, car::units_of<cia447::TaximeterKind>, taximeter_id};
};

TEST(RealTaxiDevice, AMeterOfSomebodyElseIsWhatTheDriverFollowsAndItsFareIsReadAndJudged) {
  RealMeter car;
  car.run_until(Time(shift_over));
  const auto trips = car.network().trips();
  ASSERT_GE(trips.size(), 2u);
  EXPECT_TRUE(car.network().all_hold());
  EXPECT_EQ(car.meter().record().total.hirings, trips.size());
  // The meter has counted the pulses of the simulated car.
  double metres = 0;
  for (const Trip& trip : trips) metres += trip.metres;
  EXPECT_NEAR(car.meter().record().total.distance_hired, metres,
              static_cast<double>(trips.size()) * 4 + 0.002 * metres);
  EXPECT_GE(count<ShiftChanged>(car.network()), 1u);
  // Its fare is read and judged.
  double paid = 0;
  for (const Trip& trip : trips) {
    EXPECT_FALSE(trip.is_disturbed());
    EXPECT_GT(trip.paid, 0);
    paid += trip.paid;
  }
  EXPECT_DOUBLE_EQ(paid, car.meter().record().total.income);
}

/// Instructions to a person at a real meter.
TEST(RealTaxiDevice, ATesterOfAMeterIsToldWhenPassengersGetInPayAndGetOut) {
  RealMeter car;
  car.run_until(Time(shift_over));
  std::string told;
  for (const TaxiEvent& event : car.network().events()) {
    if (const auto* seen = std::get_if<PassengersSeen>(&event.what)) {
      told += seen->doing == PassengersSeen::Doing::get_in ? "in " : "out. ";
    } else if (const auto* key = std::get_if<MeterWaitedFor>(&event.what)) {
      told += "wait " + std::to_string(static_cast<int>(key->state)) + " ";
    } else if (std::holds_alternative<TripPaid>(event.what)) {
      told += "paid ";
    }
  }
  // 60D8h: for hire 0, hired 1, stopped 2, signed off 3 (4.2.12.6).
  std::string expected = "wait 0 ";
  for (std::size_t i = 0; i < car.network().trips().size(); ++i) {
    expected += "in wait 1 wait 2 paid out. wait 0 ";
  }
  EXPECT_EQ(told, expected + "wait 3 ");
}

TEST(RealTaxiDevice, AMeterThatIsSealedForOtherWheelsIsFound) {
  RealMeter car(25'000);
  car.run_until(Time(shift_over));
  ASSERT_GE(car.network().trips().size(), 2u);
  EXPECT_EQ(broken_names(car.network()), "fare distance ");
}

TEST(RealTaxiDevice, AMetersReceiptsAreReadInItsOwnWords) {
  RealMeter car(RealMeter::Fraud{.prints = true});
  car.run_until(Time(shift_over));
  ASSERT_GE(car.network().trips().size(), 2u);
  EXPECT_EQ(car.network().paper().lines().size(), car.network().trips().size());
  EXPECT_EQ(broken_names(car.network()), "");
}

TEST(RealTaxiDevice, AMeterThatPrintsMoreThanWasPaidIsFound) {
  RealMeter car(RealMeter::Fraud{.prints = true, .on_paper = 1000});
  car.run_until(Time(shift_over));
  EXPECT_EQ(broken_names(car.network()), "receipts ");
}

TEST(RealTaxiDevice, AMeterThatAddsUpMoreThanWasPaidIsFound) {
  RealMeter car(RealMeter::Fraud{.after_paying = 1000});
  car.run_until(Time(shift_over));
  ASSERT_EQ(car.network().snapshot().driver, Activity::off_duty) << "the shift is over";
  EXPECT_EQ(broken_names(car.network()), "totals ");
}

TEST(RealTaxiDevice, WithoutHandsAtItTheDriverWaits) {
  TaxiNetwork network(with_real(taximeter_id));
  Stranger meter(network, car::units_of<cia447::TaximeterKind>, taximeter_id);
  meter.join();
  network.run_until(Time(2h + 2min));
  EXPECT_EQ(network.snapshot().driver, Activity::signing_on);
  EXPECT_EQ(broken_names(network), "");
  EXPECT_EQ(
      car::undecided_names(network),
      "fare distance duration waiting total totals receipts receipt_lines shift_slip roof_sign "
      "terminal_fare silence no_service carried ")
      << "nobody here knows whom a real one carries";
  EXPECT_EQ(network.trips().size(), 0u);
}

/// A taxi with a real alarm, ten minutes after the start.
struct RealAlarm {
  RealAlarm() {
    stranger.watch(unit);
    stranger.join();
    network.run_until(Time(10min));
  }

  TaxiNetwork network{with_real(alarm_id)};
  cia447::TaxiAlarmUnit* unit = nullptr;
  Stranger stranger{network, car::units_of<cia447::TaxiAlarmKind>, alarm_id};
};

TEST(RealTaxiDevice, AnAlarmThatIsPressedThereIsAnAlarm) {
  RealAlarm alarm;
  TaxiNetwork& network = alarm.network;
  EXPECT_EQ(count<AlarmPressed>(network), 0u);
  alarm.unit->press_key(true);
  alarm.unit->press_key(false);
  alarm.stranger.touched();
  network.run_until(Time(11min));
  EXPECT_EQ(count<AlarmPressed>(network), 1u);
  EXPECT_TRUE(network.all_hold());
}

TEST(RealTaxiDevice, OneThatVanishesIsMissing) {
  RealAlarm alarm;
  TaxiNetwork& network = alarm.network;
  alarm.stranger.vanish();
  network.run_until(Time(10min + 22s));  // its last heartbeat holds for 3 s
  EXPECT_EQ(broken_names(network), "");
  network.run_until(Time(10min + 24s));
  EXPECT_EQ(broken_names(network), "device_missing ");
}

TEST(RealTaxiDevice, OneThatComesBackInTimeIsNot) {
  RealAlarm alarm;
  TaxiNetwork& network = alarm.network;
  alarm.stranger.vanish();
  network.run_until(Time(10min + 10s));
  alarm.stranger.join();
  network.run_until(Time(20min));
  EXPECT_EQ(broken_names(network), "");
}

/// LSS assigns node-IDs one after the other, and a real device answers when its computer lets it.
TEST(RealTaxiDevice, WhoIsPlayedBesideARealOneHasThreeMinutesToBeNamed) {
  TaxiNetwork network(with_real(alarm_id));
  Stranger alarm(network, car::units_of<cia447::TaxiAlarmKind>, alarm_id);
  alarm.join();
  network.node(printer_id).power(false);
  network.run_until(Time(91s));
  network.node(printer_id).power(true);
  network.run_until(Time(2min));
  EXPECT_TRUE(network.node(printer_id).is_operational());
  EXPECT_EQ(broken_names(network), "");
}

TEST(RealTaxiDevice, AndIsMissedAfterThem) {
  TaxiNetwork network(with_real(alarm_id));
  Stranger alarm(network, car::units_of<cia447::TaxiAlarmKind>, alarm_id);
  alarm.join();
  network.node(printer_id).power(false);
  network.run_until(Time(3min + 19s));
  EXPECT_EQ(broken_names(network), "");
  network.run_until(Time(3min + 21s));
  EXPECT_EQ(broken_names(network), "device_missing ");
}

/// A car that always drives at 36 km/h.
class RealCar {
 public:
  explicit RealCar(TaxiNetwork& network) : network_(network) {}

  cia447::CarHardware hardware() {
    cia447::CarHardware car = cia447::parked_car();
    car.distance = cia447::Sensor::to<&RealCar::distance>(*this);
    car.speed = cia447::Sensor::to<&RealCar::speed>(*this);
    return car;
  }
  std::optional<double> distance() {
    return 10 * std::chrono::duration<double>(network_.now() - Time{}).count();
  }

 private:
  std::optional<double> speed() { return 10; }
  TaxiNetwork& network_;
};

TEST(RealTaxiDevice, AGatewayOfSomebodyElseIsTheCarThatDrives) {
  TaxiNetwork network(with_real(cia447::gateway_node_id));
  RealCar car(network);
  Stranger stranger(network, car::units_of<cia447::IvnGatewayKind>, cia447::gateway_node_id);
  stranger.provide(callback<&RealCar::hardware>(car));
  stranger.join();
  network.run_until(Time(25min));
  // From its first valid count on, which takes some time.
  EXPECT_NEAR(network.drive().metres(), *car.distance(), 20);
  EXPECT_NEAR(network.drive().speed(), 10, 0.5);
  for (const auto& node : network.nodes()) {
    EXPECT_EQ(node->is_operational(), node->place().id != cia447::gateway_node_id)
        << node->place().name;
  }
  ASSERT_GE(network.trips().size(), 2u);
  for (const Trip& trip : network.trips()) {
    EXPECT_NEAR(trip.metered_metres, trip.metres, 0.002 * trip.metres + 4);
  }
  EXPECT_TRUE(network.all_hold());
}

TEST(RealTaxiDevice, WithARealGatewayAnotherDeviceAsksTheMeter) {
  RealMeter meter(24'000, {cia447::gateway_node_id});
  TaxiNetwork& network = meter.network();
  RealCar car(network);
  Stranger gateway(network, car::units_of<cia447::IvnGatewayKind>, cia447::gateway_node_id);
  gateway.provide(callback<&RealCar::hardware>(car));
  gateway.join();
  meter.run_until(Time(shift_over));
  ASSERT_GE(network.trips().size(), 2u);
  for (const Trip& trip : network.trips()) {
    EXPECT_FALSE(trip.is_disturbed());
    EXPECT_GT(trip.metered_fare, 0);
  }
  EXPECT_EQ(broken_names(network), "");
}

/// Each device in turn, with the invariants that cannot be judged then.
struct RealTaxiCase {
  NodeId id;
  std::span<const cia447::CarUnit* const> units;
  const char* undecided;
};
std::ostream& operator<<(std::ostream& out, const RealTaxiCase& it) {
  return out << "node " << unsigned{it.id};
}
const RealTaxiCase real_taxi_cases[] = {
    {cia447::gateway_node_id, car::units_of<cia447::IvnGatewayKind>,
     "fare distance duration waiting total totals receipts receipt_lines shift_slip alarm "
     "silence "},
    {taximeter_id, car::units_of<cia447::TaximeterKind>,
     "fare distance duration waiting total totals receipts receipt_lines shift_slip roof_sign "
     "alarm "
     "terminal_fare silence no_service "},
    {printer_id, car::units_of<cia447::PrinterKind>,
     "receipts receipt_lines shift_slip alarm silence "},
    {driver_id, car::units_of<cia447::DriverIdentificationKind, cia447::RealTimeClockKind>,
     "fare waiting receipts receipt_lines shift_slip alarm terminal_place silence "},
    {sign_id, car::units_of<cia447::TariffDisplayKind>,
     "receipts receipt_lines shift_slip roof_sign alarm silence "},
    {terminal_id, car::units_of<cia447::TerminalKind>,
     "receipts receipt_lines shift_slip alarm terminal_fare terminal_place silence "},
    {navigation_id, car::units_of<cia447::GpsKind, cia447::NavigationKind>,
     "receipts receipt_lines shift_slip alarm terminal_place silence "},
    {alarm_id, car::units_of<cia447::TaxiAlarmKind>,
     "receipts receipt_lines shift_slip alarm silence "},
};

class EachRealTaxiDevice : public testing::TestWithParam<RealTaxiCase> {};

TEST_P(EachRealTaxiDevice, HasItsPlaceAndIsSupervised) {
  TaxiNetwork network(with_real(GetParam().id));
  Stranger device(network, GetParam().units, GetParam().id);
  device.join();
  car::expect_supervision(network, device, Time(8min), Time(12min));
  EXPECT_EQ(car::undecided_names(network), GetParam().undecided + std::string("carried "))
      << "who is carried, before two hours are over; receipts and sleep, before the shift is; and "
         "no alarm was pressed";
}

/// The gateway does not get its node-ID from another device.
TEST_P(EachRealTaxiDevice, OneOfAnotherMakerHasItAsWell) {
  if (GetParam().id == cia447::gateway_node_id) return;
  TaxiNetwork network(with_real(GetParam().id));
  Stranger device(network, GetParam().units, of_other_maker(GetParam().id));
  device.join();
  car::expect_supervision(network, device, Time(8min), Time(12min));
}

TEST_P(EachRealTaxiDevice, OneThatNeverComesIsMissing) {
  TaxiNetwork network(with_real(GetParam().id));
  network.run_until(Time(79s));  // a minute to come, and 20 s like each device that is lost
  EXPECT_EQ(broken_names(network), "");
  network.run_until(Time(81s));
  EXPECT_EQ(broken_names(network), "device_missing ");
}

TEST_P(EachRealTaxiDevice, OneThatVanishesAsSoonAsAllHaveStartedIsMissing) {
  TaxiNetwork network(with_real(GetParam().id));
  Stranger device(network, GetParam().units, GetParam().id);
  device.join();
  car::expect_early_loss_is_told(network, device);
}

INSTANTIATE_TEST_SUITE_P(Nodes, EachRealTaxiDevice, testing::ValuesIn(real_taxi_cases));

TaxiOptions printer_of(std::uint32_t vendor) {
  TaxiOptions options = with_real(printer_id);
  options.identities = {{.id = printer_id, .identity = {.address = {{vendor}}, .known = {true}}}};
  return options;
}

TEST(RealTaxiDevice, WhoHasTheIdentityThatTheFileNamesTakesThePlace) {
  TaxiNetwork network(printer_of(other_maker));
  Stranger printer(network, car::units_of<cia447::PrinterKind>, of_other_maker(printer_id));
  printer.join();
  network.run_until(Time(2min));
  EXPECT_TRUE(printer.node().is_operational());
  EXPECT_EQ(broken_names(network), "");
}

TEST(RealTaxiDevice, WhoHasAnotherOneDoesNot) {
  TaxiNetwork network(printer_of(other_maker + 1));
  Stranger printer(network, car::units_of<cia447::PrinterKind>, of_other_maker(printer_id));
  printer.join();
  network.run_until(Time(2min));
  EXPECT_EQ(printer.node().node().id(), 9) << "the first that is free";
  EXPECT_EQ(broken_names(network), "device_missing ");
}

TEST(RealTaxiDevice, AllPlacesAreTried) {
  ASSERT_EQ(std::size(real_taxi_cases), device_names.size());
  for (NodeId id = 1; id <= device_names.size(); ++id) EXPECT_EQ(real_taxi_cases[id - 1].id, id);
}

}  // namespace
}  // namespace canvoy::taxi::taxi_real_device_test
