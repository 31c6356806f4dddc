// Typed access to all objects of CiA 407, in one device that has all of them: bytes by the clauses.
#include "canvoy/profiles/cia407/handles.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia407.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia407_handles_test {
namespace {

/// All application objects; of arrays of up to 254 the first entries.
constexpr auto make_everything() {
  DeviceDescription<110> parts;
  for (const ObjectInfo* object : cia407::profile.objects) {
    constexpr unsigned enough = 8;
    const bool is_long = object->code == ObjectCode::array;
    if (object->index < 0x6000) continue;
    parts.add(is_long ? Part(*object).up_to(enough) : Part(*object));
  }
  return parts;
}
constexpr auto everything = describe(make_everything());
constexpr auto layout = lay_out_device<everything>();

class Cia407Handles : public testing::Test {
 protected:
  std::uint64_t number(unsigned index, unsigned sub = 0) const {
    return memory_.dictionary.number(static_cast<std::uint16_t>(index),
                                     static_cast<std::uint8_t>(sub));
  }
  void set(unsigned index, unsigned sub, std::uint64_t value) {
    ASSERT_TRUE(memory_.dictionary.set_number(static_cast<std::uint16_t>(index),
                                              static_cast<std::uint8_t>(sub), value));
  }
  template <class... Handles>
  void expect_to_exist(const Handles&... handles) {
    unsigned position = 0;
    const auto expect = [&](bool exists) { EXPECT_TRUE(exists) << "handle " << position++; };
    (expect(values_[handles].exists()), ...);
  }

  DeviceMemory memory_{layout.tables()};
  Values values_{memory_.dictionary};
};

TEST_F(Cia407Handles, PointToEntriesOfTheVehicle) {
  using namespace cia407;
  expect_to_exist(vehicle_id, body_id, garage_id, radio_id, vehicle_class, number_of_vehicle_units,
                  driver_schedule_number, route_destination_id, journey_direction, stop_point_id,
                  number_of_running_in_route_representation, text_line_route_description(1),
                  text_of_destination(8), local_year, local_day, local_month, local_hour,
                  local_minute, local_second, time_standby, route_segment_number, fare_zone,
                  text_of_stop_point(3), previous_route_segment, previous_fare_zone, scheduled_year,
                  scheduled_day, scheduled_month, scheduled_hour, scheduled_minute,
                  scheduled_second, blocking_of_ticket_canceller, traffic_light_priority_request,
                  inside_temperature, car_mileage, car_mileage_calibration_information,
                  vehicle_id_text, body_id_text, garage_id_text, radio_id_text, stop_point_id_text,
                  route_destination_id_text, driver_schedule_number_text, vehicle_speed, driver_id,
                  destination_number, line_id, route_number, block_id, journey_number, line_id_text,
                  block_id_text, driver_id_text);
}

TEST_F(Cia407Handles, PointToEntriesOfDisplaysAndSensors) {
  using namespace cia407;
  expect_to_exist(xml_file(2), display_update, display_update_manufacturer, mapped_object(1),
                  mapped_index_msb(2), mapped_index_lsb(2), mapped_sub_index(7), flash_speed(1),
                  font_style(1), alignment(1), font_size(1), bus_stop_request,
                  selected_character_set, available_character_set(1), available_character_set(7),
                  wheel_based_vehicle_speed, vehicle_mileage, vehicle_mileage_precision,
                  direction_flag, drive_flag, compass_bearing, compass_bearing_precision, all_doors,
                  left_side_doors, right_side_doors, door<1>, door<28>, door_validity<5>,
                  ambient_air_temperature, fuel_rate, instantaneous_fuel_economy,
                  average_fuel_economy, total_fuel_used, trip_fuel, total_idle_fuel_used,
                  brake_switch, engine_coolant_temperature, total_idle_hours, total_vehicle_hours,
                  total_engine_hours, total_power_takeoff_hours, tachograph_speed,
                  direction_indication, drive_recognition, total_vehicle_distance, trip_distance,
                  tachograph_local_hour, tachograph_local_minute, tachograph_year, tachograph_day,
                  tachograph_month, tachograph_hour, tachograph_minute, tachograph_second,
                  driver_1_card, driver_2_card, driver_1_driving_time, driver_2_driving_time);
}

TEST_F(Cia407Handles, PointToEntriesOfPositionCountersDiagnosticsAndInputs) {
  using namespace cia407;
  expect_to_exist(
      latitude, longitude, position_precision, gps_based_speed, gps_based_heading, gps_mileage,
      gps_mileage_precision, universal_local_hour, universal_local_minute, universal_year,
      universal_day, universal_month, universal_hour, universal_minute, universal_second,
      flag_direction_forward_selection, incoming_passengers_of_door, outgoing_passengers_of_door,
      total_incoming_passengers, total_outgoing_passengers, counter_passenger_sum,
      passenger_capacity_usage, number_of_errors, short_error_code(1), short_error_device(8),
      number_of_class_1_messages, number_of_class_2_messages, number_of_class_3_messages,
      class_1_message(1), class_2_message(2), class_3_message(8), digital_inputs, digital_outputs,
      analogue_input_1(1), analogue_input_2(4), analogue_output_1(1), analogue_output_2(4),
      supported_virtual_device(1), supported_virtual_device_class(2),
      supported_virtual_device_subclass(8), event_at_sub);
}

TEST_F(Cia407Handles, PointToEvents) {
  using namespace cia407;
  expect_to_exist(
      state_information(1), display_in_test_mode(2), information_cannot_be_displayed(7),
      send_state_information(1), enter_test_mode(8), driver_to_indoor_loudspeakers(1),
      driver_to_outdoor_loudspeakers(1), driver_to_voice_radio(1),
      attendant_to_indoor_loudspeakers(1), voice_radio_to_indoor_loudspeakers(1),
      acoustic_state_information(1), switch_driver_to_indoor_loudspeakers(1),
      switch_driver_to_outdoor_loudspeakers(1), switch_driver_to_voice_radio(1),
      switch_attendant_to_indoor_loudspeakers(1), switch_voice_radio_to_indoor_loudspeakers(1),
      send_acoustic_state_information(1), many_passengers_counted(1),
      close_to_passenger_capacity(1), passenger_capacity_warning(1), many_short_errors(1),
      short_errors_close_to_capacity(1), many_class_1_messages(1), many_class_2_messages(1),
      many_class_3_messages(1), reset_trip_distance(1), adjust_local_hour(1),
      adjust_local_minute(1), event_from_code(1), event_for_code(8), event_from_manufacturer(1),
      event_for_manufacturer(1), event_flags_from(1), event_flags_for(1));
}

TEST_F(Cia407Handles, AnEventIsABitBesideTheCodeOfItsVirtualDevice) {  // 9.2.4, 9.2.5
  values_[cia407::event_from_code(2)] = cia407::DeviceCode::passenger_information;
  values_[cia407::event_from_manufacturer(2)] = 0xABCD;
  values_[cia407::display_in_test_mode(2)] = cia407::Event::pending;
  EXPECT_EQ(number(0x6001, 3), 0x03AB'CD02U) << "the 2nd virtual device is at sub-index 03h";
  values_[cia407::event_for_code(2)] = cia407::DeviceCode::tachograph;
  values_[cia407::adjust_local_minute(2)] = cia407::Event::pending;
  EXPECT_EQ(number(0x6002, 2), 0x0C00'0004U);
  set(0x6001, 4, 0x0800'0040);
  EXPECT_TRUE(values_[cia407::acoustic_state_information(3)].is(cia407::Event::pending));
  EXPECT_TRUE(values_[cia407::event_from_code(3)].is(cia407::DeviceCode::acoustic_control_manager));
}

TEST_F(Cia407Handles, ShortNamesAreCharactersWithZerosBehind) {  // 9.2.6.12, 9.2.6.25
  values_[cia407::line_short_representation] = "U8";
  EXPECT_EQ(number(0x610B, 1), 'U');
  EXPECT_EQ(number(0x610B, 2), '8');
  EXPECT_EQ(number(0x610B, 3), 0U);
  char buffer[8];
  EXPECT_EQ(values_[cia407::line_short_representation].value(buffer), "U8");
  values_[cia407::stop_point_short_representation] = "MAINSTATION";
  EXPECT_EQ(values_[cia407::stop_point_short_representation].value(buffer), "MAINSTAT");
}

TEST_F(Cia407Handles, TextsAreNumberedFrom1) {
  values_[cia407::text_of_destination(2)] = "Airport";
  EXPECT_EQ(values_[cia407::text_of_destination(2)].value(), "Airport");
  EXPECT_EQ(values_[cia407::text_of_destination(1)].value(), "");
  EXPECT_EQ(memory_.dictionary.find(0x610D, 2)->bytes().size(), 7U);
}

TEST_F(Cia407Handles, TimesAreInTheStepsOfTheText) {  // 9.2.6.15
  EXPECT_FALSE(values_[cia407::local_year].is_valid()) << "FFh from the start";
  values_[cia407::local_year] = 2026;
  values_[cia407::local_day] = 21.75;
  values_[cia407::local_second] = 30.5;
  EXPECT_EQ(number(0x610E, 1), 41U);
  EXPECT_EQ(number(0x610E, 2), 87U);
  EXPECT_EQ(number(0x610E, 6), 122U);
  values_[cia407::local_month] = 11;
  EXPECT_EQ(values_[cia407::local_month].value(), 11);
  values_[cia407::tachograph_local_hour] = -1;
  EXPECT_EQ(number(0x6523, 1), 0xFFU);
  EXPECT_EQ(number(0x6115, 2), 1U) << "there is no day 0";
}

TEST_F(Cia407Handles, DoorsAreFourInAByteFromTheTop) {  // 9.2.15.7
  values_[cia407::door<1>] = cia407::Door::open;
  values_[cia407::door_validity<1>] = cia407::Validity::valid;
  EXPECT_EQ(number(0x6488, 2), 0xC0U);
  values_[cia407::door<8>] = cia407::Door::open;
  values_[cia407::door_validity<6>] = cia407::Validity::valid;
  EXPECT_EQ(number(0x6488, 3), 0x12U);
  EXPECT_EQ(cia407::door<1012>.sub(), 0xFE);
  values_[cia407::left_side_doors] = cia407::Release::released;
  EXPECT_EQ(number(0x6488, 1), 0x40U);
}

TEST_F(Cia407Handles, WhatIsShownHasItsFormatInTheHighestByte) {  // 9.2.8.4
  EXPECT_EQ(number(0x6203, 2), 0x000C'6101U) << "610Ch, the first text";
  EXPECT_EQ(number(0x6203, 3), 0x0012'6101U) << "6112h, the first text";
  values_[cia407::flash_speed(1)] = cia407::FlashSpeed::medium;
  values_[cia407::font_style(1)] = cia407::FontStyle::bold;
  values_[cia407::alignment(1)] = cia407::Alignment::right;
  values_[cia407::font_size(1)] = cia407::FontSize::small;
  EXPECT_EQ(number(0x6203, 2), 0xAD0C'6101U);
  values_[cia407::display_update] = 3;
  EXPECT_EQ(number(0x6203, 1), 3U);
}

TEST_F(Cia407Handles, QuantitiesAreInTheirUnits) {
  values_[cia407::inside_temperature] = 21.5;
  EXPECT_EQ(number(0x6119), 215U);
  values_[cia407::ambient_air_temperature] = -10;
  EXPECT_EQ(number(0x6489), 8416U) << "263 K below 273, in 32nds";
  values_[cia407::wheel_based_vehicle_speed] = 300;
  EXPECT_EQ(number(0x6481), 0xFAFFU) << "stays within the range";
  values_[cia407::wheel_based_vehicle_speed] = std::nullopt;
  EXPECT_EQ(number(0x6481), 0xFFFFU);
  values_[cia407::latitude] = 52.5200066;
  EXPECT_EQ(number(0x6660, 1), 2'625'200'066U);
  values_[cia407::longitude] = -0.0000001;
  EXPECT_EQ(number(0x6660, 2), 2'099'999'999U);
  values_[cia407::analogue_input_1(1)] = -2;
  EXPECT_EQ(number(0x6762, 1), 0xFFFE'0000U);
}

TEST_F(Cia407Handles, TellTheFirstOfSeveralLogicalDevices) {
  // 9.2.30.1 and 8.1.1: a destination indicator (class 1) with text (subclass 2) is 0312'0197h.
  set(0x67FF, 0, 0x0312'0197);
  EXPECT_EQ(values_[cia407::first_device_type].value(), 0x0312'0197);
  EXPECT_EQ(values_[cia407::first_device_type_profile].value(), 407);
  EXPECT_EQ(values_[cia407::first_device_type_subclass].value(), 2);
  EXPECT_EQ(values_[cia407::first_device_type_class].value(), 1);
  EXPECT_TRUE(
      values_[cia407::first_device_type_code].is(cia407::DeviceCode::passenger_information));
}

}  // namespace
}  // namespace canvoy::cia407_handles_test
