// Channel groups of an MDF 4 file that hold CAN frames as ASAM's bus logging has them
// (CAN_DataFrame, CAN_RemoteFrame, CAN_ErrorFrame): where in a record each field stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/time.hpp"
#include "canvoy/formats/trace/trace_mf4_file.hpp"

namespace canvoy::formats {

// The data that a link of an MDF 4 file leads to, as one row of bytes: a block DT, SD or RD, one
// that zlib has compressed (DZ), or a list (DL, HL) of such blocks. Read in pieces, from front to
// back.
//
//     Mf4Data data(file, link);
//     std::string_view record = data.show(27);   // less at the end
//     data.take(27);

/// In memory it has a piece of 64 KiB, or a block that was compressed, up to 64 MiB.
class Mf4Data {
 public:
  /// `is_open_end`: the length of the last block may be missing; it goes to the end of the file.
  /// `file` has to outlive it.
  Mf4Data(Mf4File& file, std::uint64_t link, bool is_open_end);

  /// The next bytes, until the next call; fewer at the end of the data. At most show_max.
  std::string_view show(std::size_t size);
  /// Passes over them, whether they were shown or not; false where they are not all there.
  bool take(std::uint64_t size);
  /// Why nothing more is shown; empty where the data have ended as they should.
  std::string_view problem() const { return problem_; }
  /// The place in the file of what is read.
  std::uint64_t position() const { return piece_at_ - (is_packed_ ? 0 : bytes_.size() - done_); }

  /// Bytes.
  static constexpr std::size_t show_max = std::size_t{16} * 1024 * 1024;

 private:
  bool fill();
  bool next_piece();
  bool enter(std::uint64_t link);
  bool inflate(const Mf4Block& block);
  bool fail(std::string_view problem);

  Mf4File* file_;
  bool is_open_end_;
  std::uint64_t first_;     ///< a link that was not followed yet
  Mf4Block list_;           ///< a DL, of which the next piece is taken
  std::uint64_t item_ = 0;  ///< of the list; 0: there is none
  std::uint64_t piece_at_ = 0;
  std::uint64_t piece_left_ = 0;
  std::uint64_t total_ = 0;  ///< bytes of the file that were taken
  std::string bytes_;        ///< read and not yet taken, from done_ on
  std::size_t done_ = 0;
  bool is_packed_ = false;  ///< the piece was compressed: its place is that of its block
  std::string_view problem_;
};

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
