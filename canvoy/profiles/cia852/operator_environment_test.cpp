// Devices by clauses 9, 11 and 12 of CiA 852, and their use by applications.
#include "canvoy/profiles/cia852/operator_environment.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia852/handles.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::operator_environment_test {
namespace {

using cia852::OperatorEnvironment;
using cia852::Switch;

constexpr OperatorEnvironment seat_elements = {.joysticks = 2,
                                               .foot_pedals = 3,
                                               .encoders = 1,
                                               .wheels = 1,
                                               .push_button_clusters = 2,
                                               .indicator_clusters = 1,
                                               .displays = 2,
                                               .display_parameters = 6};
constexpr auto seat = describe(cia852::operator_environment<seat_elements>(),
                               cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(1000),
                               cia301::heartbeat_consumers(1), cia301::emergency_consumers(1));
constexpr auto seat_layout = lay_out_device<seat>();

/// A remote control with push-buttons alone.
constexpr OperatorEnvironment remote_elements = {.push_button_clusters = 1};
constexpr auto remote =
    describe(cia852::operator_environment<remote_elements>(), cia301::identity({.vendor_id = 1}),
             cia301::heartbeat_producer(1000));
constexpr auto remote_layout = lay_out_device<remote>();

constexpr OperatorEnvironment cabin_elements = {.joysticks = 16,
                                                .foot_pedals = 16,
                                                .encoders = 8,
                                                .wheels = 8,
                                                .push_button_clusters = 8,
                                                .indicator_clusters = 8,
                                                .displays = 8};
constexpr auto cabin =
    describe(cia852::operator_environment<cabin_elements>(), cia301::identity({.vendor_id = 1}),
             cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(1),
             cia301::emergency_consumers(1));
constexpr auto cabin_layout = lay_out_device<cabin>();

TEST(OperatorEnvironment, HasTheEntriesOfItsElementsAndNoOthers) {
  DeviceMemory device(seat_layout.tables(), 5);
  const auto count = [&](std::uint16_t index) {
    unsigned entries = 0;
    for (unsigned sub = 1; sub <= 0xFF; ++sub) {
      if (device.dictionary.find(index, static_cast<std::uint8_t>(sub))) ++entries;
    }
    return entries;
  };
  EXPECT_EQ(count(0x6000), 2U * 2 + 3 + 2 * 8);
  EXPECT_EQ(count(0x6120), 1U);
  EXPECT_EQ(count(0x6200), 8U);
  EXPECT_EQ(count(0x6401), 2U * 3 + 3 + 1);
  EXPECT_EQ(count(0x6411), 2U * 6);
  EXPECT_EQ(count(0x6444), 2U * 6);
  EXPECT_EQ(count(0x6413), 0U);
  // Table 5: of two clusters the last group is 40h; Table 4: the first wheel is 41h.
  EXPECT_EQ(device.dictionary.number(0x6000, 0), 0x40U);
  EXPECT_EQ(device.dictionary.number(0x6401, 0), 0x41U);
  EXPECT_EQ(device.dictionary.number(0x6120, 0), 0x81U);
  EXPECT_EQ(device.dictionary.find(0x6000, 0x05).abort(), AbortCode::no_sub_index);
  EXPECT_EQ(device.dictionary.find(0x6411, 0x07).abort(), AbortCode::no_sub_index);
  EXPECT_TRUE(device.dictionary.find(0x6411, 0x0D));
}

TEST(OperatorEnvironment, TellsItsElementsInTheDeviceType) {
  EXPECT_EQ(DeviceMemory(seat_layout.tables()).dictionary.number(0x1000, 0), 0xFF8F'0191U);
  EXPECT_EQ(DeviceMemory(remote_layout.tables()).dictionary.number(0x1000, 0), 0x9081'0191U);
}

TEST(OperatorEnvironment, HasThePdosOfItsElementsWithoutThoseThatAreMissing) {
  DeviceMemory device(seat_layout.tables(), 5);
  struct {
    std::uint16_t mapping;
    unsigned entries;
  } constexpr pdos[] = {{0x1600, 8}, {0x1601, 4}, {0x1603, 2},  // parameters 5 and 6 of display 1
                        {0x160C, 4}, {0x160D, 2}, {0x1A00, 5}, {0x1A04, 5},
                        {0x1A13, 4}, {0x1A14, 2},  // foot pedal 3 without the fourth
                        {0x1A1B, 1}, {0x1A1F, 1}, {0x1A21, 8}, {0x1A22, 8}};
  std::size_t found = 0;
  for (const ObjectRow& row : seat_layout.objects) {
    if (is_pdo_mapping(row.index)) ++found;
  }
  EXPECT_EQ(found, std::size(pdos));
  for (const auto& [mapping, entries] : pdos) {
    SCOPED_TRACE(testing::Message() << std::hex << mapping);
    EXPECT_EQ(device.dictionary.number(mapping, 0), entries);
    EXPECT_TRUE(device.dictionary.find(mapping, static_cast<std::uint8_t>(entries)));
    EXPECT_FALSE(device.dictionary.find(mapping, static_cast<std::uint8_t>(entries + 1)));
  }
  EXPECT_EQ(device.dictionary.number(0x1800, 1), 0x8000'0185U);
  EXPECT_EQ(device.dictionary.number(0x1804, 1), 0x8000'0000U);
}

TEST(OperatorEnvironment, OfOneKindHasTheMandatoryObjectsAndItsOwn) {
  constexpr std::uint16_t expected[] = {0x1000, 0x1001, 0x1005, 0x1014, 0x1015, 0x1017,
                                        0x1018, 0x1029, 0x1821, 0x1A21, 0x6000};
  ASSERT_EQ(remote_layout.objects.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(remote_layout.objects[i].index, expected[i]);
  }
}

TEST(OperatorEnvironment, CanHaveAllElements) {
  DeviceMemory device(cabin_layout.tables(), 5);
  EXPECT_EQ(device.dictionary.number(0x6000, 0), 0x70U);
  EXPECT_EQ(device.dictionary.number(0x6411, 0), 0x60U);
  EXPECT_EQ(device.dictionary.number(0x1A28, 8), 0x6000'7008U);
  EXPECT_EQ(device.dictionary.number(0x1620, 4), 0x6411'6010U);
  EXPECT_EQ(device.dictionary.number(0x6443, 0x60), 1U);
}

/// Table 8: the bit of the element is its code.
constexpr const VirtualDeviceInfo& wheel = cia852::functional_elements[3];
constexpr auto wheel_parts = virtual_device(cia852::profile, wheel);

TEST(OperatorEnvironment, AFunctionalElementBringsItsFirstPdoAndWhatThatMaps) {
  EXPECT_EQ(wheel.name, "Wheel");
  EXPECT_EQ(wheel.code, 0b1000);
  constexpr std::uint16_t expected[] = {0x181F, 0x1A1F, 0x6401};
  ASSERT_EQ(wheel_parts.size(), std::size(expected));
  for (const std::uint16_t index : expected) EXPECT_NE(wheel_parts.find(index), nullptr);
}

TEST(OperatorEnvironment, TheCodesOfFunctionalElementsAreTheirBitsInTheDeviceType) {
  struct {
    const char* name;
    unsigned code;
    std::uint16_t first_pdo;
  } constexpr elements[] = {{"Joystick", 0x01, 0x1800},
                            {"Foot-pedal", 0x02, 0x1813},
                            {"Encoder", 0x04, 0x181B},
                            {"Wheel", 0x08, 0x181F},
                            {"Push-button cluster", 0x10, 0x1821},
                            {"Indicator cluster", 0x20, 0x1400},
                            {"Display", 0x40, 0x1401}};
  ASSERT_EQ(cia852::profile.virtual_devices.size(), std::size(elements));
  for (std::size_t i = 0; i < std::size(elements); ++i) {
    const VirtualDeviceInfo& element = cia852::profile.virtual_devices[i];
    EXPECT_EQ(element.name, elements[i].name);
    EXPECT_EQ(element.code, elements[i].code);
    EXPECT_EQ(element.objects[0].index, elements[i].first_pdo);
    EXPECT_EQ(element.objects[0].category, Category::mandatory);
  }
}

class OperatorEnvironmentHandles : public testing::Test {
 protected:
  DeviceMemory device_{cabin_layout.tables()};
  Values values_{device_.dictionary};

  std::uint64_t raw(std::uint16_t index, std::uint8_t sub) {
    return device_.dictionary.number(index, sub);
  }
};

TEST_F(OperatorEnvironmentHandles, ReachTheInputs) {
  values_[cia852::joystick_x(1)] = -12000;
  values_[cia852::joystick_y(2)] = 1;
  values_[cia852::joystick_z(16)] = 40000;
  EXPECT_EQ(raw(0x6401, 0x01), 0xD120U);
  EXPECT_EQ(raw(0x6401, 0x05), 1U);
  EXPECT_EQ(raw(0x6401, 0x30), 0x7FFFU);
  values_[cia852::foot_pedal_position(16)] = 7;
  values_[cia852::wheel_position(8)] = 8;
  values_[cia852::encoder_position(8)] = 0xFFFF'FFFFU;
  EXPECT_EQ(raw(0x6401, 0x40), 7U);
  EXPECT_EQ(raw(0x6401, 0x48), 8U);
  EXPECT_EQ(raw(0x6120, 0x88), 0xFFFF'FFFFU);
  values_[cia852::analogue_events_enabled] = true;
  EXPECT_EQ(raw(0x6423, 0), 1U);
}

TEST_F(OperatorEnvironmentHandles, ReachSingleBits) {
  values_[cia852::joystick_memory_x(2)] = Switch::on;
  values_[cia852::joystick_memory_z(2)] = Switch::on;
  EXPECT_EQ(raw(0x6000, 0x03), 0b101U);
  values_[cia852::joystick_memory_y(2)] = Switch::on;
  values_[cia852::joystick_memory_x(2)] = Switch::off;
  EXPECT_EQ(raw(0x6000, 0x03), 0b110U);
  values_[cia852::joystick_button<8>(16)] = Switch::on;
  EXPECT_EQ(raw(0x6000, 0x20), 0x80U);
  EXPECT_EQ(values_[cia852::joystick_buttons(16)].raw(), 0x80U);
  values_[cia852::foot_pedal_memory(1)] = Switch::on;
  EXPECT_EQ(raw(0x6000, 0x21), 1U);
  values_[cia852::push_button<1>(1)] = Switch::on;
  values_[cia852::push_button<13>(2)] = Switch::on;  // the fifth of 9 to 16
  values_[cia852::push_button<64>(8)] = Switch::on;
  EXPECT_EQ(raw(0x6000, 0x31), 1U);
  EXPECT_EQ(raw(0x6000, 0x3A), 0x10U);
  EXPECT_EQ(raw(0x6000, 0x70), 0x80U);
  EXPECT_EQ(values_[cia852::push_buttons(2, 2)].raw(), 0x10U);
}

TEST_F(OperatorEnvironmentHandles, ReachTheOutputs) {
  values_[cia852::indicator<9>(1)] = Switch::on;
  EXPECT_EQ(raw(0x6200, 0x02), 1U);
  EXPECT_EQ(values_[cia852::indicators(1, 2)].raw(), 1U);
  EXPECT_TRUE(values_[cia852::indicator<9>(1)].is(Switch::on));
  EXPECT_TRUE(values_[cia852::indicator<10>(1)].is(Switch::off));
  // Table 6: 01h arms the first of eight indicators alone.
  EXPECT_TRUE(values_[cia852::indicator_error_mode<57>(8)].is(cia401::ErrorMode::take_error_value));
  EXPECT_TRUE(values_[cia852::indicator_error_mode<58>(8)].is(cia401::ErrorMode::keep));
  values_[cia852::indicator_error_value<64>(8)] = Switch::on;
  EXPECT_EQ(raw(0x6207, 0x40), 0x80U);
  values_[cia852::display_value(2, 1)] = -1;
  EXPECT_EQ(raw(0x6411, 0x0D), 0xFFFFU);
  EXPECT_TRUE(values_[cia852::display_error_mode(8, 12)].is(cia401::ErrorMode::take_error_value));
  values_[cia852::display_error_value(8, 12)] = 70000;
  EXPECT_EQ(raw(0x6444, 0x60), 70000U);
  EXPECT_EQ(values_[cia852::display_float(1, 1)].value(), std::nullopt) << "the cabin has integers";
}

}  // namespace
}  // namespace canvoy::operator_environment_test
