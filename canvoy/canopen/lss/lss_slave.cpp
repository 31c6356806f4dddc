#include "canvoy/canopen/lss/lss_slave.hpp"

#include <iterator>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

using lss::Command;

/// One of several successive messages, each with a number that must match.
struct Step {
  enum Fit : std::uint8_t { never, equal, at_least, at_most };

  Fit fit : 2 = never;  ///< relation of the number here to that in the message
  std::uint8_t part : 2 = 0;
  bool first : 1 = false;
  bool last : 1 = false;
};

/// By command, from select_vendor on: four messages that select a slave, six that identify those
/// with revision and serial number in a range.
constexpr Step steps[] = {{Step::equal, LssAddress::vendor, true, false},
                          {Step::equal, LssAddress::product, false, false},
                          {Step::equal, LssAddress::revision, false, false},
                          {Step::equal, LssAddress::serial, false, true},
                          {},
                          {},
                          {Step::equal, LssAddress::vendor, true, false},
                          {Step::equal, LssAddress::product, false, false},
                          {Step::at_least, LssAddress::revision, false, false},
                          {Step::at_most, LssAddress::revision, false, false},
                          {Step::at_least, LssAddress::serial, false, false},
                          {Step::at_most, LssAddress::serial, false, true}};

/// Distance of a command from `first`.
constexpr std::size_t distance(Command command, Command first) {
  return static_cast<std::size_t>(command) - static_cast<std::size_t>(first);
}

bool fits(const Step& step, std::uint32_t mine, std::uint32_t asked) {
  if (mine == asked) return true;
  return step.fit == Step::at_least ? mine > asked : step.fit == Step::at_most && mine < asked;
}

}  // namespace

void LssSlave::on_event(NodeService& service, ServiceEvent& event) {
  LssSlave& self = static_cast<LssSlave&>(service);
  if (event.kind == ServiceEvent::reset) self.reset();
  if (event.kind == ServiceEvent::frame_came) self.receive(event.frame(), self.node_.now());
}

void LssSlave::listen() {
  node_.router().listen<&LssSlave::receive>(*this, 0, can_id::lss_request);
}

inline void LssSlave::reset() {
  // A constant-initialised slave could not set the acceptance filter before.
  if constexpr (is_small_machine) listen();
  started_ = true;
  storing_ = false;
  expected_ = scan_position_ = 0;
  enter(LssState::waiting);
}

inline void LssSlave::receive(const Frame& frame, Time) {
  if (!started_ || node_.transmitter().muted()) return;
  if (frame.length != lss::length) return node_.count_malformed();
  const auto command = static_cast<Command>(frame.data[0]);
  const std::uint8_t expected = std::exchange(expected_, std::uint8_t{0});
  const std::size_t position = distance(command, Command::select_vendor);
  if (position < std::size(steps) && steps[position].fit != Step::never) {
    const bool goes_on = steps[position].first || expected == frame.data[0];
    if (goes_on) match(command, load<std::uint32_t>(&frame.data[1]));
    return;
  }
  switch (command) {
    case Command::switch_global:
      return switch_global(frame.data[1]);
    case Command::identify_unconfigured:
      if (is_unconfigured()) answer(Command::unconfigured);
      return;
    case Command::fastscan:
      return fastscan(frame);
    default:
      return configure(command, frame);
  }
}

/// The services of state configuration.
[[gnu::always_inline]] inline void LssSlave::configure(Command command, const Frame& frame) {
  const std::size_t inquired = distance(command, Command::inquire_vendor);
  const bool inquires = inquired <= distance(Command::inquire_node_id, Command::inquire_vendor);
  const bool known = inquires || command == Command::configure_node_id ||
                     command == Command::configure_bit_timing ||
                     command == Command::activate_bit_timing || command == Command::store;
  if (!known) return node_.count_malformed();
  if (state_ != LssState::configuration) return;
  if (command == Command::inquire_node_id) return answer(command, node_.id());
  if (inquires) return answer(command, identity(inquired));
  if (command == Command::configure_node_id) return configure_node_id(frame.data[1]);
  if (configure_with_hooks_ != nullptr) return configure_with_hooks_(*this, command, frame);
  static_assert(LssError::out_of_range == LssError::store_unsupported);
  if (command != Command::activate_bit_timing) answer(command, LssError::out_of_range);
}

void LssSlave::configure_with_hooks(LssSlave& self, Command command, const Frame& frame) {
  if (command == Command::configure_bit_timing) {
    return self.configure_bit_timing(frame.data[1], frame.data[2]);
  }
  if (command == Command::store) return self.store_configuration();
  self.activate_bit_timing(load<std::uint16_t>(&frame.data[1]));
}

void LssSlave::enter(LssState state) {
  if (state == state_) return;
  state_ = state;
  hooks_.state_entered(state);
}

inline void LssSlave::leave_configuration() {
  if (state_ == LssState::waiting) return;
  enter(LssState::waiting);
  node_.take_first_id();
}

inline void LssSlave::switch_global(std::uint8_t wanted) {
  if (wanted == static_cast<std::uint8_t>(LssState::waiting)) return leave_configuration();
  if (wanted != static_cast<std::uint8_t>(LssState::configuration)) return node_.count_malformed();
  enter(LssState::configuration);
}

/// Another message in between, or a number that does not match, ends a sequence of messages.
[[gnu::always_inline]] inline void LssSlave::match(Command command, std::uint32_t asked) {
  const Step step = steps[distance(command, Command::select_vendor)];
  const bool selects = command <= Command::select_serial;
  if (selects && state_ != LssState::waiting) return;
  if (!fits(step, identity(step.part), asked)) return;
  if (!step.last) {
    expected_ = static_cast<std::uint8_t>(command + 1);
    return;
  }
  if (!selects) return answer(Command::identified);
  enter(LssState::configuration);
  answer(Command::selected);
}

[[gnu::always_inline]] inline void LssSlave::fastscan(const Frame& frame) {
  if (state_ != LssState::waiting || !is_unconfigured()) return;
  const std::uint8_t bit_checked = frame.data[5];
  const std::uint8_t sub = frame.data[6];
  const std::uint8_t next = frame.data[7];
  if (bit_checked == lss::FastscanRequest::anybody) {
    scan_position_ = 0;
    return answer(Command::identified);
  }
  if (sub > 3 || next > 3 || bit_checked > 31) return node_.count_malformed();
  const std::uint32_t unlike = identity(sub) ^ load<std::uint32_t>(&frame.data[1]);
  if (sub != scan_position_ || unlike >> bit_checked != 0) return;
  answer(Command::identified);
  if (bit_checked != 0) return;
  scan_position_ = next;
  if (next < sub) enter(LssState::configuration);
}

inline void LssSlave::configure_node_id(NodeId wanted) {
  const bool good = is_node_id(wanted) || wanted == node_id_unconfigured;
  if (good) node_.set_pending_id(wanted);
  answer(Command::configure_node_id, std::uint32_t{good ? LssError::none : LssError::out_of_range});
}

void LssSlave::configure_bit_timing(std::uint8_t table, std::uint8_t index) {
  const bool known = table == 0 && lss_bit_timing::is_index(index);
  LssError error{.code = LssError::out_of_range};
  if (known && hooks_.configure_bit_timing) error = hooks_.configure_bit_timing(index);
  if (error.ok()) bit_timing_ = index;
  answer(Command::configure_bit_timing, error);
}

/// If none was configured and the present one is unknown, there is no bit timing to switch to.
void LssSlave::activate_bit_timing(std::uint16_t milliseconds) {
  if (bit_timing_ == lss_bit_timing::unknown) return;
  hooks_.activate_bit_timing(bit_timing_, from_milliseconds(milliseconds));
}

inline void LssSlave::store_configuration() {
  if (!hooks_.store) {
    return answer(Command::store, LssError{.code = LssError::store_unsupported});
  }
  if (stored_id_ != 0) return;
  storing_ = true;
  stored_id_ = node_.pending_id();
  hooks_.store(stored_id_, bit_timing_);
}

void LssSlave::stored(LssError error) {
  if (stored_id_ == 0) return;
  if (error.ok()) node_.set_power_on_id(stored_id_);
  stored_id_ = 0;
  if (!storing_) return;
  storing_ = false;
  answer(Command::store, error);
}

/// True without node-ID, and without a pending one.
bool LssSlave::is_unconfigured() const {
  return !is_node_id(node_.id()) && !is_node_id(node_.pending_id());
}

std::uint32_t LssSlave::identity(std::size_t part) const {
  return node_.dictionary().word(object_index::identity, static_cast<std::uint8_t>(part + 1));
}

void LssSlave::answer(Command command, std::uint32_t value) {
  const std::uint64_t message = static_cast<std::uint8_t>(command) | std::uint64_t{value} << 8;
  node_.transmitter().send(can_id::lss_response,
                           {reinterpret_cast<const std::uint8_t*>(&message), lss::length});
}

void LssSlave::answer(Command command, LssError error) {
  answer(command, std::uint32_t{error.code} | std::uint32_t{error.specific} << 8);
}

}  // namespace canvoy
