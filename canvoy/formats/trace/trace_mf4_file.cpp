#include "canvoy/formats/trace/trace_mf4_file.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace canvoy::formats {

std::uint64_t Mf4File::number_at(std::uint64_t at, unsigned size) const {
  std::array<char, 8> bytes{};
  if (file_.read(at, std::span(bytes).first(size)) != size) return 0;
  std::uint64_t value = 0;
  for (unsigned byte = size; byte-- > 0;) {
    value = value << 8 | static_cast<std::uint8_t>(bytes.at(byte));
  }
  return value;
}

std::optional<Mf4Block> Mf4File::block(std::uint64_t at) {
  constexpr std::uint64_t spare = 1000;  // headers of data are asked for once more
  std::array<char, 4> mark{};
  const bool is_there = at >= mf4_header_at && at < size() && size() - at >= mf4_block_head;
  if (!is_there || asked_ > spare + size() / mf4_block_head) return std::nullopt;
  ++asked_;
  file_.read(at, mark);
  if (mark[0] != '#' || mark[1] != '#') return std::nullopt;
  Mf4Block block{.kind = {mark[2], mark[3]}, .at = at};
  block.length = number_at(at + 8, 8);
  block.links = number_at(at + 16, 8);
  if (block.links > (size() - at - mf4_block_head) / 8) return std::nullopt;
  return block;
}

std::optional<Mf4Block> Mf4File::block(std::uint64_t at, std::string_view kind) {
  std::optional<Mf4Block> found = block(at);
  if (found && found->kind != kind) found.reset();
  return found;
}

std::uint64_t Mf4File::link(const Mf4Block& block, std::uint64_t number) const {
  return number < block.links ? number_at(block.at + mf4_block_head + 8 * number, 8) : 0;
}

std::uint64_t Mf4File::number(const Mf4Block& block, std::uint64_t at, unsigned size) const {
  return at + size <= block.data_size() ? number_at(block.data_at() + at, size) : 0;
}

double Mf4File::real(const Mf4Block& block, std::uint64_t at) const {
  return std::bit_cast<double>(number(block, at, 8));
}

std::string Mf4File::text(std::uint64_t at) {
  constexpr std::uint64_t length_max = 4096;
  const std::optional<Mf4Block> found = block(at);
  if (!found || (found->kind != "TX" && found->kind != "MD")) return {};
  std::string text(static_cast<std::size_t>(std::min(found->data_size(), length_max)), '\0');
  text.resize(file_.read(found->data_at(), text));
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace canvoy::formats
