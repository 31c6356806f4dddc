#include "canvoy/profiles/model/handle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia419.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::handle_test {
namespace {

// Objects as in other profiles: several fields in an entry, odd sizes, signs, offsets, several
// sentinels, arrays, texts, reals.

enum class Lock : std::uint8_t { open = 0, closed = 1, no_action = 3 };
constexpr NamedValue lock_names[] = {{Lock::open, "open"},
                                     {Lock::closed, "closed"},
                                     {2, "reserved", Meaning::reserved},
                                     {Lock::no_action, "no action"}};
constexpr NamedValue angle_names[] = {{0x3FFE, "failure", Meaning::failure},
                                      {0x3FFF, "not available", Meaning::invalid}};
constexpr FieldInfo door_fields[] = {
    {.first_bit = 0,
     .bits = 14,
     .name = "angle",
     .value = {.unit = Unit::degree,
               .scale = {.denominator = 10, .offset = -8000},
               .names = angle_names}},
    {.first_bit = 14, .bits = 2, .name = "lock", .value = {.names = lock_names}},
    {.first_bit = 16, .bits = 7, .name = "offset", .is_signed = true},
    {.first_bit = 23, .bits = 1, .name = "alarm"},
};
constexpr ObjectInfo door_object = {.index = 0x6100,
                                    .name = "door",
                                    .entry = {.type = DataType::unsigned24, .fields = door_fields}};

constexpr NamedValue byte_names[] = {{0xFB, 0xFD, "reserved", Meaning::reserved},
                                     {0xFE, "failure", Meaning::failure},
                                     {0xFF, "not available", Meaning::invalid}};
constexpr ObjectInfo level_object = {
    .index = 0x6101,
    .name = "level",
    .entry = {.value = {.unit = Unit::litre, .scale = {.denominator = 2}, .names = byte_names}}};
constexpr ObjectInfo speed_object = {
    .index = 0x6102,
    .name = "speed",
    .entry = {.type = DataType::real32, .value = {.unit = Unit::metre_per_second}}};
constexpr ObjectInfo mass_object = {
    .index = 0x6103,
    .name = "mass",
    .entry = {.type = DataType::real64,
              .value = {.unit = Unit::kilogram, .scale = {.denominator = 1000}}}};
constexpr ObjectInfo driver_object = {
    .index = 0x6104,
    .name = "driver",
    .entry = {.type = DataType::visible_string, .access = Access::rw, .capacity = 8}};
constexpr ObjectInfo counter_object = {
    .index = 0x6105, .name = "counter", .entry = {.type = DataType::unsigned64}};
constexpr ObjectInfo position_object = {
    .index = 0x6106,
    .name = "position",
    .entry = {.type = DataType::integer24, .value = {.limits = within(-1000, 1000)}}};
constexpr ObjectInfo switch_object = {
    .index = 0x6107, .name = "switch", .entry = {.type = DataType::boolean}};
constexpr EntryInfo input_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1, .sub_last = 254, .name = "input", .type = DataType::unsigned48}};
constexpr ObjectInfo inputs_object = {.index = 0x6200,
                                      .count = 32,
                                      .code = ObjectCode::array,
                                      .name = "inputs",
                                      .subs = input_entries};
constexpr EntryInfo lamp_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 11, .sub_last = 14, .name = "lamp #", .first_number = 3}};
constexpr ObjectInfo lamps_object = {
    .index = 0x6220, .code = ObjectCode::array, .name = "lamps", .subs = lamp_entries};
constexpr ObjectInfo absent_object = {
    .index = 0x6F00, .name = "absent", .entry = {.value = {.unit = Unit::volt}}};

constexpr Quantity<door_object, "", "angle"> angle;
constexpr State<Lock, door_object, "", "lock"> lock;
constexpr Number<door_object, "", "offset"> offset;
constexpr Flag<door_object, "", "alarm"> alarm;
constexpr Quantity<level_object> level;
constexpr Quantity<speed_object> speed;
constexpr Quantity<mass_object> mass;
constexpr Text<driver_object> driver;
constexpr Number<counter_object> counter;
constexpr Number<position_object> position;
constexpr Flag<switch_object> the_switch;
constexpr Number<inputs_object, "input"> input;
constexpr Number<lamps_object, "lamp #"> lamp;
constexpr Quantity<absent_object> absent;

constexpr auto device =
    describe(cia419::charger({.rpdo2 = true, .rpdo3 = true, .tpdo2 = true, .tpdo3 = true}),
             cia301::identity({.vendor_id = 1}), cia301::heartbeat_producer(1000), door_object,
             level_object, speed_object, mass_object, driver_object, counter_object,
             position_object, switch_object, inputs_object, lamps_object);
constexpr auto layout = lay_out_device<device>();

struct Handles : testing::Test {
  DeviceMemory memory{layout.tables()};
  Dictionary& dictionary = memory.dictionary;
  Values values{dictionary};
};

TEST_F(Handles, APhysicalValueIsWrittenInStepsOfItsScale) {
  values[cia419::battery_temperature] = 21.5;
  EXPECT_EQ(dictionary.number(0x6010, 0), 172U);
  values[cia419::battery_temperature] = -40;
  EXPECT_EQ(dictionary.number(0x6010, 0), 0xFEC0U);
  values[cia419::battery_voltage] = 24.0;
  EXPECT_EQ(dictionary.number(0x6060, 0), 24576U);
  values[cia419::charge_current_requested] = 12.5;
  EXPECT_EQ(dictionary.number(0x6070, 0), 200U);
}

TEST_F(Handles, AValueBetweenTwoStepsIsRoundedToTheNearest) {
  values[cia419::battery_temperature] = 21.06;
  EXPECT_EQ(values[cia419::battery_temperature].raw(), 168);
  values[cia419::battery_temperature] = 21.07;
  EXPECT_EQ(values[cia419::battery_temperature].raw(), 169);
  values[cia419::battery_temperature] = -21.07;
  EXPECT_EQ(values[cia419::battery_temperature].raw(), -169);
}

TEST_F(Handles, ASentinelIsNoValueAndNoValueIsTheSentinel) {
  EXPECT_EQ(values[cia419::battery_temperature].value(), std::nullopt);
  EXPECT_FALSE(values[cia419::battery_temperature].is_valid());
  values[cia419::battery_temperature] = 0;
  EXPECT_EQ(values[cia419::battery_temperature].value(), 0.0);
  values[cia419::battery_temperature] = std::nullopt;
  EXPECT_EQ(dictionary.number(0x6010, 0), 0xFFFFU);
  values[cia419::battery_voltage] = std::optional<double>(1.0);
  EXPECT_EQ(values[cia419::battery_voltage].value(), 1.0);
  values[cia419::battery_voltage] = std::optional<double>();
  EXPECT_EQ(dictionary.number(0x6060, 0), 0xFFFF'FFFFU);
  values[cia419::battery_voltage] = 3.0;
  values[cia419::battery_voltage] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(values[cia419::battery_voltage].value(), std::nullopt);
}

TEST_F(Handles, AValueThatWouldReadAsInvalidIsNudgedToItsNeighbour) {  // CiA 419, errata 1
  struct {
    double written;
    int raw;
  } constexpr cases[] = {{-0.125, 0}, {-0.13, -2}, {-0.12, 0},    {-0.18, -2},
                         {-0.07, 0},  {-0.06, 0},  {-0.1876, -2}, {-0.25, -2}};
  for (const auto& [written, raw] : cases) {
    values[cia419::battery_temperature] = written;
    EXPECT_EQ(values[cia419::battery_temperature].raw(), raw) << written;
  }
  values[cia419::charge_current_requested] = 65535.0 / 16;
  EXPECT_EQ(values[cia419::charge_current_requested].raw(), 0xFFFE);
}

TEST_F(Handles, AValueOutOfRangeIsTheNearestThatCanBeSent) {
  values[cia419::battery_temperature] = 1e9;
  EXPECT_EQ(values[cia419::battery_temperature].raw(), 0x02A8) << "CiA 419, 6010h: to 85 degrees";
  values[cia419::battery_temperature] = -1e9;
  EXPECT_EQ(values[cia419::battery_temperature].raw(), -0x0140) << "FEC0h: from -40 degrees";
  values[cia419::battery_voltage] = -5;
  EXPECT_EQ(values[cia419::battery_voltage].raw(), 0U);
  values[cia419::battery_voltage] = 1e12;
  EXPECT_EQ(values[cia419::battery_voltage].raw(), 0xFFFF'FFFEU);
  values[cia419::charger_state_of_charge] = 101;
  EXPECT_EQ(values[cia419::charger_state_of_charge].raw(), 100);
  values[cia419::charger_state_of_charge] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(values[cia419::charger_state_of_charge].raw(), 100);
}

TEST_F(Handles, AllTemperaturesOfItsRangeRoundTripButTheSentinel) {
  auto temperature = values[cia419::battery_temperature];
  for (int raw = -32768; raw <= 32767; ++raw) {
    temperature.set_raw(static_cast<std::int16_t>(raw));
    const std::optional<double> value = temperature.value();
    const bool is_in_range = raw >= -0x0140 && raw <= 0x02A8;
    if (raw == -1 || !is_in_range) {
      ASSERT_EQ(value, std::nullopt) << raw;
      continue;
    }
    ASSERT_EQ(value, raw * 0.125);
    temperature.set_raw(0x5555);
    temperature = value.value_or(0);
    ASSERT_EQ(temperature.raw(), raw);
  }
}

TEST_F(Handles, ARawNumberOutOfTheLimitsIsNoValue) {
  values[cia419::charger_state_of_charge].set_raw(101);
  EXPECT_EQ(values[cia419::charger_state_of_charge].value(), std::nullopt);
  EXPECT_EQ(values[cia419::charger_state_of_charge].raw(), 101);
}

TEST_F(Handles, StatesAreComparedAndWrittenByName) {
  values[cia419::charger_status] = Readiness::ready;
  EXPECT_EQ(dictionary.number(0x6001, 0), 1U);
  EXPECT_TRUE(values[cia419::charger_status].is(Readiness::ready));
  EXPECT_FALSE(values[cia419::charger_status].is(Readiness::not_ready));
  EXPECT_EQ(values[cia419::charger_status].value(), Readiness::ready);
}

TEST_F(Handles, AFieldIsWrittenWithoutTouchingItsNeighbours) {
  dictionary.set_number(0x6100, 0, 0xFF'FFFF);
  values[lock] = Lock::open;
  EXPECT_EQ(dictionary.number(0x6100, 0), 0xFF'3FFFU);
  values[angle] = 0;
  EXPECT_EQ(dictionary.number(0x6100, 0), 0xFF'1F40U);  // 8000 steps
  values[offset] = -64;
  EXPECT_EQ(dictionary.number(0x6100, 0), 0xC0'1F40U);
  values[alarm] = false;
  EXPECT_EQ(dictionary.number(0x6100, 0), 0x40'1F40U);
  values[lock] = Lock::no_action;
  EXPECT_EQ(dictionary.number(0x6100, 0), 0x40'DF40U);

  EXPECT_EQ(values[angle].value(), 0.0);
  EXPECT_EQ(values[offset].value(), -64);
  EXPECT_FALSE(values[alarm].is_set());
  EXPECT_TRUE(values[lock].is(Lock::no_action));
}

TEST_F(Handles, AStateThatNobodyNamedIsNoState) {
  dictionary.set_number(0x6100, 0, 0x8000);  // lock 2: reserved
  EXPECT_EQ(values[lock].value(), std::nullopt);
  EXPECT_EQ(values[lock].raw(), 2);
}

TEST_F(Handles, AnOffsetOfAScaleIsExact) {
  values[angle].set_raw(0);
  EXPECT_EQ(values[angle].value(), -800.0);
  values[angle] = 12.3;
  EXPECT_EQ(values[angle].raw(), 8123);
  values[angle] = 1e6;
  EXPECT_EQ(values[angle].raw(), 0x3FFD) << "below failure and not available";
  values[angle].set_raw(0x3FFE);
  EXPECT_EQ(values[angle].value(), std::nullopt) << "a failure is no value either";
}

TEST_F(Handles, SeveralSentinelsSideBySideArePassedOverTogether) {
  values[level] = 127.4;  // FFh is 127.5, FBh to FFh are no values
  EXPECT_EQ(values[level].raw(), 0xFA);
  values[level] = std::nullopt;
  EXPECT_EQ(values[level].raw(), 0xFF);
  for (unsigned raw = 0; raw <= 0xFF; ++raw) {
    values[level].set_raw(static_cast<std::uint8_t>(raw));
    EXPECT_EQ(values[level].is_valid(), raw <= 0xFA) << raw;
  }
}

TEST_F(Handles, RealsKeepTheirFractionsAndAreInvalidAsNotANumber) {
  values[speed] = 1.5;
  EXPECT_EQ(dictionary.number(0x6102, 0), 0x3FC0'0000U);  // 1.5 in IEEE 754
  EXPECT_EQ(values[speed].value(), 1.5);
  values[speed] = std::nullopt;
  EXPECT_EQ(values[speed].value(), std::nullopt);
  values[mass] = 2.5;                                               // in thousandths
  EXPECT_EQ(dictionary.number(0x6103, 0), 0x40A3'8800'0000'0000U);  // 2500.0
  EXPECT_EQ(values[mass].value(), 2.5);
}

TEST_F(Handles, IntegersStayWithinTheirLimits) {
  values[position] = -1001;
  EXPECT_EQ(values[position].value(), -1000);
  EXPECT_EQ(dictionary.number(0x6106, 0), 0xFF'FC18U);
  values[position] = 1'000'000'000'000;
  EXPECT_EQ(values[position].value(), 1000);
  values[counter] = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(values[counter].value(), std::numeric_limits<std::uint64_t>::max());
  values[counter] = -1;
  EXPECT_EQ(values[counter].value(), 0U);
  values[offset] = 64U;
  EXPECT_EQ(values[offset].value(), 63);
}

TEST_F(Handles, ABooleanIsTrueForAnyValueBut0) {
  values[the_switch] = true;
  EXPECT_EQ(dictionary.number(0x6107, 0), 1U);
  dictionary.set_number(0x6107, 0, 0x80);
  EXPECT_TRUE(values[the_switch].is_set());
  values[the_switch] = false;
  EXPECT_EQ(dictionary.number(0x6107, 0), 0U);
}

TEST_F(Handles, TextsAreReadAndWrittenAndCutAtTheirCapacity) {
  EXPECT_EQ(values[driver].value(), "");
  values[driver] = "Ada";
  EXPECT_EQ(values[driver].value(), "Ada");
  values[driver] = "123456789";
  EXPECT_EQ(values[driver].value(), "12345678");
}

TEST_F(Handles, AnArrayHasAHandleForEachOfItsEntriesAndObjects) {
  values[input] = 1;  // the first of the first
  values[input[254]] = 0xFFFF'FFFF'FFFF;
  values[input[7].shifted(31)] = 0x1234'5678'9ABC;
  EXPECT_EQ(dictionary.number(0x6200, 1), 1U);
  EXPECT_EQ(dictionary.number(0x6200, 254), 0xFFFF'FFFF'FFFFU);
  EXPECT_EQ(dictionary.number(0x621F, 7), 0x1234'5678'9ABCU);
  EXPECT_EQ(dictionary.number(0x6200, 7), 0U);
  EXPECT_EQ(values[input[7].shifted(31)].value(), 0x1234'5678'9ABCU);
}

TEST_F(Handles, OneOfSeveralIsFoundByTheNumberInItsName) {
  values[lamp(3)] = 30;
  values[lamp(6)] = 60;
  EXPECT_EQ(dictionary.number(0x6220, 11), 30U);
  EXPECT_EQ(dictionary.number(0x6220, 14), 60U);
  values[input(32)] = 320;
  values[input(2, 254)] = 2254;
  values[input(2).shifted(1)[5]] = 35;
  EXPECT_EQ(dictionary.number(0x621F, 1), 320U);
  EXPECT_EQ(dictionary.number(0x6201, 254), 2254U);
  EXPECT_EQ(dictionary.number(0x6202, 5), 35U);
}

TEST_F(Handles, AnObjectThatTheNodeDoesNotHaveGivesNothingAndTakesNothing) {
  EXPECT_FALSE(values[absent].exists());
  EXPECT_EQ(values[absent].value(), std::nullopt);
  EXPECT_EQ(values[absent].raw(), 0);
  values[absent] = 12.0;
  EXPECT_EQ(values[absent].value(), std::nullopt);
}

TEST_F(Handles, WhatCannotBeWrittenIsAnErrorValue) {
  EXPECT_EQ(values.set(level, 12.5), AbortCode::none);
  EXPECT_EQ(dictionary.number(0x6101, 0), 25U);
  EXPECT_EQ(values.set(absent, 12.0), AbortCode::no_object);
  EXPECT_EQ(values.set(lamp[15], 1), AbortCode::no_sub_index) << "lamps stand at 11 to 14";
  static constexpr ObjectInfo wide = {
      .index = 0x6101,
      .name = "level",
      .entry = {.type = DataType::unsigned32, .value = {.unit = Unit::litre}}};
  EXPECT_EQ(values.set(Quantity<wide>{}, 1.0), AbortCode::length);
  EXPECT_EQ(values.find(level), AbortCode::none);
  EXPECT_EQ(values.find(absent), AbortCode::no_object);
}

TEST_F(Handles, AnObjectOfAnotherTypeThanDescribedIsNotThere) {
  static constexpr ObjectInfo wide = {
      .index = 0x6101,
      .name = "level",
      .entry = {.type = DataType::unsigned32, .value = {.unit = Unit::litre}}};
  EXPECT_FALSE(values[Quantity<wide>{}].exists());
  EXPECT_TRUE(values[level].exists());
}

TEST_F(Handles, AValueIsCopiedToAnotherOfTheSameUnitWhateverItsScale) {
  values[cia419::battery_state_of_charge] = 80;
  values[cia419::charger_state_of_charge] = values[cia419::battery_state_of_charge];
  EXPECT_EQ(values[cia419::charger_state_of_charge].value(), 80.0);
  values[cia419::battery_state_of_charge] = std::nullopt;
  values[cia419::charger_state_of_charge] = values[cia419::battery_state_of_charge];
  EXPECT_EQ(values[cia419::charger_state_of_charge].value(), std::nullopt);
}

TEST_F(Handles, ABoundHandleIsTheSameValue) {
  Bound<cia419::battery_voltage> voltage(dictionary);
  ASSERT_TRUE(voltage.exists());
  voltage = 25.2;
  EXPECT_NEAR(values[cia419::battery_voltage].value().value_or(0), 25.2, 0.5 / 1024);
  values[cia419::battery_voltage] = std::nullopt;
  EXPECT_FALSE(voltage.is_valid());
}

TEST_F(Handles, ACopyOfAReferenceIsTheSameValue) {
  auto temperature = values[cia419::battery_temperature];
  const auto same = temperature;
  temperature = 10;
  EXPECT_EQ(same.value(), 10.0);
}

TEST_F(Handles, ATpdoLearnsOfAChangeAndOfNothingElse) {
  dictionary.watch(*dictionary.find(0x6001, 0), 1U << 0);
  dictionary.watch(*dictionary.find(0x6080, 0), 1U << 2);
  values[cia419::charger_status] = Readiness::not_ready;
  EXPECT_EQ(dictionary.changes(), 0U) << "it was not ready before";
  values[cia419::charger_state_of_charge] = 50;
  EXPECT_EQ(dictionary.changes(), 1U << 2);
  values[cia419::charger_status] = Readiness::ready;
  EXPECT_EQ(dictionary.changes(), 1U << 2 | 1U << 0);
}

// Code that must not compile.

template <const auto& handle, class Value>
concept Takes = requires(Values& values, Value value) { values[handle] = value; };

TEST(UnitSafety, OnlyValuesOfTheRightUnitAreTaken) {
  using cia419::battery_temperature;
  using cia419::battery_voltage;
  using TemperatureValue = decltype(std::declval<Values&>()[battery_temperature]);
  using VoltageValue = decltype(std::declval<Values&>()[battery_voltage]);
  static_assert(Takes<battery_temperature, double> && Takes<battery_temperature, int>);
  static_assert(Takes<battery_temperature, std::optional<double>> &&
                Takes<battery_temperature, std::nullopt_t>);
  static_assert(Takes<battery_temperature, Celsius> &&
                Takes<battery_temperature, TemperatureValue>);
  static_assert(!Takes<battery_temperature, Volts>);
  static_assert(!Takes<battery_voltage, Celsius>);
  static_assert(!Takes<battery_voltage, TemperatureValue>);
  static_assert(!Takes<battery_temperature, VoltageValue>);
  static_assert(!Takes<battery_voltage, std::optional<Celsius>>);
  static_assert(!Takes<battery_voltage, Readiness>);
  static_assert(Takes<battery_voltage, std::optional<Volts>>);
}

TEST(UnitSafety, AStateTakesNothingButItsOwnNames) {
  enum class Other : std::uint8_t { ready = 1 };
  using cia419::charger_status;
  static_assert(Takes<charger_status, Readiness>);
  static_assert(!Takes<charger_status, int> && !Takes<charger_status, bool> &&
                !Takes<charger_status, Other>);
}

TEST(UnitSafety, NothingIsInvalidOnlyWhereThereIsASentinel) {
  static_assert(!Takes<counter, std::nullopt_t>);
  static_assert(!Takes<counter, double> && !Takes<counter, Readiness>);
  static_assert(Takes<cia419::battery_state_of_charge, std::nullopt_t>);
}

TEST(UnitSafety, AmountsOfDifferentUnitsDoNotMix) {
  static_assert(!std::is_convertible_v<Volts, Amperes> && !std::is_constructible_v<Volts, Amperes>);
  static_assert(!std::is_convertible_v<Volts, double>);
  EXPECT_LT(Volts(1), Volts(2));
  EXPECT_EQ(Volts(24).number(), 24.0);
}

}  // namespace
}  // namespace canvoy::handle_test
