// A terminal alone on a cable, with a record of its display contents. Its node-ID is 5; devices 2
// and 3 are its clients.
#pragma once

#include <string>
#include <vector>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/terminal/terminal_unit.hpp"

namespace canvoy::cia447 {

class TerminalBench {
 public:
  /// PDOs 81 and 82 are the 27th and 28th of the list: 380h + 26 and 27 of node 5.
  static constexpr std::uint32_t keys_pdo = 0x39A;
  static constexpr std::uint32_t pad_pdo = 0x39B;

  explicit TerminalBench(const TerminalSettings& settings = {})
      : settings_(settings), bench(only_unit<TerminalKind>, [this](Environment& environment) {
          environment.provide(callback<&TerminalBench::hardware>(*this));
          environment.provide(callback<&TerminalBench::settings>(*this));
          environment.watch(unit_);
        }) {}

  TerminalUnit& unit() { return *unit_; }
  std::string ask_as(unsigned client, const std::string& request) {
    return bench.ask_as(client, request);
  }
  std::string ask(const std::string& request) { return bench.ask(request); }
  std::string last(std::uint32_t id) {
    bench.cable.run_for(0s);
    return bench.cable.last(id);
  }
  /// Lets time pass, with heartbeats of these devices.
  void run_for(Duration duration, std::vector<unsigned> heard = {}) {
    for (; duration > 0s; duration -= 1s) {
      for (const unsigned node : heard) {
        bench.cable.send("70" + std::to_string(node) + "#05");
      }
      bench.cable.run_for(std::min<Duration>(duration, 1s));
    }
  }

  // The last contents shown, and the number of changes.
  std::string title, text;
  unsigned display = 0, holder = 0, shows = 0;
  bool is_on = false, buzzes = false;
  std::string warned;  ///< "+1 -1": lamps switched on and off
  std::vector<ShownIcon> icons;

 private:
  void show(const DisplayContent& content) {
    display = content.display == TerminalDisplay::display_1 ? 1 : 2;
    holder = content.holder;
    is_on = content.is_on;
    title = content.title;
    text = content.text;
    ++shows;
  }
  void show_icon(const ShownIcon& icon) { icons.push_back(icon); }
  void buzz(bool on) { buzzes = on; }
  void warn(TerminalWarning warning, bool on) {
    warned += (on ? "+" : "-") + std::to_string(static_cast<unsigned>(warning)) + " ";
  }
  TerminalHardware hardware() {
    return {.show = callback<&TerminalBench::show>(*this),
            .show_icon = callback<&TerminalBench::show_icon>(*this),
            .buzz = callback<&TerminalBench::buzz>(*this),
            .warn = callback<&TerminalBench::warn>(*this)};
  }
  TerminalSettings settings() { return settings_; }

  TerminalSettings settings_;
  TerminalUnit* unit_ = nullptr;

 public:
  CarBench bench;
};

}  // namespace canvoy::cia447
