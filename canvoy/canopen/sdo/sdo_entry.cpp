#include "canvoy/canopen/sdo/sdo_entry.hpp"

#include <utility>

#include "canvoy/can/must_hold.hpp"

namespace canvoy {

/// What is found is filled in in its place: a copy would have to wait for its parts to get there.
AbortCode SdoEntry::find(sdo::Multiplexer multiplexer) {
  domain_ = nullptr;
  seek(0);
  found_.index = multiplexer.index();
  found_.sub = multiplexer.sub();
  return dictionary_.locate_for_bus(found_);
}

AbortCode SdoEntry::open_read() {
  writes_ = false;
  const bool is_readable = allows(row().access, Access::sdo_read);
  if (row().type == DataType::domain && is_readable) return open_domain();
  const AbortCode answer = dictionary_.open_read(found_);
  if (answer != AbortCode::none) return answer;
  const std::span<const std::uint8_t> value = found_.bytes();
  value_ = value.data();
  size_ = static_cast<std::uint32_t>(value.size());
  return AbortCode::none;
}

AbortCode SdoEntry::keep() {
  if (is_domain() || allows(row().access, Access::constant)) return AbortCode::none;
  if (size_ > buffer_.size()) return AbortCode::out_of_memory;
  std::memcpy(buffer_.data(), value_, size_);
  value_ = buffer_.data();
  return AbortCode::none;
}

Result<std::span<const std::uint8_t>> SdoEntry::next(std::span<std::uint8_t> memory) {
  if (is_domain()) return domain_->transfer->read(*this, memory);
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
  if (size_ <= buffer_.size()) return AbortCode::none;
  size_ = static_cast<std::uint32_t>(buffer_.size());
  return announced_ ? AbortCode::out_of_memory : AbortCode::none;
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
  std::uint8_t* place = buffer_.data() + offset_;
  offset_ += static_cast<std::uint32_t>(bytes.size());
  if (is_domain()) return domain_->transfer->write(*this, bytes);
  sdo::copy_segment(bytes, place);
  return AbortCode::none;
}

AbortCode SdoEntry::finish() {
  if (announced_ && offset_ < size_) return AbortCode::length_too_low;
  if (is_domain()) return domain_->transfer->close(*this, true);
  must_hold(offset_ <= buffer_.size());
  return write_whole(buffer_.first(offset_));
}

// A domain: nothing of it is linked where no Domain is, which alone names DomainTransfer::calls.

constexpr DomainTransfer DomainTransfer::calls = {.open_read = SdoEntry::open_domain_to_read,
                                                  .read = SdoEntry::read_domain,
                                                  .open_write = SdoEntry::open_domain_to_write,
                                                  .write = SdoEntry::write_domain,
                                                  .close = SdoEntry::close_domain};

AbortCode SdoEntry::open_domain_to_read(SdoEntry& self, const Domain& domain) {
  if (!domain.open_read) return AbortCode::unsupported_access;
  const Result<std::uint32_t> size = domain.open_read(self.found_);
  self.size_ = *size;
  self.domain_ = &domain;
  return size.abort();
}

Result<std::span<const std::uint8_t>> SdoEntry::read_domain(SdoEntry& self,
                                                            std::span<std::uint8_t> memory) {
  const std::uint32_t offset = self.offset_;
  const std::size_t wanted = std::min<std::size_t>(memory.size(), self.size_ - offset);
  if (wanted == 0) return std::span<const std::uint8_t>();
  const Result<std::size_t> size = self.domain_->read(self.found_, offset, memory.first(wanted));
  if (!size) return size.abort();
  self.ended_ = *size < wanted;
  if (*size > wanted || (self.ended_ && self.size_ != Domain::size_unknown)) {
    return AbortCode::internal_incompatible;
  }
  self.offset_ += static_cast<std::uint32_t>(*size);
  return std::span<const std::uint8_t>(memory.first(*size));
}

AbortCode SdoEntry::open_domain_to_write(SdoEntry& self, const Domain& domain) {
  if (!domain.write) return AbortCode::unsupported_access;
  const AbortCode answer = domain.open_write(self.found_, self.announced_ ? self.size_ : 0);
  if (answer == AbortCode::none) self.domain_ = &domain;
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
