// Records that wait for their PDO, in the order of arrival: a ring in memory of its owner.
//
//     WaitingRecords queue(memory);              // records of 6010h or 6011h, as they are
//     if (!queue.push(encode(record))) ...       // no room
//     WaitingNumbers changed(places);            // which inputs or sensors; who pushes each once,
//     changed.push(17);                          // and has a place for each, always finds room
#pragma once

#include <cstdint>
#include <span>

namespace canvoy::cia417 {

template <class Item>
class WaitingQueue {
 public:
  /// The size of `places` limits the number of waiting records; it must outlive the queue.
  explicit WaitingQueue(std::span<Item> places) : places_(places) {}

  bool empty() const { return size_ == 0; }
  std::uint32_t size() const { return size_; }
  /// False if there is no room.
  bool push(Item item) {
    if (size_ == places_.size()) return false;
    places_[(std::size_t{first_} + size_) % places_.size()] = item;
    ++size_;
    return true;
  }
  /// Removes and returns the first; 0 from an empty queue.
  Item pop() {
    if (empty()) return {};
    const Item item = places_[first_];
    first_ = static_cast<std::uint32_t>((first_ + std::size_t{1}) % places_.size());
    --size_;
    return item;
  }
  /// Discards all.
  void clear() { size_ = 0; }

 private:
  std::span<Item> places_;
  std::uint32_t first_ = 0;
  std::uint32_t size_ = 0;
};

using WaitingRecords = WaitingQueue<std::uint64_t>;  ///< of inputs or sensors, as in the PDO
using WaitingNumbers = WaitingQueue<std::uint32_t>;  ///< of inputs or sensors

}  // namespace canvoy::cia417
