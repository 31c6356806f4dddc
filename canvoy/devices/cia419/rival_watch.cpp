#include "canvoy/devices/cia419/rival_watch.hpp"

#include <utility>

namespace canvoy::cia419 {

void RivalWatch::watch(NodeId battery, std::uint16_t can_id) {
  if (can_id != can_id_) {
    forget();
    if (node_.router().add(can_id, Router::Receiver::to<&RivalWatch::heard>(*this))) {
      can_id_ = can_id;
    }
  }
  battery_ = battery;
  is_linked_ = true;
  is_to_leave_ = false;
  linked_at_ = node_.now();
}

void RivalWatch::leave() {
  is_linked_ = is_to_leave_ = false;
}

bool RivalWatch::is_served(NodeId battery) const {
  return battery == battery_ && heard_last_ != never && node_.now() < heard_last_ + quiet_time;
}

void RivalWatch::advance(Time now) {
  if (heard_first_ == never || now < heard_last_ + quiet_time) return;
  heard_first_ = never;
  if (std::exchange(is_told_, false)) node_.clear(cob_id_collision(can_id_));
}

void RivalWatch::forget() {
  if (can_id_ != 0) {
    node_.router().remove(can_id_, Router::Receiver::to<&RivalWatch::heard>(*this));
  }
  if (std::exchange(is_told_, false)) node_.clear(cob_id_collision(can_id_));
  battery_ = 0;
  can_id_ = 0;
  is_linked_ = is_to_leave_ = false;
  heard_first_ = heard_last_ = never;
}

void RivalWatch::heard(const Frame& frame, Time now) {
  if (frame.is_remote()) return;
  if (heard_first_ == never) heard_first_ = now;
  heard_last_ = now;
  if (!is_linked_) return;
  if (!std::exchange(is_told_, true)) node_.raise(cob_id_collision(can_id_));
  is_to_leave_ = now < linked_at_ + newcomer_time || now >= heard_first_ + patience;
}

}  // namespace canvoy::cia419
