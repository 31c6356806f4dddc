// Each fault of each world: the doctor reports nothing that no fault causes.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <string>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/text/doctor/doctor.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/police/police_network.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::world_faults_test {
namespace {

using text::FindingKind;

// Power, cables, sensors, clocks, foreign devices that fill the bus: no device has another
// configuration, uses another protocol, or exists twice.
constexpr FindingKind never_caused[] = {
    FindingKind::no_traffic,    FindingKind::wrong_bit_rate, FindingKind::node_id_twice,
    FindingKind::cob_id_twice,  FindingKind::pdo_length,     FindingKind::sync_window,
    FindingKind::inhibit_time,  FindingKind::reserved_value, FindingKind::against_protocol,
    FindingKind::sheet_differs, FindingKind::sync_twice,     FindingKind::sync_differs};

/// Listens to all buses of a world until its fault is long over. Duplicate devices are expected.
template <class Network>
void listen(Network& network, const std::string& fault, Duration length, std::uint32_t bit_rate,
            unsigned buses = 1) {
  std::deque<text::Doctor> doctors;
  for (unsigned i = 0; i < buses; ++i)
    doctors.emplace_back(text::DoctorOptions{.bit_rate = bit_rate});
  for (BusIndex bus = 0; bus < doctors.size(); ++bus) {
    network.world().bus(bus).observe(
        {.context = &doctors[bus],
         .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
           static_cast<text::Doctor*>(context)->hear(now, frame);
         }});
  }
  network.run_until(Time(length));
  ASSERT_GE(doctors[0].observed().traffic.frames(), 1000U) << fault;
  const bool is_twice = fault.starts_with("duplicate-node-id");
  bool is_told = false;
  for (text::Doctor& doctor : doctors) {
    for (const text::Finding& finding : doctor.findings(Time(length))) {
      const bool is_twin = is_twice && finding.kind == FindingKind::node_id_twice;
      is_told |= is_twin;
      EXPECT_TRUE(is_twin ||
                  std::ranges::find(never_caused, finding.kind) == std::end(never_caused))
          << fault << ": " << text::finding_row(finding.kind).name << ": " << finding.what;
    }
  }
  EXPECT_EQ(is_told, is_twice) << fault;
}

/// Every third fault, from `first` on; all faults in a full test. Returns their number.
template <class Kind, class Try>
std::size_t each_fault(unsigned first, std::string_view when, const Try& attempt) {
  const auto kinds = fault_grammar<Kind>().kinds;
  std::size_t count = 0;
  const std::size_t step = tries_all() ? 1 : 3;
  for (std::size_t i = tries_all() ? 0 : first; i < kinds.size(); i += step, ++count) {
    const std::string text = std::string(kinds[i].name) + std::string(when);
    attempt(*parse_fault<Kind>(text).fault, text);
  }
  return count;
}

TEST(WorldFaults, OfAChargerAreNotTakenForOthers) {
  const std::size_t count =
      each_fault<charger::FaultKind>(1, "@2min+20s", [](auto fault, const std::string& text) {
        charger::ChargerOptions options;
        options.faults.faults = {fault};
        charger::ChargerNetwork network(options);
        listen(network, text, 5min, options.bit_rate);
      });
  EXPECT_GE(count, 5U);
}

TEST(WorldFaults, OfALiftAreNotTakenForOthers) {
  const std::size_t count =
      each_fault<lift::FaultKind>(1, "@2min+20s", [](auto fault, const std::string& text) {
        lift::LiftNetworkDescription description = lift::standard_lift_network({.seed = 1});
        description.faults.faults = {fault};
        lift::LiftNetwork network(std::move(description));
        listen(network, text, 5min, lift::lift_bit_rate);
      });
  EXPECT_GE(count, 5U);
}

template <class Network, class Options, class Kind>
void try_each(unsigned first, std::string_view when, Duration length, unsigned buses = 1) {
  const std::size_t count = each_fault<Kind>(first, when, [&](auto fault, const std::string& text) {
    Options options;
    options.length = length;
    options.faults.faults = {fault};
    Network network(options);
    listen(network, text, length, options.bit_rate, buses);
  });
  EXPECT_GE(count, 2U);
}

TEST(WorldFaults, OfATaxiAreNotTakenForOthers) {
  try_each<taxi::TaxiNetwork, taxi::TaxiOptions, taxi::FaultKind>(2, "@5min+20s", 8min);
}
TEST(WorldFaults, OfAPoliceCarAreNotTakenForOthers) {
  try_each<police::PoliceNetwork, police::PoliceOptions, police::FaultKind>(0, "@5min+20s", 8min);
}
TEST(WorldFaults, OfABusAreNotTakenForOthers) {
  try_each<bus_line::BusNetwork, bus_line::BusNetworkOptions, bus_line::FaultKind>(2, "@24min+20s",
                                                                                   27min, 2);
}
TEST(WorldFaults, OfAnExcavatorAreNotTakenForOthers) {
  try_each<excavator::ExcavatorNetwork, excavator::ExcavatorOptions, excavator::FaultKind>(
      0, "@100s+10s", 3min, 2);
}

}  // namespace
}  // namespace canvoy::world_faults_test
