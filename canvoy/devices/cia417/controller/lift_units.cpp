#include "canvoy/devices/cia417/controller/lift_units.hpp"

#include <algorithm>
#include <bitset>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::cia417 {

namespace {

/// Fills 1016h from its first sub-index on.
class HeartbeatTimes {
 public:
  explicit HeartbeatTimes(Dictionary& dictionary)
      : dictionary_(dictionary),
        sub_max_(static_cast<unsigned>(dictionary.number(object_index::heartbeat_consumers, 0))) {}

  void add(NodeId id, std::uint16_t time_ms) {
    if (!is_node_id(id) || known_[id] || sub_ >= sub_max_) return;
    known_[id] = true;
    ++sub_;
    const std::uint32_t value = static_cast<std::uint32_t>(id) << 16 | time_ms;
    dictionary_.set_number(object_index::heartbeat_consumers, static_cast<std::uint8_t>(sub_),
                           value);
  }

 private:
  Dictionary& dictionary_;
  unsigned sub_max_;
  unsigned sub_ = 0;
  std::bitset<node_id_max + 1> known_;
};

}  // namespace

bool LiftUnits::has(NodeId id) const {
  const auto is_among = [id](const auto& ids) {
    return std::ranges::find(ids, id) != std::ranges::end(ids);
  };
  return id == drive || id == position_unit || id == load_unit || is_among(door_units) ||
         is_among(light_barrier_units);
}

void watch(Dictionary& dictionary, const LiftUnits& units) {
  HeartbeatTimes times(dictionary);
  const auto add = [&](NodeId unit) {
    times.add(unit, units.unit_time_ms);
    if (is_node_id(unit)) {
      dictionary.set_number(object_index::emergency_consumers, unit, can_id::emergency + unit);
    }
  };
  for (const NodeId unit : {units.drive, units.position_unit, units.load_unit}) add(unit);
  for (const NodeId unit : units.door_units) add(unit);
  for (const NodeId unit : units.light_barrier_units) add(unit);
  for (const NodeId other : units.others) times.add(other, units.other_time_ms);
}

}  // namespace canvoy::cia417
