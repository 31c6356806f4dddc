#include "canvoy/canopen/error_behaviour.hpp"

namespace canvoy {

namespace {

constexpr std::uint16_t behaviour_object = 0x1029;

/// The values of an entry of 1029h.
enum class Reaction : std::uint8_t { leave_operational = 0, none = 1, stop = 2 };

}  // namespace

constexpr ServiceCalls ErrorBehaviour::fixed_calls = {
    .bus_state_changed = method<&ErrorBehaviour::bus_state_changed>,
    .error_changed = method<&ErrorBehaviour::error_changed>};
constexpr ServiceCalls ErrorBehaviour::configurable_calls = {
    .bus_state_changed = method<&ErrorBehaviour::bus_state_changed>,
    .error_changed = method<&ErrorBehaviour::error_changed>,
    .hooks = {&hook_calls, 1}};
constexpr HookCalls ErrorBehaviour::hook_calls = {.first = behaviour_object,
                                                  .last = behaviour_object,
                                                  .before_write = method<&ErrorBehaviour::check>};

void ErrorBehaviour::device_failure(std::uint8_t sub) {
  const auto reaction = static_cast<Reaction>(node_.dictionary().word(behaviour_object, sub));
  if (reaction == Reaction::stop) return node_.command(NmtCommand::stop);
  if (reaction == Reaction::leave_operational && node_.state() == NmtState::operational) {
    node_.command(NmtCommand::enter_pre_operational);
  }
}

inline AbortCode ErrorBehaviour::check(const Entry& entry, std::span<const std::uint8_t> value) {
  constexpr auto last = static_cast<std::uint32_t>(Reaction::stop);
  const bool known = entry.sub == 0 || load_word(value) <= last;
  return known ? AbortCode::none : AbortCode::value_range;
}

inline void ErrorBehaviour::error_changed(const Error& error, bool present) {
  if (present && error.code == emergency_code::heartbeat) device_failure(communication_error);
}

inline void ErrorBehaviour::bus_state_changed(BusState state) {
  if (state == BusState::bus_off) device_failure(communication_error);
}

}  // namespace canvoy
