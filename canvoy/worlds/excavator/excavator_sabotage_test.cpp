// Complaints of an operator of an excavator, and the invariant that each breaks: alone, and beside
// a module that reboots every three minutes, which excuses none of it.
#include <gmock/gmock.h>

#include <ostream>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/canopen/testing/wire.hpp"
#include "canvoy/worlds/excavator/excavator_network_test.hpp"

namespace canvoy::excavator::excavator_sabotage_test {
namespace {

constexpr Time trouble_at{3min};

/// A foreign device sends all of these, each `period` from trouble_at on.
struct Sabotage {
  const char* what = nullptr;
  std::string_view breaks;
  std::vector<std::string_view> says = {};
  Duration period = 50ms;
  std::vector<ScheduledFault> faults = {};
  bool pierces_bucket = false;  ///< from trouble_at on

  /// The run goes on for this time after trouble_at: 150 s without earth is too long, and a restart
  /// excuses a minute.
  Duration lasts() const { return breaks == "service" ? 5min : 110s; }
};
void PrintTo(const Sabotage& sabotage, std::ostream* out) {
  *out << sabotage.what;
}

/// Several faults, one after the other, so that some of them meet a moving machine.
std::vector<ScheduledFault> losses_of(NodeId node) {
  std::vector<ScheduledFault> all;
  for (int i = 0; i < 4; ++i) {
    all.push_back({.kind = FaultKind::lost_node,
                   .start = trouble_at + 10s + i * Duration(23s),
                   .duration = 8s,
                   .node = node});
  }
  return all;
}

// Node-IDs: host 1, seat 10 (0Ah), valves 33 (21h). PDOs are those of host_objects.hpp; values of
// CiA 401: 6200h, 6411h and 6401h, of CiA 852: 6000h (memory and buttons), 6401h (axes).
const Sabotage sabotages[] = {
    // It moves.
    {"a stranger opens the valves of boom, stick, bucket and slew",
     "unwanted_motion",
     {"321#00 40 00 40 00 40 00 40"},
     10ms},
    {"a stranger opens the valves of the tracks",
     "unwanted_motion",
     {"421#00 40 00 40 00 40 00 00"},
     10ms},
    {"a stranger says that a joystick is pushed",
     "unwanted_motion",
     {"18A#00 50 00 50 00 00 00 A0"},
     10ms},
    {"a stranger says that the pedals are pressed",
     "unwanted_motion",
     {"38A#00 00 50 00 00 50"},
     10ms},
    {"a stranger writes the valves by SDO",
     "unwanted_motion",
     {"621#2B 11 64 05 00 40 00 00", "621#2B 11 64 06 00 40 00 00"},
     10ms},
    {"a stranger lives for a dead host",
     "unwanted_motion",
     {"701#05", "321#00 40 00 40 00 40 00 40", "421#00 40 00 40 00 40 00 00",
      "221#10 00 00 00 00 00 00 00"},
     50ms,
     losses_of(host_id)},
    {"a stranger makes the valves trust",
     "lost_host",
     {"621#23 16 10 01 00 00 00 00", "621#2B 00 14 05 00 00 00 00", "621#2B 01 14 05 00 00 00 00",
      "621#2B 02 14 05 00 00 00 00"},
     50ms,
     losses_of(host_id)},
    // It does not work.
    {"a stranger stops the host", "service", {"000#02 01"}},
    {"a stranger stops the seat", "service", {"000#02 0A"}},
    {"a stranger stops the valves", "service", {"000#02 21"}},
    {"a stranger makes the valves pre-operational", "service", {"000#80 21"}},
    {"a stranger resets the host each 2 s", "service", {"000#81 01"}, 2s},
    {"a stranger resets the seat each 2 s", "service", {"000#82 0A"}, 2s},
    {"a stranger takes the heartbeat of the valves away",
     "service",
     {"621#2B 17 10 00 00 00 00 00"}},
    {"a stranger takes the left joystick away", "axis_delta", {"60A#23 00 18 01 8A 01 00 80"}},
    {"a stranger takes the right joystick away", "service", {"60A#23 04 18 01 8A 02 00 80"}},
    {"a stranger closes the valves",
     "service",
     {"321#00 00 00 00 00 00 00 00", "221#00 00 00 00 00 00 00 00"},
     2ms},
    // Its lamps, its display and its buttons are wrong.
    {"a stranger lights all lamps", "indicators", {"20A#FF FF FF FF FF FF FF FF"}},
    {"a stranger puts all lamps out", "indicators", {"20A#00 00 00 00 00 00 00 00"}},
    {"a stranger writes the display", "display", {"30A#39 30 39 30 39 30 39 30"}},
    {"a stranger writes the rest of the display", "display", {"40A#39 30 39 30 39 30 39 30"}},
    {"a stranger says another fuel level and pressure", "display", {"3A1#00 00 00 00 00 00 00 00"}},
    {"a stranger says other angles", "display", {"2A1#00 00 00 00 00 00 00 00"}},
    {"a stranger presses buttons", "presses", {"48A#FF", "48A#00"}},
    {"a stranger coarsens the joysticks",
     "axis_delta",
     {"60A#23 26 64 01 88 13 00 00", "60A#23 26 64 02 88 13 00 00"},
     1s},
    {"a stranger turns the wheel of the throttle", "throttle", {"18B#FF 7F 00 00"}, 20ms},
    {"a stranger lets the engine idle", "throttle", {"621#2B 11 64 08 00 00 00 00"}, 10ms},
    {"a stranger turns the rotator", "unwanted_motion", {"18B#00 00 FF 7F"}, 20ms},
    {"a stranger shifts the valve of the boom",
     "unwanted_motion",
     {"621#23 46 64 01 00 20 00 00"},
     1s},
    {"a stranger turns the knob", "display", {"28B#05 00 00 00"}, 100ms},
    {"a stranger turns the outputs round", "presses", {"621#2F 02 62 01 FF 00 00 00"}, 1s},
    {"a stranger turns the lamps round", "indicators", {"60A#2F 02 62 01 FF 00 00 00"}, 1s},
    {.what = "the bucket has a hole", .breaks = "spilled", .pierces_bucket = true},
    {"a stranger takes the valves from the network", "device_missing", {"000#02 21"}},
    {"a stranger takes the seat from the network", "device_missing", {"000#02 0A"}},
};

/// With or without another device that reboots from time to time.
using Case = std::tuple<Sabotage, bool>;

class ExcavatorSabotageTable : public testing::TestWithParam<Case> {};

TEST_P(ExcavatorSabotageTable, BreaksWhatItIsAbout) {
  const auto& [sabotage, is_beside] = GetParam();
  ExcavatorOptions options{.length = trouble_at.time_since_epoch() + sabotage.lasts()};
  options.faults.faults = sabotage.faults;
  for (Time at{90s}; is_beside && at < Time(options.length); at += 3min) {
    options.faults.faults.push_back({.kind = FaultKind::restart, .start = at, .node = valves_id});
  }
  ExcavatorNetwork network(options);
  if (sabotage.pierces_bucket) {
    network.world().at(trouble_at, [&](Time) { network.machine().pierce_bucket(); });
  }
  const ControllerId stranger = network.world().bus(0).attach({});
  for (Time now = trouble_at; now <= Time(options.length); now += sabotage.period) {
    network.world().at(now, [&](Time) {
      for (const std::string_view frame : sabotage.says) {
        network.world().bus(0).send(stranger, wire_frame(frame));
      }
    });
  }
  network.run_until(Time(options.length));
  EXPECT_THAT(broken(network), testing::Contains(sabotage.breaks));
}

// Alone in a full run only: what breaks beside an excuse also breaks without it.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Sabotage& sabotage : sabotages) {
    all.emplace_back(sabotage, true);
    if (tries_all()) all.emplace_back(sabotage, false);
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, ExcavatorSabotageTable, testing::ValuesIn(cases()));

}  // namespace
}  // namespace canvoy::excavator::excavator_sabotage_test
