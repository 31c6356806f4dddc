// LSS scans with a controller that takes no frame for a while.
#include <gtest/gtest.h>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/testing/lss_scanner.hpp"

namespace canvoy::lss_scan_full_controller_test {
namespace {

using Outcome = LssScan::Outcome;
using Scanner = LssScanner;

/// A scan that has its nodes store their node-IDs, with a controller that is full for `time` from
/// the moment on at which the bus has had so many frames.
void scan_with_a_full_controller(std::size_t frames, Duration time, bool names) {
  LssNetwork network;
  const auto addresses = similar_addresses(2);
  for (const LssAddress& address : addresses) network.add(address);
  network.start();
  Scanner scanner(network, names ? NodeId{127} : NodeId{9});
  ASSERT_TRUE(scanner.scan.start({.store = true}, LssScan::Done::to<&Scanner::ended>(scanner)));
  std::optional<Time> full_until;
  ASSERT_TRUE(network.run_until(Time(10min), [&] {
    if (!full_until && network.frames() >= frames) full_until = network.now + time;
    if (full_until && network.now < *full_until) fill_controller(network);
    return scanner.result.has_value();
  }));
  network.run_until(network.now + 2s, [] { return false; });
  const std::size_t named = names ? scanner.nodes.size() : 0;
  EXPECT_LE(network.boot_ups(), named) << frames;
  EXPECT_TRUE(scanner.result != Outcome::complete || scanner.nodes.size() == 2) << frames;
}

TEST(LssScanFullController, AFullControllerAtAnyMomentIsOvercomeOrTheScanIsNotComplete) {
  for (const bool names : {true, false}) {
    LssNetwork network;
    for (const LssAddress& address : similar_addresses(2)) network.add(address);
    network.start();
    Scanner scanner(network, names ? NodeId{127} : NodeId{9});
    ASSERT_EQ(scanner.run({.store = true}), Outcome::complete);
    for (std::size_t frames = 1; frames < network.frames(); frames += tries_all() ? 3 : 10) {
      for (const Duration time : {60ms, 400ms}) {
        scan_with_a_full_controller(frames, time, names);
      }
    }
  }
}

TEST(LssScanFullController, IsNotCompleteWhereNobodyCouldBeAsked) {
  for (const Duration time : {Duration(500ms), Duration(1min)}) {
    LssNetwork network;
    network.add(lss_address);
    network.start();
    Scanner scanner(network);
    fill_controller(network);
    ASSERT_TRUE(scanner.scan.start({}, LssScan::Done::to<&Scanner::ended>(scanner)));
    ASSERT_TRUE(network.run_until(Time(10min), [&] {
      if (network.now < Time(time)) fill_controller(network);
      return scanner.result.has_value();
    }));
    const bool has_time = time == 500ms;
    EXPECT_EQ(scanner.result, has_time ? Outcome::complete : Outcome::lost);
    EXPECT_EQ(scanner.nodes.size(), has_time ? 1u : 0u);
  }
}

TEST(LssScanFullController, TriesThreeTimesToTellAllThatItIsOver) {
  LssNetwork free;
  free.add(lss_address);
  free.start();
  Scanner undisturbed(free);
  ASSERT_EQ(undisturbed.run(), Outcome::complete);
  LssNetwork network;
  network.add(lss_address);
  network.start();
  Scanner scanner(network);
  ASSERT_TRUE(scanner.scan.start({}, LssScan::Done::to<&Scanner::ended>(scanner)));
  ASSERT_FALSE(network.run_until(free.now - 1us, [&] { return scanner.result.has_value(); }));
  ASSERT_TRUE(network.run_until(free.now + 1min, [&] {
    if (network.now < free.now + 150ms) fill_controller(network);
    return scanner.result.has_value();
  }));
  EXPECT_EQ(network.now, free.now + 200ms);
  network.run_until(network.now + 1s, [] { return false; });
  EXPECT_EQ(network.requests(0x04), free.requests(0x04) + 1) << "that of the other is on its way";
}

}  // namespace
}  // namespace canvoy::lss_scan_full_controller_test
