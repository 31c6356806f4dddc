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
  std::uint16_t index = 0;       ///< of the object
  std::uint8_t sub = 0;          ///< of the entry
  AbortCode code = {};           ///< that the access is answered with
  std::string_view when = {};    ///< condition, in words
  std::string_view clause = {};  ///< of the specification
};

/// Indices that belong to the objects of one device.
struct IndexRangeProvision {
  std::uint16_t first = 0;       ///< included
  std::uint16_t last = 0;        ///< included
  std::string_view owner = {};   ///< device that they belong to
  std::string_view clause = {};  ///< of the specification
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
  std::uint8_t code = 0;          ///< number of the virtual device
  std::uint8_t device_class = 0;  ///< 0: not used
  std::uint8_t subclass = 0;      ///< 0: not used
};
/// Devices that form a network together.
struct ConfigurationProvision {
  std::string_view name = {};            ///< of the configuration
  Items<ConfiguredDevice> devices = {};  ///< that belong together
  std::string_view clause = {};          ///< of the specification
};

/// A bit rate that devices of the profile support.
struct BitRateProvision {
  std::uint16_t kilobits_per_second = 0;    ///< 10 to 1000
  Category category = Category::mandatory;  ///< whether a device must support it
  std::string_view clause = {};             ///< of the specification
};

/// A rule in words: how instances are counted, how a bit rate is set.
struct RuleProvision {
  std::string_view subject = {};  ///< what it is about
  std::string_view rule = {};     ///< in words
  std::string_view clause = {};   ///< of the specification
};

/// A serious failure of a device, to which it reacts with its error behaviour (1029h).
struct FailureProvision {
  std::string_view failure = {};  ///< in words
  std::string_view clause = {};   ///< of the specification
};
// Failures that several profiles name.
/// Entry of a profile's list.
inline constexpr std::string_view bus_off_failure = "the CAN interface is bus-off";
/// Entry of a profile's list.
inline constexpr std::string_view life_guarding_failure = "a life guarding event has occurred";
/// Entry of a profile's list.
inline constexpr std::string_view heartbeat_failure = "a heartbeat event has occurred";

/// Coding of the bytes of a domain or string, selected by the value of another entry.
struct CodingProvision {
  std::uint16_t index = 0;        ///< of the object
  std::uint8_t sub = 0;           ///< of the entry
  std::uint16_t selector = 0;     ///< index of the entry (sub-index 00h) that selects; 0: none
  std::int64_t selected = 0;      ///< its value
  std::string_view content = {};  ///< what the bytes hold
  std::string_view coding = {};   ///< how they are coded
  std::string_view clause = {};   ///< of the specification
};
/// Bytes in such contents that are a command.
struct CommandProvision {
  std::uint16_t index = 0;        ///< of the object
  std::uint8_t sub = 0;           ///< of the entry
  std::uint16_t selector = 0;     ///< index of the entry that selects
  std::int64_t first = 0;         ///< values of the selector for which it holds
  std::int64_t last = 0;          ///< included
  std::uint16_t bytes = 0;        ///< one byte, or two with the first in the upper half
  std::string_view command = {};  ///< what it does
  std::string_view clause = {};   ///< of the specification
};

struct Provisions {
  Items<BitRateProvision> bit_rates = {};             ///< that devices support
  Items<IndexRangeProvision> index_ranges = {};       ///< by device
  Items<ConfigurationProvision> configurations = {};  ///< networks
  Items<AbortProvision> aborts = {};                  ///< beside those of CiA 301
  Items<FailureProvision> failures = {};              ///< of 1029h
  Items<RuleProvision> rules = {};                    ///< in words
  Items<CodingProvision> codings = {};                ///< of domains and strings
  Items<CommandProvision> commands = {};              ///< in such contents
};

}  // namespace canvoy
