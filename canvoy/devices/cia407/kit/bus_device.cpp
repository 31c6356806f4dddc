#include "canvoy/devices/cia407/kit/bus_device.hpp"

#include <algorithm>
#include <optional>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/devices/kit/device_kind.hpp"

namespace canvoy::cia407 {

namespace {

constexpr std::uint16_t heartbeat_ms = 1000;
constexpr std::uint8_t errors_kept = 8;
constexpr unsigned nodes_watched = 16;
constexpr std::uint16_t first_tpdo = object_index::tpdo_parameter;
constexpr std::uint16_t first_rpdo = object_index::rpdo_parameter;
constexpr std::uint16_t to_mapping = object_index::tpdo_mapping - object_index::tpdo_parameter;
constexpr unsigned pdos_max = 512;
constexpr unsigned tpdos_of_connection_set = 4;
constexpr std::uint32_t first_can_id = 0x180;
constexpr std::uint32_t can_id_step = 0x100;
constexpr std::uint32_t not_valid = 0x8000'0000;

constexpr auto basics = describe(error_register_object, cia301::heartbeat_producer(heartbeat_ms),
                                 cia301::heartbeat_consumers(nodes_watched), cia301::emergency(),
                                 cia301::error_history(errors_kept), error_behavior_object);

/// The specification leaves the number of entries to the device: these are the usual numbers here,
/// and the bytes of an entry.
constexpr WantedObject usual_sizes[] = {
    {0x610C, 16}, {0x610D, 16}, {0x6112, 64}, {0x6200, 8, 4096}, {0x6201, 16}, {0x6202, 8},
    {0x6203, 33}, {0x6205, 15}, {0x6488, 4},  {0x648D, 4},       {0x6762, 4},  {0x6763, 4},
};

struct PdoObjects {
  const ObjectInfo* parameter;
  const ObjectInfo* mapping;
};
/// In the order of `pdos`.
template <std::size_t... position>
constexpr std::array<PdoObjects, sizeof...(position)> make_listed(
    std::index_sequence<position...>) {
  return {PdoObjects{&detail::PredefinedPdo<detail::ListedPdo<profile, position>>::parameter,
                     &detail::PredefinedPdo<detail::ListedPdo<profile, position>>::mapping}...};
}
constexpr auto listed_objects = make_listed(std::make_index_sequence<std::size(pdos)>());

constexpr bool is_dummy(std::uint32_t raw) {
  return MappingValue(raw).is_dummy();
}

/// A footnote changes which device has the object (6.2, 6.3, 6.10).
DeviceObject in_segment(DeviceObject object, const BusSegment& segment) {
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

class BusParts {
 public:
  BusParts(std::span<const BusUnit* const> units, const BusSegment& segment)
      : units_(units), segment_(segment) {}

  std::vector<Part> make() && {
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
  std::size_t virtual_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        units_, [](const BusUnit* unit) { return unit->provides->code != application.code; }));
  }
  void add_basics() {
    const DeviceInfo& first = units_.front()->info;
    const auto count = static_cast<unsigned>(virtual_count());
    const bool are_several = count > 1;
    parts_.push_back(cia301::device_type(are_several ? multiple_device_type
                                                     : device_type(*units_.front()->provides)));
    parts_.push_back(cia301::identity({.product_code = first.product_code}));
    const auto names = cia301::names(
        {.device = first.product, .hardware_version = "simulated", .software_version = "0.1.0"});
    parts_.insert(parts_.end(), names.begin(), names.end());
    parts_.insert(parts_.end(), basics.begin(), basics.end());
    if (!are_several) return;
    parts_.push_back(Part(supported_virtual_device_types_object).up_to(count));
    parts_.emplace_back(device_type_object);
  }

  void add_objects(const BusUnit& unit) {
    for (const DeviceObject& listed : unit.provides->objects) {
      add_object(unit, in_segment(listed, segment_));
    }
    // It sends the third message in place of the main on-board computer, which has the object
    // (errata 31).
    const bool stands_in = unit.provides->code == code_of(DeviceCode::train_bus_gateway) &&
                           !segment_.has_main_computer;
    if (stands_in) {
      add_object(unit, provides(events_from_virtual_devices_object.index, Category::optional));
    }
  }
  void add_object(const BusUnit& unit, const DeviceObject& as) {
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
  static bool has_counts_of_others(std::uint16_t index) {
    return index == passenger_counting_in_and_out_per_door_object.index;
  }
  /// The third message of a main on-board computer carries the events that it has received (errata
  /// 96).
  bool passes_events_on(const BusUnit& unit, std::uint16_t index) const {
    return index == events_from_virtual_devices_object.index &&
           unit.provides->code == code_of(DeviceCode::main_on_board_computer) &&
           segment_.configuration == Configuration::typical;
  }
  WantedObject size_of(const BusUnit& unit, std::uint16_t index) const {
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
    for (const WantedObject& size : usual_sizes) {
      if (size.index == index) return size;
    }
    return {};
  }

  /// Of several descriptions of one message, the one with the most existing objects: several
  /// virtual devices may receive it.
  void add_listed_pdos(PdoInfo::Direction direction) {
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
      add_pdo(direction, number, pdos[i].number, *listed_objects[i].parameter,
              *listed_objects[i].mapping);
    }
  }
  bool is_wanted(const PdoInfo& pdo) const {
    const bool has_it = std::ranges::any_of(units_, [&](const BusUnit* unit) {
      return has_pdo(*unit->provides, segment_.configuration, pdo);
    });
    return has_it && has_mapped(pdo);
  }
  /// Objects that one virtual device of this device has from another already exist.
  bool has_mapped(const PdoInfo& pdo) const {
    const Access needed =
        pdo.direction == PdoInfo::Direction::transmit ? Access::tpdo : Access::rpdo;
    return std::ranges::all_of(pdo.mapping, [&](std::uint32_t raw) {
      if (is_dummy(raw)) return true;
      const MappingValue mapped(raw);
      const Part* part = find(mapped.index);
      const EntryInfo* entry = part == nullptr ? nullptr : find_entry(part->object(), mapped.sub);
      return entry != nullptr && part->has(*entry) &&
             allows(detail::access_of(*part, *entry), needed);
    });
  }
  static std::ptrdiff_t values_of(const PdoInfo& pdo) {
    return std::ranges::count_if(pdo.mapping, [](std::uint32_t raw) { return !is_dummy(raw); });
  }

  void add_own_pdos(const BusUnit& unit) {
    for (const OwnPdo& pdo : unit.pdos) {
      if (!pdo.is_in(segment_.has_main_computer) || !has_mapped(*pdo.info)) continue;
      const unsigned number = free_number(pdo.info->direction, 1);
      if (number == 0) return;
      add_pdo(pdo.info->direction, number, pdo.info->number, *pdo.parameter, *pdo.mapping,
              can_id_of(*pdo.info, number));
    }
  }
  static Default can_id_of(const PdoInfo& pdo, unsigned number) {
    if (pdo.cob_id != 0) return pdo.cob_id;
    const bool is_in_set =
        pdo.direction == PdoInfo::Direction::transmit && number <= tpdos_of_connection_set;
    return is_in_set ? plus_node_id(first_can_id + can_id_step * (number - 1)) : Default(not_valid);
  }
  void add_pdo(PdoInfo::Direction direction, unsigned number, unsigned described,
               const ObjectInfo& parameter, const ObjectInfo& mapping,
               const std::optional<Default>& cob_id = std::nullopt) {
    const std::uint16_t first = direction == PdoInfo::Direction::transmit ? first_tpdo : first_rpdo;
    Part moved = Part(parameter).moved(first + number - 1U - parameter.index);
    if (cob_id) moved = moved.initial(1, *cob_id);
    parts_.push_back(moved);
    parts_.push_back(Part(mapping).moved(number - described));
  }
  /// The wanted number, or the next free one; 0: none.
  unsigned free_number(PdoInfo::Direction direction, unsigned wanted) const {
    const unsigned first = direction == PdoInfo::Direction::transmit ? first_tpdo : first_rpdo;
    for (unsigned number = wanted; number <= pdos_max; ++number) {
      if (find(first + number - 1) == nullptr) return number;
    }
    return 0;
  }

  const Part* find(unsigned index) const {
    const auto found = std::ranges::find(parts_, index, &Part::index);
    return found == parts_.end() ? nullptr : &*found;
  }
  Part* find(unsigned index) {
    const auto found = std::ranges::find(parts_, index, &Part::index);
    return found == parts_.end() ? nullptr : &*found;
  }

  std::span<const BusUnit* const> units_;
  const BusSegment& segment_;
  std::vector<Part> parts_;
};

bool starts_others(std::span<const BusUnit* const> units, const BusSegment& segment) {
  const DeviceCode first = segment.has_main_computer ? DeviceCode::main_on_board_computer
                                                     : DeviceCode::train_bus_gateway;
  return segment.is_started_by_first && std::ranges::any_of(units, [first](const BusUnit* unit) {
           return unit->provides->code == code_of(first);
         });
}

std::size_t routes_of(std::span<const BusUnit* const> units, const BusSegment& segment) {
  std::size_t routes = starts_others(units, segment) ? NetworkStart::routes : 0;
  for (const BusUnit* unit : units) routes += unit->routes;
  return routes;
}

}  // namespace

std::vector<Part> bus_parts(std::span<const BusUnit* const> units, const BusSegment& segment) {
  return BusParts(units, segment).make();
}

BusDevice::BusDevice(std::span<const BusUnit* const> units, const Port& port, NodeId node_id,
                     const Environment& environment)
    : tables_(bus_parts(units, environment.get<BusSegment>())),
      device_(tables_.tables(), port, node_id,
              catalogue_routes + routes_of(units, environment.get<BusSegment>())),
      all_(device_.node()) {
  environment.made<VirtualDevices>(all_, device_.node());
  for (const BusUnit* kind : units) {
    VirtualDevice& device = virtual_devices_.emplace_back(
        all_, *kind->provides, static_cast<unsigned>(virtual_devices_.size() + 1));
    Made& made = units_.emplace_back(Made{kind, std::make_unique<std::byte[]>(kind->bytes)});
    kind->make(made.memory.get(), device, environment);
  }
  const BusSegment segment = environment.get<BusSegment>();
  take_files(bus_parts(units, segment));
  if (starts_others(units, segment)) start_ = std::make_unique<NetworkStart>(node());
}

/// A file that no unit uses is still accepted: the device offers it.
void BusDevice::take_files(std::span<const Part> parts) {
  const Dictionary& dictionary = node().dictionary();
  for (const Part& part : parts) {
    const Result<Entry> entry = dictionary.find(part.index(), 0);
    const bool is_file = entry && entry->row->type == DataType::domain;
    if (!is_file || dictionary.domain(*entry) != nullptr) continue;
    TakenFile& taken = taken_files_.emplace_back(virtual_devices_.front(), part.index());
    taken.file.shelf().on_stored = Callback<void(const Entry&)>::to<&BusDevice::file_taken>(*this);
  }
}

std::span<const std::uint8_t> BusDevice::taken_file(std::uint16_t index) {
  const auto found = std::ranges::find(taken_files_, index, &TakenFile::index);
  return found == taken_files_.end() ? std::span<const std::uint8_t>()
                                     : found->file.shelf().file(0);
}

BusDevice::~BusDevice() {
  for (auto unit = units_.rbegin(); unit != units_.rend(); ++unit) {
    unit->kind->end(unit->memory.get());
  }
}

}  // namespace canvoy::cia407
