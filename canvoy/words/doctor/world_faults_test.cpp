// Each fault of each world: the doctor has no words for what none of them does.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <string>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/sim/bus/bus_network.hpp"
#include "canvoy/sim/charging/charging_network.hpp"
#include "canvoy/sim/excavator/excavator_network.hpp"
#include "canvoy/sim/lift/lift_network.hpp"
#include "canvoy/sim/lift/lift_network_description.hpp"
#include "canvoy/sim/police/police_network.hpp"
#include "canvoy/sim/taxi/taxi_network.hpp"
#include "canvoy/words/doctor/doctor.hpp"

namespace canvoy::world_faults_test {
namespace {

using words::FindingKind;

// Power, cables, sensors, clocks, strangers who fill the bus: no device has another configuration,
// speaks another protocol, or is there twice.
constexpr FindingKind never_caused[] = {FindingKind::no_traffic,       FindingKind::wrong_bit_rate,
                                        FindingKind::node_id_twice,    FindingKind::cob_id_twice,
                                        FindingKind::pdo_length,       FindingKind::sync_window,
                                        FindingKind::inhibit_time,     FindingKind::reserved_value,
                                        FindingKind::against_protocol, FindingKind::sheet_differs};

/// Listens to all buses of a world until its fault is long over. Who is there twice is told.
template <class Network>
void listen(Network& network, const std::string& fault, Duration length, std::uint32_t bit_rate,
            unsigned buses = 1) {
  std::deque<words::Doctor> doctors;
  for (unsigned i = 0; i < buses; ++i)
    doctors.emplace_back(words::DoctorOptions{.bit_rate = bit_rate});
  for (BusIndex bus = 0; bus < doctors.size(); ++bus) {
    network.world().bus(bus).observe(
        {.context = &doctors[bus],
         .on_frame = [](void* context, Time now, ControllerId, const Frame& frame) {
           static_cast<words::Doctor*>(context)->hear(now, frame);
         }});
  }
  network.run_until(Time(length));
  ASSERT_GE(doctors[0].observed().traffic.frames(), 1000U) << fault;
  const bool is_twice = fault.starts_with("duplicate-node-id");
  bool is_told = false;
  for (words::Doctor& doctor : doctors) {
    for (const words::Finding& finding : doctor.findings(Time(length))) {
      const bool is_twin = is_twice && finding.kind == FindingKind::node_id_twice;
      is_told |= is_twin;
      EXPECT_TRUE(is_twin ||
                  std::ranges::find(never_caused, finding.kind) == std::end(never_caused))
          << fault << ": " << words::finding_row(finding.kind).name << ": " << finding.what;
    }
  }
  EXPECT_EQ(is_told, is_twice) << fault;
}

/// Each third fault, from `first` on; all where all is tried. How many.
template <class Kind, class Try>
std::size_t each_fault(unsigned first, std::string_view when, const Try& attempt) {
  const auto kinds = fault_grammar<Kind>().kinds;
  std::size_t count = 0;
  for (std::size_t i = tries_all() ? 0 : first; i < kinds.size();
       i += tries_all() ? 1 : 3, ++count) {
    const std::string text = std::string(kinds[i].name) + std::string(when);
    attempt(*parse_fault<Kind>(text).fault, text);
  }
  return count;
}

TEST(WorldFaults, OfAChargerAreNotTakenForOthers) {
  const std::size_t count =
      each_fault<charging::FaultKind>(1, "@2min+20s", [](auto fault, const std::string& text) {
        charging::ChargingOptions options;
        options.faults.faults = {fault};
        charging::ChargingNetwork network(options);
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
  try_each<bus::BusNetwork, bus::BusNetworkOptions, bus::FaultKind>(2, "@24min+20s", 27min, 2);
}
TEST(WorldFaults, OfAnExcavatorAreNotTakenForOthers) {
  try_each<excavator::ExcavatorNetwork, excavator::ExcavatorOptions, excavator::FaultKind>(
      0, "@100s+10s", 3min, 2);
}

}  // namespace
}  // namespace canvoy::world_faults_test
