// What a customer of a taxi would complain of, and the invariant that it breaks: alone, and
// together with a harmless fault elsewhere, which excuses none of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "canvoy/sim/car/real_device_test.hpp"
#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi::taxi_sabotage_test {
namespace {

/// A shift of some minutes with trips of one or two; asleep from a minute after it.
TaxiOptions shortest_shift(bool has_fault) {
  TaxiOptions options;
  options.length = 10min;
  options.shift.begin = Time(30s);
  options.shift.waiting_max = 10s;
  options.shift.boarding_max = 10s;
  options.shift.paying_max = 10s;
  options.shift.trip_min_metres = 400;
  options.shift.trip_max_metres = 800;
  // The alarm boots again and again, until all sleep: nobody pays more by that.
  for (Time at(45s); has_fault && at < Time(6min); at += 45s) {
    options.faults.faults.push_back({.kind = FaultKind::restart, .start = at, .node = alarm_id});
  }
  return options;
}
constexpr Time asleep_and_awake(35min);

bool is_broken(const TaxiNetwork& network, InvariantKind kind) {
  return std::ranges::any_of(network.invariants(), [kind](const Invariant& invariant) {
    return invariant.kind == kind && !invariant.held;
  });
}

/// In the place of the meter, with hands that do what the driver does next; what it tells of a trip
/// can be made wrong.
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
    device_.offer(Callback<cia447::TaximeterHardware()>::to<&StrangersMeter::hardware>(*this));
    device_.offer(Callback<cia447::TaximeterSettings()>::to<&StrangersMeter::settings>(*this));
    device_.watch(
        Callback<void(cia447::TaximeterUnit&, Node&)>::to<&StrangersMeter::is_made>(*this));
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
  cia447::TaximeterHardware hardware() {
    return {.show =
                Callback<void(const cia447::TaximeterDisplay&)>::to<&StrangersMeter::show>(*this)};
  }
  cia447::TaximeterSettings settings() { return {.k = 24'000, .clock_node = driver_id}; }
  void is_made(cia447::TaximeterUnit& unit, Node& node) {
    meter_ = &unit;
    node_ = &node;
  }
  /// After the honest amounts were put there.
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

/// Once, as soon as the driver does this.
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
};
std::ostream& operator<<(std::ostream& out, const Sabotage& it) {
  return out << it.name;
}

constexpr cia447::TariffLevel dear[] = {{.name = {'1', 0},
                                         .initial_fare = 3900,
                                         .distance_rate = 2900,
                                         .time_rate = 33'000,
                                         .increment = 100}};

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
         print(network, "Receipt 99\nFare            5.00\nTOTAL           5.00\n");
       });
     }},
    {"ALineThatIsNoneOfAReceipt", InvariantKind::receipt_lines, [](TaxiOptions&) {},
     [](TaxiNetwork&) {},
     [] {
       return once_while(Activity::waiting,
                         [](TaxiNetwork& network) { print(network, "Night surcharge 3.00\n"); });
     }},
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

void expect_found(const Sabotage& sabotage, bool has_fault) {
  SCOPED_TRACE(has_fault ? "with an alarm that restarts" : "alone");
  TaxiOptions options = shortest_shift(has_fault);
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

TEST_P(EachTaxiSabotage, IsFoundAlone) {
  expect_found(GetParam(), false);
}

TEST_P(EachTaxiSabotage, IsFoundBesideAHarmlessFault) {
  expect_found(GetParam(), true);
}

INSTANTIATE_TEST_SUITE_P(Each, EachTaxiSabotage, testing::ValuesIn(sabotages),
                         [](const auto& it) { return std::string(it.param.name); });

/// Without one all holds, and all is judged that a shift of minutes has.
TEST(TaxiSabotages, TheFaultBesideThemBreaksAndExcusesNothing) {
  TaxiNetwork network(shortest_shift(true));
  network.run_until(asleep_and_awake);
  EXPECT_EQ(broken_names(network), "");
  EXPECT_EQ(car::undecided_names(network), "carried ") << "two hours are not over";
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
