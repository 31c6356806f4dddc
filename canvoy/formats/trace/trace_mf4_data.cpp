#include "canvoy/formats/trace/trace_mf4_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <span>
#include <utility>

namespace canvoy::formats {

namespace {

constexpr std::size_t read_size = std::size_t{64} * 1024;
constexpr std::uint64_t unpacked_max = std::uint64_t{64} * 1024 * 1024;

/// Of a block DZ: columns were written one behind another, `columns` of them; what is left over of
/// the last row stands at the end.
std::string transposed(std::string_view bytes, std::size_t columns) {
  const std::size_t rows = bytes.size() / columns;
  std::string result(bytes);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      result[row * columns + column] = bytes[column * rows + row];
    }
  }
  return result;
}

}  // namespace

Mf4Data::Mf4Data(Mf4File& file, std::uint64_t link, bool is_open_end)
    : file_(&file), is_open_end_(is_open_end), first_(link) {}

std::string_view Mf4Data::show(std::size_t size) {
  while (bytes_.size() - done_ < size && size <= show_max && fill()) continue;
  return std::string_view(bytes_).substr(done_, size);
}

bool Mf4Data::take(std::uint64_t size) {
  while (true) {
    const std::uint64_t here = std::min<std::uint64_t>(size, bytes_.size() - done_);
    done_ += static_cast<std::size_t>(here);
    size -= here;
    if (size == 0) return true;
    const std::uint64_t passed = std::min(size, piece_left_);
    piece_at_ += passed;
    piece_left_ -= passed;
    size -= passed;
    if (size != 0 && !fill()) return false;
  }
}

bool Mf4Data::fill() {
  if (done_ > 0) bytes_.erase(0, done_);
  done_ = 0;
  while (piece_left_ == 0) {
    const std::size_t before = bytes_.size();
    if (!next_piece()) return false;
    if (bytes_.size() > before) return true;  // it was compressed
  }
  const std::size_t before = bytes_.size();
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(read_size, piece_left_));
  bytes_.resize(before + wanted);
  const std::size_t got = file_->read(piece_at_, std::span(bytes_).subspan(before));
  bytes_.resize(before + got);
  piece_at_ += got;
  piece_left_ = got < wanted ? 0 : piece_left_ - got;
  return got == wanted || got > 0 || fail("the file ends within its data");
}

bool Mf4Data::fail(std::string_view problem) {
  problem_ = problem;
  first_ = 0;
  item_ = 0;
  piece_left_ = 0;
  return false;
}

bool Mf4Data::next_piece() {
  if (first_ != 0) return enter(std::exchange(first_, 0));
  if (item_ == 0) return false;
  if (item_ < list_.links) return enter(file_->link(list_, item_++));
  item_ = 0;
  const std::uint64_t next = file_->link(list_, 0);
  return next != 0 && enter(next);
}

bool Mf4Data::enter(std::uint64_t link) {
  if (link == 0) return true;  // a piece that is not there
  std::optional<Mf4Block> block = file_->block(link);
  if (block && block->kind == "HL") block = file_->block(file_->link(*block, 0));
  if (!block) return fail("a block of data is not where it should be");
  if (block->kind == "DL") {
    list_ = *block;
    item_ = 1;
    return true;
  }
  piece_at_ = block->data_at();
  total_ += block->length;
  if (total_ > file_->size() + mf4_block_head) {
    const bool is_cut = piece_at_ + block->data_size() > file_->size();
    if (!is_cut) return fail("blocks of data are used twice");
  }
  is_packed_ = block->kind == "DZ";
  if (is_packed_) return inflate(*block);
  if (block->kind != "DT" && block->kind != "SD" && block->kind != "RD") {
    return fail("the data are in blocks of a kind that is not read");
  }
  piece_left_ = block->data_size();
  if (piece_left_ == 0 && is_open_end_) piece_left_ = file_->size() - piece_at_;
  return true;
}

// Kind of the block, kind of compression, reserved, columns, and both sizes.
bool Mf4Data::inflate(const Mf4Block& block) {
  constexpr std::uint64_t head = 24;
  constexpr std::uint64_t is_transposed = 1;
  constexpr std::uint64_t ratio_max = 1040;  // of zlib: 1032
  const std::uint64_t compression = file_->number(block, 2, 1);
  const auto columns = static_cast<std::size_t>(file_->number(block, 4, 4));
  const std::uint64_t size = file_->number(block, 8, 8);
  const std::uint64_t packed_size = file_->number(block, 16, 8);
  if (compression > is_transposed) return fail("the data are compressed in a way that is not read");
  if (size > unpacked_max) return fail("a compressed block has more than 64 MiB");
  if (packed_size > file_->size()) return fail("the file ends within its data");
  if (size / ratio_max > packed_size) return fail("its compressed data are damaged");
  std::string packed(static_cast<std::size_t>(packed_size), '\0');
  if (file_->read(block.data_at() + head, packed) != packed.size()) {
    return fail("the file ends within its data");
  }
  std::string unpacked(static_cast<std::size_t>(size), '\0');
  uLongf made = unpacked.size();
  const int result = ::uncompress(reinterpret_cast<Bytef*>(unpacked.data()), &made,
                                  reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (result != Z_OK || made != size) return fail("its compressed data are damaged");
  bytes_ += compression == is_transposed && columns > 1 ? transposed(unpacked, columns) : unpacked;
  return true;
}

}  // namespace canvoy::formats
