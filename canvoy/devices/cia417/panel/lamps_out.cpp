#include "canvoy/devices/cia417/panel/lamps_out.hpp"

namespace canvoy::cia417 {

namespace {

constexpr std::uint8_t all_target_stops = 0xFF;
constexpr std::uint8_t all_doors = 0xFF;

void name_lamps_of_call(VirtualOutput& output, unsigned number) {
  const auto first = static_cast<unsigned>(BasicFunction::standard_hall_call);
  output.function = static_cast<BasicFunction>(first + number);
  const bool is_car_call = is_between(output.function, BasicFunction::standard_car_call,
                                      BasicFunction::high_priority_car_call);
  output.sub_function = is_hall_call(output.function) ? hall_undirected : all_target_stops;
  output.floor = is_car_call ? floor_of_car : all_floors;
}

}  // namespace

VirtualOutput LampsOut::next(std::uint8_t lifts) {
  VirtualOutput output{.lifts = lifts, .doors = all_doors, .data = output_data(false)};
  unsigned number = position_++;
  if (number < call_functions) {
    name_lamps_of_call(output, number);
    return output;
  }
  number -= call_functions;
  output.floor = number % 2 == 0 ? floor_of_car : all_floors;
  if (number < 2 * special_functions) {
    output.function = BasicFunction::special_function;
    output.sub_function = static_cast<std::uint8_t>(1 + number / 2);
    return output;
  }
  number -= 2 * special_functions;
  if (number < 2) {
    output.function = BasicFunction::special_indication;
    output.sub_function = sub_function_of(SpecialIndication::all_off);
    return output;
  }
  output.function = BasicFunction::hall_lantern;
  output.sub_function = arrow_up | arrow_down;
  output.floor = all_floors;
  return output;
}

}  // namespace canvoy::cia417
