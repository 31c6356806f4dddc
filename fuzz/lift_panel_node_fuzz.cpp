// Arbitrary frames, writes of parameters and PDOs, buttons, defects, object creations and times,
// passed to a landing panel of CiA 417-4. It continues to run, its memory is bounded, and when the
// bus is free again, the last report of each input is its state.
#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia417/kit/lift_number.hpp"
#include "canvoy/devices/cia417/kit/object_creation.hpp"
#include "canvoy/devices/cia417/panel/panel_device.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_feeder.hpp"

namespace canvoy::cia417 {
namespace {

using fuzz::Input, fuzz::NodeFeeder, fuzz::require;

constexpr std::uint8_t input_count = 5;
constexpr std::uint8_t output_count = 6;
constexpr std::size_t queue_max = 3;
constexpr NodeId node_id = 22;
constexpr std::uint32_t input_cob_id = 0x480 + node_id;

constexpr auto make_parts() {
  DeviceDescription<64> parts;
  parts.add(panel<PanelOptions{
                .inputs = input_count, .outputs = output_count, .low_pdo_numbers = true}>());
  parts.add(object_creation_object);
  parts.add(lift_number_object);
  parts.add(Part(input_parameter_1_object).only(4, 2).up_to(4));
  parts.add(cia301::identity({}));
  parts.add(cia301::sync_consumer());
  return parts;
}
constexpr auto parts = make_parts();
constexpr auto layout = partial(lay_out_device<parts>());
constexpr CreatableObjects creatable[] = {
    {.first = 0x6124, .last = 0x6125, .highest_sub = 4, .specified = Access::rw}};

constexpr VirtualInput inputs[] = {
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_up,
     .lifts = lift_bit(1),
     .floor = 3},
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_down,
     .lifts = lift_bit(1),
     .floor = 3},
    {.function = BasicFunction::special_function,
     .sub_function = 0x0C,
     .lifts = lift_bit(1),
     .data = VirtualInput::lock_bit},
    {.function = BasicFunction::standard_car_call, .sub_function = 7, .lifts = lift_bit(1)}};
constexpr VirtualOutput outputs[] = {
    {.function = BasicFunction::standard_hall_call,
     .sub_function = hall_up,
     .lifts = 1,
     .floor = 3},
    {.function = BasicFunction::position_indicator, .lifts = 1, .floor = 3},
    {.function = BasicFunction::special_indication, .lifts = 1, .floor = 3},
    {.function = BasicFunction::special_indication, .sub_function = 3, .lifts = 1, .floor = 3},
    {.function = BasicFunction::arrival_indication, .lifts = 1, .floor = 3}};

class World {
 public:
  void run(Input& input) {
    node().command(NmtCommand::start);
    while (!input.empty()) step(input);
    settle_down();
  }

 private:
  Node& node() { return device_.node(); }

  void step(Input& input) {
    switch (input.byte() % 8) {
      case 0:
        return receive(input);
      case 1:
        return write_parameter(input);
      case 2:
        return write_pdo(input);
      case 3:
        return report(input);
      case 4:
        return feeder_.pass(Duration(input.word() * 20));
      case 5:
        return change_controller();
      default:
        device_.inputs().set_level(input.byte() % 6, input.byte() % 2 == 1, feeder_.now());
        require(device_.inputs().waiting() <= queue_max + input_count);
        return node().advance(feeder_.now());
    }
  }

  /// Records for the outputs, NMT, SYNC, SDO requests, and the own CAN-ID.
  void receive(Input& input) {
    constexpr std::array<std::uint32_t, 6> likely = {0x400, 0x400,           0x000,
                                                     0x080, 0x600 + node_id, input_cob_id};
    Frame frame;
    frame.id = likely[input.byte() % likely.size()];
    frame.length = input.byte() % 4 == 0 ? static_cast<std::uint8_t>(input.byte() % 9)
                                         : static_cast<std::uint8_t>(frame.id == 0x400 ? 6 : 8);
    input.fill(std::span(frame.data).first(frame.length));
    if (frame.id == 0x400 && input.byte() % 2 == 0) frame.data[2] = 0x01;
    if (frame.id == 0x400 && input.byte() % 2 == 0) frame.data[3] = 0x03;
    feeder_.receive(frame);
  }
  void write_parameter(Input& input) {
    constexpr std::array<std::uint16_t, 11> objects = {
        0x6120, 0x6140, 0x6160, 0x6180, 0x6220, 0x6240, 0x6260, 0x6280, 0x6020, 0x6124, 0x6001};
    const std::uint16_t index = objects[input.byte() % objects.size()];
    feeder_.write(index, input.byte() % 7, input.word() | std::uint32_t{input.word()} << 16);
  }
  void write_pdo(Input& input) {
    const std::uint32_t valid = input.byte() % 2 == 0 ? 0x8000'0000 : 0;
    const bool sends = input.byte() % 2 == 0;
    const auto index = static_cast<std::uint16_t>(sends ? 0x1800 : 0x1400);
    feeder_.write(index, 1, valid | (sends ? input_cob_id : 0x400));
    feeder_.write(index, static_cast<std::uint8_t>(2 + input.byte() % 4), input.byte());
  }
  void report(Input& input) {
    const auto condition = static_cast<CallRequest>(input.byte() % 4);
    device_.inputs().report(input.byte() % 6, condition, feeder_.now(), input.byte());
    device_.outputs().report(input.byte() % 7, input.byte());
  }
  void change_controller() {
    full_ = !full_;
    if (!full_) node().tx_ready(feeder_.now());
  }

  /// As after power-on, with the present presses and defects: all of it is then reported.
  void settle_down() {
    if (full_) change_controller();
    node().advance(feeder_.now());
    node().command(NmtCommand::reset_node);
    feeder_.pass(1s);
    last_.fill(0);
    node().command(NmtCommand::start);
    feeder_.pass(1s);
    check();
    // More than backlog and queue can hold.
    change_controller();
    for (unsigned change = 0; change < 61; ++change) {
      device_.inputs().set_level(change % std::size(inputs), change / 4 % 2 == 0, feeder_.now());
    }
    change_controller();
    feeder_.pass(1s);
    check();
  }
  void check() {
    require(device_.inputs().waiting() == 0);
    for (std::uint32_t i = 0; i < std::size(inputs); ++i) {
      const VirtualInput input = device_.inputs().input(i);
      const bool was_told = last_[i] != 0;
      require(was_told || (input.request() == CallRequest::none && !input.locks()));
      require(!was_told || last_[i] == encode(input));
    }
  }

  static bool take(void* context, const Frame& frame) {
    auto& self = *static_cast<World*>(context);
    if (self.full_) return false;
    if (frame.id == input_cob_id) self.note(frame);
    return true;
  }
  static constexpr std::uint64_t but_for_data = 0xFF'FFFF'FFFF;
  void note(const Frame& frame) {
    require(frame.length == 6);
    std::uint64_t record = 0;
    for (unsigned i = 0; i < 6; ++i) record |= at_record_byte(i, frame.data[i]);
    for (std::size_t i = 0; i < std::size(inputs); ++i) {
      const bool is_it = (record & but_for_data) == (encode(inputs[i]) & but_for_data);
      if (is_it) last_[i] = record;
    }
  }

  bool full_ = false;
  std::array<std::uint64_t, std::size(inputs)> last_{};  ///< reported records
  PanelDevice<layout, queue_max> device_{
      {this, &World::take, nullptr}, node_id, {}, {.inputs = inputs}, {.outputs = outputs}};
  std::array<CreatedObject, 3> created_{};
  ObjectCreation creation_{device_.node(), creatable, created_};
  LiftNumber lift_number_{device_.node(), {}};
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
