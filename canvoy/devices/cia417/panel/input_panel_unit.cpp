#include "canvoy/devices/cia417/panel/input_panel_unit.hpp"

#include <algorithm>

#include "canvoy/canopen/pdo/pdo_parameter.hpp"

namespace canvoy::cia417 {

namespace {

constexpr unsigned request_bits = 0x03;

/// A change in the queue: the input in the upper bytes, its state in the lowest.
constexpr std::uint32_t change(std::uint32_t number, CallRequest request) {
  return number << 8 | static_cast<std::uint32_t>(request);
}

}  // namespace

constexpr AccessHandlers InputPanelUnit::parameter_hook = {
    .first = input_parameter_1_object.index,
    .last = input_parameter_4_object.index - 1,
    .before_write = method<&InputPanelUnit::before_parameter_write>,
    .after_write = method<&InputPanelUnit::parameter_written>};
constexpr AccessHandlers InputPanelUnit::hook_calls[] = {
    in_lift(1, parameter_hook), in_lift(2, parameter_hook), in_lift(3, parameter_hook),
    in_lift(4, parameter_hook), in_lift(5, parameter_hook), in_lift(6, parameter_hook),
    in_lift(7, parameter_hook), in_lift(8, parameter_hook)};
constexpr ServiceHandlers InputPanelUnit::service_calls = {
    .reset = method<&InputPanelUnit::reset>,
    .state_entered = method<&InputPanelUnit::state_entered>,
    .hooks = hook_calls};

InputPanelUnit::InputPanelUnit(Node& node, Tpdos& tpdos, const InputPanelMemory& memory,
                               const InputPanelSettings& settings)
    : node_(node),
      groups_(node.dictionary().tables(), input_group_object.index),
      memory_(memory),
      queue_(memory.queue),
      settings_(settings),
      mapping_(node, tpdos, virtual_input_mapping_object.index,
               {callback<&InputPanelUnit::waits>(*this), callback<&InputPanelUnit::next>(*this)}),
      timer_(callback<&InputPanelUnit::expire>(*this)) {
  node.attach(service_);
}

// Calls from outside

void InputPanelUnit::set_level(std::uint32_t number, bool high, Time now) {
  node_.advance(now);
  if (number >= memory_.states.size()) return;
  InputState& state = memory_.states[number];
  state.level = high;
  state.debouncing = false;
  if (state.level == state.stable) return wake();
  const IoPlace place = groups_.place(number);
  const std::uint8_t milliseconds = parameter(place, 3, debounce_byte);
  if (milliseconds == 0 || milliseconds == parameter_not_used) {
    level_changed(number, place);
  } else {
    state.debouncing = true;
    state.stable_at = low_ticks(now) + milliseconds * 1000U;
  }
  wake();
}

void InputPanelUnit::report(std::uint32_t number, CallRequest condition, Time now,
                            std::uint8_t error_code) {
  node_.advance(now);
  if (number >= memory_.states.size()) return;
  const bool works = condition == CallRequest::none || condition == CallRequest::request;
  memory_.states[number].condition = works ? CallRequest::none : condition;
  const IoPlace place = groups_.place(number);
  set_parameter_byte(node_.dictionary(), place, 1, error_code_byte, error_code);
  update(number, place, false);
}

VirtualInput InputPanelUnit::input(std::uint32_t number) const {
  const IoPlace place = groups_.place(number);
  return decode_input(node_.dictionary().number(place.index, place.sub));
}

std::uint32_t InputPanelUnit::find(BasicFunction function, std::uint8_t sub_function,
                                   std::uint8_t floor) const {
  std::uint32_t found = io_nowhere;
  groups_.for_each([&](std::uint32_t number, IoPlace place) {
    if (found != io_nowhere) return;
    const VirtualInput record = decode_input(node_.dictionary().number(place.index, place.sub));
    const bool is_it =
        record.function == function && record.sub_function == sub_function && record.floor == floor;
    if (is_it) found = number;
  });
  return found;
}

// Life of the node

void InputPanelUnit::reset(ResetScope) {
  node_.timers().disarm(timer_);
  queue_.clear();
  behind_ = 0;
  begun_ = false;
  groups_.for_each([this](std::uint32_t number, IoPlace place) {
    if (number >= memory_.states.size()) return;
    InputState& state = memory_.states[number];
    state.stable = state.level;
    state.debouncing = state.counting = state.held = false;
    state.behind = state.missed = state.was_told = false;
    state.told = CallRequest::none;
    const bool is_assigned = number < settings_.inputs.size();
    VirtualInput record = is_assigned ? settings_.inputs[number] : VirtualInput{};
    record.set_request(request_of(state, place));
    node_.dictionary().set_number(place.index, place.sub, encode(record));
    // A reset of the node has ended all errors: this one still exists.
    if (record.request() == CallRequest::defective) node_.raise(defect_of(number));
  });
}

void InputPanelUnit::state_entered(NmtState state) {
  if (state == NmtState::operational) {
    // The PDO may already be working, and have requested a record.
    if (waits()) mapping_.announce();
    return;
  }
  begun_ = false;
  queue_.clear();
  behind_ = 0;
}

/// Finds the inputs to send first: earlier messages may have been lost.
void InputPanelUnit::begin() {
  begun_ = true;
  queue_.clear();
  behind_ = turn_ = 0;
  for (std::uint32_t i = 0; i < memory_.states.size(); ++i) {
    InputState& state = memory_.states[i];
    const VirtualInput record = input(i);
    state.behind = state.missed = false;
    if (record.function == BasicFunction::none) continue;
    const bool is_wanted = record.request() != CallRequest::none || record.locks();
    if (is_wanted || state.was_told) fall_behind(i, record.request());
  }
  if (memory_.states.empty()) return;
  begin_mapping(node_.dictionary(), virtual_input_mapping_object.index, encode(input(0)));
}

// Parameters

AbortCode InputPanelUnit::before_parameter_write(const Entry& entry,
                                                 std::span<const std::uint8_t> value) {
  return check_event_counts(entry, value, input_parameter_2_object.index);
}

void InputPanelUnit::parameter_written(const Entry& entry, Source) {
  const IoPlace place = place_of_parameter({entry.index, entry.sub}, input_group_object.index);
  const std::uint32_t number = groups_.position(place);
  if (number < memory_.states.size()) update(number, place, false);
}

std::uint8_t InputPanelUnit::parameter(IoPlace place, unsigned number, unsigned byte) const {
  return parameter_byte(node_.dictionary(), place, number, byte);
}

bool InputPanelUnit::is_inverted(IoPlace place) const {
  const std::uint8_t value = parameter(place, 3, edge_byte);
  return value != parameter_not_used && (value & polarity_bit) != 0;
}

/// Edges are those of the request; a failure of the input is always sent.
bool InputPanelUnit::is_edge_told(IoPlace place, CallRequest request) const {
  if (request != CallRequest::request && request != CallRequest::none) return true;
  const unsigned bit = request == CallRequest::request ? rising_bit : falling_bit;
  return (parameter(place, 3, edge_byte) & bit) != 0;
}

CallRequest InputPanelUnit::request_of(const InputState& state, IoPlace place) const {
  if ((parameter(place, 1, enable_byte) & 1) == 0) return CallRequest::none;
  if (state.condition != CallRequest::none) return state.condition;
  return state.stable != is_inverted(place) ? CallRequest::request : CallRequest::none;
}

// Changes

void InputPanelUnit::level_changed(std::uint32_t number, IoPlace place) {
  InputState& state = memory_.states[number];
  state.debouncing = false;
  state.stable = state.level;
  update(number, place, true);
}

/// Stores the present state of the input, and sends it if that is a message.
void InputPanelUnit::update(std::uint32_t number, IoPlace place, bool by_edge) {
  VirtualInput record = input(number);
  const CallRequest request = request_of(memory_.states[number], place);
  if (request == record.request()) return;
  record.set_request(request);
  node_.dictionary().set_number(place.index, place.sub, encode(record));
  node_.report(defect_of(number), request == CallRequest::defective);
  if (!by_edge || (is_edge_told(place, request) && is_message(number, place))) tell(number);
}

/// Counts the event against limitation and sending event.
bool InputPanelUnit::is_message(std::uint32_t number, IoPlace place) {
  const std::uint8_t limitation = parameter(place, 2, limitation_byte);
  const std::uint8_t sending_event = parameter(place, 2, start_event_byte);
  if (limitation == parameter_not_used && sending_event == parameter_not_used) return true;
  InputState& state = memory_.states[number];
  if (!state.counting) {
    state.counting = true;
    state.events = 0;
    state.second_at = low_ticks(node_.now()) + one_second;
  }
  if (state.events < parameter_not_used) ++state.events;
  if (state.events > limitation) {
    state.held = true;
    return false;
  }
  return sending_event == parameter_not_used || sending_event == 0 ||
         state.events % sending_event == 0;
}

void InputPanelUnit::tell(std::uint32_t number) {
  const VirtualInput record = input(number);
  if (record.function == BasicFunction::none) return;
  if (!mapping_.is_working()) {
    node_.dictionary().set_number(virtual_input_mapping_object.index, 0, encode(record));
    return fall_behind(number, record.request());
  }
  if (behind_ == 0 && queue_.push(change(number, record.request()))) {
    memory_.states[number].told = record.request();
  } else {
    fall_behind(number, record.request());
  }
  mapping_.announce();
}

void InputPanelUnit::fall_behind(std::uint32_t number, CallRequest request) {
  InputState& state = memory_.states[number];
  state.missed = state.missed || request == CallRequest::request;
  if (!state.behind) ++behind_;
  state.behind = true;
}

// Time

void InputPanelUnit::expire(Time now) {
  const std::uint32_t ticks = low_ticks(now);
  for (std::uint32_t i = 0; i < memory_.states.size(); ++i) {
    InputState& state = memory_.states[i];
    if (state.debouncing && is_over(state.stable_at, ticks)) level_changed(i, groups_.place(i));
    if (!state.counting || !is_over(state.second_at, ticks)) continue;
    const bool held = state.held;
    state.counting = state.held = false;
    const CallRequest request = input(i).request();
    if (held && request != state.told && is_edge_told(groups_.place(i), request)) tell(i);
  }
  wake();
}

/// At the next end of a debounce time or of a second.
void InputPanelUnit::wake() {
  const std::uint32_t now = low_ticks(node_.now());
  std::uint32_t left = UINT32_MAX;
  for (const InputState& state : memory_.states) {
    if (state.debouncing) left = std::min(left, state.stable_at - now);
    if (state.counting) left = std::min(left, state.second_at - now);
  }
  node_.timers().arm(timer_, left == UINT32_MAX ? never : node_.now() + Duration(left));
}

// Access to the bus

bool InputPanelUnit::waits() {
  if (node_.state() != NmtState::operational) return false;
  if (!begun_) begin();
  return !queue_.empty() || behind_ != 0;
}

std::uint64_t InputPanelUnit::next() {
  if (queue_.empty()) return next_behind();
  const std::uint32_t told = queue_.pop();
  return record(told >> 8, static_cast<CallRequest>(told & request_bits));
}

/// Inputs that are behind take turns. A request that has ended comes first.
std::uint64_t InputPanelUnit::next_behind() {
  while (!memory_.states[turn_].behind) {
    turn_ = static_cast<std::uint32_t>((turn_ + 1) % memory_.states.size());
  }
  InputState& state = memory_.states[turn_];
  const CallRequest request = input(turn_).request();
  const bool has_gone = state.missed && request != CallRequest::request;
  state.missed = false;
  state.behind = has_gone && is_edge_told(groups_.place(turn_), request);
  if (!state.behind) --behind_;
  return record(turn_, has_gone ? CallRequest::request : request);
}

std::uint64_t InputPanelUnit::record(std::uint32_t number, CallRequest request) {
  InputState& state = memory_.states[number];
  state.was_told = true;
  if (queue_.empty()) state.told = request;
  VirtualInput record = input(number);
  record.set_request(request);
  return encode(record);
}

}  // namespace canvoy::cia417
