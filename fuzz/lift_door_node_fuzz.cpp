// Arbitrary frames at arbitrary times, and arbitrary people and faults, for the door of a car, its
// controller, its light barrier, a load measuring unit and a sensor unit.
//
// Beside what the sanitizers detect: the nodes come to rest, the statusword holds a defined state,
// a locked door is closed, and nothing leaves the path of the panels.
#include <array>
#include <cstdint>
#include <memory>

#include "canvoy/devices/cia417/door/car_door_controller_device.hpp"
#include "canvoy/devices/cia417/door/car_door_device.hpp"
#include "canvoy/devices/cia417/load/load_measuring_device.hpp"
#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"
#include "canvoy/devices/cia417/sensor/sensor_unit_device.hpp"
#include "canvoy/worlds/lift/door_plant.hpp"
#include "canvoy/worlds/lift/load_cell.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy::fuzz {
namespace {

bool drop(void*, const Frame&) {
  return true;
}
constexpr Port nowhere = {nullptr, &drop, nullptr};
constexpr cia417::VirtualSensor sensors[] = {{.function = cia417::SensorFunction::smoke},
                                             {.function = cia417::SensorFunction::temperature}};
/// CAN-IDs that one of the nodes receives.
constexpr std::uint16_t wanted_ids[] = {0x000, 0x200, 0x201, 0x205, 0x601, 0x606,
                                        0x609, 0x60D, 0x61E, 0x701, 0x706};

class Lift {
 public:
  explicit Lift(Input& input) : input_(input) {
    plant_.on_change(Callback<void()>::to<&Lift::changed>(*this));
    for (Node* node : nodes_) node->start(now_);
    tell_all(Frame::data_frame(0, {}), {1, 0});
  }

  void step() {
    const std::uint8_t what = input_.byte();
    now_ += Duration(std::int64_t{what >> 4} * what * 1000);
    settle();
    switch (what % 8) {
      case 0:
      case 1:
      case 2:
        return receive();
      case 3:
        return plant_.stand_in_way(now_, (what & 0x10) != 0,
                                   {.width_m = input_.byte() / 255.0, .force_n = 4.0 * what});
      case 4:
        return plant_.set_faults(now_, faults(input_.word()));
      case 5:
        return command(input_.byte());
      case 6:
        return sense();
      default:
        plant_.approach((what & 0x10) != 0);
        return plant_.touch_edge((what & 0x20) != 0);
    }
  }

  void check() {
    settle();
    const auto state = static_cast<unsigned>(door_.unit().state());
    require(state <= 7 || state == 14);
    const double open = plant_.open_m(now_);
    require(open >= 0 && open <= 0.9);
    require(!plant_.is_locked(now_) || open < 0.001 || plant_.faults().lock_is_stuck);
    require(sensor_.unit().waiting() <= 2);
  }

 private:
  void changed() {
    door_.unit().hardware_changed();
    barrier_.unit().hardware_changed();
  }
  void settle() {
    for (Node* node : nodes_) {
      int calls = 0;
      while (node->deadline() <= now_) {
        node->advance(now_);
        require(++calls < 1'000'000);
      }
    }
  }
  void tell_all(Frame frame, std::initializer_list<std::uint8_t> bytes) {
    frame.length = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    for (Node* node : nodes_) node->receive(frame, now_);
  }
  void receive() {
    Frame frame = Frame::data_frame(wanted_ids[input_.byte() % std::size(wanted_ids)], {});
    frame.length = static_cast<std::uint8_t>(input_.byte() % 9);
    input_.fill({frame.data.data(), frame.length});
    for (Node* node : nodes_) node->receive(frame, now_);
  }
  static lift::DoorFaults faults(unsigned bits) {
    return {.is_stuck = (bits & 0x01) != 0,
            .belt_is_broken = (bits & 0x02) != 0,
            .drive_fails = (bits & 0x04) != 0,
            .lock_is_stuck = (bits & 0x08) != 0,
            .contact_is_broken = (bits & 0x10) != 0,
            .barrier_is_broken = (bits & 0x20) != 0,
            .barrier_is_covered = (bits & 0x40) != 0,
            .finger_protector_is_broken = (bits & 0x80) != 0,
            .motion_detector_is_broken = (bits & 0x100) != 0};
  }
  void command(unsigned what) {
    cia417::CarDoorController& doors = controller_.unit();
    const auto mask = static_cast<cia417::DoorMask>(what >> 4);
    switch (what % 5) {
      case 0:
        return doors.open(mask);
      case 1:
        return doors.close(mask, cia417::DoorClosing::normal);
      case 2:
        return doors.close(mask, cia417::DoorClosing::nudging);
      case 3:
        return doors.stop(mask);
      default:
        return doors.reset(mask);
    }
  }
  void sense() {
    const std::uint16_t value = input_.word();
    cell_.set_load(value);
    cell_.break_sensor(value % 5);
    sensor_.unit().set_level(value % 3U, (value & 0x80) != 0, now_);
    sensor_.unit().set_value(1, static_cast<std::int16_t>(value), now_);
    sensor_.unit().report(0, static_cast<cia417::SensorSignal>(value >> 14), now_);
  }

  Input& input_;
  Time now_{};
  lift::DoorPlant plant_{lift::DoorPlantOptions{.has_light_barrier = true}};
  lift::LoadCell cell_;
  cia417::CarDoorDevice<> door_{nowhere, 6, {plant_.hardware()}};
  cia417::CarDoorControllerDevice<> controller_{nowhere, 1, {.doors = 0b0111}};
  cia417::LightBarrierDevice<> barrier_{nowhere, 9, plant_.light_barrier_hardware()};
  cia417::LoadMeasuringDevice<> load_{nowhere, 13, cell_.hardware()};
  cia417::SensorUnitDevice<2> sensor_{nowhere, 30, {.sensors = sensors}};
  std::array<Node*, 5> nodes_{&door_.node(), &controller_.node(), &barrier_.node(), &load_.node(),
                              &sensor_.node()};
};

}  // namespace
}  // namespace canvoy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::Input input(data, size);
  const auto lift = std::make_unique<canvoy::fuzz::Lift>(input);
  for (int steps = 0; !input.empty() && steps < 500; ++steps) {
    lift->step();
    lift->check();
  }
  return 0;
}
