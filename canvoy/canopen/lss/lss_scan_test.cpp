// LSS Fastscan and the scan over all nodes, on a simulated bus of 125 kbit/s.
#include "canvoy/canopen/lss/lss_scan.hpp"

#include <gtest/gtest.h>

#include <set>

#include "canvoy/can/random.hpp"
#include "canvoy/canopen/testing/lss_scanner.hpp"

namespace canvoy::lss_scan_test {
namespace {

using Outcome = LssScan::Outcome;
using Scanner = LssScanner;

std::vector<LssAddress> random_addresses(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<LssAddress> addresses(count);
  for (LssAddress& address : addresses) {
    for (std::uint32_t& part : address.parts) part = static_cast<std::uint32_t>(random.next());
  }
  return addresses;
}

/// Checks that every node has its own node-ID, and has booted with it.
void expect_all_named(LssNetwork& network, const Scanner& scanner,
                      const std::vector<LssAddress>& addresses) {
  EXPECT_EQ(scanner.nodes.size(), addresses.size());
  EXPECT_EQ(network.boot_ups(), addresses.size());
  std::set<NodeId> ids;
  for (auto& member : network.members()) {
    if (!member.slave) continue;
    EXPECT_EQ(member.node.state(), NmtState::pre_operational);
    EXPECT_EQ(member.slave->state(), LssState::waiting);
    ids.insert(member.node.id());
  }
  EXPECT_EQ(ids.size(), addresses.size());
  for (const LssScan::Found& found : scanner.nodes) EXPECT_FALSE(found.duplicate);
}

/// Records the virtual time taken in the report of the tests.
void note_time(const Scanner& scanner) {
  testing::Test::RecordProperty("milliseconds", static_cast<int>(scanner.took().count()));
  testing::Test::RecordProperty("frames", static_cast<int>(scanner.network.frames()));
}

TEST(LssScan, Finds16RandomNodesAndEachBootsWithItsOwnNodeId) {
  LssNetwork network;
  const auto addresses = random_addresses(16, 1);
  for (const LssAddress& address : addresses) network.add(address);
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, addresses);
  for (const LssAddress& address : addresses) {
    EXPECT_NE(std::ranges::find(scanner.scan.found(), address), scanner.scan.found().end());
  }
  note_time(scanner);
  EXPECT_LT(scanner.took(), 9s);
}

TEST(LssScan, Finds16NodesOfOneKindFaster) {
  LssNetwork network;
  const auto addresses = similar_addresses(16);
  for (const LssAddress& address : addresses) network.add(address);
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, addresses);
  note_time(scanner);
  EXPECT_LT(scanner.took(), 3s);
}

TEST(LssScan, Finds16RandomNodesThatAnswerAtTheirOwnPace) {
  LssNetwork network;
  const auto addresses = random_addresses(16, 2);
  Random random(3);
  for (const LssAddress& address : addresses) {
    network.add(address, {.latency = Duration(random.below(3000))});
  }
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, addresses);
  note_time(scanner);
  EXPECT_LT(scanner.took(), 15s);
}

TEST(LssScan, FindsNodesThatDifferInOneBitAnywhere) {
  LssNetwork network;
  std::vector<LssAddress> addresses(1, lss_address);
  for (std::size_t part = 0; part < 4; ++part) {
    for (const unsigned bit : {0U, 16U, 31U}) {
      addresses.push_back(lss_address);
      addresses.back().parts[part] ^= 1U << bit;
    }
  }
  addresses.push_back({{0, 0, 0, 0}});
  addresses.push_back({{0xFFFF'FFFF, 0xFFFF'FFFF, 0xFFFF'FFFF, 0xFFFF'FFFF}});
  for (const LssAddress& address : addresses) network.add(address);
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, addresses);
}

TEST(LssScan, EndsSoonWhereNobodyWaits) {
  LssNetwork network;
  network.add(lss_address, {.id = 5});
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  EXPECT_EQ(scanner.nodes.size(), 0U);
  EXPECT_EQ(scanner.took(), 700ms) << "100, 200 and 400 ms of silence";
}

TEST(LssScan, MeasuresTheSlowestAnswerAndFindsNodesOfAnySpeed) {
  LssNetwork network;
  const auto addresses = random_addresses(6, 7);
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    network.add(addresses[i], {.latency = Duration(4ms) * static_cast<int>(i)});
  }
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, addresses);
  EXPECT_GE(scanner.time_outs.at(0), Duration(40ms));
  EXPECT_LE(scanner.time_outs.at(0), Duration(60ms));
}

TEST(LssScan, LearnsOfANodeThatBecameSlowLater) {
  LssNetwork network;
  LssNetwork::Member& member = network.add(lss_address);
  network.start();
  Scanner scanner(network);
  // Fast at first, and slower than the measured time-out from the tenth request on.
  int requests = 0;
  member.deaf = [&](const Frame& frame) {
    if (frame.id == 0x7E5 && ++requests == 10) member.latency = 11ms;
    return false;
  };
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, {lss_address});
  EXPECT_GE(scanner.scan.fastscan().time_out(), Duration(11ms));
}

// As when a cable is mended, and all nodes have much to send before their answer: the scan waits 70
// ms, and twice that after each bit of the first, some 120 of them: 17 s. The other seven have 35
// messages each: 34 s with an unchanged pace, and 5 s, 2.5 s and so on, less than 10 s in all, if
// it halves.
TEST(LssScan, WaitsNoLongerThanItTakesOnceThoseWhoWereSlowAreFast) {
  LssNetwork network;
  const auto addresses = similar_addresses(8);
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    network.add(addresses[i], {.latency = Duration(10ms) * static_cast<int>(i)});
  }
  unsigned requests = 0;
  const auto hurry = [&](const Frame& frame) {
    if (frame.id != 0x7E5 || ++requests != 2) return false;
    for (LssNetwork::Member& member : network.members()) member.latency /= 20;
    return false;
  };
  network.members().back().deaf = hurry;
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  expect_all_named(network, scanner, addresses);
  note_time(scanner);
  EXPECT_LT(scanner.took(), 35s);
}

TEST(LssScan, FindsItsWayAgainAfterAnyLostRequest) {
  for (int lost = 1; lost <= 140; ++lost) {
    LssNetwork network;
    LssNetwork::Member& member = network.add(lss_address);
    network.start();
    Scanner scanner(network);
    int requests = 0;
    member.deaf = [&](const Frame& frame) { return frame.id == 0x7E5 && ++requests == lost; };
    ASSERT_EQ(scanner.run(), Outcome::complete) << lost;
    ASSERT_EQ(scanner.nodes.size(), 1U) << lost;
    ASSERT_EQ(scanner.nodes[0].address, lss_address) << lost;
  }
}

TEST(LssScan, FindsItsWayAgainAfterAnyLostAnswer) {
  for (int lost = 1; lost <= 90; ++lost) {
    LssNetwork network;
    network.add(lss_address);
    network.start();
    Scanner scanner(network);
    int answers = 0;
    network.master_member().deaf = [&](const Frame& frame) {
      return frame.id == 0x7E4 && ++answers == lost;
    };
    ASSERT_EQ(scanner.run(), Outcome::complete) << lost;
    ASSERT_EQ(scanner.nodes.size(), 1U) << lost;
    ASSERT_EQ(scanner.nodes[0].address, lss_address) << lost;
    ASSERT_EQ(scanner.nodes[0].id, 10) << lost;
  }
}

TEST(LssScan, ReportsTwoNodesWithOneAddress) {
  LssNetwork network;
  network.add(lss_address);
  network.add(lss_address, {.latency = 1500us});
  network.add({{1, 1, 1, 1}});
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  ASSERT_EQ(scanner.nodes.size(), 2U);
  EXPECT_FALSE(scanner.nodes[0].duplicate);
  EXPECT_TRUE(scanner.nodes[1].duplicate);
  EXPECT_EQ(scanner.nodes[1].address, lss_address);
}

TEST(LssScan, TellsWhereAnAddressComesAgain) {
  LssNetwork network;
  network.add(lss_address);
  LssNetwork::Member& second = network.add(lss_address);
  network.start();
  Scanner scanner(network);
  // The second takes part only when the first has its node-ID.
  second.deaf = [&](const Frame&) { return network.boot_ups() == 0; };
  EXPECT_EQ(scanner.run(), Outcome::complete);
  EXPECT_TRUE(scanner.scan.came_again());
  EXPECT_EQ(scanner.nodes.size(), 1U);
  EXPECT_EQ(scanner.scan.last().address, lss_address);
  EXPECT_TRUE(network.run_until(network.now + 1s,
                                [&] { return second.slave->state() == LssState::waiting; }));
}

TEST(LssScan, GivesUpOnAnAddressThatNobodyConfirms) {
  LssNetwork network;
  LssNetwork::Member& member = network.add(lss_address);
  network.start();
  Scanner scanner(network);
  // It receives the first message of a run and no other: like a node without Fastscan.
  member.deaf = [](const Frame& frame) {
    return frame.id == 0x7E5 && !(frame.data[0] == 0x51 && frame.data[5] == 0x80);
  };
  EXPECT_EQ(scanner.run(), Outcome::lost);
  EXPECT_EQ(scanner.nodes.size(), 0U);
  EXPECT_LT(scanner.took(), 3min);
}

TEST(LssScan, FindsANodeAgainThatEnteredConfigurationAndWasNotHeardOf) {
  LssNetwork network;
  LssNetwork::Member& member = network.add(lss_address);
  network.start();
  Scanner scanner(network);
  // Both inquiries of the serial number get lost.
  int inquiries = 0;
  member.deaf = [&](const Frame& frame) {
    return frame.id == 0x7E5 && frame.data[0] == 0x5D && ++inquiries <= 2;
  };
  EXPECT_EQ(scanner.run(), Outcome::complete);
  EXPECT_EQ(inquiries, 3);
  expect_all_named(network, scanner, {lss_address});
}

TEST(LssScan, IsNotCompleteWhereANodeCannotBeInquired) {
  for (const bool known : {false, true}) {
    LssNetwork network;
    LssNetwork::Member& member = network.add(lss_address);
    network.start();
    Scanner scanner(network);
    member.deaf = [](const Frame& frame) { return frame.id == 0x7E5 && frame.data[0] == 0x5D; };
    const LssPattern pattern{.address = lss_address, .known = {known, known, known, known}};
    EXPECT_EQ(scanner.run({.pattern = pattern}), Outcome::lost) << known;
    EXPECT_EQ(scanner.nodes.size(), 0U);
    EXPECT_TRUE(network.run_until(network.now + 1s,
                                  [&] { return member.slave->state() == LssState::waiting; }));
  }
}

TEST(LssScan, IsNotCompleteWhereANodeVanishesWhileItIsIdentified) {
  LssNetwork network;
  LssNetwork::Member& member = network.add(lss_address);
  network.start();
  Scanner scanner(network);
  int requests = 0;
  member.deaf = [&](const Frame& frame) { return frame.id == 0x7E5 && ++requests > 40; };
  EXPECT_EQ(scanner.run(), Outcome::lost);
  EXPECT_EQ(scanner.nodes.size(), 0U);
}

TEST(LssScan, LooksOnlyForWhatIsKnown) {
  LssNetwork network;
  const auto chargers = similar_addresses(3);
  for (const LssAddress& address : chargers) network.add(address);
  network.add({{0x2F0, 418, 1, 1}});
  network.add({{0x100, 419, 1, 1}});
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run({.pattern = {.address = {{0x2F0, 419, 0, 0}}, .known = {true, true}}}),
            Outcome::complete);
  EXPECT_EQ(scanner.nodes.size(), 3U);
  EXPECT_EQ(network.boot_ups(), 3U);
  EXPECT_LT(scanner.took(), 2s);
}

TEST(LssScan, FindsANodeThatIsKnownWholeAtOnce) {
  LssNetwork network;
  network.add(lss_address);
  network.add({{1, 1, 1, 1}});
  network.start();
  Scanner scanner(network);
  const LssPattern pattern{.address = lss_address, .known = {true, true, true, true}};
  EXPECT_EQ(scanner.run({.pattern = pattern}), Outcome::complete);
  EXPECT_EQ(scanner.nodes.size(), 1U);
  EXPECT_LT(scanner.scan.fastscan().requests(), 15U);
}

TEST(LssScan, IdentifiesAllWhereItGivesNoNodeIdAndChangesNothing) {
  LssNetwork network;
  const auto addresses = random_addresses(4, 3);
  for (const LssAddress& address : addresses) network.add(address);
  network.start();
  Scanner scanner(network, 0);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  EXPECT_EQ(scanner.nodes.size(), 4U);
  EXPECT_TRUE(network.run_until(network.now + 1s, [&] {
    return std::ranges::all_of(network.members(), [](const auto& member) {
      return !member.slave || member.slave->state() == LssState::waiting;
    });
  }));
  EXPECT_EQ(network.boot_ups(), 0U);
}

TEST(LssScan, FindsNodesThatKnowFastscanAloneOfAllIdentification) {
  LssNetwork network;
  const auto addresses = random_addresses(4, 4);
  for (const LssAddress& address : addresses) {
    network.add(address).deaf = [](const Frame& frame) {
      return frame.id == 0x7E5 && frame.data[0] >= 0x46 && frame.data[0] <= 0x4C;
    };
  }
  network.start();
  Scanner naming(network, 11);
  EXPECT_EQ(naming.run(), Outcome::complete);
  EXPECT_EQ(naming.nodes.size(), 4U);
  EXPECT_EQ(network.boot_ups(), 2U);
}

TEST(LssScan, FindsItsWayAgainAfterAnyLostAnswerWhileOthersAreInConfiguration) {
  for (int lost = 1; lost <= 120; lost += 3) {
    LssNetwork network;
    network.add(lss_address);
    network.add({{0x0102'0304, 0x1112'1314, 5, 6}});
    network.start();
    Scanner scanner(network, 0);
    int answers = 0;
    network.master_member().deaf = [&](const Frame& frame) {
      return frame.id == 0x7E4 && ++answers == 60 + lost;
    };
    ASSERT_EQ(scanner.run(), Outcome::complete) << lost;
    ASSERT_EQ(scanner.nodes.size(), 2U) << lost;
  }
}

TEST(LssScan, IdentifiesTheRestWhenItsNodeIdsAreUsedUp) {
  LssNetwork network;
  const auto addresses = similar_addresses(5);
  for (const LssAddress& address : addresses) network.add(address);
  network.start();
  Scanner scanner(network, 11);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  ASSERT_EQ(scanner.nodes.size(), 5U);
  EXPECT_EQ(scanner.nodes[1].id, 11);
  EXPECT_EQ(scanner.nodes[2].id, node_id_unconfigured);
  EXPECT_EQ(network.boot_ups(), 2U);
}

TEST(LssScan, LetsNodesStoreWhereItIsAskedFor) {
  LssNetwork network;
  network.add(lss_address);
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run({.pattern = {}, .store = true}), Outcome::complete);
  ASSERT_EQ(scanner.nodes.size(), 1U);
  EXPECT_TRUE(scanner.nodes[0].configured.ok());
  EXPECT_EQ(scanner.nodes[0].stored.outcome, LssMaster::Outcome::refused);
  EXPECT_EQ(scanner.nodes[0].stored.error.code, LssError::store_unsupported);
}

TEST(LssScan, GivesANodeIdAndHasItStoredOnceWhereThatIsAnswered) {
  LssNetwork network;
  network.add(lss_address);
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run({.pattern = {}, .store = true}), Outcome::complete);
  EXPECT_EQ(network.requests(0x11), 1U);
  EXPECT_EQ(network.requests(0x17), 1U);
}

TEST(LssScan, GivesANodeIdThreeTimesWhereNobodyAnswers) {
  LssNetwork network;
  network.add(lss_address).deaf = [](const Frame& frame) {
    return frame.id == 0x7E5 && frame.data[0] == 0x11;
  };
  network.start();
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  EXPECT_EQ(network.requests(0x11), 3U);
  ASSERT_EQ(scanner.nodes.size(), 1U);
  EXPECT_EQ(scanner.nodes[0].configured.outcome, LssMaster::Outcome::time_out);
  EXPECT_EQ(scanner.nodes[0].id, node_id_unconfigured);
}

TEST(LssScan, EndsWhenItsMemoryIsFull) {
  LssNetwork network;
  for (const LssAddress& address : similar_addresses(3)) network.add(address);
  network.start();
  std::array<LssAddress, 2> memory;
  LssScan scan(network.node(), network.master, memory);
  std::optional<Outcome> result;
  auto done = [&](Outcome outcome) { result = outcome; };
  ASSERT_TRUE(scan.start({}, LssScan::Done::of(done)));
  EXPECT_FALSE(scan.start({}, LssScan::Done::of(done))) << "one at a time";
  EXPECT_TRUE(network.run_until(Time(1min), [&] { return result.has_value(); }));
  EXPECT_EQ(result, Outcome::full);
  EXPECT_EQ(scan.found().size(), 2U);
}

/// A scan of three nodes that calls `act` when it needs a node-ID, or reports the first node.
struct Interrupted {
  explicit Interrupted(bool when_choosing) : at_choice(when_choosing) {
    for (const LssAddress& address : similar_addresses(3)) network.add(address);
    network.start();
    scan.on_choose(LssScan::Choose::to<&Interrupted::choose>(*this));
    scan.on_found(LssScan::Report::to<&Interrupted::found>(*this));
  }
  NodeId choose(const LssAddress&) {
    ++choices;
    if (at_choice) act();
    return static_cast<NodeId>(9 + choices);
  }
  void found(const LssScan::Found&) {
    ++reports;
    if (!at_choice) act();
  }
  void ended(Outcome outcome) { results.push_back(outcome); }
  bool start() { return scan.start({}, LssScan::Done::to<&Interrupted::ended>(*this)); }
  void run() {
    EXPECT_TRUE(start());
    network.run_until(network.now + 10min, [] { return false; });
  }

  LssNetwork network;
  std::array<LssAddress, 8> memory;
  LssScan scan{network.node(), network.master, memory};
  bool at_choice;
  std::function<void()> act;
  int choices = 0;
  int reports = 0;
  std::vector<Outcome> results;
};

TEST(LssScan, MayBeCancelledFromItsCallbacks) {
  for (const bool at_choice : {true, false}) {
    Interrupted sut(at_choice);
    sut.act = [&] { sut.scan.cancel(); };
    sut.run();
    EXPECT_EQ(sut.choices, 1);
    EXPECT_EQ(sut.reports, at_choice ? 0 : 1);
    EXPECT_EQ(sut.results.size(), 0U) << "what was given up is not reported";
    EXPECT_EQ(sut.network.boot_ups(), at_choice ? 0U : 1U);
    EXPECT_TRUE(sut.network.master.idle());
    EXPECT_FALSE(sut.scan.fastscan().running());
  }
}

TEST(LssScan, MayBeStartedAnewFromItsCallbacksWhenItWasCancelledAndNotBefore) {
  for (const bool at_choice : {true, false}) {
    Interrupted sut(at_choice);
    bool anew = false;
    sut.act = [&] {
      EXPECT_FALSE(sut.start());
      if (std::exchange(anew, true)) return;
      sut.scan.cancel();
      EXPECT_TRUE(sut.start());
    };
    sut.run();
    EXPECT_EQ(sut.results, std::vector<Outcome>{Outcome::complete});
    EXPECT_EQ(sut.reports, 3);
    EXPECT_EQ(sut.network.boot_ups(), 3U);
  }
}

TEST(LssScan, EndsWhereACallbackTakesTheMasterForSomethingElse) {
  for (const bool at_choice : {true, false}) {
    Interrupted sut(at_choice);
    sut.act = [&] { sut.network.master.inquire_node_id({}); };
    sut.run();
    EXPECT_EQ(sut.results, std::vector<Outcome>{Outcome::lost});
    EXPECT_EQ(sut.reports, 1);
  }
}

TEST(LssScan, LeavesAServiceOfTheMasterAloneWhenItIsNotRunning) {
  Interrupted sut(true);
  EXPECT_TRUE(sut.network.master.inquire_node_id({}));
  sut.scan.cancel();
  EXPECT_FALSE(sut.network.master.idle());
}

TEST(LssScan, WorksAtEveryBitRateOfTheTable) {
  for (const std::uint32_t bit_rate : lss_bit_timing::bit_rates) {
    if (bit_rate == 0) continue;
    LssNetwork network(bit_rate);
    const auto addresses = random_addresses(3, bit_rate);
    for (const LssAddress& address : addresses) network.add(address);
    network.start();
    Scanner scanner(network);
    EXPECT_EQ(scanner.run(), Outcome::complete) << bit_rate;
    expect_all_named(network, scanner, addresses);
  }
}

TEST(LssScan, TriesAgainWhatAFullControllerDidNotTake) {
  for (const bool at_choice : {true, false}) {
    Interrupted sut(at_choice);
    sut.act = [&] { fill_controller(sut.network); };
    sut.run();
    EXPECT_EQ(sut.results, std::vector<Outcome>{Outcome::complete});
    EXPECT_EQ(sut.choices, 3) << "no node is found twice";
    EXPECT_EQ(sut.reports, 3);
    EXPECT_EQ(sut.network.boot_ups(), 3U);
  }
}

TEST(LssScan, WaitsForItsTimeOutsWhereNoFrameGetsOutAndEnds) {
  LssNetwork network;
  network.add(lss_address);
  network.start();
  network.bus.power(network.master_member().controller, false);
  Scanner scanner(network);
  EXPECT_EQ(scanner.run(), Outcome::complete);
  EXPECT_EQ(scanner.nodes.size(), 0U);
  EXPECT_LT(scanner.took(), 2s);
}

}  // namespace
}  // namespace canvoy::lss_scan_test
