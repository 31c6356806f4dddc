#include "canvoy/devices/cia852/kinds.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "canvoy/canopen/device/heap_node.hpp"
#include "canvoy/devices/cia852/operator_device.hpp"
#include "canvoy/devices/kit/part_tables.hpp"
#include "canvoy/devices/kit/program_place.hpp"
#include "canvoy/profiles/cia302/program.hpp"

namespace canvoy::cia852 {

namespace {

constexpr unsigned every_node = 127;

/// Parts in the order of their arrival.
struct PartList {
  std::vector<Part> parts;

  void add(const Part& part) { parts.push_back(part); }
  template <std::size_t count>
  void add(const DeviceDescription<count>& more) {
    parts.insert(parts.end(), more.begin(), more.end());
  }
  void add_pdo(const Part& parameter, const Part& mapping) {
    add(parameter);
    add(mapping);
  }
};

/// A device in memory from the heap.
class OperatorOnHeap {
 public:
  OperatorOnHeap(const Port& port, NodeId node_id, const Environment& environment)
      : elements_(environment.get<OperatorEnvironment>(usual_elements)),
        tables_(operator_parts(elements_, environment.keeps_parameters)),
        device_(tables_.tables(), port, node_id, catalogue_routes),
        inputs_(count(read_input_8_bit_object)),
        indicators_(count(write_output_8_bit_object)),
        analogue_inputs_(count(read_analogue_input_16_bit_object)),
        encoders_(elements_.encoders),
        unit_(device_.node(),
              {{inputs_, indicators_, analogue_inputs_, elements_.displays > 0,
                elements_.display_floats ? &reals_ : nullptr},
               encoders_},
              environment.get<OperatorHardware>(), environment.get<OperatorSettings>()) {
    take_programs(environment.get<ProgramPlace>());
    environment.made<OperatorUnit>(unit_, device_.node());
  }

  Node& node() { return device_.node(); }
  EmergencyProducer& emergency_producer() { return device_.emergency_producer(); }

 private:
  std::size_t count(const ObjectInfo& object) const {
    return cia401::detail::count_elements(device_.tables(), object);
  }

  void take_programs(const ProgramPlace& place) {
    if (!elements_.program_download || place.flash == nullptr) return;
    slots_[0].size = place.size;
    programs_.emplace(device_.node(), *place.flash, slots_, place.hooks);
  }

  OperatorEnvironment elements_;
  PartTables tables_;
  HeapNode device_;
  std::vector<cia401::DigitalInputGroup> inputs_;
  std::vector<std::uint8_t> indicators_;
  std::vector<cia401::AnalogueInputState> analogue_inputs_;
  cia401::AnalogueReals reals_ = cia401::AnalogueReals::calls;
  std::vector<EncoderInputs::State> encoders_;
  OperatorUnit unit_;
  std::array<ProgramSlot, 1> slots_{};
  std::optional<ProgramServer> programs_;
};

template <bool keeps>
inline constexpr DeviceForm operator_form[1] = {
    {.parts =
         [] {
           // They live as long as the program.
           static const auto& parts = *new std::vector<Part>(operator_parts(usual_elements, keeps));
           return std::span<const Part>(parts);
         },
     .bytes = sizeof(OperatorOnHeap),
     .make = [](void* memory, const Port& port, NodeId node_id,
                const Environment& environment) -> MadeDevice {
       auto* const made =
           std::construct_at(static_cast<OperatorOnHeap*>(memory), port, node_id, environment);
       return {&made->node(), &made->emergency_producer()};
     },
     .end = [](void* memory) { std::destroy_at(static_cast<OperatorOnHeap*>(memory)); }}};

}  // namespace

std::vector<Part> operator_parts(const OperatorEnvironment& elements, bool keeps_parameters) {
  PartList list;
  list.parts.reserve(capacity_for(elements));
  list.add(cia301::identity({.product_code = operator_info.product_code}));
  list.add(cia301::names({.device = operator_info.product,
                          .hardware_version = "simulated",
                          .software_version = "0.1.0"}));
  list.add(sync_window_object);
  add_operator_module(list, elements, every_node);
  if (keeps_parameters) list.add(cia301::storage(storage_groups));
  if (elements.program_download) list.add(cia302::programs(1));
  std::ranges::sort(list.parts, {}, &Part::index);
  return std::move(list.parts);
}

const DeviceKind operator_kind = {.info = operator_info,
                                  .profile = &profile,
                                  .forms = operator_form<false>,
                                  .keeping_forms = operator_form<true>};

}  // namespace canvoy::cia852
