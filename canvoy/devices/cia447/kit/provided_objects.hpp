// Objects of other devices by which a device counts or records (CiA 447-3: "rw for functional
// client"): writes by SDO are accepted only from the node that the configuration names as their
// provider, on its channel of the mesh. The default channel belongs to no node: any device that is
// plugged in can use it. PDOs are not checked here: CarNetwork::source_of() has their sender.
//
//     constexpr const ObjectInfo* clock[] = {&rtc_date_object, &rtc_time_object};
//     ProvidedObjects provided(network, {.provider = 7, .objects = clock, .refused = ...});
//
// Reserved codes are also refused, with 0609 0030h (4.2).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::cia447 {

/// A refused write by a client that is not the provider.
struct RefusedWrite {
  NodeId client = 0;        ///< 0: on the default channel
  std::uint16_t index = 0;  ///< of the written entry
  std::uint8_t sub = 0;     ///< of the written entry
  std::uint32_t value = 0;  ///< its first four bytes
};

/// Construct it before the node starts. It lives as long as the node's dictionary.
class ProvidedObjects {
 public:
  /// Room for the objects of one provider.
  static constexpr std::size_t objects_max = 6;

  /// Providers and their objects.
  struct Settings {
    NodeId provider = 0;  ///< 1 to 16; 0: none, all writes are refused
    /// objects_max at most; those that the node lacks, or provides itself, are ignored.
    std::span<const ObjectInfo* const> objects = {};
    /// Called for each write that is refused with 0800 0021h because of its client. Optional.
    Callback<void(const RefusedWrite&)> refused = {};
    /// May refuse a value from the provider. Optional.
    Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)> check = {};
  };

  /// Both must outlive this.
  ProvidedObjects(CarNetwork& network, const Settings& settings);

 private:
  AbortCode asked(const Entry& entry, std::span<const std::uint8_t> value);

  CarNetwork& network_;
  Settings settings_;
  std::array<Hook, objects_max> hooks_;
};

}  // namespace canvoy::cia447
