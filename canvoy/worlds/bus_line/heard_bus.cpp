#include "canvoy/worlds/bus_line/heard_bus.hpp"

#include <algorithm>
#include <cmath>

#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/worlds/bus_line/bus_places.hpp"

namespace canvoy::bus_line {

namespace {

// Messages of 8.1.4.3, with their numbers read in the order of the table (errata 94).
constexpr std::uint32_t block_message = 0x281;
constexpr std::uint32_t route_message = 0x381;
constexpr std::uint32_t stop_message = 0x401;
/// Greatest number of 610Ah.
constexpr unsigned running_number_max = 255;

/// Value of a coded number; empty above its range (9.1).
std::optional<double> coded_16(const Frame& frame, std::size_t at) {
  const auto raw = load<std::uint16_t>(&frame.data[at]);
  return raw > 0xFAFF ? std::nullopt : std::optional<double>(raw);
}
std::optional<double> coded_32(const Frame& frame, std::size_t at) {
  const auto raw = load<std::uint32_t>(&frame.data[at]);
  return raw > 0xFAFF'FFFF ? std::nullopt : std::optional<double>(raw);
}

/// Position of 6660h: in ten-millionths of a degree from -210 degrees on (errata 57, 59).
std::optional<GeoPoint> position_in(const Frame& frame) {
  const auto degrees = [&](std::size_t at, double limit) {
    std::optional<double> value = coded_32(frame, at);
    if (value) *value = *value * 1e-7 - 210;
    return value && std::abs(*value) <= limit ? value : std::nullopt;
  };
  const std::optional<double> latitude = degrees(0, 90);
  const std::optional<double> longitude = degrees(4, 180);
  if (!latitude || !longitude) return std::nullopt;
  return GeoPoint{*latitude, *longitude};
}

}  // namespace

HeardBus::HeardBus(const BusLine& line, const BusDesign& design)
    : line_(line),
      ids_(message_ids(design)),
      nodes_{id_of(design, computer_id), id_of(design, identification_id),
             id_of(design, vehicle_gateway_id), id_of(design, positioning_id),
             id_of(design, counting_manager_id)} {}

HeardBus::Source HeardBus::source_of(std::uint32_t can_id) const {
  if (can_id == block_message) return identification;
  if (can_id == route_message || can_id == stop_message) return computer;
  for (std::size_t source = 0; source < nodes_.size(); ++source) {
    if (can_id == std::uint32_t{can_id::error_control} + nodes_[source])
      return static_cast<Source>(source);
  }
  if (can_id == ids_.motion || can_id == ids_.mileage) return gateway;
  if (can_id == ids_.position) return positioning;
  return can_id == ids_.aboard ? counting : sources;
}

bool HeardBus::is_there(Source source, Time now) const {
  return heard_.at(source).is_there && now - heard_.at(source).at <= time_out;
}

void HeardBus::forget(Source source) {
  switch (source) {
    case computer:
      stop_point_.reset();
      running_number_.reset();
      stop_.reset();
      break;
    case identification:
      journey_ = nullptr;
      stop_.reset();
      break;
    case gateway:
      speed_.reset();
      odometer_.reset();
      has_open_door_.reset();
      break;
    case positioning:
      position_.reset();
      break;
    case counting:
      aboard_.reset();
      break;
    case sources:
      break;
  }
}

void HeardBus::hear(Time now, const Frame& frame) {
  const Source source = frame.is_plain() && !frame.is_extended() ? source_of(frame.id) : sources;
  if (source == sources) return;
  const bool is_heartbeat = (frame.id & ~std::uint32_t{0x7F}) == can_id::error_control;
  if (is_heartbeat) return hear_sign_of_life(now, source, frame);
  // A sender of process data is operational.
  if (!is_there(source, now)) forget(source);
  heard_.at(source) = {.at = now, .is_there = true};
  take(now, frame);
}

void HeardBus::hear_sign_of_life(Time now, Source source, const Frame& frame) {
  if (frame.length != 1) return;
  const bool is_operational = remote_state(frame.data[0]) == RemoteState::operational;
  if (!is_operational || !is_there(source, now)) forget(source);
  heard_.at(source) = {.at = now, .is_there = is_operational};
}

void HeardBus::take(Time now, const Frame& frame) {
  switch (frame.id) {
    case block_message:
      if (frame.length == 8) take_journey(frame);
      return look_for_place(now);
    case route_message:
      if (frame.length == 6) running_number_ = frame.data[5];
      return look_for_place(now);
    case stop_message:
      if (frame.length == 8) stop_point_ = load<std::uint32_t>(frame.data.data());
      return look_for_place(now);
    default:
      return take_vehicle(now, frame);
  }
}

/// Takes messages with the CAN-IDs of the fleet.
void HeardBus::take_vehicle(Time now, const Frame& frame) {
  if (frame.id == ids_.motion) {
    if (frame.length == 5) take_doors(now, frame);
  } else if (frame.id == ids_.mileage) {
    if (frame.length == 6) odometer_ = coded_32(frame, 0);
    if (odometer_) *odometer_ *= 5;
  } else if (frame.id == ids_.position) {
    if (frame.length == 8) position_ = position_in(frame);
  } else if (frame.id == ids_.aboard) {
    if (frame.length == 3) aboard_ = load<std::uint16_t>(frame.data.data());
  }
}

void HeardBus::take_journey(const Frame& frame) {
  const auto block_number = load<std::uint32_t>(frame.data.data());
  const auto journey_number = load<std::uint16_t>(&frame.data[6]);
  const Journey* found = nullptr;
  for (const Block& block : line_.blocks) {
    if (block.number != block_number) continue;
    const auto journey = std::ranges::find(block.journeys, journey_number, &Journey::number);
    if (journey != block.journeys.end()) found = &*journey;
  }
  if (found == journey_) return;
  journey_ = found;
  stop_.reset();
}

/// Takes 6481h, 6484h and the first doors of 6488h.
void HeardBus::take_doors(Time now, const Frame& frame) {
  constexpr double raw_of_metres_per_second = 256 * 3.6;
  constexpr unsigned any_door_open = 0x80;
  speed_ = coded_16(frame, 0);
  if (speed_) *speed_ /= raw_of_metres_per_second;
  has_open_door_ = (frame.data[3] & any_door_open) != 0;
  if (*has_open_door_ && stop_ && !stop_->arrived) stop_->arrived = now;
}

/// Finds the place where stop point and number in the route agree. A route with more stops than
/// numbers has its last number for all others: then the stop point decides.
std::optional<std::size_t> HeardBus::reported_place() const {
  if (journey_ == nullptr || !stop_point_ || !running_number_ || *running_number_ == 0) {
    return std::nullopt;
  }
  const std::size_t count = line_.routes[journey_->route].stops.size();
  const std::size_t first = *running_number_ - 1;
  const std::size_t last = *running_number_ == running_number_max ? count : first + 1;
  for (std::size_t place = first; place < std::min(last, count); ++place) {
    if (line_.stop(journey_->route, place).number == *stop_point_) return place;
  }
  return std::nullopt;
}

void HeardBus::look_for_place(Time now) {
  const std::optional<std::size_t> place = reported_place();
  if (!place || (stop_ && stop_->place == *place)) return;
  const bool has_gone_on = stop_ && stop_->place + 1 == *place;
  stop_ = Stop{.place = *place};
  if (has_gone_on) stop_->left_before = now;
}

const Journey* HeardBus::journey(Time now) const {
  return is_there(identification, now) ? journey_ : nullptr;
}

std::optional<HeardBus::Aged<HeardBus::Stop>> HeardBus::stop(Time now) const {
  if (journey(now) == nullptr || !is_there(computer, now) || !stop_) return std::nullopt;
  if (reported_place() != stop_->place) return std::nullopt;
  return Aged<Stop>{.value = *stop_, .heard = heard_.at(computer).at};
}

std::optional<HeardBus::Aged<GeoPoint>> HeardBus::position(Time now) const {
  if (!is_there(positioning, now) || !position_) return std::nullopt;
  return Aged<GeoPoint>{.value = *position_, .heard = heard_.at(positioning).at};
}

std::optional<double> HeardBus::speed(Time now) const {
  return is_there(gateway, now) ? speed_ : std::nullopt;
}

std::optional<double> HeardBus::odometer(Time now) const {
  return is_there(gateway, now) ? odometer_ : std::nullopt;
}

std::optional<bool> HeardBus::has_open_door(Time now) const {
  return is_there(gateway, now) ? has_open_door_ : std::nullopt;
}

std::optional<unsigned> HeardBus::aboard(Time now) const {
  return is_there(counting, now) ? aboard_ : std::nullopt;
}

}  // namespace canvoy::bus_line
