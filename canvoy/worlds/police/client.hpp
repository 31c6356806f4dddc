// Clients that share the terminal of a police car, and their reports to observers.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/can/callback.hpp"
#include "canvoy/profiles/cia447/add_on_states.hpp"

namespace canvoy::police {

/// A client of the terminal.
enum class Client : std::uint8_t { radio, signals, navigation };
inline constexpr unsigned client_count = 3;  ///< number of clients

/// Title on display 1 while a client has it.
constexpr std::string_view title_of(Client client) {
  constexpr std::array<std::string_view, client_count> titles = {"RADIO", "SOUND", "NAVIGATION"};
  return titles[static_cast<unsigned>(client)];
}

/// A key on which a client has acted.
struct KeyAction {
  Client client = Client::radio;  ///< the client that acted
  bool is_function_key = false;   ///< true: of the function keys; false: of the number pad
  std::uint8_t key = 0;           ///< NumberPadKey or FunctionKey
};
/// Called when a client acts on a key.
using Acted = Callback<void(const KeyAction&)>;

/// Digit of a key of the pad: 0 to 9; -1 for other keys.
constexpr int digit_of(cia447::NumberPadKey key) {
  using cia447::NumberPadKey;
  if (key == NumberPadKey::key_0) return 0;
  const bool is_digit = key >= NumberPadKey::key_1 && key <= NumberPadKey::key_9;
  return is_digit ? static_cast<int>(key) - static_cast<int>(NumberPadKey::none) : -1;
}

}  // namespace canvoy::police
