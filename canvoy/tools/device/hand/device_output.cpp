#include "canvoy/tools/device/hand/device_output.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "canvoy/text/first_characters.hpp"

namespace canvoy::tools {

namespace {

void write_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

std::string_view indication_text(Indication indication) {
  constexpr std::array<std::string_view, 8> texts = {
      "off",          "on",           "flickering",   "blinking",
      "single flash", "double flash", "triple flash", "quadruple flash"};
  return texts.at(static_cast<std::size_t>(indication));
}

void DeviceOutput::say(std::string_view who, std::string_view text) const {
  if (!json_) return write_line(fmt::format("{}: {}", who, text));
  write_line(nlohmann::ordered_json{{"device", who}, {"event", "text"}, {"text", text}}.dump());
}

void DeviceOutput::lights(std::string_view who, Indication run, Indication error) const {
  const std::string_view run_text = indication_text(run);
  const std::string_view error_text = indication_text(error);
  if (!json_) {
    return write_line(fmt::format("{}: lights: run {}, error {}", who, run_text, error_text));
  }
  write_line(nlohmann::ordered_json{
      {"device", who}, {"event", "lights"}, {"run", run_text}, {"error", error_text}}
                 .dump());
}

void DeviceOutput::draw(std::string_view who, std::span<const std::string> lines,
                        std::size_t columns, bool has_sign) const {
  if (json_) {
    return write_line(nlohmann::ordered_json{
        {"device", who},
        {"event", "display"},
        {"lines", std::vector<std::string>(lines.begin(), lines.end())},
        {"stop_sign",
         has_sign}}.dump());
  }
  std::string picture = fmt::format("{}:\n  +{:-<{}}+\n", who, "", columns + 2);
  for (const std::string& line : lines) {
    picture += fmt::format("  | {} |\n", text::first_characters(line, columns));
  }
  write_line(picture + fmt::format("  +{:-<{}}+{}", "", columns + 2, has_sign ? "  [ STOP ]" : ""));
}

void LightsTeller::look() {
  const Indication run = indicators_.run();
  const Indication error = indicators_.error();
  if (run == run_ && error == error_) return;
  run_ = run;
  error_ = error;
  output_.lights(who_, run, error);
}

}  // namespace canvoy::tools
