#include "canvoy/tools/play/time_zone.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>

namespace canvoy::tools {

namespace {

using bus_line::EpochSeconds;
using bus_line::OffsetChange;

/// Sets TZ during its lifetime.
class ZoneOfProcess {
 public:
  explicit ZoneOfProcess(const std::string& zone) {
    if (const char* const before = std::getenv("TZ")) before_ = before;
    set(":" + zone);
  }
  ~ZoneOfProcess() { set(before_); }
  ZoneOfProcess(const ZoneOfProcess&) = delete;
  ZoneOfProcess& operator=(const ZoneOfProcess&) = delete;

 private:
  static void set(const std::optional<std::string>& zone) {
    zone ? ::setenv("TZ", zone->c_str(), 1) : ::unsetenv("TZ");
    ::tzset();
  }

  std::optional<std::string> before_;
};

/// Offset of the time zone of the process.
std::int64_t offset_of_process(EpochSeconds utc) {
  std::tm local{};
  const std::time_t at = utc;
  ::localtime_r(&at, &local);
  return local.tm_gmtoff;
}

/// A name of the database, which does not leave its folder.
bool is_zone_name(std::string_view name) {
  const auto may_be_there = [](char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return std::isalnum(code) != 0 ||
           std::string_view("_+-/").find(letter) != std::string_view::npos;
  };
  return !name.empty() && name.front() != '/' && std::ranges::all_of(name, may_be_there);
}

/// The C library takes unknown names for UTC.
bool is_known(const std::string& zone) {
  if (!is_zone_name(zone)) return false;
  const char* const given = std::getenv("TZDIR");
  const std::string folder = given != nullptr ? given : "/usr/share/zoneinfo";
  std::ifstream file(folder + "/" + zone, std::ios::binary);
  constexpr std::string_view magic = "TZif";
  std::string begin(magic.size(), '\0');
  return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == magic;
}

/// End of the offset of `before`: after it, and `after` at the latest.
EpochSeconds end_of_offset(EpochSeconds before, EpochSeconds after) {
  const std::int64_t offset = offset_of_process(before);
  while (after - before > 1) {
    const EpochSeconds middle = before + (after - before) / 2;
    (offset_of_process(middle) == offset ? before : after) = middle;
  }
  return after;
}

}  // namespace

std::optional<std::vector<OffsetChange>> offsets_of(const std::string& zone,
                                                    std::chrono::sys_days first,
                                                    std::chrono::days days) {
  if (!is_known(zone)) return std::nullopt;
  // No clock is set twice within this time.
  constexpr EpochSeconds step = std::chrono::seconds(std::chrono::days(1)).count();
  const ZoneOfProcess in_zone(zone);
  EpochSeconds at = std::chrono::seconds(first.time_since_epoch()).count();
  std::vector<OffsetChange> changes{{at, offset_of_process(at)}};
  for (std::chrono::days day{1}; day <= days; ++day, at += step) {
    if (offset_of_process(at + step) == changes.back().offset) continue;
    const EpochSeconds since = end_of_offset(at, at + step);
    changes.push_back({since, offset_of_process(since)});
  }
  return changes;
}

}  // namespace canvoy::tools
