// A whole operator environment interface module of CiA 852, with the elements that its maker
// selects.
//
//     constexpr cia852::OperatorEnvironment elements = {.joysticks = 2, .indicator_clusters = 1};
//     cia852::OperatorDevice<elements> seat(port, 10, hardware);
//     seat.node().start(now);
//
// A maker has a separate kind, with its own identity:
//
//     struct Seat : cia852::OperatorKind<elements> {
//       static constexpr auto description =
//           describe(cia852::operator_module<elements>(), cia301::identity({.vendor_id = 0x123}));
//     };
#pragma once

#include "canvoy/devices/cia401/io_device.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/profiles/cia852/operator_environment.hpp"

namespace canvoy::cia852 {

inline constexpr std::uint16_t usual_heartbeat_ms = 1000;  ///< default of 1017h
inline constexpr unsigned usual_errors_kept = 8;           ///< length of 1003h
inline constexpr unsigned usual_nodes_watched = 2;         ///< entries of 1016h, with outputs

/// Objects of Annex A beside those of the elements, and names; all except the identity. 1028h of
/// those with outputs has room for the node-IDs up to `emergency_nodes`.
template <class Parts>
constexpr void add_operator_module(Parts& parts, const OperatorEnvironment& has,
                                   unsigned emergency_nodes) {
  add_operator_environment(parts, has);
  parts.add(cia301::heartbeat_producer(usual_heartbeat_ms));
  parts.add(cia301::error_history(usual_errors_kept));
  if (!has_outputs(has)) return;
  parts.add(cia301::heartbeat_consumers(usual_nodes_watched));
  parts.add(cia301::emergency_consumers(emergency_nodes));
}
/// For a device that is known at compile time.
template <OperatorEnvironment has, unsigned emergency_nodes = 1>
constexpr auto operator_module() {
  check_elements(has);
  constexpr std::size_t beside = 4;
  DeviceDescription<capacity_for(has) + beside> parts;
  parts.add(cia301::profile);
  parts.add(profile);
  add_operator_module(parts, has, emergency_nodes);
  return parts;
}

/// An OperatorUnit with memory for its dictionary.
template <const auto& layout>
class OwnOperatorMemory {
 public:
  operator OperatorMemory() { return {io_, encoders_}; }  // NOLINT(google-explicit-constructor)

 private:
  static constexpr std::size_t encoders =
      cia401::detail::count_elements(layout.tables(), read_input_32_bit_object);

  cia401::OwnIoMemory<layout> io_;
  std::array<EncoderInputs::State, encoders> encoders_{};
};
/// An OperatorUnit with its memory.
template <const auto& layout>
class OwnOperatorUnit : private OwnOperatorMemory<layout>, public OperatorUnit {
 public:
  /// Makes the unit; everything to which `hardware` refers must outlive it.
  OwnOperatorUnit(Node& node, const OperatorHardware& hardware, const OperatorSettings& settings)
      : OperatorUnit(node, static_cast<OwnOperatorMemory<layout>&>(*this), hardware, settings) {}
};

inline constexpr DeviceInfo operator_info = {
    .name = "operator",
    .title = "operator environment: seat, cabin or remote control",
    .product = "Canvoy operator environment",
    .product_code = 852,
    .node_id = 10,
    .hardware = "joysticks, foot pedals, encoders, wheels, push-buttons, indicators, displays"};

/// Kind of a module with these elements.
template <OperatorEnvironment has>
struct OperatorKind : KindOf<OperatorUnit, OperatorHardware, OperatorSettings> {
  /// The unit for a dictionary, with memory for it.
  template <const auto& layout>
  using UnitOn = OwnOperatorUnit<layout>;

  static constexpr DeviceInfo info = operator_info;
  /// The objects of the module, with the identity of the catalogue's.
  static constexpr auto description =
      describe(operator_module<has>(), cia301::identity({.product_code = info.product_code}));
};

/// `layout` has a description with the objects of such a module.
template <OperatorEnvironment has, const auto& layout = layout_of<OperatorKind<has>>,
          std::size_t own_routes = 0>
using OperatorDevice = Device<OperatorKind<has>, layout, own_routes>;

}  // namespace canvoy::cia852
