// Domains that stand in memory whole, of more than 64 KiB: through client and server, and frame by
// frame (CiA 301, 7.2.4.3).
#include "canvoy/canopen/sdo/large_value.hpp"

#include <gtest/gtest.h>

#include "canvoy/canopen/testing/sdo_line.hpp"

namespace canvoy::large_value_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Of 2033h, which no other service has.
class LargeValues : public ::testing::TestWithParam<SdoTransfer> {
 protected:
  SdoClient::Outcome download(const Bytes& bytes) {
    line_.outcome.reset();
    line_.client.choose(GetParam());
    const AbortCode begun = line_.client.download(5, 0x2033, 0, bytes, line_.on_done());
    if (begun != AbortCode::none) return begun;
    line_.run();
    return line_.outcome.value_or(AbortCode::no_data);
  }
  Bytes upload() {
    Bytes bytes(200'000);
    line_.outcome.reset();
    line_.client.choose(GetParam());
    EXPECT_EQ(line_.client.upload(5, 0x2033, 0, bytes, line_.on_done()), AbortCode::none);
    line_.run();
    EXPECT_TRUE(line_.outcome && *line_.outcome);
    bytes.resize(line_.outcome ? **line_.outcome : 0);
    return bytes;
  }
  Bytes held() const { return {sut_.value().begin(), sut_.value().end()}; }

  Line line_;
  Bytes memory_ = Bytes(150'000);
  Bytes spare_ = Bytes(150'000);
  LargeValue sut_{line_.server_node.node, 0x2033, memory_, spare_};
};
INSTANTIATE_TEST_SUITE_P(, LargeValues,
                         ::testing::Values(SdoTransfer::segmented, SdoTransfer::block));

TEST_P(LargeValues, AnySizeArrivesWholeAndComesBack) {
  for (const std::size_t size :
       {0U, 1U, 4U, 5U, 7U, 8U, 14U, 889U, 890U, 65'535U, 65'536U, 100'000U, 149'999U, 150'000U}) {
    SCOPED_TRACE(size);
    const Bytes sent = pattern(size, static_cast<std::uint8_t>(size + 3));
    EXPECT_EQ(download(sent).abort(), AbortCode::none);
    EXPECT_EQ(held(), sent);
    EXPECT_EQ(upload(), sent);
  }
}

TEST_P(LargeValues, MoreThanThereIsMemoryForIsRefused) {
  EXPECT_TRUE(sut_.set(pattern(20)));
  EXPECT_EQ(download(pattern(150'001)).abort(), AbortCode::out_of_memory);
  EXPECT_EQ(held(), pattern(20));
}

TEST_P(LargeValues, ADownloadThatTheDeviceRefusesLeavesTheValueAsItWas) {
  EXPECT_TRUE(sut_.set(pattern(20)));
  auto refuse = [](std::span<const std::uint8_t> value) {
    return value.size() == 1000 ? AbortCode::parameter_incompatible : AbortCode::none;
  };
  sut_.on_written = Callback<AbortCode(std::span<const std::uint8_t>)>::of(refuse);
  EXPECT_EQ(download(pattern(1000)).abort(), AbortCode::parameter_incompatible);
  EXPECT_EQ(held(), pattern(20));
  EXPECT_EQ(download(pattern(1001)).abort(), AbortCode::none);
  EXPECT_EQ(held(), pattern(1001));
}

TEST_P(LargeValues, ValuesOfOtherEntriesAreGatheredInTheServersOwnMemoryAgain) {
  EXPECT_EQ(download(pattern(1000)).abort(), AbortCode::none);
  const Bytes sent = pattern(300, 9);
  line_.outcome.reset();
  EXPECT_EQ(line_.client.download(5, 0x2021, 0, sent, line_.on_done()), AbortCode::none);
  line_.run();
  EXPECT_EQ(value_of(line_.server_node.node, 0x2021), sent);
  EXPECT_EQ(held(), pattern(1000));
}

/// Frames typed from CiA 301, 7.2.4.3.3 to 7.2.4.3.6.
class LargeValueAtTheWire : public ::testing::Test {
 protected:
  void ask(const std::string& request, const std::string& answer) {
    SCOPED_TRACE(request);
    node_.receive("605#" + request);
    node_.expect({"585#" + answer});
  }

  WireNode node_{sdo_objects(), 5};
  std::array<std::uint8_t, 32> buffer_{};
  SdoServer server_{node_.node, 0, buffer_};
  std::array<std::uint8_t, 20> memory_{};
  LargeValue sut_{node_.node, 0x2033, memory_};
};

TEST_F(LargeValueAtTheWire, WithoutASpareMemoryADownloadThatEndsHalfWayLeavesNothing) {
  node_.boot();
  EXPECT_TRUE(sut_.set(pattern(9)));
  ask("21 33 20 00 09 00 00 00", "60 33 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  EXPECT_TRUE(sut_.value().empty());
  EXPECT_FALSE(sut_.set(pattern(9)));
  node_.receive("605#80 33 20 00 00 00 00 08");
  node_.expect({});
  EXPECT_TRUE(sut_.value().empty());
  EXPECT_TRUE(sut_.set(pattern(9)));
}

TEST_F(LargeValueAtTheWire, FewerBytesThanAnnouncedAreRefused) {
  node_.boot();
  ask("21 33 20 00 09 00 00 00", "60 33 20 00 00 00 00 00");
  ask("01 01 02 03 04 05 06 07", "80 33 20 00 13 00 07 06");
  EXPECT_TRUE(sut_.value().empty());
}

TEST_F(LargeValueAtTheWire, OneThatIsNotAnnouncedEndsWhereThereIsNoMore) {
  node_.boot();
  ask("20 33 20 00 00 00 00 00", "60 33 20 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("10 01 02 03 04 05 06 07", "30 00 00 00 00 00 00 00");
  ask("00 01 02 03 04 05 06 07", "80 33 20 00 12 00 07 06");
  EXPECT_TRUE(sut_.value().empty());
}

TEST_F(LargeValueAtTheWire, FourBytesComeAndGoWithoutSegments) {
  node_.boot();
  ask("23 33 20 00 01 02 03 04", "60 33 20 00 00 00 00 00");
  EXPECT_EQ(Bytes(sut_.value().begin(), sut_.value().end()), (Bytes{1, 2, 3, 4}));
  ask("40 33 20 00 00 00 00 00", "43 33 20 00 01 02 03 04");
}

TEST_F(LargeValueAtTheWire, WhatIsLongerThanTheMemoryIsNotSet) {
  EXPECT_TRUE(sut_.set(pattern(20)));
  EXPECT_FALSE(sut_.set(pattern(21)));
  EXPECT_EQ(sut_.value().size(), 20u);
  EXPECT_TRUE(sut_.set({}));
  EXPECT_TRUE(sut_.value().empty());
}

/// CiA 301, 7.2.4.3.17: 0800 0022h, because of the present device state.
TEST_F(LargeValueAtTheWire, IsOfOneClientAtATime) {
  std::array<std::uint8_t, 32> buffer{};
  SdoServer second(node_.node, 1, buffer);
  node_.boot();
  ask("23 01 12 01 80 06 00 00", "60 01 12 01 00 00 00 00");
  ask("23 01 12 02 81 06 00 00", "60 01 12 02 00 00 00 00");
  ask("21 33 20 00 09 00 00 00", "60 33 20 00 00 00 00 00");
  node_.receive("680#21 33 20 00 09 00 00 00");
  node_.expect({"681#80 33 20 00 22 00 00 08"});
  ask("00 01 02 03 04 05 06 07", "20 00 00 00 00 00 00 00");
  ask("1B 08 09 00 00 00 00 00", "30 00 00 00 00 00 00 00");
  EXPECT_EQ(sut_.value().size(), 9u);
}

/// A domain whose memory is not as it should be.
class OddMemory : public ::testing::Test {
 protected:
  OddMemory() {
    domain_.view = decltype(Domain::view)::to<&OddMemory::view>(*this);
    domain_.room = decltype(Domain::room)::to<&OddMemory::room>(*this);
    domain_.write = decltype(Domain::write)::to<&OddMemory::write>(*this);
    domain_.close_write = decltype(Domain::close_write)::to<&OddMemory::close>(*this);
    hook_.first = hook_.last = 0x2033;
    hook_.domain = &domain_;
    node_.node.dictionary().attach(hook_);
    node_.boot();
  }
  Result<std::span<const std::uint8_t>> view(const Entry&) { return AbortCode::hardware; }
  Result<std::span<std::uint8_t>> room(const Entry&, std::uint32_t) { return memory_; }
  AbortCode write(const Entry&, std::span<const std::uint8_t>) {
    return AbortCode::parameter_incompatible;
  }
  AbortCode close(const Entry&, bool complete) {
    closed_.push_back(complete);
    return AbortCode::none;
  }
  void ask(const std::string& request, const std::string& answer) {
    node_.receive("605#" + request);
    node_.expect({"585#" + answer});
  }

  WireNode node_{sdo_objects(), 5};
  std::array<std::uint8_t, 32> buffer_{};
  SdoServer server_{node_.node, 0, buffer_};
  std::array<std::uint8_t, 8> place_{};
  std::span<std::uint8_t> memory_ = place_;
  Domain domain_;
  Hook hook_;
  std::vector<bool> closed_;
};

TEST_F(OddMemory, ThatCannotBeReadIsAborted) {
  ask("40 33 20 00 00 00 00 00", "80 33 20 00 00 00 06 06");
}

TEST_F(OddMemory, ThatIsSmallerThanWhatIsAnnouncedIsAborted) {
  ask("21 33 20 00 09 00 00 00", "80 33 20 00 05 00 04 05");
}

TEST_F(OddMemory, WhoseOwnerRefusesTheValueIsClosedWithoutIt) {
  ask("23 33 20 00 01 02 03 04", "80 33 20 00 43 00 04 06");
  EXPECT_EQ(closed_, std::vector<bool>{false});
}

}  // namespace
}  // namespace canvoy::large_value_test
