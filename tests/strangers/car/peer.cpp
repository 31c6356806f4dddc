// Gateway and taximeter of a car as one node of ours, node 1, on a bus that is a pair of pipes
// (pipe_node.hpp): it looks for devices without a node-ID, and names and starts them. A line "on"
// is the driver's key.
//
//     echo "until 1000" | canvoy_car_peer    # 701#00, 7E5#04 ..., now 1000
#include <string_view>

#include "canvoy/devices/cia447/ivn_gateway/ivn_gateway_unit.hpp"
#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/taximeter/taximeter_unit.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

class Car {
 public:
  Car() {
    environment_.watch(Callback<void(cia447::TaximeterUnit&, Node&)>::to<&Car::is_meter>(*this));
    device_.emplace(units, pipe_port, NodeId{cia447::gateway_node_id}, environment_);
  }

  Node& node() { return device_->node(); }
  void obey(std::string_view line) {
    if (line == "on") meter_->sign_on();
  }

 private:
  static constexpr const cia447::CarUnit* units[] = {&cia447::car_unit<cia447::IvnGatewayKind>,
                                                     &cia447::car_unit<cia447::TaximeterKind>};

  void is_meter(cia447::TaximeterUnit& unit, Node& /*node*/) { meter_ = &unit; }

  Environment environment_;
  cia447::TaximeterUnit* meter_ = nullptr;
  std::optional<cia447::CarDevice> device_;
};

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::PipeNode<canvoy::Car>().run();
}
