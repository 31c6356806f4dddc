#include "canvoy/devices/cia417/panel/lift_panels.hpp"

namespace canvoy::cia417 {

namespace {

/// Records written one behind the other, as far as there is room.
template <class Record>
class List {
 public:
  explicit List(std::span<Record> room) : room_(room) {}
  void add(const Record& record) {
    if (used_ < room_.size()) room_[used_++] = record;
  }
  std::span<const Record> used() const { return room_.first(used_); }

 private:
  std::span<Record> room_;
  std::size_t used_ = 0;
};

template <class Record>
Record at_landing(const LandingPanel& panel, BasicFunction function, std::uint8_t sub_function) {
  return {.function = function,
          .sub_function = sub_function,
          .lifts = panel.lifts,
          .floor = panel.floor,
          .doors = at_doors(panel.doors)};
}
template <class Record>
Record in_car(const CarPanel& panel, BasicFunction function, std::uint8_t sub_function) {
  return {.function = function,
          .sub_function = sub_function,
          .lifts = lift_bit(panel.lift),
          .floor = floor_of_car};
}

/// Buttons and keys, or the lamps that acknowledge them: the records have the same bytes.
template <class Record>
void add_calls(const LandingPanel& panel, List<Record>& list) {
  if (panel.destinations) {
    for (unsigned floor = panel.lowest_floor; floor <= panel.highest_floor; ++floor) {
      const auto target = static_cast<std::uint8_t>(floor);
      if (target == panel.floor) continue;
      list.add(at_landing<Record>(panel, BasicFunction::standard_destination_call, target));
    }
  } else {
    const BasicFunction call = BasicFunction::standard_hall_call;
    if (panel.floor < panel.highest_floor) list.add(at_landing<Record>(panel, call, hall_up));
    if (panel.floor > panel.lowest_floor) list.add(at_landing<Record>(panel, call, hall_down));
  }
  if (!panel.fire_key) return;
  list.add(at_landing<Record>(panel, BasicFunction::special_function,
                              sub_function_of(SpecialFunction::fire_service)));
}
template <class Record>
void add_calls(const CarPanel& panel, List<Record>& list) {
  for (unsigned floor = panel.lowest_floor; floor <= panel.highest_floor; ++floor) {
    const auto target = static_cast<std::uint8_t>(floor);
    Record call = in_car<Record>(panel, BasicFunction::standard_car_call, target);
    call.doors = destination_doors(panel.doors);
    list.add(call);
  }
  constexpr SpecialFunction buttons[] = {SpecialFunction::door_open, SpecialFunction::door_close};
  constexpr SpecialFunction keys[] = {SpecialFunction::fire_service,
                                      SpecialFunction::attendant_service,
                                      SpecialFunction::vip_service};
  const auto add = [&](SpecialFunction function) {
    list.add(in_car<Record>(panel, BasicFunction::special_function, sub_function_of(function)));
  };
  for (const SpecialFunction function : buttons) add(function);
  if (!panel.keys) return;
  for (const SpecialFunction function : keys) add(function);
}

/// Keys stay in the position to which they are turned; buttons for doors do not.
std::span<const VirtualInput> with_locks(std::span<VirtualInput> inputs) {
  for (VirtualInput& input : inputs) {
    const bool is_key = input.function == BasicFunction::special_function &&
                        input.sub_function != sub_function_of(SpecialFunction::door_open) &&
                        input.sub_function != sub_function_of(SpecialFunction::door_close);
    if (is_key) input.data = VirtualInput::lock_bit;
  }
  return inputs;
}

}  // namespace

std::span<const VirtualInput> landing_inputs(const LandingPanel& panel,
                                             std::span<VirtualInput> inputs) {
  List<VirtualInput> list(inputs);
  add_calls(panel, list);
  return with_locks(inputs.first(list.used().size()));
}

std::span<const VirtualInput> car_inputs(const CarPanel& panel, std::span<VirtualInput> inputs) {
  List<VirtualInput> list(inputs);
  add_calls(panel, list);
  return with_locks(inputs.first(list.used().size()));
}

std::span<const VirtualOutput> landing_outputs(const LandingPanel& panel,
                                               std::span<VirtualOutput> outputs) {
  List<VirtualOutput> list(outputs);
  add_calls(panel, list);
  for (const BasicFunction function :
       {BasicFunction::position_indicator, BasicFunction::hall_lantern,
        BasicFunction::direction_indication, BasicFunction::special_indication,
        BasicFunction::arrival_indication}) {
    list.add(at_landing<VirtualOutput>(panel, function, 0));
  }
  return list.used();
}

std::span<const VirtualOutput> car_outputs(const CarPanel& panel,
                                           std::span<VirtualOutput> outputs) {
  List<VirtualOutput> list(outputs);
  add_calls(panel, list);
  for (const BasicFunction function :
       {BasicFunction::position_indicator, BasicFunction::direction_indication,
        BasicFunction::special_indication, BasicFunction::arrival_indication}) {
    list.add(in_car<VirtualOutput>(panel, function, 0));
  }
  return list.used();
}

}  // namespace canvoy::cia417
