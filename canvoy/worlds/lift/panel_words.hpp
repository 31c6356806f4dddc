// Controls of a panel beside call buttons, by their names in a file: keys and buttons with a
// special function, and displays (CiA 417-4, 4.3.1 and 4.4.1).
//
//     special_function_of("vip-service");   // SpecialFunction::vip_service
//     panel_display_of("arrival");          // the gong
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"

namespace canvoy::lift {

/// An output that shows what a lift does.
struct PanelDisplay {
  /// Basic function of the output.
  cia417::BasicFunction function = cia417::BasicFunction::position_indicator;
  std::uint8_t sub_function = 0;  ///< special indication; 0: any

  friend bool operator==(const PanelDisplay&, const PanelDisplay&) = default;
};

/// Controls of a panel beside call buttons.
struct PanelDescription {
  /// Keys and buttons; empty optional: those that it needs. Each listed one also has a lamp.
  std::optional<std::vector<cia417::SpecialFunction>> keys{};
  /// Displays; empty optional: position and lantern of a landing; position, direction and overload
  /// of a car.
  std::optional<std::vector<PanelDisplay>> displays{};
  bool calls = true;        ///< false: it has no call buttons, as an inspection station
  bool parameters = false;  ///< it has the four parameters of each input and output

  friend bool operator==(const PanelDescription&, const PanelDescription&) = default;
};

/// Function of `fan-1` to `dogging-service-down`; empty for other names.
std::optional<cia417::SpecialFunction> special_function_of(std::string_view name);
/// Inverse of special_function_of().
std::string_view special_function_name(cia417::SpecialFunction function);
/// All names, for messages.
std::vector<std::string_view> special_function_names();

/// Display of `position`, `lantern`, `direction`, `arrival`, `special`, or of one special
/// indication, such as `overload`.
std::optional<PanelDisplay> panel_display_of(std::string_view name);
/// Inverse of panel_display_of().
std::string_view panel_display_name(const PanelDisplay& display);
/// All names, for messages.
std::vector<std::string_view> panel_display_names();

/// Function of key lock 1 to 4, by its number from 0 on.
constexpr cia417::SpecialFunction key_lock(std::size_t number) {
  return static_cast<cia417::SpecialFunction>(
      static_cast<std::size_t>(cia417::SpecialFunction::key_lock_1) + number);
}

/// True for a key, which stays where it is turned to; a button returns.
bool is_key(cia417::SpecialFunction function);

}  // namespace canvoy::lift
