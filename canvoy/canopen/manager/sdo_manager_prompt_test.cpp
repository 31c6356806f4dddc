// The SDO manager on a bus with immediate answers, during the request (CiA 302-5).
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/dynamic_sdo_nodes.hpp"
#include "canvoy/canopen/testing/prompt_bus.hpp"

namespace canvoy::sdo_manager_prompt_test {
namespace {

struct PromptManager : PromptBus {
  PromptManager() : PromptBus(dynamic_sdo_manager(), 1) {
    answers = [this](const Frame& frame) { return answer(frame); };
    for (const NodeId id : {NodeId{4}, NodeId{5}}) {
      sut.remote_changed(id, RemoteState::operational);
    }
    run_for(Duration::zero());
    sent.clear();
  }
  /// Nodes 4 and 5 confirm all writes; 5 requests its client 1280h by 1F10h until it is written.
  std::optional<Frame> answer(const Frame& frame) {
    if (frame.id != 0x604 && frame.id != 0x605) return std::nullopt;
    const std::uint8_t* b = frame.data.data();
    const bool is_state = load<std::uint16_t>(b + 1) == 0x1F10;
    if (b[0] != 0x40) {
      if (is_state) asks = false;
      return Frame::data_frame(frame.id - 0x80, {0x60, b[1], b[2], b[3], 0, 0, 0, 0});
    }
    if (frame.id == 0x604 || !asks) {
      return Frame::data_frame(frame.id - 0x80, {0x43, 0x10, 0x1F, 0, 0, 0, 0, 0});
    }
    return Frame::data_frame(0x585, {0x43, 0x10, 0x1F, 0, 0, 0, 0x80, 0x12});
  }

  bool asks = true;
  SdoServer servers[3] = {SdoServer(node, 0, {}), SdoServer(node, 1, {}), SdoServer(node, 2, {})};
  std::array<SdoConnection, 3> connections;
  SdoManager sut{node, connections, {}};
};

TEST(SdoManagerPromptAnswers, RegisterADevice) {
  PromptManager manager;
  manager.receive("6E0#");
  EXPECT_EQ(manager.sent, (std::vector<std::string>{
                              "604#40 10 1F 00 00 00 00 00", "605#40 10 1F 00 00 00 00 00",
                              "605#2F 80 12 03 01 00 00 00", "605#23 80 12 01 80 06 00 40",
                              "605#23 80 12 02 81 06 00 40", "605#23 10 1F 00 02 00 80 12"}));
  EXPECT_EQ(manager.connections[0].state, SdoConnection::State::given);
  EXPECT_FALSE(manager.sut.busy());
}

TEST(SdoManagerPromptAnswers, ThatAskForNothingEndTheScan) {
  PromptManager manager;
  manager.asks = false;
  manager.receive("6E0#");
  manager.run_for(10s);
  EXPECT_FALSE(manager.sut.busy());
  EXPECT_EQ(manager.sent.front(), "604#40 10 1F 00 00 00 00 00");
  EXPECT_EQ(manager.sent.back(), "67F#80 10 1F 00 00 00 04 05") << "the last one is silent";
}

}  // namespace
}  // namespace canvoy::sdo_manager_prompt_test
