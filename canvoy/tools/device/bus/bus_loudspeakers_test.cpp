// Announcements in a bus, and their notation.
#include "canvoy/tools/device/bus/bus_loudspeakers.hpp"

#include <gtest/gtest.h>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools::bus_loudspeakers_test {
namespace {

struct Heard {
  bool is_known = false;
  std::string text{};
};

Heard announced(const StopAnnouncements& announcements, std::uint32_t stop, std::string_view text) {
  const DeviceOutput output;
  BusLoudspeakers loudspeakers(announcements, output);
  Environment environment;
  loudspeakers.join(environment);
  testing::internal::CaptureStdout();
  const bool is_known = environment.get<cia407::AcousticAnnouncerHardware>().announce(stop, text);
  return {is_known, testing::internal::GetCapturedStdout()};
}

TEST(BusLoudspeakers, SayAnyStopWhereNoneIsGiven) {
  const Heard named = announced({}, 17, "Town Hall");
  EXPECT_TRUE(named.is_known);
  EXPECT_EQ(named.text, "acoustic-announcer: stop 17, Town Hall\n");
  EXPECT_EQ(announced({}, 17, "").text, "acoustic-announcer: stop 17\n");
}

TEST(BusLoudspeakers, SayThoseAloneThatAreGiven) {
  const StopAnnouncements one = {{17, "Town Hall"}};
  EXPECT_EQ(announced(one, 17, "Rathaus").text, "acoustic-announcer: stop 17, Town Hall\n");
  const Heard other = announced(one, 18, "Airport");
  EXPECT_FALSE(other.is_known);
  EXPECT_EQ(other.text, "acoustic-announcer: nothing to say of stop 18\n");
}

TEST(BusLoudspeakers, AreSwitchedAsIsWanted) {
  const DeviceOutput output;
  BusLoudspeakers loudspeakers({}, output);
  Environment environment;
  loudspeakers.join(environment);
  const auto manager = environment.get<cia407::AcousticControlManagerHardware>();
  constexpr cia407::AudioPaths two = {.driver_to_outdoor = true, .radio_to_indoor = true};
  testing::internal::CaptureStdout();
  EXPECT_EQ(manager.switch_paths(two), two);
  EXPECT_EQ(manager.switch_paths({}), cia407::AudioPaths{});
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "acoustic-control-manager: switched: driver to outdoor, radio to indoor\n"
            "acoustic-control-manager: nothing is switched\n");
}

TEST(StopAnnouncements, AreAStopPointAndWhatIsSaidOfIt) {
  const StopAnnouncements known = {{17, "Town Hall"}, {4294967295, "a=b"}};
  EXPECT_EQ(parse_announcements({"17=Town Hall", "4294967295=a=b"}), known);
  EXPECT_EQ(parse_announcements({}), StopAnnouncements{});
}

TEST(StopAnnouncements, WhatIsNoneIsRefused) {
  for (const char* const text :
       {"", "17", "17=", "=Town Hall", "0=Town Hall", "17a=Town Hall", "4294967296=Town Hall"}) {
    EXPECT_THROW(parse_announcements({text}), UsageError) << text;
  }
}

}  // namespace
}  // namespace canvoy::tools::bus_loudspeakers_test
