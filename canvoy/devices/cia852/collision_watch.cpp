#include "canvoy/devices/cia852/collision_watch.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::cia852 {

namespace {

constexpr std::uint8_t cob_id_sub = 1;

}  // namespace

constexpr AccessHandlers CollisionWatch::hook_calls[] = {
    {.first = object_index::tpdo_parameter,
     .last = object_index::tpdo_parameter_last,
     .sub_first = cob_id_sub,
     .sub_last = cob_id_sub,
     .after_write = method<&CollisionWatch::written>}};
constexpr ServiceHandlers CollisionWatch::service_calls = {.reset = method<&CollisionWatch::reset>,
                                                           .hooks = hook_calls};

CollisionWatch::CollisionWatch(Node& node, std::span<std::uint16_t> ids) : node_(node), ids_(ids) {
  node.attach(service_);
}

void CollisionWatch::reset(ResetScope /*scope*/) {
  collided_ = 0;
  node_.timers().disarm(timer_);
  listen_anew();
}

void CollisionWatch::written(const Entry& /*entry*/, Source /*source*/) {
  listen_anew();
}

void CollisionWatch::listen_anew() {
  const auto receiver = Router::Receiver::to<&CollisionWatch::heard>(*this);
  for (const std::uint16_t can_id : ids_.first(used_)) node_.router().remove(can_id, receiver);
  used_ = 0;
  if (!is_node_id(node_.id())) return;
  for (const std::uint16_t of_node :
       {can_id::emergency, can_id::sdo_response, can_id::error_control}) {
    listen_to(static_cast<std::uint16_t>(of_node + node_.id()));
  }
  for (std::uint16_t index = object_index::tpdo_parameter;
       index <= object_index::tpdo_parameter_last; ++index) {
    const Result<Entry> entry = node_.dictionary().find(index, cob_id_sub);
    if (!entry) continue;
    const CobId cob_id{node_.dictionary().word(index, cob_id_sub)};
    if (cob_id.valid() && cob_id.is_base_frame()) {
      listen_to(static_cast<std::uint16_t>(cob_id.can_id()));
    }
  }
}

void CollisionWatch::listen_to(std::uint16_t can_id) {
  if (used_ == ids_.size()) return;
  const auto receiver = Router::Receiver::to<&CollisionWatch::heard>(*this);
  if (node_.router().add(can_id, receiver)) ids_[used_++] = can_id;
}

void CollisionWatch::heard(const Frame& frame, Time now) {
  node_.timers().arm(timer_, now + quiet_time);
  if (collided_ != 0) return;
  collided_ = static_cast<std::uint16_t>(frame.id);
  node_.raise(cob_id_collision(collided_));
}

void CollisionWatch::is_quiet(Time /*now*/) {
  node_.clear(cob_id_collision(collided_));
  collided_ = 0;
}

}  // namespace canvoy::cia852
