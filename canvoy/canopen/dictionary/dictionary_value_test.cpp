#include "canvoy/canopen/dictionary/dictionary.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "canvoy/canopen/testing/held_dictionary.hpp"

namespace canvoy::dictionary_value_test {
namespace {

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

// CiA 301, 7.1.4: length of a value of the type in bytes.
constexpr std::size_t type_bytes[type_count] = {1, 1, 2, 4, 1, 2, 4, 4, 6, 6, 3,
                                                8, 5, 6, 7, 8, 3, 5, 6, 7, 8};

TEST(DictionaryLength, IsThatOfTheTypeAndNoOther) {
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

TEST(DictionaryLength, KeepsEveryBitOfEveryType) {
  Held sut(types.tables());
  // Except a Boolean, which has one: see OfABooleanIsZeroAndOne.
  for (std::size_t i = 1; i < type_count; ++i) {
    const auto index = static_cast<std::uint16_t>(0x2000 + i);
    for (const Bytes& pattern : {bytes_of(0xFEDC'BA98'7654'3210, type_bytes[i]),
                                 Bytes(type_bytes[i], 0xFF), Bytes(type_bytes[i], 0x00)}) {
      EXPECT_EQ(sut.write(index, 0, pattern), AbortCode::none) << std::hex << index;
      EXPECT_EQ(sut.read(index, 0), pattern);
    }
  }
}

TEST(DictionaryLength, RefusesBitsThatAnOddSizedIntegerDoesNotHave) {
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

// Ranges

/// One entry 2000h of a type with limits.
struct Limited {
  Limited(DataType type, std::int64_t low, std::int64_t high,
          EntryTraits traits = EntryTraits::limited, std::int64_t sentinel = 0)
      : layout(lay_out(std::array{ObjectRow{.index = 0x2000, .entry_count = 1}},
                       std::array{EntryRow{.type = type,
                                           .access = Access::rw,
                                           .traits = traits,
                                           .low = low,
                                           .high = high,
                                           .sentinel = sentinel}})),
        held(layout.tables()) {}

  AbortCode write(std::uint64_t number) {
    const EntryShape& entry = layout.entries[0];
    const Bytes value = bytes_of(number, entry.capacity);
    const AbortCode answer = held.write(0x2000, 0, value);
    EXPECT_EQ(answer, held.dictionary.check_value(entry, value));
    return answer;
  }

  DictionaryLayout<1, 1> layout;
  Held held;
};

constexpr DataType unsigned_types[] = {
    DataType::unsigned8,  DataType::unsigned16, DataType::unsigned24, DataType::unsigned32,
    DataType::unsigned40, DataType::unsigned48, DataType::unsigned56, DataType::unsigned64};
constexpr DataType signed_types[] = {DataType::integer8,  DataType::integer16, DataType::integer24,
                                     DataType::integer32, DataType::integer40, DataType::integer48,
                                     DataType::integer56, DataType::integer64};

TEST(DictionaryRange, HoldsForUnsignedIntegersOfAllSizes) {
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

TEST(DictionaryRange, HoldsForSignedIntegersOfAllSizes) {
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

TEST(DictionaryRange, ReachesToBothEndsOf64Bits) {
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

TEST(DictionaryRange, LetsASentinelPassOutsideOfTheLimits) {
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

TEST(DictionaryRange, DoesNotHoldWhereTheEntryHasNone) {
  Limited sut(DataType::unsigned16, 10, 20, EntryTraits::none);
  for (const std::uint64_t number : {0U, 9U, 21U, 0xFFFFU}) {
    EXPECT_EQ(sut.write(number), AbortCode::none);
  }
}

TEST(DictionaryRange, OfABooleanIsZeroAndOne) {
  Limited sut(DataType::boolean, 0, 1, EntryTraits::none);
  for (unsigned byte = 0; byte < 2; ++byte) EXPECT_EQ(sut.write(byte), AbortCode::none);
  for (unsigned byte = 2; byte < 256; ++byte) {
    EXPECT_EQ(sut.write(byte), AbortCode::value_too_high);
  }
}

TEST(DictionaryRange, DoesNotHoldForRealsAndTimes) {
  for (const DataType type : {DataType::real32, DataType::real64, DataType::time_of_day}) {
    Limited sut(type, 1, 2);
    EXPECT_EQ(sut.write(0), AbortCode::none);
    EXPECT_EQ(sut.write(~std::uint64_t{0}), AbortCode::none);
  }
}

TEST(DictionaryRange, ChangesNothingWhenItRefuses) {
  Limited sut(DataType::unsigned16, 10, 20);
  ASSERT_EQ(sut.write(15), AbortCode::none);
  EXPECT_EQ(sut.write(21), AbortCode::value_too_high);
  EXPECT_EQ(sut.held.write(0x2000, 0, {1}), AbortCode::length_too_low);
  EXPECT_EQ(sut.held.dictionary.number(0x2000, 0), 15U);
}

TEST(DictionaryRange, AgreesWithArithmeticForAnyValueAndLimits) {
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

TEST(DictionaryString, HasItsDefaultText) {
  Held sut(strings.tables());
  EXPECT_EQ(sut.read(0x1008, 0), (Bytes{'c', 'a', 'n', 'v', 'o', 'y'}));
  EXPECT_EQ(sut.read(0x2000, 1), Bytes{});
  EXPECT_EQ(sut.abort, AbortCode::none);
}

TEST(DictionaryString, HasAnyLengthUpToItsCapacity) {
  Held sut(strings.tables());
  for (std::size_t length = 0; length <= 8; ++length) {
    const Bytes text(length, 'x');
    EXPECT_EQ(sut.write(0x1008, 0, text), AbortCode::none);
    EXPECT_EQ(sut.read(0x1008, 0), text);
  }
  EXPECT_EQ(sut.write(0x1008, 0, Bytes(9, 'y')), AbortCode::length_too_high);
  EXPECT_EQ(sut.read(0x1008, 0), Bytes(8, 'x'));
}

TEST(DictionaryString, DoesNotTouchItsNeighbours) {
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

TEST(DictionaryString, IsCutWhenTheDeviceItselfSetsTooMuch) {
  Held sut(strings.tables());
  sut.dictionary.set(sut.entry(0x1008), Bytes(20, 'z'));
  EXPECT_EQ(sut.read(0x1008, 0), Bytes(8, 'z'));
}

TEST(DictionaryString, IsNoNumber) {
  Held sut(strings.tables());
  EXPECT_FALSE(sut.dictionary.set_number(0x1008, 0, 7));
  EXPECT_EQ(sut.dictionary.number(0x1008, 0), 0U);
}

TEST(DictionaryString, TellsItsWatchersOfAChangeOfLengthAsWell) {
  Held sut(strings.tables());
  sut.dictionary.watch(sut.entry(0x1008), 1);
  sut.dictionary.set(sut.entry(0x1008), Bytes{'c', 'a', 'n', 'v', 'o', 'y'});
  EXPECT_EQ(sut.dictionary.changes(), 0U);
  sut.dictionary.set(sut.entry(0x1008), Bytes{'c', 'a', 'n'});
  EXPECT_EQ(sut.dictionary.changes(), 1U);
}

// Numbers from inside

TEST(DictionaryNumber, IsCutToTheLengthOfTheEntryAndReadWithoutSign) {
  Held sut(types.tables());
  for (std::size_t i = 0; i < type_count; ++i) {
    const auto index = static_cast<std::uint16_t>(0x2000 + i);
    EXPECT_TRUE(sut.dictionary.set_number(index, 0, ~std::uint64_t{0}));
    const std::uint64_t all_ones = ~std::uint64_t{0} >> (64 - 8 * type_bytes[i]);
    EXPECT_EQ(sut.dictionary.number(index, 0), all_ones);
  }
}

TEST(DictionaryNumber, DoesNotTouchItsNeighbours) {
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

TEST(DictionaryNumber, IsExtendedByItsSignBit) {
  EXPECT_EQ(sign_extend(0xFF, 8), -1);
  EXPECT_EQ(sign_extend(0x7F, 8), 127);
  EXPECT_EQ(sign_extend(0x1234'5680, 8), -128);
  EXPECT_EQ(sign_extend(0x80'0000, 24), -8'388'608);
  EXPECT_EQ(sign_extend(0x8000'0000'0000'0000, 64), INT64_MIN);
  EXPECT_EQ(sign_extend(1, 1), -1);
}

}  // namespace
}  // namespace canvoy::dictionary_value_test
