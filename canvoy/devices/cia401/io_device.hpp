// A whole input and output module of CiA 401.
//
//     IoDevice<> io(port, 33, {.digital_inputs = ..., .drive_digital = ...});
//     io.node().start(now);
//
// A maker has a separate kind, with its own identity and number of inputs and outputs:
//
//     struct Valves : IoKind<IoOptions{.digital_outputs = 16}> {
//       static constexpr auto description = describe(
//           io_module<IoOptions{.digital_outputs = 16}>(), cia301::identity({.vendor_id = 0x123}),
//           cia301::heartbeat_producer(1000));
//     };
#pragma once

#include <algorithm>

#include "canvoy/devices/cia401/analogue_reals.hpp"
#include "canvoy/devices/cia401/io_unit.hpp"
#include "canvoy/devices/kit/device.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia301/predefined_pdo.hpp"
#include "canvoy/profiles/cia401.hpp"

namespace canvoy::cia401 {

// The objects of an input and output module of CiA 401, by its number of inputs and outputs.
//
//     constexpr auto module = describe(io_module<IoOptions{.digital_inputs = 16}>(),
//                                      cia301::identity({.vendor_id = 0x123}));
//
// The text of CiA 401 is not at hand. The PDOs that exist at the start are common practice.

/// Digital inputs and outputs come in groups of 8.
struct IoOptions {
  unsigned digital_inputs = 0;    ///< 0 to 2032
  unsigned digital_outputs = 0;   ///< 0 to 2032
  unsigned analogue_inputs = 0;   ///< 0 to 254
  unsigned analogue_outputs = 0;  ///< 0 to 254
  /// Adds the objects of 16 and 32 bits for the same digital inputs and outputs, and those of 8 and
  /// 32 bits and floating-point numbers for analogue ones.
  bool all_widths = false;
  /// Adds the objects of single bits for the first 1,024 digital inputs.
  bool single_bits = false;
};

/// Value of 1000h: 401, and a bit for each kind of inputs and outputs (bits 16 to 19).
constexpr std::uint32_t device_type_of(const IoOptions& options) {
  return profile_number | static_cast<std::uint32_t>(options.digital_inputs != 0) << 16 |
         static_cast<std::uint32_t>(options.digital_outputs != 0) << 17 |
         static_cast<std::uint32_t>(options.analogue_inputs != 0) << 18 |
         static_cast<std::uint32_t>(options.analogue_outputs != 0) << 19;
}

namespace detail {

constexpr unsigned in_groups(unsigned channels, unsigned of) {
  return (channels + of - 1) / of;
}

template <std::size_t capacity, std::size_t count>
constexpr void add_arrays(DeviceDescription<capacity>& parts, unsigned channels,
                          const ObjectInfo* const (&objects)[count]) {
  if (channels == 0) return;
  for (const ObjectInfo* object : objects) parts.add(Part(*object).up_to(channels));
}

/// 128 inputs in each object; the last has the remaining ones.
template <std::size_t capacity>
constexpr void add_bits(DeviceDescription<capacity>& parts, unsigned inputs) {
  constexpr unsigned of_object = 128;
  for (unsigned i = 0; i < read_input_bit_object.count && i * of_object < inputs; ++i) {
    const unsigned left = in_groups(inputs, 8) * 8 - i * of_object;
    parts.add(Part(read_input_bit_object).only(i).up_to(std::min(left, of_object)));
  }
}

/// The PDO at this position of the profile's list, with those of its objects that the device has.
template <std::size_t position, std::size_t capacity>
constexpr void add_pdo(DeviceDescription<capacity>& parts, unsigned channels, unsigned before) {
  if (channels <= before) return;
  using Objects = canvoy::detail::PredefinedPdo<canvoy::detail::ListedPdo<profile, position>>;
  constexpr auto room = static_cast<unsigned>(profile.pdos[position].mapping.size());
  const unsigned mapped = std::min(room, channels - before);
  parts.add_pdo(Objects::parameter, Part(Objects::mapping).up_to(mapped).initial(mapped));
}

}  // namespace detail

/// All objects of the profile in such a module, and its default PDOs.
template <IoOptions options>
constexpr auto io_module() {
  using namespace detail;  // NOLINT(google-build-using-namespace)
  constexpr unsigned inputs = in_groups(options.digital_inputs, 8);
  constexpr unsigned outputs = in_groups(options.digital_outputs, 8);
  constexpr unsigned analogue_inputs = options.analogue_inputs;
  constexpr unsigned analogue_outputs = options.analogue_outputs;
  constexpr std::size_t more_bits = read_input_bit_object.count;
  DeviceDescription<2 + profile.objects.size() + more_bits + 2 * profile.pdos.size()> parts;
  parts.add(Part(cia301::device_type_object).initial(device_type_of(options)));
  parts.add(cia301::error_register_object);

  add_arrays(parts, inputs,
             {&read_input_8_bit_object, &polarity_input_8_bit_object,
              &filter_constant_input_8_bit_object, &interrupt_mask_any_change_8_bit_object,
              &interrupt_mask_low_to_high_8_bit_object, &interrupt_mask_high_to_low_8_bit_object});
  if (inputs != 0) parts.add(global_interrupt_enable_digital_object);
  add_arrays(parts, outputs,
             {&write_output_8_bit_object, &change_polarity_output_8_bit_object,
              &error_mode_output_8_bit_object, &error_value_output_8_bit_object,
              &filter_mask_output_8_bit_object});
  add_arrays(
      parts, analogue_inputs,
      {&read_analogue_input_16_bit_object, &analogue_input_interrupt_trigger_selection_object,
       &analogue_input_interrupt_upper_limit_integer_object,
       &analogue_input_interrupt_lower_limit_integer_object,
       &analogue_input_interrupt_delta_unsigned_object,
       &analogue_input_interrupt_negative_delta_unsigned_object,
       &analogue_input_interrupt_positive_delta_unsigned_object,
       &analogue_input_offset_integer_object, &analogue_input_scaling_integer_object});
  if (analogue_inputs != 0) {
    parts.add(Part(analogue_input_interrupt_source_object).up_to(in_groups(analogue_inputs, 32)));
    parts.add(analogue_input_global_interrupt_enable_object);
  }
  add_arrays(parts, analogue_outputs,
             {&write_analogue_output_16_bit_object, &analogue_output_error_mode_object,
              &analogue_output_error_value_integer_object, &analogue_output_offset_integer_object,
              &analogue_output_scaling_integer_object});

  if (options.all_widths) {
    add_arrays(
        parts, in_groups(options.digital_inputs, 16),
        {&read_input_16_bit_object, &polarity_input_16_bit_object,
         &filter_constant_input_16_bit_object, &interrupt_mask_any_change_16_bit_object,
         &interrupt_mask_low_to_high_16_bit_object, &interrupt_mask_high_to_low_16_bit_object});
    add_arrays(
        parts, in_groups(options.digital_inputs, 32),
        {&read_input_32_bit_object, &polarity_input_32_bit_object,
         &filter_constant_input_32_bit_object, &interrupt_mask_any_change_32_bit_object,
         &interrupt_mask_low_to_high_32_bit_object, &interrupt_mask_high_to_low_32_bit_object});
    add_arrays(parts, in_groups(options.digital_outputs, 16),
               {&write_output_16_bit_object, &change_polarity_output_16_bit_object,
                &error_mode_output_16_bit_object, &error_value_output_16_bit_object,
                &filter_mask_output_16_bit_object});
    add_arrays(parts, in_groups(options.digital_outputs, 32),
               {&write_output_32_bit_object, &change_polarity_output_32_bit_object,
                &error_mode_output_32_bit_object, &error_value_output_32_bit_object,
                &filter_mask_output_32_bit_object});
    add_arrays(
        parts, analogue_inputs,
        {&read_analogue_input_8_bit_object, &read_analogue_input_32_bit_object,
         &read_analogue_input_float_object, &analogue_input_interrupt_upper_limit_float_object,
         &analogue_input_interrupt_lower_limit_float_object,
         &analogue_input_interrupt_delta_float_object,
         &analogue_input_interrupt_negative_delta_float_object,
         &analogue_input_interrupt_positive_delta_float_object, &analogue_input_offset_float_object,
         &analogue_input_scaling_float_object, &analogue_input_si_unit_object});
    add_arrays(parts, analogue_outputs,
               {&write_analogue_output_8_bit_object, &write_analogue_output_32_bit_object,
                &write_analogue_output_float_object, &analogue_output_error_value_float_object,
                &analogue_output_offset_float_object, &analogue_output_scaling_float_object,
                &analogue_output_si_unit_object});
  }

  if (options.single_bits) add_bits(parts, options.digital_inputs);

  add_pdo<0>(parts, outputs, 0);
  add_pdo<1>(parts, analogue_outputs, 0);
  add_pdo<2>(parts, analogue_outputs, 4);
  add_pdo<3>(parts, analogue_outputs, 8);
  add_pdo<4>(parts, inputs, 0);
  add_pdo<5>(parts, analogue_inputs, 0);
  add_pdo<6>(parts, analogue_inputs, 4);
  add_pdo<7>(parts, analogue_inputs, 8);
  return parts;
}

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
