#include "canvoy/tools/device/bus/sensed_vehicle.hpp"

#include <algorithm>
#include <string_view>

namespace canvoy::tools {

namespace {

constexpr double ambient_celsius = 20;
/// Three characters of the member state, 16 of the card.
constexpr std::array<std::string_view, 2> driver_cards = {"D  1234567890123456",
                                                          "D  6543210987654321"};

}  // namespace

void SensedVehicle::join(Environment& environment) {
  using namespace cia407;
  environment.provide(callback<&SensedVehicle::gateway_hardware>(*this));
  environment.watch(gateway_);
  environment.provide(callback<&SensedVehicle::tachograph_hardware>(*this));
  environment.provide(callback<&SensedVehicle::tachograph_settings>(*this));
  environment.watch(tachograph_);
}

void SensedVehicle::act(const BusPress& press) {
  const unsigned number = press.number().value_or(0);
  if (press.what == "card" || press.what == "no-card") {
    has_card_.at(number - 1) = press.what == "card";
  } else if (press.what == "open" || press.what == "close") {
    doors_.at(number - 1).is_open = press.what == "open";
    gateway_->hardware_changed();
  } else if (press.what == "brake" || press.what == "release") {
    is_braking_ = press.what == "brake";
    gateway_->hardware_changed();
  }
}

std::optional<double> SensedVehicle::trip_begin() const {
  return tachograph_ == nullptr ? std::nullopt : std::optional(tachograph_->trip_begin_metres());
}

cia407::VehicleGatewayHardware SensedVehicle::gateway_hardware() {
  doors_.fill({.is_valid = true});
  return {.read = callback<&SensedVehicle::read>(*this)};
}

cia407::VehicleReading SensedVehicle::read() {
  cia407::VehicleReading reading;
  reading.speed_kmh = motion_.speed_kmh();
  reading.mileage_metres = motion_.metres();
  reading.bearing_degrees.value = motion_.receiver().heading;
  reading.ambient_celsius = ambient_celsius;
  reading.direction =
      console_.is_reverse() ? cia407::Direction::reverse : cia407::Direction::forward;
  reading.brake = is_braking_ ? cia407::BrakePedal::depressed : cia407::BrakePedal::released;
  reading.doors = doors_;
  // All doors are on the right, and a door that opens was released.
  reading.right_released = std::ranges::any_of(doors_, &cia407::DoorState::is_open);
  reading.local_time = motion_.utc();
  return reading;
}

cia407::TachographHardware SensedVehicle::tachograph_hardware() {
  return {.read = callback<&SensedVehicle::record>(*this)};
}

cia407::TachographSettings SensedVehicle::tachograph_settings() {
  return {.trip_begin_metres = kept_trip_begin_};
}

cia407::TachographReading SensedVehicle::record() {
  cia407::TachographReading reading = {.speed_kmh = motion_.speed_kmh(),
                                       .direction = cia407::Direction::forward,
                                       .distance_metres = motion_.metres(),
                                       .utc = motion_.utc()};
  for (std::size_t slot = 0; slot < reading.cards.size(); ++slot) {
    if (has_card_.at(slot)) reading.cards.at(slot) = driver_cards.at(slot);
  }
  return reading;
}

}  // namespace canvoy::tools
