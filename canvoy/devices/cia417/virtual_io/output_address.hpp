// Selects the virtual outputs that a record of 6011h addresses: by function, sub-function, lifts,
// floor and doors (CiA 417-4, 4.4.1).
//
//     is_addressed(record, output)   // `output` is what the output was assigned
//
// A reserved value addresses only outputs that are assigned exactly the same one; function 00h and
// the reserved sub-function 00h address none.
#pragma once

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::cia417 {

/// True if the sub-function is the contents to show, and does not address outputs.
constexpr bool shows_sub_function(BasicFunction function) {
  return is_between(function, BasicFunction::position_indicator,
                    BasicFunction::publicity_indication);
}

/// An output for special indications that shows any of them.
inline constexpr std::uint8_t any_special_indication = 0;

/// For a hall call, each direction; for target stops, one or all; for an indication, equality.
constexpr bool is_sub_function_addressed(BasicFunction function, std::uint8_t wanted,
                                         std::uint8_t assigned) {
  constexpr std::uint8_t all_target_stops = 0xFF;
  if (is_hall_call(function)) return (wanted & assigned & hall_undirected) != 0;
  if (has_target_stop(function)) {
    return wanted != 0 && assigned != 0 && (wanted == assigned || wanted == all_target_stops);
  }
  switch (function) {
    case BasicFunction::special_function:
      return wanted != 0 && wanted == assigned;
    case BasicFunction::position_indicator:
      return wanted != static_cast<std::uint8_t>(Floor::all);
    case BasicFunction::special_indication:
      return wanted == sub_function_of(SpecialIndication::all_off) || wanted == assigned ||
             assigned == any_special_indication;
    case BasicFunction::arrival_indication:
      return (wanted & (arrow_up | arrow_down)) != (arrow_up | arrow_down);
    default:
      return shows_sub_function(function) || wanted == assigned;
  }
}

/// All landings, one of them, or the car.
constexpr bool is_floor_addressed(std::uint8_t wanted, std::uint8_t assigned) {
  return wanted == assigned || (wanted == all_floors && assigned != floor_of_car);
}

/// Half a byte of doors: at least one of those given. Outputs without doors are always addressed.
constexpr bool is_door_addressed(std::uint8_t wanted, std::uint8_t assigned) {
  return wanted == 0 || assigned == 0 || (wanted & assigned) != 0;
}

/// True if a record addresses an output with these assignments.
constexpr bool is_addressed(const VirtualOutput& record, const VirtualOutput& assigned) {
  return record.function == assigned.function && record.function != BasicFunction::none &&
         is_sub_function_addressed(record.function, record.sub_function, assigned.sub_function) &&
         (record.lifts & assigned.lifts) != 0 && is_floor_addressed(record.floor, assigned.floor) &&
         is_door_addressed(source_doors(record.doors), source_doors(assigned.doors)) &&
         is_door_addressed(destination_doors(record.doors), destination_doors(assigned.doors));
}

}  // namespace canvoy::cia417
