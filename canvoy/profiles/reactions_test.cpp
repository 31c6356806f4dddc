#include "canvoy/profiles/reactions.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/layout.hpp"
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

/// Notes what it is told, and refuses the dark.
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

  static const HookCalls hook_calls[];
  static const ServiceCalls service_calls;
  ServiceLink service_;
};

constexpr HookCalls Unit::hook_calls[] = {
    before_read<&Unit::read, mode>,
    before_read<&Unit::refuse_read, lamp_object>,
    before_write<&Unit::check_mode, mode>,
    before_write<&Unit::check_brightness, brightness>,
    before_write<&Unit::check_colour, colour>,
    after_write<&Unit::mode_written, mode_object>,
    after_write<&Unit::lamp_written, colour>,
    after_write<&Unit::any_written, mode_object, lamp_object>};
constexpr ServiceCalls Unit::service_calls = {.hooks = hook_calls};

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

}  // namespace
}  // namespace canvoy::reactions_test
