// Data of a cancelled or printed ticket: position of the vehicle, line, time.
//
//     const TicketData data = read_ticket_data(values);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "canvoy/devices/cia407/kit/bus_time.hpp"

namespace canvoy::cia407 {

/// An identifier of 0 has not been received.
struct TicketData {
  std::optional<CivilTime> time = {};    ///< local
  std::uint32_t vehicle_id = 0;          ///< of the vehicle
  std::uint32_t stop_point_id = 0;       ///< the present or last stop
  std::uint32_t destination_number = 0;  ///< of the journey
  std::uint32_t block_id = 0;            ///< work of the vehicle for the day
  std::uint16_t line_id = 0;             ///< of the journey
  std::uint16_t route_number = 0;        ///< of the journey
  bool has_fare_place = false;  ///< segment and zone were received: 0 is a valid value of both
  std::uint16_t route_segment_number = 0;                        ///< of the route
  std::uint8_t fare_zone = 0;                                    ///< of the stop
  std::uint8_t number_of_running = 0;                            ///< 0: not known
  JourneyDirection direction = JourneyDirection::not_specified;  ///< forward or backward
  /// Valid until one of them is written.
  std::string_view stop_point_text = {};
  std::string_view line_text = {};  ///< of the line; valid until it is written
};

/// The location that a ticket machine has received since the last NMT reset of its node. A ticket
/// without a stop or a zone cannot be checked.
class ToldPlace {
 public:
  /// Clears the location: the node was reset.
  void forget() { *this = {}; }
  /// Call it for each written object.
  void hear(const Entry& entry) {
    const std::uint16_t index = entry.index;
    if (index == stop_point_id_object.index) has_stop_ = entry.word() != 0;
    if (index == route_segment_number_object.index) has_segment_ = true;
    if (index == fare_zone_object.index) has_zone_ = true;
  }
  /// One message carries both (8.1.4.3), or SDO writes them one after the other.
  bool has_fare_place() const { return has_segment_ && has_zone_; }
  /// True with a stop, or a place for the fare.
  bool is_known() const { return has_stop_ || has_fare_place(); }

 private:
  bool has_stop_ = false;
  bool has_segment_ = false;
  bool has_zone_ = false;
};

/// Data of a ticket at present, from the dictionary and what was received.
inline TicketData read_ticket_data(Values values, const ToldPlace& place) {
  return {.time = local_time(values),
          .vehicle_id = values[vehicle_id].raw(),
          .stop_point_id = values[stop_point_id].raw(),
          .destination_number = values[destination_number].raw(),
          .block_id = values[block_id].raw(),
          .line_id = values[line_id].raw(),
          .route_number = values[route_number].raw(),
          .has_fare_place = place.has_fare_place(),
          .route_segment_number = values[route_segment_number].raw(),
          .fare_zone = values[fare_zone].raw(),
          .number_of_running = values[number_of_running_in_route_representation].raw(),
          .direction = values[journey_direction].value().value_or(JourneyDirection::not_specified),
          .stop_point_text = values[stop_point_id_text].value(),
          .line_text = values[line_id_text].value()};
}

/// Result of a request for a ticket.
enum class TicketAnswer : std::uint8_t {
  done,
  blocked,         ///< as 6116h says
  not_in_service,  ///< the node is not operational, or time or place have not been received
  out_of_paper,
};
/// Whether tickets are possible at present, and if not, why.
inline TicketAnswer can_have_tickets(VirtualDevice& device, const ToldPlace& place) {
  const bool is_told = place.is_known() && local_time(device.values());
  if (device.node().state() != NmtState::operational || !is_told) {
    return TicketAnswer::not_in_service;
  }
  return device[blocking_of_ticket_canceller].is(TicketValidator::blocked) ? TicketAnswer::blocked
                                                                           : TicketAnswer::done;
}

}  // namespace canvoy::cia407
