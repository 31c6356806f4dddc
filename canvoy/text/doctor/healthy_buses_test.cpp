// Healthy buses: all worlds, with several seeds, listened to from several moments and for several
// durations, give no alarm.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/text/doctor/doctor.hpp"
#include "canvoy/worlds/bus_line/bus_network.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"
#include "canvoy/worlds/excavator/excavator_network.hpp"
#include "canvoy/worlds/lift/lift_network.hpp"
#include "canvoy/worlds/lift/lift_network_description.hpp"
#include "canvoy/worlds/police/police_network.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"

namespace canvoy::healthy_buses_test {
namespace {

/// A doctor on one bus of a world, from a moment on.
struct Listening {
  Listening(BusIndex at_bus, std::uint32_t bit_rate, Time at_begin, Time at_end)
      : bus(at_bus), begin(at_begin), end(at_end), doctor({.bit_rate = bit_rate}) {
    doctor.begin(begin);
  }
  static void hear(void* context, Time now, ControllerId /*sender*/, const Frame& frame) {
    auto& self = *static_cast<Listening*>(context);
    if (now >= self.begin && now <= self.end) self.doctor.hear(now, frame);
  }

  BusIndex bus;
  Time begin;
  Time end;
  text::Doctor doctor;
};

/// All listeners on one bus, which has room for few taps.
struct Audience {
  static void hear(void* context, Time now, ControllerId sender, const Frame& frame) {
    for (const auto& each : static_cast<Audience*>(context)->all) {
      Listening::hear(each.get(), now, sender, frame);
    }
  }
  std::vector<std::unique_ptr<Listening>> all;
};

constexpr Duration lengths[] = {60s, 20s, 4min, 90s};

/// Listens from the start, and from moments in the middle; returns their number.
template <class Network>
unsigned listen(Network& network, Duration time, unsigned moments, std::string_view world,
                std::uint64_t seed, unsigned buses, std::uint32_t bit_rate) {
  std::vector<Audience> audiences(buses);
  unsigned count = 0;
  unsigned heard = 0;
  for (unsigned bus = 0; bus < buses; ++bus) {
    for (unsigned i = 0; i < moments; ++i) {
      const Time begin(i * (time - 5min) / std::max(1U, moments - 1) + i * 137ms);
      const Time end = begin + lengths[(i + seed) % std::size(lengths)];
      audiences[bus].all.push_back(std::make_unique<Listening>(bus, bit_rate, begin, end));
    }
    audiences[bus].all.push_back(
        std::make_unique<Listening>(bus, bit_rate, Time{}, Time(time)));  // to the whole run
    network.world().bus(bus).observe({.context = &audiences[bus], .on_frame = &Audience::hear});
  }
  network.run_until(Time(time));
  for (const Audience& audience : audiences) {
    for (const auto& each : audience.all) {
      ++count;
      if (each->doctor.observed().traffic.frames() >= 100) ++heard;
      for (const text::Finding& finding : each->doctor.findings(each->end)) {
        const text::FindingRow& row = text::finding_row(finding.kind);
        if (row.severity == text::Severity::note) continue;
        ADD_FAILURE() << world << " seed " << seed << ", bus " << each->bus << ", from "
                      << each->begin.time_since_epoch().count() / 1000 << " ms to "
                      << each->end.time_since_epoch().count() / 1000 << " ms: " << row.name << ": "
                      << finding.what;
      }
    }
  }
  // Cars sleep at times; otherwise there is something to judge.
  EXPECT_GE(heard * 2, count) << world;
  return count;
}

unsigned listen_to_all(std::uint64_t seed, unsigned moments) {
  unsigned count = 0;
  {
    charger::ChargerOptions options;
    options.faults.seed = seed;
    charger::ChargerNetwork network(options);
    count += listen(network, 20min, moments, "charger", seed, 1, options.bit_rate);
  }
  {
    lift::StandardLifts options{.seed = seed};
    lift::LiftNetwork network(lift::standard_lift_network(options));
    count += listen(network, 12min, moments, "lift", seed, 1, lift::lift_bit_rate);
  }
  {
    taxi::TaxiOptions options;
    options.faults.seed = seed;
    options.length = 30min;
    taxi::TaxiNetwork network(options);
    count += listen(network, options.length, moments, "taxi", seed, 1, options.bit_rate);
  }
  {
    police::PoliceOptions options;
    options.faults.seed = seed;
    options.length = 30min;
    police::PoliceNetwork network(options);
    count += listen(network, options.length, moments, "police", seed, 1, options.bit_rate);
  }
  {
    bus_line::BusNetworkOptions options;
    options.faults.seed = seed;
    options.length = 30min;
    bus_line::BusNetwork network(options);
    count += listen(network, options.length, moments, "bus", seed, 1, options.bit_rate);
  }
  {
    excavator::ExcavatorOptions options;
    options.faults.seed = seed;
    options.length = 12min;
    excavator::ExcavatorNetwork network(options);
    count += listen(network, options.length, moments, "excavator", seed, 2, options.bit_rate);
  }
  return count;
}

TEST(HealthyBuses, OfAllWorldsGiveNoAlarm) {
  const std::uint64_t seeds = tries_all() ? 3 : 1;
  const unsigned moments = tries_all() ? 12 : 3;
  unsigned count = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) count += listen_to_all(seed, moments);
  EXPECT_GE(count, tries_all() ? 200U : 18U);
}

}  // namespace
}  // namespace canvoy::healthy_buses_test
