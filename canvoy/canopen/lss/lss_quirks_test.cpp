// Naming networks with the slaves of other stacks, where these do not do as CiA 305 says: the fault
// is theirs, the users are ours.
#include <gtest/gtest.h>

#include <deque>

#include "canvoy/canopen/lss/lss_scan.hpp"
#include "canvoy/canopen/testing/lss_network.hpp"

namespace canvoy::lss_quirks_test {
namespace {

using Outcome = LssScan::Outcome;

enum class Quirk : std::uint8_t {
  none,
  answers_named,       ///< Fastscan, although it has a node-ID
  answers_everything,  ///< each message of Fastscan in state configuration
};

/// An LSS slave of somebody else, message by message.
class OtherSlave {
 public:
  OtherSlave(SimulatedBus& bus, const LssAddress& address, Quirk quirk)
      : bus_(bus),
        controller_(bus.attach({.listener = {.context = this, .on_frame = &OtherSlave::heard}})),
        address_(address),
        quirk_(quirk) {}

  NodeId id = node_id_unconfigured;

 private:
  static void heard(void* context, Time, const Frame& frame) {
    if (frame.id == 0x7E5) static_cast<OtherSlave*>(context)->take(frame);
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
    if (configures_) {
      if (quirk_ == Quirk::answers_everything) answer(0x4F);
      return;
    }
    if (is_node_id(id) && quirk_ != Quirk::answers_named) return;
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

struct Mixed {
  explicit Mixed(NodeId last_id = 127) : last(last_id) {
    scan.on_choose(LssScan::Choose::to<&Mixed::choose>(*this));
    scan.on_found(LssScan::Report::to<&Mixed::found>(*this));
  }
  void add(std::uint32_t serial, Quirk quirk) {
    others.emplace_back(network.bus, LssAddress{{0x360, 5, 1, serial}}, quirk);
  }
  NodeId choose(const LssAddress&) { return next > last ? node_id_unconfigured : next++; }
  void found(const LssScan::Found& node) { serials.push_back(node.address.parts[3]); }
  void ended(Outcome outcome) { result = outcome; }
  Outcome run() {
    EXPECT_TRUE(scan.start({}, LssScan::Done::to<&Mixed::ended>(*this)));
    EXPECT_TRUE(network.run_until(Time(10min), [this] { return result.has_value(); }));
    return result.value_or(Outcome::lost);
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

TEST(LssQuirks, OfSlavesThatAnswerEverythingNoneIsToldThatIsNotThere) {
  Mixed sut(0);  // they are identified only
  for (const std::uint32_t serial : {1U, 2U, 3U}) sut.add(serial, Quirk::answers_everything);
  EXPECT_EQ(sut.run(), Outcome::hidden);
  EXPECT_EQ(sut.serials, (std::vector<std::uint32_t>{1}));
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
