// The messages between a socketcand and its clients (its doc/protocol.md): messages such as `<
// frame 123 23.424242 1122 >`, one after the other.
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

/// Message for a frame: `< send 123 2 11 22 >`, and `< sendrtr 123 2 >` for a remote frame. Eight
/// digits of the identifier mean 29 bits.
std::string socketcand_send_message(const Frame& frame);

/// Frame in a `frame`, `rtr` or `error` message, without its brackets; nothing if it is malformed,
/// or another message. Data may be in one word or in several; an error frame has the class only.
std::optional<Frame> parse_socketcand_frame(std::string_view message);

/// Assembles messages from pieces of a stream. Text outside of brackets is skipped; a message
/// longer than any valid one is dropped and counted, so that memory is limited.
class SocketcandMessages {
 public:
  /// Characters of a message; a longer one is dropped.
  static constexpr std::size_t length_max = 256;

  /// Appends a piece of the stream, of any length.
  void add(std::string_view bytes) { bytes_ += bytes; }
  /// Next complete message, without brackets and surrounding blanks; valid until the next call.
  std::optional<std::string_view> next();
  /// Number of messages dropped since the last call.
  std::uint64_t take_malformed() { return std::exchange(malformed_, 0); }
  /// Discards what is incomplete, for a new connection.
  void clear();

 private:
  std::string bytes_;
  std::size_t read_ = 0;
  std::uint64_t malformed_ = 0;
};

}  // namespace canvoy::host
