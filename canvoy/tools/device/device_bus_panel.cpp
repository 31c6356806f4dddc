#include "canvoy/tools/device/device_bus_panel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr Duration kept_each = 1s;

bool is_display(const cia407::BusUnit& unit) {
  return unit.provides->code == code_of(cia407::DeviceCode::passenger_information);
}

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

std::map<std::uint32_t, std::string> parse_announcements(const std::vector<std::string>& texts) {
  std::map<std::uint32_t, std::string> all;
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

void add_bus_panel_options(CLI::App& command, BusPanelOptions& options) {
  command
      .add_option("--segment", options.segment,
                  "of a network of CiA 407, each by itself: minimum (the configuration), "
                  "no-main-computer, no-diagnostics, identification-texts")
      ->allow_extra_args(false);
  command.add_option("--display", options.display,
                     "columns and lines of a passenger information device (default 32x4)");
  command.add_option("--png", options.png,
                     "the file in which its display is drawn, whenever it looks different");
  command
      .add_option("--announce", options.announcements,
                  "what an acoustic-announcer says of a stop point: '17=Town Hall'; it has nothing "
                  "for others then")
      ->allow_extra_args(false);
  command
      .add_option("--capacity", options.capacity,
                  "passengers of the vehicle of a passenger-counting-manager (default 80)")
      ->check(CLI::Range(1U, 1000U));
}

void check_bus_options(std::span<const cia407::BusUnit* const> units,
                       const BusPanelOptions& options, const std::vector<std::string>& presses) {
  for (const std::string& text : presses) parse_bus_press(units, text);
  parse_bus_segment(options.segment);
  parse_display_size(options.display);
  parse_announcements(options.announcements);
  const auto displays =
      std::ranges::count_if(units, [](const cia407::BusUnit* unit) { return is_display(*unit); });
  if (!options.png.empty() && displays != 1) {
    throw UsageError(
        fmt::format("--png: the picture is one of a display, and there are {}", displays));
  }
}

BusPanel::BusPanel(std::span<const cia407::BusUnit* const> units,
                   const std::vector<std::string>& presses, const BusPanelOptions& options,
                   Site& site, const Place& place)
    : kinds_(units.begin(), units.end()),
      options_(options),
      place_(place),
      segment_(parse_bus_segment(options.segment)),
      door_(site.door),
      announcements_(parse_announcements(options.announcements)) {
  for (const std::string& text : presses) {
    if (has_bus_press(units, text)) plan_.push_back({parse_bus_press(units, text)});
  }
  if (place_.store != nullptr) kept_ = stored_ = place_.store->load();
  join(site);
}

void BusPanel::step(Node& node, Time now) {
  const Time begin = begin_.value_or(now);
  begin_ = begin;
  if (now >= keep_at_) {
    keep_at_ = now + kept_each;
    keep();
  }
  for (Planned& each : plan_) {
    if (each.is_done || now - begin < each.press.at) continue;
    each.is_done = true;
    // Somebody outside of the node does something: it is brought up to the present.
    node.advance(now);
    act(each.press, node);
  }
  std::erase_if(release_at_, [&](const auto& key) {
    const bool is_over = now >= key.second;
    if (is_over) keys_ &= ~(std::uint32_t{1} << (key.first - 1));
    return is_over;
  });
  for (DeviceBusDisplay& display : displays_) display.look();
}

void BusPanel::keep() {
  if (place_.store == nullptr) return;
  KeptBusValues now = kept_;
  now.metres = metres();
  if (const auto* recorder = unit<cia407::TachographUnit>())
    now.trip_begin = recorder->trip_begin_metres();
  if (const auto* counting = unit<cia407::CountingManagerUnit>()) now.counts = counting->counts();
  now.assignment = assignment_;
  if (now == stored_) return;
  stored_ = now;
  place_.store->keep(now);
}

// What joins the site.

template <class Unit>
void BusPanel::watch(Site& site) {
  site.watch(Callback<void(Unit&, Node&)>::template to<&BusPanel::is_there<Unit>>(*this));
}

void BusPanel::join(Site& site) {
  site.offer(Callback<cia407::BusSegment()>::to<&BusPanel::segment>(*this));
  join_people(site);
  join_vehicle(site);
  join_codes(site);
  watch<cia407::TicketCancellerUnit>(site);
  watch<cia407::TicketPrinterUnit>(site);
  watch<cia407::IdentificationUnit>(site);
  watch<cia407::MainOnBoardComputerUnit>(site);
  watch<cia407::PassengerCounterUnit>(site);
  watch<cia407::TrainBusGatewayUnit>(site);
  watch<cia407::VehicleGatewayUnit>(site);
  watch<cia407::TachographUnit>(site);
  site.watch(
      Callback<void(cia407::CountingManagerUnit&, Node&)>::to<&BusPanel::has_manager>(*this));
}

void BusPanel::join_people(Site& site) {
  site.offer(Callback<cia407::DisplayHardware()>::to<&BusPanel::display>(*this));
  site.offer(Callback<cia407::TicketCancellerHardware()>::to<&BusPanel::canceller>(*this));
  site.offer(Callback<cia407::TicketPrinterHardware()>::to<&BusPanel::printer>(*this));
  site.offer(Callback<cia407::AcousticAnnouncerHardware()>::to<&BusPanel::announcer>(*this));
  site.offer(
      Callback<cia407::AcousticControlManagerHardware()>::to<&BusPanel::control_manager>(*this));
  site.offer(Callback<cia407::DriverIndicatorHardware()>::to<&BusPanel::indicator>(*this));
  site.offer(Callback<cia407::IdentificationHardware()>::to<&BusPanel::identification>(*this));
  site.offer(Callback<cia407::MainOnBoardComputerHardware()>::to<&BusPanel::computer>(*this));
  site.offer(Callback<cia407::KeyboardHardware()>::to<&BusPanel::keyboard>(*this));
  site.offer(Callback<cia407::PassengerCounterSettings()>::to<&BusPanel::counter>(*this));
  site.offer(Callback<cia407::CountingManagerSettings()>::to<&BusPanel::manager>(*this));
}

void BusPanel::join_vehicle(Site& site) {
  site.offer(Callback<cia407::TrainBusGatewayHardware()>::to<&BusPanel::train>(*this));
  site.offer(Callback<cia407::GenericIoHardware()>::to<&BusPanel::io>(*this));
  site.offer(Callback<cia407::VehicleGatewayHardware()>::to<&BusPanel::gateway>(*this));
  site.offer(Callback<cia407::TachographHardware()>::to<&BusPanel::tachograph>(*this));
  site.offer(Callback<cia407::TachographSettings()>::to<&BusPanel::tachograph_settings>(*this));
  site.offer(Callback<cia407::PositioningHardware()>::to<&BusPanel::positioning>(*this));
  site.offer(Callback<cia407::TimeFixingHardware()>::to<&BusPanel::time_fixing>(*this));
}

void BusPanel::join_codes(Site& site) {
  site.offer(Callback<cia407::CodeOnlyHardware<cia407::DeviceCode::data_radio>()>::to<
             &BusPanel::radio<cia407::DeviceCode::data_radio>>(*this));
  site.offer(Callback<cia407::CodeOnlyHardware<cia407::DeviceCode::voice_radio>()>::to<
             &BusPanel::radio<cia407::DeviceCode::voice_radio>>(*this));
  site.offer(
      Callback<cia407::CodeOnlyHardware<cia407::DeviceCode::short_range_communication>()>::to<
          &BusPanel::radio<cia407::DeviceCode::short_range_communication>>(*this));
  site.offer(
      Callback<cia407::CodeOnlyHardware<cia407::DeviceCode::power_supply>()>::to<&BusPanel::supply>(
          *this));
}

template <cia407::DeviceCode code>
cia407::CodeOnlyHardware<code> BusPanel::radio() {
  return {.has_error = Callback<bool(std::uint16_t)>::to<&BusPanel::is_disconnected>(*this)};
}
cia407::CodeOnlyHardware<cia407::DeviceCode::power_supply> BusPanel::supply() {
  return {.has_error = Callback<bool(std::uint16_t)>::to<&BusPanel::has_error>(*this)};
}

}  // namespace canvoy::tools
