#include "canvoy/worlds/car/drive_record.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "canvoy/devices/cia447/navigation/geography.hpp"

namespace canvoy::car {

namespace {

Duration since_midnight(const cia447::GpsTime& time) {
  constexpr double microseconds = 1e6;
  return std::chrono::hours(time.hour) + std::chrono::minutes(time.minute) +
         Duration(std::llround(time.second * microseconds));
}

/// State of the car at one time.
struct Fix {
  Duration at{};
  std::optional<double> speed;
  std::optional<cia447::GeoPosition> place;
};

class Reader {
 public:
  explicit Reader(DriveRecord& record) : record_(record) {}

  void read() {
    const std::string_view text = record_.text;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size() - 1) + 1;
      const std::uint32_t before = receiver_.counts().accepted;
      receiver_.receive(text.substr(begin, end - begin));
      // The last line may have no end.
      if (end == text.size()) receiver_.receive('\n');
      if (receiver_.counts().accepted != before) {
        line_accepted(begin, kind_of(text.substr(begin, end - begin)));
      }
      if (is_open_) record_.said.back().end = end;
      begin = end;
    }
    close();
    record_.counts.lines = receiver_.counts();
    find_speeds();
    find_legs();
  }

 private:
  /// `RMC`, for a sentence that was accepted.
  static std::string_view kind_of(std::string_view line) {
    return line.substr(line.rfind('$') + 1).substr(2, 3);
  }

  void line_accepted(std::size_t begin, std::string_view kind) {
    const cia447::GpsReading reading = receiver_.reading();
    if (!reading.time) return;
    if (!clock_ || *clock_ != *reading.time) begin_second(*reading.time, begin);
    if (!is_open_) return;
    // Values of another second are outdated.
    if (kind == "RMC" || kind == "VTG") fix_.speed = reading.velocity;
    if (kind != "RMC" && kind != "GGA") return;
    fix_.place.reset();
    if (reading.latitude && reading.longitude) fix_.place = {*reading.latitude, *reading.longitude};
  }

  void begin_second(const cia447::GpsTime& time, std::size_t begin) {
    constexpr Duration day = 24h;
    close();
    const Duration now = since_midnight(time);
    Duration passed = clock_ ? now - since_midnight(*clock_) : Duration{};
    if (passed < -day / 2) passed += day;
    if (clock_ && passed <= Duration{}) {
      ++record_.counts.out_of_order;
      return;
    }
    if (passed > DriveRecord::gap_max) passed = 1s;
    at_ += passed;
    clock_ = time;
    is_open_ = true;
    fix_ = {.at = at_, .speed = {}, .place = {}};
    record_.said.push_back({at_, begin, begin});
  }

  void close() {
    if (is_open_ && (fix_.speed || fix_.place)) fixes_.push_back(fix_);
    is_open_ = false;
  }

  void find_speeds() {
    for (std::size_t i = 0; i < fixes_.size(); ++i) {
      std::optional<double> speed = fixes_[i].speed;
      if (!speed && i > 0) speed = speed_between(fixes_[i - 1], fixes_[i]);
      if (!speed) continue;
      if (!(*speed <= DriveRecord::fastest)) {
        ++record_.counts.impossible;
        continue;
      }
      record_.samples.push_back(
          {fixes_[i].at, *speed < DriveRecord::standing ? 0.0 : std::max(0.0, *speed)});
    }
    record_.counts.accepted = static_cast<std::uint32_t>(record_.samples.size());
  }
  static std::optional<double> speed_between(const Fix& from, const Fix& to) {
    if (!from.place || !to.place) return std::nullopt;
    const double seconds = std::chrono::duration<double>(to.at - from.at).count();
    return cia447::metres_between(*from.place, *to.place) / seconds;
  }

  void find_legs() {
    const std::vector<DriveRecord::Sample>& samples = record_.samples;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      if (samples[i].speed <= 0 && samples[i + 1].speed <= 0) continue;
      std::vector<DriveRecord::Leg>& legs = record_.legs;
      const bool goes_on = !legs.empty() && samples[i].at - legs.back().end < DriveRecord::arrival;
      if (!goes_on) legs.push_back({samples[i].at, samples[i].at});
      legs.back().end = samples[i + 1].at;
    }
  }

  DriveRecord& record_;
  cia447::NmeaReceiver receiver_;
  std::optional<cia447::GpsTime> clock_;  ///< of the last second that was taken
  Duration at_{};
  bool is_open_ = false;  ///< a second, for more lines
  Fix fix_;
  std::vector<Fix> fixes_;
};

}  // namespace

DriveRecord read_drive_record(std::string text) {
  DriveRecord record;
  record.text = std::move(text);
  Reader(record).read();
  return record;
}

}  // namespace canvoy::car
