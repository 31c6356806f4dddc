#include "canvoy/worlds/police/police_excuses.hpp"

namespace canvoy::police {

namespace {

using car::Nodes;
using car::nodes;
using car::return_bound;

constexpr NodeId gateway_id = cia447::gateway_node_id;
constexpr Nodes everybody = car::all_nodes(armoured_names.size());
/// Devices that take keys of the terminal.
constexpr Nodes clients = nodes(radio_id, roof_sound_id, navigation_id);
/// Devices on the path of speech, and the one that supplies the radio.
constexpr Nodes radio_path =
    nodes(gateway_id, radio_id, audio_switch_id, hands_free_id, power_supply_id, inputs_id);
constexpr Nodes signal_keys = nodes(gateway_id, terminal_id, roof_sound_id);

/// The gateway affects all that goes over the bus: it assigns node-IDs to the other devices and
/// starts them, and starts them again when it returns.
constexpr car::Needs<InvariantKind> needs[] = {
    {InvariantKind::keypad, nodes(gateway_id, terminal_id) | clients, return_bound},
    {InvariantKind::terminal_wait, nodes(gateway_id, terminal_id, power_supply_id) | clients,
     return_bound},
    {InvariantKind::blue_light, signal_keys | nodes(roof_light_id, blue_light_id), return_bound},
    {InvariantKind::siren, signal_keys, return_bound},
    {InvariantKind::siren_alone, signal_keys | nodes(roof_light_id, blue_light_id), return_bound},
    {InvariantKind::work_light, signal_keys | nodes(roof_light_id), return_bound},
    {InvariantKind::speech, radio_path, return_bound},
    {InvariantKind::carrier, radio_path, return_bound},
    {InvariantKind::display, signal_keys | nodes(roof_light_id, blue_light_id), return_bound},
    {InvariantKind::locks, signal_keys, return_bound},
    {InvariantKind::power, nodes(gateway_id, power_supply_id), return_bound},
    {InvariantKind::silence, everybody, return_bound},
    {InvariantKind::calls, radio_path, return_bound},
    {InvariantKind::emergency, nodes(gateway_id, terminal_id, radio_id, power_supply_id),
     return_bound},
    // For each device: can_cost().
    {InvariantKind::device_missing, everybody, return_bound},
};
static_assert(std::size(needs) == invariant_kinds);
static_assert(std::ranges::is_sorted(needs, {}, &car::Needs<InvariantKind>::kind));

constexpr const car::Needs<InvariantKind>& needs_of(InvariantKind kind) {
  return needs[static_cast<std::size_t>(kind)];
}

/// The radio has no power, but its device has: it is not heard, and does not answer keys.
constexpr bool needs_power_of_radio(InvariantKind kind) {
  switch (kind) {
    case InvariantKind::terminal_wait:
    case InvariantKind::speech:
    case InvariantKind::power:
    case InvariantKind::calls:
    case InvariantKind::emergency:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool can_cause(const ScheduledFault& fault, InvariantKind kind) {
  switch (fault.kind) {
    case FaultKind::overload:
      return needs_power_of_radio(kind);
    case FaultKind::dead_client:  // any of them: the next client that has the terminal
      return (needs_of(kind).nodes & clients) != 0;
    default:
      return car::hinders(fault, needs_of(kind).nodes);
  }
}

bool can_cost(const ScheduledFault& fault, NodeId device) {
  if (fault.kind == FaultKind::dead_client) return (nodes(device) & clients) != 0;
  return car::hinders(fault, nodes(gateway_id, device));
}

Duration lasts_after(InvariantKind kind) {
  return needs_of(kind).after;
}

}  // namespace canvoy::police
