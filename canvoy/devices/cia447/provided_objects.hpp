// Objects of others by which a device counts or records (CiA 447-3: "rw for functional client"):
// what an SDO client writes is taken from the node alone that the configuration names as their
// provider, on its channel of the mesh. The default channel is nobody's: whoever is plugged in can
// ask on it. PDOs are not looked at here: who sends them CarNetwork::source_of() says.
//
//     constexpr const ObjectInfo* clock[] = {&rtc_date_object, &rtc_time_object};
//     ProvidedObjects provided(network, {.provider = 7, .objects = clock, .refused = ...});
//
// Reserved codes are refused too, with 0609 0030h (4.2).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::cia447 {

/// What somebody wanted to write who is not the provider.
struct RefusedWrite {
  NodeId client = 0;        ///< 0: by the default channel
  std::uint16_t index = 0;  ///< of what he wanted to write
  std::uint8_t sub = 0;     ///< the same
  std::uint32_t value = 0;  ///< its first four bytes
};

/// It has to be made before the node starts, and lives as long as the node's dictionary.
class ProvidedObjects {
 public:
  /// Room for the objects of one provider.
  static constexpr std::size_t objects_max = 6;

  /// Who provides what.
  struct Settings {
    NodeId provider = 0;  ///< 1 to 16; 0: nobody, all are refused
    /// objects_max at most; those that the node lacks, or provides itself, are left alone.
    std::span<const ObjectInfo* const> objects = {};
    /// Called for each write that is refused with 0800 0021h because of who writes. Optional.
    Callback<void(const RefusedWrite&)> refused = {};
    /// May refuse what the provider writes. Optional.
    Callback<AbortCode(const Entry&, std::span<const std::uint8_t>)> check = {};
  };

  /// Both must outlive this.
  ProvidedObjects(CarNetwork& network, const Settings& settings);
  ProvidedObjects(const ProvidedObjects&) = delete;
  ProvidedObjects& operator=(const ProvidedObjects&) = delete;

 private:
  AbortCode asked(const Entry& entry, std::span<const std::uint8_t> value);

  CarNetwork& network_;
  Settings settings_;
  std::array<Hook, objects_max> hooks_;
};

}  // namespace canvoy::cia447
