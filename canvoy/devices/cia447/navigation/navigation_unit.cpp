#include "canvoy/devices/cia447/navigation/navigation_unit.hpp"

#include "canvoy/profiles/model/reactions.hpp"

namespace canvoy::cia447 {

namespace {

constexpr const ObjectInfo* navigation_commands[] = {&position_description_request_object,
                                                     &start_route_guidance_object,
                                                     &current_position_request_object};

constexpr unsigned position_pdo = 70;

constexpr const NamedValue& no_destination = distance_names[2];
static_assert(no_destination.name == "No destination selected");

template <class Handle>
bool says_failure(const Values& values, const Handle& handle) {
  return values[handle].raw() == code_meaning(place_of(handle), Meaning::failure);
}

}  // namespace

constexpr AccessHandlers NavigationUnit::hook_calls[] = {
    after_write<&NavigationUnit::position_written, gps_current_position_object>};
constexpr ServiceHandlers NavigationUnit::service_calls = {.reset = method<&NavigationUnit::reset>,
                                                           .hooks = hook_calls};

NavigationUnit::NavigationUnit(CarNetwork& network, const NavigationHardware& hardware,
                               const NavigationSettings& settings)
    : network_(network),
      hardware_(hardware),
      settings_(settings),
      values_(network.node().dictionary()),
      gps_(network, {.pdo_number = position_pdo,
                     .lost = callback<&NavigationUnit::position_lost>(*this),
                     .read = callback<&NavigationUnit::follow>(*this)}),
      commands_(network, navigation_commands,
                {.commanded = callback<&NavigationUnit::commanded>(*this),
                 .refuses = callback<&NavigationUnit::refuses>(*this)}),
      timer_(callback<&NavigationUnit::look>(*this)) {
  network.node().attach(service_);
}

/// Guidance continues, whatever happens to the network.
void NavigationUnit::reset(ResetScope) {
  described_ = {};
  wanted_ = {};
  look(network_.node().now());
}

// Position of the car.

void NavigationUnit::position_lost() {
  values_[gps_current_position_latitude] = std::nullopt;
  values_[gps_current_position_longitude] = std::nullopt;
  report_distance();
}

std::optional<GeoPosition> NavigationUnit::position() const {
  if (hardware_.position) return hardware_.position();
  return Request{.latitude = values_[gps_current_position_latitude].value(),
                 .longitude = values_[gps_current_position_longitude].value()}
      .position();
}

bool NavigationUnit::has_failed() const {
  return !hardware_.position && (says_failure(values_, gps_current_position_latitude) ||
                                 says_failure(values_, gps_current_position_longitude));
}

// Commands.

/// An invalid destination is refused.
AbortCode NavigationUnit::refuses(const Commanded& wanted) {
  const bool starts = wanted.is_for(start_route_guidance_start);
  return starts && !wanted_.position() ? AbortCode::device_state : AbortCode::none;
}

void NavigationUnit::commanded(const Commanded& wanted) {
  if (wanted.is_for(position_description_request_latitude)) {
    described_.latitude = values_[position_description_request_latitude].value();
    describe();
  } else if (wanted.is_for(position_description_request_longitude)) {
    described_.longitude = values_[position_description_request_longitude].value();
    describe();
  } else if (wanted.is_for(start_route_guidance_position_latitude)) {
    wanted_.latitude = values_[start_route_guidance_position_latitude].value();
  } else if (wanted.is_for(start_route_guidance_position_longitude)) {
    wanted_.longitude = values_[start_route_guidance_position_longitude].value();
  } else if (wanted.is_for(start_route_guidance_start)) {
    start(wanted.as<StartGuidance>() == StartGuidance::with_interrupting);
  } else if (wanted.is_for(current_position_request)) {
    report_current_position();
  }
}

void NavigationUnit::describe() {
  const auto position = described_.position();
  if (!position) return;
  const NamedPlace* place = hardware_.gazetteer.nearest(*position);
  values_[position_description_city] = place != nullptr ? place->city : "";
  values_[position_description_street] = place != nullptr ? place->street : "";
  values_[position_description_country] = place != nullptr ? place->country : "";
}

const NamedPlace* NavigationUnit::here() const {
  const auto position_now = position();
  return position_now ? hardware_.gazetteer.nearest(*position_now) : nullptr;
}

void NavigationUnit::report_current_position() {
  const NamedPlace* place = here();
  values_[current_position_city] = place != nullptr ? place->city : "";
  values_[current_position_street] = place != nullptr ? place->street : "";
  values_[current_position_country] = place != nullptr ? place->country : "";
}

// Guidance.

void NavigationUnit::start(bool interrupts) {
  const auto target = wanted_.position();
  if (!target) return;
  if (destination_ && !interrupts) {
    waiting_ = target;
  } else {
    select(*target);
  }
}

void NavigationUnit::select(const GeoPosition& destination) {
  destination_ = destination;
  waiting_.reset();
  hardware_.guide(&*destination_);
  follow();
}

void NavigationUnit::cancel() {
  if (!destination_) return;
  destination_.reset();
  waiting_.reset();
  hardware_.guide(nullptr);
  report_distance();
}

void NavigationUnit::look(Time now) {
  network_.node().timers().arm(timer_, now + settings_.period);
  follow();
}

void NavigationUnit::follow() {
  const auto here = position();
  while (here && destination_ && metres_between(*here, *destination_) <= settings_.arrival) {
    destination_ = std::exchange(waiting_, std::nullopt);
    hardware_.guide(destination_ ? &*destination_ : nullptr);
  }
  report_distance();
}

std::optional<double> NavigationUnit::distance() const {
  const auto here = position();
  if (!here || !destination_) return std::nullopt;
  return hardware_.road ? hardware_.road(*here, *destination_)
                        : metres_between(*here, *destination_);
}

void NavigationUnit::report_distance() {
  const auto told = values_[distance_to_selected_destination];
  const auto set = [&](std::int64_t code) { told.set_raw(static_cast<std::uint16_t>(code)); };
  const auto metres = distance();
  if (!destination_) {
    set(no_destination.first);
  } else if (has_failed()) {
    set(code_meaning(place_of(distance_to_selected_destination), Meaning::failure).value_or(0));
  } else if (!metres) {
    told = std::nullopt;
  } else {
    constexpr double metres_per_kilometre = 1000;
    told = *metres / metres_per_kilometre;
  }
}

}  // namespace canvoy::cia447
