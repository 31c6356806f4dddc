// A mapping record is read when it is set, and for none of the frames of a world, whatever limits,
// hooks and watchers the values of its devices have.
#include <gtest/gtest.h>

#include "canvoy/worlds/bus_line/bus_network.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/police/police_network.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::mapping_reads_test {
namespace {

/// From `begin`, when all nodes are configured and operational, for a minute.
template <class Network>
void expect_no_reads(Network&& network, Time begin = Time(1min)) {
  network.run_until(begin);
  const std::uint64_t reads = network.world().mapping_reads();
  const std::uint64_t frames = network.world().bus().statistics().frames;
  ASSERT_GT(reads, 0U);
  network.run_until(begin + 1min);
  EXPECT_GT(network.world().bus().statistics().frames, frames);
  EXPECT_EQ(network.world().mapping_reads(), reads);
}

TEST(MappingReads, OfALiftEndWithItsConfiguration) {
  expect_no_reads(lift::LiftNetwork(lift::standard_lift_network({})));
}

TEST(MappingReads, OfAChargerEndWithItsConfiguration) {
  expect_no_reads(charger::ChargerNetwork());
}

TEST(MappingReads, OfATaxiEndWithItsConfiguration) {
  expect_no_reads(taxi::TaxiNetwork(taxi::TaxiOptions()));
}

TEST(MappingReads, OfAPoliceCarEndWithItsConfiguration) {
  expect_no_reads(police::PoliceNetwork(police::PoliceOptions()));
}

TEST(MappingReads, OfABusEndWithItsConfiguration) {
  expect_no_reads(bus_line::BusNetwork(bus_line::BusNetworkOptions()));
}

TEST(MappingReads, OfAnExcavatorEndWithItsConfiguration) {
  expect_no_reads(excavator::ExcavatorNetwork(excavator::ExcavatorOptions()));
}

}  // namespace
}  // namespace canvoy::mapping_reads_test
