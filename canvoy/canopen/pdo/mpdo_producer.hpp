// Producer of multiplexed PDOs (CiA 301, 7.2.3, and the object scanner lists 1FA0h to 1FCFh).
//
//     ScannedObject scanned[16];
//     MpdoProducer::Message queue[4];
//     MpdoProducer mpdo_producer(node, tpdos, scanned, queue);
//     // 1A01h:00h = FEh: the second TPDO sends what 1FA0h:01h and up list when it changes
//     // 1A02h:00h = FFh: the third sends what the application asks for
//     mpdo_producer.send(3, 10, 0x6000, 1, bytes);
#pragma once

#include "canvoy/canopen/pdo/mpdo.hpp"
#include "canvoy/canopen/pdo/tpdo.hpp"

namespace canvoy {

/// One object of the scanner lists. The owner of MpdoProducer provides the memory.
struct ScannedObject {
  std::uint16_t index = 0;                            ///< in the dictionary of the producer
  std::uint8_t sub = 0;                               ///< sub-index
  bool waits = false;                                 ///< must be sent
  std::array<std::uint8_t, mpdo_data_max> sent = {};  ///< the last value sent
};

/// Adds the two modes of multiplexed PDOs to TPDOs. Inhibit time, event timer and the start in NMT
/// state operational are those of the TPDO; its remote frames are not answered. A frame that must
/// wait is sent later, and none is skipped.
///
/// SAM: one TPDO of a node can have this mode. Objects of the scanner lists are sent when they have
/// changed; Tpdos::trigger() and the event timer send all of them, one frame after the other in the
/// order of the lists, so that no object delays another forever. The lists start at 1FA0h and have
/// no gaps. An entry is refused if its first object cannot be mapped into a TPDO or has more than
/// four bytes; further objects of its block that cannot are skipped. A list may change at any time;
/// frames that wait are then discarded. Linear in the number of objects for each change of one.
///
/// DAM: sends the values that the application passes to send().
class MpdoProducer {
 public:
  /// A waiting DAM frame.
  struct Message {
    std::uint16_t number = 0;  ///< of the TPDO
    Mpdo mpdo;                 ///< what it carries
  };

  /// Makes the producer. `scanned` has room for the objects of all scanner lists: entries that need
  /// more are refused with out_of_memory. `queue` has room for waiting DAM frames. All arguments
  /// must outlive it.
  MpdoProducer(Node& node, Tpdos& tpdos, std::span<ScannedObject> scanned,
               std::span<Message> queue);
  MpdoProducer(const MpdoProducer&) = delete;
  MpdoProducer& operator=(const MpdoProducer&) = delete;

  /// Sends a value of at most four bytes to an object of node `consumer`, or of all nodes (0), by
  /// TPDO `number`: at once, or when its inhibit time is over or the controller has room. False if
  /// this is not an active DAM TPDO, the value is too long, or the queue is full. Outside of a
  /// callback, call Node::advance(now) before.
  bool send(std::uint16_t number, NodeId consumer, std::uint16_t index, std::uint8_t sub,
            std::span<const std::uint8_t> value);

 private:
  using Value = std::array<std::uint8_t, mpdo_data_max>;
  /// A pending change of an entry in a scanner list; by default of none.
  struct Change {
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    std::uint32_t value = 0;
  };

  AbortCode before_list_write(const Entry& entry, std::span<const std::uint8_t> value);
  AbortCode before_parameter_write(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  void load();
  std::size_t scan(std::span<ScannedObject> objects, const Change& change) const;
  void append(const ScannerEntry& entry, std::span<ScannedObject> objects,
              std::size_t& count) const;

  void event(std::uint16_t number, MpdoMode mode, MpdoEvent event);
  void transmit(std::uint16_t number, MpdoMode mode);
  bool next(std::uint16_t number, MpdoMode mode, PdoImage& image);
  bool next_scanned(PdoImage& image);
  void sent(std::uint16_t number, MpdoMode mode);
  void watch(MpdoMode mode, std::uint32_t watchers);
  std::span<Message>::iterator first_of(std::uint16_t number);
  void forget(std::uint16_t number);
  Value value_of(const ScannedObject& object) const;

  Node& node_;
  Tpdos& tpdos_;
  std::span<ScannedObject> scanned_;
  std::span<Message> queue_;
  std::size_t count_ = 0;   ///< of scanned objects
  std::size_t next_ = 0;    ///< next scanned object in turn
  std::size_t queued_ = 0;  ///< waiting messages
  static const AccessHandlers hook_calls[2];
  static const ServiceHandlers service_calls;
  static const MpdoCalls mpdo_calls;
  MpdoSource source_{&mpdo_calls, this};
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy
