// The environment of a device of the catalogue: its hardware, and the settings for it.
// Hardware and settings are identified by their types, so that neither side depends on the other: a
// plant offers hardware, and a device takes what it needs and works without hardware that is not
// offered.
//
//     Environment environment;
//     environment.floors = 12;
//     environment.provide(callback<&LoadCell::hardware>(cell));
//     environment.watch(load_unit);                       // a pointer that is set
//     environment.watch(callback<&Car::has_load>(car));   // called with unit and node
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "canvoy/can/callback.hpp"
#include "canvoy/can/check_invariant.hpp"
#include "canvoy/canopen/node/node.hpp"

namespace canvoy {

class Environment {
 public:
  // Site of a device of a lift.

  unsigned lift = 1;     ///< 1 to 8
  unsigned door = 1;     ///< 1 to 4: the door that a unit moves or watches
  unsigned floor = 1;    ///< from 1, at which a panel hangs
  unsigned floors = 10;  ///< of the shaft

  bool keeps_parameters = false;  ///< the device has the objects of storage (1010h, 1011h)
  bool manages_network = true;    ///< a device with that ability starts the others

  Environment() = default;
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  /// `source` is called for each device that needs a Thing; everything to which it refers must
  /// outlive the devices. The first offer of a type counts; there is room for 24, and as many
  /// watchers.
  template <class Thing>
  void provide(Callback<Thing()> source) {
    add(provided_, &key<Thing>, source);
  }
  /// The same, by a member function; its result is the Thing.
  template <auto source, class Object>
  void provide(BoundMember<source, Object> bound) {
    using Thing = std::remove_cvref_t<decltype((bound.object.*source)())>;
    provide(Callback<Thing()>(bound));
  }
  /// The offered Thing, or `otherwise`.
  template <class Thing>
  Thing get(const Thing& otherwise = {}) const {
    const Callback<void()>* source = find_in(provided_, &key<Thing>);
    return source == nullptr ? otherwise : std::bit_cast<Callback<Thing()>>(*source)();
  }

  /// `watcher` is called with each Unit that is made here, and its node.
  template <class Unit>
  void watch(Callback<void(Unit&, Node&)> watcher) {
    add(watchers_, &key<Unit>, watcher);
  }
  /// The same, by a member function that takes a Unit& and a Node&.
  template <auto watcher, class Object>
  void watch(BoundMember<watcher, Object> bound) {
    watch(to_watcher(bound, watcher));
  }
  /// `unit` is set to each Unit that is made here; it must outlive the devices.
  template <class Unit>
  void watch(Unit*& unit) {
    watch(Callback<void(Unit&, Node&)>(
        [](void* kept, Unit& made, Node&) { *static_cast<Unit**>(kept) = &made; }, &unit));
  }
  /// Tells the watcher of a type about a unit that was made; called by the device.
  template <class Unit>
  void made(Unit& unit, Node& node) const {
    const Callback<void()>* watcher = find_in(watchers_, &key<Unit>);
    if (watcher != nullptr) std::bit_cast<Callback<void(Unit&, Node&)>> (*watcher)(unit, node);
  }

 private:
  /// A type is identified by the address of its own variable: boards have no RTTI.
  template <class Type>
  static inline char key = 0;

  struct Known {
    const void* key = nullptr;
    Callback<void()> call = {};  ///< actually of another signature
  };
  static constexpr std::size_t known_max = 24;
  using AllKnown = std::array<Known, known_max>;

  template <class Bound, class Object, class Unit>
  static Callback<void(Unit&, Node&)> to_watcher(Bound bound,
                                                 void (Object::* /*watcher*/)(Unit&, Node&)) {
    return bound;
  }
  template <class Call>
  static void add(AllKnown& all, const void* what, const Call& call) {
    for (Known& known : all) {
      if (known.key != nullptr) continue;
      known = {what, std::bit_cast<Callback<void()>>(call)};
      return;
    }
    check_invariant(false);  // no room: known_max
  }
  static const Callback<void()>* find_in(const AllKnown& all, const void* what) {
    for (const Known& known : all) {
      if (known.key == what) return &known.call;
    }
    return nullptr;
  }

  AllKnown provided_;
  AllKnown watchers_;
};

}  // namespace canvoy
