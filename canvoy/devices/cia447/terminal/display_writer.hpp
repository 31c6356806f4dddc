// What another device shows on a display of the terminal (CiA 447-3, 4.2.9.17 to 4.2.9.26), as its
// SDO client: it locks the display, writes its text, and gives the display back.
//
//     DisplayWriter writer(network, {.terminal = 6, .display = TerminalDisplay::display_1});
//     writer.show("HIRED\n12.40 EUR");
//     writer.show("");    // the car may have it again
//
// What the terminal does not take, as while another device has the display, is told again until it
// does; a terminal that was lost and comes back is told anew.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/devices/cia447/car_network.hpp"
#include "canvoy/devices/cia447/terminal/terminal_display.hpp"

namespace canvoy::cia447 {

class DisplayWriter {
 public:
  static constexpr std::size_t text_max = 80;  ///< bytes

  struct Settings {
    NodeId terminal = 0;  ///< 0: there is none
    TerminalDisplay display = TerminalDisplay::display_1;
    Duration repetition = 2s;  ///< of what is shown, and of what was refused
  };

  /// It takes on_lost() of the network, and calls who was called before.
  DisplayWriter(CarNetwork& network, const Settings& settings);
  DisplayWriter(const DisplayWriter&) = delete;
  DisplayWriter& operator=(const DisplayWriter&) = delete;

  /// UTF-8; what is longer than text_max is cut. It need not outlive the call.
  void show(std::string_view text);
  /// The terminal has what was last given to show().
  bool is_shown() const { return is_known_ && text() == shown(); }

 private:
  struct Text {
    std::array<char, text_max> bytes{};
    std::size_t length = 0;
  };

  std::string_view text() const { return {wanted_.bytes.data(), wanted_.length}; }
  std::string_view shown() const { return {shown_.bytes.data(), shown_.length}; }
  void reset(ResetScope scope);
  void lost(NodeId node);
  void begin_anew();
  void go_on(Time now);
  void write_command(bool locks);
  void write_text();
  void written(SdoClient::Outcome outcome);

  /// What is under way.
  enum class Step : std::uint8_t { none, lock, release, text };

  CarNetwork& network_;
  Settings settings_;
  SdoClient client_;
  Callback<void(NodeId)> next_lost_;
  Service service_;
  Timer timer_;
  Text wanted_;
  Text shown_;
  Text writing_;
  Step step_ = Step::none;
  bool is_known_ = true;  ///< what the terminal shows
  bool has_display_ = false;
  std::uint8_t command_ = 0;
};

}  // namespace canvoy::cia447
