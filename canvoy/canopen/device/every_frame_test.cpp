// Exhaustive test of a node with all services: each of the 2,048 CAN-IDs, with each length, as data
// and as remote frame, in each NMT state; and each bit flip of a valid frame. The answer is that of
// CiA 301, or none, and the node keeps working.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "canvoy/canopen/device/device_node.hpp"
#include "canvoy/canopen/testing/bit_flips.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::every_frame_test {
namespace {

using Texts = std::vector<std::string>;

constexpr ObjectRow object(std::uint16_t index, std::uint16_t entries = 1) {
  return {.index = index, .entry_count = entries};
}
constexpr EntryRow entry(DataType type, std::int64_t initial = 0) {
  return {.type = type, .access = Access::rw | Access::tpdo | Access::rpdo, .initial = initial};
}
constexpr EntryRow entry(std::uint8_t sub, DataType type, std::int64_t initial = 0) {
  return {
      .sub_first = sub, .sub_last = sub, .type = type, .access = Access::rw, .initial = initial};
}

using enum DataType;

// It consumes SYNC, TIME, the heartbeat of node 10 and the emergencies of node 2; RPDO 1 takes one
// byte, TPDO 1 sends one at each SYNC.
constexpr auto layout = partial(lay_out(
    std::to_array<ObjectRow>(
        {object(0x1000), object(0x1001), object(0x1003, 2), object(0x1005), object(0x100C),
         object(0x100D), object(0x1012), object(0x1014), object(0x1015), object(0x1016, 2),
         object(0x1017), object(0x1028, 3), object(0x1029, 2), object(0x1400, 3), object(0x1600, 2),
         object(0x1800, 3), object(0x1A00, 2), object(0x2000), object(0x2001)}),
    std::to_array<EntryRow>({entry(unsigned32, 0x0002'0191),
                             entry(unsigned8),
                             entry(unsigned8),
                             {.sub_first = 1, .sub_last = 4, .type = unsigned32},
                             entry(unsigned32, 0x80),
                             entry(unsigned16),
                             entry(unsigned8),
                             entry(unsigned32, 0x8000'0100),
                             entry(unsigned32, 0x85),
                             entry(unsigned16),
                             entry(unsigned8, 1),
                             entry(1, unsigned32, 0x000A'012C),
                             entry(unsigned16),
                             entry(unsigned8, 2),
                             entry(1, unsigned32, 0x8000'0000),
                             entry(2, unsigned32, 0x82),
                             entry(unsigned8, 1),
                             entry(1, unsigned8, 1),
                             entry(unsigned8, 2),
                             entry(1, unsigned32, 0x205),
                             entry(2, unsigned8, 255),
                             entry(unsigned8, 1),
                             entry(1, unsigned32, 0x2000'0008),
                             entry(unsigned8, 2),
                             entry(1, unsigned32, 0x185),
                             entry(2, unsigned8, 1),
                             entry(unsigned8, 1),
                             entry(1, unsigned32, 0x2001'0008),
                             entry(unsigned8),
                             entry(unsigned8)})));

/// The device, and what it sends.
class Bench {
 public:
  explicit Bench(NmtState state, NodeId node_id = 5)
      : device_({this, &Bench::take, nullptr}, node_id) {
    device_.node().start(Time{});
    if (state == NmtState::operational) receive(wire_frame("000#01 05"));
    if (state == NmtState::stopped) receive(wire_frame("000#02 05"));
    sent_.clear();
  }

  void receive(const Frame& frame) {
    device_.node().receive(frame, Time{});
    for (int i = 0; device_.node().deadline() <= Time{}; ++i) {
      ASSERT_LT(i, 100) << wire_text(frame);
      device_.node().advance(Time{});
    }
  }
  Texts take_sent() { return std::exchange(sent_, {}); }
  std::uint32_t unwanted() const { return device_.node().counters().unwanted; }

  /// Checks that it can be started, and answers. A transfer begun by a flip is aborted first: in a
  /// block download any frame is a segment.
  bool lives() {
    receive(wire_frame("000#01 05"));
    receive(wire_frame("605#80 00 00 00 00 00 00 08"));
    sent_.clear();
    receive(wire_frame("605#40 00 10 00 00 00 00 00"));
    return take_sent() == Texts({"585#43 00 10 00 91 01 02 00"});
  }

 private:
  static bool take(void* context, const Frame& frame) {
    static_cast<Bench*>(context)->sent_.push_back(wire_text(frame));
    return true;
  }

  Texts sent_;
  DeviceNode<layout> device_;
};

constexpr NmtState states[] = {NmtState::pre_operational, NmtState::operational, NmtState::stopped};

/// A CAN-ID that the node alone sends: its emergencies, TPDO 1, SDO answers and heartbeats.
bool is_own(const Frame& frame) {
  return !is_small_machine && !frame.is_remote() &&
         (frame.id == 0x085 || frame.id == 0x185 || frame.id == 0x585 || frame.id == 0x705);
}

bool wants(const Frame& frame) {
  const std::vector<std::uint32_t> remote = {0x185, 0x705};
  const std::vector<std::uint32_t> data = {0x000, 0x080, 0x082, 0x100, 0x205, 0x605, 0x70A};
  const auto& ids = frame.is_remote() ? remote : data;
  return std::ranges::find(ids, frame.id) != ids.end() || is_own(frame);
}

/// First bytes of the answer to a frame full of zeros; nothing if there is none.
std::string answer_to(const Frame& frame, NmtState state) {
  const bool stopped = state == NmtState::stopped;
  const bool operational = state == NmtState::operational;
  if (frame.is_remote() && frame.id == 0x705) {
    return stopped ? "705#04" : operational ? "705#05" : "705#7F";
  }
  if (stopped) return "";
  if (frame.is_remote()) return operational ? "185#00" : "";
  if (is_own(frame)) return "085#50 81 11 " + wire_text(frame).substr(1, 2);
  if (frame.id == 0x605 && frame.length == 8) return "585#80 00 00 00 01 00 04 05";
  if (frame.id == 0x080 && frame.length > 0) return "085#40 82 11";
  if (!operational) return "";
  if (frame.id == 0x080) return "185#00";
  if (frame.id == 0x205 && frame.length == 0) return "085#10 82 11";
  if (frame.id == 0x205 && frame.length > 1) return "085#20 82 11";
  return "";
}

Frame frame_of(std::uint32_t id, std::uint8_t length, bool remote) {
  Frame frame = Frame::data_frame(id, {});
  frame.length = length;
  if (remote) frame.flags = FrameFlags::remote;
  return frame;
}

TEST(EveryFrame, ThatIsForOthersLeavesNoTrace) {
  for (const NmtState state : states) {
    const auto sut = std::make_unique<Bench>(state);
    std::uint32_t unwanted = 0;
    for (unsigned what = 0; what < 0x800 * 9 * 2; ++what) {
      const Frame frame =
          frame_of(what / 18, static_cast<std::uint8_t>(what % 9), what / 9 % 2 != 0);
      if (wants(frame)) continue;
      sut->receive(frame);
      ASSERT_EQ(sut->unwanted(), ++unwanted) << wire_text(frame);
    }
    EXPECT_EQ(sut->take_sent(), Texts());
    EXPECT_TRUE(sut->lives());
  }
}

TEST(EveryFrame, ThatIsForTheNodeIsAnsweredAsItsServiceSays) {
  for (const NmtState state : states) {
    for (unsigned what = 0; what < 0x800 * 9 * 2; ++what) {
      const Frame frame =
          frame_of(what / 18, static_cast<std::uint8_t>(what % 9), what / 9 % 2 != 0);
      if (!wants(frame)) continue;
      SCOPED_TRACE(wire_text(frame) + " in state " + std::to_string(static_cast<int>(state)));
      const auto sut = std::make_unique<Bench>(state);
      sut->receive(frame);
      const Texts sent = sut->take_sent();
      const std::string expected = answer_to(frame, state);
      ASSERT_EQ(sent.size(), expected.empty() ? 0U : 1U);
      EXPECT_TRUE(sent.empty() || sent[0].starts_with(expected)) << sent[0];
      EXPECT_TRUE(sut->lives());
    }
  }
}

TEST(EveryFrame, IsLeftAloneByANodeWithoutANodeId) {
  const auto sut = std::make_unique<Bench>(NmtState::initialisation, node_id_unconfigured);
  for (unsigned what = 0; what < 0x800 * 9 * 2; ++what) {
    sut->receive(frame_of(what / 18, static_cast<std::uint8_t>(what % 9), what / 9 % 2 != 0));
  }
  EXPECT_EQ(sut->take_sent(), Texts());
}

constexpr std::string_view golden_frames[] = {"000#01 05",
                                              "000#82 00",
                                              "080#",
                                              "082#30 81 11 00 00 00 00 00",
                                              "100#00 2E 93 02 31 3D",
                                              "205#01",
                                              "605#40 00 10 00 00 00 00 00",
                                              "605#23 00 20 00 01 00 00 00",
                                              "705#R1",
                                              "70A#05"};

TEST(EveryFrame, WithOneBitFlippedHasAWellFormedAnswerOrNone) {
  for (const NmtState state : states) {
    for (const std::string_view golden : golden_frames) {
      for (const Frame& flip : bit_flips(wire_frame(golden))) {
        SCOPED_TRACE(wire_text(flip));
        const auto sut = std::make_unique<Bench>(state);
        sut->receive(flip);
        for (const std::string& sent : sut->take_sent()) {
          const Frame answer = wire_frame(sent);
          const bool known = (answer.id == 0x585 && answer.length == 8) ||
                             (answer.id == 0x085 && answer.length == 8) ||
                             (answer.id == 0x705 && answer.length == 1) ||
                             (answer.id == 0x185 && answer.length == 1);
          EXPECT_TRUE(known) << sent;
        }
        EXPECT_TRUE(sut->lives());
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::every_frame_test
