// What physical devices have in common that are composed of virtual devices at run time, in memory
// from the heap, whatever their profile is (CiA 407, CiA 447).
//
//     UnitsOnHeap<cia447::CarUnit> units;  // the first member of a device
//     units.make(kind, network, environment);
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy {

/// For units without settings.
struct NoSettings {};

/// Parts in the order in which they are added, for devices composed at compile time.
struct PartArray {
  std::array<Part, 320> items{};  ///< more than a device has
  std::size_t count = 0;          ///< of parts

  /// Adds a part.
  constexpr void push_back(const Part& part) { items[count++] = part; }
  constexpr Part* begin() { return items.data(); }
  constexpr Part* end() { return items.data() + count; }
  constexpr const Part* begin() const { return items.data(); }
  constexpr const Part* end() const { return items.data() + count; }
};
/// A description of the parts that the function `make` returns as a PartArray.
template <auto make>
constexpr auto describe_parts() {
  DeviceDescription<make().count> description;
  for (const Part& part : make()) description.add(part);
  return description;
}

/// The types of a kind of virtual device.
template <class UnitType, class HardwareType, class SettingsType>
struct UnitKind {
  using Unit = UnitType;          ///< behaviour of the virtual device
  using Hardware = HardwareType;  ///< what the unit senses and drives
  using Settings = SettingsType;  ///< what no object of the dictionary sets
};

/// How a unit is made in a device that offers it a `Context`, which has node().
template <class Context>
struct UnitMaker {
  std::size_t bytes = 0;  ///< of memory for make(), aligned for any type
  /// Constructs the unit, and offers it to the environment.
  void (*make)(void* memory, Context& context, const Environment& environment) = nullptr;
  void (*end)(void* memory) = nullptr;  ///< destroys it; the memory stays
};
/// A unit is constructed with the context, its hardware and its settings. Hardware that the
/// environment does not offer is that of Kind::simulated(), or absent.
template <class Kind, class Context>
inline constexpr UnitMaker<Context> unit_maker = {
    .bytes = sizeof(typename Kind::Unit),
    .make =
        [](void* memory, Context& context, const Environment& environment) {
          using Made = typename Kind::Unit;
          static_assert(alignof(Made) <= alignof(std::max_align_t));
          typename Kind::Hardware otherwise{};
          if constexpr (requires { Kind::simulated(); }) otherwise = Kind::simulated();
          Made* const unit = std::construct_at(static_cast<Made*>(memory), context,
                                               environment.get<typename Kind::Hardware>(otherwise),
                                               environment.get<typename Kind::Settings>());
          environment.made<Made>(*unit, context.node());
        },
    .end = [](void* memory) { std::destroy_at(static_cast<typename Kind::Unit*>(memory)); }};

/// The units of a device. Their timers may be armed until the end: the device calls end() while it
/// still has its node, and this is its first member, so that the memory is released after the node.
template <class Row>
class UnitsOnHeap {
 public:
  /// Makes the next unit, of this kind.
  template <class Context>
  void make(const Row& kind, Context& context, const Environment& environment) {
    Made& made = units_.emplace_back(Made{&kind, std::make_unique<std::byte[]>(kind.unit.bytes)});
    kind.unit.make(made.memory.get(), context, environment);
  }
  /// Destroys the units, the last first.
  void end() {
    for (auto made = units_.rbegin(); made != units_.rend(); ++made) {
      made->kind->unit.end(made->memory.get());
    }
  }
  /// The Kind::Unit of a kind; null if there is none.
  void* find(const Row& kind) const {
    for (const Made& made : units_) {
      if (made.kind == &kind) return made.memory.get();
    }
    return nullptr;
  }

 private:
  struct Made {
    const Row* kind;
    std::unique_ptr<std::byte[]> memory;
  };

  std::vector<Made> units_;
};

/// The form of a physical device of one virtual device, for the catalogue: `units` are a list of
/// one row.
template <class Composed, const auto& units>
inline constexpr DeviceForm composed_form[1] = {
    {.parts =
         [] {
           // They live as long as the program.
           static const auto& parts = *new std::vector<Part>(Composed::parts_of(units));
           return std::span<const Part>(parts);
         },
     .bytes = sizeof(Composed),
     .make = [](void* memory, const Port& port, NodeId node_id,
                const Environment& environment) -> MadeDevice {
       auto* const made =
           std::construct_at(static_cast<Composed*>(memory), units, port, node_id, environment);
       return {&made->node(), &made->emergency_producer()};
     },
     .end = [](void* memory) { std::destroy_at(static_cast<Composed*>(memory)); }}};

}  // namespace canvoy
