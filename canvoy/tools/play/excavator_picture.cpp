#include "canvoy/tools/play/excavator_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "canvoy/text/text.hpp"
#include "canvoy/text/time_text.hpp"
#include "canvoy/tools/play/excavator_text.hpp"
#include "canvoy/tools/player/world_text.hpp"

namespace canvoy::tools {

namespace {

using excavator::ExcavatorSnapshot;

constexpr int picture_columns = 40;
constexpr int picture_lines = 11;
constexpr double metres_a_column = 0.28;
constexpr double metres_a_line = 0.9;
constexpr double top_metres = 7;
constexpr int axis_column = 6;  ///< axis of the slew

using Canvas = std::vector<std::string>;

void set_letter(Canvas& canvas, const Excavator::Point& at, char letter) {
  const int column = axis_column + static_cast<int>(std::lround(at.x / metres_a_column));
  const int line = static_cast<int>(std::lround((top_metres - at.z) / metres_a_line));
  if (column < 0 || column >= picture_columns || line < 0 || line >= picture_lines) return;
  canvas[static_cast<std::size_t>(line)][static_cast<std::size_t>(column)] = letter;
}

void draw_line(Canvas& canvas, const Excavator::Point& from, const Excavator::Point& to,
               char letter) {
  constexpr int parts = 40;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    set_letter(canvas, {from.x + share * (to.x - from.x), from.z + share * (to.z - from.z)},
               letter);
  }
}

/// `<---o---->` with the hand in it.
std::string slider_text(double place) {
  constexpr int half = 4;
  std::string text(2 * half + 1, '-');
  text[half] = '|';
  const int at = half + static_cast<int>(std::lround(place * half));
  text[static_cast<std::size_t>(std::clamp(at, 0, 2 * half))] = 'O';
  return text;
}

std::string lamps_line(const ExcavatorSnapshot& now) {
  constexpr std::array<std::string_view, excavator::lamp_count> names = {
      "light", "beacon", "fast", "locked", "FAULT", "fuel", "hot", "ready"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("{}{} ", now.lit[i] ? "(*)" : "( )", names[i]);
  }
  return text;
}

std::string shown_text(std::int16_t value, std::string_view unit) {
  return value == excavator::no_value ? "--" : fmt::format("{} {}", value, unit);
}

/// Beside the arm, line by line.
std::vector<std::string> seat_lines(const ExcavatorSnapshot& now) {
  const auto hand = [&now](Movement movement) {
    return slider_text(now.hands[static_cast<std::size_t>(movement)]);
  };
  const auto shown = [&now](excavator::Shown what, std::string_view unit) {
    return shown_text(now.display[static_cast<std::size_t>(what)], unit);
  };
  using excavator::Shown;
  return {
      fmt::format("left  stick {}", hand(Movement::stick)),
      fmt::format("      slew  {}", hand(Movement::slew)),
      fmt::format("right boom  {}", hand(Movement::boom)),
      fmt::format("     bucket {}", hand(Movement::bucket)),
      fmt::format("pedals {} {}", hand(Movement::left_track), hand(Movement::right_track)),
      fmt::format("display  fuel {:<7} oil {}", shown(Shown::fuel, "%"), shown(Shown::oil, "degC")),
      fmt::format("  slew {:<9} {}", shown(Shown::slew, "deg"), shown(Shown::rpm, "rpm")),
      fmt::format("  tip {} high, {} out", shown(Shown::height, "cm"), shown(Shown::reach, "cm")),
      fmt::format("horn {}  light {}  beacon {}", now.switched[0] ? "TOOT" : "-",
                  now.switched[1] ? "on" : "off", now.switched[2] ? "on" : "off"),
  };
}

}  // namespace

std::string arm_picture(const ExcavatorSnapshot& now) {
  Canvas canvas(picture_lines, std::string(picture_columns, ' '));
  for (int column = 0; column < picture_columns; ++column) {
    set_letter(canvas, {(column - axis_column) * metres_a_column, 0}, '_');
  }
  draw_line(canvas, {-1.4, 0.9}, {1.2, 0.9}, '=');
  draw_line(canvas, {-1.4, 1.8}, {0.2, 1.8}, '#');
  draw_line(canvas, now.arm[0], now.arm[1], 'B');
  draw_line(canvas, now.arm[1], now.arm[2], 's');
  draw_line(canvas, now.arm[2], now.arm[3], now.statistics.earth.in_bucket > 0.1 ? '@' : 'u');
  std::string text;
  for (const std::string& line : canvas) text += line + "\n";
  return text;
}

std::string WorldText<excavator::ExcavatorNetwork>::picture(excavator::ExcavatorNetwork& network,
                                                            double speed) {
  const ExcavatorSnapshot now = network.snapshot();
  std::string text = fmt::format(
      "Canvoy: an excavator, CiA 852 on {} kbit/s   {}{}\n\n", network.options().bit_rate / 1000,
      text::duration_text(now.at - Time{}), speed > 0 ? fmt::format("  (x{:g})", speed) : "");
  const std::string arm = arm_picture(now);
  const std::vector<std::string> seat = seat_lines(now);
  std::size_t line = 0;
  for (std::size_t at = 0; at < arm.size(); ++line) {
    const std::size_t end = arm.find('\n', at);
    text += fmt::format("{}{}\n", arm.substr(at, end - at), line < seat.size() ? seat[line] : "");
    at = end + 1;
  }
  text += "  " + lamps_line(now) + "\n";
  text += fmt::format("  heap {:.1f} m3, bucket {:.1f} m3; {} cycles; slewed to {:.0f} deg\n",
                      now.statistics.earth.heaped, now.statistics.earth.in_bucket,
                      now.statistics.cycles, now.angles[0]);
  for (std::size_t i = 0; i < now.nodes.size(); ++i) {
    text += fmt::format("  {} {}", now.names[i], tools::state_text(now.nodes[i]));
  }
  text += fmt::format("\n  bus load {:.1f} %, {} frames, {} error frames\n", now.bus.load * 100,
                      now.bus.frames, now.bus.error_frames);
  const auto events = network.events();
  constexpr std::size_t shown = 4;
  for (const excavator::ExcavatorEvent& event : events.last(std::min(shown, events.size()))) {
    text += fmt::format("  {:>16}  {:.60}\n", text::duration_text(event.at - Time{}),
                        WorldText<excavator::ExcavatorNetwork>::event(event, network).text);
  }
  return text;
}

}  // namespace canvoy::tools
