// A passive listener that turns the CANopen traffic of one bus into objects with their values. It
// contains the profiles, and learns from the traffic which profile each node has and what its PDOs
// carry.
//
//     Decoder decoder;
//     const Decoded& decoded = decoder.decode(frame);
//     for (const DecodedValue& value : decoded.values) show(value.object->name, value.bytes());
//
// Memory is bounded for any input: a few hundred bytes for each node, PDO and SDO channel, and 4
// KiB for the active transfer of a channel. A silent bus takes about 20 KiB; from its first object
// on, another 8 KiB for descriptions of entries.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/decoder/entry_cache.hpp"
#include "canvoy/decoder/lss_follower.hpp"
#include "canvoy/decoder/mark.hpp"
#include "canvoy/decoder/network.hpp"
#include "canvoy/decoder/sdo_follower.hpp"

namespace canvoy::decoder {

/// The value of one object in a frame, or in a transfer.
struct DecodedValue {
  std::uint16_t index = 0;             ///< of the object, in the node's dictionary
  std::uint8_t sub = 0;                ///< sub-index
  const Profile* profile = nullptr;    ///< of the node; CiA 301 if nothing else is known
  const ObjectInfo* object = nullptr;  ///< null: the index is not in the profile
  /// Includes the unit that the node has reported; null: the sub-index is not in the profile.
  const EntryInfo* entry = nullptr;
  bool is_told = false;  ///< `entry` is a copy that lives as long as the network
  std::array<std::uint8_t, Frame::length_max> mapped{};  ///< of a PDO
  std::span<const std::uint8_t> transferred = {};        ///< of an SDO transfer
  std::uint8_t size = 0;                                 ///< bytes used of `mapped`
  Marks marks = {};                                      ///< violations in this value
  /// For a PDO: changes whenever the bytes differ from the previous ones with this CAN-ID.
  std::uint64_t version = 0;

  /// The value as on the wire: of the PDO or of the transfer.
  std::span<const std::uint8_t> bytes() const {
    return transferred.data() != nullptr ? transferred : std::span(mapped).first(size);
  }
};

/// The objects in one frame. Valid until the next frame.
struct Decoded {
  /// What the frame belongs to; other: NMT, SYNC, TIME, EMCY, error control, LSS or none of
  /// CANopen.
  enum class Service : std::uint8_t { other, pdo, sdo_request, sdo_response };
  Service service = Service::other;  ///< which of the members below count
  NodeId node = 0;                   ///< of SDO, the server; 0: none, or unknown
  NodeId client = 0;                 ///< of SDO, if the client is known
  std::uint16_t channel = 0;         ///< of SDO: the CAN-ID of the requests
  const PdoPlan* pdo = nullptr;      ///< null: the content is unknown
  bool is_same = false;  ///< of a PDO: values and marks are those of the last one with its CAN-ID
  SdoMessage message = SdoMessage::unknown;  ///< of SDO messages with eight bytes
  SdoBehind behind{};                        ///< the peer of the transfer, if other than the server
  const SdoTransfer* transfer = nullptr;     ///< the transfer that this frame ends
  const DecodedValue* about = nullptr;       ///< of SDO: the entry, without a value, if known
  const LssFollower::Device* device = nullptr;  ///< the device that LSS has reported on
  const NodeNews* news = nullptr;               ///< what this frame reveals about a node
  std::span<const DecodedValue> values = {};    ///< in the order of the frame; empty: none is known
  Marks marks = {};                             ///< of the frame and of all values
};

class Decoder {
 public:
  /// What is known of the bus, to add data sheets and profiles before the first frame.
  Network& network() { return network_; }
  /// What is known of the bus.
  const Network& network() const { return network_; }

  /// Takes the next frame of the bus and tells what it says. Constant for most frames; linear in
  /// the mapped values of a PDO.
  const Decoded& decode(const Frame& frame);

 private:
  /// An entry, or a dummy, that a PDO carries.
  struct Slot {
    unsigned first = 0;  ///< its first bit
    unsigned end = 0;
    std::uint64_t mask = 0;
    std::uint64_t raw = 0;  ///< in the last PDO
    bool is_heard = false;
    bool is_value = false;  ///< the next element of `values`; else a dummy
  };
  /// Last content of the PDO with a CAN-ID: most values on a bus do not change.
  struct Image {
    std::uint32_t generation = 0;  ///< of the network, at creation; 0: never created
    std::vector<Slot> slots;
    std::vector<DecodedValue> values;
    unsigned bits = 0;
    bool is_heard = false;    ///< the next ones are those of the last PDO
    std::uint8_t length = 0;  ///< in bytes
    std::uint64_t whole = 0;  ///< all bytes
    std::size_t count = 0;    ///< number of values
    Marks marks = {};         ///< of the frame
  };

  /// The description of an entry in a profile; null if it has none.
  struct Described {
    const ObjectInfo* object = nullptr;
    const EntryInfo* entry = nullptr;
  };
  static constexpr std::size_t entries_max = 256;

  DecodedValue described(const Profile& profile, sdo::Multiplexer place);
  DecodedValue value_at(NodeId node, const Profile& profile, sdo::Multiplexer place);
  void decode_lss(const Frame& frame);
  void end_transfers_with(NodeId server);
  void decode_sdo(const Frame& frame, const SdoRoute& route);
  void describe(sdo::Multiplexer entry, const SdoBehind& behind, NodeId server);
  void decode_transfer(const SdoTransfer& transfer, NodeId server);
  void check_length(const sdo::Message& message, NodeId server);
  void decode_pdo(const Frame& frame, const PdoPlan& plan);
  void decode_mapped(const Frame& frame, const PdoPlan& plan);
  void make_image(Image& image, const PdoPlan& plan);
  void decode_multiplexed(const Frame& frame, const PdoPlan& plan);
  void add_value(DecodedValue value);

  Network network_;
  std::map<std::uint16_t, SdoFollower> channels_;
  LssFollower lss_;
  ByCanId<Image> images_;
  EntryCache<Described, entries_max> entries_;
  std::vector<DecodedValue> values_;
  DecodedValue about_;
  std::uint64_t versions_ = 0;
  Decoded decoded_;
};

}  // namespace canvoy::decoder
