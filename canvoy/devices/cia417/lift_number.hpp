// The lift number of a physical device (6001h): a bit for each lift that it belongs to (CiA 417-4,
// 4.2.2).
//
//     LiftNumber lift_number(node, {});   // one lift: the one whose objects the dictionary has
//
// A device of one lift refuses more than one bit, a device of several lifts (a gateway, a group
// controller) those of which it has no objects: with 0609 0030h, since the clause names no code.
//
// Objects of lift n stand at (n - 1) * 0800h above those of lift 1. That is laid out when a device
// is built: one that is to become a device of another lift is built anew, when `changed` has told
// its owner. Without `changed`, a lift of which the device has no objects is refused.
#pragma once

#include "canvoy/canopen/node.hpp"
#include "canvoy/devices/cia417/virtual_io.hpp"
#include "canvoy/profiles/cia417/physical.hpp"

namespace canvoy::cia417 {

struct LiftNumberSettings {
  bool several = false;  ///< it stands for several lifts
  /// The lift number was written; `lifts` has a bit for each.
  Callback<void(std::uint8_t lifts)> changed = {};
};

/// The lifts of which a dictionary has objects: a bit for each. Linear in the number of objects.
constexpr std::uint8_t lifts_of(const DictionaryTables& tables) {
  unsigned lifts = 0;
  for (const ObjectRow& object : tables.objects) {
    for (unsigned lift = 1; lift <= lift_count; ++lift) {
      const unsigned block = 0x6000 + (lift - 1) * block_pitch;
      const bool is_in_block =
          object.index<block + block_pitch&& unsigned{object.index} + object.count> block + 0x100;
      if (is_in_block) lifts |= lift_bit(lift);
    }
  }
  return static_cast<std::uint8_t>(lifts);
}

class LiftNumber {
 public:
  /// `node` has 6001h, and must outlive this.
  LiftNumber(Node& node, const LiftNumberSettings& settings);
  LiftNumber(const LiftNumber&) = delete;
  LiftNumber& operator=(const LiftNumber&) = delete;

  /// As it stands in 6001h: a bit for each lift.
  std::uint8_t lifts() const;

 private:
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);

  static const HookCalls hook_calls[1];
  Node& node_;
  LiftNumberSettings settings_;
  HookLink hooks_{hook_calls, this};
};

}  // namespace canvoy::cia417
