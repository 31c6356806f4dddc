// Events and invariants of a charging yard, as types: those of its bays, and of its vehicles.
//
//     if (const auto* came = std::get_if<VehicleMoved>(&event.what)) print(came->vehicle);
#pragma once

#include <variant>

#include "canvoy/worlds/charger/charger_event.hpp"

namespace canvoy::charger {

/// What a referee judges of a yard; yard_invariant_rows says what of each kind is measured.
enum class YardInvariantKind : std::uint8_t { battery_goal, charger_goal, equalised, supply };

/// All kinds, in the order of YardInvariantKind.
inline constexpr InvariantRow yard_invariant_rows[] = {
    {"battery_goal", "missing of its charge at the time of the goal", "%", "file"},
    {"charger_goal", "missing of a battery of its bay at the time of the goal", "%", "file"},
    {"equalised", "missing of the time of equalising", "%", "canvoy"},
    {"supply", "power from the mains at most", "kW", "file"},
};
/// Number of kinds of invariants of a yard.
inline constexpr std::size_t yard_invariant_kinds = std::size(yard_invariant_rows);
static_assert(yard_invariant_kinds == static_cast<std::size_t>(YardInvariantKind::supply) + 1);
/// The rows of the table above; found by the type of the argument.
constexpr std::span<const InvariantRow> rows_of(YardInvariantKind) {
  return yard_invariant_rows;
}
/// Its part is the number of a battery, or of a bay where it is about a charger.
using YardInvariant = canvoy::Invariant<YardInvariantKind>;

/// Where a vehicle is.
enum class VehiclePlace : std::uint8_t {
  away,
  waiting,  ///< in the yard, for its bay
  plugged,  ///< at the cable of its bay
};

/// A vehicle came, was plugged in, was taken from the cable, or left.
struct VehicleMoved {
  unsigned vehicle = 0;                    ///< from 1 on
  unsigned bay = 0;                        ///< of the vehicle, from 1 on
  VehiclePlace from = VehiclePlace::away;  ///< place before
  VehiclePlace to = VehiclePlace::away;    ///< place from now on
  double state_of_charge = 0;              ///< 0 to 1, of its cells
};

/// An event of a bay has the numbers of faults in the plan of the yard.
struct YardEvent {
  Time at{};         ///< since the start of the run
  unsigned bay = 0;  ///< from 1 on; 0: of the yard
  /// An event of a bay, a move of a vehicle, or the first breach of a goal of the yard.
  std::variant<ChargerEvent, VehicleMoved, canvoy::InvariantBroken<YardInvariantKind>> what;
};

}  // namespace canvoy::charger
