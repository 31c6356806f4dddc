// Real devices in the simulated police car: each is a simulated device that the test puts on the
// bus. It gets a node-ID, and is supervised and judged; what depends on it and cannot be seen is
// not judged.
#include <gtest/gtest.h>

#include <ostream>
#include <span>
#include <string>

#include "canvoy/worlds/car/real_device_test.hpp"
#include "canvoy/worlds/police/police_network.hpp"

namespace canvoy::police::police_real_device_test {
namespace {

/// A patrol in which one device is real. The world has eleven nodes.
class PatrolWith {
 public:
  PatrolWith(NodeId id, std::span<const cia447::CarUnit* const> units, std::uint32_t vendor = 0)
      : network(options_with(id)),
        device(network.world(), units,
               {.name = "real",
                .id = id,
                .serial_number = 2000U + id,
                .is_named_by_lss = id != cia447::gateway_node_id,
                .vendor_id = vendor},
               device_names.size()) {
    device.provide(callback<&PatrolWith::hardware>(*this));
    device.join();
  }

  std::string broken() const { return broken_names(network); }
  std::string undecided() const { return car::undecided_names(network); }

  PoliceNetwork network;
  car::RealDevice device;
  unsigned lamps_on = 0;  ///< number of times that one was switched on

 private:
  static PoliceOptions options_with(NodeId id) {
    PoliceOptions options;
    options.length = 150min;
    options.real = {id};
    return options;
  }
  cia447::SwitchedHardware hardware() { return {.became = callback<&PatrolWith::became>(*this)}; }
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
  EXPECT_EQ(patrol.undecided(), "blue_light siren_alone display ");
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
  EXPECT_EQ(patrol.undecided(),
            "keypad terminal_wait blue_light siren siren_alone work_light display locks silence "
            "emergency ");
  EXPECT_EQ(patrol.broken(), "");
}

/// Each device in turn, with the invariants that cannot be judged then.
struct RealPoliceCase {
  NodeId id;
  std::span<const cia447::CarUnit* const> units;
  const char* undecided;
};
std::ostream& operator<<(std::ostream& out, const RealPoliceCase& it) {
  return out << "node " << unsigned{it.id};
}
const RealPoliceCase real_police_cases[] = {
    {cia447::gateway_node_id, car::units_of<cia447::IvnGatewayKind>,
     "speech carrier locks power silence "},
    {terminal_id, car::units_of<cia447::TerminalKind>,
     "keypad terminal_wait blue_light siren siren_alone work_light display locks silence "
     "emergency "},
    {roof_light_id, car::units_of<cia447::RoofBarLightKind>,
     "blue_light siren_alone work_light display "},
    {roof_sound_id, car::units_of<cia447::RoofBarSoundKind>,
     "terminal_wait blue_light siren siren_alone work_light display locks "},
    {blue_light_id, car::units_of<cia447::BlueLightKind>, "blue_light siren_alone display "},
    {radio_id, car::units_of<cia447::RadioKind>, "terminal_wait speech carrier emergency "},
    {audio_switch_id, car::units_of<cia447::AudioSwitchKind>, "speech carrier "},
    {hands_free_id, car::units_of<cia447::HandsFreeKind>, "speech carrier "},
    {power_supply_id, car::units_of<cia447::PowerSupplyKind>, "speech carrier power emergency "},
    {inputs_id, car::units_of<cia447::DiscreteInputsKind>, "speech carrier "},
    {navigation_id, car::units_of<cia447::GpsKind, cia447::NavigationKind>, "terminal_wait "},
};

class EachRealPoliceDevice : public testing::TestWithParam<RealPoliceCase> {};

TEST_P(EachRealPoliceDevice, HasItsPlaceAndIsSupervised) {
  PatrolWith patrol(GetParam().id, GetParam().units);
  car::expect_supervision(patrol.network, patrol.device, Time(12min), Time(15min));
  // The car has not slept yet; and a real gateway commands it.
  const std::string of_sleep = "silence ";
  std::string undecided = GetParam().undecided;
  const std::size_t behind = std::min(undecided.find("emergency "), undecided.size());
  if (undecided.find(of_sleep) == std::string::npos) undecided.insert(behind, of_sleep);
  EXPECT_EQ(patrol.undecided(), undecided);
  EXPECT_GE(patrol.network.calls().size(), 1u);
}

TEST_P(EachRealPoliceDevice, OneThatNeverComesIsMissing) {
  PoliceOptions options;
  options.real = {GetParam().id};
  PoliceNetwork network(options);
  network.run_until(Time(79s));  // a minute to come, and 20 s like each device that is lost
  EXPECT_EQ(broken_names(network), "");
  network.run_until(Time(81s));
  EXPECT_EQ(broken_names(network), "device_missing ");
}

TEST_P(EachRealPoliceDevice, OneThatVanishesAsSoonAsAllHaveStartedIsMissing) {
  PatrolWith patrol(GetParam().id, GetParam().units);
  car::expect_early_loss_is_told(patrol.network, patrol.device);
}

/// All that is known of it is the virtual device that it provides.
TEST_P(EachRealPoliceDevice, OneOfAnotherMakerHasItAsWell) {
  if (GetParam().id == cia447::gateway_node_id) return;
  constexpr std::uint32_t other_maker = 0x2F0;
  PatrolWith patrol(GetParam().id, GetParam().units, other_maker);
  car::expect_supervision(patrol.network, patrol.device, Time(8min), Time(12min));
}

INSTANTIATE_TEST_SUITE_P(Nodes, EachRealPoliceDevice, testing::ValuesIn(real_police_cases));

TEST(RealPoliceDevice, AllPlacesAreTried) {
  ASSERT_EQ(std::size(real_police_cases), device_names.size());
  for (NodeId id = 1; id <= device_names.size(); ++id) EXPECT_EQ(real_police_cases[id - 1].id, id);
}

}  // namespace
}  // namespace canvoy::police::police_real_device_test
