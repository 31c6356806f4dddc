// Requests SDO connections from the SDO manager of the network (CiA 302-5: the SDO requesting
// device).
//
// Needs 1F10h, the object of an SDO client for the channel to the SDO manager, and one for each
// connection (1280h and above).
//
//     SdoRequester requester(node, {.manager_client = 0});
//     requester.connect(10, 1, SdoRequester::Done::to<&Charger::connected>(*this));
//     ... SdoClient(node, 1).upload(10, 0x1000, 0, ...);
//     requester.release(1);
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/manager/dynamic_sdo.hpp"
#include "canvoy/canopen/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// The first connect() registers the device with the SDO manager: it calls on 6E0h, is found by its
/// 1F10h, and gets a channel to the manager, on which all requests go from then on. Where no
/// manager answers, connect() ends without an answer, and the device may use the default channels.
///
/// A manager that started anew knows nothing of a registration, and one that still closes what was
/// lost refuses: where a registration from before leads to silence or to 0800 0022h, the device
/// registers anew, once, before it gives up.
class SdoRequester {
 public:
  struct Settings {
    std::uint8_t manager_client = 0;  ///< 1280h + this is the channel to the SDO manager
    Duration time_out = 500ms;        ///< for the registration, and for each request
    unsigned calls_max = 2;           ///< of 6E0h, each with its own time-out
  };
  /// done, or why there is no connection: no answer (no SDO manager, or it was too slow), aborted
  /// by the manager (by SDO; or no_sdo_connection for a refusal in 1F10h, see error()), or
  /// cancelled by NMT.
  using Done = Callback<void(SdoEnd)>;

  SdoRequester(Node& node, const Settings& settings);
  SdoRequester(const SdoRequester&) = delete;
  SdoRequester& operator=(const SdoRequester&) = delete;

  /// Whether the dictionary has what is needed: without 1F10h there is nothing to request with.
  bool available() const;

  /// Asks for a connection of SDO client `client` (1280h + client) to the default server of
  /// `server`. `done` is called once. Refused at once: no_sdo_connection (no such objects, no
  /// node-ID), device_state (a request is under way, or the NMT state forbids it).
  AbortCode connect(NodeId server, std::uint8_t client, Done done);
  /// Asks for the sole use of all default SDO channels, as a configuration tool does.
  AbortCode connect_all(Done done);
  /// Gives the connection of this client back; false where that cannot be asked for now.
  bool release(std::uint8_t client);
  /// Gives everything back, the registration included.
  bool leave();

  bool busy() const { return state_ != State::idle; }
  /// The channel to the SDO manager is valid.
  bool registered() const;
  /// Of the last refusal.
  DynamicSdoError error() const { return error_; }

 private:
  enum class State : std::uint8_t { idle, calling, requesting, releasing };

  void state_entered(NmtState state);
  void after_write(const Entry& entry, Source source);
  void answered_by_manager(const DynamicSdoState& answer);
  AbortCode begin(bool wants_all, Done done);
  bool may_speak() const;
  void register_anew();
  void close_manager_channel();
  void ask_to_register();
  void call();
  AbortCode request();
  bool send(std::uint16_t index, const DynamicSdoRequest& request);
  void sent(SdoClient::Outcome outcome);
  void expired(Time now);
  void finish(SdoEnd end);
  NodeId manager() const;
  std::uint16_t manager_parameter() const {
    return static_cast<std::uint16_t>(sdo_client_parameter + settings_.manager_client);
  }

  static const ServiceCalls service_calls;
  static const HookCalls hook_calls;

  Node& node_;
  Settings settings_;
  SdoClient client_;
  ServiceLink service_{&service_calls, this};
  Timer timer_;
  Done done_;
  DynamicSdoRequest wanted_;
  std::array<std::uint8_t, 4> buffer_{};
  unsigned calls_left_ = 0;
  State state_ = State::idle;
  bool wants_all_ = false;
  bool is_kept_ = false;  ///< the registration that the request relies on is from before
  DynamicSdoError error_ = DynamicSdoError::none;
};

}  // namespace canvoy
