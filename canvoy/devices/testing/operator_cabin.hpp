// An operator environment with the maximum number of all elements (CiA 852, 9.1), of which one
// input after the other moves: for benchmarks, and for a test of its cost.
//
//     OperatorCabin cabin(std::chrono::milliseconds(2));
//     cabin.work();
//     cabin.change();
//     cabin.run_to(cabin.now + std::chrono::microseconds(100));
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "canvoy/devices/catalogue.hpp"
#include "canvoy/devices/cia852/kinds.hpp"
#include "canvoy/devices/cia852/operator_unit.hpp"
#include "canvoy/devices/kit/environment.hpp"

namespace canvoy::cia852 {

class OperatorCabin {
 public:
  static constexpr OperatorEnvironment everything = {.joysticks = 16,
                                                     .foot_pedals = 16,
                                                     .encoders = 8,
                                                     .wheels = 8,
                                                     .push_button_clusters = 8,
                                                     .indicator_clusters = 8,
                                                     .displays = 8,
                                                     .configuration = true};

  explicit OperatorCabin(Duration sensing_period) : sensing_period_(sensing_period) {
    environment_.provide(callback<&OperatorCabin::elements>(*this));
    environment_.provide(callback<&OperatorCabin::hardware>(*this));
    environment_.provide(callback<&OperatorCabin::settings>(*this));
    environment_.watch(unit_);
    device_ = std::make_unique<CatalogueDevice>(operator_kind, Port{this, send, nullptr},
                                                NodeId{10}, environment_);
    device_->node().start(now);
  }

  Node& node() { return device_->node(); }
  /// Enables all TPDOs and events of analogue inputs.
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
  /// Moves one input: joysticks, pedals and wheels, and a push-button after each eighth of them.
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
  static bool send(void* context, const Frame& /*frame*/) {
    ++static_cast<OperatorCabin*>(context)->sent;
    return true;
  }
  void write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::size_t size) {
    std::uint8_t bytes[4];
    store(bytes, value);
    node().dictionary().write(index, sub, std::span(bytes).first(size), Source::sdo);
  }
  OperatorEnvironment elements() { return everything; }
  OperatorSettings settings() { return {.sensing_period = sensing_period_}; }
  std::int16_t axis(unsigned joystick, unsigned axis) { return axes_[joystick * 3 + axis - 4]; }
  std::int16_t pedal(unsigned number) { return axes_[47 + number]; }
  std::int16_t wheel(unsigned number) { return axes_[63 + number]; }
  std::uint8_t pressed(unsigned cluster, unsigned group) {
    return buttons_[cluster * 8 + group - 9];
  }
  OperatorHardware hardware() {
    return {.joystick_axis = callback<&OperatorCabin::axis>(*this),
            .foot_pedal = callback<&OperatorCabin::pedal>(*this),
            .wheel = callback<&OperatorCabin::wheel>(*this),
            .push_buttons = callback<&OperatorCabin::pressed>(*this)};
  }

  Duration sensing_period_;
  Environment environment_;
  std::unique_ptr<CatalogueDevice> device_;
  OperatorUnit* unit_ = nullptr;
  std::array<std::int16_t, 72> axes_{};
  std::array<std::uint8_t, 64> buttons_{};
  unsigned moved_ = 0;
};

}  // namespace canvoy::cia852
