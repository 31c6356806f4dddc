// All virtual devices of CiA 447-3 on the 16 nodes of a car, as one program on a bus that is a pair
// of pipes (pipe_node.hpp). Node 1 is the gateway; a physical device may be two virtual ones. First
// it says who is where:
//
//     echo "until 1000" | canvoy_car_network_peer    # device 1 ivn-gateway, ... 701#00, ...
#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

constexpr std::size_t nodes = 16;

/// What a node sends goes to all others, and out.
class Car {
 public:
  Car() {
    const std::vector<const DeviceKind*> kinds = kinds_of_a_car();
    std::array<std::vector<const DeviceKind*>, nodes> devices;
    for (std::size_t i = 0; i < kinds.size(); ++i) devices[i % nodes].push_back(kinds[i]);
    for (std::size_t i = 0; i < nodes; ++i) add(devices[i]);
  }

  Car& node() { return *this; }
  void start(Time now) {
    for (Place& place : places_) place.device->node().start(now);
    pass_on(now);
  }
  void advance(Time now) {
    for (Place& place : places_) {
      if (place.device->node().deadline() <= now) place.device->node().advance(now);
    }
    pass_on(now);
  }
  void receive(const Frame& frame, Time now) {
    sent_.push_back({nullptr, frame});
    pass_on(now);
  }
  Time deadline() {
    Time first = never;
    for (Place& place : places_) first = std::min(first, place.device->node().deadline());
    return first;
  }

 private:
  struct Place {
    Car* car = nullptr;
    std::vector<const cia447::CarUnit*> units;
    Environment environment;
    std::unique_ptr<cia447::CarDevice> device;
  };
  struct Sent {
    Place* by;  // none of the nodes, where null
    Frame frame;
  };

  static std::vector<const DeviceKind*> kinds_of_a_car() {
    std::vector<const DeviceKind*> kinds;
    for (const DeviceKind* kind : device_catalogue()) {
      if (kind->car_unit != nullptr) kinds.push_back(kind);
    }
    // The gateway is node 1.
    std::ranges::stable_partition(
        kinds, [](const DeviceKind* kind) { return kind->info.name == "ivn-gateway"; });
    return kinds;
  }

  void add(std::span<const DeviceKind* const> kinds) {
    Place& place = places_.emplace_back();
    place.car = this;
    std::string names;
    for (const DeviceKind* kind : kinds) {
      place.units.push_back(kind->car_unit);
      names += (names.empty() ? "" : "+") + std::string(kind->info.name);
    }
    const auto id = static_cast<NodeId>(places_.size());
    print_line("device " + std::to_string(id) + " " + names);
    place.device = std::make_unique<cia447::CarDevice>(place.units, Port{&place, &take, nullptr},
                                                       id, place.environment);
  }
  static bool take(void* place, const Frame& frame) {
    auto* const by = static_cast<Place*>(place);
    by->car->sent_.push_back({by, frame});
    return print_frame(nullptr, frame);
  }
  void pass_on(Time now) {
    while (!sent_.empty()) {
      const Sent sent = sent_.front();
      sent_.pop_front();
      for (Place& place : places_) {
        if (&place != sent.by) place.device->node().receive(sent.frame, now);
      }
    }
  }

  std::deque<Place> places_;
  std::deque<Sent> sent_;
};

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::PipeNode<canvoy::Car>().run();
}
