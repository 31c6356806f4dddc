// Arbitrary controlwords, targets, modes, parameters, factors, emergencies, heartbeats and times,
// passed to a car drive unit of CiA 417-4 with a simulated car that fails.
//
// It continues to run and comes to rest; without power the brake is closed; the statusword gives
// the state; its commands to the car are finite numbers.
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/drive/car_drive_device.hpp"
#include "canvoy/worlds/lift/car_plant.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_feeder.hpp"

namespace canvoy::cia417 {
namespace {

using fuzz::Input, fuzz::NodeFeeder, fuzz::require;

constexpr NodeId node_id = 2;

class World {
 public:
  void run(Input& input) {
    node().command(NmtCommand::start);
    feeder_.write(0x1028, 4, 0x84);
    while (!input.empty()) {
      step(input);
      check();
    }
    stand();
  }

 private:
  Node& node() { return device_.node(); }
  Time read_clock() { return feeder_.now(); }

  void step(Input& input) {
    switch (input.byte() % 8) {
      case 0:
        return receive(input);
      case 1:
        return write_parameter(input);
      case 2:
        return feeder_.pass(Duration(input.word() * 100));
      case 3:
        return change_car(input);
      case 4:
        return enable();
      default:
        return control(input);
    }
  }

  /// 180h or 184h: usually meaningful words.
  void control(Input& input) {
    constexpr std::array<std::uint16_t, 8> words = {0x06, 0x07, 0x0F, 0x1F,
                                                    0x3F, 0x5F, 0x02, 0x10F};
    const std::uint8_t which = input.byte();
    const std::uint16_t word = which < 200 ? words[which % words.size()] : input.word();
    const auto target = static_cast<std::int16_t>(input.word());
    send(which % 2 == 0 ? 0x180 : 0x184, word, which % 3 == 0 ? target : target % 1600);
  }
  void enable() {
    constexpr std::array<std::uint16_t, 4> words = {0x80, 0x06, 0x07, 0x0F};
    for (const std::uint16_t word : words) send(0x184, word, 0);
  }
  void send(std::uint32_t id, std::uint16_t word, std::int32_t target) {
    Frame frame = Frame::data_frame(id, {});
    frame.length = 6;
    store(frame.data.data(), word);
    store(frame.data.data() + 2, target);
    feeder_.receive(frame);
  }
  void receive(Input& input) {
    constexpr std::array<std::uint32_t, 7> likely = {0x180, 0x184, 0x000, 0x084,
                                                     0x701, 0x602, 0x080};
    Frame frame;
    frame.id = likely[input.byte() % likely.size()];
    frame.length = static_cast<std::uint8_t>(input.byte() % 9);
    input.fill(std::span(frame.data).first(frame.length));
    if (frame.id == 0x084 && frame.length == 8) frame.data[1] |= 0xF0;
    feeder_.receive(frame);
  }

  void write_parameter(Input& input) {
    const auto index = static_cast<std::uint16_t>(0x6400 + input.byte() % 0x39);
    const std::uint32_t small = input.byte();
    const std::uint32_t large = small << (input.byte() % 32);
    feeder_.write(index, input.byte() % 7, input.byte() % 2 == 0 ? small : large);
  }

  void change_car(Input& input) {
    const std::uint8_t bits = input.byte();
    plant_.set_faults({.drive_encoder_is_dead = (bits & 1) != 0,
                       .slip = (bits & 2) != 0 ? 0.1 : 0,
                       .motor_runs_away = (bits & 4) != 0,
                       .brake_share = (bits & 8) != 0 ? 0.1 : 1,
                       .brake_is_stuck = (bits & 16) != 0,
                       .drive_fault = (bits & 32) != 0 ? std::uint16_t{0x4210} : std::uint16_t{0}});
    plant_.set_load(input.byte() * 8);
    if ((bits & 64) != 0) plant_.release_gear();
  }

  void check() {
    const CarDriveUnit& drive = device_.unit();
    const Values values(node().dictionary());
    require(cia402::drive_state(values[statusword].raw()) == drive.state());
    const MotionState demand = drive.demand(feeder_.now());
    require(std::isfinite(demand.position) && std::isfinite(demand.velocity));
    const lift::CarPlant::Truth car = plant_.truth();
    require(std::isfinite(car.position_m) && std::isfinite(car.velocity_m_s));
    require(is_powered(drive.state()) || car.brake_is_closed);
  }
  /// At the end a car with a working brake stands.
  void stand() {
    plant_.set_faults({});
    feeder_.receive(Frame::data_frame(0x000, std::array<std::uint8_t, 2>{0x81, node_id}));
    feeder_.pass(2s);
    check();
    require(plant_.truth().velocity_m_s == 0);
    require(device_.unit().is_standing());
  }

  lift::CarPlant plant_{{}, Callback<Time()>::to<&World::read_clock>(*this)};
  CarDriveDevice<> device_{{nullptr, [](void*, const Frame&) { return true; }, nullptr},
                           node_id,
                           plant_.drive_hardware()};
  NodeFeeder feeder_{device_.node()};
};

}  // namespace
}  // namespace canvoy::cia417

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::Input input(data, size);
  canvoy::cia417::World world;
  world.run(input);
  return 0;
}
