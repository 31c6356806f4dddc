// How an SdoEntry that is a domain is read and written: linked where there is a Domain.
#include <utility>

#include "canvoy/canopen/sdo/sdo_entry.hpp"

namespace canvoy {

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
