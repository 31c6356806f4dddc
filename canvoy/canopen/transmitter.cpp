#include "canvoy/canopen/transmitter.hpp"

namespace canvoy {

bool Transmitter::keep(const Frame& frame) {
  if (muted_) return true;
  if (size_ == backlog_.size()) {
    ++lost_;
    return false;
  }
  backlog_[(first_ + size_) % backlog_.size()] = frame;
  ++size_;
  return true;
}

void Transmitter::flush() {
  while (size_ > 0 && port_.send(port_.context, backlog_[first_])) {
    first_ = (first_ + 1) % backlog_.size();
    --size_;
  }
}

}  // namespace canvoy
