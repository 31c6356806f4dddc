#include "canvoy/devices/cia407/main_on_board_computer/main_on_board_computer_unit.hpp"

#include <utility>

#include "canvoy/devices/cia407/kit/motion_recognition.hpp"

namespace canvoy::cia407 {

namespace {

constexpr unsigned seconds_of_minute = 60;
constexpr std::uint16_t events_index = events_from_virtual_devices_object.index;

}  // namespace

constexpr AccessHandlers MainOnBoardComputerUnit::hook_calls[] = {
    after_write<&MainOnBoardComputerUnit::event_written, events_from_virtual_devices_object>,
    after_write<&MainOnBoardComputerUnit::doors_written, state_of_doors_object>,
    after_write<&MainOnBoardComputerUnit::mileage_written, vehicle_mileage_object>,
    after_write<&MainOnBoardComputerUnit::mileage_precision_written,
                vehicle_mileage_precision_object>,
    after_write<&MainOnBoardComputerUnit::follow_speed, tachograph_speed_object>,
    after_write<&MainOnBoardComputerUnit::follow_speed, wheel_based_vehicle_speed_object>,
    after_write<&MainOnBoardComputerUnit::satellite_speed_written, gps_based_speed_object>,
    after_any_write<&MainOnBoardComputerUnit::told>};

MainOnBoardComputerUnit::MainOnBoardComputerUnit(VirtualDevice& device,
                                                 const MainOnBoardComputerHardware& hardware,
                                                 const MainOnBoardComputerSettings& settings)
    : device_(device),
      hardware_(hardware),
      settings_(settings),
      texts_(device.node()),
      timer_(callback<&MainOnBoardComputerUnit::look>(*this)) {
  device.on_reset = callback<&MainOnBoardComputerUnit::reset>(*this);
  device.react(*this, hook_calls);
}

void MainOnBoardComputerUnit::reset(ResetScope scope) {
  if (scope == ResetScope::node) {
    has_satellite_speed_ = false;
    are_doors_open_ = false;
    report_vehicle();
  }
  look(node().now());
}

void MainOnBoardComputerUnit::report_vehicle() {
  device_.tell(vehicle_id, settings_.vehicle_id);
  device_.tell(body_id, settings_.body_id);
  device_.tell(garage_id, settings_.garage_id);
  device_.tell(radio_id, settings_.radio_id);
  device_.tell(vehicle_class, settings_.vehicle_class);
  device_.tell(number_of_vehicle_units, settings_.vehicle_units);
  device_.tell(vehicle_id_text, settings_.vehicle_id_text);
  device_.tell(body_id_text, settings_.body_id_text);
  device_.tell(garage_id_text, settings_.garage_id_text);
  device_.tell(radio_id_text, settings_.radio_id_text);
}

void MainOnBoardComputerUnit::look(Time now) {
  const std::optional<CivilTime> time = hardware_.clock ? hardware_.clock() : std::nullopt;
  report_clock(device_, local_clock, time);
  const bool is_known = time && can_be_told(*time);
  node().timers().arm(timer_,
                      now + std::chrono::seconds(is_known ? seconds_of_minute - time->second : 1));
  const auto warmth = hardware_.inside_temperature ? hardware_.inside_temperature() : std::nullopt;
  if (warmth) device_.tell(inside_temperature, *warmth);
}

void MainOnBoardComputerUnit::begin_route(const RoutePosition& position) {
  device_.tell(previous_route_segment, 0);
  device_.tell(previous_fare_zone, 0);
  report_position(position);
}

void MainOnBoardComputerUnit::set_position(const RoutePosition& position) {
  const std::uint8_t zone = device_[fare_zone].raw();
  const std::uint16_t segment = device_[route_segment_number].raw();
  if (position.fare_zone != zone) device_.tell(previous_fare_zone, zone);
  // The same number in another zone is another segment.
  if (position.fare_zone != zone || position.route_segment != segment) {
    device_.tell(previous_route_segment, segment);
  }
  report_position(position);
}

void MainOnBoardComputerUnit::report_position(const RoutePosition& position) {
  device_.tell(route_segment_number, position.route_segment);
  device_.tell(fare_zone, position.fare_zone);
  device_.tell(journey_direction, position.direction);
  device_.tell(number_of_running_in_route_representation, position.number_of_running);
  device_.tell(stop_point_id, position.stop_point_id);
}

void MainOnBoardComputerUnit::block_tickets(bool is_blocked) {
  device_.tell(blocking_of_ticket_canceller,
               is_blocked ? TicketValidator::blocked : TicketValidator::in_operation);
}

void MainOnBoardComputerUnit::request_stop(bool is_requested) {
  device_.tell(bus_stop_request, is_requested ? BusStop::requested : BusStop::not_requested);
}

void MainOnBoardComputerUnit::command(unsigned number, DeviceCode code, std::uint8_t flags,
                                      std::uint16_t information) {
  const bool is_event = flags != 0 || information != 0;
  const std::uint32_t word = std::uint32_t{code_of(code)} << event_code_bit |
                             std::uint32_t{information} << event_information_bit | flags;
  const std::uint16_t index = events_for_virtual_devices_object.index;
  const auto sub = static_cast<std::uint8_t>(number);
  node().dictionary().set_number(index, sub, is_event ? word : 0);
  device_.announce_at(index, sub);
}

void MainOnBoardComputerUnit::event_written(const Entry& entry) {
  if (entry.sub >= 2) take_event(entry.sub);
}

/// A request is for the next station (9.2.8.5): opening doors end it, open doors do not.
void MainOnBoardComputerUnit::doors_written() {
  const bool are_open = device_[all_doors].is(Doors::open);
  const bool were_open = std::exchange(are_doors_open_, are_open);
  if (are_open && !were_open) request_stop(false);
}

void MainOnBoardComputerUnit::mileage_written() {
  device_.tell(car_mileage, device_[vehicle_mileage].value());
}

void MainOnBoardComputerUnit::mileage_precision_written() {
  device_.tell(car_mileage_calibration_information, device_[vehicle_mileage_precision].value());
}

void MainOnBoardComputerUnit::told(const Entry& entry) {
  if (hardware_.on_told) hardware_.on_told(entry);
}

/// The summary covers its own entries: each device that sends events has a separate one.
void MainOnBoardComputerUnit::take_event(std::uint8_t sub) {
  Dictionary& dictionary = node().dictionary();
  const std::uint32_t event = dictionary.word(events_index, sub);
  const std::uint32_t bit = std::uint32_t{1} << (sub - 2U);
  const std::uint32_t others = dictionary.word(events_index, 1) & ~bit;
  dictionary.set_number(events_index, 1, others | (event != 0 ? bit : 0));
  if (hardware_.on_event) hardware_.on_event(sub - 1U, event);
}

void MainOnBoardComputerUnit::satellite_speed_written() {
  has_satellite_speed_ = true;
  follow_speed();
}

/// 6123h follows the tachograph, the wheels, or GPS: the first that is valid and was ever received.
/// It has no code for "not known" (9.2.6.36): without a source, it keeps its value.
void MainOnBoardComputerUnit::follow_speed() {
  const auto by_tachograph = device_[tachograph_speed].value();
  const auto by_wheels = device_[wheel_based_vehicle_speed].value();
  const auto by_satellites = device_[gps_based_speed].value();
  if (by_tachograph) {
    device_.tell(vehicle_speed, *by_tachograph);
  } else if (by_wheels) {
    device_.tell(vehicle_speed, *by_wheels);
  } else if (has_satellite_speed_ && by_satellites) {
    device_.tell(vehicle_speed, *by_satellites * kmh_of_metres_per_second);
  }
}

}  // namespace canvoy::cia407
