#include "canvoy/tools/lss_option.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "canvoy/tools/text.hpp"

namespace canvoy::tools {

namespace {

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

std::optional<LssStore>& made(std::optional<LssStore>& store, Node& node,
                              const LssOption::Settings& settings) {
  if (settings.flash != nullptr) store.emplace(node, *settings.flash, settings.place);
  return store;
}

}  // namespace

LssOption::LssOption(std::string who, Node& node, const Settings& settings)
    : who_(std::move(who)),
      node_(node),
      identity_(node, {.serial_number = settings.serial_number}),
      slave_(node, {.configure_bit_timing = {},
                    .activate_bit_timing = {},
                    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): made() has looked
                    .store = made(store_, node, settings) ? store_->hook()
                                                          : Callback<void(NodeId, std::uint8_t)>{},
                    .state_entered = Callback<void(LssState)>::to<&LssOption::entered>(*this)}) {
  if (store_) store_->on_stored(LssStore::Stored::to<&LssSlave::stored>(slave_));
  service_.reset = Callback<void(ResetScope)>::to<&LssOption::reset>(*this);
  node.attach(service_);
}

void LssOption::reset(ResetScope) {
  told_ = node_.id();
  if (!is_node_id(node_.id())) say(fmt::format("{}: waits for a node-ID by LSS", who_));
}

void LssOption::entered(LssState state) {
  if (state == LssState::configuration) return say(fmt::format("{}: LSS configuration", who_));
  if (std::exchange(told_, node_.pending_id()) == node_.pending_id()) return;
  if (!is_node_id(node_.pending_id())) {
    return say(fmt::format("{}: has no node-ID from the next reset on", who_));
  }
  say(fmt::format("{}: {} {}", who_, is_node_id(node_.id()) ? "at the next reset it is" : "is",
                  node_text(node_.pending_id())));
}

}  // namespace canvoy::tools
