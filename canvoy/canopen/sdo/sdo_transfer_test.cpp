// Client and server together, over a line that keeps every frame, and over a lossy one.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/canopen/testing/sdo_line.hpp"

namespace canvoy::sdo_transfer_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::size_t> all_sizes() {
  std::vector<std::size_t> sizes;
  for (std::size_t size = 0; size <= 300; ++size) sizes.push_back(size);
  sizes.insert(sizes.end(), {889, 890, 5000});
  return sizes;
}

TEST(SdoTransfer, EverySizeArrivesWholeByDownloadAndComesBackByUpload) {
  Line line;
  for (const std::size_t size : all_sizes()) {
    SCOPED_TRACE(size);
    const Bytes sent = pattern(size, static_cast<std::uint8_t>(size));
    ASSERT_EQ(line.client.download(5, 0x2021, 0, sent, line.on_done()), AbortCode::none);
    line.run();
    ASSERT_TRUE(line.outcome && *line.outcome);
    EXPECT_EQ(**line.outcome, size);
    EXPECT_EQ(value_of(line.server_node.node, 0x2021), sent);
    line.outcome.reset();
    Bytes received(size);
    ASSERT_EQ(line.client.upload(5, 0x2021, 0, received, line.on_done()), AbortCode::none);
    line.run();
    ASSERT_TRUE(line.outcome && *line.outcome);
    EXPECT_EQ(**line.outcome, size);
    EXPECT_EQ(received, sent);
    line.outcome.reset();
  }
}

TEST(SdoTransfer, EverySizeOfADomainIsStreamedBothWays) {
  Line line;
  for (const std::size_t size : all_sizes()) {
    SCOPED_TRACE(size);
    const Bytes sent = pattern(size, static_cast<std::uint8_t>(size));
    std::size_t given = 0;
    auto give = [&](std::span<std::uint8_t> piece) {
      const std::size_t count = std::min(piece.size(), size - given);
      std::copy_n(sent.begin() + static_cast<long>(given), count, piece.begin());
      given += count;
      return Result<std::size_t>(count);
    };
    const bool announce = size % 2 == 0;
    ASSERT_EQ(line.client.download(
                  5, 0x2030, 0, SdoClient::Supply::of(give),
                  announce ? std::optional(static_cast<std::uint32_t>(size)) : std::nullopt,
                  line.on_done()),
              AbortCode::none);
    line.run();
    ASSERT_TRUE(line.outcome && *line.outcome);
    EXPECT_EQ(**line.outcome, size);
    EXPECT_EQ(line.domain.announced, announce ? size : 0U);
    EXPECT_EQ(line.domain.content, sent);
    line.outcome.reset();
    Bytes received;
    auto take = [&](std::span<const std::uint8_t> piece) {
      received.insert(received.end(), piece.begin(), piece.end());
      return AbortCode::none;
    };
    ASSERT_EQ(line.client.upload(5, 0x2030, 0, SdoClient::Sink::of(take), line.on_done()),
              AbortCode::none);
    line.run();
    ASSERT_TRUE(line.outcome && *line.outcome);
    EXPECT_EQ(received, sent);
    line.outcome.reset();
  }
  EXPECT_EQ(line.domain.dropped, 0);
  EXPECT_LE(line.domain.longest_piece, is_small_machine ? 7U : line.buffer.size());
}

TEST(SdoTransfer, NumbersOfEveryLengthGoBothWays) {
  Line line;
  for (std::uint16_t length = 1; length <= 8; ++length) {
    SCOPED_TRACE(length);
    const auto index = static_cast<std::uint16_t>(0x2000 + length);
    const Bytes sent = pattern(length, 0x81);
    ASSERT_EQ(line.client.download(5, index, 0, sent, line.on_done()), AbortCode::none);
    line.run();
    ASSERT_TRUE(line.outcome && *line.outcome);
    Bytes received(8);
    ASSERT_EQ(line.client.upload(5, index, 0, received, line.on_done()), AbortCode::none);
    line.run();
    ASSERT_TRUE(line.outcome && *line.outcome);
    received.resize(**line.outcome);
    EXPECT_EQ(received, sent);
  }
}

TEST(SdoTransfer, ATransferOf889BytesTakes128FramesEachWay) {
  Line line;
  ASSERT_EQ(line.client.download(5, 0x2021, 0, pattern(889), line.on_done()), AbortCode::none);
  line.client.cancel();
  line.run();
  line.frames = 0;
  const Bytes sent = pattern(889);
  ASSERT_EQ(line.client.download(5, 0x2021, 0, sent, line.on_done()), AbortCode::none);
  line.run();
  EXPECT_EQ(line.frames, 2U * 128U);
}

/// One transfer over a line with these fates; checks the properties that hold for any of them.
struct Attempt {
  Attempt(bool is_upload, std::size_t size, const std::vector<Fate>& fates,
          std::deque<std::uint8_t> room = {})
      : sent(pattern(size)), received(size) {
    line.room = std::move(room);
    const Bytes old = pattern(10, 0xEE);
    set_value(line.server_node.node, 0x2021, is_upload ? sent : old);
    const AbortCode started = is_upload ? line.client.upload(5, 0x2021, 0, received, line.on_done())
                                        : line.client.download(5, 0x2021, 0, sent, line.on_done());
    RC_ASSERT(started == AbortCode::none);
    line.run(fates);
    // Both sides have ended within the time-out.
    RC_ASSERT(line.outcome.has_value());
    RC_ASSERT(!line.client.busy());
    RC_ASSERT(!line.server.busy());
    const Bytes value = value_of(line.server_node.node, 0x2021);
    is_whole = is_upload ? received == sent : value == sent;
    is_untouched = is_upload || value == old;
  }
  /// Earlier frames do not disturb the next transfer.
  void expect_alive() {
    line.outcome.reset();
    Bytes device_type(4);
    RC_ASSERT(line.client.upload(5, 0x1000, 0, device_type, line.on_done()) == AbortCode::none);
    line.run();
    RC_ASSERT(line.outcome && *line.outcome);
    RC_ASSERT(device_type == (Bytes{0xA2, 0x01, 0x02, 0x00}));
  }

  Line line;
  Bytes sent;
  Bytes received;
  bool is_whole = false;
  bool is_untouched = false;
};

std::vector<Fate> fates_of(std::initializer_list<Fate> kinds) {
  return *rc::gen::container<std::vector<Fate>>(rc::gen::weightedOneOf<Fate>(
      {{4, rc::gen::just(Fate::arrives)}, {1, rc::gen::elementOf(std::vector<Fate>(kinds))}}));
}

void expect_data_whole_or_abort(std::initializer_list<Fate> kinds) {
  const bool is_upload = *rc::gen::arbitrary<bool>();
  const auto size = *rc::gen::inRange<std::size_t>(0, 40);
  Attempt attempt(is_upload, size, fates_of(kinds));
  if (*attempt.line.outcome) {
    RC_ASSERT(attempt.is_whole);
  } else {
    RC_ASSERT(attempt.is_whole || attempt.is_untouched);
  }
  attempt.expect_alive();
}

/// Each frame is answered by one, so a reordered one can only be overtaken by its own copy or by an
/// abort.
RC_GTEST_PROP(SdoTransfer, LossAndDuplicationEndWithDataWholeOrAnAbort, ()) {
  expect_data_whole_or_abort({Fate::is_lost, Fate::comes_twice});
}

RC_GTEST_PROP(SdoTransfer, LossAndReorderingEndWithDataWholeOrAnAbort, ()) {
  expect_data_whole_or_abort({Fate::is_lost, Fate::is_overtaken});
}

/// With both, a copy may replace the segment after the next: one toggle bit cannot distinguish
/// them, and no CAN bus does that. It still ends.
RC_GTEST_PROP(SdoTransfer, AnythingAtAllComesToAnEnd, ()) {
  const bool is_upload = *rc::gen::arbitrary<bool>();
  const auto size = *rc::gen::inRange<std::size_t>(0, 60);
  Attempt attempt(is_upload, size,
                  fates_of({Fate::is_lost, Fate::comes_twice, Fate::is_overtaken}));
  attempt.expect_alive();
}

RC_GTEST_PROP(SdoTransfer, FullControllersAloneCostNoTransfer, ()) {
  const bool is_upload = *rc::gen::arbitrary<bool>();
  const auto size = *rc::gen::inRange<std::size_t>(0, 60);
  Attempt attempt(
      is_upload, size, {},
      *rc::gen::container<std::deque<std::uint8_t>>(60, rc::gen::inRange<std::uint8_t>(0, 3)));
  RC_ASSERT(attempt.line.outcome->abort() == AbortCode::none);
  RC_ASSERT(attempt.is_whole);
  attempt.expect_alive();
}

TEST(SdoTransfer, ALostFrameAtAnyPlaceEndsBothSidesWithATimeOut) {
  for (const bool is_upload : {true, false}) {
    // Initiate and three segments: four requests, four answers.
    for (std::size_t place = 0; place < 8; ++place) {
      SCOPED_TRACE(place);
      std::vector<Fate> fates(place, Fate::arrives);
      fates.push_back(Fate::is_lost);
      Attempt attempt(is_upload, 15, fates);
      EXPECT_TRUE(attempt.line.outcome->is_silence());
      EXPECT_EQ(attempt.line.client_node.now, Time(1s));
      // The last answer of a download is lost after the data have been written.
      EXPECT_EQ(attempt.is_whole, !is_upload && place == 7);
      attempt.expect_alive();
    }
  }
}

}  // namespace
}  // namespace canvoy::sdo_transfer_test
