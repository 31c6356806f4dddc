#include "canvoy/canopen/sdo_entry.hpp"

#include <utility>

#include "canvoy/canopen/sdo.hpp"

namespace canvoy {

AbortCode SdoReader::open(const Entry& entry, std::span<const std::uint8_t> value,
                          std::span<std::uint8_t> buffer) {
  domain_ = nullptr;
  value_ = value.data();
  size_ = static_cast<std::uint32_t>(value.size());
  seek(0);
  if (allows(entry.row->access, Access::constant)) return AbortCode::none;
  if (value.size() > buffer.size()) return AbortCode::out_of_memory;
  std::ranges::copy(value, buffer.begin());
  value_ = buffer.data();
  return AbortCode::none;
}

AbortCode SdoReader::open_domain(const Dictionary& dictionary, const Entry& entry) {
  if (!allows(entry.row->access, Access::sdo_read)) return AbortCode::write_only;
  domain_ = dictionary.domain(entry);
  if (domain_ == nullptr || !domain_->open_read) return AbortCode::unsupported_access;
  const Result<std::uint32_t> size = domain_->open_read(entry);
  entry_ = entry;
  size_ = *size;
  seek(0);
  return size.abort();
}

Result<std::span<const std::uint8_t>> SdoReader::next(std::span<std::uint8_t> memory) {
  const std::size_t wanted = std::min<std::size_t>(memory.size(), size_ - offset_);
  const std::uint32_t offset = offset_;
  if (domain_ == nullptr) {
    offset_ += static_cast<std::uint32_t>(wanted);
    return std::span<const std::uint8_t>(value_ + offset, wanted);
  }
  if (wanted == 0) return std::span<const std::uint8_t>();
  const Result<std::size_t> size = domain_->read(entry_, offset, memory.first(wanted));
  if (!size) return size.abort();
  ended_ = *size < wanted;
  if (*size > wanted || (ended_ && size_ != Domain::size_unknown)) {
    return AbortCode::internal_incompatible;
  }
  offset_ += static_cast<std::uint32_t>(*size);
  return std::span<const std::uint8_t>(memory.first(*size));
}

AbortCode SdoWriter::open(const Entry& entry, std::optional<std::uint32_t> announced) {
  entry_ = entry;
  announced_ = announced;
  received_ = 0;
  if (!allows(entry.row->access, Access::sdo_write)) return AbortCode::read_only;
  if (entry.row->type != DataType::domain)
    return check_size(announced.value_or(entry.row->capacity));
  const Domain* domain = dictionary_.domain(entry);
  if (domain == nullptr || !domain->write) return AbortCode::unsupported_access;
  const AbortCode answer = domain->open_write(entry, announced.value_or(0));
  if (answer == AbortCode::none) domain_ = domain;
  return answer;
}

AbortCode SdoWriter::check_size(std::uint32_t size) const {
  const EntryRow& row = *entry_.row;
  if (size > row.capacity) return AbortCode::length_too_high;
  if (size < row.capacity && !is_string(row.type)) return AbortCode::length_too_low;
  return announced_ && size > buffer_.size() ? AbortCode::out_of_memory : AbortCode::none;
}

AbortCode SdoWriter::write(std::span<const std::uint8_t> bytes) {
  const std::size_t size = std::size_t{received_} + bytes.size();
  if (announced_ && size > *announced_) return AbortCode::length_too_high;
  if (domain_ == nullptr) {
    if (size > entry_.row->capacity) return AbortCode::length_too_high;
    if (size > buffer_.size()) return AbortCode::out_of_memory;
    sdo::copy_segment(bytes, buffer_.data() + received_);
  }
  received_ = static_cast<std::uint32_t>(size);
  return domain_ == nullptr ? AbortCode::none : domain_->write(entry_, bytes);
}

AbortCode SdoWriter::finish() {
  if (announced_ && received_ < *announced_) return AbortCode::length_too_low;
  const Domain* domain = std::exchange(domain_, nullptr);
  if (domain != nullptr) return domain->close_write(entry_, true);
  return dictionary_.write(entry_, buffer_.first(received_), Source::sdo);
}

void SdoWriter::drop() {
  const Domain* domain = std::exchange(domain_, nullptr);
  if (domain != nullptr) domain->close_write(entry_, false);
}

}  // namespace canvoy
