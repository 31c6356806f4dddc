// An add-on device at a terminal: locks parts when it needs them, shows texts, and receives the
// keys that are pressed for it (CiA 447-3, 4.2.9).
//
//     TerminalClient terminal(network, {.terminal = 2});
//     terminal.on_number_key(Callback<void(NumberPadKey)>::to<&App::pressed>(app));
//     terminal.want(TerminalPart::number_pad, true);
//     terminal.want(TerminalPart::display_1, true);
//     terminal.show(TerminalText::title, "RADIO");
//     if (terminal.has(TerminalPart::display_1)) ...
//
// A part that another device holds is requested again until it is free. Parts are locked in the
// order of TerminalPart, and none before those in front of it, so that two clients never wait for
// each other. A part that was lost (the terminal booted, or has not received this device) is locked
// again, and its texts are written again. The terminal does not notify a device that it has lost;
// therefore the client periodically reads the holder of its parts.
//
// A key counts for this device if its PDO says that this device has the pad, and an earlier one has
// said so with no key pressed: so each key reaches one client, once.
//
// The node has to consume the objects of PDO 81: terminal_keys_objects.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/kit/car_network.hpp"
#include "canvoy/devices/cia447/terminal/terminal_part.hpp"
#include "canvoy/profiles/cia447/terminal_handles.hpp"

namespace canvoy::cia447 {

/// All objects of PDO 81.
inline constexpr std::array<const ObjectInfo*, 8> terminal_keys_objects = {
    &number_pad_status_object,    &number_pad_user_interaction_object,
    &function_keys_status_object, &function_keys_user_interaction_object,
    &control_keys_status_object,  &control_keys_user_interaction_object,
    &display_1_status_object,     &display_2_status_object};

/// Where a text is shown: the title and text of display 1, the text of display 2.
enum class TerminalText : std::uint8_t { title, text_1, text_2 };

/// The terminal, and what is wanted of it.
struct TerminalClientSettings {
  NodeId terminal = 0;        ///< 1 to 16
  Duration retry = 300ms;     ///< after a refusal, or without an answer
  Duration check = 2s;        ///< of held parts: they may have been lost
  Duration time_out = 500ms;  ///< of an answer
};

/// Construct it before the node starts. It sets on_lost() of the network, and calls the former
/// callback.
class TerminalClient {
 public:
  static constexpr std::size_t text_max = 80;  ///< bytes of UTF-8

  /// Makes the client; `network` must outlive it.
  TerminalClient(CarNetwork& network, const TerminalClientSettings& settings);

  /// Sets the callback for each key of the number pad that is pressed.
  void on_number_key(Callback<void(NumberPadKey)> pressed) { number_pressed_ = pressed; }
  /// Sets the callback for each function key that is pressed.
  void on_function_key(Callback<void(FunctionKey)> pressed) { function_pressed_ = pressed; }

  /// Requests or releases a part. Pads and displays: number_pad, function_pad, display_1,
  /// display_2; no effect for others.
  void want(TerminalPart part, bool is_wanted);
  /// Sets the text shown while this device has the display, cut to text_max.
  void show(TerminalText where, std::string_view text);
  /// True while this device holds a part.
  bool has(TerminalPart part) const { return states_[number_of(part)].is_held; }

 private:
  static constexpr unsigned number_of(TerminalPart part) { return static_cast<unsigned>(part); }

  struct PartWish {
    bool is_wanted = false;
    bool is_held = false;
  };
  struct ShownText {
    std::array<std::uint8_t, text_max> bytes{};
    std::size_t length = 0;
    bool is_told = false;
  };
  /// A pad with keys that this device receives.
  struct Pad {
    bool is_armed = false;  ///< it belongs to this device, and no key was pressed
    bool is_known = false;  ///< its keys were received since the reset
  };
  struct Job {
    enum class Kind : std::uint8_t { none, lock, release, write, check, look } kind = Kind::none;
    unsigned what = 0;  ///< a part, or a text
  };

  void reset(ResetScope scope);
  void lost(NodeId node);
  void forget();
  void go_on(Time now);
  void go_on_soon();
  Job next_job(Time now) const;
  Time next_time() const;
  void start(const Job& job);
  AbortCode start_write(unsigned text);
  AbortCode start_command(unsigned part, AccessCommand command);
  AbortCode start_check(unsigned part);
  AbortCode start_look(unsigned part);
  Pad* pad_of(unsigned part);
  const Pad* pad_of(unsigned part) const;
  bool is_unknown_pad(unsigned part) const;
  void take(unsigned part, std::uint8_t status);
  void done(SdoClient::Outcome outcome);
  template <TerminalPart part>
  void status_written(const Entry& entry);
  void number_written();
  void function_written();
  void let_go(unsigned part);
  bool is_mine(TerminalAccess access) const;
  template <class Key>
  void look_at(Pad& pad, bool is_mine, Key key, const Callback<void(Key)>& pressed);

  CarNetwork& network_;
  TerminalClientSettings settings_;
  SdoClient client_;
  Callback<void(NumberPadKey)> number_pressed_;
  Callback<void(FunctionKey)> function_pressed_;
  Callback<void(NodeId)> next_lost_;
  std::array<PartWish, lockable_part_count> states_{};
  std::array<ShownText, 3> texts_{};
  Pad number_pad_;
  Pad function_pad_;
  Job job_;
  std::array<std::uint8_t, 1> command_{};  ///< or a status
  std::array<std::uint8_t, text_max> written_{};
  Time not_before_{};
  Time lock_due_{};  ///< of parts that another device has
  Time check_due_{};
  Time look_due_{};                          ///< of pads of which the keys are not known
  unsigned to_check_ = lockable_part_count;  ///< the next part; all are checked
  static const AccessHandlers hook_calls[];
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

}  // namespace canvoy::cia447
