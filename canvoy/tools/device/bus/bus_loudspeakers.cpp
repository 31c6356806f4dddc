#include "canvoy/tools/device/bus/bus_loudspeakers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

StopAnnouncements parse_announcements(const std::vector<std::string>& texts) {
  StopAnnouncements all;
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    std::uint32_t stop = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + equals, stop);
    const bool is_one = error == std::errc{} && end == text.data() + equals && stop != 0 &&
                        equals + 1 < text.size();
    if (!is_one) {
      throw UsageError(
          fmt::format("--announce: '{}' is no stop point with what is said: write "
                      "'17=Town Hall'",
                      text));
    }
    all[stop] = text.substr(equals + 1);
  }
  return all;
}

void BusLoudspeakers::join(Environment& environment) {
  using namespace cia407;
  environment.provide(callback<&BusLoudspeakers::announcer>(*this));
  environment.provide(callback<&BusLoudspeakers::control_manager>(*this));
}

cia407::AcousticAnnouncerHardware BusLoudspeakers::announcer() {
  return {.announce = callback<&BusLoudspeakers::announce>(*this)};
}

bool BusLoudspeakers::announce(std::uint32_t stop_point, std::string_view text) {
  std::string said(text);
  if (const auto known = announcements_.find(stop_point); known != announcements_.end()) {
    said = known->second;
  } else if (!announcements_.empty()) {
    output_.say("acoustic-announcer", fmt::format("nothing to say of stop {}", stop_point));
    return false;
  }
  output_.say("acoustic-announcer", said.empty() ? fmt::format("stop {}", stop_point)
                                                 : fmt::format("stop {}, {}", stop_point, said));
  return true;
}

cia407::AcousticControlManagerHardware BusLoudspeakers::control_manager() {
  using cia407::AudioPaths;
  return {.switch_paths = callback<&BusLoudspeakers::switch_paths>(*this), .state = {}};
}

cia407::AudioPaths BusLoudspeakers::switch_paths(const cia407::AudioPaths& wanted) {
  std::vector<std::string_view> on;
  if (wanted.driver_to_indoor) on.emplace_back("driver to indoor");
  if (wanted.driver_to_outdoor) on.emplace_back("driver to outdoor");
  if (wanted.driver_to_radio) on.emplace_back("driver to radio");
  if (wanted.attendant_to_indoor) on.emplace_back("attendant to indoor");
  if (wanted.radio_to_indoor) on.emplace_back("radio to indoor");
  output_.say("acoustic-control-manager", on.empty()
                                              ? "nothing is switched"
                                              : fmt::format("switched: {}", fmt::join(on, ", ")));
  return wanted;
}

}  // namespace canvoy::tools
