// The COB-IDs that an SDO manager has to give to SDO connections (1F02h of CiA 302-5).
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
  /// Both must outlive this.
  SdoCobIds(const Dictionary& dictionary, const SdoConnections& connections)
      : dictionary_(dictionary), connections_(connections) {}

  /// A new value of one of its entries. Aborts: device_state (it is given: it stays as it is until
  /// it comes back), value_range (restricted, or of 29 bits), parameter_incompatible (it is there
  /// already).
  AbortCode check(const Entry& entry, std::uint32_t value) const;
  /// One that no connection has, other than `taken`; 0 where there is none.
  std::uint16_t free_can_id(std::uint16_t taken = 0) const;

 private:
  unsigned count() const;
  CobId at(unsigned sub) const;

  const Dictionary& dictionary_;
  const SdoConnections& connections_;
};

}  // namespace canvoy
