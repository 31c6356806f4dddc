// The blocks of an ASAM MDF 4 file: a header of 24 bytes, links to other blocks, and data.
//
//     Mf4File file(source);
//     std::optional<Mf4Block> header = file.block(mf4_header_at, "HD");
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace_file.hpp"

namespace canvoy::formats {

/// A file begins with it.
inline constexpr std::string_view mf4_mark = "MDF     ";
/// Its writer has not come to the end: counts and lengths may be missing.
inline constexpr std::string_view mf4_unfinished_mark = "UnFinMF ";
/// Where the block HD stands, behind what the file is.
inline constexpr std::uint64_t mf4_header_at = 64;
/// Bytes of a block before its links.
inline constexpr std::uint64_t mf4_block_head = 24;

/// A block. What is at its links and in its data is read when it is asked for.
struct Mf4Block {
  std::string kind = {};     ///< two letters
  std::uint64_t at = 0;      ///< its place in the file
  std::uint64_t length = 0;  ///< with head and links, as it says
  std::uint64_t links = 0;   ///< how many

  /// The place of its data in the file.
  std::uint64_t data_at() const { return at + mf4_block_head + 8 * links; }
  /// Bytes of data, as the block says.
  std::uint64_t data_size() const {
    const std::uint64_t before = mf4_block_head + 8 * links;
    return length > before ? length - before : 0;
  }
};

/// Numbers are those of little-endian files, as all of MDF 4 are. What is not there is 0.
class Mf4File {
 public:
  /// Blocks are looked for in all of it.
  explicit Mf4File(TraceFile file) : file_(std::move(file)) {}

  std::uint64_t size() const { return file_.size(); }
  /// As TraceFile has it.
  std::size_t read(std::uint64_t at, std::span<char> into) const { return file_.read(at, into); }
  /// Any block; none where there is none, or where blocks were asked for more often than there is
  /// room for them in the file: they lead in circles.
  std::optional<Mf4Block> block(std::uint64_t at);
  /// One of this kind.
  std::optional<Mf4Block> block(std::uint64_t at, std::string_view kind);
  /// From 0 on; 0 where there is none.
  std::uint64_t link(const Mf4Block& block, std::uint64_t number) const;
  /// `size` bytes, at most 8, of the block's data.
  std::uint64_t number(const Mf4Block& block, std::uint64_t at, unsigned size) const;
  /// Of 64 bits.
  double real(const Mf4Block& block, std::uint64_t at) const;
  /// Of a block TX or MD, up to 4 KiB of it.
  std::string text(std::uint64_t at);

 private:
  std::uint64_t number_at(std::uint64_t at, unsigned size) const;

  TraceFile file_;
  std::uint64_t asked_ = 0;
};

}  // namespace canvoy::formats
