// Requests SDO connections from the SDO manager of the network (CiA 302-5, SDO requesting device).
//
// Needs 1F10h, the object of an SDO client for the channel to the SDO manager, and one for each
// connection (1280h and above).
//
//     SdoRequester requester(node, {.manager_client = 0});
//     requester.connect(10, 1, SdoRequester::Done::to<&Charger::connected>(*this));
//     requester.release(1);  // when the transfers of SDO client 1 are done
#pragma once

#include <array>
#include <cstdint>

#include "canvoy/canopen/manager/dynamic_sdo.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

/// The first connect() registers the device with the SDO manager: it calls on 6E0h, is found by its
/// 1F10h, and gets a channel to the manager, on which all requests go from then on. If no manager
/// answers, connect() ends without an answer, and the device may use the default channels.
///
/// A restarted manager has no record of a registration, and one that still closes lost connections
/// refuses requests: if an earlier registration leads to silence or to 0800 0022h, the device
/// registers again, once, before it gives up.
class SdoRequester {
 public:
  /// Channel and times.
  struct Settings {
    std::uint8_t manager_client = 0;  ///< 1280h + this is the channel to the SDO manager
    Duration time_out = 500ms;        ///< for the registration, and for each request
    unsigned calls_max = 2;           ///< calls on 6E0h, each with its own time-out
  };
  /// Called at the end: done, or the reason: no answer (no SDO manager, or too slow), aborted by
  /// the manager (by SDO; or no_sdo_connection for a refusal in 1F10h, see error()), or cancelled
  /// by NMT.
  using Done = Callback<void(SdoEnd)>;

  /// Makes the object; `node` must outlive it, and needs a route for its SDO client.
  SdoRequester(Node& node, const Settings& settings);
  SdoRequester(const SdoRequester&) = delete;
  SdoRequester& operator=(const SdoRequester&) = delete;

  /// True if the dictionary has the objects it needs; requests are not possible without 1F10h.
  bool available() const;

  /// Requests a connection of SDO client `client` (1280h + client) to the default server of
  /// `server`. `done` is called once. Immediate refusals: no_sdo_connection (no such objects, not a
  /// node-ID), device_state (a request is under way, or the NMT state forbids it).
  AbortCode connect(NodeId server, std::uint8_t client, Done done);
  /// Requests the sole use of all default SDO channels, for example for a configuration tool.
  AbortCode connect_all(Done done);
  /// Returns the connection of this client; false if that cannot be requested at present.
  bool release(std::uint8_t client);
  /// Returns everything, including the registration.
  bool leave();

  /// True from a request until its end.
  bool busy() const { return state_ != State::idle; }
  /// True if the channel to the SDO manager is valid.
  bool registered() const;
  /// Error of the last refusal.
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

  static const ServiceHandlers service_calls;
  static const AccessHandlers hook_calls;

  Node& node_;
  Settings settings_;
  SdoClient client_;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
  Done done_;
  DynamicSdoRequest wanted_;
  std::array<std::uint8_t, 4> buffer_{};
  unsigned calls_left_ = 0;
  State state_ = State::idle;
  bool wants_all_ = false;
  bool is_kept_ = false;  ///< the request uses an earlier registration
  DynamicSdoError error_ = DynamicSdoError::none;
};

}  // namespace canvoy
