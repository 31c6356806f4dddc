// Identities of the real devices of a car, in its network file.
#include <gtest/gtest.h>

#include <string>

#include "canvoy/tools/play/network_file_test.hpp"

namespace canvoy::tools::car_file_test {
namespace {

std::string rewritten(std::string_view world, const std::string& rest) {
  return rewritten_file(world, "[bus]\nreal = \"can0\"\n" + rest);
}

TEST(CarFile, NamesARealDeviceByItsIdentity) {
  const std::string text = rewritten(
      "taxi", "[printer]\nplayed = false\nvendor = 0x2F0\nproduct = 7\nserial = 4294967295\n");
  EXPECT_NE(text.find("\n[printer]\nplayed = false\nvendor = 752\nproduct = 7\n"
                      "serial = 4294967295\n"),
            std::string::npos)
      << text;
}

TEST(CarFile, WithoutOneItIsWhoeverProvidesTheVirtualDevice) {
  const std::string text = rewritten("police", "[radio]\nplayed = false\n");
  EXPECT_NE(text.find("\n[radio]\nplayed = false\n\n"), std::string::npos) << text;
}

TEST(CarFile, RefusesAnIdentityOfWhoIsPlayed) {
  EXPECT_EQ(rewritten("taxi", "[printer]\nvendor = 1\n"),
            "car.toml line 1: [printer] is played here: vendor, product and serial are those of a "
            "real one, write played = false");
}

TEST(CarFile, RefusesIdentitiesThatOneDeviceMayHave) {
  const std::string two =
      "[terminal]\nplayed = false\nvendor = 1\nproduct = 2\n[printer]\nplayed = false\nvendor = "
      "1\n";
  EXPECT_EQ(rewritten("taxi", two),
            "car.toml line 1: one device may be both [printer] and [terminal]: give each its "
            "serial");
  EXPECT_NE(rewritten("taxi", two + "product = 3\n").find("product = 3\n"), std::string::npos);
}

// -- hands

std::string hands(std::string_view lines) {
  return fmt::format("[[hands]]\n{}", lines);
}

TEST(CarFile, HandsAreWrittenAsTheyWereRead) {
  const std::string text =
      hands("at = \"90s\"\ndevice = \"taximeter\"\npress = \"supplement=2\"\n");
  EXPECT_EQ(rewritten_file("taxi", text), "car.toml line 5: press: it is set: write set =");
  const std::string set = hands("at = \"90s\"\ndevice = \"taximeter\"\nset = \"supplement=2\"\n");
  EXPECT_NE(rewritten_file("taxi", set)
                .find("\n[[hands]]\nat = \"90s\"\ndevice = \"taximeter\"\n"
                      "set = \"supplement=2\""),
            std::string::npos)
      << rewritten_file("taxi", set);
}

TEST(CarFile, RefusesHandsThatNobodyHas) {
  const auto complaint = [](std::string_view lines) {
    return rewritten_file("taxi", hands(lines));
  };
  EXPECT_TRUE(complaint("at = \"1s\"\ndevice = \"printr\"\npress = \"x\"\n")
                  .starts_with("car.toml line 4: device: there is no 'printr'; did you mean"));
  EXPECT_TRUE(complaint("at = \"1s\"\ndevice = \"printer\"\npress = \"hire\"\n")
                  .starts_with("car.toml line 5: press: 'hire@0s': nothing here is 'hire'"));
  EXPECT_EQ(complaint("at = \"1s\"\ndevice = \"printer\"\n"),
            "car.toml line 2: write press = or set =");
  EXPECT_EQ(complaint("at = \"1s\"\ndevice = \"taximeter\"\npress = \"hire@5s\"\n"),
            "car.toml line 5: press: its time is at =");
  EXPECT_EQ(complaint("at = \"1s\"\ndevice = \"ivn-gateway\"\nset = \"speed=5\"\n"),
            "car.toml line 5: set: speed is the car's own, which the run moves");
  EXPECT_TRUE(complaint("at = \"soon\"\ndevice = \"printer\"\nset = \"paper=no\"\n")
                  .starts_with("car.toml line 3: at: 'soon' is no time"));
  EXPECT_EQ(
      rewritten("taxi", "[printer]\nplayed = false\n" + hands("at = \"1s\"\ndevice = \"printer\"\n"
                                                              "set = \"paper=no\"\n")),
      "car.toml line 8: device: it is not played here: its hands are where it is");
}

/// Without paper 60E1h reports it by PDO 72; the driver signs on at 2 min (CiA 447-3, 4.2.13.2).
TEST(CarFile, HandsDoInAWorldWhatTheyDoAtADevice) {
  const std::string events =
      events_of("taxi",
                hands("at = \"0s\"\ndevice = \"taximeter\"\npress = \"hire\"\n") +
                    hands("at = \"1min\"\ndevice = \"taximeter\"\npress = \"sign-on\"\n") +
                    hands("at = \"1min\"\ndevice = \"printer\"\nset = \"paper=no\"\n") +
                    hands("at = \"1min\"\ndevice = \"terminal\"\npress = \"key-1\"\n"),
                Time(61s));
  for (const char* expected :
       {R"({"time":0.0,"event":"hand","node":2,"hand":"hire","refused":"not in this state"})",
        R"({"time":60.0,"event":"hand","node":2,"hand":"sign-on"})",
        R"({"time":60.0,"event":"meter","state":"for hire"})",
        R"({"time":60.0,"event":"hand","node":3,"hand":"paper=no"})",
        R"({"time":60.0,"event":"hand","node":6,"hand":"key-1"})",
        R"({"time":60.3,"event":"hand","node":6,"hand":"key-1=released"})"}) {
    EXPECT_NE(events.find(expected), std::string::npos) << expected << "\n" << events;
  }
}

/// 6069h is 04h: automatic extinguishing has started (CiA 447-3, 4.2.5.1).
TEST(CarFile, FireExtinguishingRidesInAnArmouredCarAlone) {
  const std::string fire = hands(
      "at = \"1min\"\ndevice = \"fire-extinguishing\"\n"
      "set = \"fire-extinguishing-system=automatic-started\"\n");
  EXPECT_NE(events_of("police", "armoured = true\n" + fire, Time(61s))
                .find(R"({"time":60.0,"event":"hand","node":12,)"),
            std::string::npos);
  EXPECT_TRUE(rewritten_file("police", fire)
                  .starts_with("car.toml line 4: device: there is no 'fire-extinguishing'"));
  EXPECT_EQ(rewritten("police", "[emergency-fresh-air]\nplayed = false\n"),
            "car.toml line 1: [emergency-fresh-air] rides in an armoured car: write armoured = "
            "true");
}

// -- holidays

TEST(CarFile, HolidaysAreDaysOfEachYearOrOfOne) {
  EXPECT_NE(rewritten_file("taxi", "holidays = [\"12-25\", \"2026-04-03\", \"02-29\"]\n")
                .find("\nholidays = [\"12-25\", \"2026-04-03\", \"02-29\"]"),
            std::string::npos);
  for (const char* day : {"13-01", "02-30", "2026-02-29", "1-1", "12.25", "0000-01-01", "12-25 "}) {
    EXPECT_EQ(rewritten_file("taxi", fmt::format("holidays = [\"{}\"]\n", day)),
              fmt::format("car.toml line 2: holidays: \"{}\" is no day as \"12-25\" or "
                          "\"2026-04-03\"",
                          day));
  }
}

constexpr const char* on_holidays =
    "[[tariff]]\nlevel = \"1\"\ninitial_fare = 4\n[[tariff]]\nlevel = \"H\"\n"
    "initial_fare = 9\n[[tariff_hours]]\nlevel = \"H\"\ndays = [\"holidays\"]\n";

TEST(CarFile, HoursOfHolidaysWithoutAnyAreRefused) {
  EXPECT_EQ(rewritten_file("taxi", std::string("holidays = []\n") + on_holidays),
            "car.toml line 2: holidays: [[tariff_hours]] has hours of holidays alone, and there "
            "are none");
}

/// 23 November 2026 is a Monday.
TEST(CarFile, OnAHolidayItsLevelHolds) {
  const std::string shift =
      "for = \"40min\"\nbegin = 2026-11-23T10:00:00\n{}\n[shift]\nwaiting_max = \"1min\"\n"
      "trip_max_m = 2000\n";
  const std::string usual =
      events_of("taxi", fmt::format(fmt::runtime(shift), "") + on_holidays, Time(20min));
  EXPECT_NE(usual.find(R"("event":"tariff","level":"1")"), std::string::npos) << usual;
  EXPECT_EQ(usual.find(R"("event":"tariff","level":"H")"), std::string::npos) << usual;
  const std::string feast =
      events_of("taxi", fmt::format(fmt::runtime(shift), "holidays = [\"11-23\"]") + on_holidays,
                Time(20min));
  EXPECT_NE(feast.find(R"("event":"tariff","level":"H")"), std::string::npos) << feast;
}

// -- identities

TEST(CarFile, AGatewayIsNamedByNobody) {
  EXPECT_TRUE(rewritten("taxi", "[ivn-gateway]\nplayed = false\nvendor = 1\n")
                  .starts_with("car.toml line 6: vendor: is not known here; there are played"));
  EXPECT_EQ(rewritten("taxi",
                      "[ivn-gateway]\nplayed = false\n[printer]\nplayed = false\n"
                      "vendor = 1\n"),
            "car.toml line 1: [ivn-gateway] is real, and gives node-IDs by itself: vendor, product "
            "and serial are for the one that is played");
}

}  // namespace
}  // namespace canvoy::tools::car_file_test
