// Provisions of a profile beside its objects, PDOs and devices: bit rates, devices that belong
// together, failures, codings of domains. They are for documents and files; nodes do not need them.
//
//     for (const AbortProvision& each : cia417::profile.provisions->aborts) show(each.code);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/protocol/abort_code.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy {

/// Abort code with which a device refuses an access. Where there are several, the device chooses.
struct AbortProvision {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  AbortCode code = {};
  std::string_view when = {};
  std::string_view clause = {};
};

/// Indices that belong to the objects of one device.
struct IndexRangeProvision {
  std::uint16_t first = 0;
  std::uint16_t last = 0;
  std::string_view owner = {};
  std::string_view clause = {};
};

/// Adjacent ranges of `pitch` indices, one for each owner.
template <std::size_t count>
constexpr std::array<IndexRangeProvision, count> ranges_of(
    unsigned first, unsigned pitch, const std::array<std::string_view, count>& owners,
    std::string_view clause) {
  std::array<IndexRangeProvision, count> ranges{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = static_cast<std::uint16_t>(first + i * pitch);
    ranges[i] = {begin, static_cast<std::uint16_t>(begin + pitch - 1), owners[i], clause};
  }
  return ranges;
}

/// A virtual device of a configuration; class and subclass 0: not used.
struct ConfiguredDevice {
  std::uint8_t code = 0;
  std::uint8_t device_class = 0;
  std::uint8_t subclass = 0;
};
/// Devices that form a network together.
struct ConfigurationProvision {
  std::string_view name = {};
  Items<ConfiguredDevice> devices = {};
  std::string_view clause = {};
};

struct BitRateProvision {
  std::uint16_t kilobits_per_second = 0;
  Category category = Category::mandatory;
  std::string_view clause = {};
};

/// A rule in words: how instances are counted, how a bit rate is set.
struct RuleProvision {
  std::string_view subject = {};
  std::string_view rule = {};
  std::string_view clause = {};
};

/// A serious failure of a device, to which it reacts with its error behaviour (1029h).
struct FailureProvision {
  std::string_view failure = {};
  std::string_view clause = {};
};
// Failures that several profiles name.
inline constexpr std::string_view bus_off_failure = "the CAN interface is bus-off";
inline constexpr std::string_view life_guarding_failure = "a life guarding event has occurred";
inline constexpr std::string_view heartbeat_failure = "a heartbeat event has occurred";

/// Coding of the bytes of a domain or string, selected by the value of another entry.
struct CodingProvision {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint16_t selector = 0;  ///< index of the entry (sub-index 00h) that selects; 0: none
  std::int64_t selected = 0;   ///< its value
  std::string_view content = {};
  std::string_view coding = {};
  std::string_view clause = {};
};
/// Bytes in such contents that are a command.
struct CommandProvision {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint16_t selector = 0;
  std::int64_t first = 0;  ///< values of the selector for which it holds
  std::int64_t last = 0;
  std::uint16_t bytes = 0;  ///< one byte, or two with the first in the upper half
  std::string_view command = {};
  std::string_view clause = {};
};

struct Provisions {
  Items<BitRateProvision> bit_rates = {};
  Items<IndexRangeProvision> index_ranges = {};
  Items<ConfigurationProvision> configurations = {};
  Items<AbortProvision> aborts = {};
  Items<FailureProvision> failures = {};
  Items<RuleProvision> rules = {};
  Items<CodingProvision> codings = {};
  Items<CommandProvision> commands = {};
};

}  // namespace canvoy
