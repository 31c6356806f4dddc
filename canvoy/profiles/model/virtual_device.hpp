// The parts of a device that is one virtual device of a profile, or several: their mandatory
// objects and the wanted optional ones, with the access of the virtual device.
//
//     constexpr auto my_indicator = describe(
//         virtual_device(cia407::profile, cia407::ticket_canceller, {0x6001, 0x6002, {0x6112, 4}}),
//         cia301::device_type(cia407::device_type(cia407::ticket_canceller)),
//         cia407::error_register_object, cia301::identity({.vendor_id = 0x123}));
//
// All work is done at compile time. A wanted object that the virtual device does not have does not
// compile.
#pragma once

#include <initializer_list>

#include "canvoy/profiles/model/device_description.hpp"

namespace canvoy {

/// A selected object of a virtual device, which may have fewer entries or bytes than allowed.
struct WantedObject {
  std::uint16_t index = 0;          ///< 0: none
  std::uint8_t highest_sub = 0xFF;  ///< no entries above this sub-index
  std::uint16_t capacity = 0;       ///< bytes of its strings; 0: as in the description

  constexpr WantedObject() = default;
  /// Selects an object, all of it unless a limit is given.
  constexpr WantedObject(std::uint16_t wanted_index,  // NOLINT(google-explicit-constructor)
                         std::uint8_t wanted_highest_sub = 0xFF, std::uint16_t wanted_capacity = 0)
      : index(wanted_index), highest_sub(wanted_highest_sub), capacity(wanted_capacity) {}
};
/// The optional objects that a device has.
using WantedObjects = std::initializer_list<WantedObject>;

namespace detail {

/// The wanted object at `index`; index 0 if there is none.
constexpr WantedObject find_wanted(const WantedObjects& wanted, unsigned index) {
  for (const WantedObject& object : wanted) {
    if (object.index == index) return object;
  }
  return {};
}

/// The last index that `object` stands for.
constexpr unsigned last_index(const DeviceObject& object) {
  return object.last == 0 ? object.index : object.last;
}

/// The object of a virtual device at an index, or null.
constexpr const DeviceObject* find_device_object(const VirtualDeviceInfo& device, unsigned index) {
  for (const DeviceObject& object : device.objects) {
    if (index >= object.index && index <= last_index(object)) return &object;
  }
  return nullptr;
}

constexpr Part part_of(const ObjectInfo& object, unsigned index, const DeviceObject& as,
                       const WantedObject& wanted) {
  Part part = object.count > 1 ? Part(object).only(index - object.index) : Part(object);
  if (as.consumed) part = part.consumed();
  if (as.access != Access::none) part = part.by_device(as.access);
  if (wanted.highest_sub != 0xFF) part = part.up_to(wanted.highest_sub);
  return wanted.capacity != 0 ? part.capacity(wanted.capacity) : part;
}

/// True if a PDO of the device maps the object by default: the object is then mandatory. Parts are
/// sorted by index: the search ends behind the last mapping.
template <std::size_t capacity>
constexpr bool is_mapped(const DeviceDescription<capacity>& parts, unsigned index) {
  for (const Part& part : parts) {
    if (part.index() > last_pdo_mapping_index) return false;
    if (maps(part.object(), index)) return true;
  }
  return false;
}

/// Of several virtual devices with one object, the one that does not only consume it counts.
template <std::size_t capacity>
constexpr void merge(DeviceDescription<capacity>& parts, const Part& part) {
  const Part* known = parts.find(part.index());
  if (known == nullptr) {
    parts.add(part);
  } else if (known->is_consumed() && !part.is_consumed()) {
    parts = parts.with(part);
  }
}

/// The object at `index`, if the profile describes it.
template <std::size_t capacity>
constexpr void add_device_object(DeviceDescription<capacity>& parts, const Profile& profile,
                                 unsigned index, const DeviceObject& as,
                                 const WantedObject& wanted) {
  const ObjectInfo* object = find_object(profile, index);
  if (object != nullptr) merge(parts, part_of(*object, index, as, wanted));
}

}  // namespace detail

/// Adds a virtual device to `parts`, and the objects of it that the PDOs among them map. An object
/// that several virtual devices have takes the form of the one that provides it.
template <std::size_t capacity>
constexpr void add_virtual_device(DeviceDescription<capacity>& parts, const Profile& profile,
                                  const VirtualDeviceInfo& device,
                                  const WantedObjects& wanted = {}) {
  for (const WantedObject& object : wanted) {
    if (detail::find_device_object(device, object.index) == nullptr) {
      detail::description_is_wrong("the virtual device does not have a wanted object");
    }
  }
  for (const DeviceObject& as : device.objects) {
    for (unsigned index = as.index; index <= detail::last_index(as); ++index) {
      const WantedObject wish = detail::find_wanted(wanted, index);
      const bool is_there = wish.index == index || as.category == Category::mandatory ||
                            detail::is_mapped(parts, index);
      if (is_there) detail::add_device_object(parts, profile, index, as, wish);
    }
  }
}

/// Adds one object that a virtual device may have.
template <std::size_t capacity>
constexpr void add_wanted_object(DeviceDescription<capacity>& parts, const Profile& profile,
                                 const VirtualDeviceInfo& device, const WantedObject& wanted) {
  const DeviceObject* as = detail::find_device_object(device, wanted.index);
  if (as == nullptr) {
    detail::description_is_wrong("the virtual device does not have a wanted object");
  }
  detail::add_device_object(parts, profile, wanted.index, *as, wanted);
}

/// Adds all objects that a virtual device may have, mandatory or not.
template <std::size_t capacity>
constexpr void add_device_object(DeviceDescription<capacity>& parts, const Profile& profile,
                                 const DeviceObject& as) {
  for (unsigned index = as.index; index <= detail::last_index(as); ++index) {
    detail::add_device_object(parts, profile, index, as, {});
  }
}

/// The parts of a device that is this virtual device.
template <std::size_t capacity = 96>
constexpr DeviceDescription<capacity> virtual_device(const Profile& profile,
                                                     const VirtualDeviceInfo& device,
                                                     const WantedObjects& wanted = {}) {
  DeviceDescription<capacity> parts;
  parts.add(profile);
  add_virtual_device(parts, profile, device, wanted);
  return parts;
}

}  // namespace canvoy
