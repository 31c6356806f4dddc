#include "canvoy/worlds/lift/crowd_watch.hpp"

namespace canvoy::lift {

CrowdWatch::CrowdWatch(const Building& building, const PassengerOptions& people) {
  for (const LiftDesign& lift : building.lifts) {
    places_ += lift.car.rated_persons * people.fill_share;
  }
}

void CrowdWatch::look(Time now, bool is_hindered, std::size_t waiting) {
  constexpr Duration saturated_after = 5min;
  constexpr Duration clears_within = 30min;
  if (is_hindered) hindered_at_ = now;
  const auto people = static_cast<double>(waiting);
  const bool may_be_left = is_hindered || now - hindered_at_ < clears_within;
  is_left_ = (is_hindered || is_left_) && may_be_left && people > places_;
  if (is_hindered || is_left_) excused_at_ = now;
  if (is_hindered || is_left_ || people <= 2 * places_) not_crowded_at_ = now;
  is_saturated_ = is_saturated_ || now - not_crowded_at_ >= saturated_after;
}

}  // namespace canvoy::lift
