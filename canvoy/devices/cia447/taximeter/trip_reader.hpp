// Reads the trip of a taximeter (60D0h to 60D4h; CiA 447-3, 4.2.12.1 to 4.2.12.5) over the mesh,
// with all values of one moment: the sequence counter (60DBh, 4.2.12.9) is the same before and
// after.
//
//     TripReader reader(network, 2, Callback<void(const TripData*)>::to<&Radio::trip_came>(*this));
//     reader.read();   // trip_came() is called when all is there
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"

namespace canvoy::cia447 {

class TripReader {
 public:
  /// Null: the meter does not answer, or its trip changes faster than it can be read. Values that a
  /// meter lacks are unknown.
  using Done = Callback<void(const TripData* trip)>;

  /// `meter` is the node-ID of another node. `network` must outlive this.
  TripReader(CarNetwork& network, NodeId meter, Done done);

  /// No effect while a request is under way.
  void read();
  /// True while a trip is being read.
  bool is_reading() const { return client_.busy(); }

 private:
  static constexpr unsigned attempts_max = 5;

  void ask();
  void answered(SdoClient::Outcome outcome);
  void take(std::size_t length);
  bool is_last() const;

  SdoClient client_;
  NodeId meter_;
  Done done_;
  TripData data_;
  /// Position in the list of requests: 0 and the last are the sequence counter.
  std::size_t position_ = 0;
  unsigned attempts_ = 0;
  std::uint32_t sequence_ = 0;
  std::array<std::uint8_t, 4> value_{};
};

}  // namespace canvoy::cia447
