// Values of the battery from before a loss of either are out of date: after the return, current
// flows only on new values (CiA 419, 5.2 and 6.2).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia418/battery_device.hpp"
#include "canvoy/devices/cia419/charger_device.hpp"
#include "canvoy/devices/cia419/charger_test.hpp"

namespace canvoy::cia419::charger_stale_data_test {
namespace {

/// A battery that sends its PDOs on change only, and forbids remote frames: what was not renewed
/// has no deadline.
class ChargerStaleData : public testing::Test {
 protected:
  ChargerStaleData() {
    cable.connect(0, charger.node());
    cable.connect(1, battery.node());
    battery.node().start(cable.now);
    for (std::uint16_t index = 0x1800; index <= 0x1802; ++index) {
      Dictionary& dictionary = battery.node().dictionary();
      const auto cob_id = static_cast<std::uint32_t>(dictionary.number(index, 1));
      write(battery.node(), index, 1, 0x8000'0000U | cob_id, 4);
      write(battery.node(), index, 5, 0, 2);
      write(battery.node(), index, 1, 0x4000'0000U | cob_id, 4);
    }
    charger.node().start(cable.now);
    // It stays operational in all cases, unless stated otherwise.
    write(charger.node(), 0x1029, 1, 1, 1);
    cable.run_for(5s);
    cable.send("000#01 00");
    cable.run_for(2s);
    EXPECT_EQ(bench.delivered, 40);
  }
  static void write(Node& node, std::uint16_t index, std::uint8_t sub, std::uint32_t value,
                    std::size_t length) {
    std::uint8_t bytes[4];
    store(bytes, value);
    ASSERT_EQ(node.dictionary().write(index, sub, std::span(bytes).first(length), Source::sdo),
              AbortCode::none);
  }
  static bool is_battery_pdo(const Frame& frame) {
    return frame.id == 0x18A || frame.id == 0x28A || frame.id == 0x38A;
  }
  /// Only heartbeats of the battery come through.
  void lose_pdos() {
    cable.filter = [](const Frame& frame) { return !is_battery_pdo(frame); };
  }
  void lose_heartbeats() {
    cable.filter = [](const Frame& frame) { return frame.id != 0x70A; };
  }
  /// Each value once: what the battery sends when something changes.
  void renew(int position) {
    static constexpr const char* pdos[] = {"28A#A0 00 01 00 C8 00 00", "38A#80 02 1E"};
    cable.filter = [](const Frame&) { return true; };
    cable.send(pdos[position]);
    lose_pdos();
  }
  /// The battery has been received again, and none of its values has come.
  void expect_rest_until_all_is_new() {
    cable.run_for(3s);
    EXPECT_EQ(bench.delivered, 0);
    EXPECT_EQ(charger.charger().reason(), StopReason::battery_data_missed);
    renew(0);
    cable.run_for(1s);
    EXPECT_EQ(bench.delivered, 0) << "the other PDO is still of before";
    renew(1);
    cable.run_for(1s);
    EXPECT_EQ(bench.delivered, 40);
  }

  Bench bench;
  Cable cable;
  static ChargerSettings settings() {
    ChargerSettings settings;
    settings.manage_network = false;
    return settings;
  }
  ChargerDevice<> charger{cable.port(0), 5, bench.charger_hardware(), settings()};
  cia418::BatteryDevice<> battery{cable.port(1), 10, bench.battery_hardware(), {}};
};

TEST_F(ChargerStaleData, OfBeforeALostHeartbeatIsVoid) {
  lose_heartbeats();
  cable.run_for(3s);
  EXPECT_EQ(charger.charger().reason(), StopReason::heartbeat_lost);
  lose_pdos();
  expect_rest_until_all_is_new();
}

TEST_F(ChargerStaleData, ThatComesWhileTheHeartbeatIsLostIsVoidWhenItIsBack) {
  lose_heartbeats();
  cable.run_for(3s);
  EXPECT_EQ(charger.charger().reason(), StopReason::heartbeat_lost);
  renew(0);
  renew(1);
  cable.run_for(1h);
  EXPECT_EQ(bench.delivered, 0);
  lose_pdos();
  expect_rest_until_all_is_new();
}

TEST_F(ChargerStaleData, OfBeforeTheChargerLeftOperationalIsVoid) {
  for (const char* command : {"000#80 05", "000#02 05"}) {
    cable.send(command);
    lose_pdos();
    cable.run_for(1h);
    EXPECT_EQ(bench.delivered, 0);
    cable.send("000#01 05");
    expect_rest_until_all_is_new();
  }
}

TEST_F(ChargerStaleData, OfBeforeTheBatteryLeftOperationalIsVoid) {
  for (const char* command : {"000#80 0A", "000#02 0A"}) {
    cable.send(command);
    cable.run_for(2s);
    EXPECT_EQ(charger.charger().reason(), StopReason::battery_data_missed);
    lose_pdos();
    cable.send("000#01 0A");
    expect_rest_until_all_is_new();
  }
}

// A PDO proves that its sender is operational again: its heartbeat follows up to a period later.
TEST_F(ChargerStaleData, FromABatteryThatIsOperationalAgainIsNewBeforeItsHeartbeatSaysSo) {
  cable.send("000#80 0A");
  cable.run_for(2s);
  ASSERT_EQ(bench.delivered, 0);
  cable.send("000#01 0A");
  cable.run_for(2s);
  EXPECT_EQ(bench.delivered, 40);
}

TEST_F(ChargerStaleData, OfBeforeABusOffIsVoid) {
  charger.node().bus_state(BusState::bus_off, cable.now);
  cable.run_for(1s);
  EXPECT_EQ(bench.delivered, 0);
  lose_pdos();
  charger.node().bus_state(BusState::error_active, cable.now);
  expect_rest_until_all_is_new();
}

/// Each is refused whole (8200h, or 8210h for its length), so that the values of before are shown,
/// but hold no longer.
TEST_F(ChargerStaleData, OfBeforeAPdoThatWasNotTakenIsVoid) {
  struct {
    int position;
    const char* frame;
    const char* emergency;
  } constexpr pdos[] = {
      {0, "28A#00 70 01 00 C8 00 00", "085#00 82 11 02 00 10 60 00"},  // 6010h = 7000h
      {0, "28A#A0 00 03 00 C8 00 00", "085#00 82 11 02 00 00 60 00"},  // 6000h = 03h
      {1, "38A#80 02 65", "085#00 82 11 03 00 81 60 00"},              // 6081h = 65h
      {0, "28A#A0 00 01", "085#10 82 11 02 00 00 00 00"}};
  for (const auto& pdo : pdos) {
    lose_pdos();
    cable.run_for(1s);
    ASSERT_EQ(bench.delivered, 40) << pdo.frame;
    cable.clear();
    cable.filter = [](const Frame&) { return true; };
    cable.send(pdo.frame);
    lose_pdos();
    cable.run_for(1s);
    EXPECT_EQ(cable.last(0x085), pdo.emergency);
    EXPECT_EQ(bench.delivered, 0) << pdo.frame;
    EXPECT_EQ(charger.charger().reason(), StopReason::battery_data_missed) << pdo.frame;
    renew(pdo.position);
    cable.run_for(1s);
    EXPECT_EQ(bench.delivered, 40) << pdo.frame;
  }
}

}  // namespace
}  // namespace canvoy::cia419::charger_stale_data_test
