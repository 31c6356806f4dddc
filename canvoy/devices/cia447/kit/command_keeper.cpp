#include "canvoy/devices/cia447/kit/command_keeper.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::cia447 {

constexpr ServiceHandlers CommandKeeper::service_calls = {.reset = method<&CommandKeeper::reset>};

CommandKeeper::CommandKeeper(CarNetwork& network, const CommandKeeperSettings& settings)
    : network_(network),
      settings_(settings),
      client_(network.node(), mesh_channel_to(settings.server)),
      timer_(callback<&CommandKeeper::go_on>(*this)) {
  next_lost_ = network.on_lost(callback<&CommandKeeper::lost>(*this));
  network.node().attach(service_);
}

void CommandKeeper::want(unsigned place, const KeptCommand& command) {
  Kept& kept = kept_[place];
  const Time now = network_.node().now();
  const Time until = command.is_once ? now + settings_.lifetime : never;
  if (kept.wanted == command) {
    kept.until = until;
    return;
  }
  kept = {.wanted = command, .until = until};
  network_.node().timers().arm(timer_, std::max(now, not_before_));
}

bool CommandKeeper::is_done() const {
  return !client_.busy() && std::ranges::all_of(kept_, [](const Kept& kept) {
    return kept.is_told || kept.wanted.size == 0;
  });
}

void CommandKeeper::reset(ResetScope) {
  client_.cancel();
  report_all_anew({});
}

void CommandKeeper::lost(NodeId node) {
  if (next_lost_) next_lost_(node);
  if (node == settings_.server) report_all_anew(settings_.retry);
}

void CommandKeeper::report_all_anew(Duration after) {
  for (Kept& kept : kept_) kept.is_told = false;
  not_before_ = network_.node().now() + after;
  network_.node().timers().arm(timer_, not_before_);
}

void CommandKeeper::drop_old(Time now) {
  for (Kept& kept : kept_) {
    if (now >= kept.until) kept = {};
  }
}

void CommandKeeper::go_on(Time now) {
  if (client_.busy()) return;  // its end continues
  drop_old(now);
  if (now < not_before_) return network_.node().timers().arm(timer_, not_before_);
  network_.watch(settings_.server);
  if (now >= renewal_due_) {
    renewal_due_ = now + settings_.renewal;
    for (Kept& kept : kept_) kept.is_told = false;
  }
  const auto next = std::ranges::find_if(
      kept_, [](const Kept& kept) { return !kept.is_told && kept.wanted.size != 0; });
  if (next == kept_.end()) return network_.node().timers().arm(timer_, renewal_due_);
  writing_ = static_cast<unsigned>(next - kept_.begin());
  // A command that replaces it meanwhile is sent after this one.
  next->is_told = true;
  store(bytes_.data(), next->wanted.value);
  const AbortCode started =
      client_.download(settings_.server, next->wanted.index, next->wanted.sub,
                       std::span(bytes_).first(next->wanted.size),
                       SdoClient::Done::to<&CommandKeeper::taken>(*this), settings_.time_out);
  if (started != AbortCode::none) taken(started);
}

void CommandKeeper::taken(SdoClient::Outcome outcome) {
  const Time now = network_.node().now();
  Kept& written = kept_[writing_];
  if (!outcome) {
    written.is_told = false;
    not_before_ = now + settings_.retry;
  } else if (written.is_told && written.wanted.is_once) {
    written = {};
  }
  network_.node().timers().arm(timer_, std::max(now, not_before_));
}

}  // namespace canvoy::cia447
