#include "canvoy/tools/device/car/car_words.hpp"

#include <fmt/format.h>

#include <span>
#include <string_view>

#include "canvoy/profiles/cia447/radio_handles.hpp"
#include "canvoy/profiles/cia447/taxi_handles.hpp"

namespace canvoy::tools {

namespace {

/// In the form for use within a sentence.
std::string name_of_code(std::span<const NamedValue> names, std::int64_t code) {
  for (const NamedValue& named : names) {
    if (named.first != code) continue;
    std::string text(named.name);
    if (text.front() >= 'A' && text.front() <= 'Z') text.front() += 'a' - 'A';
    return text;
  }
  return "reserved";
}

template <class Handle>
constexpr std::span<const NamedValue> names_of_states(const Handle& /*handle*/) {
  return Handle::Place::value.names;
}

}  // namespace

std::string taximeter_words(cia447::Taximeter state) {
  return name_of_code(names_of_states(cia447::taximeter_status), static_cast<std::int64_t>(state));
}

std::string lamp_words(cia447::Lamp lamp) {
  constexpr std::string_view of_what = "lamp ";
  std::string text = name_of_code(names_of_states(cia447::tariff_display_lamps_status_1_taxi_light),
                                  static_cast<std::int64_t>(lamp));
  if (text.starts_with(of_what)) text.erase(0, of_what.size());
  return text;
}

std::string car_event_words(cia447::CarEvent::Kind kind, std::string_view device) {
  using Kind = cia447::CarEvent::Kind;
  switch (kind) {
    case Kind::named:
      return fmt::format("{} has its node-ID", device);
    case Kind::refused:
      return fmt::format("there is no node-ID left: {} devices have one",
                         cia447::add_on_devices_max);
    case Kind::started:
      return fmt::format("{} is started", device);
    case Kind::lost:
      return fmt::format("{} is lost", device);
    case Kind::stranger:
      return fmt::format("{} is no device of CiA 447", device);
    case Kind::objection:
      return fmt::format("{} objects to sleep", device);
    case Kind::asleep:
      return "the network sleeps";
    case Kind::awake:
      return "the network is awake";
  }
  return {};
}

}  // namespace canvoy::tools
