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
    {.first = object_index::rpdo_parameter,
     .last = object_index::rpdo_parameter_last,
     .sub_first = cob_id_sub,
     .sub_last = cob_id_sub,
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
  listen();
}

void CollisionWatch::written(const Entry& /*entry*/, Source /*source*/) {
  listen();
}

void CollisionWatch::listen() {
  const CanIds received = received_by_rpdos();
  const bool has_id = is_node_id(node_.id());
  for (std::size_t place = 0; place < slots_.size(); ++place) {
    const std::uint16_t can_id = has_id ? sent_at(place) : std::uint16_t{0};
    listen(slots_[place], received[can_id] ? std::uint16_t{0} : can_id);
  }
}

void CollisionWatch::listen(Slot& slot, std::uint16_t can_id) {
  const auto receiver = Router::Receiver::to<&CollisionWatch::heard>(*this);
  if (slot == can_id) return;
  if (slot != 0) node_.router().remove(std::exchange(slot, Slot{0}), receiver);
  if (can_id != 0 && node_.router().add(can_id, receiver)) slot = can_id;
}

/// The CAN-ID with which the node sends what has this place among the slots; 0: none.
std::uint16_t CollisionWatch::sent_at(std::size_t place) const {
  const auto of_node = [this](std::uint16_t function) {
    return static_cast<std::uint16_t>(function + node_.id());
  };
  switch (place) {
    case emergency_place:
      return can_id_in(object_index::cob_id_emergency, 0);
    case sdo_place:
      return of_node(can_id::sdo_response);
    case heartbeat_place:
      return of_node(can_id::error_control);
    default:
      return can_id_in(static_cast<std::uint16_t>(object_index::tpdo_parameter + first_tpdo_ - 1U +
                                                  place - ids_beside_tpdos),
                       cob_id_sub);
  }
}

/// 0: the COB-ID is not there, not valid, or of an extended frame.
std::uint16_t CollisionWatch::can_id_in(std::uint16_t index, std::uint8_t sub) const {
  const CobId cob_id{node_.dictionary().word(index, sub, CobId::bit31)};
  const bool is_one = cob_id.valid() && cob_id.is_base_frame();
  return is_one ? static_cast<std::uint16_t>(cob_id.can_id()) : std::uint16_t{0};
}

/// Of those that the node has: there may be 512.
CollisionWatch::CanIds CollisionWatch::received_by_rpdos() const {
  CanIds received;
  const std::span<const ObjectRow> objects = node_.dictionary().tables().objects;
  auto row = std::ranges::lower_bound(objects, object_index::rpdo_parameter, {}, &ObjectRow::index);
  for (; row != objects.end() && row->index <= object_index::rpdo_parameter_last; ++row) {
    for (unsigned each = 0; each < row->count; ++each) {
      received[can_id_in(static_cast<std::uint16_t>(row->index + each), cob_id_sub)] = true;
    }
  }
  return received;
}

void CollisionWatch::heard(const Frame& frame, Time now) {
  node_.timers().arm(timer_, now + quiet_time);
  if (collided_ != 0) return;
  collided_ = static_cast<std::uint16_t>(frame.id);
  node_.raise(cob_id_collision(collided_));
}

void CollisionWatch::is_quiet(Time /*now*/) {
  node_.clear(cob_id_collision(std::exchange(collided_, std::uint16_t{0})));
}

}  // namespace canvoy
