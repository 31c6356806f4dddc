// The parts of a physical device that consists of one or several virtual devices, of one lift or
// several (CiA 417-4, 4.2.1, 4.2.2 and 4.1.1).
//
//     constexpr auto my_controller = describe(
//         physical_device<PhysicalOptions{.lifts = lift_bit(2)}, VirtualDevice::call_controller,
//                         VirtualDevice::car_door_controller>({0x6010, 0x6011, 0x6300}),
//         cia301::identity({.vendor_id = 0x123}));
//
// 1000h names the virtual device, or says that there are several, which 6000h then lists. All
// objects of a lift are 0800h above those of the one before. Pre-defined PDOs are those of all
// virtual devices and lifts for which the mapped objects exist.
#pragma once

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/profiles/cia417/lift_device.hpp"

namespace canvoy::cia417 {

/// What a physical device of several virtual devices has room for.
struct PhysicalOptions {
  unsigned lifts = 0b1;          ///< bit 0 is lift 1: the default of 6001h
  unsigned doors = 0b1111;       ///< doors that it moves or watches: bit 0 is door 1
  std::size_t parts = 128;       ///< maximum number of objects
  bool creates_objects = false;  ///< it has 6020h
};

/// True if a mask of lifts has lift 1 to 8.
constexpr bool has_lift(unsigned lifts, unsigned lift) {
  return (lifts >> (lift - 1) & 1) != 0;
}

/// Adds a virtual device with those of the wanted objects that it has.
template <VirtualDevice device, std::size_t capacity>
constexpr void add_with_wanted(DeviceDescription<capacity>& own, const WantedObjects& wanted) {
  add_virtual_device(own, profile, info_of(device));
  for (const WantedObject& object : wanted) {
    if (canvoy::detail::find_device_object(info_of(device), object.index) == nullptr) continue;
    add_wanted_object(own, profile, info_of(device), object);
  }
}

/// Adds the objects of `own`, given for lift 1, once for each of the lifts.
template <std::size_t capacity>
constexpr void add_in_lifts(DeviceDescription<capacity>& parts,
                            const DeviceDescription<capacity>& own, unsigned lifts) {
  for (const Part& part : own) {
    if (part.index() == lift_number_object.index) {
      parts.add(part.initial(lifts));
    } else if (!is_of_lift(part.index())) {
      parts.add(part);
    } else {
      for (unsigned lift = 1; lift <= lift_count; ++lift) {
        if (has_lift(lifts, lift)) parts.add(part.moved((lift - 1) * block_pitch));
      }
    }
  }
}

/// True if the PDO belongs to these virtual devices, in one of the lifts.
template <PhysicalOptions options, VirtualDevice... devices>
constexpr bool is_pdo_of_physical(const PdoInfo& pdo) {
  return []<std::size_t... lift>(const PdoInfo& of, std::index_sequence<lift...>) {
    const auto in = [&of]<unsigned number>() {
      constexpr LiftDeviceOptions each{.lift = number, .doors = options.doors};
      return has_lift(options.lifts, number) && (is_pdo_of<devices, each>(of) || ...);
    };
    return (in.template operator()<lift + 1>() || ...);
  }(pdo, std::make_index_sequence<lift_count>{});
}

/// Adds the pre-defined PDOs of virtual devices for each lift.
template <PhysicalOptions options, VirtualDevice... devices, std::size_t capacity>
constexpr void add_physical_pdos(DeviceDescription<capacity>& parts) {
  constexpr auto is_mine = [](const PdoInfo& pdo) {
    return is_pdo_of_physical<options, devices...>(pdo);
  };
  const auto candidates = predefined_pdos<profile, is_mine>();
  for (const PdoInfo& pdo : profile.pdos) {
    if (!is_mine(pdo) || !has_mapped(parts, pdo)) continue;
    const bool sends = pdo.direction == PdoInfo::Direction::transmit;
    const unsigned parameter = (sends ? 0x1800U : 0x1400U) + pdo.number - 1;
    parts.add_pdo(*candidates.find(parameter), *candidates.find(parameter + 0x200));
  }
}

/// 6000h of a device that consists of all of these.
template <VirtualDevice... devices>
class DeviceTypes {
  static constexpr std::size_t count = sizeof...(devices);
  static constexpr auto entries = [] {
    constexpr VirtualDevice all[] = {devices...};
    std::array<EntryInfo, count + 1> made{};
    made[0] = count_entry("Number of supported virtual devices", count, count, count);
    for (std::size_t i = 0; i < count; ++i) {
      made[i + 1] = at(static_cast<std::uint8_t>(i + 1), virtual_device_type);
      // The high word of 1000h of each device alone.
      made[i + 1].initial = device_type(all[i]) >> 16;
    }
    return made;
  }();
  static constexpr ObjectInfo with_entries(ObjectInfo made) {
    made.subs = entries;
    return made;
  }

 public:
  /// 6000h, with the types of these devices.
  static constexpr ObjectInfo object = with_entries(supported_virtual_device_types_object);
};

/// 1000h, and 6000h if there are several.
template <VirtualDevice... devices, std::size_t capacity>
constexpr void add_device_types(DeviceDescription<capacity>& parts) {
  constexpr VirtualDevice all[] = {devices...};
  constexpr bool is_one = sizeof...(devices) == 1;
  parts.add(cia301::device_type(device_type(is_one ? all[0] : VirtualDevice::several)));
  if constexpr (!is_one) parts.add(DeviceTypes<devices...>::object);
}

/// `wanted` are the optional objects of part 4, by their indices in lift 1; each virtual device
/// takes those that it can have.
template <PhysicalOptions options, VirtualDevice... devices>
constexpr auto physical_device(const WantedObjects& wanted) {
  static_assert(options.lifts != 0 && options.lifts <= 0xFF, "there are 8 lifts");
  static_assert(sizeof...(devices) != 0, "a device of nothing");
  DeviceDescription<options.parts> own;
  (add_with_wanted<devices>(own, wanted), ...);
  for (const WantedObject& object : wanted) {
    if (own.find(object.index) == nullptr) {
      canvoy::detail::description_is_wrong("no virtual device has a wanted object");
    }
  }
  DeviceDescription<options.parts> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  add_device_types<devices...>(parts);
  parts.add(cia301::error_register_object);
  if (options.creates_objects) parts.add(object_creation_object);
  add_in_lifts(parts, own, options.lifts);
  add_physical_pdos<options, devices...>(parts);
  return parts;
}

}  // namespace canvoy::cia417
