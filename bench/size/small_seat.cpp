// An operator seat (CiA 852 on CiA 401) beside the small nodes: two joysticks with eight buttons
// each, and a cluster of which eight indicators are used; with all that Annex A requires, and LSS.
#include "bench/size/small_node.hpp"
#include "canvoy/devices/cia852/operator_device.hpp"

namespace canvoy {

constexpr cia852::OperatorEnvironment seat = {.joysticks = 2, .indicator_clusters = 1};
using SeatKind = cia852::OperatorKind<seat>;
inline constexpr auto node_tables = layout_of<SeatKind>;
/// Not linked; the report reads its size.
extern const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes;
const std::array<std::uint8_t, node_tables.value_bytes> node_value_bytes{};

/// Empty stubs of its pins.
struct SeatPins {
  std::int16_t axis(unsigned, unsigned) { return read; }
  std::uint8_t buttons(unsigned) { return static_cast<std::uint8_t>(read); }
  void show(unsigned, unsigned, std::uint8_t lit) { shown = lit; }

  volatile std::int16_t read = 0;
  volatile std::uint8_t shown = 0;
};
/// Node-ID and bit rate are set by LSS (CiA 852, 6.2, 8.2).
struct SeatDevice {
  SeatDevice(const Port& port, const cia852::OperatorHardware& hardware)
      : device(port, node_id_unconfigured, hardware) {}

  cia852::OperatorDevice<seat, node_tables, LssSlave::routes> device;
  LssSlave lss{device.node()};
};

}  // namespace canvoy

using namespace canvoy;  // NOLINT(google-build-using-namespace): this is the program

static SeatPins the_pins;
alignas(SeatDevice) static std::byte the_memory[sizeof(SeatDevice)];

int main() {
  using cia852::OperatorHardware;
  auto* const device = new (the_memory) SeatDevice(
      {nullptr, board_send, nullptr},
      OperatorHardware{
          .joystick_axis =
              Callback<std::int16_t(unsigned, unsigned)>::to<&SeatPins::axis>(the_pins),
          .joystick_buttons = Callback<std::uint8_t(unsigned)>::to<&SeatPins::buttons>(the_pins),
          .show_indicators =
              Callback<void(unsigned, unsigned, std::uint8_t)>::to<&SeatPins::show>(the_pins)});
  run_on_board(device->device.node());
}
