// The end of an SDO request: done, aborted by one side, without an answer, or cancelled. The abort
// code alone is ambiguous: 0504 0000h is the code of a client without an answer, and a server may
// send it 76 ms after the request (CiA 301, 7.2.4.3.17).
//
//     void answered(SdoOutcome outcome) {
//       if (outcome) return take(*outcome);                    // bytes
//       if (outcome.is_silence()) return try_again();          // nobody answered
//       tell(outcome.kind(), outcome.abort());
//     }
#pragma once

#include <cstddef>
#include <cstdint>

#include "canvoy/canopen/protocol/abort_code.hpp"

namespace canvoy {

/// Kind of end, and the abort code that belongs to it.
class SdoEnd {
 public:
  /// Which side ended the request, and how.
  enum class Kind : std::uint8_t {
    done,
    aborted_by_server,  ///< by an answer of the server, with any code
    aborted_by_client,  ///< a wrong answer, no room, or not started
    no_answer,          ///< within the time-out; 0504 0000h is sent to the server
    cancelled,          ///< the NMT state or the channel of this node changed
  };

  constexpr SdoEnd() = default;
  /// Result of this side; none: done.
  constexpr SdoEnd(AbortCode own)  // NOLINT(google-explicit-constructor): as return value
      : kind_(own == AbortCode::none ? Kind::done : Kind::aborted_by_client), abort_(own) {}

  /// An abort of the server with code 0 becomes another code.
  static constexpr SdoEnd by_server(AbortCode code) {
    return {Kind::aborted_by_server, code == AbortCode::none ? AbortCode::general : code};
  }
  /// No answer came within the time-out: 0504 0000h was sent.
  static constexpr SdoEnd no_answer() { return {Kind::no_answer, AbortCode::time_out}; }
  /// The client ended it without an answer of the server.
  static constexpr SdoEnd cancelled(AbortCode reason) { return {Kind::cancelled, reason}; }

  constexpr explicit operator bool() const { return kind_ == Kind::done; }
  /// Which side ended it.
  constexpr Kind kind() const { return kind_; }
  /// none if it is done; otherwise the code that was sent, or would have been.
  constexpr AbortCode abort() const { return abort_; }
  /// True if no answer came in time.
  constexpr bool is_silence() const { return kind_ == Kind::no_answer; }
  /// True if the server refused, with any code: it is present.
  constexpr bool is_refusal() const { return kind_ == Kind::aborted_by_server; }

  friend constexpr bool operator==(const SdoEnd&, const SdoEnd&) = default;
  /// A code does not say which side ended it: compare abort(), or ask for kind().
  friend constexpr bool operator==(const SdoEnd&, AbortCode) = delete;

 private:
  constexpr SdoEnd(Kind kind, AbortCode code) : kind_(kind), abort_(code) {}

  Kind kind_ = Kind::done;
  AbortCode abort_ = AbortCode::none;
};

/// True if the server has no such entry.
constexpr bool is_absent(const SdoEnd& end) {
  return end.is_refusal() && is_absent(end.abort());
}

/// Like SdoEnd, but for a finished request also with the number of bytes that were transferred.
class SdoOutcome : public SdoEnd {
 public:
  /// A request that is done.
  constexpr SdoOutcome(std::size_t bytes)  // NOLINT(google-explicit-constructor): as return value
      : bytes_(bytes) {}
  /// A request that has ended in one of the other ways, or is done without bytes.
  constexpr SdoOutcome(SdoEnd end)  // NOLINT(google-explicit-constructor): as return value
      : SdoEnd(end) {}
  /// Result of this side; none: done.
  constexpr SdoOutcome(AbortCode own)  // NOLINT(google-explicit-constructor): as return value
      : SdoEnd(own) {}

  /// Number of bytes; 0 if it is not done.
  constexpr std::size_t operator*() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

}  // namespace canvoy
