#include "canvoy/tools/play/arrival_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "canvoy/can/real_text.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"

namespace canvoy::tools {

namespace {

using formats::trimmed;
using lift::Arrival;
using lift::Building;
using lift::FloorNumber;

constexpr std::size_t arrivals_max = 1'000'000;
constexpr double seconds_max = 1e6;
constexpr double kilograms_max = 1000;
constexpr double microseconds_of_second = 1e6;

/// Takes the text before the next comma.
std::string_view next_field(std::string_view& line) {
  const std::size_t comma = line.find(',');
  const std::string_view field = trimmed(line.substr(0, comma));
  line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  return field;
}

/// Text for a message: the file may be binary.
std::string shown(std::string_view field) {
  constexpr std::size_t shown_max = 40;
  std::string text(field.substr(0, shown_max));
  std::ranges::replace_if(
      text, [](char each) { return each < ' ' || each > '~'; }, '?');
  return field.size() > shown_max ? text + "..." : text;
}

double number(std::string_view field, double least, double most) {
  double value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, error] = real_from_chars(field.data(), end, value);
  // Written so that it refuses what is not a number as well.
  if (error != std::errc{} || stop != end || !(value >= least && value <= most)) {
    throw UsageError(fmt::format("'{}' is no number from {} to {}", shown(field), least, most));
  }
  return value;
}

FloorNumber floor_number(std::string_view field, const Building& building) {
  unsigned value = 0;
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc{} || stop != end || value < 1 || value > building.floor_count()) {
    throw UsageError(
        fmt::format("'{}' is no floor from 1 to {}", shown(field), building.floor_count()));
  }
  return static_cast<FloorNumber>(value);
}

Arrival parse_line(std::string_view line, const Building& building) {
  Arrival arrival;
  const double seconds = number(next_field(line), 0, seconds_max);
  arrival.at = Time(Duration(static_cast<Duration::rep>(seconds * microseconds_of_second)));
  arrival.from = floor_number(next_field(line), building);
  arrival.to = floor_number(next_field(line), building);
  if (arrival.from == arrival.to) throw UsageError("from and to are the same floor");
  if (!line.empty()) arrival.mass_kg = number(next_field(line), 1, kilograms_max);
  if (!line.empty()) throw UsageError("an arrival is: seconds,from,to or seconds,from,to,kg");
  return arrival;
}

}  // namespace

std::vector<Arrival> parse_arrivals(std::string_view name, std::string_view text,
                                    const Building& building) {
  std::vector<Arrival> arrivals;
  for (std::size_t count = 1; !text.empty(); ++count) {
    const std::size_t end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    const bool is_title = count == 1 && line.starts_with("seconds");
    if (line.empty() || line.front() == '#' || is_title) continue;
    try {
      if (arrivals.size() == arrivals_max) throw UsageError("more than a million arrivals");
      arrivals.push_back(parse_line(line, building));
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{} line {}: {}", name, count, failure.what()));
    }
  }
  if (arrivals.empty()) throw Failure(fmt::format("{}: nobody comes", name));
  return arrivals;
}

std::vector<Arrival> read_arrivals(const std::string& path, const Building& building) {
  const std::vector<std::uint8_t> bytes = read_value_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return parse_arrivals(path, text, building);
}

}  // namespace canvoy::tools
