// A whole input and output module of CiA 401.
//
//     IoDevice<> io(port, 33, {.digital_inputs = ..., .drive_digital = ...});
//     io.node().start(now);
//
// A maker has a kind of his own, with his identity and his number of inputs and outputs:
//
//     struct Valves : IoKind<IoOptions{.digital_outputs = 16}> {
//       static constexpr auto description = describe(io_module<...>(), cia301::identity({...}));
//     };
#pragma once

#include "canvoy/devices/cia401/io_module.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/device.hpp"

namespace canvoy::cia401 {

/// An IoUnit with memory for what its dictionary has.
template <const auto& layout>
class OwnIoUnit : public IoUnit {
 public:
  OwnIoUnit(Node& node, const IoHardware& hardware, const IoSettings& settings)
      : IoUnit(node, {inputs_, outputs_, analogue_inputs_, analogue_outputs}, hardware, settings) {}

 private:
  static constexpr std::size_t count(const ObjectInfo& object) {
    return canvoy::detail::highest_sub_index(layout.tables(), object.index);
  }
  static constexpr auto analogue_outputs =
      static_cast<unsigned>(count(write_analogue_output_16_bit_object));

  std::array<DigitalInputGroup, count(read_input_8_bit_object)> inputs_{};
  std::array<std::uint8_t, count(write_output_8_bit_object)> outputs_{};
  std::array<AnalogueInputState, count(read_analogue_input_16_bit_object)> analogue_inputs_{};
};

/// The default: as many as the default PDOs carry.
inline constexpr IoOptions default_io = {
    .digital_inputs = 64, .digital_outputs = 64, .analogue_inputs = 12, .analogue_outputs = 12};

template <IoOptions options = default_io>
struct IoKind : KindOf<IoUnit, IoHardware, IoSettings> {
  template <const auto& layout>
  using UnitOn = OwnIoUnit<layout>;

  static constexpr DeviceInfo info = {.name = "io-401",
                                      .title = "input and output module",
                                      .product = "Canvoy CiA 401 module",
                                      .product_code = 401,
                                      .node_id = 33,
                                      .hardware = "digital and analogue inputs and outputs"};
  static constexpr auto description = describe(
      io_module<options>(), cia301::identity({.product_code = info.product_code}),
      cia301::names(
          {.device = info.product, .hardware_version = "simulated", .software_version = "0.1.0"}),
      cia301::sync_consumer(), cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(2),
      cia301::emergency(), cia301::error_history(8), cia301::error_behavior());

  /// Nothing is wired.
  static constexpr IoHardware simulated() {
    return {.digital_inputs = {[](void*, unsigned) -> std::uint8_t { return 0; }, nullptr},
            .drive_digital = {[](void*, unsigned, std::uint8_t) {}, nullptr},
            .analogue_input = {[](void*, unsigned) -> std::int32_t { return 0; }, nullptr},
            .drive_analogue = {[](void*, unsigned, std::int32_t) {}, nullptr}};
  }
};

/// `layout` is that of a description with the objects of a module.
template <IoOptions options = default_io, const auto& layout = layout_of<IoKind<options>>,
          std::size_t own_routes = 0>
using IoDevice = Device<IoKind<options>, layout, own_routes>;

}  // namespace canvoy::cia401
