#include "canvoy/worlds/bus_line/demand.hpp"

namespace canvoy::bus_line {

bool Demand::add(const Row& row) {
  return rows_.try_emplace(Key(row.stop, row.is_backward, row.hour), row.exchange).second;
}

Demand::Exchange Demand::at(std::size_t stop, bool is_backward, unsigned hour) const {
  for (const Key& key : {Key(stop, is_backward, hour), Key(stop, is_backward, std::nullopt),
                         Key(stop, std::nullopt, hour), Key(stop, std::nullopt, std::nullopt)}) {
    if (const auto found = rows_.find(key); found != rows_.end()) return found->second;
  }
  return {};
}

}  // namespace canvoy::bus_line
