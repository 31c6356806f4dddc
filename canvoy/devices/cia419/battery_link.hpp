// The requests of a charger to a battery module before it links its PDOs to those of the battery
// (CiA 419, 6.1 and 7.2.4).
//
//     BatteryLink link(node);
//     link.on_answered(Callback<void(const BatteryOffer&)>::to<&Charging::begin>(*this));
//     link.ask(battery_id);
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy::cia419 {

/// A battery's answers. Values that it does not have are invalid or absent.
struct BatteryOffer {
  static constexpr std::size_t pdos = 3;  ///< TPDOs and RPDOs that a battery may have

  NodeId id = 0;                                          ///< of the battery
  std::array<CobId, pdos> tpdo;                           ///< 1800h to 1802h, sub-index 1
  std::array<CobId, pdos> rpdo;                           ///< 1400h to 1402h, sub-index 1
  std::array<std::uint16_t, pdos> tpdo_event_timer_ms{};  ///< 1800h to 1802h, sub-index 5
  /// PDOs with a mapping (1A00h to 1A02h, 1600h to 1602h) that differs from that of the charger's
  /// PDO at the other end: they would be misread.
  std::bitset<pdos> misfit_tpdos;
  std::bitset<pdos> misfit_rpdos;                      ///< likewise
  std::uint16_t heartbeat_ms = 0;                      ///< 1017h
  std::optional<std::uint16_t> ampere_hours_returned;  ///< 6052h, 0.125 Ah
  std::optional<std::uint16_t> capacity_ampere_hours;  ///< 6020h, sub-index 2
  std::optional<std::uint16_t> current_max_ampere;     ///< 6020h, sub-index 3; neither 0 nor FFFFh
  std::optional<std::uint16_t> cells;                  ///< 6020h, sub-index 4; neither 0 nor FFFFh
};

class BatteryLink {
 public:
  /// Makes the link, with an SDO client on default channels, which needs a route.
  explicit BatteryLink(Node& node);

  /// Called when all requests were answered, or refused by a battery that does not have the object.
  void on_answered(Callback<void(const BatteryOffer&)> answered) { answered_ = answered; }
  /// Called when the battery does not answer any more.
  void on_failed(Callback<void()> failed) { failed_ = failed; }

  /// Sets the channel to the battery: a connection that the SDO manager assigned, or (null) the
  /// battery's default channel. No request may be under way.
  void use(SdoClient* client) { client_ = client != nullptr ? client : &default_client_; }
  /// Begins to read the PDOs and data of a battery. Replaces what is under way.
  void ask(NodeId battery);
  /// Ends the requests, without a callback.
  void cancel();
  /// Discards waiting messages: the battery is gone, and they do not apply to the next one.
  void forget();

  /// Writes the returned ampere-hours to the battery (6052h, 7.2.4), and retries until it has them.
  /// A value that it already has is not written again.
  void write_back(NodeId battery, std::uint16_t ampere_hours_returned);
  /// Makes a battery without a heartbeat send one (1017h).
  void write_heartbeat(NodeId battery, std::uint16_t milliseconds);

 private:
  struct Question {
    std::uint16_t index;
    std::uint8_t sub;
    void (*take)(BatteryOffer& offer, std::uint32_t answer);
  };
  /// A value that the battery has to receive.
  struct Message {
    std::uint16_t index = 0;
    std::uint16_t value = 0;
    NodeId battery = 0;
    unsigned tries_left = 0;
    bool is_known = false;  ///< the battery has answered
  };
  /// The PDOs with compared mappings: the battery's TPDOs, then its RPDOs.
  static constexpr std::size_t mappings = 2 * BatteryOffer::pdos;
  static const std::array<Question, 14> questions;
  static constexpr unsigned tries_max = 3;

  void next();
  void ask_for(std::uint16_t index, std::uint8_t sub, SdoClient::Done done);
  void answered(SdoClient::Outcome outcome);
  void compare_mappings();
  bool is_linkable(std::size_t mapping) const;
  void mapping_answered(SdoClient::Outcome outcome);
  void note_misfit(std::size_t mapping);
  void tell(Message& message, NodeId battery, std::uint16_t value);
  void send_next_message();
  AbortCode send(const Message& message);
  void told(SdoClient::Outcome outcome);

  Node& node_;
  SdoClient default_client_;
  SdoClient* client_ = &default_client_;
  Callback<void(const BatteryOffer&)> answered_;
  Callback<void()> failed_;
  BatteryOffer offer_;
  std::size_t question_ = 0;
  std::size_t mapping_ = 0;       ///< the mapping that is being compared
  std::uint8_t mapping_sub_ = 0;  ///< its entry
  std::array<std::uint8_t, 4> buffer_{};
  std::array<Message, 2> messages_{Message{.index = 0x6052},
                                   Message{.index = object_index::heartbeat_producer}};
  Message* under_way_ = nullptr;  ///< that the client is sending, or sent last
};

}  // namespace canvoy::cia419
