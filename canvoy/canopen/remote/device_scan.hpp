// Finds a node by its device profile: reads the device type (1000h) of all nodes by SDO, a few at a
// time.
//
// The bus load is limited (one request an interval, none while the controller has not sent the one
// before), and absent nodes cost little (a short time-out, several requests under way at once).
// Nodes that were heard are asked first.
//
//     DeviceScan scan(node, clients, {.profile = 418});
//     scan.on_found(Callback<void(NodeId)>::to<&Charger::battery_found>(*this));
//     scan.start();
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/canopen/sdo/sdo_client.hpp"

namespace canvoy {

class DeviceScan {
 public:
  /// What to look for, and how fast.
  struct Options {
    std::uint16_t profile = 0;  ///< the lower word of 1000h
    Duration interval = 10ms;   ///< from one request to the next
    Duration time_out = 100ms;  ///< for one answer
    Duration pause = 1s;        ///< from the end of one round over all nodes to the next
  };

  static constexpr std::size_t requests_max = 4;  ///< requests under way at a time

  /// Makes the scan. Requests use the default SDO channels of the nodes 1 to 127, except this one.
  DeviceScan(Node& node, const Options& options);

  /// Sets the callback for the node that was found; the scan has stopped then.
  void on_found(Callback<void(NodeId)> found) { found_ = found; }

  /// Begins with the preferred nodes, then asks all of them, again and again until one is found;
  /// the first request follows after `later`.
  void start(Duration later = {});
  /// Continues after a node that was found but is not the right one.
  void go_on();
  /// Stops the scan. Requests under way are cancelled.
  void stop();
  /// True from start() until a node is found, or stop().
  bool running() const { return running_; }
  /// Asks this node next, since it was heard. Ignores a number that is not a node-ID.
  void prefer(NodeId id) {
    if (id <= node_id_max) preferred_[id] = true;
  }

  /// Number of requests sent since construction.
  std::uint32_t requests() const { return requests_; }

 private:
  /// One request under way.
  class Request {
   public:
    Request(DeviceScan& scan, Node& node) : scan_(scan), client_(node) {}
    bool idle() const { return server_ == 0; }
    bool ask(NodeId server, Duration time_out);
    void cancel();

   private:
    void answered(SdoClient::Outcome outcome);

    DeviceScan& scan_;
    SdoClient client_;
    NodeId server_ = 0;
    std::array<std::uint8_t, 4> device_type_{};
  };

  void next(Time now);
  Duration ask_next();
  NodeId choose();
  void found(NodeId id);

  Node& node_;
  Options options_;
  Callback<void(NodeId)> found_;
  std::array<Request, requests_max> pool_;
  Timer timer_;
  std::bitset<node_id_max + 1> preferred_;
  NodeId position_ = 0;  ///< the node asked last in this round
  bool running_ = false;
  std::uint32_t requests_ = 0;
};

}  // namespace canvoy
