// The loudspeakers of a bus (CiA 407) that `canvoy device` runs: announcements of stop points by
// the acoustic announcer, and the sources that the acoustic control manager connects.
//
//     BusLoudspeakers loudspeakers(parse_announcements({"17=Town Hall"}), output);
//     loudspeakers.join(environment);
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/devices/cia407/acoustic/acoustic_announcer_unit.hpp"
#include "canvoy/devices/cia407/acoustic/acoustic_control_manager_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"
#include "canvoy/tools/device/hand/device_output.hpp"

namespace canvoy::tools {

/// Announcements by number of the stop point.
using StopAnnouncements = std::map<std::uint32_t, std::string>;
/// Reads `17=Town Hall`. Throws UsageError.
StopAnnouncements parse_announcements(const std::vector<std::string>& texts);

class BusLoudspeakers {
 public:
  /// Empty announcements: one exists for every stop point. `output` must outlive this.
  BusLoudspeakers(StopAnnouncements announcements, const DeviceOutput& output)
      : announcements_(std::move(announcements)), output_(output) {}
  BusLoudspeakers(const BusLoudspeakers&) = delete;
  BusLoudspeakers& operator=(const BusLoudspeakers&) = delete;

  /// This must outlive the devices that are made in the environment.
  void join(Environment& environment);

 private:
  cia407::AcousticAnnouncerHardware announcer();
  bool announce(std::uint32_t stop_point, std::string_view text);
  cia407::AcousticControlManagerHardware control_manager();
  cia407::AudioPaths switch_paths(const cia407::AudioPaths& wanted);

  StopAnnouncements announcements_;
  const DeviceOutput& output_;
};

}  // namespace canvoy::tools
