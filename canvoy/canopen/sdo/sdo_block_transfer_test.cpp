// Client and server together, in blocks: over a line that keeps every frame, and over a lossy one.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/canopen/testing/sdo_line.hpp"

namespace canvoy::sdo_block_transfer_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::size_t> all_sizes() {
  std::vector<std::size_t> sizes;
  for (std::size_t size = 0; size <= 100; ++size) sizes.push_back(size);
  sizes.insert(sizes.end(), {882, 888, 889, 890, 896, 1777, 1778, 1779, 5000});
  return sizes;
}

/// Supplies and takes bytes like an application that does not have all of them at a time.
struct Stream {
  Bytes bytes;
  std::size_t at = 0;

  Result<std::size_t> give(std::span<std::uint8_t> piece) {
    const std::size_t size = std::min(piece.size(), bytes.size() - at);
    std::copy_n(bytes.begin() + static_cast<long>(at), size, piece.begin());
    at += size;
    return size;
  }
  AbortCode take(std::span<const std::uint8_t> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return AbortCode::none;
  }
  SdoClient::Supply supply() { return SdoClient::Supply::to<&Stream::give>(*this); }
  SdoClient::Sink sink() { return SdoClient::Sink::to<&Stream::take>(*this); }
};

class BlockLine : public Line {
 public:
  explicit BlockLine(std::uint8_t block_size = sdo::block_size_max) : Line(block_size) {
    client.choose(SdoTransfer::block);
  }
  /// The outcome of the transfer that was started.
  SdoClient::Outcome end(AbortCode started, const std::vector<Fate>& fates = {}) {
    if (started != AbortCode::none) return started;
    outcome.reset();
    run(fates);
    return outcome.value_or(AbortCode::no_data);
  }
};

TEST(SdoBlockTransfer, EverySizeArrivesWholeByDownloadAndComesBackByUpload) {
  for (const unsigned block_size : {1U, 2U, 5U, 64U, 126U, 127U}) {
    BlockLine line(static_cast<std::uint8_t>(block_size));
    for (const std::size_t size : all_sizes()) {
      SCOPED_TRACE(size);
      const Bytes sent = pattern(size, static_cast<std::uint8_t>(size));
      auto outcome = line.end(line.client.download(5, 0x2021, 0, sent, line.on_done()));
      EXPECT_EQ(outcome.abort(), AbortCode::none);
      EXPECT_EQ(*outcome, size);
      EXPECT_EQ(value_of(line.server_node.node, 0x2021), sent);
      Bytes received(size);
      outcome = line.end(line.client.upload(5, 0x2021, 0, received, line.on_done()));
      EXPECT_EQ(outcome.abort(), AbortCode::none);
      EXPECT_EQ(*outcome, size);
      EXPECT_EQ(received, sent);
    }
  }
}

TEST(SdoBlockTransfer, EverySizeOfADomainIsStreamedBothWaysWhetherItIsToldOrNot) {
  BlockLine line;
  auto sizes = all_sizes();
  sizes.push_back(100'000);
  for (const std::size_t size : sizes) {
    for (const bool told : {true, false}) {
      SCOPED_TRACE(std::to_string(size) + (told ? " told" : " not told"));
      Stream from{pattern(size, static_cast<std::uint8_t>(size))};
      const auto announced = told ? std::optional(static_cast<std::uint32_t>(size)) : std::nullopt;
      auto outcome =
          line.end(line.client.download(5, 0x2030, 0, from.supply(), announced, line.on_done()));
      EXPECT_EQ(outcome.abort(), AbortCode::none);
      EXPECT_EQ(*outcome, size);
      EXPECT_EQ(line.domain.announced, told ? size : 0U);
      EXPECT_EQ(line.domain.content, from.bytes);
      line.domain.tells_size = told;
      Stream to;
      outcome = line.end(line.client.upload(5, 0x2030, 0, to.sink(), line.on_done()));
      EXPECT_EQ(outcome.abort(), AbortCode::none);
      EXPECT_EQ(to.bytes, from.bytes);
    }
  }
  EXPECT_EQ(line.domain.dropped, 0);
  EXPECT_LE(line.domain.longest_piece, is_small_machine ? 7U : line.buffer.size());
}

TEST(SdoBlockTransfer, ALostFrameAtAnyPlaceIsMendedOrEndsBothSides) {
  for (const bool is_upload : {true, false}) {
    for (const unsigned block_size : {1U, 3U, 127U}) {
      for (std::size_t place = 0; place < 20; ++place) {
        SCOPED_TRACE(std::to_string(block_size) + (is_upload ? " upload " : " download ") +
                     std::to_string(place));
        BlockLine line(static_cast<std::uint8_t>(block_size));
        const Bytes sent = pattern(30);
        const Bytes old = pattern(10, 0xEE);
        Bytes received(30);
        set_value(line.server_node.node, 0x2021, is_upload ? sent : old);
        std::vector<Fate> fates(place, Fate::arrives);
        fates.push_back(Fate::is_lost);
        const auto outcome =
            is_upload ? line.end(line.client.upload(5, 0x2021, 0, received, line.on_done()), fates)
                      : line.end(line.client.download(5, 0x2021, 0, sent, line.on_done()), fates);
        EXPECT_FALSE(line.server.busy());
        EXPECT_LE(line.client_node.now, Time(2s));
        const Bytes value = value_of(line.server_node.node, 0x2021);
        if (outcome) {
          EXPECT_EQ(is_upload ? received : value, sent);
        } else {
          // A lost acknowledgement brings a block twice, and thus too many bytes.
          EXPECT_TRUE(outcome.is_silence() || outcome.abort() == AbortCode::time_out ||
                      outcome.abort() == AbortCode::length_too_high);
          EXPECT_TRUE(is_upload || value == old || value == sent);
        }
      }
    }
  }
}

/// Of 22 segments in blocks of 7 the last is alone in its block: if it is lost, only the size shows
/// the receiver that there was one.
TEST(SdoBlockTransfer, ALostSegmentCostsNoTransferWhoseSizeWasTold) {
  for (const bool is_upload : {true, false}) {
    for (std::size_t segment = 0; segment < 22; ++segment) {
      BlockLine line(7);
      const Bytes sent = pattern(150);
      if (is_upload) set_value(line.server_node.node, 0x2021, sent);
      Bytes received(150);
      const std::size_t before = is_upload ? 3 : 2;  // initiate, answer, start
      std::vector<Fate> fates(before + segment + segment / 7, Fate::arrives);
      fates.push_back(Fate::is_lost);
      const auto outcome =
          is_upload ? line.end(line.client.upload(5, 0x2021, 0, received, line.on_done()), fates)
                    : line.end(line.client.download(5, 0x2021, 0, sent, line.on_done()), fates);
      EXPECT_EQ(outcome.abort(), AbortCode::none)
          << (is_upload ? "upload " : "download ") << segment;
      EXPECT_EQ(is_upload ? received : value_of(line.server_node.node, 0x2021), sent);
    }
  }
}

TEST(SdoBlockTransfer, ALostStartOfAnUploadCostsNothing) {
  BlockLine line(7);
  const Bytes sent = pattern(150);
  set_value(line.server_node.node, 0x2021, sent);
  Bytes received(150);
  const auto outcome = line.end(line.client.upload(5, 0x2021, 0, received, line.on_done()),
                                {Fate::arrives, Fate::arrives, Fate::is_lost});
  EXPECT_EQ(outcome.abort(), AbortCode::none);
  EXPECT_EQ(received, sent);
}

/// A transfer over a line that does what it will with frames, between controllers that may be full
/// at times, also in the middle of a block. It ends on both sides within the time-out; a success
/// means that the data are whole, a failure that they are whole or as before.
struct Trial {
  bool is_upload = *rc::gen::arbitrary<bool>();
  /// Often long, so that last segments have numbers that look like any command.
  std::size_t size =
      *rc::gen::oneOf(rc::gen::inRange<std::size_t>(0, 150), rc::gen::inRange<std::size_t>(0, 900));
  std::uint8_t block_size = *rc::gen::oneOf(rc::gen::inRange<std::uint8_t>(1, 20),
                                            rc::gen::inRange<std::uint8_t>(1, 128));
  std::deque<std::uint8_t> room = {};
  bool repeats_acknowledgements = false;
};

void expect_data_whole_or_abort(std::initializer_list<Fate> kinds, Trial trial) {
  const bool is_upload = trial.is_upload;
  const bool is_domain = *rc::gen::arbitrary<bool>();
  const auto fates = *rc::gen::container<std::vector<Fate>>(rc::gen::weightedOneOf<Fate>(
      {{8, rc::gen::just(Fate::arrives)}, {1, rc::gen::elementOf(std::vector<Fate>(kinds))}}));
  BlockLine line(trial.block_size);
  line.room = std::move(trial.room);
  line.repeats_acknowledgements = trial.repeats_acknowledgements;
  const Bytes sent = pattern(trial.size);
  const Bytes old = pattern(10, 0xEE);
  const std::uint16_t index = is_domain ? 0x2030 : 0x2021;
  line.domain.content = is_upload ? sent : old;
  set_value(line.server_node.node, 0x2021, line.domain.content);
  Stream from{sent};
  Stream to;
  const auto outcome =
      is_upload
          ? line.end(line.client.upload(5, index, 0, to.sink(), line.on_done()), fates)
          : line.end(line.client.download(5, index, 0, from.supply(), std::nullopt, line.on_done()),
                     fates);
  RC_ASSERT(line.outcome.has_value());
  RC_ASSERT(!*line.outcome || **line.outcome == trial.size);
  RC_ASSERT(!line.client.busy());
  RC_ASSERT(!line.server.busy());
  RC_ASSERT(!line.domain.open);
  const Bytes value = is_domain ? line.domain.content : value_of(line.server_node.node, 0x2021);
  if (is_upload) {
    RC_ASSERT(!outcome || to.bytes == sent);
  } else {
    RC_ASSERT(value == sent || (!outcome && value == old));
  }
  Bytes device_type(4);
  line.client.choose(SdoTransfer::segmented);
  RC_ASSERT(bool(line.end(line.client.upload(5, 0x1000, 0, device_type, line.on_done()))));
  RC_ASSERT(device_type == (Bytes{0xA2, 0x01, 0x02, 0x00}));
}

RC_GTEST_PROP(SdoBlockTransfer, LossEndsWithDataWholeOrAnAbort, ()) {
  expect_data_whole_or_abort({Fate::is_lost}, {});
}

RC_GTEST_PROP(SdoBlockTransfer, LossDuplicationAndReorderingEndWithDataWholeOrAnAbort, ()) {
  expect_data_whole_or_abort({Fate::is_lost, Fate::comes_twice, Fate::is_overtaken}, {});
}

/// Room for zero to three frames, step by step: a larger block is held up in its middle, where a
/// copy of the acknowledgement before may come.
std::deque<std::uint8_t> often_full() {
  return *rc::gen::container<std::deque<std::uint8_t>>(200, rc::gen::inRange<std::uint8_t>(0, 4));
}

RC_GTEST_PROP(SdoBlockTransfer, SoDoesAllThatWhereControllersAreFullAtTimes, ()) {
  expect_data_whole_or_abort({Fate::is_lost, Fate::comes_twice, Fate::is_overtaken},
                             {.room = often_full()});
}

/// A copy that comes while a block is still waiting for the controller has no information on that
/// block, and data given for it may be needed again. Many blocks and trials, so that it happens: if
/// the client goes back at a copy, seven of eight runs of a third of this find it.
RC_GTEST_PROP(SdoBlockTransfer, CopiesOfAcknowledgementsWhileControllersAreFullForgetNothing, ()) {
  for (int trial = 0; trial < 3; ++trial) {
    expect_data_whole_or_abort({Fate::is_lost},
                               {.size = *rc::gen::inRange<std::size_t>(100, 400),
                                .block_size = *rc::gen::inRange<std::uint8_t>(4, 10),
                                .room = often_full(),
                                .repeats_acknowledgements = true});
  }
}

RC_GTEST_PROP(SdoBlockTransfer, FullControllersAloneCostNoTransfer, ()) {
  const bool is_upload = *rc::gen::arbitrary<bool>();
  BlockLine line(*rc::gen::inRange<std::uint8_t>(1, 128));
  const Bytes sent = pattern(*rc::gen::inRange<std::size_t>(0, 1000));
  line.room = often_full();
  if (is_upload) set_value(line.server_node.node, 0x2021, sent);
  Bytes received(sent.size());
  const auto outcome = is_upload
                           ? line.end(line.client.upload(5, 0x2021, 0, received, line.on_done()))
                           : line.end(line.client.download(5, 0x2021, 0, sent, line.on_done()));
  RC_ASSERT(outcome.abort() == AbortCode::none);
  RC_ASSERT((is_upload ? received : value_of(line.server_node.node, 0x2021)) == sent);
}

}  // namespace
}  // namespace canvoy::sdo_block_transfer_test
