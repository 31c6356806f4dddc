#include "canvoy/tools/play/settings.hpp"

#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

std::string setting_line(std::string_view key, std::string_view value, std::string_view help,
                         std::string_view example, bool is_help_of_example) {
  const std::string comment = help.empty() ? "" : fmt::format("  # {}", help);
  if (value.empty())
    return example.empty() ? "" : fmt::format("# {} = {}{}\n", key, example, comment);
  return fmt::format("{} = {}{}\n", key, value, is_help_of_example ? "" : comment);
}

namespace detail {

void take_time(TomlTable& table, std::string_view key, Duration& to,
               SettingLimits<Duration> limits) {
  table.take(key, to, Duration::zero());
  if (!table.has(key) || (to >= limits.least && to <= limits.most)) return;
  if (limits.most == Duration::max()) {
    table.refuse(key, fmt::format("{} is too short", written(to)));
  }
  table.refuse(key, fmt::format("{} is not from {} to {}", written(to), written(limits.least),
                                written(limits.most)));
}

std::string value_text(bool value) {
  return value ? "true" : "false";
}
std::string value_text(double value) {
  return fmt::format("{}", value);
}
std::string value_text(const std::string& value) {
  return value.empty() ? value : text_value(value);
}
std::string value_text(Duration value) {
  return value == Duration{} ? "" : fmt::format("\"{}\"", written(value));
}
std::string value_text(Time value) {
  return fmt::format("\"{}\"", written(value - Time{}));
}
std::string value_text(CivilTime value) {
  return date_value(value);
}

std::string in_file(double value) {
  return value_text(value);
}
std::string in_file(const std::string& value) {
  return text_value(value);
}
std::string in_file(const std::vector<double>& value) {
  return fmt::format("[{}]", fmt::join(value, ", "));
}
std::string in_file(const std::vector<std::string>& value) {
  std::vector<std::string> texts;
  texts.reserve(value.size());
  for (const std::string& each : value) texts.push_back(text_value(each));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string range_words(const SettingLimits<Duration>& limits) {
  const std::string_view what = "a time, as `\"30s\"`";
  return limits.most == Duration::max()
             ? std::string(what)
             : fmt::format("{}, from {} to {}", what, written(limits.least), written(limits.most));
}

}  // namespace detail

}  // namespace canvoy::tools
