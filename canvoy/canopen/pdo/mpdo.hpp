// Multiplexed PDOs: each frame carries one value and the object that it belongs to (CiA 301, 7.2.3,
// objects 1FA0h to 1FCFh and 1FD0h to 1FFFh).
//
// In destination address mode (DAM) a frame names the object of the consumer that gets the value,
// in source address mode (SAM) the object of the producer that it comes from. A PDO is multiplexed
// if sub-index 00h of its mapping record is FFh (DAM) or FEh (SAM); its transmission type is 254 or
// 255.
//
// The layouts are derived from what other stacks send and receive, not from the text of CiA 301.
//
//     PdoImage image = encode(Mpdo{.mode = MpdoMode::destination, .node = 10, .index = 0x6000});
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_mapping.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

inline constexpr unsigned sub_index_max = 0xFF;   ///< the highest sub-index
inline constexpr std::uint8_t mpdo_data_max = 4;  ///< bytes of one value

/// Contents of one frame.
struct Mpdo {
  MpdoMode mode = MpdoMode::destination;  ///< from the upper bit of the first byte
  NodeId node = 0;                        ///< DAM: the consumer, 0 for all; SAM: the producer
  std::uint16_t index = 0;                ///< object that the mode refers to
  std::uint8_t sub = 0;                   ///< sub-index of the value
  std::array<std::uint8_t, mpdo_data_max> data = {};  ///< a shorter value comes first

  friend constexpr bool operator==(const Mpdo&, const Mpdo&) = default;
};

/// The frame's eight bytes: flag and node-ID, index, sub-index, data.
inline PdoImage encode(const Mpdo& mpdo) {
  constexpr std::uint8_t destination_bit = 0x80;
  PdoImage image{};
  image[0] = mpdo.node;
  if (mpdo.mode == MpdoMode::destination) image[0] |= destination_bit;
  store(&image[1], mpdo.index);
  image[3] = mpdo.sub;
  store(&image[4], mpdo.data);
  return image;
}

/// Takes eight bytes apart. Any eight bytes are a multiplexed PDO; a shorter frame is none.
inline Mpdo decode_mpdo(const std::uint8_t* data) {
  constexpr std::uint8_t node_mask = 0x7F;
  Mpdo mpdo;
  mpdo.mode = data[0] > node_mask ? MpdoMode::destination : MpdoMode::source;
  mpdo.node = data[0] & node_mask;
  mpdo.index = load<std::uint16_t>(data + 1);
  mpdo.sub = data[3];
  mpdo.data = load<std::array<std::uint8_t, mpdo_data_max>>(data + 4);
  return mpdo;
}

namespace detail {

/// Number of sub-indices of a list entry: a block of size 0 is a single object.
constexpr unsigned block_size(unsigned written) {
  return written == 0 ? 1 : written;
}

}  // namespace detail

/// An entry of an object scanner list (1FA0h to 1FCFh): an object that a SAM producer sends. Zero:
/// unused.
struct ScannerEntry {
  std::uint16_t index = 0;  ///< object in the producer
  std::uint8_t sub = 0;     ///< the first
  unsigned block_size = 1;  ///< consecutive sub-indices, up to FFh
};
/// Takes an entry apart: block size (bits 24 to 31, 0 counts as 1), index, sub-index.
constexpr ScannerEntry decode_scanner_entry(std::uint32_t value) {
  return {static_cast<std::uint16_t>(value >> 8), static_cast<std::uint8_t>(value),
          detail::block_size(value >> 24)};
}

/// An entry of an object dispatching list (1FD0h to 1FFFh): the object in which a SAM consumer
/// stores what a producer sends. Zero: unused.
struct DispatcherEntry {
  NodeId producer = 0;               ///< node-ID, 1 to 127
  std::uint16_t producer_index = 0;  ///< object in the producer
  std::uint8_t producer_sub = 0;     ///< the first
  std::uint16_t index = 0;           ///< of the consumer's object
  std::uint8_t sub = 0;              ///< the first
  unsigned block_size = 1;           ///< consecutive sub-indices of both objects

  /// True if the entry says where this value is stored.
  constexpr bool covers(const Mpdo& mpdo) const {
    return producer == mpdo.node && producer_index == mpdo.index && mpdo.sub >= producer_sub &&
           mpdo.sub - producer_sub < static_cast<int>(block_size);
  }
};
/// Takes an entry of 64 bits apart: block size, index and sub-index here, those there, producer.
constexpr DispatcherEntry decode_dispatcher_entry(std::uint64_t value) {
  return {.producer = static_cast<NodeId>(value),
          .producer_index = static_cast<std::uint16_t>(value >> 16),
          .producer_sub = static_cast<std::uint8_t>(value >> 8),
          .index = static_cast<std::uint16_t>(value >> 40),
          .sub = static_cast<std::uint8_t>(value >> 32),
          .block_size = detail::block_size(static_cast<unsigned>(value >> 56))};
}

/// Indices of the objects of both kinds of lists, and of PDO parameters.
namespace mpdo_list {
inline constexpr std::uint16_t rpdo_first = object_index::rpdo_parameter;              ///< 1400h
inline constexpr std::uint16_t rpdo_last = object_index::rpdo_parameter_last;          ///< 15FFh
inline constexpr std::uint16_t tpdo_first = object_index::tpdo_parameter;              ///< 1800h
inline constexpr std::uint16_t tpdo_last = object_index::tpdo_parameter_last;          ///< 19FFh
inline constexpr std::uint16_t scanner_first = object_index::scanner_list;             ///< 1FA0h
inline constexpr std::uint16_t scanner_last = object_index::scanner_list_last;         ///< 1FCFh
inline constexpr std::uint16_t dispatcher_first = object_index::dispatching_list;      ///< 1FD0h
inline constexpr std::uint16_t dispatcher_last = object_index::dispatching_list_last;  ///< 1FFFh
}  // namespace mpdo_list

/// Checks a write to a communication parameter of a PDO: a valid multiplexed PDO must be
/// event-driven, in whatever order the parameters are written. Abort: parameter_incompatible.
inline AbortCode check_mpdo_parameter(const Dictionary& dictionary, const Entry& entry,
                                      std::span<const std::uint8_t> value) {
  const auto wanted = static_cast<std::uint32_t>(load_unsigned(value));
  const auto becomes = [&](std::uint8_t sub, std::uint32_t absent) {
    return entry.sub == sub ? wanted : dictionary.word(entry.index, sub, absent);
  };
  const auto mapping = static_cast<std::uint16_t>(entry.index + pdo_count_max);
  const CobId cob_id{becomes(pdo_sub::cob_id, CobId::bit31)};
  const std::uint32_t type = becomes(pdo_sub::transmission_type, transmission_type::event_profile);
  const bool fits = !cob_id.valid() || type >= transmission_type::event_manufacturer ||
                    mpdo_mode(dictionary.word(mapping, 0, 0)) == MpdoMode::none;
  return fits ? AbortCode::none : AbortCode::parameter_incompatible;
}

}  // namespace canvoy
