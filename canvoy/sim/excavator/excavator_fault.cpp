#include "canvoy/sim/excavator/excavator_fault.hpp"

#include <array>

namespace canvoy::excavator {

namespace {

using Kind = InvariantKind;

constexpr std::array excavator_faults{
    FaultName{"lost-node", "a device has no power (default: the host)"},
    FaultName{"restart", "a device boots again (default: the host)"},
    FaultName{"bus-off", "a device has the wrong bit rate, until it gives up (default: the host)"},
    FaultName{"cable-cut", "the bus cable is cut behind a device (default: the host)"},
    FaultName{"babbling-node", "a stranger fills the bus with frames of the highest priority"},
    FaultName{"corrupted-frames", "one frame in a hundred is disturbed, and sent again"},
    FaultName{"lost-frames", "one in twenty frames of a device is lost (default: the host)"},
    FaultName{"delayed-frames", "all frames of a device come 20 ms late (default: the host)"},
    FaultName{"stuck-axis", "the sensor of a stick stays where it is (default: axis 4, boom)"},
    FaultName{"broken-wire", "the wire of a stick's sensor is broken (default: axis 4, boom)"},
    FaultName{"vanished-armrest", "the device on the network behind the seat has no power"},
};
static_assert(excavator_faults.size() == fault_kinds);

enum FaultPlaces : std::size_t { at_node, at_axis };
constexpr FaultPlaceName excavator_places[] = {{"node", node_id_max}, {"axis", stick_count}};

InvariantSet set_of(std::initializer_list<Kind> kinds) {
  InvariantSet set;
  for (const Kind kind : kinds) set.set(static_cast<std::size_t>(kind));
  return set;
}

}  // namespace

FaultGrammar fault_grammar() {
  return {excavator_faults, excavator_places};
}

std::string_view fault_name(FaultKind kind) {
  return excavator_faults.at(static_cast<std::size_t>(kind)).name;
}

ScheduledFault scheduled(const WrittenFault& fault) {
  ScheduledFault made{
      .kind = static_cast<FaultKind>(fault.kind), .start = fault.start, .duration = fault.duration};
  for (const WrittenFault::Place& place : fault.places) {
    if (place.place == at_node) made.node = static_cast<NodeId>(place.number);
    if (place.place == at_axis) made.axis = place.number;
  }
  return made;
}

WrittenFault written(const ScheduledFault& fault) {
  WrittenFault made{.kind = static_cast<std::size_t>(fault.kind),
                    .start = fault.start,
                    .duration = fault.duration};
  if (fault.node != 0) made.places.push_back({at_node, fault.node});
  if (fault.axis != 0) made.places.push_back({at_axis, fault.axis});
  return made;
}

/// Never that of motion: it stops, whatever happens.
InvariantSet affected_by(FaultKind kind) {
  switch (kind) {
    case FaultKind::corrupted_frames:
      return {};
    case FaultKind::delayed_frames:
      return set_of({Kind::axis_delta});
    case FaultKind::stuck_axis:
    case FaultKind::broken_wire:
      return set_of({Kind::axis_delta, Kind::service});
    case FaultKind::vanished_armrest:
      return set_of({Kind::presses, Kind::service});
    default:
      return set_of({Kind::presses, Kind::axis_delta, Kind::indicators, Kind::display,
                     Kind::service, Kind::device_missing});
  }
}

}  // namespace canvoy::excavator
