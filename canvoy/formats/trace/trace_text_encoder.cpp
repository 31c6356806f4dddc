#include "canvoy/formats/trace/trace_text_encoder.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <optional>

#include "canvoy/can/host/candump_log.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::formats {

namespace {

// An interface's name ends at a blank; those of other systems have blanks in them.
std::string_view candump_name(std::string_view channel, std::string& room) {
  if (channel.empty()) return "can0";
  if (std::ranges::none_of(channel, [](char each) { return each <= ' ' && each >= 0; }))
    return channel;
  room = channel;
  std::ranges::replace_if(
      room, [](char each) { return each <= ' ' && each >= 0; }, '_');
  return room;
}

class CandumpEncoder final : public TraceEncoder {
 public:
  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override {
    std::string room;
    host::append_log_line(bytes, frame.time.time_since_epoch(), candump_name(frame.channel, room),
                          frame.frame);
  }
};

// Of each name a channel from 1 on. can0 is channel 1, a name without a number as well; where a
// number is taken by another name, the next free one is taken: two buses do not become one.
class ChannelNumbers {
 public:
  std::size_t operator[](std::string_view channel) {
    if (channel.empty()) channel = "can0";
    const auto known = std::ranges::find(names_, channel);
    if (known != names_.end()) return static_cast<std::size_t>(known - names_.begin()) + 1;
    const std::size_t wanted = wanted_place(channel);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      std::string& name = names_[(wanted + i) % names_.size()];
      if (!name.empty()) continue;
      name = channel;
      return (wanted + i) % names_.size() + 1;
    }
    return wanted + 1;  // more than there are numbers: they share
  }

 private:
  static std::size_t wanted_place(std::string_view channel) {
    const std::size_t letters = channel.find_last_not_of("0123456789");
    if (letters != std::string_view::npos) channel.remove_prefix(letters + 1);
    std::int64_t number = 0;
    const bool is_one = read_decimal(channel, number) && number < TraceChannel::number_max;
    return is_one ? static_cast<std::size_t>(number) : 0;
  }

  std::array<std::string, TraceChannel::number_max> names_;
};

template <class... Values>
void append_formatted(std::string& bytes, const char* format, Values... values) {
  std::array<char, 96> room{};
  const int length = std::snprintf(room.data(), room.size(), format, values...);
  if (length > 0)
    bytes.append(room.data(), std::min(static_cast<std::size_t>(length), room.size() - 1));
}

class AscEncoder final : public TraceEncoder {
 public:
  explicit AscEncoder(std::optional<Time> begin) : begin_(begin) {}

  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override;

 private:
  static void append_header(std::string& bytes, std::chrono::sys_seconds start);
  static void append_content(std::string& bytes, const TraceFrame& frame);

  std::optional<Time> begin_;
  std::optional<Duration> start_;
  ChannelNumbers channels_;
};

void AscEncoder::append(std::string& bytes, const TraceFrame& frame, std::string_view) {
  if (!start_) {
    const Duration first = std::max(begin_.value_or(frame.time).time_since_epoch(), Duration{});
    const auto second = std::chrono::floor<std::chrono::seconds>(first);
    append_header(bytes, std::chrono::sys_seconds{second});
    start_ = second;
  }
  const long long offset = (time_from(frame, *start_) - *start_).count();
  append_formatted(bytes, "%4lld.%06lld %-2zu", offset / 1'000'000, offset % 1'000'000,
                   channels_[frame.channel]);
  append_content(bytes, frame);
  bytes += '\n';
}

void AscEncoder::append_header(std::string& bytes, std::chrono::sys_seconds start) {
  static constexpr std::array<const char*, 7> days = {"Sun", "Mon", "Tue", "Wed",
                                                      "Thu", "Fri", "Sat"};
  static constexpr std::array<const char*, 12> months = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                         "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const auto day = std::chrono::floor<std::chrono::days>(start);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{start - day};
  append_formatted(
      bytes, "date %s %s %u %02d:%02d:%02d %d\n", days[std::chrono::weekday{day}.c_encoding()],
      months[static_cast<unsigned>(date.month()) - 1], static_cast<unsigned>(date.day()),
      static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
      static_cast<int>(clock.seconds().count()), static_cast<int>(date.year()));
  bytes += "base hex  timestamps absolute\nno internal events logged\n";
}

void AscEncoder::append_content(std::string& bytes, const TraceFrame& frame) {
  const Frame& content = frame.frame;
  if (content.is_error()) {
    bytes += " ErrorFrame";
    return;
  }
  std::array<char, 12> id{};
  std::snprintf(id.data(), id.size(), content.is_extended() ? "%Xx" : "%X", content.id);
  append_formatted(bytes, " %-15s %s   %c %u", id.data(),
                   frame.direction == TraceDirection::sent ? "Tx" : "Rx",
                   content.is_remote() ? 'r' : 'd', unsigned{content.length});
  for (const std::uint8_t byte : content.payload())
    append_formatted(bytes, " %02X", unsigned{byte});
}

}  // namespace

std::unique_ptr<TraceEncoder> make_candump_encoder() {
  return std::make_unique<CandumpEncoder>();
}

std::unique_ptr<TraceEncoder> make_asc_encoder(std::optional<Time> begin) {
  return std::make_unique<AscEncoder>(begin);
}

}  // namespace canvoy::formats
