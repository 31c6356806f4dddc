// Virtual inputs by multiplexed PDOs (CiA 301, 7.2.3): a panel without a separate PDO for 6010h
// sends its records by the MPDO with CAN-ID 500h + node-ID.
//
// A record has 48 bits, and a multiplexed PDO carries 32 of one object. Therefore each record is
// sent in two parts, one after the other: manufacturer-specific objects of our own, since no source
// at hand describes other implementations.
//
// - 5F10h Virtual input in parts (panel): sub-index 1 and 2. For source address mode: scanner
//   entry 02 5F10 01h; the consumer's dispatching list puts both into 5F11h.
// - 5F11h Virtual inputs of panels in parts (controller): 2n - 1 and 2n are those of node-ID n.
//   In destination address mode the panel names them by its own node-ID.
//
// Part 1 has the bytes 0 to 3 of the record. Part 2 has the bytes 4 and 5, a count, and the
// exclusive or of these seven bytes, so that parts of different records are not combined.
//
//     VirtualMpdoProducer mpdos(node, tpdos, mpdo_producer, panel.mapping(), {.number = 2});
//     VirtualMpdoConsumer consumer(node);    // writes each record into 6010h
#pragma once

#include "canvoy/canopen/pdo/mpdo_producer.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_mapping.hpp"
#include "canvoy/profiles/cia417/inputs.hpp"
#include "canvoy/profiles/cia417/values.hpp"

namespace canvoy::cia417 {

/// As in 5F10h and 5F11h.
inline constexpr EntryInfo record_part = {.name = "Part #",
                                          .type = DataType::unsigned32,
                                          .access = Access::ro,
                                          .mapping = Mapping::optional,
                                          .initial = 0,
                                          .value = hexadecimal};
/// A part of a record of node-ID 1 and up.
constexpr EntryInfo received_part() {
  EntryInfo entry = record_part;
  entry.access = Access::rw;
  entry.sub_first = 1;
  entry.first_number = 1;
  entry.sub_last = 2 * node_id_max;
  return entry;
}
/// Both parts of a record to send.
inline constexpr EntryInfo record_parts_entries[] = {number_of_entries(2), at(1, record_part),
                                                     at(2, record_part)};
/// Both parts of a record, for each node-ID.
inline constexpr EntryInfo received_parts_entries[] = {number_of_entries(2 * node_id_max),
                                                       received_part()};
/// Where a panel has the parts of a record.
inline constexpr ObjectInfo record_parts_object = {.index = 0x5F10,
                                                   .code = ObjectCode::array,
                                                   .name = "Virtual input in parts",
                                                   .category = Category::optional,
                                                   .clause = "manufacturer-specific",
                                                   .subs = record_parts_entries};
/// Where a controller receives the parts, at 2n - 1 and 2n for node-ID n.
inline constexpr ObjectInfo received_parts_object = {.index = 0x5F11,
                                                     .code = ObjectCode::array,
                                                     .name = "Virtual inputs of panels in parts",
                                                     .category = Category::optional,
                                                     .clause = "manufacturer-specific",
                                                     .subs = received_parts_entries};

/// A record in transfer.
struct RecordParts {
  std::uint32_t first = 0;   ///< four bytes of the record
  std::uint32_t second = 0;  ///< two bytes of the record, a count and a check byte
};
/// Parts of a record. `count` differs from record to record, so that parts of two records do not
/// match.
constexpr RecordParts split(std::uint64_t record, std::uint8_t count) {
  unsigned check = count;
  for (unsigned i = 0; i < 6; ++i) check ^= static_cast<unsigned>(record >> (8 * i)) & 0xFF;
  const auto last_bytes = static_cast<std::uint32_t>(record >> 32) & 0xFFFF;
  return {static_cast<std::uint32_t>(record),
          last_bytes | std::uint32_t{count} << 16 | check << 24};
}
/// False if the parts do not belong together.
constexpr bool join(const RecordParts& parts, std::uint64_t& record) {
  record = parts.first | std::uint64_t{parts.second & 0xFFFF} << 32;
  const auto count = static_cast<std::uint8_t>(parts.second >> 16);
  return split(record, count).second == parts.second;
}

/// The TPDO and its consumer.
struct VirtualMpdoSettings {
  std::uint16_t number = 1;  ///< number of the multiplexed TPDO; its mode is in its mapping record
  NodeId consumer = 0;       ///< for destination address mode; 0: all nodes
};

/// The side of the panel. No record is lost through inhibit time or a busy bus. In source address
/// mode, the node has 5F10h, and the scanner lists both of its parts in their order.
class VirtualMpdoProducer {
 public:
  /// All arguments must outlive this.
  VirtualMpdoProducer(Node& node, Tpdos& tpdos, MpdoProducer& producer, VirtualMapping& mapping,
                      const VirtualMpdoSettings& settings);

 private:
  bool is_working();
  void announce();
  void go_on(Time now);
  void before_transmit(std::uint16_t number);
  AbortCode before_read(const Entry& entry);
  void state_entered(NmtState state);
  bool is_destination() const;
  bool tell(std::uint8_t part);
  bool change(std::uint8_t part, std::uint32_t value);

  static const AccessHandlers hook_calls[1];
  static const ServiceHandlers service_calls;

  Node& node_;
  Tpdos& tpdos_;
  MpdoProducer& producer_;
  VirtualMapping& mapping_;
  VirtualMpdoSettings settings_;
  Callback<void(std::uint16_t)> former_;
  Timer timer_;
  HandlerBinding service_{&service_calls, this};
  RecordParts parts_;
  std::uint8_t part_ = parts_told;  ///< the next part to send
  std::uint8_t count_ = 0;          ///< of records
  bool changed_ = false;            ///< source address mode: a part waits to be sampled
  bool transmitting_ = false;

  static constexpr std::uint8_t parts_told = 3;
};

/// The side of the controller: a record received in 5F11h is written to 6010h, or another object,
/// when it is complete, like a record received by PDO.
class VirtualMpdoConsumer {
 public:
  /// `node` has 5F11h and the object `mapping`, and must outlive this.
  explicit VirtualMpdoConsumer(Node& node,
                               std::uint16_t mapping = virtual_input_mapping_object.index)
      : node_(node), mapping_(mapping) {
    node.attach(service_);
  }

 private:
  void written(const Entry& entry, Source source);

  static const AccessHandlers hook_calls[1];
  static const ServiceHandlers service_calls;

  Node& node_;
  std::uint16_t mapping_;
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
