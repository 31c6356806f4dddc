// What a device takes from a PDO of another one, until that one falls silent: then nobody knows.
//
//     CarSource ignition(network, 1, Callback<void()>::to<&Supply::ignition_lost>(supply));
//     void Supply::written(const Entry&, Source source) { ignition.came(source); ... }
#pragma once

#include <optional>

#include "canvoy/devices/cia447/car_network.hpp"

namespace canvoy::cia447 {

/// What stays behind of the old value is up to who is called: `lost` clears it.
class CarSource {
 public:
  CarSource(CarNetwork& network, unsigned pdo_number, Callback<void()> lost)
      : network_(network), pdo_number_(pdo_number), lost_(lost) {
    next_ = network.on_lost(Callback<void(NodeId)>::to<&CarSource::node_lost>(*this));
  }
  CarSource(const CarSource&) = delete;
  CarSource& operator=(const CarSource&) = delete;

  /// Something of the PDO was written. What comes by SDO has no source that is watched.
  void came(Source source) {
    if (source != Source::pdo) return;
    came_from(network_.source_of(pdo_number_));
  }
  /// This node was asked for it.
  void came_from(NodeId source) {
    source_ = source;
    network_.watch(source_);
  }

 private:
  void node_lost(NodeId node) {
    if (next_) next_(node);
    if (node != source_) return;
    source_ = 0;
    lost_();
  }

  CarNetwork& network_;
  unsigned pdo_number_;
  Callback<void()> lost_;
  Callback<void(NodeId)> next_;
  NodeId source_ = 0;
};

}  // namespace canvoy::cia447
