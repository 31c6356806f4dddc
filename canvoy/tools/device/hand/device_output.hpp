// Output of `canvoy device` about its devices: lines of text, or JSON Lines.
//
//     const DeviceOutput output(options.json);
//     output.say("charger", "linked to node 10 (0Ah)");
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "canvoy/canopen/device/indicators.hpp"

namespace canvoy::tools {

/// Text of an indication: `single flash`.
std::string_view indication_text(Indication indication);

class DeviceOutput {
 public:
  explicit DeviceOutput(bool json = false) : json_(json) {}

  void say(std::string_view who, std::string_view text) const;
  /// Reports both lights (CiA 303-3).
  void lights(std::string_view who, Indication run, Indication error) const;
  /// Draws a display of this many columns, in UTF-8, and whether its stop sign is lit.
  void draw(std::string_view who, std::span<const std::string> lines, std::size_t columns,
            bool has_sign) const;

 private:
  bool json_;
};

/// Reports changes of the lights of a device.
class LightsTeller {
 public:
  /// All arguments must outlive this.
  LightsTeller(const DeviceOutput& output, std::string who, const Indicators& indicators)
      : output_(output), who_(std::move(who)), indicators_(indicators) {}

  /// To be called often; reports if there is a change.
  void look();

 private:
  const DeviceOutput& output_;
  std::string who_;
  const Indicators& indicators_;
  Indication run_ = Indication::off;
  Indication error_ = Indication::off;
};

}  // namespace canvoy::tools
