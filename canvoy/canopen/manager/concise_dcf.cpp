#include "canvoy/canopen/manager/concise_dcf.hpp"

#include <array>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy {

namespace {

constexpr std::uint32_t count_bytes = 4;
constexpr std::uint32_t header_bytes = 7;  // index, sub-index, size

}  // namespace

AbortCode ConciseDcf::open(const ByteSource& source) {
  source_ = source;
  count_ = position_ = 0;
  offset_ = count_bytes;
  if (source.size < count_bytes) return AbortCode::length_too_low;
  std::array<std::uint8_t, count_bytes> bytes{};
  const AbortCode answer = source_.read(0, bytes);
  if (answer != AbortCode::none) return answer;
  const auto count = load<std::uint32_t>(bytes.data());
  const std::uint32_t rest = source.size - count_bytes;
  if (count > rest / header_bytes) return AbortCode::length_too_low;
  if (count == 0 && rest != 0) return AbortCode::length_too_high;
  count_ = count;
  return AbortCode::none;
}

Result<ConciseDcf::Item> ConciseDcf::next() {
  if (at_end()) return AbortCode::no_data;
  if (source_.size - offset_ < header_bytes) return AbortCode::length_too_low;
  std::array<std::uint8_t, header_bytes> header{};
  const AbortCode answer = source_.read(offset_, header);
  if (answer != AbortCode::none) return answer;
  const Item item{.index = load<std::uint16_t>(header.data()),
                  .sub = header[2],
                  .size = load<std::uint32_t>(&header[3]),
                  .offset = offset_ + header_bytes};
  const std::uint32_t rest = source_.size - item.offset;
  if (item.size > rest) return AbortCode::length_too_low;
  if (position_ + 1 == count_ && item.size < rest) return AbortCode::length_too_high;
  offset_ = item.offset + item.size;
  ++position_;
  return item;
}

AbortCode ConciseDcf::read(const Item& item, std::uint32_t offset,
                           std::span<std::uint8_t> bytes) const {
  if (offset > item.size || bytes.size() > item.size - offset) return AbortCode::length_too_high;
  return bytes.empty() ? AbortCode::none : source_.read(item.offset + offset, bytes);
}

Result<std::uint32_t> check_concise_dcf(const ByteSource& source) {
  ConciseDcf dcf;
  const AbortCode answer = dcf.open(source);
  if (answer != AbortCode::none) return answer;
  while (!dcf.at_end()) {
    const Result<ConciseDcf::Item> item = dcf.next();
    if (!item) return item.abort();
  }
  return dcf.count();
}

}  // namespace canvoy
