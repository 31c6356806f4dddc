// Real devices in the simulated police car: each is one of ours that the test has put on the bus by
// itself. It is named, supervised, and judged; what depends on it and is not seen is not.
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/devices/cia447/blue_light/blue_light_unit.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"
#include "canvoy/sim/car/real_device_test.hpp"
#include "canvoy/sim/police/police_network.hpp"

namespace canvoy::police::police_real_device_test {
namespace {

/// A patrol in which one device is real. The world has eleven nodes.
class PatrolWith {
 public:
  PatrolWith(NodeId id, std::span<const cia447::CarUnit* const> units)
      : network(options_with(id)),
        device(network.world(), units, {.name = "real", .id = id, .serial_number = 2000U + id},
               device_names.size()) {
    device.offer(Callback<cia447::SwitchedHardware()>::to<&PatrolWith::hardware>(*this));
    device.join();
  }

  std::string broken() const {
    std::string names;
    for (const Invariant& invariant : network.invariants()) {
      if (!invariant.held) names += std::string(invariant_name(invariant.kind).name) + " ";
    }
    return names;
  }
  std::string undecided() const {
    std::string names;
    for (const Invariant& invariant : network.invariants()) {
      if (!invariant.decided) names += std::string(invariant_name(invariant.kind).name) + " ";
    }
    return names;
  }

  PoliceNetwork network;
  car::RealDevice device;
  unsigned lamps_on = 0;  ///< how often one was turned on

 private:
  static PoliceOptions options_with(NodeId id) {
    PoliceOptions options;
    options.length = 150min;
    options.real = {id};
    return options;
  }
  cia447::SwitchedHardware hardware() {
    return {.became =
                Callback<void(const cia447::FieldPlace&, std::uint32_t)>::to<&PatrolWith::became>(
                    *this)};
  }
  void became(const cia447::FieldPlace&, std::uint32_t code) {
    lamps_on += code == static_cast<std::uint32_t>(cia447::Signal::on) ? 1 : 0;
  }
};

TEST(RealPoliceDevice, ABlueLightIsDrivenForAWholePatrol) {
  PatrolWith patrol(blue_light_id, car::units_of<cia447::BlueLightKind>);
  patrol.network.run_until(Time(150min));
  EXPECT_TRUE(patrol.device.node().is_operational());
  EXPECT_GE(patrol.network.calls().size(), 2u);
  EXPECT_GE(patrol.lamps_on, 10 * patrol.network.calls().size()) << "ten lamps for each call";
  EXPECT_EQ(patrol.undecided(), "blue_light display ");
  EXPECT_EQ(patrol.broken(), "");
}

TEST(RealPoliceDevice, OneThatVanishesIsMissingAndOneThatComesBackIsDrivenAnew) {
  PatrolWith patrol(blue_light_id, car::units_of<cia447::BlueLightKind>);
  patrol.network.run_until(Time(12min));  // blue light is on
  patrol.device.vanish();
  patrol.network.run_until(Time(12min + 15s));
  EXPECT_EQ(patrol.broken(), "");
  patrol.lamps_on = 0;
  patrol.device.join();
  patrol.network.run_until(Time(12min + 35s));
  EXPECT_EQ(patrol.broken(), "");
  EXPECT_EQ(patrol.lamps_on, 10u);
  patrol.device.vanish();
  patrol.network.run_until(Time(12min + 57s));  // its last heartbeat holds for 3 s
  EXPECT_EQ(patrol.broken(), "");
  patrol.network.run_until(Time(13min));
  EXPECT_EQ(patrol.broken(), "device_missing ");
}

TEST(RealPoliceDevice, WithARealTerminalTheClientsLockItAndTheCrewCannotReachIt) {
  PatrolWith patrol(terminal_id, car::units_of<cia447::TerminalKind>);
  patrol.network.run_until(Time(30min));
  EXPECT_EQ(patrol.undecided(), "keypad terminal_wait blue_light siren display locks ");
  EXPECT_EQ(patrol.broken(), "");
}

}  // namespace
}  // namespace canvoy::police::police_real_device_test
