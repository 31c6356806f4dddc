// A navigation system at its wire (CiA 447-3, 4.2.11).
#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "canvoy/devices/cia447/gps/gps_unit.hpp"
#include "canvoy/devices/cia447/kit/car_bench_test.hpp"

namespace canvoy::cia447::navigation_unit_test {
namespace {

constexpr NamedPlace places[] = {
    {.position = {48.0, 11.0}, .city = "Mun", .street = "A1", .country = "DE"},
    {.position = {48.1, 11.0}, .city = "Dac", .street = "B2", .country = "DE"},
    {.position = {-33.5, -70.25}, .city = "San", .street = "C3", .country = "CL"}};

// 48.0, 48.1 and 11.0 degrees: 1C9C 3800h, 1CAB 7A40h and 068E 7780h.
constexpr const char* north_48 = "00 38 9C 1C";
constexpr const char* north_48_1 = "40 7A AB 1C";
constexpr const char* east_11 = "80 77 8E 06";

class Navigation : public testing::Test {
 protected:
  Navigation() { guided.clear(); }
  void guide(const GeoPosition* destination) {
    guided.push_back(destination == nullptr ? GeoPosition{} : *destination);
  }
  NavigationHardware hardware() {
    return {.guide = callback<&Navigation::guide>(*this), .gazetteer = Gazetteer(places)};
  }

  std::string ask(const std::string& place) {
    const std::string answer = bench.ask("40 " + place + " 00 00 00 00");
    return answer.size() > 12 ? answer.substr(12) : answer;
  }
  std::string write(const std::string& place, const std::string& four_bytes) {
    return bench.ask_as(2, "23 " + place + " " + four_bytes);
  }
  std::string start(const std::string& code) {
    return bench.ask_as(2, "2F C3 60 03 " + code + " 00 00 00");
  }
  /// The GPS of node 7 (base CAN-ID 480h) or 9 (1A0h) sends PDO 70, the 16th of the list.
  void be_at(const std::string& latitude, const std::string& longitude, unsigned node = 7) {
    bench.cable.send(std::string(node == 7 ? "48F" : "1AF") + "#" + latitude + " " + longitude);
    bench.cable.send("70" + std::to_string(node) + "#05");
    bench.cable.run_for(1s);
  }
  std::string distance_told() { return ask("C0 60 00"); }

  std::vector<GeoPosition> guided;
  NavigationUnit* unit = nullptr;
  CarBench bench{only_unit<NavigationKind>, [this](Environment& environment) {
                   environment.provide(callback<&Navigation::hardware>(*this));
                   environment.watch(unit);
                 }};
};

constexpr const char* no_destination = "FD FF 00 00";

// Places in words.

TEST_F(Navigation, APositionIsDescribed) {
  EXPECT_EQ(ask("C2 60 00"), "03 00 00 00");
  EXPECT_EQ(write("C1 60 01", north_48), "60 C1 60 01 00 00 00 00");
  EXPECT_EQ(write("C1 60 02", east_11), "60 C1 60 02 00 00 00 00");
  EXPECT_EQ(bench.ask("40 C2 60 01 00 00 00 00"), "47 C2 60 01 4D 75 6E 00") << "city: Mun";
  EXPECT_EQ(bench.ask("40 C2 60 02 00 00 00 00"), "4B C2 60 02 41 31 00 00") << "street: A1";
  EXPECT_EQ(bench.ask("40 C2 60 03 00 00 00 00"), "4B C2 60 03 44 45 00 00") << "country: DE";
  write("C1 60 01", north_48_1);
  EXPECT_EQ(bench.ask("40 C2 60 01 00 00 00 00"), "47 C2 60 01 44 61 63 00");
}

TEST_F(Navigation, SouthAndWestAreDescribedToo) {
  // 33.5 south and 70.25 west: 499C 9AC0h and 9529 1EA0h (errata Z36).
  write("C1 60 02", "A0 1E 29 95");
  write("C1 60 01", "C0 9A 9C 49");
  EXPECT_EQ(bench.ask("40 C2 60 03 00 00 00 00"), "4B C2 60 03 43 4C 00 00");
}

TEST_F(Navigation, DoNotCareAsksNothing) {
  write("C1 60 01", north_48);
  write("C1 60 02", east_11);
  EXPECT_EQ(write("C1 60 01", "FF FF FF FF"), "60 C1 60 01 00 00 00 00");
  EXPECT_EQ(bench.ask("40 C2 60 01 00 00 00 00"), "47 C2 60 01 4D 75 6E 00");
  write("C1 60 02", east_11);
  EXPECT_EQ(bench.ask("40 C2 60 01 00 00 00 00"), "47 C2 60 01 4D 75 6E 00")
      << "the latitude is still known";
}

TEST_F(Navigation, ANamelessPositionHasNoNames) {
  write("C1 60 01", north_48);
  write("C1 60 02", east_11);
  write("C1 60 02", "00 00 00 00");
  EXPECT_EQ(unit->destination(), std::nullopt);
  // An empty text is a segmented upload of no bytes.
  EXPECT_EQ(bench.ask("40 C2 60 01 00 00 00 00"), "41 C2 60 01 00 00 00 00");
}

TEST_F(Navigation, PositionsThatAreNowhereAreRefused) {
  // Above 90 degrees south (6B49 D200h), above 180 west (D693 A400h), and FFFF FFFEh: too high.
  EXPECT_EQ(write("C1 60 01", "01 D2 49 6B"), "80 C1 60 01 30 00 09 06");
  EXPECT_EQ(write("C1 60 02", "01 A4 93 D6"), "80 C1 60 02 30 00 09 06");
  EXPECT_EQ(write("C1 60 01", "FE FF FF FF"), "80 C1 60 01 30 00 09 06");
  EXPECT_EQ(write("C3 60 01", "01 D2 49 6B"), "80 C3 60 01 30 00 09 06");
  EXPECT_EQ(write("C3 60 02", "01 A4 93 D6"), "80 C3 60 02 30 00 09 06");
  EXPECT_EQ(write("C1 60 01", "00 D2 49 6B"), "60 C1 60 01 00 00 00 00");
}

TEST_F(Navigation, TheCurrentPositionIsToldWhenItIsAskedFor) {
  EXPECT_EQ(bench.ask("40 C5 60 01 00 00 00 00"), "41 C5 60 01 00 00 00 00");
  be_at(north_48_1, east_11);
  EXPECT_EQ(bench.ask("40 C5 60 01 00 00 00 00"), "41 C5 60 01 00 00 00 00") << "not asked yet";
  bench.ask_as(2, "2F C4 60 00 FF 00 00 00");
  EXPECT_EQ(bench.ask("40 C5 60 01 00 00 00 00"), "41 C5 60 01 00 00 00 00") << "don't care";
  EXPECT_EQ(bench.ask_as(2, "2F C4 60 00 FE 00 00 00"), "60 C4 60 00 00 00 00 00");
  EXPECT_EQ(bench.ask("40 C5 60 01 00 00 00 00"), "47 C5 60 01 44 61 63 00") << "0b asks (Z38)";
  EXPECT_EQ(bench.ask("40 C5 60 02 00 00 00 00"), "4B C5 60 02 42 32 00 00");
  EXPECT_EQ(bench.ask("40 C5 60 03 00 00 00 00"), "4B C5 60 03 44 45 00 00");
  be_at("FF FF FF FF", "FF FF FF FF");
  bench.ask_as(2, "2F C4 60 00 00 00 00 00");
  EXPECT_EQ(bench.ask("40 C5 60 01 00 00 00 00"), "41 C5 60 01 00 00 00 00");
}

// Guidance.

TEST_F(Navigation, WithoutADestinationThereIsNoDistance) {
  EXPECT_EQ(distance_told(), no_destination);
  be_at(north_48, east_11);
  EXPECT_EQ(distance_told(), no_destination);
}

TEST_F(Navigation, GuidanceStartsWithTheThirdSubIndex) {
  be_at(north_48, east_11);
  EXPECT_EQ(write("C3 60 01", north_48_1), "60 C3 60 01 00 00 00 00");
  EXPECT_EQ(write("C3 60 02", east_11), "60 C3 60 02 00 00 00 00");
  EXPECT_EQ(distance_told(), no_destination);
  EXPECT_EQ(start("01"), "60 C3 60 03 00 00 00 00");
  ASSERT_EQ(guided.size(), 1u);
  EXPECT_EQ(guided[0], (GeoPosition{48.1, 11.0}));
  // A tenth of a degree of latitude is 11.12 km: 111 tenths.
  EXPECT_EQ(distance_told(), "6F 00 00 00");
}

TEST_F(Navigation, TheDistanceFollowsTheCar) {
  be_at(north_48, east_11);
  write("C3 60 01", north_48_1);
  write("C3 60 02", east_11);
  start("00");
  // 48.05 degrees: 480 500 000 = 1CA3 D920h.
  be_at("20 D9 A3 1C", east_11);
  EXPECT_EQ(distance_told(), "38 00 00 00") << "5.56 km";
  be_at("FF FF FF FF", "FF FF FF FF");
  EXPECT_EQ(distance_told(), "FF FF 00 00") << "in a tunnel";
  be_at("FE FF FF FF", "FE FF FF FF");
  EXPECT_EQ(distance_told(), "FE FF 00 00") << "the receiver has failed";
  be_at("20 D9 A3 1C", east_11);
  EXPECT_EQ(distance_told(), "38 00 00 00");
}

TEST_F(Navigation, AtTheDestinationGuidanceEnds) {
  be_at(north_48, east_11);
  write("C3 60 01", north_48_1);
  write("C3 60 02", east_11);
  start("01");
  // 56 m before it: 48.0995 degrees is 480 995 000 = 1CAB 66B8h; 44 m: 480 996 000 = 1CAB 6AA0h.
  be_at("B8 66 AB 1C", east_11);
  EXPECT_EQ(distance_told(), "01 00 00 00") << "55.6 m are one tenth of a kilometre";
  be_at("A0 6A AB 1C", east_11);
  EXPECT_EQ(distance_told(), no_destination);
  ASSERT_EQ(guided.size(), 2u);
  EXPECT_EQ(guided[1], GeoPosition{}) << "nothing";
}

TEST_F(Navigation, WithoutInterruptingADestinationWaits) {
  be_at("00 00 00 00", east_11);
  write("C3 60 01", north_48);
  write("C3 60 02", east_11);
  start("00");
  write("C3 60 01", north_48_1);
  EXPECT_EQ(start("00"), "60 C3 60 03 00 00 00 00");
  EXPECT_EQ(unit->destination(), (GeoPosition{48.0, 11.0}));
  EXPECT_EQ(unit->waiting(), (GeoPosition{48.1, 11.0}));
  be_at(north_48, east_11);
  EXPECT_EQ(unit->destination(), (GeoPosition{48.1, 11.0})) << "its turn has come";
  EXPECT_EQ(unit->waiting(), std::nullopt);
  EXPECT_EQ(distance_told(), "6F 00 00 00");
  ASSERT_EQ(guided.size(), 2u);
}

TEST_F(Navigation, WithInterruptingItGoesFirstAndNothingWaits) {
  be_at("00 00 00 00", east_11);
  write("C3 60 01", north_48);
  write("C3 60 02", east_11);
  start("00");
  start("00");
  write("C3 60 01", north_48_1);
  start("01");
  EXPECT_EQ(unit->destination(), (GeoPosition{48.1, 11.0}));
  EXPECT_EQ(unit->waiting(), std::nullopt);
}

TEST_F(Navigation, WithoutCoordinatesNothingStarts) {
  EXPECT_EQ(start("01"), "80 C3 60 03 22 00 00 08");
  write("C3 60 01", north_48);
  EXPECT_EQ(start("01"), "80 C3 60 03 22 00 00 08");
  EXPECT_EQ(start("02"), "80 C3 60 03 30 00 09 06");
  EXPECT_EQ(start("FF"), "60 C3 60 03 00 00 00 00");
  EXPECT_TRUE(guided.empty());
}

TEST_F(Navigation, ItStartsWithoutAPosition) {
  write("C3 60 01", north_48);
  write("C3 60 02", east_11);
  start("01");
  EXPECT_EQ(distance_told(), "FF FF 00 00");
  be_at(north_48_1, east_11);
  EXPECT_EQ(distance_told(), "6F 00 00 00");
}

TEST_F(Navigation, FarAwayIsTheHighestDistance) {
  be_at("C0 9A 9C 49", "A0 1E 29 95");
  unit->select({48, 11});
  EXPECT_EQ(distance_told(), "FC FF 00 00") << "6553.2 km";
}

TEST_F(Navigation, TheDriverChoosesAndCancels) {
  be_at(north_48_1, east_11);
  unit->select({48, 11});
  EXPECT_EQ(distance_told(), "6F 00 00 00");
  unit->cancel();
  EXPECT_EQ(distance_told(), no_destination);
  EXPECT_EQ(guided.size(), 2u);
  unit->cancel();
  EXPECT_EQ(guided.size(), 2u) << "there was nothing to cancel";
}

TEST_F(Navigation, AResetLeadsOn) {
  be_at(north_48_1, east_11);
  unit->select({48, 11});
  bench.cable.send("000#81 05");
  bench.cable.send("000#01 05");
  EXPECT_EQ(distance_told(), "FF FF 00 00") << "the position has to be told again";
  be_at(north_48_1, east_11);
  EXPECT_EQ(distance_told(), "6F 00 00 00");
}

// The sender of the position.

TEST_F(Navigation, AGpsThatFallsSilentMakesThePositionNotAvailable) {
  be_at(north_48_1, east_11);
  unit->select({48, 11});
  bench.cable.run_for(1s);
  EXPECT_EQ(distance_told(), "6F 00 00 00");
  bench.cable.run_for(2s);
  EXPECT_EQ(distance_told(), "FF FF 00 00");
  be_at(north_48_1, east_11, 9);
  EXPECT_EQ(distance_told(), "6F 00 00 00") << "another one will do";
  bench.cable.run_for(3s);
  EXPECT_EQ(distance_told(), "FF FF 00 00");
}

/// The GPS of a car that stands sends nothing by itself. Requests of node 5 to node 7 are on 346h,
/// answers on 2C6h (facts 2.2).
class NavigationRegained : public Navigation {
 protected:
  NavigationRegained() {
    be_at(north_48, east_11);
    unit->select({48, 11});
    unit->select({48.1, 11});
  }
  void answer_both() {
    EXPECT_EQ(bench.cable.last(0x346), "346#40 B0 60 01 00 00 00 00");
    bench.cable.send(std::string("2C6#43 B0 60 01 ") + north_48);
    EXPECT_EQ(bench.cable.last(0x346), "346#40 B0 60 02 00 00 00 00");
    bench.cable.send(std::string("2C6#43 B0 60 02 ") + east_11);
  }
};

TEST_F(NavigationRegained, AGpsThatIsHeardAgainIsAskedWhereTheCarIs) {
  bench.cable.run_for(3s);
  EXPECT_EQ(distance_told(), "FF FF 00 00");
  bench.cable.send("707#7F");
  EXPECT_EQ(bench.cable.count(0x346), 0u) << "it is not at work yet";
  bench.cable.send("707#05");
  answer_both();
  EXPECT_EQ(distance_told(), "6F 00 00 00");
  bench.cable.send("707#05");
  EXPECT_EQ(bench.cable.count(0x346), 0u) << "once is enough";
  bench.cable.run_for(3s);
  EXPECT_EQ(distance_told(), "FF FF 00 00") << "it is watched again";
}

TEST_F(NavigationRegained, AGpsThatDoesNotAnswerIsAskedAgainWhenItIsHeard) {
  bench.cable.run_for(3s);
  bench.cable.send("707#05");
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.cable.last(0x346), "346#80 B0 60 01 00 00 04 05") << "time-out";
  EXPECT_EQ(distance_told(), "FF FF 00 00");
  bench.cable.send("707#05");
  answer_both();
  EXPECT_EQ(distance_told(), "6F 00 00 00");
}

TEST_F(NavigationRegained, APdoThatComesWhileItIsAskedIsNewer) {
  bench.cable.run_for(3s);
  bench.cable.send("707#05");
  bench.cable.send(std::string("48F#") + "20 D9 A3 1C " + east_11);
  bench.cable.send(std::string("2C6#43 B0 60 01 ") + north_48);
  EXPECT_EQ(bench.cable.count(0x346), 1u) << "nothing is left to ask";
  bench.cable.run_for(1s);
  EXPECT_EQ(distance_told(), "38 00 00 00");
}

TEST_F(NavigationRegained, AfterItsOwnResetItAsksTheGpsThatItHad) {
  bench.cable.send("000#81 05");
  bench.cable.send("000#01 05");
  EXPECT_EQ(distance_told(), "FF FF 00 00");
  bench.cable.send("707#05");
  answer_both();
  EXPECT_EQ(distance_told(), "6F 00 00 00");
}

TEST_F(Navigation, AFrameThatIsTooShortIsNoPosition) {
  be_at(north_48_1, east_11);
  unit->select({48, 11});
  bench.cable.send("48F#00 00 00 00");
  bench.cable.run_for(0s);
  EXPECT_EQ(distance_told(), "6F 00 00 00");
}

struct Receiver {
  std::optional<GeoPosition> here = GeoPosition{48, 11};

  std::optional<GeoPosition> position() { return here; }
  double road(const GeoPosition& from, const GeoPosition& to) {
    return metres_between(from, to) * 1.5;
  }
  NavigationHardware hardware() {
    return {.position = callback<&Receiver::position>(*this),
            .road = callback<&Receiver::road>(*this)};
  }
  NavigationUnit* unit = nullptr;
};

TEST(NavigationWithItsOwnReceiver, NeedsNoGpsAndKnowsTheRoads) {
  Receiver receiver;
  CarBench bench(only_unit<NavigationKind>, [&](Environment& environment) {
    environment.provide(callback<&Receiver::hardware>(receiver));
    environment.watch(receiver.unit);
  });
  receiver.unit->select({48.1, 11});
  EXPECT_EQ(bench.ask("40 C0 60 00 00 00 00 00"), "4B C0 60 00 A7 00 00 00") << "16.68 km";
  receiver.here.reset();
  bench.cable.run_for(1s);
  EXPECT_EQ(bench.ask("40 C0 60 00 00 00 00 00"), "4B C0 60 00 FF FF 00 00");
}

struct Antenna {
  GpsReading read() { return {.fix = GpsFix::fix_3d, .latitude = 48.1, .longitude = 11.0}; }
  GpsHardware hardware() { return {.read = callback<&Antenna::read>(*this)}; }
  NavigationUnit* unit = nullptr;
};

TEST(NavigationWithGpsInOneDevice, KnowsThePositionWithoutAFrame) {
  Antenna antenna;
  constexpr const CarUnit* both[] = {&car_unit<GpsKind>, &car_unit<NavigationKind>};
  CarBench bench(both, [&](Environment& environment) {
    environment.provide(callback<&Antenna::hardware>(antenna));
    environment.watch(antenna.unit);
  });
  antenna.unit->select({48, 11});
  EXPECT_EQ(bench.ask("40 C0 60 00 00 00 00 00"), "4B C0 60 00 6F 00 00 00");
}

}  // namespace
}  // namespace canvoy::cia447::navigation_unit_test
