// An SDO client, an SDO server, and a line between them that loses, repeats and swaps frames as the
// test requires.
//
// For tests only.
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

/// Fate of one frame on the line.
enum class Fate : std::uint8_t { arrives, is_lost, comes_twice, is_overtaken };

/// Node 1 with a client, node 5 with a server, and a line between them. Frames arrive in the order
/// in which they were sent, except overtaken ones, which wait for the next frame.
class Line {
 public:
  /// Makes a line. Values that do not fit into one frame use segments, unless the test chooses
  /// otherwise.
  explicit Line(std::uint8_t block_size = sdo::block_size_max)
      : client_blocks(client, supplied, block_size), server_blocks(server, block_size) {
    client.choose(SdoTransfer::segmented);
    client_node.on_sent = [this](const Frame&) { take_room(client_node, client_room_); };
    server_node.on_sent = [this](const Frame&) { take_room(server_node, server_room_); };
    client_node.boot();
    server_node.boot();
  }

  /// Transfers frames and advances time until the client has its outcome, and then until nothing is
  /// left to happen.
  void run(const std::vector<Fate>& fates = {}) {
    next_fate_ = 0;
    next_step_ = 0;
    for (;;) {
      const bool is_full = make_room();
      if (!carry(fates) && !is_full && !wait()) return;
    }
  }
  void done(SdoClient::Outcome result) { outcome = result; }
  SdoClient::Done on_done() { return SdoClient::Done::to<&Line::done>(*this); }

  WireNode client_node{sdo_objects(), 1};
  WireNode server_node{sdo_objects(), 5};
  SdoClient client{client_node.node};
  /// On the heap, where the sanitizers detect a read outside of it.
  std::vector<std::uint8_t> supplied = std::vector<std::uint8_t>(SdoBlockClient::buffer_size);
  SdoBlockClient client_blocks;
  std::array<std::uint8_t, 5000> buffer{};
  SdoServer server{server_node.node, 0, buffer};
  SdoBlockServer server_blocks;
  MemoryDomain domain{server_node.node, 0x2030};
  std::optional<SdoClient::Outcome> outcome;
  std::size_t frames = 0;
  bool repeats_acknowledgements = false;  ///< of blocks, for every frame
  bool copies_acknowledgements = true;    ///< of blocks, for frames that come twice
  /// Number of frames that each controller takes, step by step; at last it takes all.
  std::deque<std::uint8_t> room;

 private:
  static constexpr unsigned much_room = 0xFFFF;

  /// True if the controllers may be full in this step. No time passes then: they are not full for
  /// long.
  bool make_room() {
    const bool is_limited = next_step_ < room.size();
    client_room_ = server_room_ = is_limited ? room[next_step_++] : much_room;
    for (auto [side, left] :
         {std::pair(&client_node, &client_room_), {&server_node, &server_room_}}) {
      const bool was_full = std::exchange(side->full, *left == 0);
      if (was_full && !side->full) side->node.tx_ready(side->now);
    }
    return is_limited;
  }

  static void take_room(WireNode& side, unsigned& left) {
    if (left != 0 && --left == 0) side.full = true;
  }

  bool carry(const std::vector<Fate>& fates) {
    bool moved = move(client_node, to_server_, fates);
    moved = move(server_node, to_client_, fates) || moved;
    moved = deliver(to_server_, server_node) || moved;
    return deliver(to_client_, client_node) || moved;
  }

  bool move(WireNode& from, std::deque<Frame>& queue, const std::vector<Fate>& fates) {
    const bool moved = !from.sent.empty();
    for (const auto& sent : from.sent) {
      ++frames;
      const Fate fate = next_fate_ < fates.size() ? fates[next_fate_++] : Fate::arrives;
      if (fate == Fate::is_lost) continue;
      queue.push_back(sent.frame);
      const bool is_acknowledgement = sent.frame.data[0] == 0xA2;
      const bool comes_twice =
          fate == Fate::comes_twice && (copies_acknowledgements || !is_acknowledgement);
      const bool is_repeated = repeats_acknowledgements && is_acknowledgement;
      if (comes_twice || is_repeated) queue.push_back(sent.frame);
      if (fate == Fate::is_overtaken && queue.size() > 1)
        std::swap(*queue.rbegin(), *++queue.rbegin());
    }
    from.sent.clear();
    return moved;
  }

  static bool deliver(std::deque<Frame>& queue, WireNode& to) {
    if (queue.empty()) return false;
    const Frame frame = queue.front();
    queue.pop_front();
    to.node.receive(frame, to.now);
    to.settle();
    return true;
  }

  bool wait() {
    const Time next = std::min(client_node.node.deadline(), server_node.node.deadline());
    if (next == never) return false;
    client_node.run_until(next);
    server_node.run_until(next);
    return true;
  }

  std::deque<Frame> to_server_;
  std::deque<Frame> to_client_;
  std::size_t next_fate_ = 0;
  std::size_t next_step_ = 0;
  unsigned client_room_ = much_room;
  unsigned server_room_ = much_room;
};

}  // namespace canvoy
