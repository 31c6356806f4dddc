// Arbitrary frames at arbitrary times on both buses of a node with devices behind it. For any
// input, only SDO frames to the indicated device leave on the bus behind, and at the end a transfer
// with a device and one with the node itself get the right answers.
#include <algorithm>
#include <array>
#include <cstdint>

#include "canvoy/canopen/remote/remote_access.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy {
namespace {

using fuzz::require;

constexpr NodeId module_id = 5;
constexpr NodeId device_id = 7;

class RemoteTarget {
 public:
  RemoteTarget() { access_.start(now_); }

  void from_host(const Frame& frame) {
    access_.receive(frame, now_);
    settle();
  }
  void from_behind(const Frame& frame) {
    access_.receive_embedded(frame, now_);
    settle();
  }
  void wait(Duration duration) {
    const Time until = now_ + duration;
    while (access_.deadline() <= until) {
      now_ = std::max(now_, access_.deadline());
      access_.advance(now_);
    }
    now_ = until;
  }
  void take_nothing_behind(bool is_full) { is_full_ = is_full; }

  /// The state to which everything must return.
  void finish() {
    is_full_ = false;
    from_host(Frame::data_frame(0x000, {0x01, module_id}));
    wait(10s);
    // One indication may still be used up by the next request.
    ask_node();
    ask_node();
    require(last_ == Frame::data_frame(0x585, {0x43, 0x00, 0x10, 0, 0xA2, 0x01, 0x02, 0x00}));
    const Frame indication = Frame::data_frame(0x605, {0xE0, 2, 0, device_id, 0, 0, 0, 0});
    from_host(indication);
    require(last_.id == 0x585 && last_.data == indication.data);
    from_host(Frame::data_frame(0x605, {0x40, 0x01, 0x64, 0x01, 0, 0, 0, 0}));
    require(behind_ == Frame::data_frame(0x607, {0x40, 0x01, 0x64, 0x01, 0, 0, 0, 0}));
    from_behind(Frame::data_frame(0x587, {0x4B, 0x01, 0x64, 0x01, 0x34, 0x12, 0, 0}));
    require(last_ == Frame::data_frame(0x585, {0x4B, 0x01, 0x64, 0x01, 0x34, 0x12, 0, 0}));
  }

 private:
  void settle() {
    while (access_.deadline() <= now_) access_.advance(now_);
  }
  void ask_node() { from_host(Frame::data_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0})); }
  static bool send(void* context, const Frame& frame) {
    static_cast<RemoteTarget*>(context)->last_ = frame;
    return true;
  }
  static bool send_behind(void* context, const Frame& frame) {
    auto& self = *static_cast<RemoteTarget*>(context);
    require(frame.is_plain() && frame.length == Frame::length_max);
    require(frame.id > can_id::sdo_request && frame.id <= can_id::sdo_request + node_id_max);
    if (self.is_full_) return false;
    self.behind_ = frame;
    return true;
  }

  DictionaryTables tables_ = sdo_objects();
  std::array<std::uint8_t, 4096> values_{};
  std::array<ObjectState, 256> states_{};
  std::array<Router::Route, 64> routes_{};
  std::array<Frame, 16> backlog_{};
  std::array<std::uint8_t, 64> buffer_{};
  Time now_{};
  Frame last_{};
  Frame behind_{};
  bool is_full_ = false;
  Node node_{tables_, {values_, states_, routes_, backlog_}, {this, &send, nullptr}, module_id};
  SdoServer server_{node_, 0, buffer_};
  std::array<RemoteChannel, 2> channels_{RemoteChannel(), RemoteChannel(SdoChannel{0x615, 0x595})};
  RemoteAccess access_{
      node_, {this, &send_behind, nullptr}, channels_, {.network = 2, .emergency_cob_id = 0x6C7}};
};

/// A frame, usually a meaningful one.
Frame any_frame(fuzz::Input& input, std::uint8_t what) {
  constexpr std::uint32_t ids[] = {0x605, 0x615, 0x587, 0x588, 0x087, 0x707, 0x000, 0x583};
  Frame frame;
  frame.id = what % 16 < 8 ? ids[what % 8] : input.word() & Frame::id_max;
  frame.length = Frame::length_max;
  input.fill(frame.data);
  if (what % 32 == 31) frame.length = input.byte() % 9;
  return frame;
}

}  // namespace
}  // namespace canvoy

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy;
  fuzz::Input input(data, size);
  RemoteTarget target;
  while (!input.empty()) {
    const std::uint8_t what = input.byte();
    switch (what / 64) {
      case 0:
        target.from_host(any_frame(input, what));
        break;
      case 1:
        target.from_behind(any_frame(input, what));
        break;
      case 2:
        target.wait(Duration(1ms) * (what % 64) * 20);
        break;
      default:
        target.take_nothing_behind(what % 2 != 0);
    }
  }
  target.finish();
  return 0;
}
