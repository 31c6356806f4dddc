#include "canvoy/tools/page/worst_times.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

const WorstTimes::Known* WorstTimes::find(std::size_t place, const Judged& judged) const {
  const auto is_it = [&](const Known& known) {
    return known.kind == judged.kind && known.part == judged.part && known.fault == judged.fault;
  };
  if (place < known_.size() && is_it(known_[place])) return &known_[place];
  const auto found = std::ranges::find_if(known_, is_it);
  return found == known_.end() ? nullptr : &*found;
}

void WorstTimes::look(Time now, std::span<const Judged> all) {
  std::vector<Known> seen;
  seen.reserve(all.size());
  for (const Judged& each : all) {
    const Known* const known = find(seen.size(), each);
    const bool is_worse = each.is_decided() && (known == nullptr || each.worst > known->worst);
    const double worst = each.is_decided() ? each.worst : -1;
    seen.push_back(
        {each.kind, each.part, each.fault, worst, is_worse || known == nullptr ? now : known->at});
  }
  known_ = std::move(seen);
}

void WorstTimes::add_to(nlohmann::ordered_json& invariants, std::span<const Judged> all) const {
  if (invariants.size() != all.size()) return;
  for (std::size_t i = 0; i < all.size(); ++i) {
    invariants[i]["words"] = all[i].kind->text;
    const Known* const known = find(i, all[i]);
    if (known != nullptr && all[i].is_decided()) {
      invariants[i]["worst_at"] = in_seconds(known->at - Time{});
    }
  }
}

}  // namespace canvoy::tools
