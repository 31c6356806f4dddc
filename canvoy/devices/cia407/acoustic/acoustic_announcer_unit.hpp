// The acoustic announcer: another stop point (6109h) is its cue (CiA 407, 6.8). Where it has
// nothing to say to it, that is an error (FF05h) until it has.
//
//     AcousticAnnouncerUnit announcer(device, {.announce = ...}, {});
//
// Stop point 0 is none. The same again is a cue by SDO, which somebody writes for the sake of it
// (6.9); by PDO it says nothing: the message that carries it also leaves for other reasons
// (8.1.4.3).
#pragma once

#include <string_view>

#include "canvoy/devices/cia407/bus_kind.hpp"
#include "canvoy/devices/cia407/errors.hpp"
#include "canvoy/devices/cia407/state_answer.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

struct AcousticAnnouncerHardware {
  /// Whether it has an announcement, which it begins then. Its text is empty where nobody told one.
  Callback<bool(std::uint32_t stop_point, std::string_view text)> announce = {};
};

class AcousticAnnouncerUnit {
 public:
  /// What `hardware` refers to must outlive this.
  AcousticAnnouncerUnit(VirtualDevice& device, const AcousticAnnouncerHardware& hardware,
                        const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware), state_(device) {
    device.on_reset = Callback<void(ResetScope)>::to<&AcousticAnnouncerUnit::reset>(*this);
    device.react(*this, reactions());
    device.on_event =
        Callback<void(std::uint8_t, std::uint16_t)>::to<&AcousticAnnouncerUnit::take_event>(*this);
  }
  AcousticAnnouncerUnit(const AcousticAnnouncerUnit&) = delete;
  AcousticAnnouncerUnit& operator=(const AcousticAnnouncerUnit&) = delete;

 private:
  static std::span<const HookCalls> reactions();
  void reset(ResetScope scope) {
    if (scope == ResetScope::node) announced_ = 0;
  }
  void stop_point_written(Source source) {
    const std::uint32_t stop_point = device_[stop_point_id].raw();
    const bool is_same = std::exchange(announced_, stop_point) == stop_point;
    if (stop_point == 0 || (is_same && source != Source::sdo)) return;
    if (!hardware_.announce) return;
    const bool is_known = hardware_.announce(stop_point, device_[stop_point_id_text].value());
    device_.report(bus_error::no_announcements, !is_known);
  }
  void take_event(std::uint8_t flags, std::uint16_t /*information*/) { state_.take(flags); }

  VirtualDevice& device_;
  AcousticAnnouncerHardware hardware_;
  StateAnswer state_;
  std::uint32_t announced_ = 0;
};

inline std::span<const HookCalls> AcousticAnnouncerUnit::reactions() {
  static constexpr HookCalls rows[] = {
      after_write<&AcousticAnnouncerUnit::stop_point_written, stop_point_id_object>};
  return rows;
}

struct AcousticAnnouncerKind : BusKind<AcousticAnnouncerUnit, AcousticAnnouncerHardware> {
  static constexpr DeviceInfo info = {.name = "acoustic-announcer",
                                      .title = "acoustic announcer",
                                      .product = "Canvoy CiA 407 announcer",
                                      .product_code = 40707,
                                      .node_id = 9,
                                      .hardware = "loudspeakers, and what they may say"};
  static constexpr const VirtualDeviceInfo& provides = acoustic_announcer;
  /// The message with the stop point, which no announcer of the typical configuration has.
  static constexpr PdoInfo stop_point_rpdo = [] {
    PdoInfo made = receives(stop_point_only_mapping, "stop point");
    made.cob_id = stop_point_message.cob_id;
    return made;
  }();
  static constexpr std::array pdos = {own_pdo<event_tpdo>, own_pdo<command_rpdo>,
                                      own_pdo<stop_point_rpdo>};
};

}  // namespace canvoy::cia407
