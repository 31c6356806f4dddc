#include "canvoy/devices/cia417/lift/lift_display.hpp"

#include <bit>

namespace canvoy::cia417 {

namespace {

constexpr std::uint8_t places[] = {floor_of_car, all_floors};

/// Indications only for passengers in the car.
constexpr SpecialIndications of_car = indication_bit(SpecialIndication::no_load) |
                                      indication_bit(SpecialIndication::overload) |
                                      indication_bit(SpecialIndication::load_time) |
                                      indication_bit(SpecialIndication::help_is_coming);

std::uint8_t arrow(Direction direction) {
  if (direction == Direction::up) return arrow_up;
  return direction == Direction::down ? arrow_down : std::uint8_t{0};
}

}  // namespace

void LiftIndications::ring(std::uint8_t floor, DoorMask doors, Direction direction) {
  ring_ = {floor, doors, direction == Direction::down ? Direction::down : Direction::up};
  rings_in_car_ = true;
}

LiftIndications::Lantern LiftIndications::wanted_lantern() const {
  if (display.lantern_floor == 0 || display.lantern == Direction::none) return {};
  return {display.lantern_floor, display.lantern_doors, display.lantern};
}

SpecialIndications LiftIndications::untold_specials(unsigned place) const {
  const unsigned ours = places[place] == floor_of_car ? ~0U : ~unsigned{of_car};
  const unsigned changed = display.specials ^ unsigned { told_[place].specials };
  return static_cast<SpecialIndications>((changed | told_[place].again) & ours);
}

bool LiftIndications::waits() const {
  for (unsigned place = 0; place < 2; ++place) {
    const Told& told = told_[place];
    if (!told.knows_floor || told.floor != display.floor || !told.knows_direction ||
        told.direction != display.direction || told.moving != display.moving ||
        untold_specials(place) != 0) {
      return true;
    }
  }
  return !out_again_.empty() || lantern_ != wanted_lantern() || ring_.floor != 0 || rings_in_car_;
}

VirtualOutput LiftIndications::next() {
  VirtualOutput output{.lifts = lift_, .doors = at_doors(0x0F), .data = output_data(true)};
  for (unsigned place = 0; place < 2; ++place) {
    Told& told = told_[place];
    output.floor = places[place];
    if (!told.knows_floor || told.floor != display.floor) {
      told.knows_floor = true;
      told.floor = output.sub_function = display.floor;
      output.function = BasicFunction::position_indicator;
      return output;
    }
    if (!told.knows_direction || told.direction != display.direction ||
        told.moving != display.moving) {
      told.knows_direction = true;
      told.direction = display.direction;
      told.moving = display.moving;
      output.function = BasicFunction::direction_indication;
      output.sub_function = static_cast<std::uint8_t>(arrow(display.direction) |
                                                      (display.moving ? arrow_moving : 0U));
      output.data = output_data(output.sub_function != 0);
      return output;
    }
    if (untold_specials(place) != 0) return next_special(place);
  }
  return next_lantern();
}

VirtualOutput LiftIndications::next_special(unsigned place) {
  const auto number = static_cast<unsigned>(std::countr_zero(untold_specials(place)));
  const auto bit = static_cast<SpecialIndications>(1U << number);
  Told& told = told_[place];
  const auto others = static_cast<SpecialIndications>(~unsigned{bit});
  told.again &= others;
  told.specials = static_cast<SpecialIndications>((told.specials & others) |
                                                  (display.specials & unsigned{bit}));
  told.were_on |= told.specials;
  return {.function = BasicFunction::special_indication,
          .sub_function = static_cast<std::uint8_t>(number),
          .lifts = lift_,
          .floor = places[place],
          .doors = at_doors(0x0F),
          .data = output_data((told.specials & bit) != 0)};
}

VirtualOutput LiftIndications::next_lantern_out() {
  const std::uint8_t floor = out_again_.lowest();
  out_again_.erase(floor);
  return {.function = BasicFunction::hall_lantern,
          .sub_function = arrow_up | arrow_down,
          .lifts = lift_,
          .floor = floor,
          .doors = at_doors(0x0F),
          .data = output_data(false)};
}

/// A lit lantern is switched off before another one is lit; then it rings.
VirtualOutput LiftIndications::next_lantern() {
  if (!out_again_.empty()) return next_lantern_out();
  const Lantern wanted = wanted_lantern();
  VirtualOutput output{.function = BasicFunction::hall_lantern, .lifts = lift_};
  if (lantern_ != wanted) {
    const bool goes_out = lantern_.floor != 0;
    const Lantern shown = goes_out ? lantern_ : wanted;
    lantern_ = goes_out ? Lantern{} : wanted;
    were_lit_.insert(shown.floor);
    output.sub_function = arrow(shown.direction);
    output.floor = shown.floor;
    output.doors = at_doors(shown.doors);
    output.data = output_data(!goes_out);
    return output;
  }
  output.function = BasicFunction::arrival_indication;
  output.sub_function = arrow(ring_.direction);
  output.doors = at_doors(ring_.doors);
  output.data = output_data(true, Property::impulse);
  if (rings_in_car_) {
    rings_in_car_ = false;
    return output;
  }
  output.floor = ring_.floor;
  ring_ = {};
  return output;
}

void LiftIndications::report_again() {
  for (Told& told : told_) {
    told.knows_floor = told.knows_direction = false;
    told.again = told.were_on;
  }
  out_again_ = were_lit_;
  out_again_.erase(lantern_.floor);
  if (lantern_ == wanted_lantern()) lantern_ = {};
}

void LiftIndications::forget() {
  told_[0] = told_[1] = {};
  lantern_ = ring_ = {};
  were_lit_ = out_again_ = {};
  rings_in_car_ = false;
}

}  // namespace canvoy::cia417
