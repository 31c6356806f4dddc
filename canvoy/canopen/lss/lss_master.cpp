#include "canvoy/canopen/lss/lss_master.hpp"

#include <algorithm>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

namespace {

using lss::Command;

constexpr bool is_configuration(Command command) {
  return command == Command::configure_node_id || command == Command::configure_bit_timing ||
         command == Command::store;
}

}  // namespace

LssMaster::LssMaster(Node& node) : node_(node), timer_(callback<&LssMaster::expired>(*this)) {
  node_.router().add(can_id::lss_response, Router::Receiver::to<&LssMaster::receive>(*this));
}

void LssMaster::cancel() {
  busy_ = false;
  node_.timers().disarm(timer_);
}

bool LssMaster::switch_global(LssState state) {
  return send(Command::switch_global, static_cast<std::uint32_t>(state));
}

bool LssMaster::activate_bit_timing(Duration delay) {
  constexpr std::int64_t delay_max = 0xFFFF;
  const std::int64_t milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(delay).count();
  return send(Command::activate_bit_timing,
              static_cast<std::uint32_t>(std::clamp<std::int64_t>(milliseconds, 0, delay_max)));
}

bool LssMaster::select(const LssAddress& address, Done done) {
  if (busy_) return false;
  constexpr std::size_t last = LssAddress::serial;
  for (std::size_t part = 0; part < last; ++part) {
    if (!send(Command::select_vendor + part, address.parts[part])) return false;
  }
  return ask(Command::select_vendor + last, address.parts[last], Command::selected, done);
}

bool LssMaster::configure_node_id(NodeId id, Done done) {
  return ask(Command::configure_node_id, id, Command::configure_node_id, done);
}

bool LssMaster::configure_bit_timing(std::uint8_t index, Done done, std::uint8_t table) {
  return ask(Command::configure_bit_timing, table | std::uint32_t{index} << 8,
             Command::configure_bit_timing, done);
}

bool LssMaster::store(Done done) {
  return ask(Command::store, 0, Command::store, done);
}

bool LssMaster::inquire(std::size_t part, Done done) {
  const Command command = Command::inquire_vendor + std::min(part, LssAddress::serial);
  return ask(command, 0, command, done);
}

bool LssMaster::inquire_node_id(Done done) {
  return ask(Command::inquire_node_id, 0, Command::inquire_node_id, done);
}

bool LssMaster::identify(const LssRange& range, Done done) {
  if (busy_) return false;
  const auto& low = range.low.parts;
  const auto& high = range.high.parts;
  const std::uint32_t values[] = {low[0], low[1], low[2], high[2], low[3]};
  std::size_t step = 0;
  for (const std::uint32_t value : values) {
    if (!send(Command::identify_vendor + step++, value)) return false;
  }
  return ask(Command::identify_vendor + step, high[3], Command::identified, done);
}

bool LssMaster::identify_unconfigured(Done done) {
  return ask(Command::identify_unconfigured, 0, Command::unconfigured, done);
}

bool LssMaster::fastscan(const lss::FastscanRequest& request, Duration time_out, Duration settle,
                         Done done) {
  if (busy_) return false;
  Frame frame = lss::frame(can_id::lss_request, Command::fastscan, request.id_number);
  frame.data[5] = request.bit_checked;
  frame.data[6] = request.sub;
  frame.data[7] = request.next;
  return ask(frame, Command::identified, time_out, settle, done);
}

bool LssMaster::send(Command command, std::uint32_t value) {
  return send(lss::frame(can_id::lss_request, command, value));
}

bool LssMaster::ask(Command command, std::uint32_t value, Command answer, Done done) {
  if (busy_) return false;
  return ask(lss::frame(can_id::lss_request, command, value), answer, time_out_, {}, done);
}

/// The answer is expected before the frame leaves: it may arrive during send().
bool LssMaster::ask(const Frame& frame, Command answer, Duration time_out, Duration settle,
                    Done done) {
  wait(answer, time_out, settle, done);
  if (send(frame)) return true;
  cancel();
  return false;
}

void LssMaster::wait(Command answer, Duration time_out, Duration settle, Done done) {
  busy_ = true;
  expected_ = answer;
  settle_ = settle;
  done_ = done;
  reply_ = {};
  sent_at_ = node_.now();
  node_.timers().arm(timer_, sent_at_ + time_out);
}

void LssMaster::receive(const Frame& frame, Time now) {
  if (frame.length != lss::length) return node_.count_malformed();
  // An unexpected answer was late.
  if (!busy_ || frame.data[0] != static_cast<std::uint8_t>(expected_)) return;
  if (reply_.answers < 0xFF) ++reply_.answers;
  reply_.last_answer = now - sent_at_;
  if (reply_.answers == 1) {
    reply_.first_answer = reply_.last_answer;
    node_.timers().arm(timer_, std::min(timer_.at(), now + settle_));
  }
  if (settle_ > Duration::zero()) return;
  if (!is_configuration(expected_)) {
    reply_.value = load<std::uint32_t>(&frame.data[1]);
    return finish(Outcome::answered);
  }
  reply_.error = {.code = frame.data[1], .specific = frame.data[2]};
  finish(reply_.error.ok() ? Outcome::answered : Outcome::refused);
}

void LssMaster::expired(Time) {
  finish(reply_.answers > 0 ? Outcome::answered : Outcome::time_out);
}

void LssMaster::finish(Outcome outcome) {
  check_invariant(busy_);
  cancel();
  reply_.outcome = outcome;
  const Reply reply = reply_;
  done_(reply);
}

}  // namespace canvoy
