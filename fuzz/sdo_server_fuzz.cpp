// Arbitrary frames at arbitrary times to a node with three SDO channels, one of them of a client,
// in segments and in blocks. For any input, the node continues: a final upload of 1000h gets the
// right answer.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy {
namespace {

using fuzz::require;

/// A node, and a client in it with requests from the input.
class Target {
 public:
  Target() {
    domain_.refused_from = 1000;
    node_.start(now_);
  }

  void wait(Duration duration) {
    const Time until = now_ + duration;
    while (node_.deadline() <= until) {
      now_ = std::max(now_, node_.deadline());
      node_.advance(now_);
    }
    now_ = until;
  }
  void receive(const Frame& frame) {
    node_.receive(frame, now_);
    while (node_.deadline() <= now_) node_.advance(now_);
  }
  void ask(std::uint8_t what) {
    const auto size = std::size_t{what} % destination_.size();
    const auto done = SdoClient::Done::to<&Target::done>(*this);
    client_.choose(static_cast<SdoTransfer>(what / 64 % 3));
    const AbortCode answer =
        what % 2 == 0 ? client_.upload(7, 0x2021, 0, std::span(destination_).first(size), done)
                      : client_.download(7, 0x2021, 0, std::span(destination_).first(size), done);
    if (answer == AbortCode::none) ++started_;
  }
  /// The state to which everything must return.
  void finish() {
    receive(Frame::data_frame(0x000, {0x01, 0x05}));
    wait(10s);
    require(!server_.busy() && !second_.busy() && !client_.busy());
    require(!domain_.open);
    require(started_ == ended_);
    last_ = {};
    receive(Frame::data_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
    require(last_ == Frame::data_frame(0x585, {0x43, 0x00, 0x10, 0, 0xA2, 0x01, 0x02, 0x00}));
  }

 private:
  static bool take(void* context, const Frame& frame) {
    require(frame.is_plain() && frame.id <= Frame::id_max && frame.length <= 8);
    static_cast<Target*>(context)->last_ = frame;
    return true;
  }
  void done(SdoClient::Outcome outcome) {
    require(!outcome || *outcome <= destination_.size());
    ++ended_;
  }

  NodeMemory memory() { return {values_, states_, routes_, backlog_}; }

  Time now_{};
  Frame last_;
  std::vector<std::uint8_t> values_ = std::vector<std::uint8_t>(sdo_objects().value_bytes);
  std::vector<ObjectState> states_ = std::vector<ObjectState>(sdo_objects().objects.size());
  std::array<Router::Route, 8> routes_;
  std::array<Frame, 4> backlog_;
  Node node_{sdo_objects(), memory(), {this, &Target::take, nullptr}, 5};
  std::array<std::uint8_t, 100> buffer_{};
  SdoServer server_{node_, 0, buffer_};
  SdoBlockServer blocks_{server_, 9};
  SdoServer second_{node_, 1, {}};
  SdoClient client_{node_};
  SdoBlockClient client_blocks_{client_, {}, 5};
  MemoryDomain domain_{node_, 0x2030};
  std::array<std::uint8_t, 64> destination_{};
  int started_ = 0;
  int ended_ = 0;
};

Frame frame_from(fuzz::Input& input, std::uint32_t id, std::uint8_t length) {
  std::array<std::uint8_t, 8> data{};
  input.fill(std::span(data).first(length));
  return Frame::data_frame(id, std::span(data).first(length));
}

void run(fuzz::Input input) {
  Target target;
  while (!input.empty()) {
    const std::uint8_t what = input.byte();
    switch (what % 8) {
      case 0:
        target.wait(Duration(std::int64_t{1} << (what >> 3)));  // up to half an hour
        break;
      case 1:
        target.ask(input.byte());
        break;
      case 2:  // any frame at all
        target.receive(frame_from(input, input.word(), what >> 3 & 7));
        break;
      case 3:
        target.receive(Frame::data_frame(0x000, {input.byte(), 0x05}));
        break;
      case 4:
        target.receive(frame_from(input, 0x6C0, 8));
        break;
      case 5:
        target.receive(frame_from(input, 0x587, 8));
        break;
      default:
        target.receive(frame_from(input, 0x605, 8));
    }
  }
  target.finish();
}

}  // namespace
}  // namespace canvoy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::run(canvoy::fuzz::Input(data, size));
  return 0;
}
