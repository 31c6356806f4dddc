// What passengers and the driver see, hear and get of a device of CiA 407.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "canvoy/tools/device/device_bus_panel.hpp"

namespace canvoy::tools {

namespace {

constexpr double cabin_celsius = 20;

std::string set_bits_text(std::uint32_t bits) {
  std::vector<unsigned> set;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((bits >> bit & 1) != 0) set.push_back(bit + 1);
  }
  return set.empty() ? "none" : fmt::format("{}", fmt::join(set, ", "));
}

std::string time_words(const std::optional<cia407::CivilTime>& time) {
  return time ? fmt::format("{:02}:{:02}", time->hour, time->minute) : "--:--";
}

std::string ticket_words(const cia407::TicketData& ticket) {
  std::string text = fmt::format("{} stop {} zone {} segment {} line {} route {} block {}",
                                 time_words(ticket.time), ticket.stop_point_id, ticket.fare_zone,
                                 ticket.route_segment_number, ticket.line_id, ticket.route_number,
                                 ticket.block_id);
  if (!ticket.stop_point_text.empty()) text += fmt::format(", {}", ticket.stop_point_text);
  return text;
}

}  // namespace

// For passengers.

/// Displays ask in the order of the units.
cia407::DisplayHardware BusPanel::display() {
  std::size_t before = displays_.size();
  const auto kind = std::ranges::find_if(kinds_, [&before](const cia407::BusUnit* unit) {
    return unit->provides->code == code_of(cia407::DeviceCode::passenger_information) &&
           before-- == 0;
  });
  const std::string_view name = kind == kinds_.end() ? "display" : (*kind)->info.name;
  return displays_
      .emplace_back(std::string(name), parse_display_size(options_.display), options_.png,
                    place_.clock, place_.output)
      .hardware();
}

cia407::TicketCancellerHardware BusPanel::canceller() {
  return {.stamp = Callback<void(const cia407::TicketData&)>::to<&BusPanel::stamp>(*this),
          .show_ready = Callback<void(bool)>::to<&BusPanel::show_ready>(*this)};
}
void BusPanel::stamp(const cia407::TicketData& ticket) {
  place_.output.say("ticket-canceller", fmt::format("stamps {}", ticket_words(ticket)));
}
void BusPanel::show_ready(bool is_ready) {
  place_.output.say("ticket-canceller", is_ready ? "takes tickets" : "takes no tickets");
}

cia407::TicketPrinterHardware BusPanel::printer() {
  return {.print = Callback<bool(const cia407::TicketData&)>::to<&BusPanel::print>(*this),
          .has_paper = Callback<bool()>::to<&BusPanel::has_paper>(*this)};
}
bool BusPanel::print(const cia407::TicketData& ticket) {
  if (has_paper_)
    place_.output.say("ticket-printer", fmt::format("prints {}", ticket_words(ticket)));
  return has_paper_;
}

cia407::AcousticAnnouncerHardware BusPanel::announcer() {
  return {.announce =
              Callback<bool(std::uint32_t, std::string_view)>::to<&BusPanel::announce>(*this)};
}
bool BusPanel::announce(std::uint32_t stop_point, std::string_view text) {
  std::string said(text);
  if (const auto known = announcements_.find(stop_point); known != announcements_.end()) {
    said = known->second;
  } else if (!announcements_.empty()) {
    place_.output.say("acoustic-announcer", fmt::format("nothing to say of stop {}", stop_point));
    return false;
  }
  place_.output.say("acoustic-announcer", said.empty()
                                              ? fmt::format("stop {}", stop_point)
                                              : fmt::format("stop {}, {}", stop_point, said));
  return true;
}

cia407::AcousticControlManagerHardware BusPanel::control_manager() {
  return {.switch_paths =
              Callback<cia407::AudioPaths(const cia407::AudioPaths&)>::to<&BusPanel::switch_paths>(
                  *this),
          .state = {}};
}
cia407::AudioPaths BusPanel::switch_paths(const cia407::AudioPaths& wanted) {
  std::vector<std::string_view> on;
  if (wanted.driver_to_indoor) on.emplace_back("driver to indoor");
  if (wanted.driver_to_outdoor) on.emplace_back("driver to outdoor");
  if (wanted.driver_to_radio) on.emplace_back("driver to radio");
  if (wanted.attendant_to_indoor) on.emplace_back("attendant to indoor");
  if (wanted.radio_to_indoor) on.emplace_back("radio to indoor");
  place_.output.say(
      "acoustic-control-manager",
      on.empty() ? "nothing is switched" : fmt::format("switched: {}", fmt::join(on, ", ")));
  return wanted;
}

// For the driver.

cia407::DriverIndicatorHardware BusPanel::indicator() {
  return {.show = Callback<void(const cia407::DriverView&)>::to<&BusPanel::show_driver>(*this)};
}
void BusPanel::show_driver(const cia407::DriverView& view) {
  std::string text =
      fmt::format("{}, doors {}", time_words(view.time), view.has_open_door ? "open" : "not open");
  if (view.left_released || view.right_released) {
    text += fmt::format(", released{}{}", view.left_released ? " left" : "",
                        view.right_released ? " right" : "");
  }
  if (view.ambient_celsius) text += fmt::format(", {:.1f} C outside", *view.ambient_celsius);
  if (view.coolant_celsius) text += fmt::format(", engine {:.0f} C", *view.coolant_celsius);
  if (view.fuel_rate_l_per_h) text += fmt::format(", {:.1f} l/h", *view.fuel_rate_l_per_h);
  if (view.average_economy_km_per_l) {
    text += fmt::format(", {:.1f} km/l on average", *view.average_economy_km_per_l);
  }
  if (view.engine_hours) text += fmt::format(", engine {:.1f} h", *view.engine_hours);
  if (view.is_braking) text += ", braking";
  if (view.last_error != 0) text += fmt::format(", error {:08X}h", view.last_error);
  if (text == driver_told_) return;
  driver_told_ = text;
  place_.output.say("driver-display", text);
}

cia407::IdentificationHardware BusPanel::identification() {
  assignment_ = kept_.assignment;
  return {.remembered = Callback<cia407::Assignment()>::to<&BusPanel::remembered>(*this)};
}

cia407::MainOnBoardComputerHardware BusPanel::computer() {
  return {.clock = Callback<std::optional<cia407::CivilTime>()>::to<&BusPanel::utc>(*this),
          .inside_temperature = {[](void*) -> std::optional<double> { return cabin_celsius; },
                                 nullptr}};
}

cia407::KeyboardHardware BusPanel::keyboard() {
  return {.keys = Callback<std::uint32_t()>::to<&BusPanel::keys>(*this),
          .is_reverse_engaged = Callback<bool()>::to<&BusPanel::is_reverse>(*this)};
}

cia407::GenericIoHardware BusPanel::io() {
  return {.digital_inputs = Callback<std::uint32_t()>::to<&BusPanel::inputs>(*this),
          .set_digital_outputs = Callback<void(std::uint32_t)>::to<&BusPanel::set_outputs>(*this),
          .set_analogue_output =
              Callback<void(unsigned, std::int16_t)>::to<&BusPanel::set_analogue>(*this),
          .has_error = Callback<bool(std::uint16_t)>::to<&BusPanel::has_error>(*this)};
}
void BusPanel::set_outputs(std::uint32_t outputs) {
  if (std::exchange(outputs_, outputs) == outputs) return;
  place_.output.say("generic-io", fmt::format("outputs on: {}", set_bits_text(outputs)));
}
void BusPanel::set_analogue(unsigned channel, std::int16_t value) {
  if (std::exchange(analogue_.at(channel - 1), value) == value) return;
  place_.output.say("generic-io", fmt::format("analogue output {}: {}", channel, value));
}

cia407::PassengerCounterSettings BusPanel::counter() {
  return {.door = door_};
}
cia407::CountingManagerSettings BusPanel::manager() {
  return {.capacity = options_.capacity};
}
void BusPanel::has_manager(cia407::CountingManagerUnit& unit, Node& /*node*/) {
  std::get<cia407::CountingManagerUnit*>(units_) = &unit;
  unit.restore(kept_.counts);
}

}  // namespace canvoy::tools
