// The objects of a physical device of CiA 407: of one virtual device or several, with what all of
// them have in common, and the pre-defined PDOs of the minimum and the typical configuration
// (8.1.4.3).
//
//     const BusUnit* units[] = {&bus_unit<TicketCancellerKind>, &bus_unit<AnnouncerKind>};
//     const std::vector<Part> parts = BusParts<std::vector<Part>>(units, segment).make();
//
// `make` works at run time, for devices that are composed then, and at compile time, for boards
// (bus_board.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/cia407/kit/virtual_devices.hpp"
#include "canvoy/devices/kit/composed_device.hpp"
#include "canvoy/profiles/cia407/configuration.hpp"
#include "canvoy/profiles/model/layout.hpp"

namespace canvoy::cia407 {

/// The descriptions of a PDO that a unit adds to those of the profile (8.1.5). TPDOs 1 to 4 get the
/// CAN-ID of the pre-defined connection set of their node. Others, and RPDOs, are invalid until the
/// network assigns one, unless the description has one (PdoInfo::cob_id).
struct OwnPdo {
  /// Segments of the network in which the unit has the PDO.
  enum class Where : std::uint8_t { everywhere, with_main_computer, without_main_computer };

  /// Mapping, direction and CAN-ID.
  const PdoInfo* info = nullptr;
  const ObjectInfo* parameter = nullptr;  ///< communication record
  const ObjectInfo* mapping = nullptr;    ///< mapping record
  Where where = Where::everywhere;        ///< segments of the network

  /// True if the unit has the PDO in a segment with, or without, a main on-board computer.
  constexpr bool is_in(bool has_main_computer) const {
    return where == Where::everywhere || (where == Where::with_main_computer) == has_main_computer;
  }
};
/// Both records of a PDO.
template <const PdoInfo& pdo, OwnPdo::Where where = OwnPdo::Where::everywhere>
inline constexpr OwnPdo own_pdo = {
    .info = &pdo,
    .parameter = &detail::PredefinedPdo<detail::OwnPdo<pdo>>::parameter,
    .mapping = &detail::PredefinedPdo<detail::OwnPdo<pdo>>::mapping,
    .where = where};

/// One virtual device of a physical one (bus_kind.hpp makes it of a kind).
struct BusUnit {
  DeviceInfo info;  ///< as in the catalogue
  /// The virtual device, with its objects and events; or `application`.
  const VirtualDeviceInfo* provides = nullptr;
  std::span<const OwnPdo> pdos = {};  ///< that the unit adds to those of the profile
  /// Numbers of entries of arrays, or of bytes in them, where they differ from the usual ones.
  std::span<const WantedObject> sizes = {};
  std::size_t routes = 0;         ///< CAN-IDs that it receives
  UnitMaker<VirtualDevice> unit;  ///< makes its unit
};

/// For a unit that is the application of a virtual device, and provides nothing itself. It is
/// behind the virtual devices of its physical device.
inline constexpr VirtualDeviceInfo application = {.name = "application"};

/// Segment of the network, for the composition of a device (footnotes of 6.2, 6.3 and 6.10).
struct BusSegment {
  Configuration configuration = Configuration::typical;  ///< minimum or typical, 8.1.4.3
  bool has_main_computer = true;                         ///< or an identification device
  bool has_diagnostics = true;                           ///< a diagnostics device
  /// 6196h to 6198h are provided by the identification device instead of the main on-board
  /// computer.
  bool identification_provides_texts = false;
  /// A main on-board computer, or else a train bus gateway, is the NMT master of the segment and
  /// starts the others (8.1.4.3 leaves the choice open).
  bool is_started_by_first = false;
};

namespace composing::detail {

inline constexpr auto basics = describe(error_register_object, cia301::heartbeat_producer(1000),
                                        cia301::heartbeat_consumers(16), cia301::emergency(),
                                        cia301::error_history(8), error_behavior_object);

/// The specification leaves the number of entries to the device: these are the usual numbers here,
/// and the bytes of an entry.
inline constexpr WantedObject usual_sizes[] = {
    {0x610C, 16}, {0x610D, 16}, {0x6112, 64}, {0x6200, 8, 4096}, {0x6201, 16}, {0x6202, 8},
    {0x6203, 33}, {0x6205, 15}, {0x6488, 4},  {0x648D, 4},       {0x6762, 4},  {0x6763, 4},
};

/// Both records of a PDO.
struct PdoObjects {
  const ObjectInfo* parameter;  ///< communication record
  const ObjectInfo* mapping;    ///< mapping record
};
/// In the order of `pdos`.
template <std::size_t... position>
constexpr std::array<PdoObjects, sizeof...(position)> make_listed(
    std::index_sequence<position...>) {
  return {PdoObjects{
      &canvoy::detail::PredefinedPdo<canvoy::detail::ListedPdo<profile, position>>::parameter,
      &canvoy::detail::PredefinedPdo<canvoy::detail::ListedPdo<profile, position>>::mapping}...};
}
inline constexpr auto listed_objects = make_listed(std::make_index_sequence<std::size(pdos)>());

/// A footnote changes which device has the object (6.2, 6.3, 6.10).
constexpr DeviceObject in_segment(DeviceObject object, const BusSegment& segment) {
  const auto provide = [&](bool is_provided) {
    object.access = is_provided ? Access::ro : Access::wo;
    object.consumed = !is_provided;
  };
  if (object.condition == identification_provides_texts && segment.identification_provides_texts) {
    provide(false);
  } else if (object.condition == main_computer_takes_texts) {
    provide(segment.identification_provides_texts);
  } else if ((object.condition == no_main_computer && !segment.has_main_computer) ||
             (object.condition == no_diagnostics && !segment.has_diagnostics)) {
    provide(true);
  }
  return object;
}

}  // namespace composing::detail

/// Composes a device. `List` is a std::vector<Part>, or has push_back(), begin() and end().
template <class List>
class BusParts {
 public:
  /// Makes the work on a device of these units, in this segment; both must outlive this.
  constexpr BusParts(std::span<const BusUnit* const> units, const BusSegment& segment)
      : units_(units), segment_(segment) {}

  /// Its parts, sorted by their indices.
  constexpr List make() && {
    add_basics();
    for (const BusUnit* unit : units_) add_objects(*unit);
    add_listed_pdos(PdoInfo::Direction::transmit);
    add_listed_pdos(PdoInfo::Direction::receive);
    for (const BusUnit* unit : units_) add_own_pdos(*unit);
    const bool has_pdos = std::ranges::any_of(parts_, [](const Part& part) {
      return part.index() >= first_rpdo && part.index() < first_tpdo + to_mapping;
    });
    if (has_pdos) parts_.push_back(cia301::sync_consumer());
    std::ranges::sort(parts_, {}, &Part::index);
    return std::move(parts_);
  }

 private:
  static constexpr std::uint16_t first_tpdo = object_index::tpdo_parameter;
  static constexpr std::uint16_t first_rpdo = object_index::rpdo_parameter;
  static constexpr std::uint16_t to_mapping =
      object_index::tpdo_mapping - object_index::tpdo_parameter;
  static constexpr unsigned pdos_max = 512;
  static constexpr unsigned tpdos_of_connection_set = 4;
  static constexpr std::uint32_t first_can_id = 0x180;
  static constexpr std::uint32_t can_id_step = 0x100;
  static constexpr std::uint32_t not_valid = 0x8000'0000;

  constexpr std::size_t virtual_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        units_, [](const BusUnit* unit) { return unit->provides->code != application.code; }));
  }
  constexpr void add_basics() {
    const DeviceInfo& first = units_.front()->info;
    const auto count = static_cast<unsigned>(virtual_count());
    const bool are_several = count > 1;
    parts_.push_back(cia301::device_type(are_several ? multiple_device_type
                                                     : device_type(*units_.front()->provides)));
    parts_.push_back(cia301::identity({.product_code = first.product_code}));
    const auto names = cia301::names(
        {.device = first.product, .hardware_version = "simulated", .software_version = "0.1.0"});
    for (const Part& part : names) parts_.push_back(part);
    for (const Part& part : composing::detail::basics) parts_.push_back(part);
    if (!are_several) return;
    parts_.push_back(Part(supported_virtual_device_types_object).up_to(count));
    parts_.push_back(Part(device_type_object));
  }

  constexpr void add_objects(const BusUnit& unit) {
    for (const DeviceObject& listed : unit.provides->objects) {
      add_object(unit, composing::detail::in_segment(listed, segment_));
    }
    // It sends the third message in place of the main on-board computer, which has the object
    // (errata 31).
    const bool stands_in = unit.provides->code == code_of(DeviceCode::train_bus_gateway) &&
                           !segment_.has_main_computer;
    if (stands_in) {
      add_object(unit, provides(events_from_virtual_devices_object.index, Category::optional));
    }
  }
  constexpr void add_object(const BusUnit& unit, const DeviceObject& as) {
    const ObjectInfo* object = find_object(profile, as.index);
    if (object == nullptr) return;
    Part part = detail::part_of(*object, as.index, as, size_of(unit, as.index));
    // SDO does not read it (6.2: wo), but the third message of 8.1.4.3 carries it.
    if (passes_events_on(unit, as.index)) {
      part = part.access(1, Access::wo | Access::tpdo | Access::rpdo);
    }
    Part* known = find(as.index);
    if (known == nullptr) {
      parts_.push_back(part);
    } else if (known->is_consumed() != part.is_consumed()) {
      if (known->is_consumed()) *known = part;
      if (has_counts_of_others(as.index)) *known = known->access(0, Access::rw);
    }
  }
  /// A device that consumes counts consumes those of all doors (6.22), even if one is counted in
  /// this device.
  static constexpr bool has_counts_of_others(std::uint16_t index) {
    return index == passenger_counting_in_and_out_per_door_object.index;
  }
  /// The third message of a main on-board computer carries the events that it has received (errata
  /// 96).
  constexpr bool passes_events_on(const BusUnit& unit, std::uint16_t index) const {
    return index == events_from_virtual_devices_object.index &&
           unit.provides->code == code_of(DeviceCode::main_on_board_computer) &&
           segment_.configuration == Configuration::typical;
  }
  constexpr WantedObject size_of(const BusUnit& unit, std::uint16_t index) const {
    const bool is_events_from = index == events_from_virtual_devices_object.index;
    if (is_events_from || index == events_for_virtual_devices_object.index) {
      // The main on-board computer has room for the maximum number.
      const bool has_all = std::ranges::any_of(units_, [](const BusUnit* each) {
        return each->provides->code == code_of(DeviceCode::main_on_board_computer);
      });
      const std::size_t count =
          has_all ? VirtualDevices::with_events_max
                  : std::min<std::size_t>(virtual_count(), VirtualDevices::with_events_max);
      return {index, static_cast<std::uint8_t>(count + (is_events_from ? 1 : 0))};
    }
    for (const WantedObject& size : unit.sizes) {
      if (size.index == index) return size;
    }
    for (const WantedObject& size : composing::detail::usual_sizes) {
      if (size.index == index) return size;
    }
    return {};
  }

  /// Of several descriptions of one message, the one with the most existing objects: several
  /// virtual devices may receive it.
  constexpr void add_listed_pdos(PdoInfo::Direction direction) {
    for (std::size_t i = 0; i < std::size(pdos); ++i) {
      if (pdos[i].direction != direction || !is_wanted(pdos[i])) continue;
      const bool is_best = std::ranges::none_of(pdos, [&](const PdoInfo& other) {
        const bool is_same = other.direction == direction && other.cob_id == pdos[i].cob_id;
        return is_same && is_wanted(other) &&
               (values_of(other) > values_of(pdos[i]) ||
                (values_of(other) == values_of(pdos[i]) && &other < &pdos[i]));
      });
      if (!is_best) continue;
      const unsigned number = free_number(direction, pdos[i].number);
      if (number == 0) return;
      add_pdo(direction, number, pdos[i].number, *composing::detail::listed_objects[i].parameter,
              *composing::detail::listed_objects[i].mapping);
    }
  }
  constexpr bool is_wanted(const PdoInfo& pdo) const {
    const bool has_it = std::ranges::any_of(units_, [&](const BusUnit* unit) {
      return has_pdo(*unit->provides, segment_.configuration, pdo);
    });
    return has_it && has_mapped(pdo);
  }
  /// Objects that one virtual device of this device has from another already exist.
  constexpr bool has_mapped(const PdoInfo& pdo) const {
    const Access needed =
        pdo.direction == PdoInfo::Direction::transmit ? Access::tpdo : Access::rpdo;
    return std::ranges::all_of(pdo.mapping, [&](std::uint32_t raw) {
      if (MappingValue(raw).is_dummy()) return true;
      const MappingValue mapped(raw);
      const Part* part = find(mapped.index);
      const EntryInfo* entry = part == nullptr ? nullptr : find_entry(part->object(), mapped.sub);
      return entry != nullptr && part->has(*entry) &&
             allows(detail::access_of(*part, *entry), needed);
    });
  }
  static constexpr std::ptrdiff_t values_of(const PdoInfo& pdo) {
    return std::ranges::count_if(pdo.mapping,
                                 [](std::uint32_t raw) { return !MappingValue(raw).is_dummy(); });
  }

  constexpr void add_own_pdos(const BusUnit& unit) {
    for (const OwnPdo& pdo : unit.pdos) {
      if (!pdo.is_in(segment_.has_main_computer) || !has_mapped(*pdo.info)) continue;
      const unsigned number = free_number(pdo.info->direction, 1);
      if (number == 0) return;
      add_pdo(pdo.info->direction, number, pdo.info->number, *pdo.parameter, *pdo.mapping,
              can_id_of(*pdo.info, number));
    }
  }
  static constexpr Default can_id_of(const PdoInfo& pdo, unsigned number) {
    if (pdo.cob_id != 0) return pdo.cob_id;
    const bool is_in_set =
        pdo.direction == PdoInfo::Direction::transmit && number <= tpdos_of_connection_set;
    return is_in_set ? plus_node_id(first_can_id + can_id_step * (number - 1)) : Default(not_valid);
  }
  constexpr void add_pdo(PdoInfo::Direction direction, unsigned number, unsigned described,
                         const ObjectInfo& parameter, const ObjectInfo& mapping,
                         const std::optional<Default>& cob_id = std::nullopt) {
    const std::uint16_t first = direction == PdoInfo::Direction::transmit ? first_tpdo : first_rpdo;
    Part moved = Part(parameter).moved(first + number - 1U - parameter.index);
    if (cob_id) moved = moved.initial(1, *cob_id);
    parts_.push_back(moved);
    parts_.push_back(Part(mapping).moved(number - described));
  }
  /// The wanted number, or the next free one; 0: none.
  constexpr unsigned free_number(PdoInfo::Direction direction, unsigned wanted) const {
    const unsigned first = direction == PdoInfo::Direction::transmit ? first_tpdo : first_rpdo;
    for (unsigned number = wanted; number <= pdos_max; ++number) {
      if (find(first + number - 1) == nullptr) return number;
    }
    return 0;
  }

  constexpr const Part* find(unsigned index) const {
    const auto found = std::ranges::find(parts_, index, &Part::index);
    return found == parts_.end() ? nullptr : &*found;
  }
  constexpr Part* find(unsigned index) {
    const auto found = std::ranges::find(parts_, index, &Part::index);
    return found == parts_.end() ? nullptr : &*found;
  }

  std::span<const BusUnit* const> units_;
  const BusSegment& segment_;
  List parts_;
};

}  // namespace canvoy::cia407
