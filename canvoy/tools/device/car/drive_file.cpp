#include "canvoy/tools/device/car/drive_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/value_file.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

std::string passed_over_text(const car::DriveRecord& record) {
  const car::DriveRecord::Counts& counts = record.counts;
  const std::pair<std::uint32_t, std::string_view> kinds[] = {
      {counts.lines.wrong_checksum, "with a wrong checksum, or none"},
      {counts.lines.malformed, "with a field that cannot be"},
      {counts.lines.garbage, "that are no sentence"},
      {counts.out_of_order, "that come after later ones"},
      {counts.impossible, "with a speed that cannot be"}};
  std::vector<std::string> parts;
  for (const auto& [count, text] : kinds) {
    if (count != 0) parts.push_back(fmt::format("{} {}", count, text));
  }
  if (parts.empty()) return {};
  const std::uint64_t lines = std::uint64_t{counts.lines.accepted} + counts.lines.not_wanted +
                              counts.lines.wrong_checksum + counts.lines.malformed +
                              counts.lines.garbage;
  return fmt::format("{} of {} lines are passed over: {}", counts.passed_over(), lines,
                     fmt::join(parts, ", "));
}

std::shared_ptr<const car::DriveRecord> read_drive_file(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_value_file(path);
  auto record = std::make_shared<const car::DriveRecord>(
      car::read_drive_record(std::string(bytes.begin(), bytes.end())));
  const std::string passed_over = passed_over_text(*record);
  if (!record->is_usable()) {
    throw Failure(fmt::format(
        "{}: no car moves in it: there is no RMC, GGA or VTG of NMEA 0183 that says so{}{}", path,
        passed_over.empty() ? "" : "; ", passed_over));
  }
  if (!passed_over.empty()) print_message(fmt::format("canvoy: {}: {}", path, passed_over));
  return record;
}

}  // namespace canvoy::tools
