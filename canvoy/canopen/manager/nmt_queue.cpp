#include "canvoy/canopen/manager/nmt_queue.hpp"

#include <algorithm>

#include "canvoy/canopen/manager/nmt_startup.hpp"

namespace canvoy {

constexpr ServiceHandlers NmtQueue::service_calls = {.reset = method<&NmtQueue::reset>,
                                                     .tx_ready = method<&NmtQueue::tx_ready>};

NmtQueue::NmtQueue(Node& node, std::span<Request> memory)
    : node_(node), memory_(memory), timer_(callback<&NmtQueue::send_due>(*this)) {
  node_.attach(service_);
}

bool NmtQueue::add(Request request) {
  if (size_ == memory_.size() || request.node > node_id_max) return false;
  memory_[(first_ + size_) % memory_.size()] = request;
  ++size_;
  if (size_ == 1) node_.timers().arm(timer_, std::max(inhibited_until_, node_.now()));
  return true;
}

void NmtQueue::reset(ResetScope) {
  size_ = 0;
  node_.timers().disarm(timer_);
}

void NmtQueue::tx_ready() {
  if (size_ != 0) node_.timers().arm(timer_, std::max(inhibited_until_, node_.now()));
}

/// While the backlog is full, tx_ready() continues. An NMT reset of this node clears the queue.
void NmtQueue::send_due(Time now) {
  while (size_ != 0) {
    if (now < inhibited_until_) return node_.timers().arm(timer_, inhibited_until_);
    const Request request = memory_[first_];
    const bool has_frame = request.node != node_.id();
    if (has_frame && node_.transmitter().full()) return;
    // Removed first: an answer to the frame may come at once, and reset this node.
    first_ = (first_ + 1) % memory_.size();
    --size_;
    if (has_frame) send(request);
    sent_(request);
    const bool means_all = request.node == all_nodes && !request.spares_master;
    if (means_all || request.node == node_.id()) node_.command(request.command);
  }
}

void NmtQueue::send(const Request& request) {
  node_.transmitter().send(
      Frame::data_frame(can_id::nmt, {static_cast<std::uint8_t>(request.command), request.node}));
  const auto inhibit = node_.dictionary().number(master_object::nmt_inhibit_time, 0);
  inhibited_until_ = node_.now() + std::chrono::microseconds(inhibit * 100);
}

}  // namespace canvoy
