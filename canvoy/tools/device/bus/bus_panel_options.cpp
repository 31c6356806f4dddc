#include "canvoy/tools/device/bus/bus_panel_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/device/bus/bus_loudspeakers.hpp"
#include "canvoy/tools/device/bus/bus_press.hpp"
#include "canvoy/tools/device/bus/device_bus_displays.hpp"

namespace canvoy::tools {

namespace {

struct SegmentWord {
  std::string_view word;
  void (*apply)(cia407::BusSegment& segment);
};
constexpr SegmentWord segment_words[] = {
    {"minimum",
     [](cia407::BusSegment& segment) { segment.configuration = cia407::Configuration::minimum; }},
    {"no-main-computer", [](cia407::BusSegment& segment) { segment.has_main_computer = false; }},
    {"no-diagnostics", [](cia407::BusSegment& segment) { segment.has_diagnostics = false; }},
    {"identification-texts",
     [](cia407::BusSegment& segment) { segment.identification_provides_texts = true; }},
};

}  // namespace

cia407::BusSegment parse_bus_segment(const std::vector<std::string>& words) {
  cia407::BusSegment segment;
  for (const std::string& word : words) {
    const auto found = std::ranges::find(segment_words, word, &SegmentWord::word);
    if (found == std::end(segment_words)) {
      std::vector<std::string_view> known;
      for (const SegmentWord& each : segment_words) known.push_back(each.word);
      throw UsageError(fmt::format("--segment: '{}' is none of {}", word, fmt::join(known, ", ")));
    }
    found->apply(segment);
  }
  return segment;
}

void add_bus_panel_options(Verb& command, BusPanelOptions& options) {
  command.add({
      {"--segment", options.segment,
       "of a network of CiA 407, each by itself: minimum (the configuration), "
       "no-main-computer, no-diagnostics, identification-texts",
       one_each},
      {"--display", options.display,
       "columns and lines of a passenger information device (default 32x4)"},
      {"--png", options.png, "the file in which its display is drawn, whenever it looks different"},
      {"--announce", options.announcements,
       "what an acoustic-announcer says of a stop point: '17=Town Hall'; it has nothing "
       "for others then",
       one_each},
      {"--capacity", options.capacity,
       "passengers of the vehicle of a passenger-counting-manager (default 80)",
       between(1U, 1000U)},
  });
}

void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses) {
  for (const std::string& text : presses) parse_bus_press(units, text);
  parse_bus_segment(options.segment);
  parse_display_size(options.display);
  parse_announcements(options.announcements);
  const std::size_t displays = display_names(units).size();
  if (!options.png.empty() && displays != 1) {
    throw UsageError(
        fmt::format("--png: the picture is one of a display, and there are {}", displays));
  }
}

}  // namespace canvoy::tools
