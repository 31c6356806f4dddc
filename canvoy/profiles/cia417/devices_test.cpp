// Devices, PDOs and error codes of CiA 417: expectations from the public sources of its parts 1 to
// 3 (device type, pre-defined PDOs, error handling), typed again.
#include <gtest/gtest.h>

#include <vector>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia417_devices_test {
namespace {

using cia417::VirtualDevice;
using enum PdoInfo::Direction;

TEST(Cia417, The1000hOfADeviceHasItsCodeInTheHighByte) {
  EXPECT_EQ(cia417::device_type(VirtualDevice::call_controller), 0x010001A1U);
  EXPECT_EQ(cia417::device_type(VirtualDevice::car_position_unit), 0x060001A1U);
  EXPECT_EQ(cia417::device_type(VirtualDevice::several), 0x000001A1U);
}

TEST(Cia417, EachVirtualDeviceIsThereOnceInTheOrderOfItsCode) {
  constexpr const char* names[] = {
      "several virtual devices", "call controller", "input panel unit",   "output panel unit",
      "car door controller",     "car door unit",   "car position unit",  "light barrier unit",
      "car drive controller",    "car drive unit",  "load measuring unit"};
  ASSERT_EQ(cia417::profile.virtual_devices.size(), std::size(names) + 1);
  for (unsigned code = 0; code < std::size(names); ++code) {
    EXPECT_EQ(cia417::profile.virtual_devices[code].code, code);
    EXPECT_EQ(cia417::profile.virtual_devices[code].name, names[code]);
  }
  EXPECT_EQ(cia417::profile.virtual_devices[std::size(names)].code, 0x0B);
}

const DeviceObject* object_of(VirtualDevice device, unsigned index) {
  for (const DeviceObject& object :
       cia417::profile.virtual_devices[static_cast<unsigned>(device)].objects) {
    const unsigned last = object.last == 0 ? object.index : object.last;
    if (index >= object.index && index <= last) return &object;
  }
  return nullptr;
}

/// 4.2.2: which devices have a lift number.
TEST(Cia417, TheDevicesOfOneLiftHaveALiftNumber) {
  for (const VirtualDeviceInfo& device : cia417::profile.virtual_devices) {
    const DeviceObject* object = object_of(VirtualDevice{device.code}, 0x6001);
    const auto code = VirtualDevice{device.code};
    const bool belongs_to_no_lift =
        code == VirtualDevice::several || code == VirtualDevice::input_panel_unit ||
        code == VirtualDevice::output_panel_unit || code == VirtualDevice::sensor_unit;
    EXPECT_EQ(object == nullptr, belongs_to_no_lift) << device.name;
    if (object != nullptr) {
      EXPECT_EQ(object->category, Category::mandatory) << device.name;
    }
  }
}

/// 4.3 to 4.13: each object has one device, or more, that provides it.
TEST(Cia417, EachObjectIsProvidedBySomeDevice) {
  for (const ObjectInfo* object : cia417::profile.objects) {
    bool is_provided = false;
    for (const VirtualDeviceInfo& device : cia417::profile.virtual_devices) {
      const DeviceObject* has = object_of(VirtualDevice{device.code}, object->index);
      is_provided = is_provided || (has != nullptr && !has->consumed);
      if (has != nullptr && has->last != 0) {
        EXPECT_EQ(has->last, object->index + object->count - 1) << object->name;
      }
    }
    EXPECT_TRUE(is_provided) << object->name;
  }
}

// PDOs.

struct ExpectedPdo {
  unsigned receiver;  ///< the communication parameter of the receiver; that of the sender is 400h
                      ///< above
  std::uint32_t can_id;
  std::vector<std::uint32_t> mapping;
};
const std::vector<ExpectedPdo>& pdos_of_lift_1() {
  static const std::vector<ExpectedPdo> pdos = {
      {0x1500, 0x400, {0x60110030}},
      {0x1502, 0x188, {0x64820108}},
      {0x1503, 0x184, {0x64000010, 0x64300020}},
      {0x1504, 0x180, {0x64000010, 0x64200020}},
      {0x1505, 0x181, {0x64010010, 0x64060020}},
      {0x1506, 0x18C, {0x63830120}},
      {0x1507, 0x185, {0x64010010, 0x64330020}},
      {0x1508, 0x200, {0x63000110, 0x63000210, 0x63000310, 0x63000410}},
      {0x150A, 0x201, {0x63010110, 0x63020110}},
      {0x150B, 0x205, {0x63100108}},
      {0x150C, 0x202, {0x63010210, 0x63020210}},
      {0x150D, 0x206, {0x63100208}},
      {0x150E, 0x203, {0x63010310, 0x63020310}},
      {0x150F, 0x207, {0x63100308}},
  };
  return pdos;
}

const PdoInfo* find_pdo(PdoInfo::Direction direction, unsigned number) {
  for (const PdoInfo& pdo : cia417::profile.pdos) {
    if (pdo.direction == direction && pdo.number == number) return &pdo;
  }
  return nullptr;
}
std::vector<std::uint32_t> mapping_of(const PdoInfo& pdo) {
  return {pdo.mapping.begin(), pdo.mapping.end()};
}

TEST(Cia417, ThePdosOfTheFirstLiftCarryWhatTheirTableSays) {
  for (const ExpectedPdo& expected : pdos_of_lift_1()) {
    for (const auto direction : {transmit, receive}) {
      const PdoInfo* pdo = find_pdo(direction, expected.receiver - 0x1400 + 1);
      ASSERT_NE(pdo, nullptr) << std::hex << expected.receiver;
      EXPECT_EQ(pdo->cob_id, expected.can_id);
      EXPECT_EQ(mapping_of(*pdo), expected.mapping) << pdo->name;
      EXPECT_EQ(pdo->transmission_type, 255);
    }
  }
}

/// Lift 2 has its load signaling in 1512h, with 6C82h:01h mapped; the step of the CAN-IDs is
/// inferred, and `condition` says so.
TEST(Cia417, ThePdosOfTheOtherLiftsAreNumbered10hAbove) {
  for (const ExpectedPdo& expected : pdos_of_lift_1()) {
    if (expected.receiver == 0x1500) continue;  // virtual outputs are of all lifts
    for (unsigned lift = 2; lift <= 8; ++lift) {
      const PdoInfo* pdo = find_pdo(receive, expected.receiver - 0x1400 + 1 + (lift - 1) * 0x10);
      ASSERT_NE(pdo, nullptr);
      EXPECT_EQ(pdo->cob_id, expected.can_id + (lift - 1) * 0x10);
      EXPECT_NE(pdo->condition.find("inferred"), std::string_view::npos);
      ASSERT_EQ(pdo->mapping.size(), expected.mapping.size());
      for (std::size_t i = 0; i < expected.mapping.size(); ++i) {
        EXPECT_EQ(pdo->mapping[i], expected.mapping[i] + ((lift - 1) * 0x800U << 16));
      }
    }
  }
  EXPECT_EQ(find_pdo(receive, 0x1512 - 0x1400 + 1)->mapping[0], 0x6C820108U);
}

TEST(Cia417, EachNodeHasPdosOfItsOwnForInputsSensorsAndTheRest) {
  constexpr unsigned expected[][3] = {
      {0x1401, 0x501, 0}, {0x1481, 0x481, 0x60100030}, {0x1581, 0x381, 0x60120030}};
  for (const auto& [index, can_id, mapped] : expected) {
    const PdoInfo* received = find_pdo(receive, index - 0x1400 + 1);
    const PdoInfo* sent = find_pdo(transmit, index - 0x1400 + 1);
    ASSERT_TRUE(received != nullptr && sent != nullptr) << std::hex << index;
    EXPECT_EQ(received->cob_id, can_id);
    EXPECT_EQ(received->last_number - received->number + 1, 127) << "node-IDs";
    EXPECT_EQ(sent->cob_id, 0x8000'0000 | (can_id - 1));
    EXPECT_TRUE(sent->plus_node_id);
    EXPECT_EQ(received->multiplexed, mapped == 0 ? MpdoKind::destination : MpdoKind::no);
    if (mapped != 0) {
      EXPECT_EQ(mapping_of(*sent), std::vector<std::uint32_t>{mapped});
    }
  }
}

TEST(Cia417, NoPdoIsThereTwice) {
  for (const PdoInfo& a : cia417::profile.pdos) {
    for (const PdoInfo& b : cia417::profile.pdos) {
      if (&a == &b || a.direction != b.direction) continue;
      EXPECT_TRUE(a.number != b.number || a.number == 0) << a.name << " " << a.number;
      EXPECT_NE(a.cob_id, b.cob_id) << a.name << ", " << b.name;
    }
  }
}

TEST(Cia417, WhatIsInferredSaysSo) {
  for (const PdoInfo& pdo : cia417::profile.pdos) {
    if (pdo.number == 0 || pdo.cob_id == 0x184) {
      EXPECT_FALSE(pdo.condition.empty()) << pdo.name;
    }
  }
}

TEST(Cia417, ErrorCodesAreThoseOfPart1) {
  constexpr unsigned codes[] = {0x0010, 0x3111, 0x3121, 0x3211, 0x3221, 0xFF01,
                                0xFF02, 0xFF03, 0xFF04, 0xFF05, 0xFF06};
  ASSERT_EQ(cia417::profile.error_codes.size(), std::size(codes));
  for (std::size_t i = 0; i < std::size(codes); ++i) {
    EXPECT_EQ(cia417::profile.error_codes[i].code, codes[i]);
  }
}

TEST(Cia417, TheDimensionRecordHasTwoIndices) {  // 4.1.3.1
  ASSERT_EQ(cia417::profile.record_types.size(), 1U);
  const RecordTypeInfo& record = cia417::profile.record_types[0];
  EXPECT_EQ(record.index, 0x0080);
  ASSERT_EQ(record.members.size(), 3U);
  EXPECT_EQ(record.members[1].type, DataType::integer8);
  EXPECT_EQ(record.members[2].type, DataType::unsigned8);
}

// Devices made of it.

constexpr auto door_unit =
    describe(virtual_device(cia417::profile, cia417::virtual_devices[5],
                            {{0x6300, 2}, {0x6301, 2}, {0x6302, 2}, 0x6304, 0x6305}),
             cia301::device_type(cia417::device_type(VirtualDevice::car_door_unit)),
             cia301::error_register_object, cia301::identity({.vendor_id = 1}));
constexpr auto door_layout = lay_out_device<door_unit>();

TEST(Cia417, ADoorUnitTakesCommandsAndGivesStates) {
  const DeviceMemory door(door_layout.tables());
  const Dictionary& dictionary = door.dictionary;
  EXPECT_EQ(access_text(dictionary.find(0x6300, 2)->row->access), "rw TR");
  EXPECT_EQ(access_text(dictionary.find(0x6301, 1)->row->access), "ro T");
  EXPECT_EQ(dictionary.find(0x6300, 3).abort(), AbortCode::no_sub_index);
  EXPECT_EQ(dictionary.number(0x1000, 0), 0x050001A1U);
  EXPECT_EQ(dictionary.number(0x6001, 0), 1U);
  EXPECT_EQ(dictionary.number(0x6300, 0), 2U);
  EXPECT_EQ(dictionary.number(0x6300, 1), 0xFFFFU) << "no action, until somebody asks for one";
  EXPECT_EQ(dictionary.number(0x6301, 2), 0xFFFFU);
  EXPECT_EQ(dictionary.number(0x6302, 2), 0xFFFFU);
  EXPECT_EQ(dictionary.number(0x6305, 0x0B), 0U);
}

/// 4.3: one input of group 32 of 254, with its parameters: what is not used is FFh.
constexpr auto panel =
    describe(virtual_device(cia417::profile, cia417::virtual_devices[2],
                            {0x6010, {0x611F, 3}, {0x613F, 3}, {0x619F, 3}}),
             cia301::device_type(cia417::device_type(VirtualDevice::input_panel_unit)),
             cia301::error_register_object, cia301::identity({.vendor_id = 1}));
constexpr auto panel_layout = lay_out_device<panel>();

TEST(Cia417, ParametersOfInputsAreNotUsedUntilTheyAreWritten) {
  const DeviceMemory device(panel_layout.tables());
  EXPECT_EQ(device.dictionary.number(0x611F, 0), 3U);
  EXPECT_EQ(device.dictionary.number(0x611F, 3), 0U);
  EXPECT_EQ(device.dictionary.number(0x613F, 3), 0xFFFFFFFFU);
  EXPECT_EQ(device.dictionary.number(0x619F, 1), 0xFFFFFFFFU);
  EXPECT_EQ(device.dictionary.find(0x611F, 4).abort(), AbortCode::no_sub_index);
  EXPECT_EQ(device.dictionary.find(0x611E, 1).abort(), AbortCode::no_object);
}

}  // namespace
}  // namespace canvoy::cia417_devices_test
