// Tachograph, positioning, time fixing, gateways, driver's devices and generic I/O at their wire.
#include <gtest/gtest.h>

#include "canvoy/devices/cia407/by_code/code_only_unit.hpp"
#include "canvoy/devices/cia407/console/driver_indicator_unit.hpp"
#include "canvoy/devices/cia407/console/keyboard_unit.hpp"
#include "canvoy/devices/cia407/gateway/train_bus_gateway_unit.hpp"
#include "canvoy/devices/cia407/gateway/vehicle_gateway_unit.hpp"
#include "canvoy/devices/cia407/generic_io/generic_io_unit.hpp"
#include "canvoy/devices/cia407/kit/bus_bench_test.hpp"
#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"
#include "canvoy/devices/cia407/positioning/positioning_unit.hpp"
#include "canvoy/devices/cia407/positioning/time_fixing_unit.hpp"
#include "canvoy/devices/cia407/tachograph/tachograph_unit.hpp"
#include "canvoy/devices/cia447/gps/nmea.hpp"

namespace canvoy::cia407::vehicle_units_test {
namespace {

/// One device with what the test offers as its hardware.
template <class Kind>
struct Bench {
  typename Kind::Hardware hardware;
  typename Kind::Unit* unit = nullptr;
  BusSegment segment;

  typename Kind::Hardware get() { return hardware; }
  BusSegment get_segment() { return segment; }
  void made(typename Kind::Unit& of, Node& /*node*/) { unit = &of; }

  static constexpr const BusUnit* units[] = {&bus_unit<Kind>};
  BusBench bench;

  explicit Bench(const typename Kind::Hardware& with, const BusSegment& in = {})
      : hardware(with), segment(in), bench(units, [this](Environment& environment) {
          environment.provide(callback<&Bench::get>(*this));
          environment.provide(callback<&Bench::get_segment>(*this));
          environment.watch(callback<&Bench::made>(*this));
        }) {}
  std::string ask(const std::string& place) {
    return bench.ask("40 " + place + " 00 00 00 00").substr(12);
  }
};

TEST(Tachograph, TellsSpeedDistanceAndDrivers) {
  TachographReading reading = {.speed_kmh = 50,
                               .direction = Direction::forward,
                               .distance_metres = 1000,
                               .cards = {"D  1234567890123456", ""}};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  EXPECT_EQ(bench.ask("20 65 00"), "00 32 00 00") << "50 x 256";
  EXPECT_EQ(bench.ask("21 65 00"), "00 00 00 00") << "motion is not yet recognized";
  bench.bench.cable.run_for(4900ms);
  EXPECT_EQ(bench.ask("21 65 00"), "00 00 00 00");
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("21 65 00"), "10 00 00 00") << "after 5 s it is";
  reading.speed_kmh = 0;
  reading.direction = Direction::reverse;
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("21 65 00"), "40 00 00 00");
  EXPECT_EQ(bench.ask("22 65 01"), "C8 00 00 00") << "1000 m in steps of 5";
  EXPECT_EQ(bench.bench.upload(0x6524, 1), "D  1234567890123456");
  reading.speed_kmh = std::nullopt;
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("20 65 00"), "FF FF 00 00");
  EXPECT_EQ(bench.ask("21 65 00"), "70 00 00 00");
}

TEST(Tachograph, AnApplicationHearsWhatIsToldThoughNoVirtualDeviceDoes) {
  TachographReading reading = {.speed_kmh = 50};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  unsigned told = 0;
  const auto watch =
      bench.bench.device().virtual_device(1).on(tachograph_speed, [&](auto) { ++told; });
  bench.bench.cable.run_for(100ms);
  EXPECT_GE(told, 1U);
}

TEST(Tachograph, AnEventBeginsATripAnewAndMovesTheLocalTime) {
  TachographReading reading = {.distance_metres = 5000};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  EXPECT_EQ(bench.ask("22 65 02"), "E8 03 00 00");
  EXPECT_EQ(bench.bench.ask("23 02 60 01 01 00 00 0C"), "60 02 60 01 00 00 00 00");
  EXPECT_EQ(bench.ask("22 65 02"), "00 00 00 00");
  EXPECT_EQ(bench.ask("22 65 01"), "E8 03 00 00");
  bench.bench.ask("23 02 60 01 02 FF 00 0C");
  EXPECT_EQ(bench.ask("23 65 01"), "FF 00 00 00") << "an hour behind";
  bench.bench.ask("23 02 60 01 04 00 1E 0C");
  EXPECT_EQ(bench.ask("23 65 02"), "1E 00 00 00");
  EXPECT_EQ(bench.ask("23 65 01"), "FF 00 00 00") << "the hour stays";
  EXPECT_EQ(bench.bench.ask("23 02 60 01 02 18 00 0C"), "80 02 60 01 30 00 09 06") << "24 h";
}

TEST(Tachograph, AnEventThatIsStillPendingBeginsNoOtherTrip) {
  TachographReading reading = {.distance_metres = 5000};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  bench.bench.ask("23 02 60 01 01 00 00 0C");
  reading.distance_metres = 6000;
  bench.bench.cable.run_for(1s);
  bench.bench.ask("23 02 60 01 01 00 00 0C");
  EXPECT_EQ(bench.ask("22 65 02"), "C8 00 00 00") << "1 km, in 5 m";
  bench.bench.ask("23 02 60 01 00 00 00 00");
  bench.bench.ask("23 02 60 01 01 00 00 0C");
  EXPECT_EQ(bench.ask("22 65 02"), "00 00 00 00");
}

TEST(Tachograph, CountsDrivingUntilABreak) {
  TachographReading reading = {.speed_kmh = 30, .cards = {"D  1234567890123456", ""}};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  bench.bench.cable.run_for(10min + 6s);
  EXPECT_EQ(bench.ask("25 65 01"), "0A 00 00 00");
  reading.speed_kmh = 0;
  bench.bench.cable.run_for(44min);
  EXPECT_EQ(bench.ask("25 65 01"), "0A 00 00 00");
  bench.bench.cable.run_for(1min + 1s);
  EXPECT_EQ(bench.ask("25 65 01"), "00 00 00 00");
}

/// The time is that of a driver, identified by the card (9.2.17.5, 9.2.17.6).
TEST(Tachograph, AnotherDriverBeginsAnew) {
  TachographReading reading = {.speed_kmh = 30, .cards = {"D  1234567890123456", ""}};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  bench.bench.cable.run_for(10min + 6s);
  EXPECT_EQ(bench.ask("25 65 01"), "0A 00 00 00");
  reading.cards[0] = "D  1234567890123457";
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("25 65 01"), "00 00 00 00");
  bench.bench.cable.run_for(2min);
  EXPECT_EQ(bench.ask("25 65 01"), "02 00 00 00");
  reading.cards[0] = "";
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.ask("25 65 01"), "00 00 00 00");
}

TEST(Tachograph, ItsSpeedIsPositiveBackwardAsWell) {
  TachographReading reading = {.speed_kmh = -5, .direction = Direction::reverse};
  Bench<TachographKind> bench(
      {.read = {[](void* of) { return *static_cast<TachographReading*>(of); }, &reading}});
  EXPECT_EQ(bench.ask("20 65 00"), "00 05 00 00") << "9.2.17.1";
  bench.bench.cable.run_for(5s);
  EXPECT_EQ(bench.ask("21 65 00"), "50 00 00 00") << "motion, reverse";
}

TEST(Positioning, TellsWhatAReceiverSays) {
  cia447::NmeaReceiver nmea;
  Bench<PositioningKind> bench({.read = callback<&cia447::NmeaReceiver::reading>(nmea)});
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#02 FF 01 01 00 00 00 00") << "no signal";
  EXPECT_EQ(bench.ask("60 66 01"), "FF FF FF FF");
  nmea.receive("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,,*11\r\n");
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#00 00 00 00 00 00 00 00");
  // (48.1173 + 210) x 10^7 = 2,581,173,000 = 99D99308h; 221.5166667 x 10^7 = 8408C2CBh.
  EXPECT_EQ(bench.ask("60 66 01"), "08 93 D9 99");
  EXPECT_EQ(bench.ask("60 66 02"), "CB C2 08 84");
  EXPECT_EQ(bench.ask("62 66 00"), "73 00 00 00") << "22.4 knots are 11.5 m/s";
  EXPECT_EQ(bench.ask("63 66 00"), "33 2A 00 00") << "84.4 x 128";
  EXPECT_EQ(bench.ask("61 66 00"), "FF 00 00 00") << "nobody said how exact";
  bench.bench.cable.run_for(99s);
  EXPECT_EQ(bench.ask("64 66 00"), "E6 00 00 00") << "100 s at 11.52 m/s are 1152 m";
  nmea.forget();
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.ask("60 66 01"), "FF FF FF FF");
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#02 FF 01 01 00 00 00 00");
}

/// 9.2.21.5: moved metres, however long the node's clock has been running.
TEST(Positioning, CountsMileageFromItsFirstLookOn) {
  cia447::NmeaReceiver nmea;
  nmea.receive("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,,*11\r\n");
  const auto read = Callback<cia447::GpsReading()>::to<&cia447::NmeaReceiver::reading>(nmea);
  auto hardware = [&read] { return PositioningHardware{.read = read}; };
  static constexpr const BusUnit* units[] = {&bus_unit<PositioningKind>};
  Environment environment;
  environment.provide(Callback<PositioningHardware()>::of(hardware));
  Cable cable;
  cable.now = Time(10h);
  BusDevice device(units, cable.port(0), 5, environment);
  cable.connect(0, device.node());
  cable.start_all();
  cable.send("605#40 64 66 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x585), "585#43 64 66 00 00 00 00 00");
  cable.run_for(100s);
  cable.send("605#40 64 66 00 00 00 00 00");
  EXPECT_EQ(cable.last(0x585), "585#43 64 66 00 E6 00 00 00") << "1152 m";
}

/// Values of a device that is put together when the program runs, by handle.
TEST(BusDevice, GivesItsValuesByHandleAndSaysWhichItHasNot) {
  static constexpr const BusUnit* units[] = {&bus_unit<PositioningKind>};
  Environment environment;
  Cable cable;
  BusDevice device(units, cable.port(0), 5, environment);
  EXPECT_EQ(device.missing().rule, "");
  EXPECT_EQ(device.find(gps_mileage), AbortCode::none);
  EXPECT_EQ(device.find(incoming_passengers_of_door), AbortCode::no_object);
  EXPECT_EQ(device.set(incoming_passengers_of_door, 5), AbortCode::no_object);
}

TEST(TimeFixing, TellsUtcAndSaysWhenItHasNone) {
  std::optional<CivilTime> utc;
  Bench<TimeFixingKind> bench(
      {.utc = {[](void* of) { return *static_cast<std::optional<CivilTime>*>(of); }, &utc}});
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#02 FF 01 01 00 00 00 00");
  utc = CivilTime{.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 5, .second = 30};
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#00 00 29 5C 0B 08 05 78");
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#00 00 00 00 00 00 00 00");
}

/// Seconds are 0 to 59.75, and the signal also exists in a leap second (9.2.22.1).
TEST(TimeFixing, ALeapSecondIsTheSecondBeforeIt) {
  std::optional<CivilTime> utc =
      CivilTime{.year = 2026, .month = 12, .day = 31, .hour = 23, .minute = 59, .second = 58};
  Bench<TimeFixingKind> bench(
      {.utc = {[](void* of) { return *static_cast<std::optional<CivilTime>*>(of); }, &utc}});
  utc->second = 60;
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#00 00 29 7C 0C 17 3B EC");
  EXPECT_EQ(bench.bench.cable.count(0x085), 0u);
  utc->second = 61;
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#02 FF 01 01 00 00 00 00") << "there is none";
}

TEST(TimeFixing, TellsHowFarTheLocalTimeIsNow) {
  std::optional<CivilTime> utc =
      CivilTime{.year = 2026, .month = 3, .day = 29, .hour = 0, .minute = 59, .second = 59};
  std::chrono::minutes offset = 60min;
  Bench<TimeFixingKind> bench(
      {.utc = {[](void* of) { return *static_cast<std::optional<CivilTime>*>(of); }, &utc},
       .local_offset = {[](void* of) { return *static_cast<std::chrono::minutes*>(of); },
                        &offset}});
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#01 00 29 74 03 00 3B EC");
  utc = CivilTime{.year = 2026, .month = 3, .day = 29, .hour = 1, .minute = 0, .second = 0};
  offset = 120min;
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#02 00 29 74 03 01 00 00");
  // West of Greenwich both are negative: Newfoundland.
  offset = -210min;
  bench.bench.cable.run_for(1s);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#FD E2 29 74 03 01 00 00");
}

TEST(VehicleGateway, HasTheRangesOfJ1939) {
  VehicleReading reading;
  Bench<VehicleGatewayKind> bench(
      {.read = {[](void* of) { return *static_cast<VehicleReading*>(of); }, &reading}});
  EXPECT_EQ(bench.ask("81 64 00"), "FF FF 00 00") << "not available";
  EXPECT_EQ(bench.ask("8C 64 00"), "FF 00 00 00");
  reading.speed_kmh = 1000;
  reading.coolant_celsius = 90;
  reading.ambient_celsius = -10;
  reading.fuel_rate_l_per_h = Measured::failure();
  reading.engine_hours = 12.5;
  reading.brake = BrakePedal::depressed;
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("81 64 00"), "FF FA 00 00") << "the end of the range";
  EXPECT_EQ(bench.ask("8C 64 00"), "82 00 00 00") << "90 + 40";
  EXPECT_EQ(bench.ask("89 64 00"), "E0 20 00 00") << "(-10 + 273) / 0.03125";
  EXPECT_EQ(bench.ask("8A 64 01"), "00 FE 00 00") << "error";
  EXPECT_EQ(bench.ask("8D 64 03"), "FA 00 00 00") << "12.5 h / 0.05 h";
  EXPECT_EQ(bench.ask("8B 64 00"), "40 00 00 00");
  reading.doors[0] = {.is_valid = true, .is_open = false};
  reading.doors[4] = {.is_valid = true, .is_open = true};
  reading.right_released = true;
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("88 64 01"), "A0 00 00 00");
  EXPECT_EQ(bench.ask("88 64 02"), "40 00 00 00");
  EXPECT_EQ(bench.ask("88 64 03"), "C0 00 00 00");
}

/// 9.2.15.1: positive backward as well; 9.2.15.5: degrees of a whole turn.
TEST(VehicleGateway, TellsASpeedBackwardAsItIs) {
  VehicleReading reading;
  reading.speed_kmh = -5;
  reading.direction = Direction::reverse;
  reading.bearing_degrees = -10;
  Bench<VehicleGatewayKind> bench(
      {.read = {[](void* of) { return *static_cast<VehicleReading*>(of); }, &reading}});
  EXPECT_EQ(bench.ask("81 64 00"), "00 05 00 00") << "5 x 256";
  EXPECT_EQ(bench.ask("86 64 00"), "00 AF 00 00") << "350 x 128";
  reading.bearing_degrees = 370;
  reading.speed_kmh = Measured::failure();
  bench.bench.cable.run_for(5s);
  EXPECT_EQ(bench.ask("86 64 00"), "00 05 00 00");
  EXPECT_EQ(bench.ask("81 64 00"), "00 FE 00 00") << "error";
}

/// The on-board computer takes the speed by satellites then (9.2.6.36).
TEST(VehicleGateway, TellsTheFailureOfASensorToOthersOfItsNode) {
  VehicleReading reading;
  reading.speed_kmh = 50;
  const VehicleGatewayHardware hardware = {
      .read = {[](void* of) { return *static_cast<VehicleReading*>(of); }, &reading}};
  auto gateway = [&hardware] { return hardware; };
  static constexpr const BusUnit* units[] = {&bus_unit<VehicleGatewayKind>,
                                             &bus_unit<MainOnBoardComputerKind>};
  BusBench bench(units, [&](Environment& environment) {
    environment.provide(Callback<VehicleGatewayHardware()>::of(gateway));
  });
  bench.ask("2B 62 66 00 32 00 00 00");  // 5 m/s
  bench.cable.run_for(100ms);
  ASSERT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 32 00 00") << "50 km/h";
  reading.speed_kmh = Measured::failure();
  bench.cable.run_for(100ms);
  EXPECT_EQ(bench.ask("40 81 64 00 00 00 00 00").substr(12), "00 FE 00 00") << "error";
  EXPECT_EQ(bench.ask("40 23 61 00 00 00 00 00").substr(12), "00 12 00 00") << "18 km/h";
}

/// Raw values by the ranges of 9.2.15: 5 m, 1/128 degree, 0.05 l/h, 1/512 km/l, 0.5 l, 0.05 h.
TEST(VehicleGateway, TellsMileageHeadingFuelAndTime) {
  VehicleReading reading;
  reading.speed_kmh = 0;
  reading.mileage_metres = 1000;
  reading.bearing_degrees = 90;
  reading.direction = Direction::reverse;
  reading.fuel_rate_l_per_h = 10;
  reading.economy_km_per_l = 2;
  reading.average_economy_km_per_l = 3;
  reading.fuel_used_l = 100;
  reading.trip_fuel_l = 5;
  reading.idle_fuel_l = 1;
  reading.local_time =
      CivilTime{.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 5, .second = 30};
  Bench<VehicleGatewayKind> bench(
      {.read = {[](void* of) { return *static_cast<VehicleReading*>(of); }, &reading}});
  EXPECT_EQ(bench.ask("82 64 00"), "C8 00 00 00");
  EXPECT_EQ(bench.ask("83 64 00"), "FF FF 00 00") << "nobody said how exact";
  EXPECT_EQ(bench.ask("84 64 00"), "40 00 00 00") << "no motion, reverse";
  EXPECT_EQ(bench.ask("86 64 00"), "00 2D 00 00");
  EXPECT_EQ(bench.ask("8A 64 01"), "C8 00 00 00");
  EXPECT_EQ(bench.ask("8A 64 02"), "00 04 00 00");
  EXPECT_EQ(bench.ask("8A 64 03"), "00 06 00 00");
  EXPECT_EQ(bench.ask("8A 64 04"), "C8 00 00 00");
  EXPECT_EQ(bench.ask("8A 64 05"), "0A 00 00 00");
  EXPECT_EQ(bench.ask("8A 64 06"), "02 00 00 00");
  const char* expected[] = {"29", "5C", "0B", "08", "05", "78"};
  for (unsigned sub = 1; sub <= 6; ++sub) {
    EXPECT_EQ(bench.ask("0E 61 0" + std::to_string(sub)),
              std::string(expected[sub - 1]) + " 00 00 00");
  }
}

struct Train {
  std::vector<std::string> told;
  void send(std::uint16_t index, std::uint8_t sub, std::span<const std::uint8_t> value) {
    char text[32];
    std::snprintf(text, sizeof text, "%04X:%02X %zu", index, sub, value.size());
    told.emplace_back(text);
  }
  TrainBusGatewayHardware hardware() { return {.send = callback<&Train::send>(*this)}; }
};

TEST(TrainBusGateway, HandsOnWhatIsToldInItsVehicle) {
  Train train;
  Bench<TrainBusGatewayKind> bench(train.hardware());
  bench.bench.cable.send("301#09 00 00 00 03 00");
  EXPECT_EQ(train.told, (std::vector<std::string>{"6191:00 4", "6193:00 2"}));
  EXPECT_EQ(bench.bench.ask("40 09 61 00 00 00 00 00"), "80 09 61 00 01 00 01 06") << "wo";
  const std::uint8_t stop[] = {1, 0, 0, 0};
  EXPECT_FALSE(bench.unit->receive(0x6109, 0, stop)) << "the main computer of this segment does";
}

/// The table of 6.10; 6720h and 6741h are files, and 6204h goes both ways.
TEST(TrainBusGateway, EachValueOfItsTableGoesToTheTrain) {
  constexpr std::uint16_t table[] = {
      0x6100, 0x6101, 0x6102, 0x6103, 0x6104, 0x6105, 0x6106, 0x6107, 0x6108, 0x6109, 0x610A,
      0x610B, 0x610C, 0x610D, 0x610E, 0x610F, 0x6110, 0x6111, 0x6112, 0x6113, 0x6114, 0x6115,
      0x6116, 0x6117, 0x6118, 0x611C, 0x611D, 0x611E, 0x611F, 0x6120, 0x6121, 0x6123, 0x6190,
      0x6191, 0x6192, 0x6193, 0x6194, 0x6195, 0x6196, 0x6197, 0x6204, 0x6481, 0x6484, 0x6488,
      0x6489, 0x6660, 0x6680, 0x6700, 0x6740, 0x6742, 0x6743, 0x6744};
  Train train;
  Bench<TrainBusGatewayKind> bench(train.hardware());
  for (const std::uint16_t index : table) {
    const auto found = bench.bench.node().dictionary().find(index, 1);
    const std::uint8_t sub = found ? 1 : 0;
    const auto entry = bench.bench.node().dictionary().find(index, sub);
    ASSERT_TRUE(entry) << std::hex << index;
    const std::size_t size = entry->row->is_text() ? 1 : entry->bytes().size();
    train.told.clear();
    EXPECT_TRUE(bench.bench.download(index, sub, std::string(size, '\1'))) << std::hex << index;
    char expected[32];
    std::snprintf(expected, sizeof expected, "%04X:%02X %zu", index, sub, size);
    EXPECT_EQ(train.told, (std::vector<std::string>{expected}));
  }
}

TEST(TrainBusGateway, StandsInWhereThereIsNoMainComputer) {
  Train train;
  Bench<TrainBusGatewayKind> bench(train.hardware(), {.has_main_computer = false});
  EXPECT_EQ(bench.bench.ask("40 09 61 00 00 00 00 00"), "43 09 61 00 00 00 00 00") << "ro";
  bench.bench.cable.clear();
  const std::uint8_t stop[] = {0x4D, 1, 0, 0};
  EXPECT_TRUE(bench.unit->receive(0x6109, 0, stop));
  const std::uint8_t zone[] = {7};
  EXPECT_TRUE(bench.unit->receive(0x6111, 0, zone));
  bench.bench.cable.run_for(0s);
  EXPECT_EQ(bench.bench.cable.last(0x401), "401#4D 01 00 00 00 00 00 00");
  EXPECT_EQ(bench.bench.cable.last(0x381), "381#00 00 07 00 01 01");
  EXPECT_FALSE(bench.unit->receive(0x6111, 0, stop)) << "4 bytes are no zone";
  EXPECT_FALSE(bench.unit->receive(0x1000, 0, stop));
  EXPECT_TRUE(train.told.empty());
}

TEST(TrainBusGateway, ARequestToStopGoesBothWays) {
  Train train;
  Bench<TrainBusGatewayKind> bench(train.hardware());
  const std::uint8_t yes[] = {1};
  EXPECT_TRUE(bench.unit->receive(0x6204, 0, yes));
  EXPECT_EQ(bench.ask("04 62 00"), "01 00 00 00");
  bench.bench.ask("2F 04 62 00 00 00 00 00");
  EXPECT_EQ(train.told, (std::vector<std::string>{"6204:00 1"}));
}

/// Number of TPDOs that carry only 6204h, BOOLEAN (9.2.8.5).
unsigned tpdos_of_stop_request(BusBench& bench) {
  unsigned count = 0;
  for (unsigned number = 0; number < 16; ++number) {
    char request[32];
    std::snprintf(request, sizeof request, "40 %02X 1A 01 00 00 00 00", number);
    count += bench.ask(request).substr(12) == "01 00 04 62" ? 1U : 0U;
  }
  return count;
}

/// 6204h has a message of the computer (8.1.5), and one of the gateway for it.
TEST(TrainBusGateway, ARequestOfTheTrainIsSentToTheMainComputer) {
  Train train;
  Bench<TrainBusGatewayKind> bench(train.hardware());
  bench.bench.cable.clear();
  bench.bench.cable.send("1C1#01");
  EXPECT_EQ(train.told, (std::vector<std::string>{"6204:00 1"}));
  bench.bench.cable.send("1C1#00");
  const std::uint8_t yes[] = {1};
  EXPECT_TRUE(bench.unit->receive(0x6204, 0, yes));
  bench.bench.cable.run_for(0s);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#01") << "180h + node-ID 5";
  EXPECT_EQ(tpdos_of_stop_request(bench.bench), 1u) << "1C1h is the computer's";
}

TEST(TrainBusGateway, InPlaceOfTheMainComputerItSendsTheRequestAndHasTheButtons) {
  Train train;
  Bench<TrainBusGatewayKind> bench(train.hardware(), {.has_main_computer = false});
  bench.bench.cable.clear();
  EXPECT_TRUE(bench.unit->press_stop_button());
  EXPECT_EQ(train.told, (std::vector<std::string>{"6204:00 1"}));
  bench.bench.cable.run_for(0s);
  EXPECT_EQ(bench.bench.cable.count(0x1C1), 0u) << "the computer has not said so yet";
  const std::uint8_t yes[] = {1};
  EXPECT_TRUE(bench.unit->receive(0x6204, 0, yes));
  bench.bench.cable.run_for(0s);
  EXPECT_EQ(bench.bench.cable.last(0x1C1), "1C1#01");
  EXPECT_EQ(tpdos_of_stop_request(bench.bench), 1u) << "nobody else is to take it";
  bench.bench.cable.send("000#80 05");
  EXPECT_FALSE(bench.unit->press_stop_button()) << "pre-operational";
}

TEST(DriverIndicator, ShowsWhatItIsTold) {
  DriverView seen;
  Bench<DriverDisplayKind> bench(
      {.show = {[](void* of, const DriverView& view) { *static_cast<DriverView*>(of) = view; },
                &seen}});
  EXPECT_EQ(bench.bench.ask("40 00 10 00 00 00 00 00"), "43 00 10 00 97 01 10 0B");
  bench.bench.ask("2F 88 64 01 C0 00 00 00");
  bench.bench.ask("2F 8C 64 00 82 00 00 00");
  bench.bench.ask("2F 8B 64 00 40 00 00 00");
  bench.bench.ask("23 40 67 01 20 31 12 00");
  EXPECT_TRUE(seen.has_open_door);
  EXPECT_TRUE(seen.left_released);
  EXPECT_EQ(seen.coolant_celsius, 90);
  EXPECT_TRUE(seen.is_braking);
  EXPECT_EQ(seen.last_error, 0x00123120u);
  bench.bench.ask("2B 89 64 00 E0 20 00 00");
  EXPECT_EQ(seen.ambient_celsius, -10);
  bench.bench.ask("2B 8A 64 01 C8 00 00 00");
  EXPECT_EQ(seen.fuel_rate_l_per_h, 10);
  bench.bench.ask("2B 8A 64 03 00 06 00 00");
  EXPECT_EQ(seen.average_economy_km_per_l, 3);
  bench.bench.ask("23 8D 64 03 FA 00 00 00");
  EXPECT_EQ(seen.engine_hours, 12.5);
  const char* clock[] = {"29", "5C", "0B", "08", "05", "78"};
  for (unsigned sub = 1; sub <= 6; ++sub) {
    bench.bench.ask("2F 0E 61 0" + std::to_string(sub) + " " + clock[sub - 1] + " 00 00 00");
  }
  EXPECT_EQ(
      seen.time,
      (CivilTime{.year = 2026, .month = 11, .day = 23, .hour = 8, .minute = 5, .second = 30}));
  bench.bench.cable.send("000#81 05");
  EXPECT_EQ(seen, DriverView{});
}

TEST(Keyboard, TellsKeysAndTheGear) {
  std::uint32_t keys = 0;
  Bench<KeyboardKind> bench(
      {.keys = {[](void* of) { return *static_cast<std::uint32_t*>(of); }, &keys},
       .is_reverse_engaged = {[](void* of) { return *static_cast<std::uint32_t*>(of) == 4; },
                              &keys}});
  EXPECT_EQ(bench.ask("C0 66 00"), "01 00 00 00") << "forward";
  keys = 4;
  bench.bench.cable.run_for(20ms);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#04 00 00 00");
  EXPECT_EQ(bench.ask("C0 66 00"), "00 00 00 00");
}

struct Pins {
  std::uint32_t in = 0;
  std::uint32_t out = 0xFF;
  std::array<std::int16_t, 9> analogue{};
  bool is_overloaded = false;
  GenericIoHardware hardware() {
    return {.digital_inputs = {[](void* of) { return static_cast<Pins*>(of)->in; }, this},
            .analogue_input = {[](void*, unsigned channel) {
                                 return static_cast<std::int16_t>(-100 * static_cast<int>(channel));
                               },
                               this},
            .set_digital_outputs = {[](void* of, std::uint32_t value) {
                                      static_cast<Pins*>(of)->out = value;
                                    },
                                    this},
            .set_analogue_output = {[](void* of, unsigned channel, std::int16_t value) {
                                      static_cast<Pins*>(of)->analogue.at(channel) = value;
                                    },
                                    this},
            .has_error = {[](void* of, std::uint16_t code) {
                            return static_cast<Pins*>(of)->is_overloaded && code == 0x2310;
                          },
                          this}};
  }
};

TEST(GenericIo, ReadsAndDrives) {
  Pins pins;
  Bench<GenericIoKind> bench(pins.hardware());
  EXPECT_EQ(pins.out, 0u) << "off after the start";
  pins.in = 0x80000001;
  bench.bench.cable.run_for(20ms);
  EXPECT_EQ(bench.bench.cable.last(0x185), "185#01 00 00 80");
  // -100 in the high word, channel 1; -200 in the low one.
  EXPECT_EQ(bench.ask("62 67 01"), "38 FF 9C FF");
  bench.bench.ask("23 61 67 00 0F 00 00 00");
  EXPECT_EQ(pins.out, 15u);
  bench.bench.ask("23 63 67 02 FE FF 05 00");
  EXPECT_EQ(pins.analogue[3], 5);
  EXPECT_EQ(pins.analogue[4], -2);
  pins.is_overloaded = true;
  bench.bench.cable.run_for(100ms);
  EXPECT_EQ(bench.bench.cable.last(0x085), "085#10 23 03 01 00 00 00 00");
  bench.bench.cable.send("000#81 05");
  EXPECT_EQ(pins.out, 0u);
}

template <class Kind>
class ByCode : public testing::Test {};
using CodeOnlyKinds = testing::Types<TicketReaderKind, DataRadioKind, VoiceRadioKind,
                                     ShortRangeKind, ConsoleDisplayKind, BusPowerSupplyKind>;
TYPED_TEST_SUITE(ByCode, CodeOnlyKinds);

TYPED_TEST(ByCode, IsACodeAndTheErrorsThatItMayHave) {
  bool is_broken = false;
  Bench<TypeParam> bench(
      {.has_error = {[](void* of, std::uint16_t) { return *static_cast<bool*>(of); }, &is_broken}});
  const unsigned code = TypeParam::provides.code;
  EXPECT_EQ(bench.bench.node().dictionary().number(0x1000, 0), code << 24 | 407U);
  EXPECT_EQ(bench.bench.ask("40 01 60 00 00 00 00 00"), "80 01 60 00 00 00 02 06") << "no objects";
  is_broken = true;
  bench.bench.cable.run_for(100ms);
  const bool is_radio = code >= 0x0D && code <= 0x0F;
  const bool is_supply = code == 0x18;
  EXPECT_EQ(bench.bench.cable.count(0x085), is_radio ? 1u : is_supply ? 11u : 0u);
  if (is_radio) {
    EXPECT_EQ(bench.bench.cable.last(0x085), "085#03 FF 01 01 00 00 00 00");
  }
}

}  // namespace
}  // namespace canvoy::cia407::vehicle_units_test
