#include "canvoy/canopen/manager/sdo_write_list.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

void SdoWriteList::run() {
  tries_left_ = tries_max_;
  while (write_next()) {
  }
}

/// False if an answer is waited for, or all is done.
bool SdoWriteList::write_next() {
  if (position_ == size_) {
    done_({});
    return false;
  }
  const Write& write = writes_[position_];
  store(buffer_.data(), write.value);
  const auto value = std::span<const std::uint8_t>(buffer_).first(write.size);
  if (write.node == node_.id()) return step(write_here(write, value));
  --tries_left_;
  const AbortCode refused =
      client_.download(write.node, write.index, write.sub, value,
                       SdoClient::Done::to<&SdoWriteList::written>(*this), time_out_);
  return refused != AbortCode::none && step(refused);
}

AbortCode SdoWriteList::write_here(const Write& write, std::span<const std::uint8_t> value) {
  return node_.dictionary().write(write.index, write.sub, value, Source::application);
}

/// True if there is a next one to write.
bool SdoWriteList::step(SdoEnd answer) {
  const Write& write = writes_[position_];
  if (answer || write.may_fail) {
    ++position_;
    tries_left_ = tries_max_;
    return true;
  }
  done_({.end = answer, .node = write.node});
  return false;
}

void SdoWriteList::written(SdoClient::Outcome outcome) {
  const bool again = outcome.is_silence() && tries_left_ != 0;
  if (!again && !step(outcome)) return;
  while (write_next()) {
  }
}

}  // namespace canvoy
