// Arbitrary records of panels, frames, faults, loads and times, passed to a lift controller with a
// car of plain numbers. For any input: no car moves with an unlocked door, no door opens between
// floors, no overloaded car leaves a floor (one that stands between two brings its people to the
// next); and without faults, each call is answered.
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/controller/lift_controller.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"
#include "canvoy/devices/testing/lift_bench.hpp"
#include "fuzz/input.hpp"
#include "fuzz/require.hpp"

namespace canvoy::cia417 {
namespace {

using fuzz::require;

using fuzz::Input;

constexpr std::array<std::int32_t, 5> floors{0, 4'000'000, 7'000'000, 10'000'000, 13'000'000};
constexpr auto parts =
    describe(lift_device<VirtualDevice::call_controller, LiftDeviceOptions{}>({0x6010, 0x6011}),
             virtual_input_rpdos<4, 1>(), cia301::identity({}), cia301::heartbeat_consumers(8),
             cia301::emergency());
constexpr auto layout = partial(lay_out_device<parts>());

class World {
 public:
  World() {
    node().on_defaults_restored(Callback<void(ResetScope)>::to<&World::restored>(*this));
    node().start(now_);
    node().command(NmtCommand::start);
  }
  void run(Input& input) {
    while (!input.empty()) step(input);
    end();
  }

 private:
  Node& node() { return device_.node(); }
  void restored(ResetScope) { use_panels(node().dictionary(), 4, 0, 1); }
  LiftLoad load() { return weighed_; }

  void step(Input& input) {
    switch (input.byte() % 8) {
      case 0:
        return receive(input);
      case 1:
        return fail(input.byte());
      case 2:
        weighed_ = {.known = input.byte() % 8 != 0,
                    .full = input.byte() % 2 == 0,
                    .overload = input.byte() % 4 == 0};
        return update();
      case 3:
        doors_.obstructed = input.byte() & 3;
        return update();
      case 4:
        return pass(input.byte() * 4U);
      default:
        return press(input);
    }
  }
  /// A record, usually a meaningful one.
  void press(Input& input) {
    const std::uint8_t what = input.byte();
    const std::uint8_t where = input.byte();
    const std::uint8_t floor = 1 + where % 6;
    VirtualInput record{.lifts = 1, .doors = 0x11, .data = 1};
    if (what % 4 == 0) {
      record.function = BasicFunction::special_function;
      record.sub_function = where % 0x18;
      record.data = static_cast<std::uint8_t>(0x80 | (what >> 4 & 3));
    } else {
      record.function = static_cast<BasicFunction>(2 + what / 4 % 12);
      record.sub_function = is_hall_call(record.function) ? where / 6 % 4 : 1 + where / 6 % 6;
      record.floor = floor;
    }
    send(encode(record), 6);
  }
  void receive(Input& input) {
    std::uint64_t bytes = 0;
    for (unsigned i = 0; i < 8; ++i) bytes |= std::uint64_t{input.byte()} << 8 * i;
    send(bytes, input.byte() % 9);
    if (bytes % 16 == 0) node().command(NmtCommand::enter_pre_operational);
    if (bytes % 16 == 1) node().command(NmtCommand::reset_node);
    if (bytes % 16 == 2) node().command(NmtCommand::start);
    node().advance(now_);
  }
  void send(std::uint64_t bytes, unsigned length) {
    Frame frame;
    frame.id = 0x482;
    frame.length = static_cast<std::uint8_t>(length);
    for (unsigned i = 0; i < 8; ++i) frame.data[i] = static_cast<std::uint8_t>(bytes >> 8 * i);
    node().receive(frame, now_);
    node().advance(now_);
  }
  void fail(std::uint8_t what) {
    if (what % 4 == 0) car_.motion.available = !car_.motion.available;
    if (what % 4 == 1) doors_.faulty ^= 1;
    if (what % 4 == 2) doors_.jammed ^= 1;
    if (what % 4 == 3) car_.is_stuck = !car_.is_stuck;
    update();
  }
  void update() {
    node().advance(now_);
    lift_.update();
    node().advance(now_);
  }

  void pass(unsigned steps) {
    for (unsigned i = 0; i < steps; ++i) {
      const MotionStatus before = car_.motion;
      const DoorsStatus doors_before = doors_.status();
      car_.step(doors_.are_closed());
      doors_.step();
      now_ += 10ms;
      while (node().deadline() <= now_) node().advance(now_);
      if (before != car_.motion || doors_before != doors_.status()) update();
      check(before);
    }
  }
  void check(const MotionStatus& before) const {
    require(!car_.left_unlocked);
    const std::int32_t at = car_.motion.position_micrometre;
    if (!doors_.are_closed()) require(is_at_floor(at));
    const bool leaves = before.standing && !car_.motion.standing && car_.is_driving &&
                        is_at_floor(before.position_micrometre);
    require(!leaves || !weighed_.overload);
  }
  static bool is_at_floor(std::int32_t position) {
    for (const std::int32_t floor : floors) {
      if (std::abs(floor - position) <= 10'000) return true;
    }
    return false;
  }

  /// A reset clears keys of all floors and doors, and faults end: calls are then answered.
  void end() {
    node().command(NmtCommand::reset_node);
    node().advance(now_);
    node().command(NmtCommand::start);
    car_.motion.available = true;
    car_.is_stuck = false;
    doors_.faulty = doors_.jammed = doors_.obstructed = 0;
    weighed_ = {};
    for (std::uint8_t function = 1; function < SpecialFunctions::count; ++function) {
      const VirtualInput off{.function = BasicFunction::special_function,
                             .sub_function = function,
                             .lifts = 1,
                             .data = 0x80};
      send(encode(off), 6);
    }
    update();
    for (unsigned minute = 0; minute < 20 && !is_at_rest(); ++minute) pass(6000);
    require(is_at_rest());
    require(lift_.fault() == LiftFault::none);
  }
  bool is_at_rest() const {
    return lift_.phase() == LiftPhase::idle && device_.calls().calls().empty();
  }

  static bool take(void*, const Frame&) { return true; }

  Time now_{};
  BenchCar car_;
  BenchDoors doors_;
  LiftLoad weighed_;
  CallControllerDevice<layout, 4> device_{
      {this, &World::take, nullptr},
      1,
      {.served = {FloorSet::between(1, 5), FloorSet::between(2, 2)}}};
  LiftController lift_{
      device_.node(),
      device_.calls(),
      {car_.interface(), doors_.interface(), Callback<LiftLoad()>::to<&World::load>(*this)},
      {.floors = floors, .doors = 0b11, .parking_floor = 2}};
};

}  // namespace
}  // namespace canvoy::cia417

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  canvoy::fuzz::Input input(data, size);
  canvoy::cia417::World world;
  world.run(input);
  return 0;
}
