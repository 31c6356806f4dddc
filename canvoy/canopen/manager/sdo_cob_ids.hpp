// The COB-IDs that an SDO manager can assign to SDO connections (CiA 302-5, 1F02h).
//
//     SdoCobIds cob_ids(dictionary, connections);
//     std::uint16_t request = cob_ids.free_can_id();
//     std::uint16_t response = cob_ids.free_can_id(request);
#pragma once

#include <cstdint>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/manager/sdo_connections.hpp"

namespace canvoy {

class SdoCobIds {
 public:
  /// Makes the object; both arguments must outlive it.
  SdoCobIds(const Dictionary& dictionary, const SdoConnections& connections)
      : dictionary_(dictionary), connections_(connections) {}

  /// Checks a new value of an entry. Aborts: device_state (the old one is assigned: it stays until
  /// it is returned), value_range (restricted, or of 29 bits), parameter_incompatible (another
  /// entry has it).
  AbortCode check(const Entry& entry, std::uint32_t value) const;
  /// A CAN-ID that no connection has, other than `taken`; 0 if there is none.
  std::uint16_t free_can_id(std::uint16_t taken = 0) const;

 private:
  unsigned count() const;
  CobId at(unsigned sub) const;

  const Dictionary& dictionary_;
  const SdoConnections& connections_;
};

}  // namespace canvoy
