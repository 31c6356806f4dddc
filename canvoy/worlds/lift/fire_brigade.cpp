#include "canvoy/worlds/lift/fire_brigade.hpp"

#include <utility>

namespace canvoy::lift {

FireBrigade::FireBrigade(FireBrigadeHands hands, const FireBrigadeOptions& options)
    : hands_(std::move(hands)), options_(options), random_(options.seed) {}

void FireBrigade::enter(Step step, Time now) {
  step_ = step;
  since_ = now;
}

void FireBrigade::begin(Time now) {
  gives_back_at_ = never;
  if (is_there()) return;
  hands_.alarm_key(true);
  enter(Step::called, now);
}

/// Those who never got in have the key of the fire floor alone.
void FireBrigade::end(Time now) {
  if (!is_there()) return;
  gives_back_at_ = now + gives_back_within;
  if (step_ == Step::called) give_back();
}

void FireBrigade::give_back() {
  let_go();
  hands_.car_key(false);
  hands_.alarm_key(false);
  rides_since_ = gives_back_at_ = never;
  step_ = Step::away;
}

bool FireBrigade::must_give_back(Time now, const FireBrigadeView& car) const {
  if (gives_back_at_ == never) return false;
  const bool is_out = step_ == Step::searching || step_ == Step::inside;
  return now >= gives_back_at_ || (is_out && car.is_open && car.floor == options_.fire_floor);
}

void FireBrigade::let_go() {
  hands_.door_close(false);
  hands_.door_open(false);
  if (target_ != no_floor) hands_.call(target_, false);
}

/// Another floor than this one, with the door closed: the call is held for a while. In the end, the
/// fire floor.
void FireBrigade::choose(Time now, FloorNumber here) {
  let_go();
  if (rides_since_ == never) rides_since_ = now;
  const auto others = static_cast<std::uint32_t>(options_.floors - 1);
  target_ = static_cast<FloorNumber>(1 + random_.below(others));
  if (target_ >= here) ++target_;
  if (gives_back_at_ != never) {
    target_ = options_.fire_floor;
    if (here == target_) return open(now);
  }
  hands_.call(target_, true);
  hands_.door_close(true);
  enter(Step::leaving, now);
}

void FireBrigade::open(Time now) {
  rides_since_ = never;
  hands_.door_open(true);
  enter(Step::opening, now);
}

void FireBrigade::look(Time now, const FireBrigadeView& car) {
  const Duration passed = now - since_;
  const bool is_at_loss = passed >= options_.patience;
  if (must_give_back(now, car)) {
    returns_ += now < gives_back_at_ ? 1U : 0U;
    return give_back();
  }
  switch (step_) {
    case Step::away:
      return;
    case Step::called:
      if (car.floor != options_.fire_floor || !car.is_open || !car.is_empty) return;
      hands_.car_key(true);
      return enter(Step::inside, now);
    case Step::inside:
      if (passed >= options_.gets_in) choose(now, options_.fire_floor);
      return;
    case Step::leaving:
      hands_.call(target_, false);
      if (car.floor == no_floor) {
        hands_.door_close(false);
        return enter(Step::riding, now);
      }
      if (is_at_loss) choose(now, car.floor);
      return;
    case Step::riding:
      if (car.floor == no_floor) since_ = now;
      if (car.floor == target_ && passed >= options_.looks_before_opening) return open(now);
      if (car.floor != no_floor && is_at_loss) choose(now, car.floor);
      return;
    case Step::opening:
      if (!car.is_open && !is_at_loss) return;
      hands_.door_open(false);
      floors_searched_ += car.is_open ? 1U : 0U;
      search_ = options_.search_least + std::chrono::seconds(random_.below(options_.search_more_s));
      return enter(Step::searching, now);
    case Step::searching:
      if (passed >= search_ || gives_back_at_ != never)
        choose(now, car.floor == no_floor ? target_ : car.floor);
      return;
  }
}

}  // namespace canvoy::lift
