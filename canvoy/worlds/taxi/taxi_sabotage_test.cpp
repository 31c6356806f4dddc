// Complaints of a customer of a taxi, and the invariant that each breaks: alone, and together with
// each harmless fault elsewhere that excuses none of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/worlds/car/real_device_test.hpp"
#include "canvoy/worlds/taxi/taxi_excuses.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::taxi::taxi_sabotage_test {
namespace {

/// Each recurs every 45 s until all devices sleep, or lasts; no passenger pays more because of it.
constexpr ScheduledFault harmless_faults[] = {{.kind = FaultKind::restart, .node = alarm_id},
                                              {.kind = FaultKind::no_fix},
                                              {.kind = FaultKind::corrupted_frames},
                                              {.kind = FaultKind::paper_out},
                                              {.kind = FaultKind::restart, .node = navigation_id},
                                              {.kind = FaultKind::restart, .node = terminal_id},
                                              {.kind = FaultKind::restart, .node = sign_id}};
constexpr std::size_t faults_at_least = 3;

/// A shift of some minutes with trips of one or two; asleep from a minute after it.
TaxiOptions shortest_shift(const ScheduledFault* fault) {
  TaxiOptions options;
  options.length = 10min;
  options.shift.begin = Time(30s);
  options.shift.waiting_max = 10s;
  options.shift.boarding_max = 10s;
  options.shift.paying_max = 10s;
  options.shift.trip_min_metres = 400;
  options.shift.trip_max_metres = 800;
  for (Time at(45s); fault != nullptr && at < Time(6min); at += 45s) {
    ScheduledFault one = *fault;
    one.start = at;
    if (lasts(one.kind)) one.duration = 44s;
    options.faults.faults.push_back(one);
  }
  return options;
}
constexpr Time asleep_and_awake(35min);

bool is_broken(const TaxiNetwork& network, InvariantKind kind) {
  return std::ranges::any_of(network.invariants(), [kind](const Invariant& invariant) {
    return invariant.kind == kind && !invariant.held;
  });
}

/// Replaces the meter, with hands that follow the driver; its report of a trip can be made wrong.
class StrangersMeter {
 public:
  StrangersMeter(TaxiNetwork& network, std::uint32_t beside_total)
      : network_(network),
        beside_total_(beside_total),
        device_(network.world(), car::units_of<cia447::TaximeterKind>,
                {.name = "real",
                 .id = taximeter_id,
                 .serial_number = 1000U + taximeter_id,
                 .is_named_by_lss = true},
                device_names.size() + 1) {
    device_.provide(callback<&StrangersMeter::hardware>(*this));
    device_.provide(callback<&StrangersMeter::settings>(*this));
    device_.watch(callback<&StrangersMeter::is_made>(*this));
    device_.join();
  }
  StrangersMeter(const StrangersMeter&) = delete;
  StrangersMeter& operator=(const StrangersMeter&) = delete;

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
        meter_->for_hire();
        break;
      case Activity::signing_off:
        meter_->sign_off();
        break;
      default:
        break;
    }
    device_.touched();
  }

 private:
  cia447::TaximeterHardware hardware() { return {.show = callback<&StrangersMeter::show>(*this)}; }
  cia447::TaximeterSettings settings() { return {.k = 24'000, .clock_node = driver_id}; }
  void is_made(cia447::TaximeterUnit& unit, Node& node) {
    meter_ = &unit;
    node_ = &node;
  }
  /// Called after the honest amounts were set.
  void show(const cia447::TaximeterDisplay& display) {
    if (node_ == nullptr || display.trip.total == cia447::TripData::unknown) return;
    write_field(node_->dictionary(), cia447::place_of(cia447::taxi_trip_payment_total_charged),
                display.trip.total + beside_total_);
  }

  TaxiNetwork& network_;
  std::uint32_t beside_total_;
  cia447::TaximeterUnit* meter_ = nullptr;
  Node* node_ = nullptr;
  car::RealDevice device_;
};

/// Does the trick once, as soon as the driver has this activity.
using Trick = std::function<void(TaxiNetwork&)>;
Trick once_while(Activity activity, Trick trick) {
  return [activity, trick = std::move(trick), is_done = false](TaxiNetwork& network) mutable {
    if (is_done || network.snapshot().driver != activity) return;
    is_done = true;
    trick(network);
  };
}

void print(TaxiNetwork& network, std::string_view text) {
  const cia447::PrinterPaper paper = network.paper().paper();
  for (const char character : text) {
    if (character == '\n') {
      paper.feed(1);
    } else {
      paper.put({.character = static_cast<char32_t>(character)});
    }
  }
}

struct Sabotage {
  const char* name;
  InvariantKind breaks;
  std::function<void(TaxiOptions&)> set = [](TaxiOptions&) {};  ///< keys of the file
  std::function<void(TaxiNetwork&)> begin = [](TaxiNetwork&) {};
  std::function<Trick()> trick = [] { return Trick([](TaxiNetwork&) {}); };  ///< each second
  bool has_strangers_meter = false;
  bool needs_paper = false;
};
std::ostream& operator<<(std::ostream& out, const Sabotage& it) {
  return out << it.name;
}

constexpr cia447::TariffLevel dear[] = {{.name = {'1', 0},
                                         .initial_fare = 3900,
                                         .distance_rate = 2900,
                                         .time_rate = 33'000,
                                         .increment = 100}};

/// Time costs more than distance up to 33 km/h; in the town's tariff, up to 14 km/h.
constexpr cia447::TariffLevel slow[] = {{.name = {'1', 0},
                                         .initial_fare = 3900,
                                         .distance_rate = 1000,
                                         .time_rate = 33'000,
                                         .increment = 100}};
/// Of the town, but for what a trip costs at least, and but for its step.
constexpr cia447::TariffLevel least[] = {{.name = {'1', 0},
                                          .initial_fare = 3900,
                                          .minimum_fare = 60'000,
                                          .distance_rate = 2300,
                                          .time_rate = 33'000,
                                          .increment = 100}};
constexpr cia447::TariffLevel coarse[] = {{.name = {'1', 0},
                                           .initial_fare = 3900,
                                           .distance_rate = 2300,
                                           .time_rate = 33'000,
                                           .increment = 2000}};
constexpr cia447::TariffLevel twice[] = {{.name = {'1', 0},
                                          .initial_fare = 3900,
                                          .distance_rate = 2300,
                                          .time_rate = 33'000,
                                          .increment = 200}};
constexpr cia447::TariffLevel half[] = {{.name = {'1', 0},
                                         .initial_fare = 3900,
                                         .distance_rate = 2300,
                                         .time_rate = 33'000,
                                         .increment = 50}};
constexpr cia447::TariffLevel renamed[] = {{.name = {'D', 0},
                                            .initial_fare = 3900,
                                            .distance_rate = 2300,
                                            .time_rate = 33'000,
                                            .increment = 100}};
constexpr cia447::SupplementKind dear_supplements[] = {{.name = "Luggage", .price = 2000}};
constexpr cia447::SupplementKind renamed_supplements[] = {{.name = "Airport", .price = 1000}};

const Sabotage sabotages[] = {
    {"WheelsThatAreSmallerThanTheMeterWasSealedFor", InvariantKind::distance,
     [](TaxiOptions& options) { options.car.wheel_circumference_m = 1.5; }},
    {"AConstantOfOtherWheels", InvariantKind::fare,
     [](TaxiOptions& options) { options.meter.k = 20'000; }},
    {"AGatewayThatCountsMorePulses", InvariantKind::distance,
     [](TaxiOptions& options) {
       options.car.pulses_per_rotation = static_cast<decltype(options.car.pulses_per_rotation)>(
           options.car.pulses_per_rotation + 10);
     }},
    {"ATariffThatIsNotTheTowns", InvariantKind::fare,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = dear}; }},
    {"AClockByWhichItIsNight", InvariantKind::fare,
     [](TaxiOptions& options) { options.clock_ahead = 5h; }},
    {"AClockThatStampsReceiptsWrongly", InvariantKind::receipt_lines,
     [](TaxiOptions& options) { options.clock_ahead = 20min; }},
    {"ATimeThatRunsFast", InvariantKind::duration, [](TaxiOptions&) {},
     [](TaxiNetwork& network) {
       network.world().set_clock_drift(taximeter_id - SlotIndex{1}, 50'000);
     }},
    {"ATotalThatIsMoreThanFareAndExtras", InvariantKind::total,
     [](TaxiOptions& options) { options.real = {taximeter_id}; }, [](TaxiNetwork&) {},
     [] { return Trick([](TaxiNetwork&) {}); }, true},
    {"ASpeedBelowWhichItSaysThatOneWaits", InvariantKind::waiting,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = slow}; }},
    {"ASupplementThatIsDearerThanTheTowns", InvariantKind::total,
     [](TaxiOptions& options) {
       options.meter.tariff.supplements = dear_supplements;
       options.shift.service_shares = {1};
     }},
    {"ASupplementUnderTheNameOfAnother", InvariantKind::receipt_lines,
     [](TaxiOptions& options) {
       options.meter.tariff.supplements = renamed_supplements;
       options.shift.service_shares = {1};
     }},
    {"AMinimumFareThatTheTownHasNot", InvariantKind::fare,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = least}; }},
    {"AStepOfTwentyTimesTheTowns", InvariantKind::fare,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = coarse}; }},
    {"AnAgreedPriceThatTheMeterForgets", InvariantKind::fare,
     [](TaxiOptions& options) { options.shift.agreed = {.share = 1, .per_km = 2000, .least = 0}; },
     [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::carrying, [](TaxiNetwork& network) {
         network.meter().agree_price(network.meter().record().trip.fare.conditions.fixed_price +
                                     10);
       });
     }},
    {"AReceiptOfAnotherCompany", InvariantKind::receipt_lines, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().printed = Business{.company = "Isar Cabs"}; }},
    {"AReceiptOfAnotherDriver", InvariantKind::receipt_lines, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().printed = Business{.driver = "B. Driver"}; }},
    {"AReceiptWithMoreTax", InvariantKind::receipt_lines, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().printed = Business{.vat_percent = 19}; }},
    {"AReceiptOfAnotherTaxi", InvariantKind::receipt_lines,
     [](TaxiOptions& options) { options.meter.taxi_identifier = "M-TX 448"; }},
    {"AReceiptOfAnotherTown", InvariantKind::receipt_lines,
     [](TaxiOptions& options) { options.business.taxi = "B-TX 447"; }},
    {"AReceiptInAnotherCurrency", InvariantKind::receipt_lines,
     [](TaxiOptions& options) { options.meter.currency = {.code = "USD", .symbol = "USD"}; }},
    {"ATerminalInAnotherCurrency", InvariantKind::terminal_fare,
     [](TaxiOptions& options) { options.meter.currency = {.code = "USD", .symbol = "USD"}; }},
    {"AReceiptThatSaysTheOtherPayment", InvariantKind::receipt_lines, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().swaps_payment = true; }},
    {"AReceiptWithTheNumberOfAnother", InvariantKind::receipts, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().receipts_skipped = 1; }},
    {"AStepOfTwiceTheTowns", InvariantKind::fare,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = twice}; }},
    {"AStepOfHalfTheTowns", InvariantKind::fare,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = half}; }},
    {"ALevelOfAnotherNameOnTheRoof", InvariantKind::roof_sign,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = renamed}; }},
    {"ALevelOfAnotherNameOnReceipts", InvariantKind::receipt_lines,
     [](TaxiOptions& options) { options.meter.tariff = {.id = 1, .levels = renamed}; }},
    {"ALevelThatTheRoofDoesNotShow", InvariantKind::roof_sign, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().cuts_level = true; }},
    {"ATaxiLightThatIsDark", InvariantKind::roof_sign, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().cuts_taxi_light = true; }},
    {"ASlipOfLessThanWasPaid", InvariantKind::shift_slip, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::signing_off, [](TaxiNetwork& network) {
         network.meter().sign_off();
         network.meter().sign_on();  // its totals of the shift are 0
       });
     }},
    {"AnExtraThatNobodyHasPressed", InvariantKind::total, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::carrying,
                         [](TaxiNetwork& network) { network.meter().add_supplement(2000); });
     }},
    {"ALevelOfTheNightByDay", InvariantKind::fare, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::boarding,
                         [](TaxiNetwork& network) { network.meter().choose_level(1); });
     }},
    {"APriceThatNobodyHasAgreedTo", InvariantKind::fare, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::boarding,
                         [](TaxiNetwork& network) { network.meter().agree_price(50'000); });
     }},
    {"ADriverWhoAsksForMore", InvariantKind::totals, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().pocketed = 500; }},
    {"AReceiptThatNobodyHasPaid", InvariantKind::receipts, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::waiting, [](TaxiNetwork& network) {
         print(network, "Receipt 99\nFare               5.00\nTOTAL              5.00 EUR\n");
       });
     }},
    {"ALineThatIsNoneOfAReceipt", InvariantKind::receipt_lines, [](TaxiOptions&) {},
     [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::waiting,
                         [](TaxiNetwork& network) { print(network, "Night surcharge 3.00\n"); });
     },
     false, true},
    {"APrinterThatIsAway", InvariantKind::receipts, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::boarding, [](TaxiNetwork& network) {
         network.node(printer_id).power(false);  // by no fault of the plan
       });
     }},
    {"ADeviceThatIsAway", InvariantKind::device_missing, [](TaxiOptions&) {}, [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::boarding,
                         [](TaxiNetwork& network) { network.node(navigation_id).power(false); });
     }},
    {"AnAlarmThatNobodySees", InvariantKind::alarm,
     [](TaxiOptions& options) { options.alarm = 1min; },
     [](TaxiNetwork& network) { network.sabotage().cuts_sign = true; }},
    {"AnAlarmThatNobodyHears", InvariantKind::alarm,
     [](TaxiOptions& options) { options.alarm = 1min; },
     [](TaxiNetwork& network) { network.sabotage().mutes_alarm = true; }},
    {"ASignThatIsNeverSwitched", InvariantKind::roof_sign, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().cuts_sign = true; }},
    {"ATerminalThatShowsNoFare", InvariantKind::terminal_fare, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().cuts_screen = true; }},
    {"AReceiverThatDoesNotSeeTheCarMove", InvariantKind::terminal_place, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().blinds_receiver = true; }},
    {"AMeterThatDoesNotObey", InvariantKind::no_service, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().blocks_keys = true; }},
    {"ADeviceThatDoesNotSleep", InvariantKind::silence, [](TaxiOptions&) {},
     [](TaxiNetwork& network) { network.sabotage().speaks_asleep = true; }},
};

class EachTaxiSabotage : public testing::TestWithParam<Sabotage> {};

void expect_found(const Sabotage& sabotage, const ScheduledFault* fault) {
  SCOPED_TRACE(fault != nullptr ? fault_text(*fault) : "alone");
  TaxiOptions options = shortest_shift(fault);
  sabotage.set(options);
  TaxiNetwork network(options);
  std::optional<StrangersMeter> meter;
  if (sabotage.has_strangers_meter) meter.emplace(network, 50'000);
  sabotage.begin(network);
  const Trick trick = sabotage.trick();
  while (!is_broken(network, sabotage.breaks) && network.now() < asleep_and_awake) {
    network.run_until(network.now() + 1s);
    trick(network);
    if (meter) meter->press();
  }
  EXPECT_TRUE(is_broken(network, sabotage.breaks));
}

/// Once all sleep, a device that has rebooted before is silent; one device is away without a fault;
/// and without paper there is no line to be seen.
bool excuses_it(const ScheduledFault& fault, const Sabotage& sabotage) {
  const InvariantKind kind = sabotage.breaks;
  if (sabotage.needs_paper && fault.kind == FaultKind::paper_out) return true;
  if (kind == InvariantKind::silence) return false;
  if (kind == InvariantKind::device_missing) return can_cost(fault, navigation_id);
  return can_cause(fault, kind);
}

/// Alone in a full run only: what is found beside a fault is found without it.
TEST_P(EachTaxiSabotage, IsFoundAloneAndBesideEachHarmlessFault) {
  if (tries_all()) expect_found(GetParam(), nullptr);
  std::size_t tried = 0;
  for (const ScheduledFault& fault : harmless_faults) {
    if (excuses_it(fault, GetParam())) continue;
    if (!tries_all() && tried == faults_at_least) break;
    expect_found(GetParam(), &fault);
    ++tried;
  }
  EXPECT_GE(tried, faults_at_least);
}

INSTANTIATE_TEST_SUITE_P(Each, EachTaxiSabotage, testing::ValuesIn(sabotages),
                         [](const auto& it) { return std::string(it.param.name); });

/// Without a sabotage all invariants hold, and all are judged that occur in a shift of minutes.
TEST(TaxiSabotages, TheFaultBesideThemBreaksAndExcusesNothing) {
  TaxiNetwork network(shortest_shift(harmless_faults));
  network.run_until(asleep_and_awake);
  EXPECT_EQ(broken_names(network), "");
  EXPECT_EQ(car::undecided_names(network), "alarm carried ")
      << "it is the alarm that boots, and two hours are not over";
  ASSERT_GE(network.trips().size(), 2u);
  for (const Trip& trip : network.trips()) EXPECT_FALSE(trip.is_disturbed());
  for (const Invariant& invariant : network.invariants()) {
    const bool is_of_trips = invariant.kind <= InvariantKind::total;
    if (is_of_trips) {
      EXPECT_EQ(invariant.judged, network.trips().size());
    }
  }
}

}  // namespace
}  // namespace canvoy::taxi::taxi_sabotage_test
