// Stored contents that are damaged, or of another kind, are refused as a whole: defaults, and
// emergency 6300h with the reason in byte 3.
#include <gtest/gtest.h>

#include "canvoy/canopen/storage/crc32.hpp"
#include "canvoy/canopen/storage/testing/storage_node.hpp"

namespace canvoy::storage_refusal_test {
namespace {

constexpr std::uint32_t head_size = 32;

/// Tables of a device that differs from stored_layout in one place.
template <class Change>
auto tables_with(Change change) {
  auto entries = stored_entries;
  change(entries);
  return lay_out(stored_objects, entries);
}

class StorageRefusal : public testing::Test {
 protected:
  StorageRefusal() {
    StoringNode node(memory);
    node.booted();
    defaults = node.parameters();
    node.set_all(1);
    stored = node.parameters();
    node.save();
  }
  std::string emergency(unsigned reason) {
    return "085#00 63 01 0" + std::to_string(reason) + " 00 00 00 00";
  }
  void expect_refused(RecordState reason) {
    StoringNode sut(memory);
    sut.expect({"705#00", emergency(static_cast<unsigned>(reason))});
    EXPECT_EQ(sut.storage.state(), reason);
    EXPECT_EQ(sut.parameters(), defaults);
  }
  /// A head with changed contents, and a matching CRC.
  void change_head(std::size_t word, std::uint32_t value) {
    store(memory.bytes.data() + 4 * word, value);
    store(memory.bytes.data() + 28, crc32(std::span(memory.bytes).first(28)));
  }
  std::uint32_t head_word(std::size_t word) {
    return load<std::uint32_t>(memory.bytes.data() + 4 * word);
  }
  /// Changes the content, with correct CRCs.
  void seal() {
    const std::uint32_t length = head_word(3);
    change_head(4, crc32(std::span(memory.bytes).subspan(head_size, length)));
  }

  SimulatedFlash memory{stored_geometry};
  StoringNode::Parameters defaults;
  StoringNode::Parameters stored;
};

/// Never a part of them.
TEST_F(StorageRefusal, WhicheverReadFailsTheValuesAreThoseStoredOrDefaults) {
  for (unsigned tried = 1;; ++tried) {
    memory.fail_read_at = tried;
    StoringNode sut(memory);
    if (std::exchange(memory.fail_read_at, 0) != 0) {
      EXPECT_EQ(sut.parameters(), stored);
      EXPECT_GT(tried, 10u);
      break;
    }
    EXPECT_NE(sut.storage.state(), RecordState::valid) << tried;
    EXPECT_EQ(sut.parameters(), defaults) << tried;
  }
}

/// Groups that are not stored now are copied from the old set.
TEST_F(StorageRefusal, WhicheverReadFailsASaveKeepsTheOldSetOrMakesAWholeNewOne) {
  const SimulatedFlash::Bytes kept = memory.bytes;
  for (unsigned tried = 1;; ++tried) {
    memory.bytes = kept;
    StoringNode before(memory);
    before.booted();
    before.set_all(2);
    memory.fail_read_at = tried;
    before.receive("605#23 10 10 04 73 61 76 65");  // 2000h to 20FFh
    before.run_for(1s);
    const bool is_over = std::exchange(memory.fail_read_at, 0) != 0;
    StoringNode sut(memory);
    EXPECT_EQ(sut.storage.state(), RecordState::valid) << tried;
    StoringNode::Parameters saved = stored;
    saved[0] = "set 2";  // 2010h
    saved[3] = "2";      // 2000h
    EXPECT_TRUE(sut.parameters() == saved || (!is_over && sut.parameters() == stored)) << tried;
    if (is_over) break;
  }
}

TEST_F(StorageRefusal, EachBitOfTheContentCounts) {
  const std::uint32_t length = head_word(3);
  for (std::uint32_t bit = 0; bit < 8 * length; ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
    memory.bytes[head_size + bit / 8] ^= mask;
    StoringNode sut(memory);
    ASSERT_EQ(sut.storage.state(), RecordState::damaged) << "bit " << bit;
    ASSERT_EQ(sut.parameters(), defaults);
    memory.bytes[head_size + bit / 8] ^= mask;
  }
}

TEST_F(StorageRefusal, EachBitOfTheHeadCounts) {
  for (std::uint32_t bit = 0; bit < 8 * head_size; ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
    memory.bytes[bit / 8] ^= mask;
    StoringNode sut(memory);
    ASSERT_EQ(sut.storage.state(), RecordState::damaged) << "bit " << bit;
    ASSERT_EQ(sut.parameters(), defaults);
    memory.bytes[bit / 8] ^= mask;
  }
}

TEST_F(StorageRefusal, ADamagedSetIsToldOnceByAnEmergency) {
  memory.bytes[head_size + 9] ^= 1;
  expect_refused(RecordState::damaged);
}

// The older set was replaced on purpose: a return to it would mix values of different times.
TEST_F(StorageRefusal, TheOlderSetDoesNotStandInForADamagedOne) {
  StoringNode node(memory);
  node.sent.clear();
  node.set_all(2);
  node.save();
  memory.bytes[256 + head_size + 9] ^= 1;
  expect_refused(RecordState::damaged);
}

TEST_F(StorageRefusal, RandomBytesAreRefused) {
  for (std::size_t i = 0; i < memory.bytes.size(); ++i) {
    memory.bytes[i] = static_cast<std::uint8_t>(i * 37 + i / 11);
  }
  expect_refused(RecordState::damaged);
}

TEST_F(StorageRefusal, AnotherKindOfRecordIsForeign) {
  change_head(0, 0x1234'5678);
  expect_refused(RecordState::foreign);
}

TEST_F(StorageRefusal, AnotherFormatIsRefused) {
  for (const std::uint32_t format : {0U, 2U, 0xFFFF'FFFFU}) {
    change_head(1, format);
    expect_refused(RecordState::other_format);
  }
}

TEST_F(StorageRefusal, ASetThatIsLongerThanItsPlaceIsRefused) {
  for (const std::uint32_t length : {225U, 256U, 0x7FFF'FFFFU, 0xFFFF'FFFFU}) {
    change_head(3, length);
    expect_refused(RecordState::too_long);
  }
}

TEST_F(StorageRefusal, ASetOfAnotherDeviceTypeIsForeign) {
  static const auto other = tables_with([](auto& entries) { entries[0].initial = 0x191; });
  StoringNode sut(memory, stored_settings, other.tables());
  sut.expect({"705#00", emergency(4)});
  EXPECT_EQ(sut.storage.state(), RecordState::foreign);
  EXPECT_EQ(sut.parameters(), defaults);
}

TEST_F(StorageRefusal, ASetOfAnotherVendorOrProductIsForeign) {
  static const auto other = tables_with([](auto& entries) { entries[8].initial = 0x124; });
  StoringNode sut(memory, stored_settings, other.tables());
  EXPECT_EQ(sut.storage.state(), RecordState::foreign);
  EXPECT_EQ(sut.parameters(), defaults);
}

/// The device after an update: 2100h has grown to 32 bits, and 6000h goes up to 600 only.
const DictionaryTables& updated_tables() {
  static const auto layout = tables_with([](auto& entries) {
    entries[11].type = DataType::unsigned32;
    entries[12].high = 600;
  });
  static const DictionaryTables tables = layout.tables();
  return tables;
}

TEST_F(StorageRefusal, ASetOfAnotherDictionaryIsOutdated) {
  StoringNode sut(memory, stored_settings, updated_tables());
  sut.expect({"705#00", emergency(5)});
  EXPECT_EQ(sut.storage.state(), RecordState::outdated);
  EXPECT_EQ(sut.get(0x1017), 0U);
}

TEST_F(StorageRefusal, AMakerMayKeepWhatFitsAfterAnUpdate) {
  Storage::Settings settings = stored_settings;
  settings.keep_what_fits = true;
  StoringNode sut(memory, settings, updated_tables());
  sut.booted();
  EXPECT_EQ(sut.get(0x1017), 1001U);
  EXPECT_EQ(sut.text(), "set 1");
  EXPECT_EQ(sut.get(0x2100), 0x2100U) << "another length";
  EXPECT_EQ(sut.get(0x6000), 100U) << "601 is out of the new range";
  EXPECT_EQ(sut.get(0x6020, 1), 11U);
}

TEST_F(StorageRefusal, WhatWasKeptAfterAnUpdateIsStoredAsWhatItIsNow) {
  Storage::Settings settings = stored_settings;
  settings.keep_what_fits = true;
  StoringNode sut(memory, settings, updated_tables());
  sut.booted();
  sut.set(0x6000, 500);
  sut.save(3);
  StoringNode again(memory, stored_settings, updated_tables());
  again.booted();
  EXPECT_EQ(again.storage.state(), RecordState::valid);
  EXPECT_EQ(again.get(0x1017), 1001U);
  EXPECT_EQ(again.get(0x2100), 0x2100U);
  EXPECT_EQ(again.get(0x6000), 500U);
}

TEST_F(StorageRefusal, WhatIsStoredAfterARefusalHoldsAndEndsTheError) {
  memory.bytes[head_size + 9] ^= 1;
  StoringNode sut(memory);
  sut.sent.clear();
  sut.set(0x1017, 700);
  sut.receive("605#23 10 10 02 73 61 76 65");
  sut.expect({"085#00 00 00 00 00 00 00 00", "585#60 10 10 02 00 00 00 00"});
  StoringNode again(memory);
  again.booted();
  EXPECT_EQ(again.get(0x1017), 700U);
  EXPECT_EQ(again.get(0x6000), 100U) << "nothing of the damaged set";
}

TEST_F(StorageRefusal, RestoringEndsTheErrorToo) {
  memory.bytes[head_size + 9] ^= 1;
  StoringNode sut(memory);
  sut.sent.clear();
  sut.receive("605#23 11 10 01 6C 6F 61 64");
  sut.expect({"085#00 00 00 00 00 00 00 00", "585#60 11 10 01 00 00 00 00"});
  StoringNode(memory).booted();
}

TEST_F(StorageRefusal, AResetOfTheNodeTellsItAgain) {
  memory.bytes[head_size + 9] ^= 1;
  StoringNode sut(memory);
  sut.sent.clear();
  sut.receive("000#81 05");
  ASSERT_FALSE(sut.sent.empty());
  EXPECT_EQ(wire_text(sut.sent.back().frame), emergency(2));
}

TEST_F(StorageRefusal, AResetOfTheCommunicationThatFindsAGoodSetEndsTheError) {
  SimulatedFlash other(stored_geometry);
  StoringNode(other).booted().save();
  other.fail_read = true;
  StoringNode sut(other);
  sut.expect({"705#00", emergency(7)});
  other.fail_read = false;
  sut.receive("000#82 05");
  sut.expect({"705#00", emergency(7), "085#00 00 00 00 00 00 00 00"});
  sut.receive("000#82 05");
  sut.booted();
}

TEST_F(StorageRefusal, AFlashThatDoesNotAnswerIsTold) {
  memory.fail_read = true;
  expect_refused(RecordState::unreadable);
}

// Invalid contents with a matching CRC.

TEST_F(StorageRefusal, ACountThatIsNotThatOfTheEntriesIsRefused) {
  memory.bytes[head_size] ^= 1;
  seal();
  expect_refused(RecordState::damaged);
}

TEST_F(StorageRefusal, AnEntryThatReachesBeyondTheEndIsRefused) {
  store(memory.bytes.data() + head_size + 4 + 3, std::uint32_t{0xFFFF'FFFF});
  seal();
  expect_refused(RecordState::damaged);
}

TEST_F(StorageRefusal, AnEntryOfAnotherLengthIsRefused) {
  // The first entry is 1014h, with four bytes.
  store(memory.bytes.data() + head_size + 4, std::uint16_t{0x1017});
  seal();
  expect_refused(RecordState::damaged);
}

TEST_F(StorageRefusal, AnEntryThatIsNoParameterIsRefused) {
  for (const std::uint16_t index :
       std::to_array<std::uint16_t>({0x1000, 0x1010, 0x6030, 0x6040, 0x7000})) {
    store(memory.bytes.data() + head_size + 4, index);
    seal();
    expect_refused(RecordState::damaged);
  }
}

TEST_F(StorageRefusal, AnEmptySetWithoutACountIsRefused) {
  change_head(3, 0);
  seal();
  expect_refused(RecordState::damaged);
}

}  // namespace
}  // namespace canvoy::storage_refusal_test
