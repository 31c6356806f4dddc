// The terminal of the taxi: the meter shows the fare on display 1, the driver's unit on display 2
// where the car is and goes; and what is read there is judged.
#include <algorithm>
#include <cmath>
#include <string>

#include "canvoy/sim/taxi/screen_text.hpp"
#include "canvoy/sim/taxi/taxi_network.hpp"

namespace canvoy::taxi {

namespace {

constexpr std::size_t fare_screen = 0;
constexpr std::size_t place_screen = 1;
/// How far a car goes from when a receiver looks until somebody reads where it is.
constexpr double stale_metres = 150;
/// The distance to a destination is told in hundreds of metres.
constexpr double told_step = 100;
constexpr double half_a_cent = 5;  ///< in 0,001 of the currency unit

}  // namespace

cia447::TerminalHardware TaxiNetwork::terminal_hardware() {
  return {.show = Callback<void(const cia447::DisplayContent&)>::to<&TaxiNetwork::terminal_shows>(
              *this)};
}

void TaxiNetwork::terminal_shows(const cia447::DisplayContent& content) {
  const bool is_first = content.display == cia447::TerminalDisplay::display_1;
  if (is_first && sabotage_.cuts_screen) return;
  screens_[is_first ? fare_screen : place_screen] = {
      content.holder, content.is_on ? std::string(content.text) : std::string()};
}

cia447::NavigationHardware TaxiNetwork::navigation_hardware() {
  return {.gazetteer = cia447::Gazetteer(options_.places)};
}

void TaxiNetwork::is_network_of_navigation(cia447::CarNetwork& network, Node& node) {
  if (trip_reader_id() == navigation_id) is_network_of_reader(network, node);
}

/// Where the car is and goes, and how far: three lines.
cia447::TerminalSettings TaxiNetwork::terminal_settings() {
  return {.display_2 = {.lines = 3, .columns = 16, .characters = 48}};
}
FareDisplaySettings TaxiNetwork::fare_display_settings() {
  return {.terminal = terminal_id, .currency = options_.meter.currency};
}
RouteDisplaySettings TaxiNetwork::route_display_settings() {
  return {.terminal = terminal_id, .navigation = navigation_id};
}

cia447::GpsReading TaxiNetwork::gps_reading() {
  cia447::GpsReading reading = drive_.receiver();
  if (!sabotage_.blinds_receiver) {
    return fix_is_lost_ ? cia447::GpsReading{.fix = cia447::GpsFix::none} : reading;
  }
  const cia447::GeoPosition start = car::Drive::town_position(0);
  reading.latitude = start.latitude;
  reading.longitude = start.longitude;
  return reading;
}

/// The driver types it. Where a drive that was recorded ends, nobody has said.
void TaxiNetwork::choose_destination() {
  if (drive_.has_record()) return;
  destination_ = car::Drive::town_position(drive_.metres() + shift_.to_go());
  if (route_display_ != nullptr) route_display_->guide(*destination_);
  world_.touched(driver_id - SlotIndex{1});
}

/// No object ends a guidance: the driver does so at the navigation system.
void TaxiNetwork::arrive() {
  destination_.reset();
  if (route_display_ != nullptr) route_display_->arrive();
  world_.touched(driver_id - SlotIndex{1});
  if (node(navigation_id).is_powered()) navigation_->cancel();
  world_.touched(navigation_id - SlotIndex{1});
}

void TaxiNetwork::judge_terminal(Time now) {
  const auto is_awake = [&](NodeId id) {
    return node(id).is_powered() && node(id).device().sleep().state() == cia447::SleepState::awake;
  };
  const auto judge = [&](std::size_t screen, bool is_judged, bool is_right) {
    if (!is_judged || is_right) screen_is_right_at_[screen] = now;
    screen_was_wrong_[screen] =
        std::max(screen_was_wrong_[screen], now - screen_is_right_at_[screen]);
  };
  const bool can_be_read = !is_excused(now) && is_awake(terminal_id);
  judge(fare_screen, can_be_read && is_awake(taximeter_id), fare_is_right());
  judge(place_screen, can_be_read && is_awake(driver_id) && is_awake(navigation_id),
        place_is_right());
}

/// It is read in hundredths.
bool TaxiNetwork::fare_is_right() const {
  const std::optional<double> fare = read_fare(screens_[fare_screen].text);
  const bool has_passengers =
      display_.state == cia447::Taximeter::hired || display_.state == cia447::Taximeter::stopped;
  if (!has_passengers) return !fare.has_value();
  return fare && std::abs(*fare - display_.trip.fare) <= half_a_cent;
}

/// A place of this name is the nearest one there, or not much farther.
bool TaxiNetwork::is_near(std::string_view street, const cia447::GeoPosition& position) const {
  const cia447::NamedPlace* nearest = cia447::Gazetteer(options_.places).nearest(position);
  if (nearest == nullptr) return true;
  return std::ranges::any_of(options_.places, [&](const cia447::NamedPlace& place) {
    return place.street == street &&
           cia447::metres_between(position, place.position) <=
               cia447::metres_between(position, nearest->position) + 2 * stale_metres;
  });
}

bool TaxiNetwork::place_is_right() const {
  const std::string& text = screens_[place_screen].text;
  const cia447::GpsReading truth = drive_.receiver();
  const bool is_somewhere = truth.latitude && truth.longitude;
  const cia447::GeoPosition here = {truth.latitude.value_or(0), truth.longitude.value_or(0)};
  const std::string_view street = read_street(text);
  // Who does not know where he is may say nothing, but nothing wrong.
  const bool is_dark = fix_is_lost_ && street.empty();
  if (is_somewhere && !is_dark && !is_near(street, here)) return false;
  if (!destination_) return read_destination(text).empty();
  if (!is_near(read_destination(text), *destination_)) return false;
  const std::optional<double> to_go = read_metres_to_go(text);
  const double truly_to_go = cia447::metres_between(here, *destination_);
  return !to_go || std::abs(*to_go - truly_to_go) <= stale_metres + told_step;
}

}  // namespace canvoy::taxi
