// CiA 447-3: enumerators beside what the tables print for their codes: the car.
#include <gtest/gtest.h>

#include "canvoy/profiles/cia447/car_handles.hpp"
#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/roof_bar_handles.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"
#include "canvoy/profiles/cia447/testing/printed.hpp"

namespace canvoy::cia447::states_test {
namespace {

TEST(Cia447States, Signal) {
  using enum Signal;
  EXPECT_EQ(printed<Signal>(ignition_switch_status_lock, {no, yes, failure, not_available}),
            "Ignition not locked|Ignition locked (Key in)|Failure|Signal not available");
  EXPECT_EQ(printed<Signal>(ignition_switch_status_accessory, {no, yes, failure, not_available}),
            "No ignition accessory|Ignition accessory|Failure|Signal not available");
  EXPECT_EQ(printed<Signal>(ignition_switch_status_on, {no, yes, failure, not_available}),
            "Ignition off|Ignition on|Failure|Signal not available");
  EXPECT_EQ(printed<Signal>(ignition_switch_status_start, {no, yes, failure, not_available}),
            "No ignition start|Ignition start|Failure|Signal not available");
  EXPECT_EQ(printed<Signal>(buckle_switch_status_driver, {no, yes, failure, not_available}),
            "Seatbelt not fastened|Seatbelt fastened|Failure|Signal not available");
  EXPECT_EQ(printed<Signal>(car_light_status_day_time_running, {no, yes, failure, not_available}),
            "Off|On|Failure|Signal not available");
}

TEST(Cia447States, Order) {
  using enum Order;
  EXPECT_EQ(printed<Order>(wiper_system_command_front, {off, on, not_implemented, do_not_care}),
            "Switch the front wiper system off|Switch tip wiping on|Function not implemented|Don't "
            "care, take no action");
  EXPECT_EQ(
      printed<Order>(wiper_system_command_washer_front, {off, on, not_implemented, do_not_care}),
      "Switch the front washing off|Switch the front washing on|Function not implemented|Don't "
      "care, take no action");
  EXPECT_EQ(printed<Order>(wiper_system_command_rear, {off, on, not_implemented, do_not_care}),
            "Switch the rear wiper system off|Switch the rear wiper system on|Function not "
            "implemented|Don't care, take no action");
  EXPECT_EQ(
      printed<Order>(wiper_system_command_washer_rear, {off, on, not_implemented, do_not_care}),
      "Switch the rear washer system off|Switch the rear washer system on|Function not "
      "implemented|Don't care, take no action");
  EXPECT_EQ(printed<Order>(heating_and_air_conditioner_command_heat_front_window,
                           {off, on, not_implemented, do_not_care}),
            "Deactivate the function|Activate the function|Function not implemented|Don't care, "
            "take no action");
  EXPECT_EQ(printed<Order>(heating_and_air_conditioner_command_defrost_front_window,
                           {off, on, not_implemented, do_not_care}),
            "Deactivate the function|Defrost front window (fans on with full power)|Function not "
            "implemented|Don't care, take no action");
}

TEST(Cia447States, Locking) {
  using enum Locking;
  EXPECT_EQ(
      printed<Locking>(central_locking_system_status,
                       {unlocked, internal, external, selective_unlocked, failure, not_available}),
      "Vehicle unlocked|Vehicle internal locked|Vehicle external locked|Vehicle selective "
      "unlocked|Failure|Signal not available");
  EXPECT_EQ(printed<Locking>(
                central_locking_system_command,
                {unlocked, internal, external, selective_unlocked, not_implemented, do_not_care}),
            "Unlock vehicle|Lock vehicle internal|Lock vehicle external|Unlock vehicle "
            "selective|Function not implemented|Don't care, take no action");
}

TEST(Cia447States, Opening) {
  using enum Opening;
  EXPECT_EQ(printed<Opening>(window_status_driver, {open, closed, is_getting_open,
                                                    is_getting_closed, failure, not_available}),
            "Open|Closed|Is getting open|Is getting closed|Failure|Signal not available");
}

TEST(Cia447States, OpeningCommand) {
  using enum OpeningCommand;
  EXPECT_EQ(
      printed<OpeningCommand>(window_command_driver, {open, close, not_implemented, do_not_care}),
      "Open the window|Close the window|Function not implemented|Don't care, take no action");
  EXPECT_EQ(
      printed<OpeningCommand>(door_command_driver, {open, close, not_implemented, do_not_care}),
      "Open the door|Close the door|Function not implemented|Don't care, take no action");
}

TEST(Cia447States, Flap) {
  using enum Flap;
  EXPECT_EQ(printed<Flap>(car_flap_status_engine_hood, {closed, open, is_getting_closed,
                                                        is_getting_open, failure, not_available}),
            "Closed|Open|Is getting closed|Is getting open|Failure|Signal not available");
  EXPECT_EQ(printed<Flap>(car_flap_status_convertible_top,
                          {closed, open, is_getting_closed, is_getting_open, stopped, failure,
                           not_available}),
            "Closed|Open|Is getting closed|Is getting open|Stopped|Failure|Signal not available");
}

TEST(Cia447States, FlapCommand) {
  using enum FlapCommand;
  EXPECT_EQ(printed<FlapCommand>(car_flap_command_engine_hood,
                                 {close, open, not_implemented, do_not_care}),
            "Close|Open|Function not implemented|Don't care, take no action");
  EXPECT_EQ(
      printed<FlapCommand>(car_flap_command_convertible_top, {close, open, stop, do_not_care}),
      "Close|Open|Stop|Don't care, take no action");
}

TEST(Cia447States, SlidingRoof) {
  using enum SlidingRoof;
  EXPECT_EQ(
      printed<SlidingRoof>(car_flap_status_sliding_roof,
                           {closed, open_tilt, open_slide, is_getting_closed_tilt,
                            is_getting_closed_slide, is_getting_open_tilt, is_getting_open_slide,
                            stopped_tilt, stopped_slide, failure, not_available}),
      "Closed|Open (tilt)|Open (slide)|Is getting closed (tilt)|Is getting closed (slide)|Is "
      "getting open (tilt)|Is getting open (slide)|Stopped (tilt)|Stopped (slide)|Failure|Signal "
      "not available");
}

TEST(Cia447States, SlidingRoofCommand) {
  using enum SlidingRoofCommand;
  EXPECT_EQ(printed<SlidingRoofCommand>(car_flap_command_sliding_roof,
                                        {close_tilt, close_slide, open_tilt, open_slide, stop,
                                         not_implemented, do_not_care}),
            "Close (tilt)|Close (slide)|Open (tilt)|Open (slide)|Stop|Function not "
            "implemented|Don't care, take no action");
}

TEST(Cia447States, SeatMotion) {
  using enum SeatMotion;
  EXPECT_EQ(printed<SeatMotion>(seat_adjustment_command_forward_backward,
                                {forward, backward, not_implemented, do_not_care}),
            "Seat forward|Seat backward|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<SeatMotion>(seat_adjustment_command_tight_support_forward_backward,
                                {forward, backward, not_implemented, do_not_care}),
            "Seat tight support forward|Seat tight support backward|Function not implemented|Don't "
            "care, take no action");
  EXPECT_EQ(
      printed<SeatMotion>(seat_adjustment_command_back_forward_backward,
                          {forward, backward, not_implemented, do_not_care}),
      "Seat back forward|Seat back backward|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<SeatMotion>(seat_adjustment_status_forward_backward,
                                {forward, backward, failure, not_available}),
            "Seat is moving forward|Seat is moving backward|Failure|Signal not available");
  EXPECT_EQ(printed<SeatMotion>(seat_adjustment_status_tight_support_forward_backward,
                                {forward, backward, failure, not_available}),
            "Seat tight support forward|Seat tight support backward|Failure|Signal not available");
  EXPECT_EQ(
      printed<SeatMotion>(seat_adjustment_status_back_forward_backward,
                          {forward, backward, failure, not_available}),
      "Seat back is moving forward|Seat back is moving backward|Failure|Signal not available");
}

TEST(Cia447States, SeatHeight) {
  using enum SeatHeight;
  EXPECT_EQ(printed<SeatHeight>(seat_adjustment_command_up_down,
                                {up, down, not_implemented, do_not_care}),
            "Seat up|Seat down|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<SeatHeight>(seat_adjustment_command_headrest_up_down,
                                {up, down, not_implemented, do_not_care}),
            "Headrest up|Headrest down|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<SeatHeight>(seat_adjustment_status_up_down, {up, down, failure, not_available}),
            "Seat is moving up|Seat is moving down|Failure|Signal not available");
  EXPECT_EQ(printed<SeatHeight>(seat_adjustment_status_headrest_up_down,
                                {up, down, failure, not_available}),
            "Headrest is moving up|Headrest is moving down|Failure|Signal not available");
}

TEST(Cia447States, SeatAngle) {
  using enum SeatAngle;
  EXPECT_EQ(printed<SeatAngle>(seat_adjustment_command_angle_lift_sink,
                               {lift, sink, not_implemented, do_not_care}),
            "Seat angle lift|Seat angle sink|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<SeatAngle>(seat_adjustment_status_angle_lift_sink,
                               {lift, sink, failure, not_available}),
            "Seat angle lift|Seat angle sink|Failure|Signal not available");
}

TEST(Cia447States, SeatMemory) {
  using enum SeatMemory;
  EXPECT_EQ(printed<SeatMemory>(
                seat_adjustment_command_recall_memory,
                {none, memory_1, memory_2, memory_3, memory_4, not_implemented, do_not_care}),
            "Recall no memory|Recall Memory 1|Recall Memory 2|Recall Memory 3|Recall Memory "
            "4|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<SeatMemory>(
                seat_adjustment_command_store_memory,
                {none, memory_1, memory_2, memory_3, memory_4, not_implemented, do_not_care}),
            "Store no memory|Store Memory 1|Store Memory 2|Store Memory 3|Store Memory 4|Function "
            "not implemented|Don't care, take no action");
  EXPECT_EQ(
      printed<SeatMemory>(seat_adjustment_status_recall_memory,
                          {none, memory_1, memory_2, memory_3, memory_4, failure, not_available}),
      "No memory recalled|Memory 1 recalled|Memory 2 recalled|Memory 3 recalled|Memory 4 "
      "recalled|Failure|Signal not available");
  EXPECT_EQ(
      printed<SeatMemory>(seat_adjustment_status_store_memory,
                          {none, memory_1, memory_2, memory_3, memory_4, failure, not_available}),
      "No memory stored|Memory 1 stored|Memory 2 stored|Memory 3 stored|Memory 4 "
      "stored|Failure|Signal not available");
}

TEST(Cia447States, Wiper) {
  using enum Wiper;
  EXPECT_EQ(printed<Wiper>(wiper_system_status_front, {off, on, failure, not_available}),
            "Front wiper system is off|Tip wiping is on|Failure|Signal not available");
  EXPECT_EQ(printed<Wiper>(wiper_system_status_washer_front, {off, on, failure, not_available}),
            "Front washer system is off|Washing is on|Failure|Signal not available");
  EXPECT_EQ(printed<Wiper>(wiper_system_status_rear, {off, on, failure, not_available}),
            "Rear wiper system is off|Rear wiper system is on|Failure|Signal not available");
  EXPECT_EQ(printed<Wiper>(wiper_system_status_washer_rear, {off, on, failure, not_available}),
            "Rear washer system is off|Washing is on|Failure|Signal not available");
}

TEST(Cia447States, WiperSwitch) {
  using enum WiperSwitch;
  EXPECT_EQ(
      printed<WiperSwitch>(wiper_system_status_switch_position_front,
                           {off, interval, stage_1, stage_2, automatic, failure, not_available}),
      "Wiper switch stage 0 (off)|Wiper switch stage I (interval)|Wiper switch stage II (stage "
      "1)|Wiper switch stage III (stage 2)|Wiper switch automatic|Failure|Signal not available");
  EXPECT_EQ(printed<WiperSwitch>(
                wiper_system_command_switch_position_front,
                {off, interval, stage_1, stage_2, automatic, not_implemented, do_not_care}),
            "Stage 0 (off)|Stage I (interval)|Stage II (stage 1)|Stage III (stage "
            "2)|Automatic|Function not implemented|Don't care, take no action");
}

TEST(Cia447States, SteeringWheelSide) {
  using enum SteeringWheelSide;
  EXPECT_EQ(
      printed<SteeringWheelSide>(steering_wheel_angle_side, {left, right, failure, not_available}),
      "Steering wheel angle positive/left|Steering wheel angle negative/right|Failure|Signal not "
      "available");
}

TEST(Cia447States, TemperatureStep) {
  using enum TemperatureStep;
  EXPECT_EQ(printed<TemperatureStep>(heating_and_air_conditioner_command_temperature,
                                     {deactivate, warmer, colder, do_not_care}),
            "Deactivate the function|+ (0,5 °C)|- (0,5 °C)|Don't care, take no action");
}

TEST(Cia447States, Language) {
  using enum Language;
  EXPECT_EQ(
      printed<Language>(user_selected_language_command,
                        {german, english, french, italian, spanish, japanese, dutch, danish,
                         swedish, turkish, portuguese, russian, not_implemented, do_not_care}),
      "German|English|French|Italian|Spanish|Japanese|Dutch|Danish|Swedish|Turkish|Portuguese|"
      "Russian|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<Language>(user_selected_language_status,
                              {german, english, french, italian, spanish, japanese, dutch, danish,
                               swedish, turkish, portuguese, russian, failure, not_available}),
            "German|English|French|Italian|Spanish|Japanese|Dutch|Danish|Swedish|Turkish|"
            "Portuguese|Russian|Failure|Signal not available");
}

TEST(Cia447States, DayNight) {
  using enum DayNight;
  EXPECT_EQ(printed<DayNight>(day_night_detection, {day, night, failure, not_available}),
            "Day|Night|Failure|Signal not available");
  EXPECT_EQ(printed<DayNight>(sound_command_roof_bar_volume_day_night,
                              {day, night, not_implemented, do_not_care}),
            "Switch to day sound signal|Switch to night sound signal|Function not "
            "implemented|Don't care, take no action");
  EXPECT_EQ(printed<DayNight>(sound_status_roof_bar_volume_day_night,
                              {day, night, failure, not_available}),
            "Day sound signal is on|Night sound signal is on|Failure|Signal not available");
}

TEST(Cia447States, InteriorLight) {
  using enum InteriorLight;
  EXPECT_EQ(printed<InteriorLight>(car_interior_light_status_illumination,
                                   {off, on_dimmed, on_undimmed, failure, not_available}),
            "Off|On dimmed|On undimmed|Failure|Signal not available");
  EXPECT_EQ(printed<InteriorLight>(car_interior_light_command_illumination,
                                   {off, on_dimmed, on_undimmed, not_implemented, do_not_care}),
            "Off|On dimmed|On undimmed|Function not implemented|Don't care, take no action");
}

TEST(Cia447States, AntiTheft) {
  using enum AntiTheft;
  EXPECT_EQ(printed<AntiTheft>(anti_theft_warning_system_status,
                               {disabled, pre_active, active, triggered, failure, not_available}),
            "Disabled|Pre-active|Active|Triggered|Failure|Signal not available");
}

TEST(Cia447States, AntiTheftCommand) {
  using enum AntiTheftCommand;
  EXPECT_EQ(printed<AntiTheftCommand>(
                anti_theft_warning_system_command,
                {disable, do_not_trigger, activate, trigger, not_implemented, do_not_care}),
            "Disable|Do not trigger|Activate|Trigger|Function not implemented|Don't care, take no "
            "action");
}

TEST(Cia447States, Engine) {
  using enum Engine;
  EXPECT_EQ(printed<Engine>(engine_status, {off, ready, cranking, running, stalled, after_run,
                                            shutdown, failure, not_available}),
            "Engine is off|Engine is ready|Engine is cranking|Engine is running|Engine is "
            "stalled|After run|Shutdown|Failure|Signal not available");
}

TEST(Cia447States, SelectorLever) {
  using enum SelectorLever;
  EXPECT_EQ(
      printed<SelectorLever>(transmission_selector_lever_position,
                             {intermediate, position_1, position_2, position_3, position_4, driving,
                              neutral, reverse, parking, low, failure, not_available}),
      "Intermediate position|Position 1|Position 2|Position 3|Position 4|Normal driving position "
      "automatic (D)|Neutral position automatic (N)|Reverse position automatic (R)|Parking "
      "position automatic (P)/Key lock release|Position L (low)|Failure|Signal not available");
}

TEST(Cia447States, GearMode) {
  using enum GearMode;
  EXPECT_EQ(printed<GearMode>(automatic_gear_mode,
                              {manual, sport, comfort, winter, failure, not_available}),
            "Manual|Sport|Comfort|Winter|Failure|Signal not available");
}

TEST(Cia447States, Gear) {
  using enum Gear;
  EXPECT_EQ(printed<Gear>(engaged_gear, {none, first, second, third, fourth, fifth, sixth, seventh,
                                         eighth, reverse, failure, not_available}),
            "No gear|1st gear|2nd gear|3rd gear|4th gear|5th gear|6th gear|7th gear|8th "
            "gear|Reverse gear|Failure|Signal not available");
}

TEST(Cia447States, WheelSource) {
  using enum WheelSource;
  EXPECT_EQ(printed<WheelSource>(wheel_signal_source,
                                 {front_right, front_left, rear_right, rear_left, average_front,
                                  average_rear, average_all, failure, not_available}),
            "Front right wheel|Front left wheel|Rear right wheel|Rear left wheel|Average front "
            "wheels|Average rear wheels|Average all wheels|Failure|Signal not available");
}

TEST(Cia447States, FuelUnit) {
  using enum FuelUnit;
  EXPECT_EQ(printed<FuelUnit>(current_average_fuel_consumption_unit,
                              {litre, kilogram, failure, not_available}),
            "Liter|Kilogram|Failure|Signal not available");
}

TEST(Cia447States, Acceleration) {
  using enum Acceleration;
  EXPECT_EQ(printed<Acceleration>(cruise_control_command_accelerate_decelerate,
                                  {accelerate, decelerate, not_implemented, do_not_care}),
            "+ accelerate|- decelerate|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<Acceleration>(cruise_control_status_accelerate_decelerate,
                                  {accelerate, decelerate, failure, not_available}),
            "+ accelerating|- decelerating|Failure|Signal not available");
}

TEST(Cia447States, StoredSpeed) {
  using enum StoredSpeed;
  EXPECT_EQ(
      printed<StoredSpeed>(cruise_control_command_store, {stored, stored_as_maximum, released,
                                                          recalled, not_implemented, do_not_care}),
      "Store current speed|Store current speed as maximum|Release stored speed|Recall last stored "
      "speed|Function not implemented|Don't care, take no action");
  EXPECT_EQ(printed<StoredSpeed>(cruise_control_status_store, {stored, stored_as_maximum, released,
                                                               recalled, failure, not_available}),
            "Current speed is stored|Current speed is stored as maximum|Stored speed released|Last "
            "stored speed recalled|Failure|Signal not available");
}

TEST(Cia447States, FireExtinguishing) {
  using enum FireExtinguishing;
  EXPECT_EQ(printed<FireExtinguishing>(
                fire_extinguishing_system_status,
                {deactivated, standby, standby_limited, initialization, automatic_started,
                 manual_started, activated, failure, not_available}),
            "Deactivated|Standby without limitation|Standby with limited "
            "function|Initialization|Automatic started|Manual started|Activated|Failure|Signal not "
            "available");
}

TEST(Cia447States, FreshAir) {
  using enum FreshAir;
  EXPECT_EQ(printed<FreshAir>(
                emergency_fresh_air_system_status,
                {deactivated, standby, standby_limited, standby_without_sensors, initialization,
                 manual_started, manually_activated, automatic_activated, failure, not_available}),
            "Deactivated|Standby without limitation|Standby with limited function|Standby without "
            "sensory activation|Initialization|Manual started|Manually activated|Automatic "
            "activated|Failure|Signal not available");
}

}  // namespace
}  // namespace canvoy::cia447::states_test
