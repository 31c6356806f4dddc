// The lines that a gateway sends: answers to commands, and events without a command (CiA 309-3).
//
//     answer_line(7, Answer::ok(), {});              // [7] OK
//     event_line(Event::boot_up(1, 5), {});          // 1 5 BOOT_UP
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/canopen/emergency/emergency.hpp"
#include "canvoy/canopen/manager/boot_error.hpp"
#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/gateway/error_code.hpp"
#include "canvoy/gateway/value.hpp"

namespace canvoy::gateway {

/// How lines are written.
struct Style {
  Version version = Version::v3_0;  ///< edition of CiA 309-3
  /// Errors carry their meaning in words: as a comment, or in parentheses (always in edition 2.1).
  bool explain = false;
};

/// The outcome of a command: a text (OK, or a value), an error of the gateway, or the abort code of
/// an SDO server.
struct Answer {
  std::string text;                   ///< OK or a value; empty if it failed
  ErrorCode error = ErrorCode::none;  ///< of the gateway
  AbortCode abort = AbortCode::none;  ///< of an SDO server

  /// Success without a value.
  static Answer ok() { return {.text = "OK"}; }
  /// Success with the text of a value.
  static Answer value(std::string text) { return {.text = std::move(text)}; }
  /// Failure, by the gateway.
  static Answer failed(ErrorCode error) { return {.text = {}, .error = error}; }
  /// Failure, by an SDO server or for one of its reasons.
  static Answer failed(AbortCode abort) { return {.text = {}, .abort = abort}; }
  /// True for success.
  bool good() const { return error == ErrorCode::none && abort == AbortCode::none; }

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Something that happens on a network without a command.
struct Event {
  /// What happened.
  enum class Kind : std::uint8_t { emergency, pdo, boot_up, error, booted };

  Kind kind = Kind::error;                    ///< which of the members below count
  std::uint16_t net = 0;                      ///< number of the network
  NodeId node = 0;                            ///< 0: the gateway's own connection to the bus
  Emergency emergency = {};                   ///< with its code, register and bytes
  std::uint16_t pdo = 0;                      ///< number of the PDO
  std::vector<std::uint64_t> values = {};     ///< values of the PDO
  ErrorCode error = ErrorCode::none;          ///< of a node, or of the gateway
  BootError boot_error = BootError::none;     ///< of the boot-up procedure; none: it has booted
  NmtState state = NmtState::initialisation;  ///< state of the slave that was booted

  /// An emergency message of a node.
  static Event of(std::uint16_t net, NodeId node, const Emergency& emergency) {
    return {.kind = Kind::emergency, .net = net, .node = node, .emergency = emergency};
  }
  /// An RPDO with its values.
  static Event of(std::uint16_t net, std::uint16_t pdo, std::vector<std::uint64_t> values) {
    return {.kind = Kind::pdo, .net = net, .pdo = pdo, .values = std::move(values)};
  }
  /// An error of a node (of the gateway: node 0) that no command has caused.
  static Event of(std::uint16_t net, NodeId node, ErrorCode error) {
    return {.kind = Kind::error, .net = net, .node = node, .error = error};
  }
  /// Error 205 (boot_up), which the protocol writes as a word.
  static Event boot_up(std::uint16_t net, NodeId node) {
    return {.kind = Kind::boot_up, .net = net, .node = node};
  }
  /// How the boot-up procedure of a slave ended (CiA 302-2).
  static Event booted(std::uint16_t net, NodeId node, BootError error, NmtState state) {
    return {.kind = Kind::booted, .net = net, .node = node, .boot_error = error, .state = state};
  }
};

// Both lines end with CR and LF.
/// Line of an answer, with the number of its command.
std::string answer_line(std::uint32_t sequence, const Answer& answer, const Style& style);
/// Line of an event.
std::string event_line(const Event& event, const Style& style);

/// Text of a PDO, as `1 pdo 3 2 0x12 0x3456`: network, PDO, number of values, values.
std::string pdo_text(std::uint16_t net, std::uint16_t pdo, std::span<const std::uint64_t> values);

}  // namespace canvoy::gateway
