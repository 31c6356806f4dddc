#include "canvoy/tools/device/car/car_driver.hpp"

#include <algorithm>
#include <initializer_list>

#include "canvoy/profiles/cia447/car_handles.hpp"

namespace canvoy::tools {

namespace {

constexpr double idle_revolutions = 800;
/// Revolutions per minute for each m/s in first gear; each higher gear takes its fraction of that.
constexpr double first_gear_revolutions = 450;
constexpr double shift_revolutions = 2800;
constexpr unsigned gear_max = 6;
constexpr double idle_consumption = 0.0005;   ///< l/s: about 1.8 l per hour
constexpr double driving_consumption = 7e-5;  ///< l/m: 7 l per 100 km

double revolutions_in(unsigned gear, double speed) {
  return std::max(idle_revolutions, speed * first_gear_revolutions / gear);
}
/// The lowest gear with a permitted engine speed.
unsigned gear_for(double speed) {
  unsigned gear = 1;
  while (gear < gear_max && revolutions_in(gear, speed) > shift_revolutions) ++gear;
  return gear;
}

bool is_any_of(cia447::SelectorLever lever, std::initializer_list<cia447::SelectorLever> levers) {
  return std::ranges::find(levers, lever) != levers.end();
}

}  // namespace

void CarDriver::set_by_hand(const cia447::FieldPlace& status) {
  if (!is_by_hand(status)) by_hand_.push_back(status);
}

bool CarDriver::is_by_hand(const cia447::FieldPlace& status) const {
  return std::ranges::find(by_hand_, status) != by_hand_.end();
}

template <class Handle, class State>
void CarDriver::say(const Handle& status, State state) {
  if (!is_by_hand(cia447::place_of(status))) gateway_->report(status, state);
}

void CarDriver::get_ready() {
  using namespace cia447;
  if (gateway_ == nullptr || is_ready_) return;
  is_ready_ = true;
  say(occupant_classification_status_driver, Signal::yes);
  say(buckle_switch_status_driver, Signal::yes);
  say(ignition_switch_status_lock, Signal::yes);
  say(ignition_switch_status_accessory, Signal::yes);
  say(ignition_switch_status_on, Signal::yes);
  say(central_locking_system_status, Locking::internal);
  say(engine_status, Engine::running);
  say(transmission_selector_lever_position, SelectorLever::driving);
  say(parking_brake, Signal::no);
}

bool CarDriver::runs() const {
  using namespace cia447;
  return gateway_ != nullptr && gateway_->power_train().is(engine_status, Engine::running);
}

std::string CarDriver::missing() const {
  using namespace cia447;
  if (gateway_ == nullptr) return "";
  const Switching& train = gateway_->power_train();
  std::string text;
  const auto add = [&text](bool is_missing, const char* what) {
    if (is_missing) text += (text.empty() ? "" : ", ") + std::string(what);
  };
  add(!gateway_->body().is(ignition_switch_status_on, Signal::yes), "the ignition is off");
  add(!train.is(engine_status, Engine::running), "the engine does not run");
  const auto lever =
      static_cast<SelectorLever>(train.actual(place_of(transmission_selector_lever_position)));
  add(is_any_of(lever,
                {SelectorLever::parking, SelectorLever::neutral, SelectorLever::intermediate}),
      "the lever is in no driving position");
  add(train.is(parking_brake, Signal::yes), "the parking brake is engaged");
  return text;
}

void CarDriver::follow(double speed, bool is_braking) {
  using namespace cia447;
  speed_ = speed;
  if (gateway_ == nullptr) return;
  const unsigned gear = gear_for(speed);
  revolutions_ = runs() ? revolutions_in(gear, speed) : 0;
  if (!is_ready_) return;
  // A driver who stands with an automatic gear engaged holds the brake.
  say(car_light_status_brake, is_braking || speed <= 0 ? Signal::on : Signal::off);
  say(engaged_gear, static_cast<Gear>(gear));
}

double CarDriver::fuel_consumption() const {
  return runs() ? idle_consumption + driving_consumption * speed_ : 0;
}

}  // namespace canvoy::tools
