// A bus as input of `canvoy load`, from any source: its messages, their senders, and how much was
// heard.
//
//     LoadedBus bus = ...;
//     const std::vector<timing::Response> responses = timing::response_times(model_of(bus));
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/timing/bus_message.hpp"

namespace canvoy::tools {

struct LoadedMessage {
  timing::BusMessage timing{};
  unsigned bytes = 0;          ///< of the longest frame
  std::string name{};          ///< empty: none
  std::string service{};       ///< `TPDO1`
  NodeId node = 0;             ///< 0: none, or unknown
  std::uint64_t frames = 0;    ///< number of frames heard; 0: planned
  double bits_per_second = 0;  ///< as heard; if planned, with the maximum number of stuff bits
};

struct LoadedBus {
  std::string name{};
  std::uint32_t bit_rate = 0;  ///< bit/s; 0: unknown
  timing::ErrorModel errors{};
  std::vector<LoadedMessage> messages{};
  Duration heard{};                     ///< zero: planned
  std::uint64_t error_frames = 0;       ///< number of error frames heard
  std::vector<std::string> left_out{};  ///< messages that cannot be counted, with the reason
};

/// Text of an identifier: `185`, `18FEF100`.
std::string id_text(const timing::BusMessage& message);
/// Title of a message: `speed`, or `TPDO1 5`; with an R in front for a remote frame.
std::string title(const LoadedMessage& message);
/// Completes a planned message: the maximum number of stuff bits, due before the next one, and
/// unless known, service and node from its identifier.
void complete(LoadedMessage& message);

/// Throws UsageError if the bit rate is unknown.
timing::BusModel model_of(const LoadedBus& bus);
/// Adds messages to the bus. Throws Failure if two have the same identifier, or there are more than
/// messages_max.
void add_messages(LoadedBus& bus, std::vector<LoadedMessage> more);

inline constexpr std::size_t messages_max = 1024;

}  // namespace canvoy::tools
