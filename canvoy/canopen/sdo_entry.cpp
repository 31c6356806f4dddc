#include "canvoy/canopen/sdo_entry.hpp"

#include <new>
#include <utility>

namespace canvoy {

/// What is found is made in its place: a copy would have to wait for its parts to get there.
AbortCode SdoEntry::find(sdo::Multiplexer multiplexer) {
  domain_ = nullptr;
  seek(0);
  new (&found_) Result<Entry>(dictionary_.find(multiplexer.index(), multiplexer.sub()));
  return found_.abort();
}

AbortCode SdoEntry::open_read() {
  writes_ = false;
  const auto value = dictionary_.read(*found_);
  if (!value) return row().type == DataType::domain ? open_domain_to_read() : value.abort();
  value_ = value->data();
  size_ = static_cast<std::uint32_t>(value->size());
  return AbortCode::none;
}

AbortCode SdoEntry::open_domain_to_read() {
  if (!allows(row().access, Access::sdo_read)) return AbortCode::write_only;
  const Domain* domain = dictionary_.domain(*found_);
  if (domain == nullptr || !domain->open_read) return AbortCode::unsupported_access;
  const Result<std::uint32_t> size = domain->open_read(*found_);
  size_ = *size;
  domain_ = domain;
  return size.abort();
}

AbortCode SdoEntry::keep() {
  if (is_domain() || allows(row().access, Access::constant)) return AbortCode::none;
  if (size_ > buffer_.size()) return AbortCode::out_of_memory;
  std::copy_n(value_, size_, buffer_.data());
  value_ = buffer_.data();
  return AbortCode::none;
}

Result<std::span<const std::uint8_t>> SdoEntry::next(std::span<std::uint8_t> memory) {
  const std::size_t wanted = std::min<std::size_t>(memory.size(), size_ - offset_);
  const std::uint32_t offset = offset_;
  if (!is_domain()) {
    offset_ += static_cast<std::uint32_t>(wanted);
    return std::span<const std::uint8_t>(value_ + offset, wanted);
  }
  if (wanted == 0) return std::span<const std::uint8_t>();
  const Result<std::size_t> size = domain_->read(*found_, offset, memory.first(wanted));
  if (!size) return size.abort();
  ended_ = *size < wanted;
  if (*size > wanted || (ended_ && size_ != Domain::size_unknown)) {
    return AbortCode::internal_incompatible;
  }
  offset_ += static_cast<std::uint32_t>(*size);
  return std::span<const std::uint8_t>(memory.first(*size));
}

AbortCode SdoEntry::open_write(std::optional<std::uint32_t> announced) {
  if (!allows(row().access, Access::sdo_write)) return AbortCode::read_only;
  writes_ = true;
  announced_ = announced.has_value();
  if (row().type == DataType::domain) return open_domain_to_write(announced);
  size_ = announced.value_or(row().capacity);
  if (size_ > row().capacity) return AbortCode::length_too_high;
  if (size_ < row().capacity && !is_string(row().type)) return AbortCode::length_too_low;
  if (size_ <= buffer_.size()) return AbortCode::none;
  size_ = static_cast<std::uint32_t>(buffer_.size());
  return announced_ ? AbortCode::out_of_memory : AbortCode::none;
}

AbortCode SdoEntry::open_domain_to_write(std::optional<std::uint32_t> announced) {
  const Domain* domain = dictionary_.domain(*found_);
  if (domain == nullptr || !domain->write) return AbortCode::unsupported_access;
  size_ = announced.value_or(Domain::size_unknown);
  const AbortCode answer = domain->open_write(*found_, announced.value_or(0));
  if (answer == AbortCode::none) domain_ = domain;
  return answer;
}

AbortCode SdoEntry::write(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > size_ - offset_) {
    const bool too_long = announced_ || offset_ + bytes.size() > row().capacity;
    return too_long ? AbortCode::length_too_high : AbortCode::out_of_memory;
  }
  std::uint8_t* place = buffer_.data() + offset_;
  offset_ += static_cast<std::uint32_t>(bytes.size());
  if (is_domain()) return domain_->write(*found_, bytes);
  sdo::copy_segment(bytes, place);
  return AbortCode::none;
}

AbortCode SdoEntry::finish() {
  if (announced_ && offset_ < size_) return AbortCode::length_too_low;
  if (is_domain()) return close_domain(true);
  return write_whole(buffer_.first(offset_));
}

AbortCode SdoEntry::close_domain(bool complete) {
  const Domain* domain = std::exchange(domain_, nullptr);
  return writes_ ? domain->close_write(*found_, complete) : AbortCode::none;
}

}  // namespace canvoy
