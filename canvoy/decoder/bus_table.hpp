// State for each bus of a log, by the name of the bus. Two buses may use the same node-ID or CAN-ID
// for different devices.
//
//     BusTable<Decoder> buses;
//     Decoder& decoder = buses.at("can1", [] { return std::make_unique<Decoder>(); });
//
// Bus names come from files. When more than the maximum number of buses appear, the bus that was
// silent for longest is dropped, and starts from the beginning if it is heard again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/check_invariant.hpp"
#include "canvoy/formats/trace/trace_text.hpp"

namespace canvoy::decoder {

template <class Bus>
class BusTable {
 public:
  static constexpr std::size_t usual_max = 64;  ///< buses kept by default

  /// `max`: number of buses that are kept, 1 or more.
  explicit BusTable(std::size_t max = usual_max) : max_(max) {}

  /// Returns the state of a bus, valid until the next call. `make` returns a std::unique_ptr to the
  /// state of a bus that has not been heard. Costs one comparison if the bus is that of the last
  /// call, else linear in the number of buses.
  template <class Make>
  Bus& at(std::string_view name, const Make& make) {
    if (last_ >= rooms_.size() || !formats::same_bytes(rooms_[last_].name, name))
      last_ = find(name, make);
    Room& room = rooms_[last_];
    room.heard = ++heard_;
    return *room.bus;
  }
  /// Calls `take` with the name and the state of each bus that is kept.
  void for_each(const auto& take) {
    for (Room& room : rooms_) take(std::string_view(room.name), *room.bus);
  }
  /// Number of buses that are kept.
  std::size_t max() const { return max_; }
  /// Number of times that a bus was dropped to make room for another.
  std::uint64_t forgotten() const { return forgotten_; }

 private:
  struct Room {
    std::string name;
    std::unique_ptr<Bus> bus;
    std::uint64_t heard = 0;  ///< when it was heard last
  };

  /// Not inlined, since at() is called for each frame and rarely needs it.
  template <class Make>
  [[gnu::noinline]] std::size_t find(std::string_view name, const Make& make) {
    auto room = std::ranges::find(rooms_, name, &Room::name);
    if (room == rooms_.end()) {
      if (rooms_.size() == max_) {
        rooms_.erase(std::ranges::min_element(rooms_, {}, &Room::heard));
        ++forgotten_;
      }
      rooms_.push_back({std::string(name), make()});
      check_invariant(rooms_.size() <= max_);
      room = rooms_.end() - 1;
    }
    return static_cast<std::size_t>(room - rooms_.begin());
  }

  std::size_t max_;
  std::vector<Room> rooms_;
  std::size_t last_ = 0;
  std::uint64_t heard_ = 0;
  std::uint64_t forgotten_ = 0;
};

}  // namespace canvoy::decoder
