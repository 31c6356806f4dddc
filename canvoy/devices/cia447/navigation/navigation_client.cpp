#include "canvoy/devices/cia447/navigation/navigation_client.hpp"

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"
#include "canvoy/profiles/model/physical.hpp"

namespace canvoy::cia447 {

namespace {

/// As in 60C1h and 60C3h (errata Z36).
template <class Handle>
std::uint32_t code_of_angle(const Handle& /*handle*/, double degrees) {
  using Place = typename Handle::Place;
  const auto code = raw_from_physical(Place::value, Place::bits, degrees);
  constexpr std::uint32_t do_not_care = 0xFFFF'FFFF;
  return code ? static_cast<std::uint32_t>(*code) : do_not_care;
}

/// An entry, and the number of bytes that are written to it; 0: it is read.
struct Question {
  std::uint16_t index;
  std::uint8_t sub;
  std::uint8_t written = 0;
};
template <class Handle>
constexpr Question question(const Handle& handle, std::uint8_t written = 0) {
  const FieldPlace place = place_of(handle);
  return {place.index, place.sub, written};
}
/// In the order of the steps.
constexpr Question questions[] = {question(start_route_guidance_position_latitude, 4),
                                  question(start_route_guidance_position_longitude, 4),
                                  question(start_route_guidance_start, 1),
                                  question(position_description_request_latitude, 4),
                                  question(position_description_request_longitude, 4),
                                  question(position_description_street),
                                  question(current_position_request, 1),
                                  question(current_position_city),
                                  question(current_position_street),
                                  question(distance_to_selected_destination)};

}  // namespace

constexpr ServiceHandlers NavigationClient::service_calls = {.reset =
                                                                 method<&NavigationClient::reset>};

NavigationClient::NavigationClient(CarNetwork& network, const NavigationClientSettings& settings)
    : network_(network),
      settings_(settings),
      client_(network.node(), mesh_channel_to(settings.navigation)),
      timer_(callback<&NavigationClient::begin>(*this)) {
  next_lost_ = network.on_lost(callback<&NavigationClient::lost>(*this));
  network.node().attach(service_);
}

void NavigationClient::reset(ResetScope) {
  client_.cancel();
  step_ = Step::none;
  forget_answers();
  network_.node().timers().arm(timer_, network_.node().now() + settings_.period);
}

void NavigationClient::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  if (node != settings_.navigation) return;
  forget_answers();
  settings_.changed();
}

/// The system has also lost the destination.
void NavigationClient::forget_answers() {
  is_guided_ = is_described_ = false;
  city_ = street_ = destination_street_ = {};
  metres_.reset();
}

void NavigationClient::guide(const GeoPosition& destination) {
  destination_ = destination;
  is_guided_ = is_described_ = false;
  destination_street_ = {};
}

void NavigationClient::forget_destination() {
  destination_.reset();
  destination_street_ = {};
}

void NavigationClient::begin(Time now) {
  network_.node().timers().arm(timer_, now + settings_.period);
  if (client_.busy()) return;
  network_.watch(settings_.navigation);
  const bool has_to_tell = destination_ && !(is_guided_ && is_described_);
  if (!has_to_tell) return ask(Step::ask_position);
  telling_ = *destination_;
  const bool was_guided = is_guided_;
  // Another destination that is set meanwhile is sent in the next round.
  is_guided_ = is_described_ = true;
  ask(was_guided ? Step::describe_latitude : Step::guide_latitude);
}

void NavigationClient::ask(Step step) {
  step_ = step;
  const Question& question = questions[static_cast<unsigned>(step)];
  const NodeId server = settings_.navigation;
  const auto done = SdoClient::Done::to<&NavigationClient::answered>(*this);
  AbortCode refused = AbortCode::none;
  if (question.written == 0) {
    refused =
        client_.upload(server, question.index, question.sub, name_.bytes, done, settings_.time_out);
  } else {
    store(value_.data(), value_to_write());
    refused = client_.download(server, question.index, question.sub,
                               std::span(value_).first(question.written), done, settings_.time_out);
  }
  if (refused != AbortCode::none) answered(refused);
}

std::uint32_t NavigationClient::value_to_write() const {
  switch (step_) {
    case Step::guide_latitude:
    case Step::describe_latitude:
      return code_of_angle(start_route_guidance_position_latitude, telling_.latitude);
    case Step::guide_longitude:
    case Step::describe_longitude:
      return code_of_angle(start_route_guidance_position_longitude, telling_.longitude);
    case Step::guide_start:
      return static_cast<std::uint32_t>(StartGuidance::with_interrupting);
    default:
      // Other bits of the request are reserved.
      return 0xFE | static_cast<std::uint32_t>(PositionRequest::read);
  }
}

void NavigationClient::answered(SdoClient::Outcome outcome) {
  take(outcome);
  const Step next = after(outcome);
  if (next == Step::none) return end();
  ask(next);
}

void NavigationClient::take(SdoClient::Outcome outcome) {
  name_.length = outcome ? *outcome : 0;
  if (step_ == Step::destination_street && is_described_ && destination_)
    destination_street_ = name_;
  if (step_ == Step::city) city_ = name_;
  if (step_ == Step::street) street_ = name_;
  if (step_ == Step::how_far) take_distance(name_.length);
}

void NavigationClient::take_distance(std::size_t length) {
  constexpr double metres_a_kilometre = 1000;
  using Place = std::remove_cvref_t<decltype(distance_to_selected_destination)>::Place;
  const Reading reading = read_value(Place::entry, std::span(name_.bytes).first(length));
  metres_.reset();
  if (reading.kind == Reading::Kind::number) metres_ = reading.number * metres_a_kilometre;
}

/// A system that does not answer is not read further in this round, and gets the destination again
/// in the next; one that refuses a destination may still know the position of the car.
NavigationClient::Step NavigationClient::after(SdoClient::Outcome outcome) {
  const bool tells = step_ < Step::ask_position;
  const bool is_refused =
      !outcome && !outcome.is_silence() && outcome.abort() != AbortCode::toggle_bit;
  if (!outcome && tells) is_guided_ = is_described_ = false;
  if (!outcome && !is_refused) {
    forget_answers();
    return Step::none;
  }
  if (is_refused && tells) return Step::ask_position;
  return static_cast<Step>(static_cast<unsigned>(step_) + 1);
}

void NavigationClient::end() {
  step_ = Step::none;
  settings_.changed();
}

}  // namespace canvoy::cia447
