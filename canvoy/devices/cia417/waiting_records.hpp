// Records of 6010h or 6011h that wait for their PDO, in the order in which they came.
//
//     WaitingRecords queue(memory);
//     if (!queue.push(encode(record))) ...   // no room
#pragma once

#include <cstdint>
#include <span>

namespace canvoy::cia417 {

class WaitingRecords {
 public:
  /// `memory` bounds the records that wait, and must outlive the queue.
  explicit WaitingRecords(std::span<std::uint64_t> memory) : memory_(memory) {}

  bool empty() const { return size_ == 0; }
  bool push(std::uint64_t record) {
    if (size_ == memory_.size()) return false;
    memory_[(first_ + size_) % memory_.size()] = record;
    ++size_;
    return true;
  }
  /// The first, where there is one.
  std::uint64_t pop() {
    if (empty()) return 0;
    const std::uint64_t record = memory_[first_];
    first_ = (first_ + 1) % memory_.size();
    --size_;
    return record;
  }
  void clear() { size_ = 0; }

 private:
  std::span<std::uint64_t> memory_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace canvoy::cia417
