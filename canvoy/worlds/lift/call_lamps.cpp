#include "canvoy/worlds/lift/call_lamps.hpp"

#include <algorithm>
#include <bit>

namespace canvoy::lift {

CallLamps::Change CallLamps::set(Time now, LiftNumber lift, const CallKey& call, bool is_lit) {
  unsigned& on = lit_[call];
  const bool was_lit = on != 0;
  const unsigned bit = 1U << (lift - 1U);
  on = is_lit ? on | bit : on & ~bit;
  const bool now_lit = on != 0;
  if (!now_lit) lit_.erase(call);
  if (was_lit == now_lit) return Change::none;
  if (now_lit) lit_at_[call] = now;
  return now_lit ? Change::lit : Change::dark;
}

Time CallLamps::lit_at(const CallKey& call) const {
  const auto found = lit_at_.find(call);
  return found == lit_at_.end() ? never : found->second;
}

bool CallLamps::are_shared() const {
  return std::ranges::any_of(lit_, [](const auto& call) {
    return call.first.lift == 0 && std::popcount(call.second) > 1;
  });
}

std::vector<FloorNumber> CallLamps::car_calls(LiftNumber lift) const {
  std::vector<FloorNumber> floors;
  for (const auto& [call, on_lifts] : lit_) {
    if (call.lift == lift) floors.push_back(call.floor);
  }
  return floors;
}

}  // namespace canvoy::lift
