// A car drive unit of ours (node 2) with a simulated car, on a bus that is a pair of pipes
// (pipe_node.hpp). Asked `where`, it tells the car's position in millimetres, and the brake:
//
//     echo where | canvoy_lift_drive_peer   # 702#00, car 0 closed
#include <cmath>
#include <string>
#include <string_view>

#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy::cia417 {
namespace {

class Drive {
 public:
  Node& node() { return device_.node(); }
  void obey(std::string_view) {
    const lift::CarPlant::Truth car = plant_.truth();
    print_line("car " + std::to_string(std::lround(car.position_m * 1000)) +
               (car.brake_is_closed ? " closed" : " open"));
  }

 private:
  Time read_clock() { return node().now(); }

  lift::CarPlant plant_{{}, Callback<Time()>::to<&Drive::read_clock>(*this)};
  CarDriveDevice<> device_{pipe_port, 2, plant_.drive_hardware()};
};

}  // namespace
}  // namespace canvoy::cia417

int main() {
  canvoy::PipeNode<canvoy::cia417::Drive>().run();
}
