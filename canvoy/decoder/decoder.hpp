// A passive listener that turns the CANopen traffic of one bus into objects with their values. It
// knows the profiles, and learns from the traffic which node has which, and what its PDOs carry.
//
//     Decoder decoder;
//     const Decoded& decoded = decoder.decode(frame);
//     for (const DecodedValue& value : decoded.values) show(value.object->name, value.bytes());
//
// Memory is bounded whatever comes: a few hundred bytes for each node, PDO and SDO channel, and
// 4 KiB for the transfer that is under way on a channel. A bus of which nothing was heard takes
// some 20 KiB, and 8 more for what profiles say of entries from its first object on.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/decoder/by_entry.hpp"
#include "canvoy/decoder/lss_follower.hpp"
#include "canvoy/decoder/mark.hpp"
#include "canvoy/decoder/network.hpp"
#include "canvoy/decoder/sdo_follower.hpp"

namespace canvoy::decoder {

/// The value of one object in a frame, or in a transfer.
struct DecodedValue {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  const Profile* profile = nullptr;
  const ObjectInfo* object = nullptr;  ///< null: the profile does not know the index
  /// With the unit that the node has told; null: the profile does not know the sub-index.
  const EntryInfo* entry = nullptr;
  bool is_told = false;  ///< `entry` is a copy, which lives no longer than the network
  std::array<std::uint8_t, Frame::length_max> mapped{};  ///< of a PDO
  std::span<const std::uint8_t> transferred = {};        ///< of an SDO transfer
  std::uint8_t size = 0;
  Marks marks = {};
  /// Of a PDO: another number whenever the bytes are others than in the last one with its CAN-ID.
  std::uint64_t version = 0;

  std::span<const std::uint8_t> bytes() const {
    return transferred.data() != nullptr ? transferred : std::span(mapped).first(size);
  }
};

/// What one frame says, as far as objects are concerned. Valid until the next frame.
struct Decoded {
  enum class Service : std::uint8_t { other, pdo, sdo_request, sdo_response };
  Service service = Service::other;
  NodeId node = 0;                              ///< of SDO the server; 0: none, or not known
  NodeId client = 0;                            ///< of SDO, where it is known who asks
  std::uint16_t channel = 0;                    ///< of SDO: the CAN-ID of the requests
  const PdoPlan* pdo = nullptr;                 ///< null: not known what it carries
  SdoMessage message = SdoMessage::unknown;     ///< of SDO, where it has eight bytes
  SdoBehind behind{};                           ///< whom it is with, where not with the server
  const SdoTransfer* transfer = nullptr;        ///< the one that this frame ends
  const DecodedValue* about = nullptr;          ///< of SDO: the entry, without a value, if known
  const LssFollower::Device* device = nullptr;  ///< of which LSS has told something
  const NodeNews* news = nullptr;               ///< what is known of a node since this frame
  std::span<const DecodedValue> values = {};
  Marks marks = {};  ///< of the frame, and of all values
};

class Decoder {
 public:
  Network& network() { return network_; }
  const Network& network() const { return network_; }

  const Decoded& decode(const Frame& frame);

 private:
  /// An entry, or a dummy, that a PDO carries.
  struct Slot {
    unsigned first = 0;  ///< its first bit
    unsigned end = 0;
    std::uint64_t mask = 0;
    std::uint64_t raw = 0;  ///< in the last frame
    bool is_heard = false;
    bool is_value = false;  ///< the next one of `values`; else a dummy
  };
  /// What the PDO with a CAN-ID carried last: most values of a bus do not change.
  struct Image {
    std::uint32_t generation = 0;  ///< of the network, when it was made; 0: never
    std::vector<Slot> slots;
    std::vector<DecodedValue> values;
    unsigned bits = 0;
  };

  /// What a profile says of an entry; null where it does not know it.
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
  ByEntry<Described, entries_max> entries_;
  std::vector<DecodedValue> values_;
  DecodedValue about_;
  std::uint64_t versions_ = 0;
  Decoded decoded_;
};

}  // namespace canvoy::decoder
