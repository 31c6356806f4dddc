#include "canvoy/formats/trace/trace_blf_encoder.hpp"

#include <zlib.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace_blf_numbers.hpp"
#include "canvoy/formats/trace/trace_error.hpp"
#include "canvoy/formats/trace/trace_fields.hpp"
#include "canvoy/formats/trace/trace_packet.hpp"

namespace canvoy::formats {

namespace {

constexpr std::size_t container_size_max = 128 * 1024;
constexpr std::uint32_t nanosecond_stamps = 2;
/// Nanoseconds have 64 bits.
constexpr Duration relative_time_max{std::numeric_limits<std::uint64_t>::max() / 1000};
constexpr std::uint16_t compressed_by_zlib = 2;
constexpr std::uint32_t application = 5;

/// Year, month, day of the week, day, hour, minute, second, millisecond, 16 bits each.
void append_date(std::string& bytes, Duration since_1970) {
  const std::chrono::sys_time<Duration> time{since_1970};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{std::chrono::floor<std::chrono::milliseconds>(time) - day};
  const auto put = [&bytes](auto number) {
    append_little(bytes, static_cast<std::uint64_t>(number), 2);
  };
  put(static_cast<int>(date.year()));
  put(static_cast<unsigned>(date.month()));
  put(std::chrono::weekday{day}.c_encoding());
  put(static_cast<unsigned>(date.day()));
  put(clock.hours().count());
  put(clock.minutes().count());
  put(clock.seconds().count());
  put(clock.subseconds().count());
}

class BlfEncoder final : public TraceEncoder {
 public:
  explicit BlfEncoder(std::optional<Time> begin) : start_(begin) {
    append_object_head(BlfKind::message, message_size, 0);
    objects_in_.copy(message_.data(), objects_in_.size());
    objects_in_.clear();
  }

  // final_header() supplies what is not known yet.
  void begin(std::string& bytes) override { bytes += header(); }

  void append(std::string& bytes, const TraceFrame& frame, std::string_view) override {
    if (!start_.is_known()) start_.set(frame);
    last_ = time_from(frame, start_.value(), start_.value() + relative_time_max);
    const auto nanoseconds = static_cast<std::uint64_t>((last_ - start_.value()).count()) * 1000;
    const bool has_register = frame.frame.is_error() && sja1000_register(frame.frame).has_value();
    const BlfKind kind = !frame.frame.is_error() ? BlfKind::message
                         : has_register          ? BlfKind::error_ext
                                                 : BlfKind::error;
    if (kind == BlfKind::message) {
      append_message(frame, nanoseconds);
    } else {
      append_object_head(kind, has_register ? error_ext_size : error_size, nanoseconds);
      append_error(frame, has_register);
    }
    ++objects_;
    if (objects_in_.size() >= container_size_max) append_container(bytes);
  }

  void end(std::string& bytes) override {
    if (!objects_in_.empty()) append_container(bytes);
  }

  std::string final_header() const override { return header(); }

 private:
  static constexpr std::size_t message_size = 16;
  static constexpr std::size_t time_at = 24;  ///< the last 8 bytes of the head
  static constexpr std::size_t error_size = 8;
  static constexpr std::size_t error_ext_size = 32;

  std::string header() const {
    std::string bytes(blf_file_mark);
    append_little(bytes, blf_header_size, 4);
    for (const std::uint32_t byte : {application, 0U, 0U, 0U, 2U, 6U, 8U, 1U}) {
      append_little(bytes, byte, 1);
    }
    append_little(bytes, blf_header_size + packed_, 8);
    append_little(bytes, blf_header_size + unpacked_, 8);
    append_little(bytes, objects_, 4);
    append_little(bytes, 0, 4);
    const Duration first = start_.is_known() ? start_.value() : Duration{};
    append_date(bytes, first);
    append_date(bytes, std::max(last_, first));
    bytes.resize(blf_header_size, '\0');
    return bytes;
  }

  void append_object_head(BlfKind kind, std::size_t content_size, std::uint64_t nanoseconds) {
    objects_in_ += blf_object_mark;
    append_little(objects_in_, blf_object_header_size, 2);
    append_little(objects_in_, 1, 2);
    append_little(objects_in_, blf_object_header_size + content_size, 4);
    append_little(objects_in_, static_cast<std::uint32_t>(kind), 4);
    append_little(objects_in_, nanosecond_stamps, 4);
    append_little(objects_in_, 0, 4);
    append_little(objects_in_, nanoseconds, 8);
  }

  // Nearly all objects: its head, then channel, flags, data length code, identifier, data.
  void append_message(const TraceFrame& heard, std::uint64_t nanoseconds) {
    const Frame& frame = heard.frame;
    const bool is_sent = heard.direction == TraceDirection::sent;
    std::array<char, blf_object_header_size + message_size> object = message_;
    char* at = object.data() + time_at;
    const auto put = [&at](auto number) {
      std::memcpy(at, &number, sizeof(number));
      at += sizeof(number);
    };
    put(nanoseconds);
    put(static_cast<std::uint16_t>(channels_[heard.channel]));
    put(static_cast<std::uint8_t>((is_sent ? blf_sent_bit : 0U) |
                                  (frame.is_remote() ? blf_remote_bit : 0U)));
    put(frame.length);
    put(frame.id | (frame.is_extended() ? extended_flag : 0U));
    put(frame.data);
    objects_in_.append(object.data(), object.size());
  }

  // Only the extended object has the register, after the flag for an SJA1000.
  void append_error(const TraceFrame& heard, bool has_register) {
    constexpr std::uint64_t is_sja1000 = 1;
    append_little(objects_in_, channels_[heard.channel], 2);
    append_little(objects_in_, 0, 2);
    if (!has_register) return append_little(objects_in_, 0, 4);
    append_little(objects_in_, is_sja1000, 4);
    append_little(objects_in_, sja1000_register(heard.frame).value_or(0), 1);
    objects_in_.append(error_ext_size - 9, '\0');
  }

  void append_container(std::string& bytes) {
    uLongf size = ::compressBound(objects_in_.size());
    packed_room_.resize(size);
    ::compress2(reinterpret_cast<Bytef*>(packed_room_.data()), &size,
                reinterpret_cast<const Bytef*>(objects_in_.data()), objects_in_.size(),
                Z_BEST_SPEED);
    const std::size_t object_size = blf_container_header_size + size;
    bytes += blf_object_mark;
    append_little(bytes, blf_base_size, 2);
    append_little(bytes, 1, 2);
    append_little(bytes, object_size, 4);
    append_little(bytes, static_cast<std::uint32_t>(BlfKind::container), 4);
    append_little(bytes, compressed_by_zlib, 2);
    append_little(bytes, 0, 6);
    append_little(bytes, objects_in_.size(), 4);
    append_little(bytes, 0, 4);
    bytes.append(packed_room_, 0, size);
    bytes.append(object_size % 4, '\0');
    packed_ += object_size + object_size % 4;
    unpacked_ += blf_container_header_size + objects_in_.size();
    objects_in_.clear();
  }

  TraceStart start_;
  TraceChannelNumbers channels_;
  Duration last_{};
  std::array<char, blf_object_header_size + message_size> message_{};  ///< only its head
  std::string objects_in_;                                             ///< of the current container
  std::string packed_room_;
  std::uint64_t packed_ = 0;
  std::uint64_t unpacked_ = 0;
  std::uint64_t objects_ = 0;
};

}  // namespace

std::unique_ptr<TraceEncoder> make_blf_encoder(std::optional<Time> begin) {
  return std::make_unique<BlfEncoder>(begin);
}

}  // namespace canvoy::formats
