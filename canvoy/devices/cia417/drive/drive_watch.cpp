#include "canvoy/devices/cia417/drive/drive_watch.hpp"

#include <cmath>

#include "canvoy/canopen/nmt/error_control_id.hpp"
#include "canvoy/canopen/nmt/remote_state.hpp"
#include "canvoy/devices/cia417/drive/drive_faults.hpp"

namespace canvoy::cia417 {

DriveHold::DriveHold(Node& node, EmergencyConsumer* emergencies, std::span<const NodeId> more,
                     Callback<void()> held)
    : node_(node), held_(held) {
  if (emergencies == nullptr) return;
  emergencies->on_emergency(callback<&DriveHold::emergency_heard>(*this));
  for (const NodeId node_id : more) emergencies->listen(node_id);
}

/// The end of one error leaves others while the register is not 0.
void DriveHold::emergency_heard(NodeId node_id, const Emergency& emergency) {
  if (is_dangerous_motion(emergency.code)) {
    hold_for(node_id);
    held_();
  }
  if (emergency.code == canvoy::emergency_code::no_error && emergency.register_bits == 0) {
    release(node_id);
  }
}

/// Its boot-up is received meanwhile. Without room for that, only a fault reset releases the drive.
void DriveHold::hold_for(NodeId node_id) {
  if (holders_[node_id]) return;
  holders_[node_id] = true;
  node_.router().add(error_control_id(node_id),
                     Router::Receiver::to<&DriveHold::error_control_heard>(*this));
}

void DriveHold::release(NodeId node_id) {
  if (!holders_[node_id]) return;
  holders_[node_id] = false;
  node_.router().remove(error_control_id(node_id),
                        Router::Receiver::to<&DriveHold::error_control_heard>(*this));
}

void DriveHold::release_all() {
  for (NodeId node_id = node_id_min; node_id <= node_id_max; ++node_id) release(node_id);
}

/// A node that boots has lost its errors, and does not report their end.
void DriveHold::error_control_heard(const Frame& frame, Time) {
  const bool is_boot_up = frame.length == 1 && remote_state(frame.data[0]) == RemoteState::boot_up;
  if (is_boot_up) release(static_cast<NodeId>(frame.id - can_id::error_control));
}

bool DriveWatch::is_too_fast(const DrivenCar& car, const DriveParameters& parameters) const {
  const double highest = parameters.velocity_max() * limits_.overspeed_percent / 100;
  return highest > 0 && std::abs(car.readings().velocity) > highest;
}

bool DriveWatch::strays(const DrivenCar& car, const DriveParameters& parameters) const {
  return car.has_strayed(parameters.increments(limits_.unintended_distance));
}

bool DriveWatch::lags_behind(const DrivenCar& car, const DriveParameters& parameters, Time now) {
  behind_.watch(car.lag(now) > parameters.increments(limits_.following_window), now);
  return behind_.lasts(limits_.following_time, now);
}

}  // namespace canvoy::cia417
