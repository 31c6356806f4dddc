// A mapping object and its PDO: 6010h for virtual inputs, 6012h for virtual sensors. What is to be
// told next is put there when the PDO is about to leave, so that each record has a PDO of its own
// and none covers another (CiA 417-4, 4.2.3 and 4.2.5).
//
//     VirtualMapping mapping(node, tpdos, virtual_input_mapping_object.index,
//                            {.waits = ..., .next = ...});
//     mapping.announce();   // there is something: next() is asked at the right time
//
// The PDO may have any transmission type that is sent without being asked for, and any inhibit
// time. It sends while the node is operational; until then records wait at their owner.
#pragma once

#include <cstdint>

#include "canvoy/canopen/pdo/tpdo.hpp"

namespace canvoy::cia417 {

/// Who has records to tell.
struct VirtualSource {
  /// Something is to be told.
  Callback<bool()> waits;
  /// What comes next, which is told with that: it is asked only while something waits.
  Callback<std::uint64_t()> next;
};

/// Another way to the bus than a PDO that maps the object: see VirtualMpdoProducer.
struct VirtualDetour {
  Callback<bool()> is_working;
  /// Something waits: VirtualMapping::take() gives one record after the other.
  Callback<void()> announce;
};

class VirtualMapping {
 public:
  /// `index` is 6010h or 6012h. It takes Tpdos::before_transmit for itself, and calls who had it
  /// before. The node needs a backlog of two frames at least. All must outlive this.
  VirtualMapping(Node& node, Tpdos& tpdos, std::uint16_t index, const VirtualSource& source);
  VirtualMapping(const VirtualMapping&) = delete;
  VirtualMapping& operator=(const VirtualMapping&) = delete;

  /// Something waits: it is sent at once, or when inhibit time, SYNC and controller allow it. From
  /// outside of a callback, call Node::advance(now) before. Linear in the number of TPDOs.
  void announce();
  /// A PDO that carries the object works, or the detour, so that what is announced will be told.
  bool is_working();

  /// Taken while no PDO that carries the object works.
  void use(const VirtualDetour& detour) { detour_ = detour; }
  /// For the detour: false where nothing waits; else `record` is what comes next, and stands in the
  /// object.
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
