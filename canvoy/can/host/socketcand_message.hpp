// What a socketcand and its clients say to each other (its doc/protocol.md): messages as
// `< frame 123 23.424242 1122 >`, one after the other.
//
//     SocketcandMessages messages;
//     messages.add(bytes);
//     while (const auto message = messages.next()) ...          // "frame 123 23.424242 1122"
//     const auto heard = parse_socketcand_frame(*message);
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "canvoy/can/frame.hpp"

namespace canvoy::host {

/// `< send 123 2 11 22 >`, and `< sendrtr 123 2 >` of a remote frame. Eight digits of the
/// identifier mean 29 bits.
std::string socketcand_send_message(const Frame& frame);

/// The frame of a `frame`, `rtr` or `error` message, without its brackets; nothing where it is
/// malformed, or another message. Data may be in one word or in several; of an error frame only the
/// class is told.
std::optional<Frame> parse_socketcand_frame(std::string_view message);

/// Messages out of pieces of a stream. What is in no brackets is passed over; one that is longer
/// than any can be is dropped and counted, so that memory is bounded.
class SocketcandMessages {
 public:
  static constexpr std::size_t length_max = 256;

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// The next whole one, without brackets and blanks around; it is good until the next call.
  std::optional<std::string_view> next();
  /// How many were dropped since it was asked.
  std::uint64_t take_malformed() { return std::exchange(malformed_, 0); }
  void clear();

 private:
  std::string bytes_;
  std::size_t read_ = 0;
  std::uint64_t malformed_ = 0;
};

}  // namespace canvoy::host
