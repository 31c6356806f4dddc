#include "canvoy/canopen/lss/lss_slave.hpp"

namespace canvoy {

namespace {

using lss::Command;

constexpr std::uint16_t identity_index = 0x1018;

/// Messages that come in a row, each of which holds one number.
constexpr std::size_t select_steps = 4;
constexpr std::size_t identify_steps = 6;

/// Whether `command` is one of `count` from `first` on, and which.
constexpr bool is_among(Command command, Command first, std::size_t count, std::size_t& position) {
  position = static_cast<std::size_t>(command) - static_cast<std::size_t>(first);
  return command >= first && position < count;
}

}  // namespace

constexpr ServiceCalls LssSlave::service_calls = {.reset = method<&LssSlave::reset>};

LssSlave::LssSlave(Node& node, const LssSlaveHooks& hooks, std::uint8_t bit_timing)
    : node_(node), hooks_(hooks), bit_timing_(bit_timing) {
  node_.attach(service_);
  node_.router().add(can_id::lss_request, Router::Receiver::to<&LssSlave::receive>(*this));
}

void LssSlave::reset(ResetScope) {
  started_ = true;
  storing_ = false;
  expected_ = scan_position_ = 0;
  enter(LssState::waiting);
}

void LssSlave::receive(const Frame& frame, Time) {
  if (!started_ || node_.transmitter().muted()) return;
  if (frame.length != lss::length) return node_.count_malformed();
  const auto command = static_cast<Command>(frame.data[0]);
  const auto value = load<std::uint32_t>(&frame.data[1]);
  std::size_t step = 0;
  if (is_among(command, Command::select_vendor, select_steps, step)) return select(step, value);
  if (is_among(command, Command::identify_vendor, identify_steps, step)) {
    return identify(step, value);
  }
  expected_ = 0;
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
void LssSlave::configure(Command command, const Frame& frame) {
  const bool here = state_ == LssState::configuration;
  switch (command) {
    case Command::configure_node_id:
      return here ? configure_node_id(frame.data[1]) : void();
    case Command::configure_bit_timing:
      return here ? configure_bit_timing(frame.data[1], frame.data[2]) : void();
    case Command::activate_bit_timing:
      return here ? activate_bit_timing(load<std::uint16_t>(&frame.data[1])) : void();
    case Command::store:
      return here ? store_configuration() : void();
    case Command::inquire_vendor:
    case Command::inquire_product:
    case Command::inquire_revision:
    case Command::inquire_serial:
      return here ? answer(command, identity(static_cast<std::size_t>(command) -
                                             static_cast<std::size_t>(Command::inquire_vendor)))
                  : void();
    case Command::inquire_node_id:
      return here ? answer(command, node_.id()) : void();
    default:
      return node_.count_malformed();
  }
}

void LssSlave::enter(LssState state) {
  if (state == state_) return;
  state_ = state;
  hooks_.state_entered(state);
}

void LssSlave::leave_configuration() {
  if (state_ == LssState::waiting) return;
  enter(LssState::waiting);
  node_.take_first_id();
}

void LssSlave::switch_global(std::uint8_t wanted) {
  if (wanted == static_cast<std::uint8_t>(LssState::waiting)) return leave_configuration();
  if (wanted != static_cast<std::uint8_t>(LssState::configuration)) return node_.count_malformed();
  enter(LssState::configuration);
}

/// Four messages in their order; another one in between, or a number that does not fit, ends it.
void LssSlave::select(std::size_t part, std::uint32_t value) {
  const Command own = Command::select_vendor + part;
  const bool goes_on = part == 0 || expected_ == static_cast<std::uint8_t>(own);
  expected_ = 0;
  if (state_ != LssState::waiting || !goes_on || value != identity(part)) return;
  if (part + 1 < select_steps) {
    expected_ = static_cast<std::uint8_t>(own + 1);
    return;
  }
  enter(LssState::configuration);
  answer(Command::selected);
}

/// Six messages in their order: vendor-ID and product code, then the ranges in which revision and
/// serial number have to be.
void LssSlave::identify(std::size_t step, std::uint32_t value) {
  static constexpr std::array<std::uint8_t, identify_steps> parts = {
      LssAddress::vendor,   LssAddress::product, LssAddress::revision,
      LssAddress::revision, LssAddress::serial,  LssAddress::serial};
  const Command own = Command::identify_vendor + step;
  const bool goes_on = step == 0 || expected_ == static_cast<std::uint8_t>(own);
  expected_ = 0;
  const std::uint32_t mine = identity(parts[step]);
  const bool fits = step < 2 ? value == mine : step % 2 == 0 ? value <= mine : value >= mine;
  if (!goes_on || !fits) return;
  if (step + 1 < identify_steps) {
    expected_ = static_cast<std::uint8_t>(own + 1);
    return;
  }
  answer(Command::identified);
}

void LssSlave::fastscan(const Frame& frame) {
  const lss::FastscanRequest request{.id_number = load<std::uint32_t>(&frame.data[1]),
                                     .bit_checked = frame.data[5],
                                     .sub = frame.data[6],
                                     .next = frame.data[7]};
  if (state_ != LssState::waiting || !is_unconfigured()) return;
  if (request.bit_checked == lss::FastscanRequest::anybody) {
    scan_position_ = 0;
    return answer(Command::identified);
  }
  if (!request.valid()) return node_.count_malformed();
  const std::uint32_t unlike = identity(request.sub) ^ request.id_number;
  if (request.sub != scan_position_ || unlike >> request.bit_checked != 0) return;
  answer(Command::identified);
  if (request.bit_checked != 0) return;
  scan_position_ = request.next;
  if (request.next < request.sub) enter(LssState::configuration);
}

void LssSlave::configure_node_id(NodeId wanted) {
  const bool good = is_node_id(wanted) || wanted == node_id_unconfigured;
  if (good) node_.set_pending_id(wanted);
  answer(Command::configure_node_id,
         LssError{.code = good ? LssError::none : LssError::out_of_range});
}

void LssSlave::configure_bit_timing(std::uint8_t table, std::uint8_t index) {
  const bool known =
      table == 0 && (lss_bit_timing::bit_rate(index) != 0 || index == lss_bit_timing::automatic);
  LssError error{.code = LssError::out_of_range};
  if (known && hooks_.configure_bit_timing) error = hooks_.configure_bit_timing(index);
  if (error.ok()) bit_timing_ = index;
  answer(Command::configure_bit_timing, error);
}

/// Where none was configured and the present one is not known, there is none to switch to.
void LssSlave::activate_bit_timing(std::uint16_t milliseconds) {
  if (bit_timing_ == lss_bit_timing::unknown) return;
  hooks_.activate_bit_timing(bit_timing_, std::chrono::milliseconds(milliseconds));
}

void LssSlave::store_configuration() {
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

/// Without node-ID, and without one to come.
bool LssSlave::is_unconfigured() const {
  return !is_node_id(node_.id()) && !is_node_id(node_.pending_id());
}

std::uint32_t LssSlave::identity(std::size_t part) const {
  return static_cast<std::uint32_t>(
      node_.dictionary().number(identity_index, static_cast<std::uint8_t>(part + 1)));
}

void LssSlave::answer(Command command, std::uint32_t value) {
  node_.transmitter().send(lss::frame(can_id::lss_response, command, value));
}

void LssSlave::answer(Command command, LssError error) {
  answer(command, std::uint32_t{error.code} | std::uint32_t{error.specific} << 8);
}

}  // namespace canvoy
