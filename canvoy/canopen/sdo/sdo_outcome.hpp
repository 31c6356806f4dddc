// How a request by SDO ended: done, aborted by one side or the other, without an answer, or
// cancelled (CiA 301, 7.2.4.3.17). The abort code alone does not tell: 0504 0000h is what a client
// says that waited in vain, and what a server may say 76 ms after the request.
//
//     void answered(SdoOutcome outcome) {
//       if (outcome) return take(*outcome);                    // bytes
//       if (outcome.is_silence()) return try_again();          // nobody answered
//       tell(outcome.kind(), outcome.abort());
//     }
#pragma once

#include <cstddef>
#include <cstdint>

#include "canvoy/canopen/dictionary/abort_code.hpp"

namespace canvoy {

/// How it ended, and the abort code that goes with that.
class SdoEnd {
 public:
  enum class Kind : std::uint8_t {
    done,
    aborted_by_server,  ///< its answer, whatever the code
    aborted_by_client,  ///< this side found a fault in an answer, has no room, or did not begin
    no_answer,          ///< within the time-out; the server is told 0504 0000h
    cancelled,          ///< this node may not go on: its NMT state or its channel changed
  };

  constexpr SdoEnd() = default;
  /// What this side decided; none: done.
  constexpr SdoEnd(AbortCode own)  // NOLINT(google-explicit-constructor): as return value
      : kind_(own == AbortCode::none ? Kind::done : Kind::aborted_by_client), abort_(own) {}

  /// A server that aborts with the code 0 means something else.
  static constexpr SdoEnd by_server(AbortCode code) {
    return {Kind::aborted_by_server, code == AbortCode::none ? AbortCode::general : code};
  }
  static constexpr SdoEnd no_answer() { return {Kind::no_answer, AbortCode::time_out}; }
  static constexpr SdoEnd cancelled(AbortCode reason) { return {Kind::cancelled, reason}; }

  constexpr explicit operator bool() const { return kind_ == Kind::done; }
  constexpr Kind kind() const { return kind_; }
  /// none where it is done; else the code that went over the bus, or would have.
  constexpr AbortCode abort() const { return abort_; }
  /// Nobody answered in time.
  constexpr bool is_silence() const { return kind_ == Kind::no_answer; }
  /// The server says no, with whatever code: it is there.
  constexpr bool is_refusal() const { return kind_ == Kind::aborted_by_server; }

  friend constexpr bool operator==(const SdoEnd&, const SdoEnd&) = default;

 private:
  constexpr SdoEnd(Kind kind, AbortCode code) : kind_(kind), abort_(code) {}

  Kind kind_ = Kind::done;
  AbortCode abort_ = AbortCode::none;
};

/// The server has no such entry.
constexpr bool is_absent(const SdoEnd& end) {
  return end.is_refusal() && is_absent(end.abort());
}

/// The same, and of a request that is done the number of bytes that were transferred.
class SdoOutcome : public SdoEnd {
 public:
  constexpr SdoOutcome(std::size_t bytes)  // NOLINT(google-explicit-constructor): as return value
      : bytes_(bytes) {}
  constexpr SdoOutcome(SdoEnd end)  // NOLINT(google-explicit-constructor): as return value
      : SdoEnd(end) {}
  constexpr SdoOutcome(AbortCode own)  // NOLINT(google-explicit-constructor): as return value
      : SdoEnd(own) {}

  /// 0 where it is not done.
  constexpr std::size_t operator*() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

}  // namespace canvoy
