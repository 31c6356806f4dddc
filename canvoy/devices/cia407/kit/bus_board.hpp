// A device of CiA 407 for a board: one virtual device, with the objects that it has in the
// catalogue (BusDevice), in memory that is known when the program is compiled.
//
//     Device<BusBoard<TicketCancellerKind>> canceller(port, 7, hardware);
//     canceller.node().start(now);
//     canceller.unit().unit();  // the TicketCancellerUnit
//
// Files that the unit does not use (6720h, 6741h) are not taken: 0601 0000h.
#pragma once

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/kit/device.hpp"

namespace canvoy::cia407 {

/// The segment of most networks.
inline constexpr BusSegment usual_segment{};

namespace composing::detail {

template <class Kind, const BusSegment& segment>
constexpr PartArray make_parts() {
  return BusParts<PartArray>(only_bus_unit<Kind>, segment).make();
}

/// A unit with its virtual device, which is the only one of its node.
template <class Kind>
class OnlyUnit {
 public:
  /// Makes both; the node, and everything to which `hardware` refers, must outlive this.
  OnlyUnit(Node& node, const typename Kind::Hardware& hardware,
           const typename Kind::Settings& settings)
      : all_(node), device_(all_, Kind::provides, 1), unit_(device_, hardware, settings) {}
  OnlyUnit(const OnlyUnit&) = delete;
  OnlyUnit& operator=(const OnlyUnit&) = delete;

  /// Behaviour of the virtual device.
  typename Kind::Unit& unit() { return unit_; }
  /// Its part of the physical device.
  VirtualDevice& virtual_device() { return device_; }

 private:
  VirtualDevices all_;
  VirtualDevice device_;
  typename Kind::Unit unit_;
};

}  // namespace composing::detail

/// `Kind` is that of a virtual device (BusKind).
template <class Kind, const BusSegment& segment = usual_segment>
struct BusBoard
    : KindOf<composing::detail::OnlyUnit<Kind>, typename Kind::Hardware, typename Kind::Settings> {
  static constexpr DeviceInfo info = Kind::info;  ///< as in the catalogue
  /// As bus_parts() has them.
  static constexpr auto description =
      describe_parts<composing::detail::make_parts<Kind, segment>>();
  static constexpr std::size_t routes = Kind::routes;  ///< CAN-IDs that the unit itself receives
};

}  // namespace canvoy::cia407
