// A bus as `canvoy load` sees it, wherever it is from: what is sent on it, by whom, and how much of
// it was heard.
//
//     LoadedBus bus = ...;
//     const std::vector<timing::Response> responses = timing::response_times(model_of(bus));
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/timing/bus_message.hpp"

namespace canvoy::tools {

struct LoadedMessage {
  timing::BusMessage timing{};
  unsigned bytes = 0;          ///< of the longest frame
  std::string name{};          ///< empty: it has none
  std::string service{};       ///< `TPDO1`
  NodeId node = 0;             ///< 0: none, or not known
  std::uint64_t frames = 0;    ///< that were heard; 0: it is planned
  double bits_per_second = 0;  ///< as heard; as planned, with as many stuff bits as can be
};

struct LoadedBus {
  std::string name{};
  std::uint32_t bit_rate = 0;  ///< bit/s; 0: not known
  timing::ErrorModel errors{};
  std::vector<LoadedMessage> messages{};
  Duration heard{};                     ///< zero: it is planned
  std::uint64_t error_frames = 0;       ///< that were heard
  std::vector<std::string> left_out{};  ///< what is sent and cannot be counted, and why
};

/// `185`, `18FEF100`
std::string id_text(const timing::BusMessage& message);
/// `speed`, or `TPDO1 5`; of a remote frame with an R in front.
std::string title(const LoadedMessage& message);
/// One that is planned, with as many stuff bits as can be, which is due before the next. Its
/// service and node are those of its identifier, unless they are known.
void complete(LoadedMessage& message);

/// Throws UsageError where the bit rate is not known.
timing::BusModel model_of(const LoadedBus& bus);
/// Puts them on the bus. Throws Failure where one has the identifier of another, or there are more
/// than messages_max.
void add_messages(LoadedBus& bus, std::vector<LoadedMessage> more);

inline constexpr std::size_t messages_max = 1024;

}  // namespace canvoy::tools
