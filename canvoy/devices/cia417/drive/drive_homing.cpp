#include "canvoy/devices/cia417/drive/drive_homing.hpp"

#include <iterator>

namespace canvoy::cia417 {

namespace {

/// The edge of a home switch that counts, its direction, and the start of the search while the
/// switch is off.
struct SwitchSearch {
  bool upper_edge;
  bool passed_up;
  bool begins_up;
};
constexpr int first_with_index = 3;
constexpr int first_without_index = 19;
constexpr SwitchSearch switch_searches[] = {{false, false, true}, {false, true, true},     // 3, 4
                                            {true, true, false},  {true, false, false},    // 5, 6
                                            {false, false, true}, {false, true, true},     // 7, 8
                                            {true, false, true},  {true, true, true},      // 9, 10
                                            {true, true, false},  {true, false, false},    // 11, 12
                                            {false, true, false}, {false, false, false}};  // 13, 14
constexpr int switch_search_count = std::size(switch_searches);
/// From here on a limit switch turns the search.
constexpr int first_with_limits = 4;

constexpr bool has_index(HomingMethod method) {
  return static_cast<int>(method) < first_without_index;
}
/// Null for a method that is none of these.
constexpr const SwitchSearch* switch_search_of(HomingMethod method) {
  const int number =
      static_cast<int>(method) - (has_index(method) ? first_with_index : first_without_index);
  return number >= 0 && number < switch_search_count ? &switch_searches[number] : nullptr;
}

}  // namespace

bool HomingSearch::goes_up() const {
  return method_ == HomingMethod::home_switch_above ||
         method_ == HomingMethod::upper_limit_switch ||
         method_ == HomingMethod::upper_limit_switch_and_index ||
         method_ == HomingMethod::index_above;
}

void HomingSearch::begin(const DriveReadings& readings, bool up_is_positive) {
  up_is_positive_ = up_is_positive;
  bool up = goes_up();
  if (const SwitchSearch* search = switch_search_of(method_); search != nullptr) {
    was_on_ = readings.home_switch.value_or(false);
    // From the switch, it moves to the edge that counts.
    up = was_on_ ? search->upper_edge : search->begins_up;
  }
  direction_ = up == up_is_positive ? 1 : -1;
  if (method_ == HomingMethod::present_position) direction_ = 0;
  seeks_index_ = method_ == HomingMethod::index_below || method_ == HomingMethod::index_above;
  has_turned_ = false;
  from_ = readings.position;
}

bool HomingSearch::is_possible(const DriveReadings& readings) const {
  return switch_search_of(method_) == nullptr || readings.home_switch.has_value();
}

/// Position of the last change of the switch that is searched for.
std::optional<double> HomingSearch::aim_of(const DriveReadings& readings) const {
  switch (method_) {
    case HomingMethod::lower_limit_switch:
    case HomingMethod::lower_limit_switch_and_index:
      return readings.lower_limit_position;
    case HomingMethod::upper_limit_switch:
    case HomingMethod::upper_limit_switch_and_index:
      return readings.upper_limit_position;
    default:
      return readings.home_position;
  }
}

std::optional<double> HomingSearch::look(const DriveReadings& readings) {
  if (direction_ == 0) return readings.position;
  if (seeks_index_) return look_for_index(readings);
  if (switch_search_of(method_) != nullptr) return look_for_edge(readings);
  const std::optional<double> aim = aim_of(readings);
  if (!aim || !has_passed(readings.position, *aim)) return std::nullopt;
  const bool is_found = method_ != HomingMethod::lower_limit_switch_and_index &&
                        method_ != HomingMethod::upper_limit_switch_and_index;
  if (is_found) return aim;
  // Moves back, to the first index pulse where the switch is off again.
  seeks_index_ = true;
  from_ = *aim;
  direction_ = -direction_;
  return std::nullopt;
}

std::optional<double> HomingSearch::look_for_index(const DriveReadings& readings) const {
  const auto& index = readings.index_position;
  const bool is_ahead = index && (*index - from_) * direction_ > 0;
  return is_ahead && has_passed(readings.position, *index) ? index : std::nullopt;
}

/// The lower edge of a switch is where it switches on upwards, or off downwards. After the other
/// edge, the search continues; the right edge in the wrong direction is passed once more.
std::optional<double> HomingSearch::look_for_edge(const DriveReadings& readings) {
  const SwitchSearch& search = *switch_search_of(method_);
  turn_at_limit(readings);
  const bool is_on = readings.home_switch.value_or(was_on_);
  if (is_on == was_on_) return std::nullopt;
  was_on_ = is_on;
  // It may not yet have turned.
  const bool moves_up = is_up(readings.velocity != 0 ? readings.velocity : direction_);
  const bool is_upper_edge = is_on != moves_up;
  if (is_upper_edge != search.upper_edge) return std::nullopt;
  direction_ = search.passed_up == up_is_positive_ ? 1 : -1;
  if (moves_up != search.passed_up) return std::nullopt;
  const double edge = readings.home_position.value_or(readings.position);
  if (!has_index(method_)) return edge;
  seeks_index_ = true;
  from_ = edge;
  return std::nullopt;
}

void HomingSearch::turn_at_limit(const DriveReadings& readings) {
  const bool turns = switch_search_of(method_) - switch_searches >= first_with_limits;
  if (!turns || has_turned_ || !is_at_limit(readings)) return;
  has_turned_ = true;
  direction_ = -direction_;
}

bool HomingSearch::is_at_limit(const DriveReadings& readings) const {
  const auto& limit =
      is_up(direction_) ? readings.upper_limit_position : readings.lower_limit_position;
  return limit && has_passed(readings.position, *limit);
}

bool HomingSearch::is_at_end(const DriveReadings& readings) const {
  return direction_ != 0 && is_at_limit(readings);
}

}  // namespace canvoy::cia417
