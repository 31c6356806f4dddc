#include "canvoy/canopen/emergency/collision_watch.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy {

namespace {

constexpr std::uint8_t cob_id_sub = 1;

enum Place : std::size_t { emergency_place, sdo_place, heartbeat_place };

}  // namespace

constexpr AccessHandlers CollisionWatch::hook_calls[] = {
    {.first = object_index::cob_id_emergency,
     .last = object_index::cob_id_emergency,
     .after_write = method<&CollisionWatch::written>},
    {.first = object_index::tpdo_parameter,
     .last = object_index::tpdo_parameter_last,
     .sub_first = cob_id_sub,
     .sub_last = cob_id_sub,
     .after_write = method<&CollisionWatch::written>}};
constexpr ServiceHandlers CollisionWatch::service_calls = {.reset = method<&CollisionWatch::reset>,
                                                           .hooks = hook_calls};

CollisionWatch::CollisionWatch(Node& node, std::span<Slot> slots, std::uint16_t first_tpdo)
    : node_(node), slots_(slots), first_tpdo_(first_tpdo) {
  std::ranges::fill(slots_, Slot{0});
  node.attach(service_);
}

void CollisionWatch::reset(ResetScope /*scope*/) {
  collided_ = 0;
  node_.timers().disarm(timer_);
  const bool has_id = is_node_id(node_.id());
  const auto of_node = [&](std::uint16_t function) {
    return has_id ? static_cast<std::uint16_t>(function + node_.id()) : std::uint16_t{0};
  };
  const CobId emergencies{node_.dictionary().word(object_index::cob_id_emergency, 0, CobId::bit31)};
  watch_cob_id(slots_[emergency_place], has_id ? emergencies : CobId{});
  listen(slots_[sdo_place], of_node(can_id::sdo_response));
  listen(slots_[heartbeat_place], of_node(can_id::error_control));
  for (std::size_t place = ids_beside_tpdos; place < slots_.size(); ++place) watch_tpdo(place);
}

void CollisionWatch::written(const Entry& entry, Source /*source*/) {
  if (entry.index == object_index::cob_id_emergency) {
    return watch_cob_id(slots_[emergency_place], CobId{entry.word()});
  }
  const unsigned first = object_index::tpdo_parameter + first_tpdo_ - 1U;
  if (entry.index >= first) watch_tpdo(ids_beside_tpdos + entry.index - first);
}

void CollisionWatch::watch_tpdo(std::size_t place) {
  if (place >= slots_.size()) return;
  const auto index = static_cast<std::uint16_t>(object_index::tpdo_parameter + first_tpdo_ - 1U +
                                                place - ids_beside_tpdos);
  watch_cob_id(slots_[place], CobId{node_.dictionary().word(index, cob_id_sub, CobId::bit31)});
}

void CollisionWatch::watch_cob_id(Slot& slot, CobId cob_id) {
  const bool is_sent = cob_id.valid() && cob_id.is_base_frame() && is_node_id(node_.id());
  listen(slot, is_sent ? static_cast<std::uint16_t>(cob_id.can_id()) : std::uint16_t{0});
}

void CollisionWatch::listen(Slot& slot, std::uint16_t can_id) {
  const auto receiver = Router::Receiver::to<&CollisionWatch::heard>(*this);
  if (slot == can_id) return;
  if (slot != 0) node_.router().remove(std::exchange(slot, Slot{0}), receiver);
  if (can_id != 0 && node_.router().add(can_id, receiver)) slot = can_id;
}

bool CollisionWatch::is_received_by_rpdo(std::uint32_t can_id) const {
  for (std::uint16_t index = object_index::rpdo_parameter;
       index <= object_index::rpdo_parameter_last; ++index) {
    const CobId cob_id{node_.dictionary().word(index, cob_id_sub, CobId::bit31)};
    if (cob_id.valid() && cob_id.is_base_frame() && cob_id.can_id() == can_id) return true;
  }
  return false;
}

void CollisionWatch::heard(const Frame& frame, Time now) {
  if (collided_ != frame.id && is_received_by_rpdo(frame.id)) return;
  node_.timers().arm(timer_, now + quiet_time);
  if (collided_ != 0) return;
  collided_ = static_cast<std::uint16_t>(frame.id);
  node_.raise(cob_id_collision(collided_));
}

void CollisionWatch::is_quiet(Time /*now*/) {
  node_.clear(cob_id_collision(std::exchange(collided_, std::uint16_t{0})));
}

}  // namespace canvoy
