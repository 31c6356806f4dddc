// Values of a lift by name: each handle reads and writes the bits of its clause, typed from the
// text.
#include "canvoy/profiles/cia417/handles.hpp"

#include <gtest/gtest.h>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia417.hpp"
#include "canvoy/profiles/model/assembled.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::cia417_handles_test {
namespace {

using namespace cia417;  // NOLINT(google-build-using-namespace): all names here are its own

constexpr auto panels = describe(
    virtual_input_mapping_object, virtual_output_mapping_object, virtual_sensor_mapping_object,
    Part(input_group_object).only(2).up_to(17), Part(output_group_object).only(31).up_to(2),
    Part(input_parameter_1_object).only(2).up_to(2),
    Part(input_parameter_3_object).only(2).up_to(2),
    Part(output_parameter_4_object).only(0).up_to(1));
constexpr auto panels_layout = lay_out_device<panels>();

constexpr auto car = describe(
    lift_number_object, door_controlword_object, door_statusword_object, door_position_object,
    door_configuration_object, light_barrier_status_object, load_value_object,
    load_signaling_object, position_value_object, measuring_step_settings_object,
    speed_value_car_object, Part(cam_state_object).up_to(2),
    Part(work_area_low_limit_3_object).up_to(2), Part(area_state_object).up_to(2),
    module_identification_4_object, operating_parameter_object, operating_status_object,
    supported_warnings_object, warnings_object, supported_alarms_object, alarms_object,
    Part(load_value_object).moved(2 * 0x800), Part(door_statusword_object).moved(7 * 0x800));
constexpr auto car_layout = lay_out_device<car>();

constexpr auto drive =
    describe(controlword_object, statusword_object, modes_of_operation_object,
             control_option_codes_object, target_velocity_object, profile_jerk_object,
             gear_ratio_object, velocity_window_object, polarity_object);
constexpr auto drive_layout = lay_out_device<drive>();

struct Cia417Panels : testing::Test {
  DeviceMemory memory{panels_layout.tables()};
  Dictionary& dictionary = memory.dictionary;
  Values values{dictionary};
};

TEST_F(Cia417Panels, ACallIsAssembledAndWrittenAtOnce) {
  constexpr auto call = Assembled(next_input.whole)
                            .set(next_input.function, BasicFunction::standard_hall_call)
                            .set(next_input.hall_call_up, true)
                            .set(next_input.source_lift<1>, true)
                            .set(next_input.source_panel, 5)
                            .set(next_input.source_door<1>, true)
                            .set(next_input.call_request, CallRequest::request);
  static_assert(call.raw() == 0x01'10'05'01'01'02);
  values[next_input.whole] = call.raw();
  EXPECT_EQ(dictionary.number(0x6010, 0), 0x01'10'05'01'01'02U);
  EXPECT_TRUE(values[next_input.function].is(BasicFunction::standard_hall_call));
  EXPECT_TRUE(values[next_input.hall_call_up].is_set());
  EXPECT_FALSE(values[next_input.hall_call_down].is_set());
  EXPECT_TRUE(values[next_input.source_lift<1>].is_set());
  EXPECT_FALSE(values[next_input.source_lift<8>].is_set());
  EXPECT_EQ(values[next_input.source_panel].value(), 5);
  EXPECT_TRUE(values[next_input.call_request].is(CallRequest::request));
  EXPECT_FALSE(values[next_input.lock].is_set());
}

TEST_F(Cia417Panels, FieldsOfInputsOfAGroupAreFoundByGroupAndNumber) {
  values[input.function(3, 17)] = BasicFunction::high_priority_car_call;
  values[input.target_stop(3, 17)] = 254;
  values[input.source_lift<8>(3, 17)] = true;
  values[input.destination_door<4>(3, 17)] = true;
  values[input.lock(3, 17)] = true;
  EXPECT_EQ(dictionary.number(0x6102, 17), 0x80'08'00'80'FE'07U);
  EXPECT_EQ(dictionary.number(0x6102, 16), 0U);
}

TEST_F(Cia417Panels, AFloorThatIsReservedIsNoValue) {
  dictionary.set_number(0x6010, 0, 0xFF00'0000);
  EXPECT_FALSE(values[next_input.source_panel].value().has_value());
  dictionary.set_number(0x6011, 0, 0xFF00'0000);
  EXPECT_EQ(values[next_output.destination_panel].value(), 0xFF);
}

TEST_F(Cia417Panels, AnOutputFlashesOrShinesAsItsPropertySays) {
  values[output.function(32, 2)] = BasicFunction::hall_lantern;
  values[output.down(32, 2)] = true;
  values[output.moving(32, 2)] = true;
  values[output.status(32, 2)] = true;
  values[output.property(32, 2)] = Property::flashing;
  values[output.flash_frequency(32, 2)] = 0.25;
  EXPECT_EQ(dictionary.number(0x621F, 2), 0x77'00'00'00'12'41U);
  EXPECT_EQ(values[output.flash_frequency(32, 2)].value(), 0.25);
  values[output.property(32, 2)] = Property::impulse;
  values[output.impulse_time(32, 2)] = 2;
  EXPECT_EQ(dictionary.number(0x621F, 2) >> 40, 0b0'011'010'1U);
  values[output.color(32, 2)] = Color::blue;
  EXPECT_EQ(dictionary.number(0x621F, 2) >> 40, 0b0'111'010'1U);
}

/// 4.4.1: the two columns of the table, typed from it.
TEST_F(Cia417Panels, TimesAndFrequenciesOfAnOutputAreThoseOfTheTable) {
  constexpr double seconds[] = {0.5, 1, 1.5, 2, 3, 5, 10, 15};
  constexpr double hertz[] = {10, 7.5, 5, 2, 1.5, 1, 0.5, 0.25};
  for (unsigned code = 0; code < 8; ++code) {
    values[next_output.impulse_time] = seconds[code];
    EXPECT_EQ(dictionary.number(0x6011, 0), std::uint64_t{code} << 44);
    EXPECT_EQ(values[next_output.impulse_time].value(), seconds[code]);
    values[next_output.flash_frequency] = hertz[code];
    EXPECT_EQ(dictionary.number(0x6011, 0), std::uint64_t{code} << 44);
    EXPECT_EQ(values[next_output.flash_frequency].value(), hertz[code]);
  }
}

TEST_F(Cia417Panels, ASensorValueHasASign) {
  values[next_sensor.function] = SensorFunction::temperature;
  values[next_sensor.signal] = SensorSignal::set;
  values[next_sensor.value] = -100;
  EXPECT_EQ(dictionary.number(0x6012, 0), 0xFE71'00'00'00'06U);
  values[next_sensor.value] = -8193;
  EXPECT_EQ(values[next_sensor.value].value(), -8192);
}

TEST_F(Cia417Panels, ParametersAreNotUsedUntilTheyAreSet) {
  EXPECT_TRUE(values[input_enabled(3, 1)].is_set()) << "errata A24";
  EXPECT_FALSE(values[input_debounce_time(3, 2)].value().has_value());
  values[input_debounce_time(3, 2)] = 20;
  values[input_inverted(3, 2)] = false;
  EXPECT_EQ(dictionary.number(0x6162, 2), 0xFFFF7F14U);
  values[output_flash_rate(1, 1)] = 7.5;
  EXPECT_EQ(dictionary.number(0x6280, 1), 0xFFFFFF4BU);
}

struct Cia417Car : testing::Test {
  DeviceMemory memory{car_layout.tables()};
  Dictionary& dictionary = memory.dictionary;
  Values values{dictionary};
};

TEST_F(Cia417Car, ADoorTakesCommandsOneByOne) {
  values[door_command(2)] = DoorCommand::open_with_limit_force;
  values[door_velocity(2)] = DoorVelocity::reduced;
  values[motion_detector_command(2)] = Disabling::disable;
  values[battery_power_command(2)] = Enabling::enable;
  EXPECT_EQ(dictionary.number(0x6300, 2), 0b0100'01'01'11'11'01'11U);
  EXPECT_EQ(dictionary.number(0x6300, 1), 0xFFFFU);
  EXPECT_TRUE(values[door_lock_command(2)].is(Disabling::no_action));
}

TEST_F(Cia417Car, ADoorSaysWhatItDoesAndSees) {
  EXPECT_TRUE(values[door_state(4)].is(DoorState::not_available));
  EXPECT_FALSE(values[door_position(4)].value().has_value());
  dictionary.set_number(0x6301, 4, 0x5D21);
  dictionary.set_number(0x6302, 4, 650);
  EXPECT_TRUE(values[door_state(4)].is(DoorState::opening));
  EXPECT_TRUE(values[force_limit(4)].is(Detection::not_available));
  EXPECT_TRUE(values[motion_detector(4)].is(Detection::yes));
  EXPECT_TRUE(values[finger_protector(4)].is(Detection::no));
  EXPECT_TRUE(values[door_lock(4)].is(Detection::error));
  EXPECT_TRUE(values[safety_contact(4)].is(Detection::yes));
  EXPECT_EQ(values[door_position(4)].value(), 650);
  values[light_barrier_status(3)] = Detection::yes;
  EXPECT_EQ(dictionary.number(0x6310, 3), 0x7FU);
}

TEST_F(Cia417Car, ADoorIsConfiguredByItsNumber) {
  values[light_barrier_modus(4)] = DoorReaction::turn;
  values[light_barrier_broken_reclose(4)] = 30;
  values[heartbeat_loss(1)] = HeartbeatLoss::close_with_reduced_speed;
  EXPECT_EQ(dictionary.number(0x6307, 4), 1U);
  EXPECT_EQ(dictionary.number(0x6307, 0x0A), 15U);
  EXPECT_EQ(dictionary.number(0x6304, 0x0B), 2U);
}

TEST_F(Cia417Car, APositionIsACountOfMeasuringSteps) {
  dictionary.set_number(0x6383, 4, 123456);
  EXPECT_DOUBLE_EQ(values[measuring_step(4)].value().value_or(0), 100);
  EXPECT_DOUBLE_EQ(values[speed_measuring_step(4)].value().value_or(0), 1);
  values[measuring_step(4)] = 500;
  EXPECT_EQ(dictionary.number(0x6387, 1), 50U);
  EXPECT_EQ(values[position_value(4)].value(), 123456U);
  dictionary.set_number(0x6390, 2, 0xFFFF);
  EXPECT_EQ(values[speed_value(2)].value(), -1);
}

TEST_F(Cia417Car, WorkAreasAndCamsAreOfUnitsAndChannels) {
  values[work_area_low_limit(3, 2)] = -5;
  EXPECT_EQ(dictionary.number(0x63B6, 2), 0xFFFF'FFFBU);
  dictionary.set_number(0x63B1, 2, 0b010);
  EXPECT_TRUE(values[range_overflow(2, 2)].is_set());
  EXPECT_FALSE(values[range_overflow(1, 2)].is_set());
  dictionary.set_number(0x63A0, 2, 0x80);
  EXPECT_TRUE(values[is_on_cam<8>(2)].is_set());
  EXPECT_FALSE(values[is_on_cam<7>(2)].is_set());
  dictionary.set_number(0x63D3, 3, 99);
  EXPECT_EQ(values[manufacturer_maximum(4)].value(), 99U);
  dictionary.set_number(0x63C7, 2, 1);
  EXPECT_TRUE(values[position_error(2)].is_set());
}

TEST_F(Cia417Car, TheLoadIsInKilogramsOrNotThere) {
  EXPECT_FALSE(values[absolute_load_value].value().has_value());
  values[absolute_load_value] = 630;
  EXPECT_EQ(dictionary.number(0x6480, 1), 630U);
  values[full_load_reached] = true;
  EXPECT_EQ(dictionary.number(0x6482, 1), 0b0100U);
  EXPECT_TRUE(values[overload_interrupt].is_set());
}

TEST_F(Cia417Car, AnotherLiftIsABlockAbove) {
  values[in_lift(3, absolute_load_value)] = 75;
  EXPECT_EQ(dictionary.number(0x7480, 1), 75U);
  values[in_lift(8, door_state(2))] = DoorState::stopped;
  EXPECT_EQ(dictionary.number(0x9B01, 2) >> 12, 7U);
  values[belongs_to_lift<3>] = true;
  EXPECT_EQ(values[lift_numbers].value(), 0b101U);
}

struct Cia417Drive : testing::Test {
  DeviceMemory memory{drive_layout.tables()};
  Dictionary& dictionary = memory.dictionary;
  Values values{dictionary};
};

TEST_F(Cia417Drive, IsControlledByBitsAndSaysItsState) {
  values[switch_on] = true;
  values[enable_voltage] = true;
  values[no_quick_stop] = true;
  values[enable_operation] = true;
  EXPECT_EQ(dictionary.number(0x6400, 0), 0x0FU);
  dictionary.set_number(0x6401, 0, 0x1637);
  EXPECT_EQ(drive_state(values[statusword].raw()), DriveState::operation_enabled);
  EXPECT_TRUE(values[target_reached].is_set());
  EXPECT_TRUE(values[set_point_acknowledge].is_set());
  EXPECT_FALSE(values[following_error].is_set());
}

TEST_F(Cia417Drive, HasSettingsAndTargets) {
  values[modes_of_operation] = DriveMode::profile_velocity;
  values[target_velocity] = -1500;
  values[quick_stop_option] = StopReaction::quick_stop_ramp_and_stay;
  values[profile_jerk(6)] = 42;
  values[velocity_window_time] = 250;
  values[position_reversed] = true;
  EXPECT_EQ(dictionary.number(0x6403, 0), 3U);
  EXPECT_EQ(dictionary.number(0x6430, 0), 0xFFFF'FA24U);
  EXPECT_EQ(dictionary.number(0x6402, 3), 6U);
  EXPECT_EQ(dictionary.number(0x640D, 6), 42U);
  EXPECT_EQ(dictionary.number(0x6435, 2), 250U);
  EXPECT_EQ(dictionary.number(0x641E, 0), 0x80U);
  EXPECT_EQ(values[gear_ratio.numerator].value(), 1U);
}

TEST_F(Cia417Drive, HasBitsOfItsMakerAndOfItsMode) {
  // CiA 402: bits 11 to 15 and bit 9 of the controlword, bits 8, 14 and 15 of the statusword.
  values[manufacturer_control] = 0x1F;
  values[operation_mode_specific] = true;
  EXPECT_EQ(dictionary.number(0x6400, 0), 0xFA00U);
  values[manufacturer_status] = true;
  values[manufacturer_status_bits] = 2;
  EXPECT_EQ(dictionary.number(0x6401, 0), 0x8100U);
}

TEST_F(Cia417Car, HasBitsOfTheMakerOfEachPositionUnit) {
  // CiA 406: bits 12 to 15 of the operating parameter and its status, of warnings and alarms.
  const auto expect = [this](const auto& handle, std::uint16_t index) {
    values[handle(3)] = 0xA;
    EXPECT_EQ(dictionary.number(index, 3), 0xA000U) << index;
  };
  expect(manufacturer_operating_parameter, 0x6380);
  expect(manufacturer_operating_status, 0x63C0);
  expect(manufacturer_supported_warnings, 0x63C4);
  expect(manufacturer_warnings, 0x63C5);
  expect(manufacturer_supported_alarms, 0x63C6);
  expect(manufacturer_alarms, 0x63C7);
}

}  // namespace
}  // namespace canvoy::cia417_handles_test
