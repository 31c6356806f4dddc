#include "canvoy/canopen/manager/concise_dcf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace canvoy::concise_dcf_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Two entries: 1017h:00h = 500 (U16), 2001h:02h = "Canvoy" (6 bytes).
const Bytes two_entries = {0x02, 0x00, 0x00, 0x00,                    // two entries
                           0x17, 0x10, 0x00, 0x02, 0x00, 0x00, 0x00,  // 1017h:00h, 2 bytes
                           0xF4, 0x01,                                // 500
                           0x01, 0x20, 0x02, 0x06, 0x00, 0x00, 0x00,  // 2001h:02h, 6 bytes
                           0x43, 0x61, 0x6E, 0x76, 0x6F, 0x79};       // "Canvoy"

/// Bytes in memory that the reader must not leave.
struct Memory {
  explicit Memory(Bytes content) : bytes(std::move(content)) {}
  AbortCode read(std::uint32_t offset, std::span<std::uint8_t> to) {
    if (offset + to.size() > bytes.size()) {
      ADD_FAILURE() << "reads " << to.size() << " bytes from " << offset << " of " << bytes.size();
      return AbortCode::general;
    }
    if (offset + to.size() > broken_from) return AbortCode::hardware;
    std::copy_n(bytes.begin() + offset, to.size(), to.begin());
    return AbortCode::none;
  }
  ByteSource source() {
    return {static_cast<std::uint32_t>(bytes.size()), callback<&Memory::read>(*this)};
  }

  Bytes bytes;
  std::size_t broken_from = SIZE_MAX;
};

AbortCode check(const Bytes& bytes) {
  Memory memory(bytes);
  return check_concise_dcf(memory.source()).abort();
}

TEST(ConciseDcf, HoldsIndexSubIndexSizeAndValueOfEachEntry) {
  Memory memory(two_entries);
  ConciseDcf sut;
  ASSERT_EQ(sut.open(memory.source()), AbortCode::none);
  EXPECT_EQ(sut.count(), 2u);
  const auto first = sut.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->index, 0x1017);
  EXPECT_EQ(first->sub, 0);
  EXPECT_EQ(first->size, 2u);
  Bytes value(2);
  EXPECT_EQ(sut.read(*first, 0, value), AbortCode::none);
  EXPECT_EQ(value, (Bytes{0xF4, 0x01}));
  EXPECT_FALSE(sut.at_end());
  const auto second = sut.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->index, 0x2001);
  EXPECT_EQ(second->sub, 2);
  EXPECT_EQ(second->size, 6u);
  EXPECT_EQ(sut.read(*second, 4, value), AbortCode::none);
  EXPECT_EQ(value, (Bytes{'o', 'y'})) << "a piece of a value";
  EXPECT_TRUE(sut.at_end());
  EXPECT_EQ(sut.next().abort(), AbortCode::no_data);
  EXPECT_EQ(sut.position(), 2u);
}

TEST(ConciseDcf, AValueIsNotReadBeyondItsEnd) {
  Memory memory(two_entries);
  ConciseDcf sut;
  ASSERT_EQ(sut.open(memory.source()), AbortCode::none);
  const auto first = sut.next();
  Bytes value(2);
  EXPECT_EQ(sut.read(*first, 1, value), AbortCode::length_too_high);
  EXPECT_EQ(sut.read(*first, 3, {}), AbortCode::length_too_high);
  EXPECT_EQ(sut.read(*first, 0xFFFF'FFFF, value), AbortCode::length_too_high);
  EXPECT_EQ(sut.read(*first, 2, {}), AbortCode::none);
}

TEST(ConciseDcf, MayBeEmpty) {
  EXPECT_EQ(check({0, 0, 0, 0}), AbortCode::none);
}

TEST(ConciseDcf, AnEntryMayHaveNoBytes) {
  EXPECT_EQ(check({1, 0, 0, 0, 0x01, 0x20, 0, 0, 0, 0, 0}), AbortCode::none);
}

TEST(ConciseDcf, IsRefusedWhereverItIsCut) {
  EXPECT_EQ(check(two_entries), AbortCode::none);
  for (std::size_t length = 0; length < two_entries.size(); ++length) {
    const Bytes cut(two_entries.begin(), two_entries.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_EQ(check(cut), AbortCode::length_too_low) << length;
  }
}

TEST(ConciseDcf, IsRefusedWithAnythingBehindItsLastEntry) {
  Bytes longer = two_entries;
  longer.push_back(0);
  EXPECT_EQ(check(longer), AbortCode::length_too_high);
  EXPECT_EQ(check({0, 0, 0, 0, 0}), AbortCode::length_too_high);
}

TEST(ConciseDcf, ACountThatItsSizeCannotHoldIsRefusedAtOnce) {
  for (const std::uint32_t count : {3u, 4u, 0x100u, 0x7FFF'FFFFu, 0x8000'0000u, 0xFFFF'FFFFu}) {
    Bytes bytes = two_entries;
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(count >> 8 * i);
    EXPECT_EQ(check(bytes), AbortCode::length_too_low) << count;
  }
}

TEST(ConciseDcf, ACountBelowTheEntriesIsRefused) {
  Bytes bytes = two_entries;
  bytes[0] = 1;
  EXPECT_EQ(check(bytes), AbortCode::length_too_high);
  bytes[0] = 0;
  EXPECT_EQ(check(bytes), AbortCode::length_too_high);
}

TEST(ConciseDcf, ASizeBeyondTheEndIsRefused) {
  for (const std::uint32_t size : {7u, 8u, 0x100u, 0x7FFF'FFFFu, 0xFFFF'FFF0u, 0xFFFF'FFFFu}) {
    for (const std::size_t at : {std::size_t{7}, std::size_t{16}}) {
      Bytes bytes = two_entries;
      // The first entry swallows the second, or the second ends beyond the end.
      const std::uint32_t value = at == 7 ? size + 20 : size;
      for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
      EXPECT_NE(check(bytes), AbortCode::none) << size << " at " << at;
    }
  }
}

/// Each bit of the count and the headers, and each byte with each value: no read beyond the end.
TEST(ConciseDcf, NoChangeOfAnyByteMakesItReadBeyondItsEnd) {
  for (std::size_t at = 0; at < two_entries.size(); ++at) {
    for (unsigned value = 0; value < 256; ++value) {
      Bytes bytes = two_entries;
      bytes[at] = static_cast<std::uint8_t>(value);
      Memory memory(bytes);
      const auto count = check_concise_dcf(memory.source());
      const bool in_value = at == 11 || at == 12 || at >= 20;
      const bool in_address = (at >= 4 && at <= 6) || (at >= 13 && at <= 15);
      EXPECT_EQ(bool(count), in_value || in_address || value == two_entries[at]) << at;
    }
  }
}

TEST(ConciseDcf, ASourceThatFailsIsTold) {
  for (std::size_t from = 0; from < 20; ++from) {
    Memory memory(two_entries);
    memory.broken_from = from;
    const auto count = check_concise_dcf(memory.source());
    EXPECT_EQ(count.abort(), AbortCode::hardware) << from;
  }
}

}  // namespace
}  // namespace canvoy::concise_dcf_test
