// Every device with variable transmission types receives SYNC (1005h), so that each PDO can be
// synchronous (CiA 301, 7.5.2.35 and 7.5.2.37), at the wire. Those of a charger are constant (CiA
// 419, 6.2.3 to 6.2.8).
#include <gtest/gtest.h>

#include <algorithm>

#include <cstdio>

#include "canvoy/canopen/pdo/mpdo.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/devices/testing/every_device.hpp"

namespace canvoy::synchronous_pdos_test {
namespace {

class DeviceOnSync : public testing::TestWithParam<const DeviceKind*> {
 protected:
  DeviceOnSync() {
    cable.connect(0, node());
    cable.start_all();
    cable.send("000#01 00");
    cable.run_for(1s);
    cable.clear();
  }
  Node& node() { return device.node(); }
  Dictionary& dictionary() { return node().dictionary(); }
  /// Of a write by SDO: 0, or the abort code.
  std::uint32_t write(unsigned index, unsigned sub, std::uint32_t value, unsigned bytes) {
    char text[48];
    std::snprintf(text, sizeof text, "%03X#%02X %02X %02X %02X %02X %02X %02X %02X",
                  0x600U + node().id(), 0x23 | (4 - bytes) << 2, index & 0xFF, index >> 8, sub,
                  value & 0xFF, value >> 8 & 0xFF, value >> 16 & 0xFF, value >> 24);
    cable.clear();
    cable.send(text);
    const std::string answer = cable.last(0x580U + node().id());
    if (answer.empty()) return ~0U;
    unsigned command = 0;
    std::array<unsigned, 4> code{};
    std::sscanf(answer.c_str() + 4, "%2X %*X %*X %*X %2X %2X %2X %2X", &command, &code[0], &code[1],
                &code[2], &code[3]);
    return command == 0x60 ? 0 : code[0] | code[1] << 8 | code[2] << 16 | code[3] << 24;
  }
  /// True if it carries an object, and is not multiplexed. A PDO that is off by default is switched
  /// on afterwards.
  bool is_usable(unsigned parameter) {
    const bool is_constant = write(parameter, 2, 255, 1) == read_only;
    EXPECT_TRUE(!is_constant || write(parameter, 2, 1, 1) == read_only);
    if (is_constant) return false;
    constexpr std::uint32_t free_can_id = 0x3F0;
    const auto index = static_cast<std::uint16_t>(parameter);
    if (!dictionary().find(index, 1)) return false;
    const auto mapped = static_cast<unsigned>(
        dictionary().number(static_cast<std::uint16_t>(parameter + 0x200U), 0));
    if (mapped < 1 || mapped > 64) return false;
    const auto cob_id = static_cast<std::uint32_t>(dictionary().number(index, 1));
    return (cob_id & CobId::bit31) == 0 || write(index, 1, free_can_id, 4) == 0;
  }

  static constexpr std::uint32_t read_only = 0x0601'0002;

  Cable cable;
  DeviceOfKind device{cable.port(0), *GetParam()};
};

TEST_P(DeviceOnSync, SendsEachTpdoAtEachSecondSync) {
  unsigned found = 0;
  for (unsigned index = 0x1800; index <= 0x19FF; ++index) {
    if (!is_usable(index)) continue;
    ++found;
    const auto can_id = static_cast<std::uint32_t>(
        dictionary().number(static_cast<std::uint16_t>(index), 1) & 0x7FF);
    ASSERT_EQ(write(index, 2, 2, 1), 0U) << std::hex << index;
    cable.run_for(1s);
    cable.clear();
    cable.send("080#");
    cable.run_for(1ms);
    EXPECT_EQ(cable.count(can_id), 0U) << std::hex << index;
    cable.send("080#");
    cable.run_for(1ms);
    EXPECT_EQ(cable.count(can_id), 1U) << std::hex << index;
    ASSERT_EQ(write(index, 2, 255, 1), 0U);
    ASSERT_EQ(write(index, 1, CobId::bit31 | can_id, 4), 0U);
  }
  // An output panel sends nothing, and receives.
  for (unsigned index = 0x1400; found == 0 && index <= 0x15FF; ++index) found += is_usable(index);
  const bool listens = static_cast<bool>(dictionary().find(0x1005, 0));
  EXPECT_EQ(found != 0, listens);
  constexpr std::string_view without[] = {"charger", "real-time-clock", "audio-switch",
                                          // Of CiA 407 by their code alone.
                                          "ticket-reader", "data-radio", "voice-radio",
                                          "short-range-communication", "console-display",
                                          "bus-power-supply"};
  EXPECT_EQ(listens, std::ranges::find(without, GetParam()->info.name) == std::end(without));
}

/// RPDOs of a taximeter are behind its seal: 0800 0022h.
TEST_P(DeviceOnSync, TakesEachTransmissionTypeOfItsRpdos) {
  const bool is_sealed = GetParam()->info.name == "taximeter";
  for (unsigned index = 0x1400; index <= 0x15FF; ++index) {
    if (!is_usable(index)) continue;
    for (const unsigned type : {0U, 1U, 240U, 254U, 255U}) {
      EXPECT_EQ(write(index, 2, type, 1), is_sealed ? 0x0800'0022U : 0U)
          << std::hex << index << " " << type;
    }
    EXPECT_EQ(write(index, 2, 241, 1), is_sealed ? 0x0800'0022U : 0x0609'0030U)
        << std::hex << index;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, DeviceOnSync, testing::ValuesIn(every_device_kind()),
                         [](const auto& each) { return test_name(*each.param); });

TEST(SynchronousRpdo, ADriveTakesItsTargetWithTheNextSync) {
  Cable cable;
  cia417::CarDriveDevice<> drive(cable.port(0), 2, {});
  cable.connect(0, drive.node());
  cable.start_all();
  cable.send("000#01 00");
  const auto target = [&] { return drive.node().dictionary().number(0x6420, 0); };
  cable.send("602#2F 04 15 02 01 00 00 00");
  ASSERT_EQ(cable.last(0x582), "582#60 04 15 02 00 00 00 00");
  cable.send("180#00 00 E8 03 00 00");
  cable.run_for(1s);
  EXPECT_EQ(target(), 0U);
  cable.send("080#");
  EXPECT_EQ(target(), 1000U);
}

}  // namespace
}  // namespace canvoy::synchronous_pdos_test
