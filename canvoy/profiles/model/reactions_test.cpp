#include "canvoy/profiles/model/reactions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/testing/device_memory.hpp"

namespace canvoy::reactions_test {
namespace {

enum class Mode : std::uint8_t { manual = 1, automatic = 2 };
constexpr NamedValue mode_names[] = {{Mode::manual, "manual"}, {Mode::automatic, "automatic"}};
constexpr ObjectInfo mode_object = {
    .index = 0x6100,
    .name = "mode",
    .entry = {.type = DataType::unsigned8, .access = Access::rw, .value = {.names = mode_names}}};
constexpr EntryInfo lamp_entries[] = {
    cia301::highest_sub_index,
    {.sub_first = 1, .name = "brightness", .type = DataType::integer16, .access = Access::rw},
    {.sub_first = 2,
     .sub_last = 4,
     .name = "colour #",
     .first_number = 1,
     .type = DataType::unsigned8,
     .access = Access::rw}};
constexpr ObjectInfo lamp_object = {.index = 0x6101,
                                    .count = 2,
                                    .code = ObjectCode::record,
                                    .name = "lamp #",
                                    .first_number = 1,
                                    .subs = lamp_entries};
/// The lamps of a second device of this kind.
constexpr ObjectInfo other_lamp_object = {.index = 0x6901,
                                          .count = 2,
                                          .code = ObjectCode::record,
                                          .name = "other lamp #",
                                          .first_number = 1,
                                          .subs = lamp_entries};
constexpr State<Mode, mode_object> mode;
constexpr Number<lamp_object, "brightness"> brightness;
constexpr Number<lamp_object, "colour #"> colour;

constexpr auto device = describe(mode_object, lamp_object, other_lamp_object);
constexpr auto layout = lay_out_device<device>();

using Log = std::vector<std::string>;

/// Records its calls, and refuses a negative brightness.
class Unit {
 public:
  explicit Unit(Dictionary& dictionary, std::uint16_t shift = 0)
      : service_(&service_calls, this, shift) {
    dictionary.attach(service_);
  }
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;

  Log log;

 private:
  void read() { log.emplace_back("read"); }
  AbortCode refuse_read(const Entry& entry) {
    return entry.sub == 3 ? AbortCode::no_data : AbortCode::none;
  }
  AbortCode check_mode(Mode wanted) const {
    return wanted == Mode::automatic ? AbortCode::device_state : AbortCode::none;
  }
  AbortCode check_brightness(std::int16_t wanted) {
    log.push_back("brightness " + std::to_string(wanted));
    return wanted < 0 ? AbortCode::value_too_low : AbortCode::none;
  }
  AbortCode check_colour(const Entry& entry, std::span<const std::uint8_t> value) {
    log.push_back("colour " + std::to_string(entry.sub) + " " + std::to_string(value[0]));
    return AbortCode::none;
  }
  void mode_written() { log.emplace_back("mode written"); }
  void lamp_written(const Entry& entry) {
    log.push_back("lamp written " + std::to_string(entry.sub));
  }
  void any_written(Source source) { log.emplace_back(source == Source::pdo ? "by PDO" : "by SDO"); }

  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_;
};

constexpr AccessHandlers Unit::hook_calls[] = {
    before_read<&Unit::read, mode>,
    before_read<&Unit::refuse_read, lamp_object>,
    before_write<&Unit::check_mode, mode>,
    before_write<&Unit::check_brightness, brightness>,
    before_write<&Unit::check_colour, colour>,
    after_write<&Unit::mode_written, mode_object>,
    after_write<&Unit::lamp_written, colour>,
    after_write<&Unit::any_written, mode_object, lamp_object>};
constexpr ServiceHandlers Unit::service_calls = {.hooks = hook_calls};

struct Reactions : testing::Test {
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::vector<std::uint8_t> value,
                  Source source = Source::sdo) {
    return dictionary.write(index, sub, value, source);
  }
  AbortCode read(std::uint16_t index, std::uint8_t sub) {
    const Result<Entry> entry = dictionary.find(index, sub);
    return entry ? dictionary.open_read(*entry) : entry.abort();
  }

  DeviceMemory memory{layout.tables()};
  Dictionary& dictionary = memory.dictionary;
};

TEST_F(Reactions, AWriteIsCheckedAsTheNumberOrStateThatItIs) {
  Unit unit(dictionary);
  EXPECT_EQ(write(0x6100, 0, {2}), AbortCode::device_state);
  EXPECT_EQ(write(0x6100, 0, {1}), AbortCode::none);
  EXPECT_EQ(write(0x6101, 1, {0xFE, 0xFF}), AbortCode::value_too_low) << "-2";
  EXPECT_EQ(dictionary.number(0x6101, 1), 0U) << "what is refused changes nothing";
  EXPECT_EQ(unit.log, (Log{"mode written", "by SDO", "brightness -2"}));
}

TEST_F(Reactions, AHandleStandsForTheEntriesOfItsNameInAllObjectsOfTheirShape) {
  Unit unit(dictionary);
  EXPECT_EQ(write(0x6102, 4, {7}, Source::pdo), AbortCode::none);
  EXPECT_EQ(unit.log, (Log{"colour 4 7", "lamp written 4", "by PDO"}));
  unit.log.clear();
  EXPECT_EQ(write(0x6102, 1, {7, 0}), AbortCode::none);
  EXPECT_EQ(unit.log, (Log{"brightness 7", "by SDO"})) << "no colour";
}

TEST_F(Reactions, AReadIsRefreshedOrRefused) {
  Unit unit(dictionary);
  EXPECT_EQ(read(0x6100, 0), AbortCode::none);
  EXPECT_EQ(unit.log, Log{"read"});
  EXPECT_EQ(read(0x6101, 3), AbortCode::no_data);
  EXPECT_EQ(read(0x6101, 4), AbortCode::none);
}

TEST_F(Reactions, ATableServesAnotherBlockOfObjectsByAShift) {
  Unit unit(dictionary, 0x800);
  EXPECT_EQ(write(0x6101, 2, {7}), AbortCode::none);
  EXPECT_EQ(unit.log, Log{}) << "of the first block";
  EXPECT_EQ(write(0x6902, 2, {7}), AbortCode::none);
  EXPECT_EQ(unit.log, (Log{"colour 2 7", "lamp written 2", "by SDO"}));
}

TEST_F(Reactions, UnitsAreAskedInTheOrderInWhichTheyWereAttachedUntilOneRefuses) {
  Unit first(dictionary);
  Unit second(dictionary);
  EXPECT_EQ(write(0x6101, 1, {0xFE, 0xFF}), AbortCode::value_too_low);
  EXPECT_EQ(first.log, Log{"brightness -2"});
  EXPECT_EQ(second.log, Log{});
  EXPECT_EQ(write(0x6101, 1, {2, 0}), AbortCode::none);
  EXPECT_EQ(second.log, (Log{"brightness 2", "by SDO"}));
}

TEST_F(Reactions, AHookOfAnApplicationIsAskedBeforeTheUnitsThatAreThere) {
  Unit unit(dictionary);
  auto refuse = [](const Entry&, std::span<const std::uint8_t>) { return AbortCode::general; };
  Hook hook{
      .first = 0x6101,
      .last = 0x6101,
      .before_write = Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)>::of(refuse)};
  dictionary.attach(hook);
  EXPECT_EQ(write(0x6101, 1, {2, 0}), AbortCode::general);
  EXPECT_EQ(unit.log, Log{});
  EXPECT_EQ(write(0x6102, 1, {2, 0}), AbortCode::none) << "another object";
}

// The type that a hook gets: that of its handle.

constexpr NamedValue pressure_names[] = {{0xFFFF, "not available", Meaning::invalid}};
constexpr ObjectInfo pressure_object = {.index = 0x6200,
                                        .name = "pressure",
                                        .entry = {.type = DataType::unsigned16,
                                                  .access = Access::rw,
                                                  .value = {.unit = canvoy::Unit::bar,
                                                            .scale = {.denominator = 100},
                                                            .names = pressure_names}}};
constexpr ObjectInfo depth_object = {
    .index = 0x6201,
    .name = "depth",
    .entry = {.type = DataType::integer16,
              .access = Access::rw,
              .value = {.unit = canvoy::Unit::metre, .scale = {.denominator = 10}}}};
constexpr ObjectInfo gain_object = {
    .index = 0x6202, .name = "gain", .entry = {.type = DataType::real32, .access = Access::rw}};
constexpr ObjectInfo mass_object = {
    .index = 0x6203,
    .name = "mass",
    .entry = {.type = DataType::real64,
              .access = Access::rw,
              .value = {.unit = canvoy::Unit::kilogram, .scale = {.denominator = 1000}}}};
constexpr FieldInfo switch_fields[] = {
    {.first_bit = 0, .bits = 5, .name = "offset", .is_signed = true},
    {.first_bit = 5, .bits = 1, .name = "alarm"},
    {.first_bit = 6, .bits = 2, .name = "mode", .value = {.names = mode_names}}};
constexpr ObjectInfo switch_object = {
    .index = 0x6204,
    .name = "switch",
    .entry = {.type = DataType::unsigned8, .access = Access::rw, .fields = switch_fields}};
constexpr ObjectInfo text_object = {
    .index = 0x6205,
    .name = "text",
    .entry = {.type = DataType::visible_string, .access = Access::rw, .capacity = 8}};
constexpr EntryInfo step_entries[] = {
    {.name = "Highest sub-index", .type = DataType::unsigned8, .access = Access::rw},
    {.sub_first = 1, .name = "way", .type = DataType::integer16, .access = Access::rw},
    {.sub_first = 2, .name = "speed", .type = DataType::unsigned16, .access = Access::rw}};
constexpr ObjectInfo step_object = {
    .index = 0x6206, .code = ObjectCode::record, .name = "step", .subs = step_entries};
constexpr NamedValue counter_names[] = {{-1, "not available", Meaning::invalid}};
constexpr ObjectInfo counter_object = {
    .index = 0x6207,
    .name = "counter",
    .entry = {
        .type = DataType::integer24, .access = Access::rw, .value = {.names = counter_names}}};

constexpr Quantity<pressure_object> pressure;
constexpr Quantity<depth_object> depth;
constexpr Quantity<gain_object> gain;
constexpr Quantity<mass_object> mass;
constexpr Number<switch_object, "", "offset"> offset;
constexpr Flag<switch_object, "", "alarm"> alarm;
constexpr State<Mode, switch_object, "", "mode"> switch_mode;
constexpr Text<text_object> text;
constexpr Number<counter_object> counter;

constexpr auto values_device =
    describe(pressure_object, depth_object, gain_object, mass_object, switch_object, text_object,
             step_object, counter_object, lamp_object);
constexpr auto values_layout = lay_out_device<values_device>();

/// Records the values that it gets.
struct ValuesUnit {
  explicit ValuesUnit(Dictionary& dictionary) { dictionary.attach(service); }

  AbortCode take_pressure(std::optional<double> value) { return note(pressures, value); }
  AbortCode take_amount(std::optional<Amount<canvoy::Unit::bar>> value) {
    return note(amounts, value ? std::optional(value->number()) : std::nullopt);
  }
  AbortCode take_depth(double value) { return note(depths, value); }
  AbortCode take_depth_amount(Amount<canvoy::Unit::metre> value) {
    return note(depths, value.number());
  }
  AbortCode take_gain(float value) { return note(gains, value); }
  AbortCode take_mass(double value) { return note(masses, value); }
  AbortCode take_offset(std::int8_t value) const {
    return value == -16 ? AbortCode::value_too_low : AbortCode::none;
  }
  AbortCode take_alarm(bool value) { return note(alarms, value); }
  AbortCode take_mode(Mode value) { return note(modes, value); }
  AbortCode take_text(std::string_view value) { return note(texts, std::string(value)); }
  AbortCode take_step(const Entry& entry, Raw<std::uint16_t> value) {
    return note(steps, std::pair(entry.sub, value.bits));
  }
  AbortCode take_whole(Raw<std::uint8_t> value) { return note(wholes, value.bits); }
  AbortCode take_count(std::optional<std::int32_t> value) { return note(counts, value); }
  AbortCode take_colour(const Entry& entry, std::uint8_t value) {
    return note(colours, std::pair(entry.sub, value));
  }

  template <class List, class Value>
  static AbortCode note(List& list, const Value& value) {
    list.push_back(value);
    return AbortCode::none;
  }

  std::vector<std::optional<double>> pressures, amounts;
  std::vector<double> depths, masses;
  std::vector<float> gains;
  std::vector<bool> alarms;
  std::vector<Mode> modes;
  std::vector<std::string> texts;
  std::vector<std::pair<std::uint8_t, std::uint16_t>> steps;
  std::vector<std::uint8_t> wholes;
  std::vector<std::optional<std::int32_t>> counts;
  std::vector<std::pair<std::uint8_t, std::uint8_t>> colours;

  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service{&service_calls, this};
};
constexpr AccessHandlers ValuesUnit::hook_calls[] = {
    before_write<&ValuesUnit::take_pressure, pressure>,
    before_write<&ValuesUnit::take_amount, pressure>,
    before_write<&ValuesUnit::take_depth, depth>,
    before_write<&ValuesUnit::take_depth_amount, depth_object>,
    before_write<&ValuesUnit::take_gain, gain>,
    before_write<&ValuesUnit::take_mass, mass>,
    before_write<&ValuesUnit::take_offset, offset>,
    before_write<&ValuesUnit::take_alarm, alarm>,
    before_write<&ValuesUnit::take_mode, switch_mode>,
    before_write<&ValuesUnit::take_whole, switch_object>,
    before_write<&ValuesUnit::take_text, text>,
    before_write<&ValuesUnit::take_step, step_object>,
    before_write<&ValuesUnit::take_count, counter>,
    before_write<&ValuesUnit::take_colour, colour>};
constexpr ServiceHandlers ValuesUnit::service_calls = {.hooks = hook_calls};

struct WrittenValues : testing::Test {
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::vector<std::uint8_t> value) {
    return memory.dictionary.write(index, sub, value, Source::sdo);
  }
  DeviceMemory memory{values_layout.tables()};
  ValuesUnit unit{memory.dictionary};
};

TEST_F(WrittenValues, AreThePhysicalOnesOfAQuantity) {
  EXPECT_EQ(write(0x6200, 0, {0x84, 0x03}), AbortCode::none);  // 900 of 0.01 bar
  EXPECT_EQ(unit.pressures, std::vector<std::optional<double>>{9.0});
  EXPECT_EQ(unit.amounts, std::vector<std::optional<double>>{9.0});
  EXPECT_EQ(write(0x6201, 0, {0xFB, 0xFF}), AbortCode::none);  // -5 of 0.1 m
  EXPECT_EQ(unit.depths, (std::vector{-0.5, -0.5})) << "by handle and by object";
}

TEST_F(WrittenValues, AreNothingWhereAQuantitySaysSo) {
  EXPECT_EQ(write(0x6200, 0, {0xFF, 0xFF}), AbortCode::none);
  EXPECT_EQ(unit.pressures, std::vector<std::optional<double>>{std::nullopt});
  EXPECT_EQ(unit.amounts, std::vector<std::optional<double>>{std::nullopt});
}

TEST_F(WrittenValues, AreRealsOfReals) {
  EXPECT_EQ(write(0x6202, 0, {0x00, 0x00, 0x80, 0x3F}), AbortCode::none);  // IEEE 754: 1.0
  EXPECT_EQ(unit.gains, std::vector{1.0F});
  EXPECT_EQ(write(0x6203, 0, {0, 0, 0, 0, 0, 0, 0x04, 0x40}), AbortCode::none);  // 2.5 g
  EXPECT_EQ(unit.masses, std::vector{0.0025});
  EXPECT_EQ(write(0x6202, 0, {0x00, 0x00, 0xC0, 0x7F}), AbortCode::none);
  EXPECT_TRUE(std::isnan(unit.gains.at(1))) << "not a number is an invalid real";
}

TEST_F(WrittenValues, AreTheBitsOfAField) {
  EXPECT_EQ(write(0x6204, 0, {0b10'1'10000}), AbortCode::value_too_low) << "-16 in five bits";
  EXPECT_EQ(write(0x6204, 0, {0b10'1'00011}), AbortCode::none);
  EXPECT_EQ(unit.alarms, std::vector{true});
  EXPECT_EQ(unit.modes, std::vector{Mode::automatic});
  EXPECT_EQ(unit.wholes, std::vector<std::uint8_t>{0b10'1'00011});
}

TEST_F(WrittenValues, AreTheCharactersOfAText) {
  EXPECT_EQ(write(0x6205, 0, {'h', 'a', 'l', 't'}), AbortCode::none);
  EXPECT_EQ(unit.texts, std::vector<std::string>{"halt"});
}

TEST_F(WrittenValues, AreRawBitsWhereThatIsAskedForAndNotOfTheCount) {
  EXPECT_EQ(write(0x6206, 1, {0xFB, 0xFF}), AbortCode::none);
  EXPECT_EQ(write(0x6206, 2, {0x01, 0x02}), AbortCode::none);
  EXPECT_EQ(write(0x6206, 0, {2}), AbortCode::none);
  EXPECT_EQ(unit.steps,
            (std::vector<std::pair<std::uint8_t, std::uint16_t>>{{1, 0xFFFB}, {2, 0x0201}}));
}

TEST_F(WrittenValues, AreSignedWhereTheEntryIsAndNothingAtASentinel) {
  EXPECT_EQ(write(0x6207, 0, {0xFB, 0xFF, 0xFF}), AbortCode::none);
  EXPECT_EQ(write(0x6207, 0, {0xFF, 0xFF, 0xFF}), AbortCode::none);
  EXPECT_EQ(unit.counts, (std::vector<std::optional<std::int32_t>>{-5, std::nullopt}));
}

TEST_F(WrittenValues, ComeWithTheirEntryWhereTheHandleStandsForSeveral) {
  EXPECT_EQ(write(0x6102, 4, {7}), AbortCode::none);
  EXPECT_EQ(unit.colours, (std::vector<std::pair<std::uint8_t, std::uint8_t>>{{4, 7}}));
}

}  // namespace
}  // namespace canvoy::reactions_test
