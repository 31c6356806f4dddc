// A mapping object and its PDO: 6010h for virtual inputs, 6012h for virtual sensors. The next
// record is written to the object just before the PDO is sent, so that each record has a separate
// PDO and none replaces another (CiA 417-4, 4.2.3 and 4.2.5).
//
//     VirtualMapping mapping(node, tpdos, virtual_input_mapping_object.index,
//                            {.waits = ..., .next = ...});
//     mapping.announce();   // there is something: next() is asked at the right time
//
// The PDO may have any transmission type that is not on request only, and any inhibit time. It is
// sent while the node is operational; until then, records wait at their owner.
#pragma once

#include <cstdint>

#include "canvoy/canopen/pdo/tpdo.hpp"

namespace canvoy::cia417 {

/// An owner of records to send.
struct VirtualSource {
  /// True if a record is waiting.
  Callback<bool()> waits;
  /// Returns the next record, and marks it as sent. Called only while one is waiting.
  Callback<std::uint64_t()> next;
};

/// An access to the bus other than a PDO that maps the object: see VirtualMpdoProducer.
struct VirtualDetour {
  Callback<bool()> is_working;  ///< false: the PDO is used
  /// Called when a record is waiting: VirtualMapping::take() returns one record after the other.
  Callback<void()> announce;
};

class VirtualMapping {
 public:
  /// `index` is 6010h or 6012h. It sets Tpdos::before_transmit, and calls the former callback. The
  /// node needs a backlog of at least two frames. All arguments must outlive this.
  VirtualMapping(Node& node, Tpdos& tpdos, std::uint16_t index, const VirtualSource& source);

  /// Reports a waiting record: it is sent at once, or when inhibit time, SYNC and controller allow
  /// it. From outside of a callback, call Node::advance(now) before. Linear in the number of TPDOs.
  void announce();
  /// True if a PDO that carries the object, or the detour, is working, so that waiting records will
  /// be sent.
  bool is_working();

  /// Used while no PDO that carries the object is working.
  void use(const VirtualDetour& detour) { detour_ = detour; }
  /// For the detour: false if no record is waiting; otherwise `record` is the next one, also stored
  /// in the object.
  bool take(std::uint64_t& record);

 private:
  void before_transmit(std::uint16_t number);
  void go_on(Time now);
  bool carries(std::uint16_t number) const;
  std::uint16_t find_pdo();

  Node& node_;
  Tpdos& tpdos_;
  VirtualSource source_;
  VirtualDetour detour_;
  Callback<void(std::uint16_t)> former_;
  Timer timer_;
  std::uint16_t index_;
};

}  // namespace canvoy::cia417
