// Which of many records are to be told, each once, in the order in which they changed: a ring that
// cannot overflow, since nobody is in it twice.
//
//     RecordQueue queue(places);      // as many places as there are records
//     queue.push(17);
//     const std::uint32_t record = queue.pop();
#pragma once

#include <cstdint>
#include <span>

namespace canvoy::cia417 {

class RecordQueue {
 public:
  /// Who pushes knows which records are in it. `places` must outlive the queue.
  explicit RecordQueue(std::span<std::uint32_t> places) : places_(places) {}

  bool empty() const { return size_ == 0; }
  std::uint32_t size() const { return size_; }
  void clear() { size_ = 0; }
  /// `record` is not in it.
  void push(std::uint32_t record) {
    places_[(std::size_t{first_} + size_) % places_.size()] = record;
    ++size_;
  }
  /// It is not empty.
  std::uint32_t pop() {
    const std::uint32_t record = places_[first_];
    first_ = static_cast<std::uint32_t>((first_ + std::size_t{1}) % places_.size());
    --size_;
    return record;
  }

 private:
  std::span<std::uint32_t> places_;
  std::uint32_t first_ = 0;
  std::uint32_t size_ = 0;
};

}  // namespace canvoy::cia417
