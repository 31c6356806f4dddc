// What an operator environment with all elements at their maximum costs: to start, and while
// everything on it moves. The goals are 10 ms of CPU for the start, and for 10,000 input changes a
// second 5 % of a core: 5 us each.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <memory>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/site.hpp"

namespace canvoy::operator_bench {
namespace {

using cia852::OperatorEnvironment;
using cia852::OperatorHardware;
using cia852::OperatorSettings;
using cia852::OperatorUnit;

constexpr OperatorEnvironment everything = {.joysticks = 16,
                                            .foot_pedals = 16,
                                            .encoders = 8,
                                            .wheels = 8,
                                            .push_button_clusters = 8,
                                            .indicator_clusters = 8,
                                            .displays = 8,
                                            .configuration = true};

class Cabin {
 public:
  explicit Cabin(Duration sensing_period) : sensing_period_(sensing_period) {
    site_.offer(Callback<OperatorEnvironment()>::to<&Cabin::elements>(*this));
    site_.offer(Callback<OperatorHardware()>::to<&Cabin::hardware>(*this));
    site_.offer(Callback<OperatorSettings()>::to<&Cabin::settings>(*this));
    site_.watch(Callback<void(OperatorUnit&, Node&)>::to<&Cabin::is_made>(*this));
    device_ = std::make_unique<CatalogueDevice>(cia852::operator_kind, Port{this, send, nullptr},
                                                NodeId{10}, site_);
    device_->node().start(now);
  }

  Node& node() { return device_->node(); }
  /// All TPDOs are on, and analogue inputs cause events.
  void work() {
    write(0x6423, 0, 1, 1);
    std::uint32_t can_id = 0x181;
    for (std::uint16_t index = 0x1800; index <= 0x1828; ++index) {
      if (node().dictionary().find(index, 1)) write(index, 1, can_id++, 4);
    }
    node().command(NmtCommand::start);
    run_to(now + std::chrono::milliseconds(10));
    sent = 0;
  }
  /// One input moves: joysticks, pedals and wheels, and a push-button after each eighth of them.
  void change() {
    ++moved_;
    if (moved_ % 8 == 0) {
      buttons_[moved_ / 8 % buttons_.size()] ^= 0x10;
    } else {
      axes_[moved_ % axes_.size()] = static_cast<std::int16_t>(moved_ * 77);
    }
  }
  void look() {
    unit_->hardware_changed();
    node().advance(now);
  }
  void run_to(Time until) {
    while (node().deadline() <= until) {
      now = std::max(now, node().deadline());
      node().advance(now);
    }
    now = until;
  }

  Time now{};
  std::uint64_t sent = 0;

 private:
  static bool send(void* context, const Frame& frame) {
    benchmark::DoNotOptimize(frame.data);
    ++static_cast<Cabin*>(context)->sent;
    return true;
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::size_t size) {
    std::uint8_t bytes[4];
    store(bytes, value);
    node().dictionary().write(index, sub, std::span(bytes).first(size), Source::sdo);
  }
  OperatorEnvironment elements() { return everything; }
  OperatorSettings settings() { return {.sensing_period = sensing_period_}; }
  void is_made(OperatorUnit& unit, Node& /*node*/) { unit_ = &unit; }
  std::int16_t axis(unsigned joystick, unsigned axis) { return axes_[joystick * 3 + axis - 4]; }
  std::int16_t pedal(unsigned number) { return axes_[47 + number]; }
  std::int16_t wheel(unsigned number) { return axes_[63 + number]; }
  std::uint8_t pressed(unsigned cluster, unsigned group) {
    return buttons_[cluster * 8 + group - 9];
  }
  OperatorHardware hardware() {
    return {.joystick_axis = Callback<std::int16_t(unsigned, unsigned)>::to<&Cabin::axis>(*this),
            .foot_pedal = Callback<std::int16_t(unsigned)>::to<&Cabin::pedal>(*this),
            .wheel = Callback<std::int16_t(unsigned)>::to<&Cabin::wheel>(*this),
            .push_buttons = Callback<std::uint8_t(unsigned, unsigned)>::to<&Cabin::pressed>(*this)};
  }

  Duration sensing_period_;
  Site site_;
  std::unique_ptr<CatalogueDevice> device_;
  OperatorUnit* unit_ = nullptr;
  std::array<std::int16_t, 72> axes_{};
  std::array<std::uint8_t, 64> buttons_{};
  unsigned moved_ = 0;
};

/// From nothing to pre-operational.
void operator_start(benchmark::State& state) {
  for (auto _ : state) {
    const Cabin cabin(OperatorSettings{}.sensing_period);
    benchmark::DoNotOptimize(&cabin);
  }
}
BENCHMARK(operator_start)->Unit(benchmark::kMillisecond);

/// A second in which 10,000 inputs change. Looked at each `sensing_period`, those in between are
/// told together; with zero, the hardware says each time that it has changed.
void run_changes(benchmark::State& state, Duration sensing_period) {
  Cabin cabin(sensing_period);
  cabin.work();
  constexpr int changes = 10'000;
  for (auto _ : state) {
    for (int i = 0; i < changes; ++i) {
      cabin.change();
      cabin.run_to(cabin.now + std::chrono::microseconds(100));
      if (sensing_period == Duration::zero()) cabin.look();
    }
  }
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(cabin.sent), benchmark::Counter::kAvgIterations);
}

/// As usual, each 2 ms: 20 changes are told together.
void operator_second_of_changes(benchmark::State& state) {
  run_changes(state, OperatorSettings{}.sensing_period);
}
BENCHMARK(operator_second_of_changes)->Unit(benchmark::kMillisecond);

/// Each of them is told for itself.
void operator_second_of_told_changes(benchmark::State& state) {
  run_changes(state, Duration::zero());
}
BENCHMARK(operator_second_of_told_changes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace canvoy::operator_bench
