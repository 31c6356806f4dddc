// The objects of a physical device of CiA 447: of one virtual device or several, with what all of
// them have in common, and the pre-defined PDOs of which all objects exist.
//
//     const CarUnit* units[] = {&car_unit<TaximeterKind>, &car_unit<PrinterKind>};
//     const std::vector<Part> parts = CarParts<std::vector<Part>>(units, 1s).make();
//
// `make` works at run time, for devices that are composed then, and at compile time, for boards
// (car_board.hpp).
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/kit/composed_device.hpp"
#include "canvoy/profiles/cia447/device.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"

namespace canvoy::cia447 {

/// One virtual device of a physical one (car_kind.hpp makes it of a kind).
struct CarUnit {
  DeviceInfo info;  ///< as in the catalogue
  /// The virtual device, with its objects.
  const VirtualDeviceInfo* provides = nullptr;
  std::span<const ObjectInfo* const> consumes = {};  ///< of other devices
  std::span<const ObjectInfo* const> own = {};       ///< of the manufacturer's area
  UnitMaker<CarNetwork> unit;                        ///< makes its unit
};

namespace composing::detail {

inline constexpr std::uint8_t errors_kept = 8;

/// PDOs of a direction that can carry what they map.
template <PdoInfo::Direction direction>
struct IsPossible {
  constexpr bool operator()(const PdoInfo& pdo) const {
    return pdo.direction == direction && can_be_mapped(pdo);
  }
};
template <PdoInfo::Direction direction>
inline constexpr auto possible_pdos = predefined_pdos<profile, IsPossible<direction>{}>();

inline constexpr auto basics =
    describe(cia301::error_register_object, cia301::emergency(), cia301::error_history(errors_kept),
             Part(cia301::sdo_server_object).only(0, node_id_max),
             Part(cia301::sdo_client_object).only(0, node_id_max));

}  // namespace composing::detail

/// Composes a device. `List` is a std::vector<Part>, or has push_back(), begin() and end(). An
/// object of a provider has priority over that of a consumer.
template <class List>
class CarParts {
 public:
  /// Makes the work on a device of these units, which must outlive this. `heartbeat` is the default
  /// of 1017h: whole milliseconds, 0 to 65.535 s.
  constexpr CarParts(std::span<const CarUnit* const> units, Duration heartbeat)
      : units_(units), heartbeat_(heartbeat) {}

  /// Its parts, sorted by their indices.
  constexpr List make() && {
    add_basics();
    for (const CarUnit* unit : units_) {
      for (const DeviceObject& object : unit->provides->objects) {
        add(Part(*find_object(profile, object.index)));
      }
      for (const ObjectInfo* object : unit->own) add(Part(*object));
    }
    for (const CarUnit* unit : units_) {
      for (const ObjectInfo* object : unit->consumes) add(Part(*object).consumed());
    }
    add_pdos<PdoInfo::Direction::transmit>();
    add_pdos<PdoInfo::Direction::receive>();
    if (has_pdos()) add(cia301::sync_consumer());
    std::ranges::sort(parts_, {}, &Part::index);
    return std::move(parts_);
  }

 private:
  constexpr void add_basics() {
    const DeviceInfo& first = units_.front()->info;
    add(cia301::device_type(device_type));
    add(cia301::identity({.product_code = first.product_code}));
    const auto names = cia301::names(
        {.device = first.product, .hardware_version = "simulated", .software_version = "0.1.0"});
    for (const Part& part : names) add(part);
    for (const Part& part : composing::detail::basics) add(part);
    add(cia301::heartbeat_producer(static_cast<std::uint16_t>(heartbeat_ / 1ms)));
  }
  constexpr void add(const Part& part) {
    if (find(part.index()) == nullptr) parts_.push_back(part);
  }
  /// PDOs of which all objects exist, and are this device's own or another's.
  template <PdoInfo::Direction direction>
  constexpr void add_pdos() {
    constexpr bool sends = direction == PdoInfo::Direction::transmit;
    for (const PdoInfo& pdo : pdos) {
      if (pdo.direction != direction || !can_be_mapped(pdo)) continue;
      const bool is_wanted = std::ranges::all_of(pdo.mapping, [this](std::uint32_t raw) {
        const Part* part = find(MappingValue(raw).index);
        return part != nullptr && part->is_consumed() != sends;
      });
      if (!is_wanted) continue;
      const unsigned parameter = (sends ? 0x1800U : 0x1400U) + pdo.number - 1;
      add(*composing::detail::possible_pdos<direction>.find(parameter));
      add(*composing::detail::possible_pdos<direction>.find(parameter + 0x200));
    }
  }
  constexpr bool has_pdos() const {
    return std::ranges::any_of(parts_, [](const Part& part) {
      return part.index() >= object_index::rpdo_parameter &&
             part.index() <= object_index::tpdo_mapping_last;
    });
  }
  constexpr const Part* find(unsigned index) const {
    const auto is_it = [index](const Part& part) {
      return index >= part.index() && index - part.index() < part.count();
    };
    const auto found = std::ranges::find_if(parts_, is_it);
    return found == parts_.end() ? nullptr : &*found;
  }

  std::span<const CarUnit* const> units_;
  Duration heartbeat_;
  List parts_;
};

}  // namespace canvoy::cia447
