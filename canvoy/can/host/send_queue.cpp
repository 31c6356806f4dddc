#include "canvoy/can/host/send_queue.hpp"

namespace canvoy::host {

void EchoQueue::push(const SentFrame& sent) {
  if (queue_.full()) queue_.pop();
  queue_.push({sent.frame, sent.sender, 0});
}

std::optional<const void*> EchoQueue::take(const Frame& frame) {
  std::size_t position = 0;
  while (position < queue_.size() && queue_[position].frame != frame) ++position;
  if (position == queue_.size()) return std::nullopt;
  const void* sender = queue_[position].sender;
  for (; position > 0; --position) {
    queue_[position] = queue_[position - 1];
    ++queue_[position].overtakings;
  }
  queue_.pop();
  while (!queue_.empty() && queue_[0].overtakings >= overtakings_max) queue_.pop();
  return sender;
}

}  // namespace canvoy::host
