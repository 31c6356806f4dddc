// Objects of a taximeter that other devices read: trip, totals, configuration and state (60D0h to
// 60DBh; CiA 447-3, 4.2.12).
//
//     TaximeterObjects objects(node);
//     objects.report_trip(data, false);     // 60DBh counts where something of it is new
#pragma once

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_record.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_settings.hpp"
#include "canvoy/devices/cia447/taximeter/trip_data.hpp"
#include "canvoy/profiles/model/handle.hpp"

namespace canvoy::cia447 {

class TaximeterObjects {
 public:
  /// Makes the objects of a node, which must outlive this.
  explicit TaximeterObjects(Node& node) : node_(node) {}
  TaximeterObjects(const TaximeterObjects&) = delete;
  TaximeterObjects& operator=(const TaximeterObjects&) = delete;

  /// Writes the trip. Without a change, only if `is_all`.
  void report_trip(const TripData& data, bool is_all);
  /// Writes the state of the taximeter.
  void report_state(Taximeter state, bool is_turning_off);
  /// Writes the totals, 60D9h.
  void report_totals(const TaximeterRecord& record);
  /// Writes the configuration, 60DAh.
  void report_configuration(const TaximeterRecord& record, const TaximeterSettings& settings);

 private:
  template <class Handle>
  auto value(const Handle& handle) const {
    return Values(node_.dictionary())[handle];
  }

  Node& node_;
  TripData told_;
  std::uint8_t sequence_ = 0;
};

}  // namespace canvoy::cia447
