// Reads objects of another node by SDO, periodically, into this node's own entries: for objects
// that a virtual device consumes and that no PDO carries (CiA 447-3: "rw for functional client").
//
//     constexpr std::uint16_t indices[] = {0x6054, 0x6056};
//     ObjectReader reader(network, {.server = 1, .indices = indices, .period = 10s,
//                                   .came =
//                                   Callback<void(std::uint16_t)>::to<&Meter::came>(*this)});
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"

namespace canvoy::cia447 {

class ObjectReader {
 public:
  /// The other node, and period.
  struct Settings {
    NodeId server = 0;  ///< 1 to 16; 0: none is read
    /// Variables, in the order of reading. They must outlive the reader. Those that this node
    /// lacks, or provides itself, are left out.
    std::span<const std::uint16_t> indices = {};
    Duration period = 10s;  ///< of the rounds over all objects
    /// Called when a value has been written to its entry.
    Callback<void(std::uint16_t index)> came = {};
  };

  /// Makes a reader; `network` must outlive it.
  ObjectReader(CarNetwork& network, const Settings& settings);

 private:
  /// From a reset to the first request: other nodes boot, too.
  static constexpr Duration first_request = 500ms;

  void reset(ResetScope scope);
  void begin(Time now);
  void ask();
  void answered(SdoClient::Outcome outcome);

  CarNetwork& network_;
  Settings settings_;
  SdoClient client_;
  std::size_t position_ = 0;
  std::array<std::uint8_t, 8> value_{};
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
