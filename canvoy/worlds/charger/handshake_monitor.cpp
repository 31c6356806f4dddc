#include "canvoy/worlds/charger/handshake_monitor.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/sim/plants/charging.hpp"

namespace canvoy::charger {

namespace {

constexpr std::uint8_t ready_bit = 1;
constexpr std::size_t status_offset = 2;  ///< of 6000h in the battery's TPDOs 1 and 2

Time later(Time when, Duration by) {
  return when == Time::min() ? Time::min() : when + by;
}

}  // namespace

void HandshakeMonitor::on_frame(Time now, const Frame& frame) {
  if (!frame.is_plain()) return;
  note_validity(now);
  if (frame.id == can_id::nmt) hear_nmt_command(frame);
  for (const NodeId node : {rules_.battery, rules_.charger}) {
    if (frame.id == can_id::error_control + std::uint32_t{node})
      hear_error_control(now, node, frame);
  }
  for (std::size_t i = 0; i < rules_.battery_tpdos.size(); ++i) {
    if (frame.id == rules_.battery_tpdos.at(i)) hear_battery_pdo(now, frame, i < 2);
    if (frame.id == rules_.charger_tpdos.at(i)) hear_charger_pdo(frame);
  }
  note_validity(now);
}

void HandshakeMonitor::hear_nmt_command(const Frame& frame) {
  if (frame.length != 2) return;
  const auto obey = [&](NodeId node, NmtState& state) {
    if (frame.data[1] != 0 && frame.data[1] != node) return;
    switch (static_cast<NmtCommand>(frame.data[0])) {
      case NmtCommand::start:
        state = NmtState::operational;
        break;
      case NmtCommand::stop:
        state = NmtState::stopped;
        break;
      case NmtCommand::enter_pre_operational:
        state = NmtState::pre_operational;
        break;
      case NmtCommand::reset_node:
      case NmtCommand::reset_communication:
        state = NmtState::initialisation;
        break;
    }
  };
  obey(rules_.battery, battery_state_);
  obey(rules_.charger, charger_state_);
}

void HandshakeMonitor::hear_error_control(Time now, NodeId node, const Frame& frame) {
  if (frame.length != 1) return;
  const auto state = static_cast<NmtState>(frame.data[0] & 0x7F);
  if (node == rules_.charger) {
    charger_state_ = state;
    return;
  }
  battery_state_ = state;
  heard_battery_at_ = now;
}

/// A PDO proves that its sender is operational: in no other state it sends one.
void HandshakeMonitor::hear_battery_pdo(Time now, const Frame& frame, bool carries_status) {
  battery_state_ = NmtState::operational;
  if (!carries_status) {
    request_at_ = now;
    return;
  }
  if (frame.length <= status_offset) return;
  battery_ready_ = (frame.data[status_offset] & ready_bit) != 0;
  status_at_ = now;
}

void HandshakeMonitor::hear_charger_pdo(const Frame& frame) {
  charger_state_ = NmtState::operational;
  if (frame.length > 0) charger_ready_ = (frame.data[0] & ready_bit) != 0;
}

void HandshakeMonitor::on_set_point(double ampere) {
  const bool begins = std::exchange(set_point_ampere_, ampere) <= 0 && ampere > 0;
  const bool is_told = charger_ready_ && charger_state_ == NmtState::operational;
  if (begins) ++begun_;
  if (begins && !is_told) ++begun_before_ready_;
}

void HandshakeMonitor::on_step(Time now, bool pilot_signal, double ampere) {
  note_validity(now);
  pilot_signal_ = pilot_signal;
  note_validity(now);
  if (ampere <= ChargingPlant::no_current_ampere) {
    no_current_until_ = now;
  } else {
    ++steps_with_current_;
  }
  outside_max_ = std::max(outside_max_, now - std::max(valid_until_, no_current_until_));
}

bool HandshakeMonitor::flags_valid() const {
  return pilot_signal_ && battery_ready_ && charger_ready_ &&
         battery_state_ == NmtState::operational && charger_state_ == NmtState::operational;
}

/// Time at which silence ends the handshake, if nothing else does.
Time HandshakeMonitor::deadline() const {
  const Time of_request = rules_.has_request ? request_at_ : status_at_;
  return std::min({later(heard_battery_at_, rules_.heartbeat_time),
                   later(status_at_, rules_.data_time), later(of_request, rules_.data_time)});
}

void HandshakeMonitor::note_validity(Time now) {
  if (flags_valid()) valid_until_ = std::max(valid_until_, std::min(now, deadline()));
}

}  // namespace canvoy::charger
