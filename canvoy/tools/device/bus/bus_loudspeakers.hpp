// The loudspeakers of a bus (CiA 407) that `canvoy device` runs: what the acoustic announcer says
// there of a stop point, and who is switched to them by the acoustic control manager.
//
//     BusLoudspeakers loudspeakers(parse_announcements({"17=Town Hall"}), output);
//     loudspeakers.join(site);
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/acoustic/acoustic_control_manager_unit.hpp"
#include "canvoy/devices/site.hpp"
#include "canvoy/tools/device/device_output.hpp"

namespace canvoy::tools {

/// What is said of a stop point, by its number.
using StopAnnouncements = std::map<std::uint32_t, std::string>;
/// `17=Town Hall`. Throws UsageError.
StopAnnouncements parse_announcements(const std::vector<std::string>& texts);

class BusLoudspeakers {
 public:
  /// No announcements: it has one for every stop point. `output` must outlive this.
  BusLoudspeakers(StopAnnouncements announcements, const DeviceOutput& output)
      : announcements_(std::move(announcements)), output_(output) {}
  BusLoudspeakers(const BusLoudspeakers&) = delete;
  BusLoudspeakers& operator=(const BusLoudspeakers&) = delete;

  /// This must outlive the devices that are made there.
  void join(Site& site);

 private:
  cia407::AcousticAnnouncerHardware announcer();
  bool announce(std::uint32_t stop_point, std::string_view text);
  cia407::AcousticControlManagerHardware control_manager();
  cia407::AudioPaths switch_paths(const cia407::AudioPaths& wanted);

  StopAnnouncements announcements_;
  const DeviceOutput& output_;
};

}  // namespace canvoy::tools
