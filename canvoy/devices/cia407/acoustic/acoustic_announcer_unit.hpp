// The acoustic announcer: a new stop point (6109h) is its cue (CiA 407, 6.8). A stop point without
// an announcement is an error (FF05h) until one with an announcement comes.
//
//     AcousticAnnouncerUnit announcer(device, {.announce = ...}, {});
//
// Stop point 0 means none. An unchanged stop point is a cue if it is written by SDO, on purpose
// (6.9). By PDO it is not: its message is also sent for other reasons (8.1.4.3).
#pragma once

#include <string_view>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/errors.hpp"
#include "canvoy/devices/cia407/kit/state_answer.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// The loudspeakers, and what can be announced.
struct AcousticAnnouncerHardware {
  /// Starts the announcement and returns true if there is one. The text is empty if none was
  /// received.
  Callback<bool(std::uint32_t stop_point, std::string_view text)> announce = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(AcousticAnnouncerHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::announce; },
      "the class has no member function of AcousticAnnouncerHardware: announce");
  if constexpr (requires { &Plain::announce; })
    hardware.announce = callback<&Plain::announce>(plain);
}

class AcousticAnnouncerUnit {
 public:
  /// Everything to which `hardware` refers must outlive this.
  AcousticAnnouncerUnit(VirtualDevice& device, const AcousticAnnouncerHardware& hardware,
                        const NoSettings& /*settings*/)
      : device_(device), hardware_(hardware), state_(device) {
    device.on_reset = callback<&AcousticAnnouncerUnit::reset>(*this);
    device.react(*this, reactions());
    device.on_event = callback<&AcousticAnnouncerUnit::take_event>(*this);
  }
  AcousticAnnouncerUnit(const AcousticAnnouncerUnit&) = delete;
  AcousticAnnouncerUnit& operator=(const AcousticAnnouncerUnit&) = delete;

 private:
  static std::span<const AccessHandlers> reactions();
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

inline std::span<const AccessHandlers> AcousticAnnouncerUnit::reactions() {
  static constexpr AccessHandlers rows[] = {
      after_write<&AcousticAnnouncerUnit::stop_point_written, stop_point_id_object>};
  return rows;
}

/// Catalogue row of the acoustic announcer (6.8); bus_unit makes it a part of a device.
struct AcousticAnnouncerKind : BusKind<AcousticAnnouncerUnit, AcousticAnnouncerHardware> {
  static constexpr DeviceInfo info = {.name = "acoustic-announcer",
                                      .title = "acoustic announcer",
                                      .product = "Canvoy CiA 407 announcer",
                                      .product_code = 40707,
                                      .node_id = 9,
                                      .hardware = "loudspeakers, and what they may say"};
  static constexpr const VirtualDeviceInfo& provides = acoustic_announcer;
  /// The message with the stop point. No announcer of the typical configuration has it.
  static constexpr PdoInfo stop_point_rpdo = [] {
    PdoInfo made = receives(stop_point_only_mapping, "stop point");
    made.cob_id = stop_point_message.cob_id;
    return made;
  }();
  static constexpr std::array pdos = {own_pdo<event_tpdo>, own_pdo<command_rpdo>,
                                      own_pdo<stop_point_rpdo>};
};

}  // namespace canvoy::cia407
