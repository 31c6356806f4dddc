// The terminal of the taxi: the meter shows the fare on display 1, the navigation system where the
// car is on display 2; and what is read there is judged.
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
  navigation_screen_.emplace(
      network, cia447::DisplayWriter::Settings{.terminal = terminal_id,
                                               .display = cia447::TerminalDisplay::display_2});
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

/// Where a drive that was recorded ends, nobody has said.
void TaxiNetwork::choose_destination() {
  if (drive_.has_record() || !node(navigation_id).is_powered()) return;
  navigation_->select(car::Drive::town_position(drive_.metres() + shift_.to_go()));
  world_.touched(navigation_id - SlotIndex{1});
}

/// The navigation system looks each second.
void TaxiNetwork::tell_terminal(Time now) {
  if ((now - Time{}) % 1s != Duration{} || !navigation_screen_) return;
  if (!node(navigation_id).is_powered()) return;
  navigation_screen_->show(place_text(navigation_->here(), navigation_->distance()));
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
  const std::optional<double> fare = read_fare(screens_[fare_screen].text);
  const bool has_passengers =
      display_.state == cia447::Taximeter::hired || display_.state == cia447::Taximeter::stopped;
  // It is read in hundredths.
  const bool is_fare = fare && std::abs(*fare - display_.trip.fare) <= half_a_cent;
  judge(fare_screen, can_be_read && is_awake(taximeter_id),
        has_passengers ? is_fare : !fare.has_value());

  const cia447::GpsReading truth = drive_.receiver();
  const bool is_somewhere = truth.latitude && truth.longitude;
  const cia447::GeoPosition here = {truth.latitude.value_or(0), truth.longitude.value_or(0)};
  const cia447::NamedPlace* nearest = cia447::Gazetteer(options_.places).nearest(here);
  const std::string_view street = read_street(screens_[place_screen].text);
  // Who does not know where he is may say nothing, but nothing wrong.
  const bool is_dark = fix_is_lost_ && street.empty();
  const bool is_right =
      is_dark || (nearest != nullptr &&
                  std::ranges::any_of(options_.places, [&](const cia447::NamedPlace& place) {
                    return place.street == street &&
                           cia447::metres_between(here, place.position) <=
                               cia447::metres_between(here, nearest->position) + 2 * stale_metres;
                  }));
  judge(place_screen, can_be_read && is_awake(navigation_id) && is_somewhere && nearest != nullptr,
        is_right);
}

}  // namespace canvoy::taxi
