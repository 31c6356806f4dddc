#include "canvoy/worlds/lift/safety_chain.hpp"

namespace canvoy::lift {

void SafetyChain::look(const SafetySight& sight) {
  const bool is_in_zone = sight.from_floor_m <= design_.door_zone_m;
  const bool levels = is_in_zone && sight.speed_m_s <= design_.levelling_speed_m_s;
  doors_are_free_ = !sight.doors_are_locked && !levels;
  const bool leaves = was_in_zone_ && !is_in_zone && sight.is_a_door_open;
  was_in_zone_ = is_in_zone;
  const bool is_beyond = sight.beyond_m > design_.final_limit_m;
  const bool passes_limit = is_beyond && !was_beyond_;
  was_beyond_ = is_beyond;
  brake_slips_ = brake_slips_ || sight.brake_slips;
  if (trip_ != Trip::none) return;
  if (sight.speed_m_s > design_.rated_speed_m_s * design_.governor_share) {
    trip_ = Trip::overspeed;
  } else if (leaves) {
    trip_ = Trip::unintended_movement;
  } else if (passes_limit) {
    trip_ = Trip::final_limit;
  } else if (sight.gear_is_caught) {
    trip_ = Trip::gear;
  }
}

}  // namespace canvoy::lift
