// A domain of which the content stands in memory whole: a value of any length (CiA 301, 7.4.7.1:
// DOMAIN), as firmware, a picture or a table is. Values of other types have 65,535 bytes at most.
//
// A host sends it from where it is, and puts what comes to where it belongs: without a copy, and
// without a call for each segment.
//
//     std::vector<std::uint8_t> memory(1'000'000), spare(memory.size());
//     LargeValue table(node, 0x2100, memory, spare);
//     auto check = [&](std::span<const std::uint8_t> value) { return judge(value); };
//     table.on_written = Callback<AbortCode(std::span<const std::uint8_t>)>::of(check);
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

/// It must outlive the node's last call. Uploads that are under way are not known here: who changes
/// the value, by set() or by a download without a spare memory, changes what they send.
class LargeValue {
 public:
  /// Of all entries of object `index`. The length of `memory` bounds that of the value. With a
  /// `spare` memory as long, the value stays what it is until a download has come whole, and so it
  /// does where that comes to nothing; without one, it is empty from the beginning of a download,
  /// and after one that failed. Both must outlive this.
  LargeValue(Node& node, std::uint16_t index, std::span<std::uint8_t> memory,
             std::span<std::uint8_t> spare = {})
      : memory_(memory), spare_(spare), hook_{.first = index, .last = index, .domain = &domain_} {
    domain_.open_read = decltype(Domain::open_read)::to<&LargeValue::open_read>(*this);
    domain_.read = decltype(Domain::read)::to<&LargeValue::read>(*this);
    domain_.open_write = decltype(Domain::open_write)::to<&LargeValue::open_write>(*this);
    domain_.write = decltype(Domain::write)::to<&LargeValue::write>(*this);
    domain_.close_write = decltype(Domain::close_write)::to<&LargeValue::close_write>(*this);
    domain_.view = decltype(Domain::view)::to<&LargeValue::view>(*this);
    domain_.room = decltype(Domain::room)::to<&LargeValue::room>(*this);
    node.dictionary().attach(hook_);
  }
  LargeValue(const LargeValue&) = delete;
  LargeValue& operator=(const LargeValue&) = delete;

  /// Asked when a download has come whole: may refuse it by an abort code.
  Callback<AbortCode(std::span<const std::uint8_t> value)> on_written = {};

  /// Present value, without a copy.
  std::span<const std::uint8_t> value() const { return memory_.first(size_); }
  /// From inside the device. False, and nothing is done, where it is longer than the memory, or a
  /// download is under way.
  bool set(std::span<const std::uint8_t> value) {
    if (is_open_ || value.size() > memory_.size()) return false;
    if (!value.empty()) std::memmove(memory_.data(), value.data(), value.size());
    size_ = value.size();
    return true;
  }

 private:
  Result<std::span<const std::uint8_t>> view(const Entry&) { return value(); }
  Result<std::uint32_t> open_read(const Entry&) { return static_cast<std::uint32_t>(size_); }
  Result<std::size_t> read(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    const std::size_t left = offset < size_ ? size_ - offset : 0;
    const std::size_t size = bytes.size() < left ? bytes.size() : left;
    if (size != 0) std::memcpy(bytes.data(), memory_.data() + offset, size);
    return size;
  }

  std::span<std::uint8_t> target() const { return spare_.empty() ? memory_ : spare_; }
  Result<std::span<std::uint8_t>> room(const Entry& entry, std::uint32_t size) {
    const AbortCode answer = open_write(entry, size);
    if (answer != AbortCode::none) return answer;
    return target();
  }
  AbortCode open_write(const Entry&, std::uint32_t size) {
    if (is_open_) return AbortCode::device_state;  // by another client
    if (size > target().size()) return AbortCode::out_of_memory;
    is_open_ = true;
    come_ = 0;
    if (spare_.empty()) size_ = 0;
    return AbortCode::none;
  }
  AbortCode write(const Entry&, std::span<const std::uint8_t> bytes) {
    if (bytes.size() > target().size() - come_) return AbortCode::out_of_memory;
    std::uint8_t* const place = target().data() + come_;
    // What a host has put there is there.
    if (place != bytes.data() && !bytes.empty()) std::memcpy(place, bytes.data(), bytes.size());
    come_ += bytes.size();
    return AbortCode::none;
  }
  AbortCode close_write(const Entry&, bool complete) {
    is_open_ = false;
    if (!complete) return AbortCode::none;
    const AbortCode answer = on_written(target().first(come_));
    if (answer != AbortCode::none) return answer;
    if (!spare_.empty()) std::swap(memory_, spare_);
    size_ = come_;
    return AbortCode::none;
  }

  std::span<std::uint8_t> memory_;
  std::span<std::uint8_t> spare_;
  std::size_t size_ = 0;
  std::size_t come_ = 0;  ///< bytes of the download that is under way
  bool is_open_ = false;  ///< one is
  Domain domain_;
  Hook hook_;
};

}  // namespace canvoy
