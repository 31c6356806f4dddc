#include "canvoy/canopen/sdo/sdo_entry.hpp"

#include <utility>

#include "canvoy/can/check_invariant.hpp"

namespace canvoy {

AbortCode SdoEntry::open_read() {
  writes_ = false;
  const bool is_readable = allows(row().access, Access::sdo_read);
  if (row().type == DataType::domain && is_readable) return open_domain();
  const AbortCode answer = dictionary_.open_read(found_);
  if (answer != AbortCode::none) return answer;
  const std::span<const std::uint8_t> value = found_.bytes();
  value_ = value.data();
  size_ = static_cast<std::uint32_t>(value.size());
  set_window(size_);
  return AbortCode::none;
}

AbortCode SdoEntry::keep() {
  if (is_streamed() || allows(row().access, Access::constant)) return AbortCode::none;
  if (!is_small_machine && row().type == DataType::domain) return AbortCode::none;  // a view
  if (size_ > buffer_.size()) return AbortCode::out_of_memory;
  std::memcpy(buffer_.data(), value_, size_);
  value_ = buffer_.data();
  return AbortCode::none;
}

Result<std::span<const std::uint8_t>> SdoEntry::next(std::span<std::uint8_t> memory) {
  if (is_streamed()) return domain_->transfer->read(*this, memory);
  const std::uint32_t offset = offset_;
  const auto wanted = std::min(static_cast<std::uint32_t>(memory.size()), size_ - offset);
  offset_ = offset + wanted;
  return std::span<const std::uint8_t>(value_ + offset, wanted);
}

AbortCode SdoEntry::open_write(std::optional<std::uint32_t> announced) {
  writes_ = true;
  announced_ = announced.has_value();
  size_ = announced.value_or(Domain::size_unknown);
  if (!allows(row().access, Access::sdo_write)) return AbortCode::read_only;
  if (row().type == DataType::domain) return open_domain();
  if (!announced_) size_ = row().capacity;
  if (size_ > row().capacity) return AbortCode::length_too_high;
  if (size_ < row().capacity && !row().is_text()) return AbortCode::length_too_low;
  const bool fits = size_ <= buffer_.size();
  if (!fits) size_ = static_cast<std::uint32_t>(buffer_.size());
  set_window(size_);
  return fits || !announced_ ? AbortCode::none : AbortCode::out_of_memory;
}

AbortCode SdoEntry::open_domain() {
  const Domain* domain = dictionary_.domain(found_);
  if (domain == nullptr) return AbortCode::unsupported_access;
  return (writes_ ? domain->transfer->open_write : domain->transfer->open_read)(*this, *domain);
}

AbortCode SdoEntry::write(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > size_ - offset_) {
    const bool too_long = announced_ || offset_ + bytes.size() > row().capacity;
    return too_long ? AbortCode::length_too_high : AbortCode::out_of_memory;
  }
  if (!is_small_machine && is_streamed()) return write_streamed(bytes);
  std::uint8_t* place = buffer_.data() + offset_;
  offset_ += static_cast<std::uint32_t>(bytes.size());
  if (is_streamed()) return domain_->transfer->write(*this, bytes);
  sdo::copy_segment(bytes, place);
  return AbortCode::none;
}

/// A window has room for a segment once it was passed on.
inline AbortCode SdoEntry::write_streamed(std::span<const std::uint8_t> bytes) {
  if (window_.value.end == 0) [[likely]] {
    offset_ += static_cast<std::uint32_t>(bytes.size());
    return domain_->write(found_, bytes);
  }
  if (!is_in_window(bytes.size())) {
    const AbortCode answer = flush_window();
    if (answer != AbortCode::none || !is_streamed()) return answer;
  }
  sdo::copy_segment(bytes, buffer_.data() + (offset_ - window_.value.first));
  offset_ += static_cast<std::uint32_t>(bytes.size());
  return AbortCode::none;
}

AbortCode SdoEntry::flush_window() {
  const std::span<const std::uint8_t> gathered = buffer_.first(offset_ - window_.value.first);
  open_window();
  return gathered.empty() ? AbortCode::none : domain_->transfer->write(*this, gathered);
}

AbortCode SdoEntry::finish() {
  if (announced_ && offset_ < size_) return AbortCode::length_too_low;
  if (is_streamed()) return domain_->transfer->close(*this, true);
  if (!is_small_machine && placed_.value.domain != nullptr) return close_placed(true);
  check_invariant(offset_ <= buffer_.size());
  return write_whole(buffer_.first(offset_));
}

// A domain: nothing of it is linked in a program without a Domain, which alone refers to
// DomainTransfer::calls.

constexpr DomainTransfer DomainTransfer::calls = {.open_read = SdoEntry::open_domain_to_read,
                                                  .read = SdoEntry::read_domain,
                                                  .open_write = SdoEntry::open_domain_to_write,
                                                  .write = SdoEntry::write_domain,
                                                  .close = SdoEntry::close_domain};

/// From here on it is as a value of any length.
AbortCode SdoEntry::open_view(const Domain& domain) {
  const Result<std::span<const std::uint8_t>> content = domain.view(found_);
  if (!content) return content.abort();
  value_ = content->data();
  size_ = static_cast<std::uint32_t>(content->size());
  set_window(size_);
  return AbortCode::none;
}

AbortCode SdoEntry::open_room(const Domain& domain) {
  const Result<std::span<std::uint8_t>> room = domain.room(found_, announced_ ? size_ : 0);
  if (!room) return room.abort();
  if (announced_ && size_ > room->size()) return AbortCode::out_of_memory;
  if (!announced_) size_ = static_cast<std::uint32_t>(room->size());
  placed_.value = {&domain, buffer_};
  buffer_ = *room;
  set_window(size_);
  return AbortCode::none;
}

AbortCode SdoEntry::close_placed(bool complete) {
  const Domain& domain = *std::exchange(placed_.value.domain, nullptr);
  const std::span<std::uint8_t> bytes = buffer_.first(offset_);
  buffer_ = placed_.value.buffer;
  const AbortCode answer = complete ? domain.write(found_, bytes) : AbortCode::none;
  if (answer == AbortCode::none) return domain.close_write(found_, complete);
  domain.close_write(found_, false);
  return answer;
}

AbortCode SdoEntry::open_domain_to_read(SdoEntry& self, const Domain& domain) {
  if (!is_small_machine && domain.view) return self.open_view(domain);
  if (!domain.open_read) return AbortCode::unsupported_access;
  const Result<std::uint32_t> size = domain.open_read(self.found_);
  self.size_ = *size;
  self.domain_ = &domain;
  self.set_window(0);
  return size.abort();
}

/// Whole segments only, so that the end shows as it does without it. False if there is no room for
/// several, or the domain refuses: then it is asked for the next segment alone.
bool SdoEntry::read_ahead() {
  if constexpr (is_small_machine) return false;
  const std::size_t room = buffer_.size() / sdo::segment_max * sdo::segment_max;
  const std::span<std::uint8_t> memory =
      buffer_.first(std::min<std::size_t>(room, size_ - offset_));
  if (memory.size() <= sdo::segment_max) return false;
  const Result<std::size_t> size = domain_->read(found_, offset_, memory);
  if (!size || *size > memory.size() || !is_streamed()) return false;
  value_ = memory.data();
  window_.value = {offset_, offset_ + static_cast<std::uint32_t>(*size)};
  return *size != 0;
}

[[gnu::always_inline]] inline Result<std::size_t> SdoEntry::stream(std::span<std::uint8_t> memory) {
  const std::uint32_t offset = offset_;
  const std::size_t wanted = std::min<std::size_t>(memory.size(), size_ - offset);
  if (wanted == 0) return std::size_t{0};
  if constexpr (!is_small_machine) {
    const bool is_ahead = is_in_window(1) || read_ahead();
    if (!is_streamed()) return std::size_t{0};  // the domain has stopped the node
    if (is_ahead && (is_in_window(wanted) || size_ == Domain::size_unknown)) {
      const std::size_t size = std::min<std::size_t>(wanted, window_.value.end - offset);
      std::memcpy(memory.data(), value_ + (offset - window_.value.first), size);
      ended_ = size < wanted;
      offset_ = offset + static_cast<std::uint32_t>(size);
      return size;
    }
  }
  const Result<std::size_t> size = domain_->read(found_, offset, memory.first(wanted));
  if (!size) return size;
  ended_ = *size < wanted;
  if (*size > wanted || (ended_ && size_ != Domain::size_unknown)) {
    return AbortCode::internal_incompatible;
  }
  offset_ = offset + static_cast<std::uint32_t>(*size);
  return size;
}

Result<std::size_t> SdoEntry::next_streamed(std::span<std::uint8_t> memory) {
  return stream(memory);
}

Result<std::span<const std::uint8_t>> SdoEntry::read_domain(SdoEntry& self,
                                                            std::span<std::uint8_t> memory) {
  const Result<std::size_t> size = self.stream(memory);
  if (!size) return size.abort();
  return std::span<const std::uint8_t>(memory.first(*size));
}

AbortCode SdoEntry::open_domain_to_write(SdoEntry& self, const Domain& domain) {
  if (!domain.write) return AbortCode::unsupported_access;
  if (!is_small_machine && domain.room) return self.open_room(domain);
  const AbortCode answer = domain.open_write(self.found_, self.announced_ ? self.size_ : 0);
  if (answer == AbortCode::none) self.domain_ = &domain;
  self.set_window(0);
  return answer;
}

AbortCode SdoEntry::write_domain(SdoEntry& self, std::span<const std::uint8_t> bytes) {
  return self.domain_->write(self.found_, bytes);
}

AbortCode SdoEntry::close_domain(SdoEntry& self, bool complete) {
  const Domain* domain = std::exchange(self.domain_, nullptr);
  return self.writes_ ? domain->close_write(self.found_, complete) : AbortCode::none;
}

}  // namespace canvoy
