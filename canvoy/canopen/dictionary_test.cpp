#include "canvoy/canopen/dictionary.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <vector>

#include "canvoy/canopen/dictionary_layout.hpp"

namespace canvoy {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A dictionary with its memory.
struct Held {
  explicit Held(const DictionaryTables& tables, std::uint8_t node_id = 5)
      : values(tables.value_bytes, 0xEE),
        states(tables.objects.size()),
        dictionary(tables, values, states) {
    dictionary.restore_defaults(0, 0xFFFF, node_id);
    dictionary.clear_changes();
  }

  AbortCode write(std::uint16_t index, std::uint8_t sub, const Bytes& bytes,
                  Source source = Source::sdo) {
    return dictionary.write(index, sub, bytes, source);
  }
  /// What a client reads, or nothing and the reason in `abort`.
  Bytes read(std::uint16_t index, std::uint8_t sub) {
    const Result<Entry> entry = dictionary.find(index, sub);
    abort = entry.abort();
    if (!entry) return {};
    const auto bytes = dictionary.read(*entry);
    abort = bytes.abort();
    return bytes ? Bytes(bytes->begin(), bytes->end()) : Bytes{};
  }
  Entry entry(std::uint16_t index, std::uint8_t sub = 0) { return *dictionary.find(index, sub); }

  Bytes values;
  std::vector<ObjectState> states;
  Dictionary dictionary;
  AbortCode abort = AbortCode::none;
};

Bytes bytes_of(std::uint64_t number, std::size_t length) {
  Bytes bytes(8);
  store(bytes.data(), number);
  bytes.resize(length);
  return bytes;
}

// A variable, a record, an array, sixteen objects of one shape, and neighbours at both ends.
constexpr auto shapes = lay_out(
    std::to_array<ObjectRow>({{.index = 0x0001, .entry_count = 1},
                              {.index = 0x1018, .entry_count = 3},
                              {.index = 0x6000, .entry_count = 2},
                              {.index = 0x6100, .count = 16, .entry_count = 3},
                              {.index = 0xFFFF, .entry_count = 1}}),
    std::to_array<EntryRow>(
        {{.access = Access::rw},
         {.access = Access::const_, .initial = 2},
         {.sub_first = 1, .sub_last = 1, .type = DataType::unsigned32, .access = Access::rw},
         {.sub_first = 3, .sub_last = 3, .type = DataType::unsigned16, .access = Access::rw},
         {.access = Access::const_, .initial = 254},
         {.sub_first = 1, .sub_last = 254, .type = DataType::unsigned16, .access = Access::rw},
         {.access = Access::const_, .initial = 9},
         {.sub_first = 1, .sub_last = 4, .type = DataType::unsigned24, .access = Access::rw},
         {.sub_first = 9, .sub_last = 9, .type = DataType::boolean, .access = Access::rw},
         {.access = Access::rw}}));

bool exists(unsigned index, unsigned sub) {
  if (index == 0x0001 || index == 0xFFFF) return sub == 0;
  if (index == 0x1018) return sub == 0 || sub == 1 || sub == 3;
  if (index == 0x6000) return sub <= 254;
  if (index >= 0x6100 && index <= 0x610F) return sub <= 4 || sub == 9;
  return false;
}

TEST(DictionarySearch, finds_each_entry_that_exists_and_no_other) {
  Held sut(shapes.tables());
  for (unsigned index = 0; index <= 0xFFFF; ++index) {
    const bool object_exists = exists(index, 0);
    const unsigned last_sub = object_exists ? 255 : 1;
    for (unsigned sub = 0; sub <= last_sub; ++sub) {
      const auto entry =
          sut.dictionary.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
      const AbortCode expected = exists(index, sub) ? AbortCode::none
                                 : object_exists    ? AbortCode::no_sub_index
                                                    : AbortCode::no_object;
      ASSERT_EQ(entry.abort(), expected) << std::hex << index << " " << sub;
      if (!entry) continue;
      ASSERT_EQ(entry->index, index);
      ASSERT_EQ(entry->sub, sub);
    }
  }
}

TEST(DictionarySearch, finds_nothing_in_an_empty_dictionary) {
  Held sut(DictionaryTables{});
  EXPECT_EQ(sut.dictionary.find(0x1000, 0).abort(), AbortCode::no_object);
  EXPECT_EQ(sut.write(0x1000, 0, {0}), AbortCode::no_object);
  EXPECT_FALSE(sut.dictionary.set_number(0x1000, 0, 1));
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0U);
}

TEST(DictionarySearch, gives_each_entry_its_own_memory_within_the_block) {
  Held sut(shapes.tables());
  std::map<const std::uint8_t*, unsigned> owner;
  for (unsigned index = 0; index <= 0xFFFF; ++index) {
    for (unsigned sub = 0; sub <= 255; ++sub) {
      if (!exists(index, sub)) {
        if (!exists(index, 0)) break;
        continue;
      }
      const Entry entry =
          sut.entry(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
      for (const std::uint8_t& byte : entry.bytes()) {
        ASSERT_GE(&byte, sut.values.data());
        ASSERT_LT(&byte, sut.values.data() + sut.values.size());
        ASSERT_TRUE(owner.emplace(&byte, index << 8 | sub).second);
      }
    }
  }
  EXPECT_EQ(owner.size(), sut.values.size()) << "and leaves none unused";
}

TEST(DictionarySearch, finds_what_a_naive_search_finds_in_any_layout) {
  const bool held = rc::check("like a list", [] {
    std::vector<ObjectRow> objects;
    std::vector<EntryRow> entries;
    std::map<unsigned, std::vector<bool>> model;  // object -> the sub-indices that exist
    unsigned index = 0x1000;
    std::uint32_t bytes = 0;
    const int count = *rc::gen::inRange(0, 12);
    for (int i = 0; i < count; ++i) {
      index += *rc::gen::inRange(0U, 3U);
      ObjectRow object{.index = static_cast<std::uint16_t>(index),
                       .count = *rc::gen::inRange<std::uint16_t>(1, 4),
                       .entry_first = static_cast<std::uint16_t>(entries.size()),
                       .entry_count = *rc::gen::inRange<std::uint16_t>(0, 4),
                       .offset = bytes};
      std::vector<bool> subs(256);
      unsigned sub = *rc::gen::inRange(0U, 2U);
      for (unsigned e = 0; e < object.entry_count; ++e) {
        const unsigned length = *rc::gen::inRange(1U, 5U);
        entries.push_back({.sub_first = static_cast<std::uint8_t>(sub),
                           .sub_last = static_cast<std::uint8_t>(sub + length - 1),
                           .capacity = 1,
                           .offset = object.pitch});
        object.pitch += length;
        for (unsigned s = sub; s < sub + length; ++s) subs[s] = true;
        sub += length + *rc::gen::inRange(0U, 2U);
      }
      for (unsigned o = 0; o < object.count; ++o) model[index + o] = subs;
      bytes += object.pitch * object.count;
      index += object.count;
      objects.push_back(object);
    }
    Held sut(DictionaryTables{objects, entries, bytes});
    for (unsigned probe = 0x0FFF; probe < index + 3; ++probe) {
      for (unsigned sub = 0; sub < 30; ++sub) {
        const auto found =
            sut.dictionary.find(static_cast<std::uint16_t>(probe), static_cast<std::uint8_t>(sub));
        const AbortCode expected = !model.contains(probe) ? AbortCode::no_object
                                   : !model[probe][sub]   ? AbortCode::no_sub_index
                                                          : AbortCode::none;
        RC_ASSERT(found.abort() == expected);
      }
    }
  });
  EXPECT_TRUE(held);
}

// Lengths

constexpr DataType all_types[] = {
    DataType::boolean,     DataType::integer8,        DataType::integer16,  DataType::integer32,
    DataType::unsigned8,   DataType::unsigned16,      DataType::unsigned32, DataType::real32,
    DataType::time_of_day, DataType::time_difference, DataType::integer24,  DataType::real64,
    DataType::integer40,   DataType::integer48,       DataType::integer56,  DataType::integer64,
    DataType::unsigned24,  DataType::unsigned40,      DataType::unsigned48, DataType::unsigned56,
    DataType::unsigned64,
};
constexpr std::size_t type_count = std::size(all_types);

/// Object 2000h and up: one for each type.
constexpr auto types = [] {
  std::array<ObjectRow, type_count> objects{};
  std::array<EntryRow, type_count> entries{};
  for (std::size_t i = 0; i < type_count; ++i) {
    objects[i] = {.index = static_cast<std::uint16_t>(0x2000 + i), .entry_count = 1};
    entries[i] = {.type = all_types[i], .access = Access::rw};
  }
  return lay_out(objects, entries);
}();

// CiA 301, 7.1.4: bytes that a value of the type takes.
constexpr std::size_t type_bytes[type_count] = {1, 1, 2, 4, 1, 2, 4, 4, 6, 6, 3,
                                                8, 5, 6, 7, 8, 3, 5, 6, 7, 8};

TEST(DictionaryLength, is_that_of_the_type_and_no_other) {
  Held sut(types.tables());
  for (std::size_t i = 0; i < type_count; ++i) {
    const auto index = static_cast<std::uint16_t>(0x2000 + i);
    for (std::size_t length = 0; length <= 9; ++length) {
      const AbortCode expected = length > type_bytes[i]   ? AbortCode::length_too_high
                                 : length < type_bytes[i] ? AbortCode::length_too_low
                                                          : AbortCode::none;
      EXPECT_EQ(sut.write(index, 0, Bytes(length, 1)), expected)
          << std::hex << index << " " << length;
    }
    EXPECT_EQ(sut.read(index, 0), Bytes(type_bytes[i], 1));
  }
}

TEST(DictionaryLength, keeps_every_bit_of_every_type) {
  Held sut(types.tables());
  for (std::size_t i = 0; i < type_count; ++i) {
    const auto index = static_cast<std::uint16_t>(0x2000 + i);
    for (const Bytes& pattern : {bytes_of(0xFEDC'BA98'7654'3210, type_bytes[i]),
                                 Bytes(type_bytes[i], 0xFF), Bytes(type_bytes[i], 0x00)}) {
      EXPECT_EQ(sut.write(index, 0, pattern), AbortCode::none) << std::hex << index;
      EXPECT_EQ(sut.read(index, 0), pattern);
    }
  }
}

TEST(DictionaryLength, refuses_bits_that_an_odd_sized_integer_does_not_have) {
  constexpr auto odd =
      lay_out(std::to_array<ObjectRow>({{.index = 0x2000, .entry_count = 1},
                                        {.index = 0x2001, .entry_count = 1},
                                        {.index = 0x2002, .entry_count = 1}}),
              std::to_array<EntryRow>({{.type = DataType::unsigned2, .access = Access::rw},
                                       {.type = static_cast<DataType>(0x66), .access = Access::rw},
                                       {.type = DataType::unsigned31, .access = Access::rw}}));
  Held sut(odd.tables());
  EXPECT_EQ(sut.write(0x2000, 0, {3}), AbortCode::none);
  EXPECT_EQ(sut.write(0x2000, 0, {4}), AbortCode::value_too_high);
  EXPECT_EQ(sut.write(0x2001, 0, {0xFF, 0x01}), AbortCode::none) << "9 bits";
  EXPECT_EQ(sut.write(0x2001, 0, {0x00, 0x02}), AbortCode::value_too_high);
  EXPECT_EQ(sut.write(0x2002, 0, {0xFF, 0xFF, 0xFF, 0x7F}), AbortCode::none);
  EXPECT_EQ(sut.write(0x2002, 0, {0x00, 0x00, 0x00, 0x80}), AbortCode::value_too_high);
}

// Access

constexpr auto accesses =
    lay_out(std::to_array<ObjectRow>({{.index = 0x2000, .entry_count = 5}}),
            std::to_array<EntryRow>(
                {{.access = Access::ro, .initial = 1},
                 {.sub_first = 1, .sub_last = 1, .access = Access::wo, .initial = 2},
                 {.sub_first = 2, .sub_last = 2, .access = Access::rw, .initial = 3},
                 {.sub_first = 3, .sub_last = 3, .access = Access::const_, .initial = 4},
                 {.sub_first = 4, .sub_last = 4, .access = Access::none}}));

TEST(DictionaryAccess, is_what_the_entry_allows) {
  Held sut(accesses.tables());
  EXPECT_EQ(sut.read(0x2000, 0), Bytes{1});
  EXPECT_EQ(sut.read(0x2000, 1), Bytes{});
  EXPECT_EQ(sut.abort, AbortCode::write_only);
  EXPECT_EQ(sut.read(0x2000, 2), Bytes{3});
  EXPECT_EQ(sut.read(0x2000, 3), Bytes{4});
  sut.read(0x2000, 4);
  EXPECT_EQ(sut.abort, AbortCode::write_only);

  EXPECT_EQ(sut.write(0x2000, 0, {9}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x2000, 1, {9}), AbortCode::none);
  EXPECT_EQ(sut.write(0x2000, 2, {9}), AbortCode::none);
  EXPECT_EQ(sut.write(0x2000, 3, {9}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x2000, 4, {9}), AbortCode::read_only);
  EXPECT_EQ(sut.dictionary.number(0x2000, 0), 1U);
  EXPECT_EQ(sut.dictionary.number(0x2000, 1), 9U);
}

TEST(DictionaryAccess, is_asked_before_length_and_range) {
  Held sut(accesses.tables());
  EXPECT_EQ(sut.write(0x2000, 0, {1, 2, 3}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x2000, 0, {}), AbortCode::read_only);
}

TEST(DictionaryAccess, does_not_bind_the_device_itself) {
  Held sut(accesses.tables());
  EXPECT_TRUE(sut.dictionary.set_number(0x2000, 0, 7));
  EXPECT_EQ(sut.read(0x2000, 0), Bytes{7});
}

TEST(DictionaryAccess, combines_its_bits) {
  EXPECT_TRUE(allows(Access::rw, Access::sdo_read));
  EXPECT_TRUE(allows(Access::rw | Access::tpdo, Access::tpdo));
  EXPECT_FALSE(allows(Access::ro | Access::tpdo, Access::rpdo));
  EXPECT_FALSE(allows(Access::const_, Access::sdo_write));
  EXPECT_FALSE(allows(Access::ro, Access::rw));
}

// Ranges

/// One entry 2000h of a type with limits.
struct Limited {
  Limited(DataType type, std::int64_t low, std::int64_t high,
          EntryTraits traits = EntryTraits::limited, std::int64_t sentinel = 0)
      : entry{.type = type,
              .access = Access::rw,
              .traits = traits,
              .capacity = static_cast<std::uint16_t>(byte_length(type)),
              .low = low,
              .high = high,
              .sentinel = sentinel},
        object{.index = 0x2000, .entry_count = 1, .pitch = entry.capacity},
        held(DictionaryTables{{&object, 1}, {&entry, 1}, entry.capacity}) {}

  AbortCode write(std::uint64_t number) {
    const AbortCode answer = held.write(0x2000, 0, bytes_of(number, entry.capacity));
    const AbortCode alone = Dictionary::check_value(entry, bytes_of(number, entry.capacity));
    EXPECT_EQ(answer, alone);
    return answer;
  }

  EntryRow entry;
  ObjectRow object;
  Held held;
};

constexpr DataType unsigned_types[] = {
    DataType::unsigned8,  DataType::unsigned16, DataType::unsigned24, DataType::unsigned32,
    DataType::unsigned40, DataType::unsigned48, DataType::unsigned56, DataType::unsigned64};
constexpr DataType signed_types[] = {DataType::integer8,  DataType::integer16, DataType::integer24,
                                     DataType::integer32, DataType::integer40, DataType::integer48,
                                     DataType::integer56, DataType::integer64};

TEST(DictionaryRange, holds_for_unsigned_integers_of_all_sizes) {
  for (const DataType type : unsigned_types) {
    Limited sut(type, 10, 200);
    EXPECT_EQ(sut.write(9), AbortCode::value_too_low);
    EXPECT_EQ(sut.write(10), AbortCode::none);
    EXPECT_EQ(sut.write(200), AbortCode::none);
    EXPECT_EQ(sut.write(201), AbortCode::value_too_high);
    EXPECT_EQ(sut.write(~std::uint64_t{0}), AbortCode::value_too_high);
    EXPECT_EQ(sut.write(0), AbortCode::value_too_low);
  }
}

TEST(DictionaryRange, holds_for_signed_integers_of_all_sizes) {
  for (const DataType type : signed_types) {
    Limited sut(type, -100, 100);
    EXPECT_EQ(sut.write(static_cast<std::uint64_t>(-101)), AbortCode::value_too_low);
    EXPECT_EQ(sut.write(static_cast<std::uint64_t>(-100)), AbortCode::none);
    EXPECT_EQ(sut.write(static_cast<std::uint64_t>(-1)), AbortCode::none);
    EXPECT_EQ(sut.write(0), AbortCode::none);
    EXPECT_EQ(sut.write(100), AbortCode::none);
    EXPECT_EQ(sut.write(101), AbortCode::value_too_high);
    const unsigned bits = bit_length(type);
    EXPECT_EQ(sut.write(std::uint64_t{1} << (bits - 1)), AbortCode::value_too_low) << bits;
    EXPECT_EQ(sut.write((std::uint64_t{1} << (bits - 1)) - 1), AbortCode::value_too_high) << bits;
  }
}

TEST(DictionaryRange, reaches_to_both_ends_of_64_bits) {
  constexpr std::int64_t lowest = INT64_MIN;
  constexpr std::int64_t highest = INT64_MAX;
  Limited with_sign(DataType::integer64, lowest + 1, highest - 1);
  EXPECT_EQ(with_sign.write(0x8000'0000'0000'0000), AbortCode::value_too_low);
  EXPECT_EQ(with_sign.write(0x8000'0000'0000'0001), AbortCode::none);
  EXPECT_EQ(with_sign.write(0x7FFF'FFFF'FFFF'FFFE), AbortCode::none);
  EXPECT_EQ(with_sign.write(0x7FFF'FFFF'FFFF'FFFF), AbortCode::value_too_high);

  // Limits of an unsigned type above 2^63 are the negative numbers with the same bits.
  Limited without(DataType::unsigned64, 1, -2);
  EXPECT_EQ(without.write(0), AbortCode::value_too_low);
  EXPECT_EQ(without.write(1), AbortCode::none);
  EXPECT_EQ(without.write(0x8000'0000'0000'0000), AbortCode::none);
  EXPECT_EQ(without.write(0xFFFF'FFFF'FFFF'FFFE), AbortCode::none);
  EXPECT_EQ(without.write(0xFFFF'FFFF'FFFF'FFFF), AbortCode::value_too_high);
}

TEST(DictionaryRange, lets_a_sentinel_pass_outside_of_the_limits) {
  constexpr EntryTraits traits = EntryTraits::limited | EntryTraits::has_sentinel;
  Limited percent(DataType::unsigned8, 0, 100, traits, 0xFF);
  EXPECT_EQ(percent.write(100), AbortCode::none);
  EXPECT_EQ(percent.write(101), AbortCode::value_too_high);
  EXPECT_EQ(percent.write(0xFE), AbortCode::value_too_high);
  EXPECT_EQ(percent.write(0xFF), AbortCode::none);

  Limited temperature(DataType::integer16, -320, 680, traits, -32768);
  EXPECT_EQ(temperature.write(0x8000), AbortCode::none);
  EXPECT_EQ(temperature.write(0x8001), AbortCode::value_too_low);
  EXPECT_EQ(temperature.write(static_cast<std::uint64_t>(-320)), AbortCode::none);

  Limited wide(DataType::unsigned64, 0, 5, traits, -1);
  EXPECT_EQ(wide.write(~std::uint64_t{0}), AbortCode::none);
  EXPECT_EQ(wide.write(~std::uint64_t{0} - 1), AbortCode::value_too_high);

  Limited odd(DataType::integer24, 0, 5, traits, -1);
  EXPECT_EQ(odd.write(0xFF'FFFF), AbortCode::none);
  EXPECT_EQ(odd.write(0xFF'FFFE), AbortCode::value_too_low);
}

TEST(DictionaryRange, does_not_hold_where_the_entry_has_none) {
  Limited sut(DataType::unsigned16, 10, 20, EntryTraits::none);
  for (const std::uint64_t number : {0U, 9U, 21U, 0xFFFFU}) {
    EXPECT_EQ(sut.write(number), AbortCode::none);
  }
}

TEST(DictionaryRange, takes_any_byte_for_a_boolean) {
  Limited sut(DataType::boolean, 0, 1, EntryTraits::none);
  for (unsigned byte = 0; byte < 256; ++byte) EXPECT_EQ(sut.write(byte), AbortCode::none);
}

TEST(DictionaryRange, does_not_hold_for_reals_and_times) {
  for (const DataType type : {DataType::real32, DataType::real64, DataType::time_of_day}) {
    Limited sut(type, 1, 2);
    EXPECT_EQ(sut.write(0), AbortCode::none);
    EXPECT_EQ(sut.write(~std::uint64_t{0}), AbortCode::none);
  }
}

TEST(DictionaryRange, changes_nothing_when_it_refuses) {
  Limited sut(DataType::unsigned16, 10, 20);
  ASSERT_EQ(sut.write(15), AbortCode::none);
  EXPECT_EQ(sut.write(21), AbortCode::value_too_high);
  EXPECT_EQ(sut.held.write(0x2000, 0, {1}), AbortCode::length_too_low);
  EXPECT_EQ(sut.held.dictionary.number(0x2000, 0), 15U);
}

TEST(DictionaryRange, agrees_with_arithmetic_for_any_value_and_limits) {
  const bool held = rc::check("signed", [] {
    const DataType type = signed_types[*rc::gen::inRange(0, 8)];
    const unsigned unused = 64 - bit_length(type);
    const auto any = [&] { return *rc::gen::arbitrary<std::int64_t>() >> unused; };
    const std::int64_t low = any();
    const std::int64_t high = any();
    const std::int64_t value = any();
    Limited sut(type, low, high);
    const AbortCode expected = value < low    ? AbortCode::value_too_low
                               : value > high ? AbortCode::value_too_high
                                              : AbortCode::none;
    RC_ASSERT(sut.write(static_cast<std::uint64_t>(value)) == expected);
  });
  EXPECT_TRUE(held);
}

// Strings

constexpr auto strings = lay_out(std::to_array<ObjectRow>({{.index = 0x1008, .entry_count = 1},
                                                           {.index = 0x2000, .entry_count = 2}}),
                                 std::to_array<EntryRow>({{.type = DataType::visible_string,
                                                           .access = Access::rw,
                                                           .capacity = 8,
                                                           .initial_text = "canvoy"},
                                                          {.access = Access::const_, .initial = 3},
                                                          {.sub_first = 1,
                                                           .sub_last = 3,
                                                           .type = DataType::octet_string,
                                                           .access = Access::rw,
                                                           .capacity = 300}}));

TEST(DictionaryString, has_its_default_text) {
  Held sut(strings.tables());
  EXPECT_EQ(sut.read(0x1008, 0), (Bytes{'c', 'a', 'n', 'v', 'o', 'y'}));
  EXPECT_EQ(sut.read(0x2000, 1), Bytes{});
  EXPECT_EQ(sut.abort, AbortCode::none);
}

TEST(DictionaryString, has_any_length_up_to_its_capacity) {
  Held sut(strings.tables());
  for (std::size_t length = 0; length <= 8; ++length) {
    const Bytes text(length, 'x');
    EXPECT_EQ(sut.write(0x1008, 0, text), AbortCode::none);
    EXPECT_EQ(sut.read(0x1008, 0), text);
  }
  EXPECT_EQ(sut.write(0x1008, 0, Bytes(9, 'y')), AbortCode::length_too_high);
  EXPECT_EQ(sut.read(0x1008, 0), Bytes(8, 'x'));
}

TEST(DictionaryString, does_not_touch_its_neighbours) {
  Held sut(strings.tables());
  for (std::uint8_t sub = 1; sub <= 3; ++sub) {
    EXPECT_EQ(sut.write(0x2000, sub, Bytes(300, sub)), AbortCode::none);
  }
  EXPECT_EQ(sut.write(0x2000, 2, Bytes(255, 0xAA)), AbortCode::none);
  EXPECT_EQ(sut.read(0x2000, 1), Bytes(300, 1));
  EXPECT_EQ(sut.read(0x2000, 2), Bytes(255, 0xAA));
  EXPECT_EQ(sut.read(0x2000, 3), Bytes(300, 3));
  EXPECT_EQ(sut.write(0x2000, 2, {}), AbortCode::none);
  EXPECT_EQ(sut.read(0x2000, 2), Bytes{});
}

TEST(DictionaryString, is_cut_when_the_device_itself_sets_too_much) {
  Held sut(strings.tables());
  sut.dictionary.set(sut.entry(0x1008), Bytes(20, 'z'));
  EXPECT_EQ(sut.read(0x1008, 0), Bytes(8, 'z'));
}

TEST(DictionaryString, is_no_number) {
  Held sut(strings.tables());
  EXPECT_FALSE(sut.dictionary.set_number(0x1008, 0, 7));
  EXPECT_EQ(sut.dictionary.number(0x1008, 0), 0U);
}

TEST(DictionaryString, tells_its_watchers_of_a_change_of_length_as_well) {
  Held sut(strings.tables());
  sut.dictionary.watch(sut.entry(0x1008), 1);
  sut.dictionary.set(sut.entry(0x1008), Bytes{'c', 'a', 'n', 'v', 'o', 'y'});
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set(sut.entry(0x1008), Bytes{'c', 'a', 'n'});
  EXPECT_EQ(sut.dictionary.changes(), 1U);
}

// Numbers from inside

TEST(DictionaryNumber, is_cut_to_the_length_of_the_entry_and_read_without_sign) {
  Held sut(types.tables());
  for (std::size_t i = 0; i < type_count; ++i) {
    const auto index = static_cast<std::uint16_t>(0x2000 + i);
    EXPECT_TRUE(sut.dictionary.set_number(index, 0, ~std::uint64_t{0}));
    const std::uint64_t all_ones = ~std::uint64_t{0} >> (64 - 8 * type_bytes[i]);
    EXPECT_EQ(sut.dictionary.number(index, 0), all_ones);
  }
}

TEST(DictionaryNumber, does_not_touch_its_neighbours) {
  Held sut(shapes.tables());
  for (std::uint16_t index = 0x6100; index <= 0x610F; ++index) {
    for (std::uint8_t sub = 1; sub <= 4; ++sub) {
      EXPECT_TRUE(sut.dictionary.set_number(index, sub, index * 16U + sub));
    }
  }
  for (std::uint16_t index = 0x6100; index <= 0x610F; ++index) {
    for (std::uint8_t sub = 1; sub <= 4; ++sub) {
      EXPECT_EQ(sut.dictionary.number(index, sub), index * 16U + sub);
    }
    EXPECT_EQ(sut.dictionary.number(index, 0), 9U);
    EXPECT_EQ(sut.dictionary.number(index, 9), 0U);
  }
}

TEST(DictionaryNumber, is_extended_by_its_sign_bit) {
  EXPECT_EQ(sign_extend(0xFF, 8), -1);
  EXPECT_EQ(sign_extend(0x7F, 8), 127);
  EXPECT_EQ(sign_extend(0x1234'5680, 8), -128);
  EXPECT_EQ(sign_extend(0x80'0000, 24), -8'388'608);
  EXPECT_EQ(sign_extend(0x8000'0000'0000'0000, 64), INT64_MIN);
  EXPECT_EQ(sign_extend(1, 1), -1);
}

// Defaults

constexpr auto defaults =
    lay_out(std::to_array<ObjectRow>({{.index = 0x0FFF, .entry_count = 1},
                                      {.index = 0x1000, .entry_count = 1},
                                      {.index = 0x1FFE, .count = 4, .entry_count = 2},
                                      {.index = 0x2010, .entry_count = 1}}),
            std::to_array<EntryRow>(
                {{.access = Access::rw, .initial = 1},
                 {.type = DataType::unsigned32,
                  .access = Access::rw,
                  .traits = EntryTraits::plus_node_id,
                  .initial = 0x8000'0180},
                 {.access = Access::rw, .initial = 3},
                 {.sub_first = 1, .sub_last = 2, .type = DataType::integer40, .initial = -4},
                 {.type = DataType::real32, .access = Access::rw, .initial = 0x3F80'0000}}));

TEST(DictionaryDefault, is_restored_for_the_objects_that_are_asked_for) {
  Held sut(defaults.tables(), 0x0A);
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0x8000'018AU);
  EXPECT_EQ(sut.dictionary.number(0x2001, 2), 0xFF'FFFF'FFFCU);
  EXPECT_EQ(sut.read(0x2010, 0), (Bytes{0x00, 0x00, 0x80, 0x3F}));

  const std::uint16_t all[] = {0x0FFF, 0x1000, 0x1FFE, 0x1FFF, 0x2000, 0x2001, 0x2010};
  for (const std::uint16_t index : all) sut.dictionary.set_number(index, 0, 0x77);
  sut.dictionary.restore_defaults(0x1000, 0x1FFF, 0x0B);
  EXPECT_EQ(sut.dictionary.number(0x0FFF, 0), 0x77U);
  EXPECT_EQ(sut.dictionary.number(0x1000, 0), 0x8000'018BU);
  EXPECT_EQ(sut.dictionary.number(0x1FFE, 0), 3U);
  EXPECT_EQ(sut.dictionary.number(0x1FFF, 0), 3U);
  EXPECT_EQ(sut.dictionary.number(0x2000, 0), 0x77U) << "of the same row, but not asked for";
  EXPECT_EQ(sut.dictionary.number(0x2001, 0), 0x77U);
  EXPECT_EQ(sut.dictionary.number(0x2010, 0), 0x77U);
}

// Hooks

/// A hook that writes down its calls, and refuses by will.
struct Recorder {
  Recorder(Dictionary& dictionary, std::uint16_t first, std::uint16_t last,
           std::vector<std::string>& calls, std::string by)
      : log(calls), name(std::move(by)) {
    hook.first = first;
    hook.last = last;
    hook.before_read = Callback<AbortCode(const Entry&)>::to<&Recorder::before_read>(*this);
    hook.before_write = Callback<AbortCode(
        const Entry&, std::span<const std::uint8_t>)>::to<&Recorder::before_write>(*this);
    hook.after_write = Callback<void(const Entry&, Source)>::to<&Recorder::after_write>(*this);
    dictionary.attach(hook);
  }
  void note(const char* what, const Entry& entry) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %s %04X:%u", name.c_str(), what, entry.index, entry.sub);
    log.emplace_back(text);
  }
  AbortCode before_read(const Entry& entry) {
    note("reads", entry);
    return answer;
  }
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value) {
    note("checks", entry);
    seen.assign(value.begin(), value.end());
    return answer;
  }
  void after_write(const Entry& entry, Source by) {
    note("wrote", entry);
    source = by;
  }

  Hook hook;
  std::vector<std::string>& log;
  std::string name;
  AbortCode answer = AbortCode::none;
  Source source = Source::application;
  Bytes seen;
};

using Log = std::vector<std::string>;

TEST(DictionaryHook, is_called_before_a_read_and_around_a_write) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x1018, 0x1018, log, "a");
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}, Source::pdo), AbortCode::none);
  EXPECT_EQ(log, (Log{"a reads 1018:1", "a checks 1018:1", "a wrote 1018:1"}));
  EXPECT_EQ(hook.seen, (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(hook.source, Source::pdo);
}

TEST(DictionaryHook, is_called_for_its_range_within_a_row_of_objects_only) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x6105, 0x6106, log, "a");
  for (std::uint16_t index = 0x6104; index <= 0x6107; ++index) sut.write(index, 9, {1});
  sut.write(0x6000, 1, {1, 2});
  sut.write(0xFFFF, 0, {1});
  EXPECT_EQ(log, (Log{"a checks 6105:9", "a wrote 6105:9", "a checks 6106:9", "a wrote 6106:9"}));
}

TEST(DictionaryHook, may_refuse_a_read_or_a_write_which_then_changes_nothing) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x1018, 0x1018, log, "a");
  sut.write(0x1018, 1, {1, 2, 3, 4});
  log.clear();
  hook.answer = AbortCode::device_state;
  EXPECT_EQ(sut.write(0x1018, 1, {5, 6, 7, 8}), AbortCode::device_state);
  EXPECT_EQ(sut.read(0x1018, 1), Bytes{});
  EXPECT_EQ(sut.abort, AbortCode::device_state);
  EXPECT_EQ(log, (Log{"a checks 1018:1", "a reads 1018:1"})) << "after_write is not called";
  hook.answer = AbortCode::none;
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{1, 2, 3, 4}));
}

TEST(DictionaryHook, is_not_asked_when_access_length_or_range_forbid_the_write) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x0000, 0xFFFF, log, "a");
  EXPECT_EQ(sut.write(0x1018, 0, {1}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x1018, 1, {1}), AbortCode::length_too_low);
  EXPECT_EQ(sut.write(0x1018, 2, {1}), AbortCode::no_sub_index);
  EXPECT_EQ(log, Log{});
}

TEST(DictionaryHook, stands_beside_others_on_one_object_and_the_last_attached_comes_first) {
  Held sut(shapes.tables());
  Log log;
  Recorder a(sut.dictionary, 0x1018, 0x1018, log, "a");
  Recorder b(sut.dictionary, 0x1000, 0x1FFF, log, "b");
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}), AbortCode::none);
  EXPECT_EQ(log, (Log{"b checks 1018:1", "a checks 1018:1", "b wrote 1018:1", "a wrote 1018:1"}));
  log.clear();
  b.answer = AbortCode::local_control;
  EXPECT_EQ(sut.write(0x1018, 1, {5, 6, 7, 8}), AbortCode::local_control);
  EXPECT_EQ(log, (Log{"b checks 1018:1"})) << "the first refusal is the answer";
}

TEST(DictionaryHook, is_not_called_for_what_the_device_itself_sets) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x0000, 0xFFFF, log, "a");
  sut.dictionary.set_number(0x1018, 1, 7);
  sut.dictionary.set(sut.entry(0x1018, 3), Bytes{1, 2});
  sut.dictionary.restore_defaults(0, 0xFFFF, 1);
  EXPECT_EQ(log, Log{});
}

TEST(DictionaryHook, may_refresh_a_value_before_it_is_read) {
  struct Clock {
    AbortCode tick(const Entry& entry) {
      dictionary.set(entry, bytes_of(++count, 4));
      return AbortCode::none;
    }
    Dictionary& dictionary;
    std::uint32_t count = 0;
  };
  Held sut(shapes.tables());
  Clock clock{sut.dictionary};
  Hook hook{.first = 0x1018, .last = 0x1018};
  hook.before_read = Callback<AbortCode(const Entry&)>::to<&Clock::tick>(clock);
  sut.dictionary.attach(hook);
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{1, 0, 0, 0}));
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{2, 0, 0, 0}));
}

TEST(DictionaryHook, is_counted_as_a_revision) {
  Held sut(shapes.tables());
  const std::uint32_t before = sut.dictionary.revision();
  Hook hook{.first = 0x1018, .last = 0x1018};
  sut.dictionary.attach(hook);
  EXPECT_NE(sut.dictionary.revision(), before);
}

TEST(DictionaryHook, is_told_alone_by_announce) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x1018, 0x1018, log, "a");
  sut.dictionary.announce(sut.entry(0x1018, 1), Source::pdo);
  sut.dictionary.announce(sut.entry(0x6000, 1), Source::pdo);
  EXPECT_EQ(log, (Log{"a wrote 1018:1"}));
}

// Domains

constexpr auto domains = lay_out(std::to_array<ObjectRow>({{.index = 0x1F50, .entry_count = 2}}),
                                 std::to_array<EntryRow>({{.access = Access::const_, .initial = 1},
                                                          {.sub_first = 1,
                                                           .sub_last = 1,
                                                           .type = DataType::domain,
                                                           .access = Access::rw,
                                                           .capacity = 99}}));

TEST(DictionaryDomain, takes_no_memory_and_has_no_value_of_its_own) {
  EXPECT_EQ(domains.tables().value_bytes, 1U);
  Held sut(domains.tables());
  sut.read(0x1F50, 1);
  EXPECT_EQ(sut.abort, AbortCode::unsupported_access);
  EXPECT_FALSE(sut.dictionary.set_number(0x1F50, 1, 5));
  EXPECT_EQ(sut.dictionary.domain(sut.entry(0x1F50, 1)), nullptr);
}

TEST(DictionaryDomain, is_served_by_the_hook_that_carries_it) {
  Held sut(domains.tables());
  const Domain domain{};
  Hook other{.first = 0x1F50, .last = 0x1F50};
  Hook hook{.first = 0x1F50, .last = 0x1F50, .domain = &domain};
  Hook elsewhere{.first = 0x1F51, .last = 0x1F51, .domain = &domain};
  sut.dictionary.attach(hook);
  sut.dictionary.attach(other);
  sut.dictionary.attach(elsewhere);
  EXPECT_EQ(sut.dictionary.domain(sut.entry(0x1F50, 1)), &domain);
}

// Watchers

TEST(DictionaryChanges, tell_the_watchers_of_what_changed_and_of_nothing_else) {
  Held sut(shapes.tables());
  sut.dictionary.watch(sut.entry(0x1018, 1), 0x0000'0004);
  sut.dictionary.watch(sut.entry(0x6000, 7), 0x8000'0000);
  sut.dictionary.watch(sut.entry(0x6000, 7), 0x0000'0001);
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set_number(0x0001, 0, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set_number(0x1018, 1, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0x0000'0004U);
  sut.dictionary.set_number(0x6000, 8, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0x8000'0005U) << "a row has its watchers in common";
  sut.dictionary.clear_changes();
  sut.dictionary.set_number(0x1018, 1, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0U) << "the same value again";
  sut.write(0x1018, 1, {1, 0, 0, 0});
  EXPECT_EQ(sut.dictionary.changes(), 0x0000'0004U) << "from the bus";
  EXPECT_EQ(sut.write(0x1018, 1, {1}), AbortCode::length_too_low);
  sut.dictionary.clear_changes();
  sut.dictionary.mark_changed(0x40);
  EXPECT_EQ(sut.dictionary.changes(), 0x40U);
}

TEST(DictionaryChanges, are_not_told_any_more_to_who_has_gone) {
  Held sut(shapes.tables());
  const std::uint32_t before = sut.dictionary.revision();
  sut.dictionary.watch(sut.entry(0x1018, 1), 0x3);
  const std::uint32_t watched = sut.dictionary.revision();
  EXPECT_NE(watched, before);
  sut.dictionary.unwatch(0x1);
  EXPECT_NE(sut.dictionary.revision(), watched);
  sut.dictionary.set_number(0x1018, 1, 9);
  EXPECT_EQ(sut.dictionary.changes(), 0x2U);
}

TEST(DictionaryChanges, include_the_return_of_a_default) {
  Held sut(defaults.tables());
  sut.dictionary.watch(sut.entry(0x0FFF), 1);
  sut.dictionary.restore_defaults(0, 0xFFFF, 5);
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set_number(0x0FFF, 0, 2);
  sut.dictionary.clear_changes();
  sut.dictionary.restore_defaults(0, 0xFFFF, 5);
  EXPECT_EQ(sut.dictionary.changes(), 1U);
}

}  // namespace
}  // namespace canvoy
