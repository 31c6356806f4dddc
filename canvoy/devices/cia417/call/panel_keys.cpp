#include "canvoy/devices/cia417/call/panel_keys.hpp"

#include <bit>

#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/profiles/cia417/inputs.hpp"

namespace canvoy::cia417 {

namespace {

constexpr std::size_t record_bytes = 6;
/// A number of inputs is one byte; a server need not give the size of an expedited answer.
constexpr std::size_t expedited_bytes = 4;

}  // namespace

constexpr ServiceHandlers PanelKeys::service_calls = {
    .reset = method<&PanelKeys::reset>, .state_entered = method<&PanelKeys::state_entered>};

PanelKeys::PanelKeys(Node& node, SdoClient& client, CallController& calls)
    : node_(node), client_(client), calls_(calls), timer_(callback<&PanelKeys::go_on>(*this)) {
  node.attach(service_);
}

void PanelKeys::reset(ResetScope) {
  waiting_.reset();
  panel_ = 0;
  node_.timers().disarm(timer_);
}

/// The client reports the end of a request that was under way; the next request may have found the
/// node in another state.
void PanelKeys::state_entered(NmtState state) {
  if (state != NmtState::operational) return;
  if (is_reading() || waiting_.any()) node_.timers().arm(timer_, node_.now());
}

void PanelKeys::read(NodeId panel) {
  if (!is_node_id(panel) || panel == node_.id()) return;
  waiting_[panel] = true;
  if (!is_reading()) node_.timers().arm(timer_, node_.now());
}

/// The next request, or the next panel.
void PanelKeys::go_on(Time) {
  if (node_.state() != NmtState::operational || client_.busy()) return;
  while (is_reading() || find_next()) {
    const AbortCode started = client_.upload(panel_, index(), input_, value_,
                                             SdoClient::Done::to<&PanelKeys::answered>(*this));
    if (started == AbortCode::none) return;
    panel_ = 0;
  }
}

bool PanelKeys::find_next() {
  for (unsigned id = 1; id <= node_id_max; ++id) {
    if (!waiting_[id]) continue;
    waiting_[id] = false;
    panel_ = static_cast<NodeId>(id);
    block_ = static_cast<std::uint8_t>(std::countr_zero(calls_.lift_mask()) + 1);
    group_ = input_ = 0;
    return true;
  }
  return false;
}

std::uint16_t PanelKeys::index() const {
  return static_cast<std::uint16_t>(input_group_object.index + (block_ - 1) * block_pitch + group_);
}

void PanelKeys::answered(SdoClient::Outcome outcome) {
  // Not from here: the NMT state may have ended it.
  node_.timers().arm(timer_, node_.now() + pause);
  if (outcome.is_silence()) {
    panel_ = 0;
  } else if (input_ == 0) {
    inputs_ = outcome && *outcome <= expedited_bytes ? value_[0] : std::uint8_t{0};
    if (inputs_ == 0) return next_block();
    input_ = 1;
  } else {
    const VirtualInput input = decode_input(load<std::uint64_t>(value_.data()));
    const bool is_record = outcome && *outcome == record_bytes;
    if (is_record) calls_.take_reading(input);
    if (input_ < inputs_) {
      ++input_;
      return;
    }
    input_ = 0;
    if (++group_ == group_count) next_block();
  }
}

/// Continues after the last group of one lift.
void PanelKeys::next_block() {
  group_ = input_ = 0;
  if (block_ == 1) {
    panel_ = 0;
  } else {
    block_ = 1;
  }
}

}  // namespace canvoy::cia417
