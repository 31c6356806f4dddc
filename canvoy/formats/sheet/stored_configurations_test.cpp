// Tools store DCFs, concise DCFs and EDS of slaves in the manager, node 1, by SDO, and slaves are
// configured from them (CiA 302-3: 1F20h to 1F24h).
#include "canvoy/formats/sheet/stored_configurations.hpp"

#include <gtest/gtest.h>

#include <string>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::formats::stored_configurations_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr EntryRow count = {.access = Access::const_, .initial = 127};
constexpr EntryRow slaves(DataType type) {
  return {.sub_first = 1, .sub_last = 127, .type = type, .access = Access::rw};
}
constexpr EntryRow second_channel(std::uint8_t sub, std::int64_t can_id) {
  return {.sub_first = sub,
          .sub_last = sub,
          .type = DataType::unsigned32,
          .access = Access::rw,
          .initial = can_id};
}

constexpr auto layout = lay_out(std::to_array<ObjectRow>({{.index = 0x1201, .entry_count = 3},
                                                          {.index = 0x1F20, .entry_count = 2},
                                                          {.index = 0x1F21, .entry_count = 2},
                                                          {.index = 0x1F22, .entry_count = 2},
                                                          {.index = 0x1F23, .entry_count = 2},
                                                          {.index = 0x1F24, .entry_count = 2}}),
                                std::to_array<EntryRow>({{.access = Access::const_, .initial = 2},
                                                         second_channel(1, 0x200),
                                                         second_channel(2, 0x180 + 1),
                                                         count,
                                                         slaves(DataType::domain),
                                                         count,
                                                         slaves(DataType::unsigned8),
                                                         count,
                                                         slaves(DataType::domain),
                                                         count,
                                                         slaves(DataType::domain),
                                                         count,
                                                         slaves(DataType::unsigned8)}));

/// A heartbeat of 500 ms.
const std::string dcf = "[1017]\r\nDataType=0x0006\r\nAccessType=rw\r\nParameterValue=500\r\n";
const Bytes concise = {1, 0, 0, 0, 0x17, 0x10, 0, 2, 0, 0, 0, 0xF4, 0x01};

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

class StoredConfigurationsTest : public testing::Test {
 protected:
  StoredConfigurationsTest() {
    sut.on_stored([this](std::uint16_t index, NodeId slave) {
      stored.push_back(std::to_string(index - 0x1F20) + " of " + std::to_string(slave));
    });
    wire.boot();
  }

  /// Downloads these bytes in segments like an SDO client; returns the abort code.
  AbortCode download(std::uint16_t index, std::uint8_t sub, const Bytes& bytes,
                     bool tells_size = true) {
    const std::uint8_t initiate = tells_size ? 0x21 : 0x20;
    AbortCode answer = ask(initiate, index, sub, static_cast<std::uint32_t>(bytes.size()));
    std::size_t at = 0;
    for (bool toggle = false; answer == AbortCode::none; toggle = !toggle) {
      Frame frame = Frame::data_frame(0x601, {});
      frame.length = 8;
      const std::size_t size = std::min<std::size_t>(7, bytes.size() - at);
      const bool is_last = at + size == bytes.size();
      frame.data[0] = static_cast<std::uint8_t>((toggle ? 0x10 : 0) | (7 - size) << 1 | is_last);
      std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), size, &frame.data[1]);
      answer = exchange(frame);
      at += size;
      if (is_last) break;
    }
    return answer;
  }
  AbortCode download(std::uint16_t index, std::uint8_t sub, const std::string& text) {
    return download(index, sub, bytes_of(text));
  }
  AbortCode ask(std::uint8_t command, std::uint16_t index, std::uint8_t sub,
                std::uint32_t number = 0) {
    Frame frame = Frame::data_frame(0x601, {});
    frame.length = 8;
    frame.data[0] = command;
    store(&frame.data[1], index);
    frame.data[3] = sub;
    store(&frame.data[4], number);
    return exchange(frame);
  }
  AbortCode exchange(const Frame& frame) {
    wire.sent.clear();
    wire.receive(wire_text(frame));
    if (wire.sent.size() != 1) return AbortCode::time_out;
    const Frame& answer = wire.sent.front().frame;
    wire.sent.clear();
    if (answer.data[0] != 0x80) return AbortCode::none;
    return static_cast<AbortCode>(load<std::uint32_t>(&answer.data[4]));
  }
  Bytes content(std::uint16_t index, NodeId slave) const {
    const auto bytes = sut.content(index, slave);
    return {bytes.begin(), bytes.end()};
  }

  WireNode wire{layout.tables(), 1};
  SdoServer server{wire.node, 0, {}};
  SdoServer second_server{wire.node, 1, {}};
  ConfigurationManager::Worker workers[1] = {ConfigurationManager::Worker(wire.node)};
  ConfigurationManager manager{wire.node, workers};
  StoredConfigurations sut{wire.node, manager, 1000};
  std::vector<std::string> stored;
};

TEST_F(StoredConfigurationsTest, ASlaveIsConfiguredByTheDcfThatWasStored) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(stored, std::vector<std::string>{"0 of 5"});
  EXPECT_EQ(manager.update(5), AbortCode::none);
  wire.settle();
  wire.expect({"605#2B 17 10 00 F4 01 00 00"});
}

TEST_F(StoredConfigurationsTest, ADcfIsReadBackAsItWasStoredAndItsConciseFormIsThere) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(content(0x1F20, 5), bytes_of(dcf));
  EXPECT_EQ(content(0x1F22, 5), concise);
  wire.receive("601#40 20 1F 05 00 00 00 00");
  wire.receive("601#60 00 00 00 00 00 00 00");
  wire.receive("601#40 22 1F 05 00 00 00 00");
  wire.receive("601#60 00 00 00 00 00 00 00");
  wire.receive("601#70 00 00 00 00 00 00 00");
  wire.expect({"581#41 20 1F 05 3C 00 00 00", "581#00 5B 31 30 31 37 5D 0D",
               "581#41 22 1F 05 0D 00 00 00", "581#00 01 00 00 00 17 10 00",
               "581#13 02 00 00 00 F4 01 00"});
}

TEST_F(StoredConfigurationsTest, ValuesGoWithTheNodeIdOfTheSlave) {
  const std::string text =
      "[1014]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x80\n"
      "ParameterValue=$NODEID+0x80\n";
  EXPECT_EQ(download(0x1F20, 6, text), AbortCode::none);
  // Invalid first, since a CAN-ID changes only in that state (CiA 301, 7.5.2.17).
  EXPECT_EQ(content(0x1F22, 6), (Bytes{2,    0,    0, 0,                             //
                                       0x14, 0x10, 0, 4, 0, 0, 0, 0x86, 0, 0, 0x80,  //
                                       0x14, 0x10, 0, 4, 0, 0, 0, 0x86, 0, 0, 0}));
}

TEST_F(StoredConfigurationsTest, ATextOfWhichThereIsNoConfigurationIsRefusedAndTheOldOneStays) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  for (const char* text : {"no DCF", "[1017]\nDataType=6\nAccessType=rw\nDefaultValue=500\n",
                           "[1017]\nDataType=6\nAccessType=rw\nParameterValue=70000\n"}) {
    EXPECT_EQ(download(0x1F20, 5, text), AbortCode::value_range) << text;
  }
  EXPECT_EQ(content(0x1F20, 5), bytes_of(dcf));
  EXPECT_EQ(content(0x1F22, 5), concise);
  EXPECT_EQ(stored.size(), 1U);
}

TEST_F(StoredConfigurationsTest, AValueThatTheNodeIdCarriesBeyond64BitsIsRefused) {
  const std::string type = "[2000]\nDataType=0x1B\nAccessType=rw\n";
  for (const char* value : {"$NODEID+0x7FFFFFFFFFFFFFFF", "$NODEID+0xFFFFFFFFFFFFFFFF",
                            "-18446744073709551615", "$NODEID+-0x8000000000000001"}) {
    EXPECT_EQ(download(0x1F20, 5, type + "ParameterValue=" + value + "\n"), AbortCode::value_range);
    EXPECT_EQ(download(0x1F20, 5, type + "ParameterValue=1\nDefaultValue=" + value + "\n"),
              AbortCode::none)
        << "only its default is none";
  }
}

TEST_F(StoredConfigurationsTest, AnUploadDoesNotGoOnInWhatWasStoredMeanwhile) {
  EXPECT_EQ(download(0x1F23, 5, "the old sheet"), AbortCode::none);
  wire.receive("200#40 23 1F 05 00 00 00 00");
  wire.receive("200#60 00 00 00 00 00 00 00");
  wire.sent.clear();
  EXPECT_EQ(download(0x1F23, 5, "the new sheet"), AbortCode::none);
  wire.receive("200#70 00 00 00 00 00 00 00");
  wire.expect({"181#80 23 1F 05 22 00 00 08"});
  wire.receive("200#40 23 1F 05 00 00 00 00");
  wire.expect({"181#41 23 1F 05 0D 00 00 00"});
}

TEST_F(StoredConfigurationsTest, ADcfThatIsCutAnywhereIsRefusedOrAConfigurationOfItself) {
  for (std::size_t size = 1; size < dcf.size(); ++size) {
    SCOPED_TRACE(size);
    const AbortCode answer = download(0x1F20, 5, dcf.substr(0, size));
    const bool is_whole = !content(0x1F22, 5).empty();
    EXPECT_EQ(answer, is_whole ? AbortCode::none : AbortCode::value_range);
  }
}

TEST_F(StoredConfigurationsTest, AConciseDcfThatIsStoredTakesThePlaceOfADcf) {
  const Bytes other = {1, 0, 0, 0, 0x17, 0x10, 0, 2, 0, 0, 0, 0xE8, 0x03};
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(download(0x1F22, 5, other), AbortCode::none);
  EXPECT_EQ(content(0x1F22, 5), other);
  EXPECT_EQ(content(0x1F20, 5), Bytes());
  EXPECT_EQ(stored, (std::vector<std::string>{"0 of 5", "2 of 5"}));
}

TEST_F(StoredConfigurationsTest, AMalformedConciseDcfIsRefusedAndTheOldOneStays) {
  EXPECT_EQ(download(0x1F22, 5, concise), AbortCode::none);
  for (std::size_t size = 1; size < concise.size(); ++size) {
    EXPECT_EQ(download(0x1F22, 5,
                       Bytes(concise.begin(),
                             concise.end() - static_cast<std::ptrdiff_t>(concise.size() - size))),
              AbortCode::length_too_low);
  }
  Bytes longer = concise;
  longer.push_back(0);
  EXPECT_EQ(download(0x1F22, 5, longer), AbortCode::length_too_high);
  EXPECT_EQ(content(0x1F22, 5), concise);
}

TEST_F(StoredConfigurationsTest, WhereNothingIsStoredThereIsNoData) {
  for (const unsigned index : {0x1F20U, 0x1F22U, 0x1F23U}) {
    EXPECT_EQ(ask(0x40, static_cast<std::uint16_t>(index), 5), AbortCode::no_data);
  }
}

TEST_F(StoredConfigurationsTest, ADownloadWithoutBytesEndsWhatWasStored) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(download(0x1F23, 5, dcf), AbortCode::none);
  EXPECT_EQ(download(0x1F20, 5, Bytes()), AbortCode::none);
  EXPECT_EQ(content(0x1F20, 5), Bytes());
  EXPECT_EQ(content(0x1F22, 5), Bytes());
  EXPECT_EQ(download(0x1F23, 5, Bytes()), AbortCode::none);
  EXPECT_EQ(content(0x1F23, 5), Bytes());
}

TEST_F(StoredConfigurationsTest, AnEdsIsKeptAsItIs) {
  EXPECT_EQ(download(0x1F23, 5, "any text"), AbortCode::none);
  EXPECT_EQ(content(0x1F23, 5), bytes_of("any text"));
  EXPECT_EQ(content(0x1F22, 5), Bytes());
}

TEST_F(StoredConfigurationsTest, SlavesAreKeptApart) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(download(0x1F20, 127, dcf), AbortCode::none);
  EXPECT_EQ(download(0x1F20, 5, Bytes()), AbortCode::none);
  EXPECT_EQ(content(0x1F22, 127), concise);
  EXPECT_EQ(download(0x1F20, 128, dcf), AbortCode::no_sub_index);
}

TEST_F(StoredConfigurationsTest, FormatsOtherThanAsciiAreRefused) {
  for (unsigned format = 0; format < 256; ++format) {
    const AbortCode expected = format == 0 ? AbortCode::none : AbortCode::value_range;
    EXPECT_EQ(ask(0x2F, 0x1F21, 5, format), expected);
    EXPECT_EQ(ask(0x2F, 0x1F24, 5, format), expected);
  }
}

TEST_F(StoredConfigurationsTest, NothingChangesUnderASlaveThatIsConfiguredJustNow) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(manager.update(5), AbortCode::none);
  wire.settle();
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::device_state);
  EXPECT_EQ(download(0x1F22, 5, concise), AbortCode::device_state);
  EXPECT_EQ(download(0x1F23, 5, dcf), AbortCode::none);
  EXPECT_EQ(download(0x1F20, 6, dcf), AbortCode::none);
  wire.receive("585#60 17 10 00 00 00 00 00");
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
}

TEST_F(StoredConfigurationsTest, ASlaveWhoseConfigurationBeginsMeanwhileKeepsTheOldOne) {
  EXPECT_EQ(download(0x1F22, 5, concise), AbortCode::none);
  EXPECT_EQ(ask(0x20, 0x1F22, 5), AbortCode::none);
  EXPECT_EQ(manager.update(5), AbortCode::none);
  wire.settle();
  wire.sent.clear();
  wire.receive("601#07 00 00 00 00 00 00 00");
  wire.expect({"581#80 22 1F 05 22 00 00 08"});
  EXPECT_EQ(content(0x1F22, 5), concise);
}

TEST_F(StoredConfigurationsTest, OneClientAtATimeStoresInOnePlace) {
  EXPECT_EQ(ask(0x20, 0x1F20, 5), AbortCode::none);
  wire.receive("200#20 20 1F 05 00 00 00 00");
  wire.expect({"181#80 20 1F 05 22 00 00 08"});
  wire.receive("200#20 20 1F 06 00 00 00 00");
  wire.expect({"181#60 20 1F 06 00 00 00 00"});
  wire.receive("601#80 20 1F 05 00 00 00 08");
  wire.receive("200#20 20 1F 05 00 00 00 00");
  wire.expect({"181#60 20 1F 05 00 00 00 00"});
}

TEST_F(StoredConfigurationsTest, MoreThanThereIsRoomForIsRefusedAndTheOldOneStays) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  const Bytes large(1000, ' ');
  EXPECT_EQ(ask(0x21, 0x1F23, 5, 1000), AbortCode::out_of_memory);
  EXPECT_EQ(ask(0x21, 0x1F23, 5, 0xFFFF'FFFF), AbortCode::out_of_memory);
  EXPECT_EQ(download(0x1F23, 5, large, false), AbortCode::out_of_memory);
  EXPECT_EQ(download(0x1F20, 5, large, false), AbortCode::out_of_memory);
  EXPECT_EQ(content(0x1F20, 5), bytes_of(dcf));
  EXPECT_EQ(download(0x1F23, 5, Bytes(400, ' ')), AbortCode::none) << "what did not fit is gone";
}

TEST_F(StoredConfigurationsTest, ADownloadThatIsAbandonedLeavesTheOldOne) {
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
  EXPECT_EQ(ask(0x20, 0x1F20, 5), AbortCode::none);
  wire.receive("601#00 41 42 43 44 45 46 47");
  wire.run_for(10s);
  EXPECT_EQ(content(0x1F20, 5), bytes_of(dcf));
  EXPECT_EQ(download(0x1F20, 5, dcf), AbortCode::none);
}

TEST_F(StoredConfigurationsTest, WhoKeptThemStoresThemAtPowerOn) {
  EXPECT_EQ(sut.store(0x1F20, 5, bytes_of(dcf)), AbortCode::none);
  EXPECT_EQ(content(0x1F22, 5), concise);
  EXPECT_EQ(sut.store(0x1F20, 5, bytes_of("no DCF")), AbortCode::value_range);
  EXPECT_TRUE(stored.empty());
}

}  // namespace
}  // namespace canvoy::formats::stored_configurations_test
