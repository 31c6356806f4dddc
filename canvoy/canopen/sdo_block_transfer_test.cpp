// Client and server together, in blocks: over a line that keeps every frame, and over one that does
// not.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "canvoy/canopen/testing/sdo_line.hpp"

namespace canvoy {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::size_t> all_sizes() {
  std::vector<std::size_t> sizes;
  for (std::size_t size = 0; size <= 100; ++size) sizes.push_back(size);
  sizes.insert(sizes.end(), {882, 888, 889, 890, 896, 1777, 1778, 1779, 5000});
  return sizes;
}

/// Gives and takes bytes as an application does that has not all of them at a time.
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
  EXPECT_LE(line.domain.longest_piece, 7U);
}

}  // namespace
}  // namespace canvoy
