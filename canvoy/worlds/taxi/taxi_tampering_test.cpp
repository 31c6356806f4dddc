// Tampering with a taxi is found, by the records of the meter or by what passengers pay, and it
// changes nothing that the meter can protect (Directive 2014/32/EU, annex IX: a taximeter is
// protected against corruption).
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "canvoy/sim/fault_pairs_test.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::taxi::taxi_tampering_test {
namespace {

using cia447::AuditEvent;
using cia447::TaximeterError;

TaxiOptions tampered(FaultKind kind) {
  TaxiOptions options;
  options.length = 70min;
  options.shift.begin = Time(30s);
  options.shift.waiting_max = 10s;
  options.shift.boarding_max = 10s;
  options.shift.trip_min_metres = 400;
  options.shift.trip_max_metres = 800;
  options.faults.faults = {{.kind = kind, .start = Time(90s)}};
  return options;
}

const Invariant* find(const std::vector<Invariant>& all, InvariantKind kind) {
  const auto found = std::ranges::find(all, kind, &Invariant::kind);
  return found == all.end() ? nullptr : &*found;
}

bool records(TaxiNetwork& network, AuditEvent what, std::uint32_t detail) {
  const cia447::AuditLog& log = network.meter().audit();
  for (std::size_t i = 0; i < log.size(); ++i) {
    const cia447::AuditEntry& entry = *log.newest(i);
    if (entry.what == what && (detail == 0 || entry.detail == detail)) return true;
  }
  return false;
}

struct Tamper {
  const char* name;
  FaultKind kind;
  AuditEvent recorded;       ///< none: the meter cannot detect it
  std::uint32_t detail = 0;  ///< of the record; 0: any
  const char* broken;        ///< what passengers find; empty: nothing is wrong for them
};
std::ostream& operator<<(std::ostream& out, const Tamper& it) {
  return out << it.name;
}

const Tamper tampers[] = {
    {"AStrangerWhoWrites", FaultKind::stranger_writes, AuditEvent::write_refused, 0, ""},
    {"PulsesThatAreNoneOfTheWheels", FaultKind::extra_pulses, AuditEvent::error,
     static_cast<std::uint32_t>(TaximeterError::extra_pulses), "distance "},
    {"ASealThatIsOpened", FaultKind::seal_opened, AuditEvent::seal_opened, 0, ""},
    {"WheelsOfAnotherSize", FaultKind::wrong_k, AuditEvent::none, 0, "distance "},
    {"AClockThatDrifts", FaultKind::clock_drift, AuditEvent::clock_step, 0, "receipt_lines "},
};

class EachTampering : public testing::TestWithParam<Tamper> {};

TEST_P(EachTampering, IsFound) {
  TaxiNetwork network(tampered(GetParam().kind));
  bool is_recorded = GetParam().recorded == AuditEvent::none;
  while (network.now() < Time(60min)) {
    network.run_until(network.now() + 10s);
    is_recorded = is_recorded || records(network, GetParam().recorded, GetParam().detail);
  }
  EXPECT_TRUE(is_recorded);
  const std::string broken = broken_names(network);
  EXPECT_NE(broken.find(GetParam().broken), std::string::npos) << broken;
  EXPECT_EQ(broken.empty(), GetParam().broken[0] == '\0') << broken;
  const std::vector<Invariant> verdicts = network.invariants();
  const Invariant* const tampering = find(verdicts, InvariantKind::tampering);
  ASSERT_NE(tampering, nullptr);
  EXPECT_TRUE(tampering->held);
  EXPECT_EQ(tampering->judged, 1u);
}

INSTANTIATE_TEST_SUITE_P(Each, EachTampering, testing::ValuesIn(tampers),
                         [](const auto& it) { return std::string(it.param.name); });

TEST(Tampering, EachKindOfItIsInTheTable) {
  EXPECT_EQ(std::size(tampers), std::size(fault_rows) - fault_kinds);
}

/// 20 m each second by two channels, while the car drives normally: a kilometre costs the same.
TEST(Tampering, AStrangerChangesNeitherFareNorTrip) {
  TaxiOptions honest = tampered(FaultKind::stranger_writes);
  honest.faults.faults.clear();
  TaxiNetwork without(honest);
  TaxiNetwork with(tampered(FaultKind::stranger_writes));
  without.run_until(Time(30min));
  with.run_until(Time(30min));
  ASSERT_GE(with.trips().size(), 3u);
  ASSERT_EQ(with.trips().size(), without.trips().size());
  for (std::size_t i = 0; i < with.trips().size(); ++i) {
    EXPECT_EQ(with.trips()[i].metered_fare, without.trips()[i].metered_fare) << i;
  }
}

/// Passengers whom the meter rightly does not accept do not wait because of it.
TEST(Tampering, AMeterThatWasOpenedTakesNobodyAndIsExcused) {
  TaxiNetwork network(tampered(FaultKind::seal_opened));
  network.run_until(Time(20min));
  EXPECT_LE(network.trips().size(), 1u);
  EXPECT_EQ(broken_names(network), "");
}

/// 48 s are too little for the meter's records, and enough for the minutes on receipts.
TEST(Tampering, AClockThatHasDriftedALittleIsFoundByTheNextReceipts) {
  TaxiOptions options = tampered(FaultKind::clock_drift);
  options.length = 3h;
  options.faults.faults[0].duration = 8min;
  TaxiNetwork network(options);
  network.run_until(Time(62min));
  const std::vector<Invariant> verdicts = network.invariants();
  const Invariant* const tampering = find(verdicts, InvariantKind::tampering);
  ASSERT_NE(tampering, nullptr);
  EXPECT_TRUE(tampering->held);
  EXPECT_EQ(tampering->judged, 1u);
}

TEST(Tampering, WithoutItThereIsNoVerdict) {
  TaxiOptions honest = tampered(FaultKind::stranger_writes);
  honest.faults.faults.clear();
  TaxiNetwork network(honest);
  network.run_until(Time(5min));
  EXPECT_EQ(find(network.invariants(), InvariantKind::tampering), nullptr);
}

TEST(TamperWatch, WhoIsNotFoundInAnHourIsMissed) {
  TamperWatch watch;
  watch.begins(FaultKind::stranger_writes, Time(1min));
  watch.begins(FaultKind::wrong_k, Time(2min));
  EXPECT_EQ(watch.judged(Time(61min)), 0u);
  EXPECT_EQ(watch.missed(Time(61min) + 1us), 1u);
  watch.recorded({.what = AuditEvent::seal_opened});
  EXPECT_EQ(watch.missed(Time(62min) + 1us), 2u) << "that is about another act";
  watch.recorded({.what = AuditEvent::write_refused});
  EXPECT_EQ(watch.missed(Time(62min) + 1us), 1u);
  watch.passengers_see();
  EXPECT_EQ(watch.missed(Time(62min) + 1us), 0u);
  EXPECT_EQ(watch.judged(Time(62min) + 1us), 2u);
}

}  // namespace
}  // namespace canvoy::taxi::taxi_tampering_test
