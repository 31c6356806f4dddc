// The data that a link of an MDF 4 file leads to, as one row of bytes: a block DT, SD or RD, one
// that zlib has compressed (DZ), or a list (DL, HL) of such blocks. Read in pieces, from front to
// back.
//
//     Mf4Data data(file, link);
//     std::string_view record = data.show(27);   // less at the end
//     data.take(27);
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace_mf4_file.hpp"

namespace canvoy::formats {

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

}  // namespace canvoy::formats
