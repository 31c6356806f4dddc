// Scans of networks with slaves of other stacks that deviate from CiA 305: the scan must handle
// them.
#include <gtest/gtest.h>

#include <deque>
#include <functional>

#include "canvoy/can/testing/tries_all.hpp"
#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/testing/lss_network.hpp"

namespace canvoy::lss_quirks_test {
namespace {

using Outcome = LssScan::Outcome;

enum class Quirk : std::uint8_t {
  none,
  answers_named,       ///< Fastscan, although it has a node-ID
  answers_everything,  ///< each message of Fastscan in state configuration
  answers_both,        ///< Fastscan although it has a node-ID, and everything in configuration
  answers_always,      ///< each message of Fastscan in any state
  has_no_place,        ///< answers for every part at any time, and everything in configuration
};

/// An LSS slave of another stack, message by message.
class OtherSlave {
 public:
  OtherSlave(SimulatedBus& bus, const LssAddress& address, Quirk quirk)
      : bus_(bus),
        controller_(bus.attach({.listener = {.context = this, .on_frame = &OtherSlave::heard}})),
        address_(address),
        quirk_(quirk) {}

  NodeId id = node_id_unconfigured;
  bool is_there = true;
  bool configures() const { return configures_; }

 private:
  static void heard(void* context, Time, const Frame& frame) {
    auto& self = *static_cast<OtherSlave*>(context);
    if (frame.id == 0x7E5 && self.is_there) self.take(frame);
  }
  void answer(std::uint8_t command, std::uint32_t value = 0) {
    Frame frame = Frame::data_frame(0x7E4, {command, 0, 0, 0, 0, 0, 0, 0});
    store(&frame.data[1], value);
    bus_.send(controller_, frame);
  }
  void take(const Frame& frame) {
    const std::uint8_t command = frame.data[0];
    const auto value = load<std::uint32_t>(&frame.data[1]);
    if (command == 0x04) configures_ = frame.data[1] == 1;
    if (command >= 0x40 && command <= 0x43 && !configures_) return select(command - 0x40U, value);
    if (command == 0x51) return fastscan(value, frame.data[5], frame.data[6], frame.data[7]);
    if (!configures_) return;
    if (command == 0x11) id = frame.data[1];
    if (command == 0x11 || command == 0x17) answer(command);
    if (command >= 0x5A && command <= 0x5D) answer(command, address_.parts[command - 0x5AU]);
  }
  void select(std::size_t part, std::uint32_t value) {
    selected_ = (part == 0 || selected_) && value == address_.parts[part];
    configures_ = part == 3 && selected_;
    if (configures_) answer(0x44);
  }
  void fastscan(std::uint32_t value, std::uint8_t bit, std::uint8_t sub, std::uint8_t next) {
    if (quirk_ == Quirk::answers_always) return answer(0x4F);
    if (configures_) {
      if (quirk_ != Quirk::none && quirk_ != Quirk::answers_named) answer(0x4F);
      return;
    }
    if (quirk_ == Quirk::has_no_place) place_ = sub;
    const bool with_id = quirk_ == Quirk::answers_named || quirk_ == Quirk::answers_both;
    if (is_node_id(id) && !with_id) return;
    if (bit == 0x80) {
      place_ = 0;
      return answer(0x4F);
    }
    if (sub != place_ || ((address_.parts[sub] ^ value) >> bit) != 0) return;
    answer(0x4F);
    if (bit != 0) return;
    place_ = next;
    configures_ = next < sub;
  }

  SimulatedBus& bus_;
  ControllerId controller_;
  LssAddress address_;
  Quirk quirk_;
  std::uint8_t place_ = 0;
  bool configures_ = false;
  bool selected_ = false;
};

using Message = std::array<std::uint8_t, 8>;

Message message(std::uint8_t command, std::uint32_t value = 0) {
  Message bytes{command};
  store(&bytes[1], value);
  return bytes;
}

Message fastscan(std::uint32_t value, std::uint8_t bit, std::uint8_t sub, std::uint8_t next) {
  Message bytes = message(0x51, value);
  bytes[5] = bit;
  bytes[6] = sub;
  bytes[7] = next;
  return bytes;
}

struct Mixed {
  explicit Mixed(NodeId last_id = 127) : last(last_id) {
    scan.on_choose(LssScan::Choose::to<&Mixed::choose>(*this));
    scan.on_found(LssScan::Report::to<&Mixed::found>(*this));
    network.bus.observe({.context = this, .on_frame = &Mixed::heard});
  }
  void add(std::uint32_t serial, Quirk quirk) { add({{0x360, 5, 1, serial}}, quirk); }
  void add(const LssAddress& address, Quirk quirk) {
    others.emplace_back(network.bus, address, quirk);
  }
  static void heard(void* context, Time, ControllerId, const Frame& frame) {
    auto& self = *static_cast<Mixed*>(context);
    if (frame.id != 0x7E5) return;
    self.requests.push_back({});
    std::ranges::copy(frame.data, self.requests.back().begin());
    if (self.at_request) self.at_request(self.requests.size());
  }
  NodeId choose(const LssAddress&) { return next > last ? node_id_unconfigured : next++; }
  void found(const LssScan::Found& node) {
    serials.push_back(node.address.parts[3]);
    nodes.push_back(node);
  }
  void ended(Outcome outcome) { result = outcome; }
  Outcome run(const LssPattern& pattern = {}) {
    network.start();
    EXPECT_TRUE(scan.start({.pattern = pattern}, LssScan::Done::to<&Mixed::ended>(*this)));
    EXPECT_TRUE(network.run_until(Time(10min), [this] { return result.has_value(); }));
    EXPECT_FALSE(network.run_until(network.now + 1s, [] { return false; }));
    for (const OtherSlave& other : others) EXPECT_FALSE(other.configures() && other.is_there);
    return result.value_or(Outcome::lost);
  }
  std::vector<LssAddress> addresses() const {
    std::vector<LssAddress> all;
    for (const LssScan::Found& node : nodes) all.push_back(node.address);
    std::ranges::sort(all, {}, &LssAddress::parts);
    return all;
  }
  std::vector<NodeId> ids() const {
    std::vector<NodeId> all;
    for (const OtherSlave& other : others) all.push_back(other.id);
    return all;
  }

  LssNetwork network;
  std::deque<OtherSlave> others;
  std::array<LssAddress, 32> memory;
  LssScan scan{network.node(), network.master, memory};
  NodeId last;
  NodeId next = 10;
  std::vector<std::uint32_t> serials;
  std::vector<LssScan::Found> nodes;
  std::vector<Message> requests;
  std::function<void(std::size_t)> at_request;  ///< called with their number so far
  std::optional<Outcome> result;
};

TEST(LssQuirks, SlavesWithoutOneAreNamedOnceEach) {
  Mixed sut;
  for (const std::uint32_t serial : {7U, 8U, 9U}) sut.add(serial, Quirk::none);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.ids(), (std::vector<NodeId>{10, 11, 12}));
  EXPECT_FALSE(sut.scan.came_again());
}

TEST(LssQuirks, SlavesThatAnswerFastscanWithANodeIdAreNamedOnceEach) {
  for (const std::size_t count : {1U, 2U, 3U, 5U}) {
    Mixed sut;
    std::vector<NodeId> wanted;
    for (std::size_t i = 0; i < count; ++i) {
      sut.add(static_cast<std::uint32_t>(0x100 + i * 3), Quirk::answers_named);
      wanted.push_back(static_cast<NodeId>(10 + i));
    }
    EXPECT_EQ(sut.run(), Outcome::complete);
    EXPECT_EQ(sut.ids(), wanted);
    EXPECT_EQ(sut.serials.size(), count) << "and told of once each";
    EXPECT_TRUE(sut.scan.came_again());
  }
}

TEST(LssQuirks, SlavesThatAnswerFastscanWithANodeIdKeepNoOthersFromBeingNamed) {
  Mixed sut;
  sut.add(1, Quirk::answers_named);
  sut.add(2, Quirk::none);
  sut.add(3, Quirk::answers_named);
  sut.add(4, Quirk::answers_everything);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.ids(), (std::vector<NodeId>{10, 11, 12, 13}));
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(LssQuirks, SlavesThatAnswerEverythingInStateConfigurationAreNamed) {
  Mixed sut;
  for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_everything);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.ids(), (std::vector<NodeId>{10, 11, 12}));
}

TEST(LssQuirks, SlavesThatAnswerEverythingAlsoWithANodeIdAreNamedOnceEach) {
  Mixed sut;
  for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_both);
  sut.add(4, Quirk::none);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.ids(), (std::vector<NodeId>{10, 11, 12, 13}));
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

// Without node-IDs to assign, as in Mixed(0), they are identified only.

TEST(LssQuirks, SlavesThatAnswerEverythingAreAllIdentifiedOnceEach) {
  Mixed sut(0);
  for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_everything);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_FALSE(sut.scan.came_again());
  EXPECT_LT(sut.network.now, Time(8s));
}

/// Both values of each bit from 31 to 3 of the serial numbers 6 and 7.
std::vector<Message> upper_bits() {
  std::vector<Message> all;
  for (std::uint8_t bit = 31; bit >= 3; --bit) {
    all.push_back(fastscan(0, bit, 3, 3));
    all.push_back(fastscan(1U << bit, bit, 3, 3));
  }
  return all;
}

/// All waiting, all slaves, and the three known parts.
std::vector<Message> beginning() {
  return {message(0x04, 0), fastscan(0, 0x80, 0, 0), fastscan(0x360, 0, 0, 1), fastscan(5, 0, 1, 2),
          fastscan(1, 0, 2, 3)};
}

TEST(LssQuirks, BothValuesOfEachBitAreAskedForAndNobodyEntersConfigurationByFastscan) {
  Mixed sut(0);
  for (const std::uint32_t serial : {6U, 7U}) sut.add(serial, Quirk::answers_everything);
  const LssPattern kind{.address = {{0x360, 5, 1, 0}}, .known = {true, true, true}};
  EXPECT_EQ(sut.run(kind), Outcome::complete);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{6, 7}));
  std::vector<Message> wanted;
  const auto add = [&](const std::vector<Message>& more) {
    wanted.insert(wanted.end(), more.begin(), more.end());
  };
  const auto walk = [&](const std::vector<Message>& selection) {
    add(beginning());
    add(upper_bits());
    add({fastscan(0, 2, 3, 3), fastscan(4, 2, 3, 3), fastscan(4, 1, 3, 3), fastscan(6, 1, 3, 3),
         fastscan(6, 0, 3, 3), fastscan(7, 0, 3, 3), fastscan(6, 0, 3, 3)});
    add(beginning());
    add({fastscan(7, 0, 3, 3)});
    add(selection);
  };
  walk({message(0x04, 0), message(0x40, 0x360), message(0x41, 5), message(0x42, 1),
        message(0x43, 7)});
  walk({});
  add({message(0x04, 0)});
  // From the second command on that sends all to waiting.
  auto from = std::find(sut.requests.begin() + 1, sut.requests.end(), message(0x04, 0));
  EXPECT_EQ(std::vector<Message>(from, sut.requests.end()), wanted);
}

TEST(LssQuirks, SlavesThatAnswerEverythingAreIdentifiedAmongOthersWhereverTheyDiffer) {
  Mixed sut(0);
  std::vector<LssAddress> all{{{0x360, 5, 1, 8}}, {{0, 0, 0, 0}}};
  all.push_back({{0xFFFF'FFFF, 0xFFFF'FFFF, 0xFFFF'FFFF, 0xFFFF'FFFF}});
  for (std::size_t part = 0; part < 4; ++part) {
    for (const unsigned bit : {0U, 17U, 31U}) {
      all.push_back(all.front());
      all.back().parts[part] ^= 1U << bit;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 3 == 0) sut.network.add(all[i], {.latency = 700us * static_cast<int>(i)});
    if (i % 3 != 0) sut.add(all[i], i % 3 == 1 ? Quirk::answers_everything : Quirk::none);
  }
  EXPECT_EQ(sut.run(), Outcome::complete);
  std::ranges::sort(all, {}, &LssAddress::parts);
  EXPECT_EQ(sut.addresses(), all);
  EXPECT_EQ(sut.network.boot_ups(), 0U);
}

TEST(LssQuirks, OneThatAnswersEverythingWithASerialNumberOfZeroHidesNobody) {
  Mixed sut(0);
  for (const std::uint32_t serial : {0U, 9U}) sut.add(serial, Quirk::answers_everything);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{0, 9}));
  EXPECT_FALSE(sut.scan.came_again());
}

TEST(LssQuirks, OneThatAnswersEverythingAndIsKnownWholeIsFoundOnce) {
  Mixed sut(0);
  for (const std::uint32_t serial : {8U, 9U}) sut.add(serial, Quirk::answers_everything);
  const LssPattern one{.address = {{0x360, 5, 1, 9}}, .known = {true, true, true, true}};
  EXPECT_EQ(sut.run(one), Outcome::complete);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{9}));
}

TEST(LssQuirks, OnlySlavesLikeThePatternAreIdentified) {
  Mixed sut(0);
  for (const std::uint32_t product : {4U, 5U, 6U}) {
    for (const std::uint32_t serial : {1U, 2U}) {
      sut.add({{0x360, product, 1, serial}}, Quirk::answers_everything);
    }
  }
  const LssPattern kind{.address = {{0x360, 5, 0, 0}}, .known = {true, true}};
  EXPECT_EQ(sut.run(kind), Outcome::complete);
  EXPECT_EQ(sut.addresses(), (std::vector<LssAddress>{{{0x360, 5, 1, 1}}, {{0x360, 5, 1, 2}}}));
}

TEST(LssQuirks, WhenTheNodeIdsAreUsedUpTheRestIsIdentifiedAndWhoAnswersWithANodeIdIsNotAgain) {
  Mixed sut(11);
  sut.add(1, Quirk::answers_named);
  for (const std::uint32_t serial : {2U, 3U, 4U}) sut.add(serial, Quirk::answers_everything);
  sut.add(5, Quirk::answers_named);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(sut.ids(), (std::vector<NodeId>{10, 11, 255, 255, 255}));
}

TEST(LssQuirks, OneThatVanishesAtAnyTimeEndsNoScanAndHidesNobodyElse) {
  for (const std::size_t gone : {0U, 1U}) {
    for (std::size_t request = 1; request < 1000; request += 9) {
      Mixed sut(0);
      for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_everything);
      sut.at_request = [&](std::size_t count) { sut.others[gone].is_there = count < request; };
      ASSERT_EQ(sut.run(), Outcome::complete) << gone << ' ' << request;
      ASSERT_EQ(std::ranges::count(sut.serials, 2U - gone), 1) << request;
      ASSERT_EQ(std::ranges::count(sut.serials, 3U), 1) << request;
      ASSERT_LE(sut.serials.size(), 3U) << request;
      ASSERT_LT(sut.requests.size(), 2000U) << request;
    }
  }
}

TEST(LssQuirks, OneThatAppearsAtAnyTimeEndsNoScanAndHidesNobodyElse) {
  for (std::size_t request = 1; request < 700; request += 9) {
    Mixed sut(0);
    for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_everything);
    sut.others[1].is_there = false;
    sut.at_request = [&](std::size_t count) { sut.others[1].is_there = count >= request; };
    ASSERT_EQ(sut.run(), Outcome::complete) << request;
    ASSERT_EQ(std::ranges::count(sut.serials, 1U), 1) << request;
    ASSERT_EQ(std::ranges::count(sut.serials, 3U), 1) << request;
    ASSERT_LE(sut.serials.size(), 3U) << request;
  }
}

TEST(LssQuirks, AllThatVanishEndTheScan) {
  for (std::size_t request = 140; request < 700; request += 13) {
    Mixed sut(0);
    for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_everything);
    sut.at_request = [&](std::size_t count) {
      for (OtherSlave& other : sut.others) other.is_there = count < request;
    };
    sut.run();
    ASSERT_LE(sut.serials.size(), 3U) << request;
    ASSERT_LT(sut.requests.size(), 2000U) << request;
  }
}

TEST(LssQuirks, AnyAnswerMayGetLost) {
  for (std::size_t lost = 1; lost < 900; lost += tries_all() ? 2 : 7) {
    Mixed sut(0);
    sut.add(1, Quirk::answers_everything);
    sut.add(6, Quirk::answers_everything);
    sut.add({{0x361, 5, 1, 7}}, Quirk::none);
    std::size_t answers = 0;
    sut.network.master_member().deaf = [&](const Frame& frame) {
      return frame.id == 0x7E4 && ++answers == lost;
    };
    ASSERT_EQ(sut.run(), Outcome::complete) << lost;
    ASSERT_EQ(sut.addresses(),
              (std::vector<LssAddress>{{{0x360, 5, 1, 1}}, {{0x360, 5, 1, 6}}, {{0x361, 5, 1, 7}}}))
        << lost;
  }
}

TEST(LssQuirks, AnyRequestMayGetLost) {
  for (std::size_t lost = 2; lost < 700; lost += tries_all() ? 3 : 8) {
    Mixed sut(0);
    for (const std::uint32_t serial : {1U, 6U}) sut.add(serial, Quirk::answers_everything);
    sut.at_request = [&](std::size_t count) {
      for (OtherSlave& other : sut.others) other.is_there = count != lost;
    };
    ASSERT_EQ(sut.run(), Outcome::complete) << lost;
    ASSERT_EQ(sut.addresses(), (std::vector<LssAddress>{{{0x360, 5, 1, 1}}, {{0x360, 5, 1, 6}}}))
        << lost;
  }
}

TEST(LssQuirks, OneThatBecomesSlowIsIdentifiedAllTheSame) {
  for (const bool always : {true, false}) {
    Mixed sut(0);
    sut.add(1, Quirk::answers_everything);
    LssNetwork::Member& slow = sut.network.add({{0x360, 5, 2, 7}});
    sut.at_request = [&](std::size_t count) {
      const bool is_fast = count < 300 || (!always && sut.requests.back()[5] == 0x80);
      slow.latency = is_fast ? 1ms : always ? 17ms : 47ms;
    };
    EXPECT_EQ(sut.run(), Outcome::complete);
    EXPECT_EQ(sut.addresses(), (std::vector<LssAddress>{{{0x360, 5, 1, 1}}, {{0x360, 5, 2, 7}}}));
  }
}

TEST(LssQuirks, WhereTheOnlyOneLikeThePatternVanishesTheScanIsComplete) {
  for (const bool is_known_whole : {true, false}) {
    Mixed sut(0);
    sut.add({{0x360, 5, 1, 9}}, Quirk::answers_everything);
    sut.add({{0x360, 5, 1, 8}}, Quirk::answers_everything);
    sut.add({{0x360, 6, 1, 9}}, Quirk::answers_everything);
    // At its identification; in the other case together with slaves that have its product code.
    const std::size_t end = is_known_whole ? 25 : 150;
    sut.at_request = [&](std::size_t count) {
      sut.others[0].is_there = count < end;
      sut.others[1].is_there = is_known_whole || count < end;
    };
    const LssPattern pattern{.address = {{0x360, 5, 1, 9}},
                             .known = {true, true, is_known_whole, is_known_whole}};
    EXPECT_EQ(sut.run(pattern), Outcome::complete) << is_known_whole;
    EXPECT_LE(sut.serials.size(), 2U);
  }
}

TEST(LssQuirks, TwoThatHaveOneAddressAreToldOf) {
  Mixed sut(0);
  sut.add(1, Quirk::answers_everything);
  for (const Duration latency : {1ms, 4ms})
    sut.network.add({{0x999, 9, 9, 9}}, {.latency = latency});
  EXPECT_EQ(sut.run(), Outcome::complete);
  ASSERT_EQ(sut.nodes.size(), 2U);
  EXPECT_FALSE(sut.nodes[0].duplicate);
  EXPECT_TRUE(sut.nodes[1].duplicate);
}

TEST(LssQuirks, WhatIsMadeUpOfPartsOfTwoIsPassedOver) {
  Mixed sut(0);
  sut.add({{1, 1, 1, 1}}, Quirk::has_no_place);
  sut.add({{1, 1, 2, 2}}, Quirk::answers_everything);
  const Outcome outcome = sut.run();
  EXPECT_EQ(sut.addresses(), (std::vector<LssAddress>{{{1, 1, 1, 1}}, {{1, 1, 2, 2}}}));
  EXPECT_EQ(outcome, Outcome::hidden) << "it stays doubtful whether these are all";
}

TEST(LssQuirks, WhereOneAnswersForAllOthersNoneIsToldThatIsNotThere) {
  Mixed sut(0);
  sut.add(1, Quirk::answers_everything);
  sut.others.emplace_back(sut.network.bus, LssAddress{{1, 2, 3, 4}}, Quirk::answers_always)
      .is_there = false;
  sut.at_request = [&](std::size_t count) { sut.others[1].is_there = count > 200; };
  EXPECT_EQ(sut.run(), Outcome::hidden);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{1}));
  EXPECT_LT(sut.requests.size(), 1500U);
}

TEST(LssQuirks, MoreThanThereIsMemoryForEndTheScan) {
  Mixed sut(0);
  for (std::uint32_t serial = 1; serial <= 33; ++serial) {
    sut.add(serial, Quirk::answers_everything);
  }
  EXPECT_EQ(sut.run(), Outcome::full);
  EXPECT_EQ(sut.serials.size(), 32U);
}

TEST(LssQuirks, ASerialNumberOfZeroIsOneAllTheSame) {
  Mixed sut(0);
  for (const std::uint32_t serial : {3U, 0U, 2U}) sut.add(serial, Quirk::none);
  sut.others.emplace_back(sut.network.bus, LssAddress{{0x35F, 5, 1, 1}}, Quirk::none);
  EXPECT_EQ(sut.run(), Outcome::complete);
  EXPECT_EQ(sut.serials.size(), 4U);
  EXPECT_EQ(std::ranges::count(sut.serials, 0U), 1);
}

}  // namespace
}  // namespace canvoy::lss_quirks_test
