#include "canvoy/formats/trace/trace_mf4_group.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

#include "canvoy/formats/trace/trace_packet.hpp"

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

namespace {

constexpr unsigned nesting_max = 4;

/// Numbers of a channel's data.
enum ChannelType : std::uint8_t { fixed_length = 0, variable_length = 1, master = 2 };

Mf4Field::Type type_of(std::uint64_t data_type, std::uint64_t bits) {
  const bool is_real = bits == 32 || bits == 64;
  switch (data_type) {
    case 0:
    case 2:
      return Mf4Field::Type::little;
    case 1:
    case 3:
      return Mf4Field::Type::big;
    case 4:
      return is_real ? Mf4Field::Type::real_little : Mf4Field::Type::none;
    case 5:
      return is_real ? Mf4Field::Type::real_big : Mf4Field::Type::none;
    default:
      return Mf4Field::Type::none;
  }
}

class GroupReader {
 public:
  GroupReader(Mf4File& file, Mf4Group& group) : file_(file), group_(group) {}

  void read_channels(std::uint64_t link, unsigned depth = 0) {
    while (const std::optional<Mf4Block> channel = file_.block(link, "CN")) {
      read_channel(*channel);
      if (depth < nesting_max) read_channels(file_.link(*channel, 1), depth + 1);
      link = file_.link(*channel, 0);
    }
  }

 private:
  Mf4Field field_of(const Mf4Block& channel) const {
    Mf4Field field;
    const std::uint64_t bits = file_.number(channel, 8, 4);
    field.byte = static_cast<std::uint32_t>(file_.number(channel, 4, 4));
    field.bit = static_cast<std::uint8_t>(file_.number(channel, 3, 1) & 7);
    field.type = type_of(file_.number(channel, 2, 1), bits);
    const std::uint64_t end = std::uint64_t{field.byte} + (field.bit + bits + 7) / 8;
    if (bits == 0 || field.bit + bits > 64 || end > group_.size) return {};
    field.bits = static_cast<std::uint8_t>(bits);
    return field;
  }

  /// Of a channel of time: a count is made seconds by a line.
  void convert(Mf4Field& field, std::uint64_t link) {
    constexpr std::uint64_t linear = 1;
    const std::optional<Mf4Block> conversion = file_.block(link, "CC");
    if (!conversion || file_.number(*conversion, 0, 1) != linear) return;
    field.offset = file_.real(*conversion, 24);
    field.factor = file_.real(*conversion, 32);
  }

  void read_channel(const Mf4Block& channel) {
    constexpr std::uint64_t time = 1;
    if (file_.number(channel, 0, 1) == master && file_.number(channel, 1, 1) == time) {
      group_.time = field_of(channel);
      convert(group_.time, file_.link(channel, 4));
      return;
    }
    const std::string name = file_.text(file_.link(channel, 2));
    const std::size_t dot = name.rfind('.');
    read_kind(std::string_view(name).substr(0, dot));
    if (dot != std::string::npos) read_part(std::string_view(name).substr(dot + 1), channel);
  }

  void read_kind(std::string_view name) {
    if (name == "CAN_DataFrame") group_.kind = Mf4Kind::data;
    if (name == "CAN_RemoteFrame") group_.kind = Mf4Kind::remote;
    if (name == "CAN_ErrorFrame") group_.kind = Mf4Kind::error;
  }

  void read_part(std::string_view name, const Mf4Block& channel) {
    if (name == "DataBytes") return read_data(channel);
    using Part = std::pair<std::string_view, Mf4Field Mf4Group::*>;
    static constexpr std::array parts = {Part{"BusChannel", &Mf4Group::bus},
                                         Part{"ID", &Mf4Group::identifier},
                                         Part{"IDE", &Mf4Group::extended},
                                         Part{"DLC", &Mf4Group::code},
                                         Part{"DataLength", &Mf4Group::length},
                                         Part{"Dir", &Mf4Group::direction},
                                         Part{"EDL", &Mf4Group::fd},
                                         Part{"BRS", &Mf4Group::bit_rate},
                                         Part{"ESI", &Mf4Group::state}};
    const auto* const part = std::ranges::find(parts, name, &Part::first);
    if (part != parts.end()) group_.*part->second = field_of(channel);
  }

  void read_data(const Mf4Block& channel) {
    const std::uint64_t at = file_.number(channel, 4, 4);
    const std::uint64_t bytes = file_.number(channel, 8, 4) / 8;
    if (file_.number(channel, 0, 1) == variable_length) {
      group_.data_offset = field_of(channel);
      group_.data_offset.type = Mf4Field::Type::little;
      if (group_.data_offset.bits == 0) group_.data_offset = {};
      group_.data_link = file_.link(channel, 5);
    } else if (at + bytes <= group_.size) {
      group_.data_byte = static_cast<std::uint32_t>(at);
      group_.data_size = static_cast<std::uint32_t>(bytes);
    }
  }

  Mf4File& file_;
  Mf4Group& group_;
};

}  // namespace

std::uint64_t Mf4Field::number(std::string_view record) const {
  if (!is_there()) return 0;
  const std::size_t size = (bit + std::size_t{bits} + 7) / 8;
  std::uint64_t value = 0;
  const std::uint64_t mask = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  const bool is_little = type == Type::little || type == Type::real_little;
  if (is_little && byte + sizeof(value) <= record.size()) {
    return FileNumbers{}.u64(record, byte) >> bit & mask;
  }
  const bool is_big = type == Type::big || type == Type::real_big;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = byte + (is_big ? i : size - 1 - i);
    value = value << 8 | static_cast<std::uint8_t>(record[at]);
  }
  return value >> bit & mask;
}

double Mf4Field::value(std::string_view record) const {
  const std::uint64_t raw = number(record);
  const bool is_real = type == Type::real_little || type == Type::real_big;
  const double plain = !is_real     ? static_cast<double>(raw)
                       : bits == 64 ? std::bit_cast<double>(raw)
                                    : std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  return offset + factor * plain;
}

std::vector<Mf4Group> read_mf4_groups(Mf4File& file, const Mf4Block& group) {
  constexpr std::uint64_t has_lengths = 1;
  std::vector<Mf4Group> groups;
  std::uint64_t link = file.link(group, 1);
  while (const std::optional<Mf4Block> block = file.block(link, "CG")) {
    Mf4Group& read = groups.emplace_back();
    read.at = block->at;
    read.id = file.number(*block, 0, 8);
    read.count = file.number(*block, 8, 8);
    read.size = file.number(*block, 24, 4) + file.number(*block, 28, 4);
    if ((file.number(*block, 16, 2) & has_lengths) != 0) {
      read.kind = Mf4Kind::lengths;
    } else {
      GroupReader(file, read).read_channels(file.link(*block, 1));
    }
    link = file.link(*block, 0);
  }
  return groups;
}

}  // namespace canvoy::formats
