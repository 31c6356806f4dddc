// A car door unit of ours with a simulated door, on a bus that is a pair of pipes (pipe_node.hpp).
// A line "+" puts a technician into the way of the door, "-" takes them out again.
//
//     echo 000#0106 | canvoy_doors_peer    # 706#00, 201#11100000
#include <string_view>

#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/worlds/lift/door_plant.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

class Door {
 public:
  Door() { plant_.on_change(Callback<void()>::to<&Door::changed>(*this)); }

  Node& node() { return device_.node(); }
  void obey(std::string_view line) { plant_.stand_in_way(node().now(), line == "+"); }

 private:
  void changed() { device_.unit().hardware_changed(); }

  lift::DoorPlant plant_{{.open_time_s = 0.5, .close_time_s = 0.5, .has_light_barrier = true}};
  cia417::CarDoorDevice<> device_{pipe_port, 6, {plant_.hardware()}};
};

}  // namespace
}  // namespace canvoy

int main() {
  canvoy::PipeNode<canvoy::Door>().run();
}
