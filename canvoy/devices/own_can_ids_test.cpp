// Every device of the catalogue reports another node that sends with a CAN-ID of its own (CiA 301,
// emergency error code 8150h): its emergencies, SDO answers and heartbeats, and each of its TPDOs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/testing/every_device.hpp"

namespace canvoy::own_can_ids_test {
namespace {

/// Valid COB-IDs of the PDOs from this parameter on, as a client reads them.
std::set<std::uint16_t> pdo_ids(const Dictionary& dictionary, std::uint16_t first) {
  std::set<std::uint16_t> ids;
  for (std::uint16_t index = first; index < first + 0x200; ++index) {
    const CobId cob_id{dictionary.word(index, 1, CobId::bit31)};
    if (cob_id.valid() && cob_id.is_base_frame()) {
      ids.insert(static_cast<std::uint16_t>(cob_id.can_id()));
    }
  }
  return ids;
}

class OwnCanIds : public testing::TestWithParam<const DeviceKind*> {
 protected:
  OwnCanIds() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.run_for(1s);
  }
  unsigned id() { return device.node().id(); }
  /// The last emergency of the device that says 8150h since the frame, or nothing.
  std::string collision_after(std::uint16_t can_id, std::uint8_t length) {
    cable.run_for(10s);
    cable.clear();
    Frame frame = Frame::data_frame(can_id, {});
    frame.length = length;
    cable.send(frame);
    cable.run_for(1s);
    for (const Cable::Heard& heard : cable.heard) {
      const std::string text = wire_text(heard.frame);
      if (heard.frame.id == 0x80 + id() && text.substr(4, 5) == "50 81") return text;
    }
    return "";
  }
  std::string expected(std::uint16_t can_id) {
    char text[24];
    std::snprintf(text, sizeof text, "%02X %02X", can_id & 0xFFU, can_id >> 8U);
    return text;
  }

  Cable cable;
  DeviceOfKind device{cable.port(0), *GetParam()};
};

TEST_P(OwnCanIds, OfAnotherNodeAreReported) {
  const auto own = [&](unsigned function) { return static_cast<std::uint16_t>(function + id()); };
  const std::pair<std::uint16_t, std::uint8_t> beside_pdos[] = {
      {own(0x700), 1}, {own(0x580), 8}, {own(0x080), 8}};
  for (const auto& [can_id, length] : beside_pdos) {
    const std::string told = collision_after(can_id, length);
    ASSERT_GE(told.size(), 18U) << std::hex << can_id;
    EXPECT_EQ(told.substr(13, 5), expected(can_id));
  }
  const auto received = pdo_ids(device.node().dictionary(), object_index::rpdo_parameter);
  for (const std::uint16_t can_id :
       pdo_ids(device.node().dictionary(), object_index::tpdo_parameter)) {
    const std::string told = collision_after(can_id, 8);
    if (received.contains(can_id)) {
      EXPECT_EQ(told, "") << std::hex << can_id;
      continue;
    }
    ASSERT_GE(told.size(), 18U) << std::hex << can_id;
    EXPECT_EQ(told.substr(13, 5), expected(can_id));
  }
}

INSTANTIATE_TEST_SUITE_P(EveryDevice, OwnCanIds, testing::ValuesIn(every_device_kind()),
                         [](const auto& info) { return test_name(*info.param); });

}  // namespace
}  // namespace canvoy::own_can_ids_test
