// Where a device of the catalogue is put: the hardware that it finds there, and what is chosen for
// it. Hardware and settings are known by their types, so that neither side knows the other: a plant
// offers what it has, a device takes what it needs, and does without where nobody offers it.
//
//     Site site;
//     site.floors = 12;
//     site.offer(Callback<cia417::LoadHardware()>::to<&LoadCell::hardware>(cell));
//     site.watch(Callback<void(cia417::LoadMeasuringUnit&, Node&)>::to<&Car::has_load>(car));
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/must_hold.hpp"
#include "canvoy/canopen/node.hpp"

namespace canvoy {

class Site {
 public:
  // What devices of a lift want to know of the place where they hang.

  unsigned lift = 1;  ///< 1 to 8
  unsigned door = 1;  ///< 1 to 4: that a unit moves or watches
  unsigned floor = 1;
  unsigned floors = 10;

  bool keeps_parameters = false;  ///< the device has the objects of storage (1010h, 1011h)
  bool manages_network = true;    ///< a device that can starts the others

  Site() = default;
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  /// `source` is asked for each device that wants a Thing; what it refers to must outlive the
  /// devices. The first offer of a type counts; there is room for 24, and as many watchers.
  template <class Thing>
  void offer(Callback<Thing()> source) {
    add(offers_, &key<Thing>, source);
  }
  /// What was offered, or `otherwise`.
  template <class Thing>
  Thing find(const Thing& otherwise = {}) const {
    const Callback<void()>* source = find_in(offers_, &key<Thing>);
    return source == nullptr ? otherwise : std::bit_cast<Callback<Thing()>>(*source)();
  }

  /// `watcher` is told of each Unit that is made here, and of its node.
  template <class Unit>
  void watch(Callback<void(Unit&, Node&)> watcher) {
    add(watchers_, &key<Unit>, watcher);
  }
  template <class Unit>
  void made(Unit& unit, Node& node) const {
    const Callback<void()>* watcher = find_in(watchers_, &key<Unit>);
    if (watcher != nullptr) std::bit_cast<Callback<void(Unit&, Node&)>> (*watcher)(unit, node);
  }

 private:
  /// A type is known by the address of its own variable: boards have no RTTI.
  template <class Type>
  static inline char key = 0;

  struct Known {
    const void* key = nullptr;
    Callback<void()> call = {};  ///< of another signature, in fact
  };
  static constexpr std::size_t known_max = 24;
  using AllKnown = std::array<Known, known_max>;

  template <class Call>
  static void add(AllKnown& all, const void* what, const Call& call) {
    for (Known& known : all) {
      if (known.key != nullptr) continue;
      known = {what, std::bit_cast<Callback<void()>>(call)};
      return;
    }
    must_hold(false);  // there is no room: known_max
  }
  static const Callback<void()>* find_in(const AllKnown& all, const void* what) {
    for (const Known& known : all) {
      if (known.key == what) return &known.call;
    }
    return nullptr;
  }

  AllKnown offers_;
  AllKnown watchers_;
};

}  // namespace canvoy
