// A whole input and output module of CiA 401.
//
//     IoDevice<> io(port, 33, {.digital_inputs = ..., .drive_digital = ...});
//     io.node().start(now);
//
// A maker has a separate kind, with its own identity and number of inputs and outputs:
//
//     struct Valves : IoKind<IoOptions{.digital_outputs = 16}> {
//       static constexpr auto description = describe(io_module<...>(), cia301::identity({...}));
//     };
#pragma once

#include "canvoy/devices/cia401/analogue_reals.hpp"
#include "canvoy/devices/cia401/io_module.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/kit/device.hpp"

namespace canvoy::cia401 {

namespace detail {

/// Number of elements of an array, without sub-index 00h.
constexpr std::size_t count_elements(const DictionaryTables& tables, const ObjectInfo& object) {
  std::size_t count = 0;
  for (const ObjectRow& row : tables.objects) {
    if (row.index != object.index) continue;
    for (const EntryShape& entry : tables.entries_of(row)) {
      if (entry.sub_first > 0) count += entry.sub_last - entry.sub_first + 1U;
    }
  }
  return count;
}

}  // namespace detail

/// Without such objects, a device links nothing of it.
template <bool has_reals>
struct OwnReals {
  /// Null: no floating-point objects.
  AnalogueReals* get() { return nullptr; }
};
/// With floating-point objects.
template <>
struct OwnReals<true> {
  /// For IoUnit; valid as long as this object.
  AnalogueReals* get() { return &reals; }

  /// The functions, and which outputs have such a value.
  AnalogueReals reals = AnalogueReals::calls;
};

/// The memory that an IoUnit needs for a dictionary.
template <const auto& layout>
class OwnIoMemory {
 public:
  operator IoMemory() {  // NOLINT(google-explicit-constructor)
    return {inputs_, outputs_, analogue_inputs_, count(write_analogue_output_16_bit_object) != 0,
            reals_.get()};
  }

 private:
  static constexpr std::size_t count(const ObjectInfo& object) {
    return detail::count_elements(layout.tables(), object);
  }
  static constexpr bool has_reals = count(read_analogue_input_float_object) != 0 ||
                                    count(write_analogue_output_float_object) != 0;

  std::array<DigitalInputGroup, count(read_input_8_bit_object)> inputs_{};
  std::array<std::uint8_t, count(write_output_8_bit_object)> outputs_{};
  std::array<AnalogueInputState, count(read_analogue_input_16_bit_object)> analogue_inputs_{};
  [[no_unique_address]] OwnReals<has_reals> reals_;
};

/// An IoUnit with its memory.
template <const auto& layout>
class OwnIoUnit : private OwnIoMemory<layout>, public IoUnit {
 public:
  /// Makes the unit; everything to which `hardware` refers must outlive it.
  OwnIoUnit(Node& node, const IoHardware& hardware, const IoSettings& settings)
      : IoUnit(node, static_cast<OwnIoMemory<layout>&>(*this), hardware, settings) {}
};

/// The default: as many inputs and outputs as the default PDOs carry.
inline constexpr IoOptions default_io = {
    .digital_inputs = 64, .digital_outputs = 64, .analogue_inputs = 12, .analogue_outputs = 12};

/// Kind of a module with these inputs and outputs.
template <IoOptions options = default_io>
struct IoKind : KindOf<IoUnit, IoHardware, IoSettings> {
  /// The unit for a dictionary, with memory for it.
  template <const auto& layout>
  using UnitOn = OwnIoUnit<layout>;

  static constexpr DeviceInfo info = {.name = "io-401",  ///< of the catalogue
                                      .title = "input and output module",
                                      .product = "Canvoy CiA 401 module",
                                      .product_code = 401,
                                      .node_id = 33,
                                      .hardware = "digital and analogue inputs and outputs"};
  /// The objects of the module, beside those of the profile those of an ordinary node.
  static constexpr auto description = describe(
      io_module<options>(), cia301::identity({.product_code = info.product_code}),
      cia301::names(
          {.device = info.product, .hardware_version = "simulated", .software_version = "0.1.0"}),
      cia301::sync_consumer(), cia301::heartbeat_producer(1000), cia301::heartbeat_consumers(2),
      cia301::emergency(), cia301::error_history(8), cia301::error_behavior());

  /// Keeps TPDOs of analogue inputs back at the start while 6423h disables their events.
  template <class Services>
  static void connect(Services& services, IoUnit& /*unit*/) {
    if constexpr (requires { services.tpdos(); }) services.tpdos().ask_at_start(tpdo_may_begin);
  }
  /// Hardware without any wiring.
  static constexpr IoHardware simulated() {
    return {.digital_inputs = {[](void*, unsigned) -> std::uint8_t { return 0; }, nullptr},
            .drive_digital = {[](void*, unsigned, std::uint8_t) {}, nullptr},
            .analogue_input = {[](void*, unsigned) -> std::int32_t { return 0; }, nullptr},
            .drive_analogue = {[](void*, unsigned, std::int32_t) {}, nullptr}};
  }
};

/// `layout` has a description with the objects of a module.
template <IoOptions options = default_io, const auto& layout = layout_of<IoKind<options>>,
          std::size_t own_routes = 0>
using IoDevice = Device<IoKind<options>, layout, own_routes>;

}  // namespace canvoy::cia401
