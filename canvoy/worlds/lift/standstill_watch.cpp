#include "canvoy/worlds/lift/standstill_watch.hpp"

#include <algorithm>
#include <cmath>

namespace canvoy::lift {

void StandstillWatch::look(const LiftNetworkSnapshot& now) {
  const bool is_wanted = now.waiting + now.riding != 0;
  if (!is_wanted || moves(before_, now)) moved_at_ = now.at;
  longest_ = std::max(longest_, now.at - moved_at_);
  before_ = now;
}

bool StandstillWatch::moves(const LiftNetworkSnapshot& before, const LiftNetworkSnapshot& now) {
  constexpr double still_m = 0.001;
  if (before.riding != now.riding || before.served != now.served) return true;
  if (before.lifts.size() != now.lifts.size()) return true;
  for (std::size_t i = 0; i < now.lifts.size(); ++i) {
    const LiftSnapshot& was = before.lifts[i];
    const LiftSnapshot& is = now.lifts[i];
    if (std::abs(was.position_m - is.position_m) > still_m) return true;
    for (std::size_t door = 0; door < is.doors.size(); ++door) {
      if (was.doors[door].open_share != is.doors[door].open_share) return true;
    }
  }
  return false;
}

}  // namespace canvoy::lift
