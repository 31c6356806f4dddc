// CiA 447-3: devices composed of virtual devices, and their use by application code.
#include "canvoy/profiles/cia447/device.hpp"

#include <gtest/gtest.h>

#include <array>

#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::device_test {
namespace {

using namespace cia447;

constexpr auto gateway =
    describe(device_with(ivn_gateway_device), cia301::identity({.vendor_id = 1}));
constexpr auto gateway_layout = lay_out_device<gateway>();
constexpr auto taxi = describe(
    device_with(taximeter_device, gps_device, tariff_display_device),
    consumed(actual_engine_revolutions_object, wheel_rpm_object, wheel_pulse_counter_object),
    cia301::identity({.vendor_id = 1}));
constexpr auto taxi_layout = lay_out_device<taxi>();
constexpr auto all_others =
    describe(device_with(terminal_device, navigation_system_device, printer_device,
                         real_time_clock_device, driver_identification_device, radio_device,
                         audio_switch_device, roof_bar_light_device, roof_bar_sound_device),
             cia301::identity({.vendor_id = 1}));
constexpr auto all_others_layout = lay_out_device<all_others>();

TEST(Cia447Device, HasTheDeviceTypeAndAllObjectsOfItsVirtualDevices) {
  DeviceMemory memory(gateway_layout.tables());
  EXPECT_EQ(memory.dictionary.number(0x1000, 0), 0x0000'01BFU);
  for (const DeviceObject& object : ivn_gateway_device.objects) {
    EXPECT_TRUE(memory.dictionary.find(object.index, 0)) << std::hex << object.index;
  }
  EXPECT_FALSE(memory.dictionary.find(0x60D0, 0));
}

TEST(Cia447Device, AStatusBeginsAsNotAvailable) {
  DeviceMemory memory(gateway_layout.tables());
  EXPECT_EQ(memory.dictionary.number(0x600D, 0), 0xFFFFU);
  EXPECT_EQ(memory.dictionary.number(0x6020, 0), 0xFFU);
  EXPECT_EQ(memory.dictionary.number(0x600E, 0), 0xFFU) << "and a command as 'don't care'";
  Values car(memory.dictionary);
  EXPECT_TRUE(car[door_status_driver].is(Opening::not_available));
  EXPECT_TRUE(car[horn_command].is(Order::do_not_care));
  EXPECT_FALSE(car[displayed_outside_air_temperature].value());
}

TEST(Cia447Device, WhatItConsumesMayBeWritten) {
  DeviceMemory own(gateway_layout.tables());
  DeviceMemory other(taxi_layout.tables());
  EXPECT_EQ(access_text(own.dictionary.find(0x6053, 0)->row->access), "ro T");
  EXPECT_EQ(access_text(other.dictionary.find(0x6053, 0)->row->access), "rw TR");
  EXPECT_EQ(other.dictionary.number(0x6053, 0), 0xFFFFU);
  EXPECT_EQ(other.dictionary.number(0x6055, 0), 0xFF'FFFFU);
}

TEST(Cia447Device, HasThePdosOfItsObjects) {
  DeviceMemory memory(gateway_layout.tables());
  for (const unsigned number : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 17U, 18U, 19U}) {
    const auto index = static_cast<std::uint16_t>(0x1800 + number - 1);
    EXPECT_EQ(memory.dictionary.number(index, 1), 0x8000'0000U) << "its CAN-ID is not known";
    EXPECT_TRUE(memory.dictionary.find(index + 0x200, 1)) << number;
  }
  EXPECT_FALSE(memory.dictionary.find(0x1850, 1)) << "that of the terminal";
  EXPECT_FALSE(memory.dictionary.find(0x1400, 1)) << "it consumes nothing";
  EXPECT_EQ(memory.dictionary.number(0x1A01, 0), 3U);
  EXPECT_EQ(memory.dictionary.number(0x1A01, 1), 0x6010'0018U);
  EXPECT_EQ(memory.dictionary.number(0x1810, 5), 100U) << "wheels are told each 100 ms (4.2.4.4)";
  EXPECT_EQ(memory.dictionary.number(0x1811, 5), 0U);
}

TEST(Cia447Device, HasTheRpdosOfWhatItConsumes) {
  DeviceMemory memory(taxi_layout.tables());
  EXPECT_EQ(memory.dictionary.number(0x1610, 0), 3U);
  EXPECT_EQ(memory.dictionary.number(0x1610, 3), 0x6055'0018U);
  EXPECT_EQ(memory.dictionary.number(0x1A45, 2), 0x60B0'0220U) << "and tells where it is";
  EXPECT_FALSE(memory.dictionary.find(0x1A4C, 1)) << "6102h cannot be mapped (errata Z40)";
  EXPECT_TRUE(memory.dictionary.find(0x1A4D, 1));
}

TEST(Cia447Device, FieldsAreWrittenForThemselves) {
  DeviceMemory memory(gateway_layout.tables());
  Values car(memory.dictionary);
  car[door_status_driver] = Opening::open;
  car[door_status_rear_left] = Opening::is_getting_closed;
  EXPECT_EQ(memory.dictionary.number(0x600D, 0), 0xF7F8U);  // 1111'011'111'111'000b
  car[seat_adjustment_status_recall_memory[2]] = SeatMemory::memory_3;
  EXPECT_EQ(memory.dictionary.number(0x6019, 2), 0xFF'BFFFU);
  EXPECT_EQ(memory.dictionary.number(0x6019, 1), 0xFF'FFFFU) << "the driver's seat is another one";
}

TEST(Cia447Device, NumbersAreWrittenInTheirUnits) {
  DeviceMemory memory(gateway_layout.tables());
  Values car(memory.dictionary);
  car[displayed_outside_air_temperature] = 21.5;
  EXPECT_EQ(memory.dictionary.number(0x6020, 0), 143U);
  car[displayed_outside_air_temperature] = std::nullopt;
  EXPECT_EQ(memory.dictionary.number(0x6020, 0), 0xFFU);
  car[wheel_rpm] = 512.5;
  EXPECT_EQ(memory.dictionary.number(0x6053, 0), 1025U);
  car[actual_engine_revolutions] = 900;
  car[actual_engine_revolutions_terminal_61] = Signal::yes;
  EXPECT_EQ(memory.dictionary.number(0x6050, 0), 0x4384U);
  car[vin_data] = "WDB9066331S123456";
  EXPECT_EQ(car[vin_data].value(), "WDB9066331S123456");
}

TEST(Cia447Device, PositionsAreWrittenAsDegrees) {
  DeviceMemory memory(taxi_layout.tables());
  Values gps(memory.dictionary);
  gps[gps_current_position_latitude] = -33.8567844;
  gps[gps_current_position_longitude] = 151.2152967;
  EXPECT_EQ(memory.dictionary.number(0x60B0, 1), 1'238'567'844U);
  EXPECT_EQ(memory.dictionary.number(0x60B0, 2), 1'512'152'967U);
  EXPECT_DOUBLE_EQ(gps[gps_current_position_latitude].value().value_or(0), -33.8567844);
  memory.dictionary.set_number(0x60B0, 2, 0xD693'A400);
  EXPECT_EQ(gps[gps_current_position_longitude].value(), -180.0);
}

TEST(Cia447Device, FaresAreWrittenAsMoney) {
  DeviceMemory memory(taxi_layout.tables());
  Values meter(memory.dictionary);
  meter[taximeter_status] = Taximeter::hired;
  meter[taxi_trip_payment_fare] = 12.34;
  meter[taxi_trip_payment_fare_calculation_mode] = FareMode::fixed_price;
  EXPECT_EQ(memory.dictionary.number(0x60D8, 0) & 0x0F, 1U);
  EXPECT_EQ(memory.dictionary.number(0x60D0, 1), 12'340U);
  EXPECT_EQ(memory.dictionary.number(0x60D0, 4), 2U);
  meter[tariff_display_lamp_command<9>] = Lamp::blinking;
  EXPECT_EQ(memory.dictionary.number(0x6107, 0), 0xFFFF'FFF3U);
}

TEST(Cia447Device, LightsHaveTheirPrintedNames) {
  DeviceMemory memory(all_others_layout.tables());
  Values roof_bar(memory.dictionary);
  roof_bar[roof_bar_light_command<"mlb1">] = Order::on;
  roof_bar[roof_bar_light_command<"af16">] = Order::off;
  EXPECT_EQ(memory.dictionary.number(0x6130, 1), 0xFFFF'FFFDU);
  EXPECT_EQ(memory.dictionary.number(0x6130, 5), 0x3FFF'FFFFU);
  EXPECT_FALSE(roof_bar[roof_bar_light_status<"rwf8">].is(Signal::on));
  roof_bar[icon_display_1_command_content[2]] = Icon::bell;
  EXPECT_EQ(memory.dictionary.number(0x60A6, 2), 0xFC2FU);  // 111'111'00001011'11b
}

TEST(Cia447Device, OfANumberTheSentinelsAreTakenFromTheBus) {
  DeviceMemory memory(gateway_layout.tables());
  for (const std::uint8_t code : std::to_array<std::uint8_t>({0x00, 0x64, 0xFE, 0xFF})) {
    EXPECT_EQ(memory.dictionary.write(0x6006, 0, {&code, 1}, Source::sdo), AbortCode::none)
        << +code;
  }
}

}  // namespace
}  // namespace canvoy::device_test
