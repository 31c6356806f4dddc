// The bits of 1F80h for a master and of 1F81h for each of its slaves (CiA 302-2, NMT start-up and
// slave assignment).
//
//     const SlaveAssignment slave = slave_assignment(node.dictionary(), 5);
//     if (slave.is_slave() && slave.is_mandatory()) ...
#pragma once

#include <cstdint>

#include "canvoy/can/time.hpp"
#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"

namespace canvoy {

/// Objects of an NMT master; in arrays, the sub-index is the node-ID of a slave.
namespace master_object {
inline constexpr std::uint16_t nmt_inhibit_time = 0x102A;  ///< in 100 us
inline constexpr std::uint16_t nmt_startup = 0x1F80;       ///< of the master: NmtStartup
inline constexpr std::uint16_t slave_assignment = 0x1F81;  ///< of each slave: SlaveAssignment
inline constexpr std::uint16_t request_nmt = 0x1F82;       ///< see NmtRequests
inline constexpr std::uint16_t request_guarding = 0x1F83;  ///< see NmtRequests
inline constexpr std::uint16_t device_type = 0x1F84;       ///< expected 1000h; 0: any
inline constexpr std::uint16_t vendor_id = 0x1F85;         ///< expected 1018h:01h; 0: any
inline constexpr std::uint16_t product_code = 0x1F86;      ///< expected 1018h:02h; 0: any
inline constexpr std::uint16_t revision_number = 0x1F87;   ///< expected 1018h:03h; 0: any
inline constexpr std::uint16_t serial_number = 0x1F88;     ///< expected 1018h:04h; 0: any
inline constexpr std::uint16_t boot_time = 0x1F89;         ///< in ms; 0: no limit
/// Sub-index of the slave's 1011h that restores its configuration; 0: none.
inline constexpr std::uint16_t restore_configuration = 0x1F8A;
}  // namespace master_object

/// Value of 1F80h.
struct NmtStartup {
  std::uint32_t raw = 0;  ///< as in the dictionary

  static constexpr std::uint32_t known_bits = 0x7F;  ///< others are reserved

  /// True if this device is the NMT master, or may become it (bit 0).
  constexpr bool is_master() const { return bit(0); }
  /// True if all slaves are started by one command; otherwise each by its own.
  constexpr bool starts_all_at_once() const { return bit(1); }
  /// True if the master enters operational by itself (bit 2 not set).
  constexpr bool enters_operational() const { return !bit(2); }
  /// True if the master starts its slaves by itself (bit 3 not set).
  constexpr bool starts_slaves() const { return !bit(3); }
  /// True if the loss of a mandatory slave resets all nodes (bit 4); otherwise that slave alone.
  constexpr bool resets_all_on_error() const { return bit(4); }
  /// True if the master negotiates with others (bit 5): see FlyingMaster.
  constexpr bool is_flying_master() const { return bit(5); }
  /// True if an error stops all nodes; takes precedence over resets_all_on_error().
  constexpr bool stops_all_on_error() const { return bit(6); }
  /// True if a device without an NMT master enters operational by itself: 08h.
  constexpr bool is_self_starting() const { return !is_master() && bit(3) && !bit(2); }

 private:
  constexpr bool bit(unsigned number) const { return (raw >> number & 1U) != 0; }
};

/// Value of an entry of 1F81h.
struct SlaveAssignment {
  std::uint32_t raw = 0;  ///< as in the dictionary

  /// True if the node is a slave of this master (bit 0); otherwise it is not in its list (A).
  constexpr bool is_slave() const { return bit(0); }
  /// True if the master boots and starts the slave; otherwise it only monitors it.
  constexpr bool is_booted() const { return bit(2); }
  /// True if the network does not start without it (bit 3).
  constexpr bool is_mandatory() const { return bit(3); }
  /// True if the slave is not reset while it is operational.
  constexpr bool is_kept_alive() const { return bit(4); }
  /// True if its program version is compared (bit 5).
  constexpr bool has_verified_program() const { return bit(5); }
  /// True if its program may be replaced (bit 6).
  constexpr bool has_updated_program() const { return bit(6); }
  /// True if its defaults are restored (1F8Ah) before it is configured.
  constexpr bool is_restored() const { return bit(7); }
  /// Number of guarding answers that may be missing (bits 15 to 8); 0: no guarding.
  constexpr std::uint8_t retry_factor() const { return static_cast<std::uint8_t>(raw >> 8); }
  /// Guard time in milliseconds (bits 31 to 16); zero: no guarding.
  constexpr Duration guard_time() const { return std::chrono::milliseconds(raw >> 16); }

 private:
  constexpr bool bit(unsigned number) const { return (raw >> number & 1U) != 0; }
};

/// Value of 1F80h; without the object, 0: not a master.
inline NmtStartup nmt_startup(const Dictionary& dictionary) {
  return {static_cast<std::uint32_t>(dictionary.number(master_object::nmt_startup, 0))};
}
/// Value of 1F81h for a slave; without the entry, 0: not a slave.
inline SlaveAssignment slave_assignment(const Dictionary& dictionary, NodeId slave) {
  return {static_cast<std::uint32_t>(dictionary.number(master_object::slave_assignment, slave))};
}

/// Limit of a node's silence by the consumer heartbeat times (1016h) of this dictionary; zero if
/// the node is absent there. Linear in the number of entries.
inline Duration heartbeat_time(const Dictionary& dictionary, NodeId slave) {
  constexpr std::uint16_t consumer_heartbeat = object_index::heartbeat_consumers;
  const auto count = static_cast<unsigned>(dictionary.number(consumer_heartbeat, 0));
  for (unsigned sub = 1; sub <= count; ++sub) {
    const auto entry = static_cast<std::uint32_t>(
        dictionary.number(consumer_heartbeat, static_cast<std::uint8_t>(sub)));
    if (entry >> 16 == slave) return std::chrono::milliseconds(entry & 0xFFFFU);
  }
  return Duration::zero();
}

}  // namespace canvoy
