// Channel groups of an MDF 4 file that hold CAN frames as ASAM's bus logging has them
// (CAN_DataFrame, CAN_RemoteFrame, CAN_ErrorFrame): where in a record each field stands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/formats/trace/trace_mf4_file.hpp"

namespace canvoy::formats {

/// A number of a record. It has up to 64 bits and may begin within a byte.
struct Mf4Field {
  /// How its bytes are read.
  enum class Type : std::uint8_t { none, little, big, real_little, real_big };

  std::uint32_t byte = 0;  ///< its first, from 0 on
  std::uint8_t bit = 0;    ///< its lowest in that, 0 to 7
  std::uint8_t bits = 0;   ///< 1 to 64
  Type type = Type::none;  ///< none: it is not there
  double offset = 0;       ///< of its unit: value = offset + factor * number
  double factor = 1;       ///< units a count

  /// Whether the group has it.
  bool is_there() const { return type != Type::none; }
  /// Its bits; 0 where it is not there. The record has to be whole.
  std::uint64_t number(std::string_view record) const;
  /// In its unit.
  double value(std::string_view record) const;
};

/// What the records of a group are.
enum class Mf4Kind : std::uint8_t { other, data, remote, error, lengths };

/// How the records of a channel group are laid out.
struct Mf4Group {
  Mf4Kind kind = Mf4Kind::other;  ///< lengths: each record has its length, then as many bytes
  std::uint64_t at = 0;           ///< of the block
  std::uint64_t id = 0;           ///< of records, where several groups share a row of them
  std::uint64_t count = 0;        ///< of records, as the file says
  std::uint64_t size = 0;         ///< of a record

  Mf4Field time = {};           ///< in seconds from the beginning of the file
  Mf4Field bus = {};            ///< BusChannel
  Mf4Field identifier = {};     ///< ID
  Mf4Field extended = {};       ///< IDE
  Mf4Field code = {};           ///< DLC
  Mf4Field length = {};         ///< DataLength
  Mf4Field direction = {};      ///< Dir: 0 received
  Mf4Field fd = {};             ///< EDL
  Mf4Field bit_rate = {};       ///< BRS
  Mf4Field state = {};          ///< ESI
  std::uint32_t data_byte = 0;  ///< where the bytes of a frame stand
  std::uint32_t data_size = 0;  ///< 0: none, or elsewhere
  Mf4Field data_offset = {};    ///< of their place elsewhere
  std::uint64_t data_link = 0;  ///< a block of data, or the group of lengths
};

/// All groups of a data group whose block is `group`.
std::vector<Mf4Group> read_mf4_groups(Mf4File& file, const Mf4Block& group);

}  // namespace canvoy::formats
