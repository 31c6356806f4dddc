#include "canvoy/tools/device/lss_option.hpp"

#include <fmt/format.h>

#include <utility>

#include "canvoy/text/text.hpp"

namespace canvoy::tools {

LssOption::LssOption(const DeviceOutput& output, std::string who, Node& node,
                     const Settings& settings)
    : output_(output),
      who_(std::move(who)),
      node_(node),
      identity_(node, {.serial_number = settings.serial_number}),
      indicators_(settings.indicators),
      // In braces, since these are evaluated in order.
      slave_{node, hooks(settings),
             bit_timing_ ? bit_timing_->present() : std::uint8_t{lss_bit_timing::unknown}} {
  if (store_) store_->on_stored(LssStore::Stored::to<&LssSlave::stored>(slave_));
  service_.reset = Callback<void(ResetScope)>::to<&LssOption::reset>(*this);
  node.attach(service_);
}

/// Makes the requested functions for the slave.
LssSlaveHooks LssOption::hooks(const Settings& settings) {
  LssSlaveHooks hooks;
  hooks.state_entered = Callback<void(LssState)>::to<&LssOption::entered>(*this);
  if (settings.flash != nullptr) {
    hooks.store = store_.emplace(node_, *settings.flash, settings.place).hook();
  }
  if (settings.interface.empty()) return hooks;
  InterfaceBitTiming& timing = bit_timing_.emplace(
      settings.interface, [this](const std::string& line) { output_.say(who_, line); });
  const std::uint8_t stored = store_ ? store_->bit_timing() : lss_bit_timing::unknown;
  if (settings.takes_stored_bit_rate && lss_bit_timing::bit_rate(stored) != 0) {
    timing.switch_to(stored);
  }
  hooks.configure_bit_timing =
      Callback<LssError(std::uint8_t)>::to<&InterfaceBitTiming::configure>(timing);
  hooks.activate_bit_timing =
      switch_.emplace(node_, Callback<void(std::uint8_t)>::to<&LssOption::switch_to>(*this)).hook();
  return hooks;
}

void LssOption::reset(ResetScope) {
  told_ = node_.id();
  if (!is_node_id(node_.id())) output_.say(who_, "waits for a node-ID by LSS");
}

void LssOption::entered(LssState state) {
  if (indicators_ != nullptr) indicators_->lss_state_entered(state);
  if (state == LssState::configuration) return output_.say(who_, "LSS configuration");
  if (std::exchange(told_, node_.pending_id()) == node_.pending_id()) return;
  if (!is_node_id(node_.pending_id())) {
    return output_.say(who_, "has no node-ID from the next reset on");
  }
  output_.say(who_, fmt::format("{} {}", is_node_id(node_.id()) ? "at the next reset it is" : "is",
                                text::node_text(node_.pending_id())));
}

}  // namespace canvoy::tools
