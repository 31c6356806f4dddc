// What a device of CiA 407 senses of its vehicle.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "canvoy/tools/device/device_bus_panel.hpp"

namespace canvoy::tools {

namespace {

constexpr double kmh_of_a_bus = 3.6;
constexpr double ambient_celsius = 20;
/// Three characters of the member state, 16 of the card.
constexpr std::array<std::string_view, 2> driver_cards = {"D  1234567890123456",
                                                          "D  6543210987654321"};

}  // namespace

// The vehicle.

double BusPanel::metres() const {
  return kept_.metres + place_.car.metres();
}

cia407::TrainBusGatewayHardware BusPanel::train() {
  return {.send =
              Callback<void(std::uint16_t, std::uint8_t,
                            std::span<const std::uint8_t>)>::to<&BusPanel::send_to_train>(*this)};
}
void BusPanel::send_to_train(std::uint16_t index, std::uint8_t sub,
                             std::span<const std::uint8_t> value) {
  place_.output.say("train-bus-gateway", fmt::format("to the train: {:04X}h:{:02X}h = {:02X}",
                                                     index, sub, fmt::join(value, " ")));
}

cia407::VehicleGatewayHardware BusPanel::gateway() {
  doors_.fill({.is_valid = true});
  return {.read = Callback<cia407::VehicleReading()>::to<&BusPanel::vehicle>(*this)};
}
cia407::VehicleReading BusPanel::vehicle() {
  cia407::VehicleReading reading;
  const cia447::GpsReading place = place_.car.receiver();
  reading.speed_kmh = place_.car.speed() * kmh_of_a_bus;
  reading.mileage_metres = metres();
  reading.bearing_degrees.value = place.heading;
  reading.ambient_celsius = ambient_celsius;
  reading.direction = is_reverse_ ? cia407::Direction::reverse : cia407::Direction::forward;
  reading.brake = is_braking_ ? cia407::BrakePedal::depressed : cia407::BrakePedal::released;
  reading.doors = doors_;
  reading.local_time = utc();
  return reading;
}

cia407::TachographHardware BusPanel::tachograph() {
  return {.read = Callback<cia407::TachographReading()>::to<&BusPanel::record>(*this)};
}
cia407::TachographSettings BusPanel::tachograph_settings() {
  return {.trip_begin_metres = kept_.trip_begin};
}
cia407::TachographReading BusPanel::record() {
  cia407::TachographReading reading = {.speed_kmh = place_.car.speed() * kmh_of_a_bus,
                                       .direction = cia407::Direction::forward,
                                       .distance_metres = metres(),
                                       .utc = utc()};
  for (std::size_t slot = 0; slot < reading.cards.size(); ++slot) {
    if (has_card_.at(slot)) reading.cards.at(slot) = driver_cards.at(slot);
  }
  return reading;
}

cia407::PositioningHardware BusPanel::positioning() {
  return {.read = Callback<cia447::GpsReading()>::to<&BusPanel::receiver>(*this)};
}
cia447::GpsReading BusPanel::receiver() {
  return has_signal_ ? place_.car.receiver() : cia447::GpsReading{.fix = cia447::GpsFix::none};
}
cia407::TimeFixingHardware BusPanel::time_fixing() {
  return {.utc = Callback<std::optional<cia407::CivilTime>()>::to<&BusPanel::satellite_time>(*this),
          .local_offset = {}};
}
std::optional<cia407::CivilTime> BusPanel::satellite_time() {
  return has_signal_ ? utc() : std::nullopt;
}
std::optional<cia407::CivilTime> BusPanel::utc() {
  const cia447::GpsReading reading = place_.car.receiver();
  if (!reading.date || !reading.time) return std::nullopt;
  return cia407::CivilTime{.year = reading.date->year,
                           .month = reading.date->month,
                           .day = reading.date->day,
                           .hour = reading.time->hour,
                           .minute = reading.time->minute,
                           .second = static_cast<unsigned>(reading.time->second)};
}

}  // namespace canvoy::tools
