// What is known when a ticket is cancelled or printed: where the vehicle is, on which line, when.
//
//     const TicketData data = read_ticket_data(values);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia407/bus_time.hpp"

namespace canvoy::cia407 {

struct TicketData {
  std::optional<CivilTime> time = {};  ///< local
  std::uint32_t vehicle_id = 0;
  std::uint32_t stop_point_id = 0;
  std::uint32_t destination_number = 0;
  std::uint32_t block_id = 0;
  std::uint16_t line_id = 0;
  std::uint16_t route_number = 0;
  std::uint16_t route_segment_number = 0;
  std::uint8_t fare_zone = 0;
  std::uint8_t number_of_running = 0;  ///< 0: not known
  JourneyDirection direction = JourneyDirection::not_specified;
  /// Valid until one of them is written.
  std::string_view stop_point_text = {};
  std::string_view line_text = {};
};

inline TicketData read_ticket_data(Values values) {
  return {.time = local_time(values),
          .vehicle_id = values[vehicle_id].raw(),
          .stop_point_id = values[stop_point_id].raw(),
          .destination_number = values[destination_number].raw(),
          .block_id = values[block_id].raw(),
          .line_id = values[line_id].raw(),
          .route_number = values[route_number].raw(),
          .route_segment_number = values[route_segment_number].raw(),
          .fare_zone = values[fare_zone].raw(),
          .number_of_running = values[number_of_running_in_route_representation].raw(),
          .direction = values[journey_direction].value().value_or(JourneyDirection::not_specified),
          .stop_point_text = values[stop_point_id_text].value(),
          .line_text = values[line_id_text].value()};
}

/// What becomes of a ticket.
enum class TicketAnswer : std::uint8_t {
  done,
  blocked,         ///< 6116h says so
  not_in_service,  ///< the node is not operational, or nobody has told the time
  out_of_paper,
};
/// Whether there may be tickets now, and if not, why.
inline TicketAnswer can_have_tickets(VirtualDevice& device) {
  if (device.node().state() != NmtState::operational || !local_time(device.values())) {
    return TicketAnswer::not_in_service;
  }
  return device[blocking_of_ticket_canceller].is(TicketValidator::blocked) ? TicketAnswer::blocked
                                                                           : TicketAnswer::done;
}

}  // namespace canvoy::cia407
