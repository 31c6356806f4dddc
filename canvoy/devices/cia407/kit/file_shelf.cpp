#include "canvoy/devices/cia407/kit/file_shelf.hpp"

#include <algorithm>
#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy::cia407 {

namespace {

/// Place of a file while it arrives.
constexpr unsigned arrival = 0;

}  // namespace

FileShelf::FileShelf(VirtualDevice& device, std::uint16_t index, const Memory& memory)
    : memory_(memory),
      domain_{.open_read = callback<&FileShelf::open_read>(*this),
              .read = callback<&FileShelf::read>(*this),
              .open_write = callback<&FileShelf::open_write>(*this),
              .write = callback<&FileShelf::write>(*this),
              .close_write = callback<&FileShelf::close_write>(*this)},
      hook_{.first = index, .last = index, .domain = &domain_},
      next_(std::exchange(device.shelves(), this)),
      shared_(shared(next_)) {
  if (&shared_ == this) device.node().dictionary().attach(hook_);
}

/// Searches the shelves that were made before, from `shelf` on.
FileShelf& FileShelf::shared(FileShelf* shelf) {
  for (; shelf != nullptr; shelf = shelf->next_) {
    if (shelf->hook_.first == hook_.first) return shelf->shared_;
  }
  return *this;
}

std::span<const std::uint8_t> FileShelf::file(unsigned sub) const {
  if (&shared_ != this) return shared_.file(sub);
  if (!has(sub)) return {};
  return bytes_at(place_of(sub)).first(memory_.sizes[place_of(sub) - 1]);
}

void FileShelf::clear() {
  if (&shared_ != this) return shared_.clear();
  std::ranges::fill(memory_.sizes, 0);
  arriving_ = 0;
  read_ = 0;
}

Result<std::uint32_t> FileShelf::open_read(const Entry& entry) {
  if (!has(entry.sub)) return AbortCode::no_data;
  read_ = place_of(entry.sub);
  return memory_.sizes[read_ - 1];
}

Result<std::size_t> FileShelf::read(const Entry& entry, std::uint32_t offset,
                                    std::span<std::uint8_t> bytes) {
  if (read_ != place_of(entry.sub)) return AbortCode::device_state;
  const std::span<const std::uint8_t> all = file(entry.sub);
  const std::span<const std::uint8_t> rest = all.subspan(std::min<std::size_t>(offset, all.size()));
  const std::span<const std::uint8_t> part = rest.first(std::min(rest.size(), bytes.size()));
  std::ranges::copy(part, bytes.begin());
  return part.size();
}

AbortCode FileShelf::open_write(const Entry& entry, std::uint32_t size) {
  if (!has(entry.sub) || size > memory_.size_max) return AbortCode::length_too_high;
  arriving_ = place_of(entry.sub);
  arrived_ = 0;
  return AbortCode::none;
}

AbortCode FileShelf::write(const Entry& entry, std::span<const std::uint8_t> bytes) {
  if (arriving_ != place_of(entry.sub)) return AbortCode::device_state;
  check_invariant(arrived_ <= memory_.size_max);
  if (bytes.size() > memory_.size_max - arrived_) return AbortCode::length_too_high;
  std::ranges::copy(bytes, bytes_at(arrival).subspan(arrived_).begin());
  arrived_ += static_cast<std::uint32_t>(bytes.size());
  return AbortCode::none;
}

AbortCode FileShelf::close_write(const Entry& entry, bool complete) {
  const unsigned place = place_of(entry.sub);
  const bool is_here = arriving_ == place;
  arriving_ = 0;
  if (!complete) return AbortCode::none;
  if (!is_here) return AbortCode::device_state;
  std::ranges::copy(bytes_at(arrival).first(arrived_), bytes_at(place).begin());
  memory_.sizes[place - 1] = arrived_;
  if (read_ == place) read_ = 0;
  if (on_stored) on_stored(entry);
  return AbortCode::none;
}

}  // namespace canvoy::cia407
