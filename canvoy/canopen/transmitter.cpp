#include "canvoy/canopen/transmitter.hpp"

namespace canvoy {

bool Transmitter::keep(const Frame& frame) {
  if (muted_) return true;
  if (size_ == backlog_.size()) {
    ++lost_;
    return false;
  }
  backlog_[place(first_ + size_)] = frame;
  ++size_;
  return true;
}

void Transmitter::flush() {
  while (size_ > 0 && port_.send(port_.context, backlog_[first_])) {
    first_ = place(first_ + 1);
    --size_;
  }
}

}  // namespace canvoy
