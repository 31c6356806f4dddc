// An LSS scan of an LssNetwork that assigns node-IDs, and its results, for tests.
//
//     LssScanner scanner(network);
//     EXPECT_EQ(scanner.run(), LssScan::Outcome::complete);
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/testing/lss_network.hpp"

namespace canvoy {

/// Scans a network, and assigns node-IDs from 10 on.
struct LssScanner {
  explicit LssScanner(LssNetwork& owner, NodeId last_id = 127)
      : network(owner), scan(owner.node(), owner.master, memory), last(last_id) {
    scan.on_choose(LssScan::Choose::to<&LssScanner::choose>(*this));
    scan.on_found(LssScan::Report::to<&LssScanner::found>(*this));
  }
  NodeId choose(const LssAddress&) { return next > last ? node_id_unconfigured : next++; }
  void found(const LssScan::Found& node) {
    nodes.push_back(node);
    time_outs.push_back(scan.fastscan().time_out());
  }
  void ended(LssScan::Outcome outcome) { result = outcome; }

  LssScan::Outcome run(const LssScan::Options& options = {}, Duration limit = 10min) {
    EXPECT_TRUE(scan.start(options, LssScan::Done::to<&LssScanner::ended>(*this)));
    begun = network.now;
    EXPECT_TRUE(network.run_until(network.now + limit, [this] { return result.has_value(); }));
    return result.value_or(LssScan::Outcome::lost);
  }
  std::chrono::milliseconds took() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(network.now - begun);
  }

  LssNetwork& network;
  std::array<LssAddress, 32> memory;
  LssScan scan;
  NodeId next = 10;
  NodeId last;
  Time begun{};
  std::vector<LssScan::Found> nodes;
  std::vector<Duration> time_outs;  ///< time-out of one bit, for each of `nodes`
  std::optional<LssScan::Outcome> result;
};

/// Devices of one kind: they differ in one bit of the serial number, or a few.
inline std::vector<LssAddress> similar_addresses(std::size_t count) {
  std::vector<LssAddress> addresses(count, LssAddress{{0x2F0, 419, 0x0001'0002, 0x1000}});
  for (std::size_t i = 0; i < count; ++i) addresses[i].parts[3] += static_cast<std::uint32_t>(i);
  return addresses;
}

/// Blocks transmission for a while: 2 ms for each frame that waits.
inline void fill_controller(LssNetwork& network) {
  while (!network.node().transmitter().full()) {
    network.node().transmitter().send(wire_frame("7FE#00 00 00 00 00 00 00 00"));
  }
}

}  // namespace canvoy
