// Arbitrary frames, SDO requests, writes and times, passed to a device of the catalogue: the first
// byte selects it. A new kind in the catalogue is included without a further line.
//
// Beside what the sanitizers detect: it comes to rest, is in a defined state, and keeps its
// identity (1000h, 1018h).
#include <cstdint>
#include <span>

#include "canvoy/devices/catalogue.hpp"
#include "fuzz/input.hpp"
#include "fuzz/node_feeder.hpp"

namespace canvoy::fuzz {
namespace {

constexpr int steps_max = 1000;

class Bench {
 public:
  explicit Bench(const DeviceKind& kind)
      : device_(kind, nowhere(), kind.node_id(environment_), environment_) {
    feeder_.receive(Frame::data_frame(0, {}));
    node().command(NmtCommand::start);
    device_type_ = number(0x1000, 0);
    product_code_ = number(0x1018, 2);
  }

  void step(Input& input) {
    switch (input.byte() % 8) {
      case 0:
      case 1:
      case 2:
        return receive(input, input.word() % 0x800);
      case 3:
        return receive(input, 0x600U + node().id());
      case 4:
        return feeder_.pass(Duration(std::int64_t{input.word()} * 100));
      case 5:
        return write_some(input);
      case 6:
        return receive(input, 0x180U + input.byte() % 0x80 + 0x80U * (input.byte() % 8));
      default:
        return node().bus_state(static_cast<BusState>(input.byte() % 4), feeder_.now());
    }
  }

  void check() {
    feeder_.pass(Duration{0});
    require(number(0x1000, 0) == device_type_);
    require(number(0x1018, 2) == product_code_);
  }

 private:
  static Port nowhere() {
    return {nullptr, [](void*, const Frame&) { return true; }, nullptr};
  }
  Node& node() { return device_.node(); }
  std::uint64_t number(std::uint16_t index, std::uint8_t sub) {
    return node().dictionary().number(index, sub);
  }
  void receive(Input& input, std::uint32_t can_id) {
    Frame frame = Frame::data_frame(can_id, {});
    frame.length = static_cast<std::uint8_t>(input.byte() % 9);
    input.fill({frame.data.data(), frame.length});
    feeder_.receive(frame);
  }
  /// Writes an existing object.
  void write_some(Input& input) {
    const std::span<const ObjectRow> objects = node().dictionary().tables().objects;
    const ObjectRow& object = objects[input.word() % objects.size()];
    const std::uint8_t sub = input.byte() % 16;
    const std::uint64_t low = input.word();
    feeder_.write(object.index, sub, low | std::uint64_t{input.word()} << 16);
  }

  Environment environment_;
  CatalogueDevice device_;
  NodeFeeder feeder_{device_.node()};
  std::uint64_t device_type_ = 0;
  std::uint64_t product_code_ = 0;
};

}  // namespace
}  // namespace canvoy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy;
  fuzz::Input input(data, size);
  const std::span<const DeviceKind* const> kinds = device_catalogue();
  fuzz::Bench bench(*kinds[input.byte() % kinds.size()]);
  for (int steps = 0; !input.empty() && steps < fuzz::steps_max; ++steps) {
    bench.step(input);
    bench.check();
  }
  return 0;
}
