// What `canvoy device` says of its devices: lines for people, or one JSON object a line.
//
//     const DeviceOutput output(options.json);
//     output.say("charger", "linked to node 10 (0Ah)");
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "canvoy/canopen/indicators.hpp"

namespace canvoy::tools {

/// `single flash`
std::string_view indication_text(Indication indication);

class DeviceOutput {
 public:
  explicit DeviceOutput(bool json = false) : json_(json) {}

  void say(std::string_view who, std::string_view text) const;
  /// Both lights of CiA 303-3.
  void lights(std::string_view who, Indication run, Indication error) const;
  /// What is to be read on a display of so many columns, in UTF-8, and whether its stop sign is
  /// lit.
  void draw(std::string_view who, std::span<const std::string> lines, std::size_t columns,
            bool has_sign) const;

 private:
  bool json_;
};

/// Tells of the lights of a device when they change.
class LightsTeller {
 public:
  /// All must outlive this.
  LightsTeller(const DeviceOutput& output, std::string who, const Indicators& indicators)
      : output_(output), who_(std::move(who)), indicators_(indicators) {}

  /// To be called often; it speaks when there is something new.
  void look();

 private:
  const DeviceOutput& output_;
  std::string who_;
  const Indicators& indicators_;
  Indication run_ = Indication::off;
  Indication error_ = Indication::off;
};

}  // namespace canvoy::tools
