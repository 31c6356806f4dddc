#include "canvoy/decoder/lss_follower.hpp"

#include <algorithm>

namespace canvoy::decoder {

namespace {

using lss::Command;

std::uint32_t number_in(const Frame& frame) {
  return load<std::uint32_t>(&frame.data[1]);
}

/// Position of the command in the four consecutive commands from `first` on; `Identity::count` or
/// more: none.
std::size_t position_in(Command first, Command command) {
  return static_cast<std::size_t>(command) - static_cast<std::size_t>(first);
}

}  // namespace

const LssFollower::Device* LssFollower::take(const Frame& frame) {
  return frame.id == can_id::lss_request ? request(frame) : response(frame);
}

const LssFollower::Device* LssFollower::request(const Frame& frame) {
  asked_ = static_cast<Command>(frame.data[0]);
  answers_ = 0;
  if (asked_ == Command::switch_global) {
    selected_ = {};
    asked_for_ = {};
  }
  if (asked_ == Command::configure_node_id) wanted_node_ = frame.data[1];
  if (asked_ == Command::fastscan) scan(frame);
  const std::size_t part = position_in(Command::select_vendor, asked_);
  if (part < Identity::count) asked_for_.set(part, number_in(frame));
  return nullptr;
}

void LssFollower::scan(const Frame& frame) {
  scan_ = {.id_number = number_in(frame),
           .bit_checked = frame.data[5],
           .sub = frame.data[6],
           .next = frame.data[7]};
  if (scan_.bit_checked == lss::FastscanRequest::anybody) found_ = {};
}

const LssFollower::Device* LssFollower::response(const Frame& frame) {
  answers_ = static_cast<std::uint8_t>(std::min(answers_ + 1, 2));
  const auto command = static_cast<Command>(frame.data[0]);
  if (command == Command::selected) {
    selected_ = {.identity = asked_for_};
    return &selected_;
  }
  if (command == Command::identified && asked_ == Command::fastscan) return scanned();
  if (command != asked_) return nullptr;
  if (command == Command::configure_node_id) return configured(frame);
  if (command == Command::store) return &selected_;
  if (command == Command::inquire_node_id) {
    selected_.node = is_node_id(frame.data[1]) && answers_ == 1 ? frame.data[1] : NodeId{0};
    return &selected_;
  }
  const std::size_t part = position_in(Command::inquire_vendor, command);
  return part < Identity::count ? inquired(part, number_in(frame)) : nullptr;
}

/// The last request of each part contains the whole number, and goes on to the next part; that of
/// the last part goes back, which selects the device.
const LssFollower::Device* LssFollower::scanned() {
  const bool is_confirmed = scan_.valid() && scan_.bit_checked == 0 && scan_.next != scan_.sub;
  if (!is_confirmed) return nullptr;
  found_.set(scan_.sub, scan_.id_number);
  if (scan_.next > scan_.sub) return nullptr;
  selected_ = {.identity = found_};
  return &selected_;
}

const LssFollower::Device* LssFollower::configured(const Frame& frame) {
  const bool is_done = frame.data[1] == LssError::none;
  if (!is_done) return nullptr;
  selected_.node = is_node_id(wanted_node_) ? wanted_node_ : NodeId{0};
  return &selected_;
}

/// If several devices answer, the number cannot be attributed.
const LssFollower::Device* LssFollower::inquired(std::size_t part, std::uint32_t value) {
  if (answers_ > 1) {
    selected_.identity.forget(part);
    return nullptr;
  }
  selected_.identity.set(part, value);
  return &selected_;
}

}  // namespace canvoy::decoder
