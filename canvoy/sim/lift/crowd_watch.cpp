#include "canvoy/sim/lift/crowd_watch.hpp"

namespace canvoy::lift {

CrowdWatch::CrowdWatch(const Building& building, const PassengerOptions& people) {
  for (const LiftDesign& lift : building.lifts) {
    places_ += lift.car.rated_persons * people.fill_share;
  }
}

void CrowdWatch::look(Time now, bool is_hindered, std::size_t waiting) {
  constexpr Duration saturated_after = 5min;
  if (is_hindered) hindered_at_ = now;
  const bool is_crowded = static_cast<double>(waiting) > 2 * places_;
  if (is_hindered || !is_crowded) not_crowded_at_ = now;
  is_saturated_ = is_saturated_ || now - not_crowded_at_ >= saturated_after;
}

}  // namespace canvoy::lift
