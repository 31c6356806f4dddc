#include "canvoy/tools/device/bus/device_bus_displays.hpp"

#include <fmt/format.h>

#include <charconv>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/png_file.hpp"

namespace canvoy::tools {

BusDisplay::Size parse_display_size(const std::string& text) {
  constexpr std::size_t columns_max = 128;
  constexpr std::size_t lines_max = 16;
  BusDisplay::Size size{.columns = 0, .lines = 0};
  const char* const end = text.data() + text.size();
  const auto columns = std::from_chars(text.data(), end, size.columns);
  if (columns.ec == std::errc{} && columns.ptr != end && *columns.ptr == 'x') {
    const auto lines = std::from_chars(columns.ptr + 1, end, size.lines);
    if (lines.ec != std::errc{} || lines.ptr != end) size.lines = 0;
  }
  const bool is_size = size.columns >= 1 && size.columns <= columns_max && size.lines >= 1 &&
                       size.lines <= lines_max;
  if (!is_size) {
    throw UsageError(
        fmt::format("--display: '{}' is no size: write columns and lines as 32x4, at most {}x{}",
                    text, columns_max, lines_max));
  }
  return size;
}

DeviceBusDisplay::DeviceBusDisplay(std::string name, const BusDisplay::Size& size, std::string png,
                                   Callback<Time()> clock, const DeviceOutput& output)
    : name_(std::move(name)),
      display_(size, clock),
      png_(std::move(png)),
      output_(output),
      columns_(size.columns),
      drawn_(size.lines) {}

void DeviceBusDisplay::look() {
  std::vector<std::string> now = display_.text();
  const bool has_sign = display_.is_stop_requested();
  if (now == drawn_ && has_sign == has_sign_) return;
  drawn_ = std::move(now);
  has_sign_ = has_sign;
  // The picture is written before its change is reported.
  if (!png_.empty()) write_png(png_, display_.picture());
  output_.draw(name_, drawn_, columns_, has_sign_);
}

std::vector<std::string_view> display_names(std::span<const cia407::BusUnit* const> units) {
  std::vector<std::string_view> names;
  for (const cia407::BusUnit* unit : units) {
    const bool has_display =
        unit->provides->code == code_of(cia407::DeviceCode::passenger_information);
    if (has_display) names.push_back(unit->info.name);
  }
  return names;
}

void DeviceBusDisplays::join(Environment& environment) {
  environment.provide(callback<&DeviceBusDisplays::next>(*this));
}

void DeviceBusDisplays::look() {
  for (DeviceBusDisplay& display : displays_) display.look();
}

/// Displays are requested in the order of the units.
cia407::DisplayHardware DeviceBusDisplays::next() {
  const std::size_t before = displays_.size();
  const std::string_view name = before < names_.size() ? names_[before] : "display";
  return displays_.emplace_back(std::string(name), size_, png_, clock_, output_).hardware();
}

}  // namespace canvoy::tools
