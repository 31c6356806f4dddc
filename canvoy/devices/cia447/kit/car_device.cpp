#include "canvoy/devices/cia447/kit/car_device.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia447/device.hpp"

namespace canvoy::cia447 {

namespace {

constexpr std::uint8_t errors_kept = 8;

template <PdoInfo::Direction direction>
constexpr auto possible_pdos = predefined_pdos<profile, [](const PdoInfo& pdo) {
  return pdo.direction == direction && can_be_mapped(pdo);
}>();
constexpr auto basics =
    describe(cia301::error_register_object, cia301::emergency(), cia301::error_history(errors_kept),
             Part(cia301::sdo_server_object).only(0, node_id_max),
             Part(cia301::sdo_client_object).only(0, node_id_max));

class PartList {
 public:
  void add(const Part& part) {
    if (find(part.index()) == nullptr) parts_.push_back(part);
  }
  template <class Parts>
  void add_all(const Parts& parts) {
    for (const Part& part : parts) add(part);
  }
  /// PDOs of which all objects exist, and are this device's own or another's.
  template <PdoInfo::Direction direction>
  void add_pdos() {
    constexpr bool sends = direction == PdoInfo::Direction::transmit;
    for (const PdoInfo& pdo : pdos) {
      if (pdo.direction != direction || !can_be_mapped(pdo)) continue;
      const bool is_wanted = std::ranges::all_of(pdo.mapping, [this](std::uint32_t raw) {
        const Part* part = find(MappingValue(raw).index);
        return part != nullptr && part->is_consumed() != sends;
      });
      if (!is_wanted) continue;
      const unsigned parameter = (sends ? 0x1800U : 0x1400U) + pdo.number - 1;
      add(*possible_pdos<direction>.find(parameter));
      add(*possible_pdos<direction>.find(parameter + 0x200));
    }
  }
  bool has_pdos() const {
    return std::ranges::any_of(parts_, [](const Part& part) {
      return part.index() >= object_index::rpdo_parameter &&
             part.index() <= object_index::tpdo_mapping_last;
    });
  }
  const Part* find(unsigned index) const {
    const auto is_it = [index](const Part& part) {
      return index >= part.index() && index - part.index() < part.count();
    };
    const auto found = std::ranges::find_if(parts_, is_it);
    return found == parts_.end() ? nullptr : &*found;
  }
  std::vector<Part> sorted() && {
    std::ranges::sort(parts_, {}, &Part::index);
    return std::move(parts_);
  }

 private:
  std::vector<Part> parts_;
};

/// A code that an object of the profile does not have is reserved according to CiA 447-3, whether
/// it is too high or too low: it is refused like any other one (4.2).
AbortCode check_code(const DictionaryTables& tables, const EntryShape& row,
                     const std::uint8_t* value) {
  constexpr unsigned first_of_profile = 0x6000;
  const AbortCode answer = check_number(tables, row, value);
  if (answer != AbortCode::value_too_low && answer != AbortCode::value_too_high) return answer;
  const auto object =
      std::ranges::lower_bound(tables.objects, first_of_profile, {}, &ObjectRow::index);
  const bool is_of_profile = object != tables.objects.end() &&
                             &row - tables.entries.data() >= std::ptrdiff_t{object->entry_first};
  return is_of_profile ? AbortCode::value_range : answer;
}

DictionaryTables with_codes(DictionaryTables tables) {
  tables.check_number = &check_code;
  return tables;
}

}  // namespace

std::vector<Part> car_parts(std::span<const CarUnit* const> units, Duration heartbeat) {
  PartList parts;
  const DeviceInfo& first = units.front()->info;
  parts.add(cia301::device_type(device_type));
  parts.add(cia301::identity({.product_code = first.product_code}));
  parts.add_all(cia301::names(
      {.device = first.product, .hardware_version = "simulated", .software_version = "0.1.0"}));
  parts.add_all(basics);
  parts.add(cia301::heartbeat_producer(static_cast<std::uint16_t>(heartbeat / 1ms)));
  for (const CarUnit* unit : units) {
    for (const DeviceObject& object : unit->provides->objects) {
      parts.add(Part(*find_object(profile, object.index)));
    }
    for (const ObjectInfo* object : unit->own) parts.add(Part(*object));
  }
  for (const CarUnit* unit : units) {
    for (const ObjectInfo* object : unit->consumes) parts.add(Part(*object).consumed());
  }
  parts.add_pdos<PdoInfo::Direction::transmit>();
  parts.add_pdos<PdoInfo::Direction::receive>();
  if (parts.has_pdos()) parts.add(cia301::sync_consumer());
  return std::move(parts).sorted();
}

CarDevice::CarDevice(std::span<const CarUnit* const> units, const Port& port, NodeId node_id,
                     const Environment& environment)
    : port_(port),
      tables_(car_parts(units, environment.get<CarNetworkSettings>().heartbeat)),
      device_(with_codes(tables_.tables()), port_.port(), node_id,
              CarNetwork::routes + CarSleep::routes + CarMaster::routes + catalogue_routes),
      network_(device_.node(), environment.get<CarNetworkSettings>()),
      sleep_(network_, port_, environment.get<CarSleepSettings>()) {
  const bool is_gateway = std::ranges::any_of(
      units, [](const CarUnit* unit) { return unit->provides == &ivn_gateway_device; });
  if (is_gateway && environment.manages_network) {
    master_.emplace(network_, sleep_, environment.get<CarMemory>(),
                    environment.get<CarMasterSettings>());
    environment.made<CarMaster>(*master_, device_.node());
  }
  environment.made<CarNetwork>(network_, device_.node());
  for (const CarUnit* kind : units) units_.make(*kind, network_, environment);
}

}  // namespace canvoy::cia447
