#include "canvoy/canopen/sdo_entry.hpp"

#include <utility>

namespace canvoy {

AbortCode SdoReader::open(const Entry& entry, std::span<const std::uint8_t> value,
                          std::span<std::uint8_t> buffer) {
  domain_ = nullptr;
  value_ = value.data();
  size_ = static_cast<std::uint32_t>(value.size());
  offset_ = 0;
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
  offset_ = 0;
  return size.abort();
}

AbortCode SdoReader::read(std::span<std::uint8_t> bytes) {
  const std::uint32_t offset =
      std::exchange(offset_, offset_ + static_cast<std::uint32_t>(bytes.size()));
  if (domain_ != nullptr) return domain_->read(entry_, offset, bytes);
  std::copy_n(value_ + offset, bytes.size(), bytes.begin());
  return AbortCode::none;
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
    std::ranges::copy(bytes, buffer_.begin() + received_);
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
