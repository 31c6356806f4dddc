// The values that a host writes into a seat and into an input and output module before it starts
// them, and how careful it is.
//
//     NodeSetup setup(node, seat_id, seat_setup({.checks_contacts = false}));
#pragma once

#include <cstdint>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/worlds/excavator/host_objects.hpp"
#include "canvoy/worlds/excavator/node_setup.hpp"

namespace canvoy::excavator {

/// Least change of an axis that is sent, in digits.
inline constexpr std::uint16_t axis_delta = 400;

/// What a host writes into others, and what it trusts.
struct HostSettings {
  /// Precautions of a host. Without one of them, a referee has something to detect.
  Duration seat_time_out = consumer_time;
  Duration host_time_out = consumer_time;  ///< 1016h of the module
  bool has_armrest = true;                 ///< behind the seat; false: there is no safety lever
  bool has_trainer = false;                ///< a second seat, of which one has the command
  bool obeys_all_seats = false;            ///< whichever has the command
  bool checks_armrest = true;              ///< false: the last state of its lever counts for ever
  std::uint16_t delta = axis_delta;  ///< least change of an axis that the seat sends, in digits
  bool checks_contacts =
      true;                  ///< false: it trusts a position without the contact of its direction
  bool counts_edges = true;  ///< of buttons; false: each PDO is a press
  bool filters_buttons = false;   ///< 6003h
  bool sets_error_values = true;  ///< false: lamps keep their state without a host (6206h, 6207h)
  bool restarts_others = true;    ///< after they have rebooted
};

/// The lists of writes for seat and module.
std::vector<SetupWrite> seat_setup(const HostSettings& settings);
/// Values for the module on the valves.
std::vector<SetupWrite> valves_setup(const HostSettings& settings);

}  // namespace canvoy::excavator
