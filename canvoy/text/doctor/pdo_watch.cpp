#include "canvoy/text/doctor/pdo_watch.hpp"

#include <algorithm>
#include <utility>

namespace canvoy::text {

void PdoWatch::hear_sync(Time at) {
  sync_ = at;
  ++cycle_;
}

namespace {

/// Finds the sender: from the parameters of nodes, from the decoder, or from the pre-defined
/// connection set.
void find_sender(HeardPdo& pdo, std::uint16_t can_id, const decoder::Decoded& decoded,
                 NodeId sender, const KnownParameters& known) {
  pdo.node = sender;
  pdo.number = 0;
  const decoder::PdoPlan* plan = decoded.pdo;
  const bool is_sent = plan != nullptr && plan->direction == PdoInfo::Direction::transmit;
  pdo.is_multiplexed = plan != nullptr && plan->multiplexed != MpdoKind::no;
  if (const KnownParameters::Place* place = known.sender_of(can_id)) {
    pdo.node = place->first;
    pdo.number = place->second;
  } else if (is_sent) {
    pdo.node = plan->node;
    pdo.number = plan->number;
  }
}

/// Nodes may have mapped other objects than the defaults of their profiles: only known parameters
/// count, and messages that are the same everywhere.
bool is_wrong_length(const Frame& frame, const KnownTpdo* tpdo, const decoder::Decoded& decoded) {
  const auto length = tpdo == nullptr ? std::nullopt : tpdo->length();
  if (length) return *length != frame.length;
  return decoded.pdo != nullptr && decoded.pdo->node == 0 &&
         decoded.marks.has(decoder::Mark::wrong_length);
}

}  // namespace

void PdoWatch::hear(Time at, const Frame& frame, const decoder::Decoded& decoded, NodeId sender,
                    const KnownParameters& known) {
  HeardPdo& pdo = pdos_[static_cast<std::uint16_t>(frame.id)];
  if (frame.is_remote()) {
    pdo.is_asked = true;
    return;
  }
  ++pdo.frames;
  find_sender(pdo, static_cast<std::uint16_t>(frame.id), decoded, sender, known);
  const bool is_of_node = pdo.node != 0 && pdo.number != 0;
  const KnownTpdo* tpdo = is_of_node ? known.tpdo(pdo.node, pdo.number) : nullptr;
  if (is_wrong_length(frame, tpdo, decoded)) pdo.wrong_length.add(at);
  judge_length(pdo, at, frame.length);
  if (tpdo != nullptr) judge_times(pdo, at, frame, *tpdo, known.sync_window(pdo.node));
  pdo.frame_before = std::exchange(pdo.frame, frame);
  pdo.latest = at;
  pdo.is_asked = false;
}

void PdoWatch::judge_length(HeardPdo& pdo, Time at, std::uint8_t length) {
  if (pdo.lengths == 0) {
    pdo.length = length;
    pdo.lengths = 1;
  }
  if (length == pdo.length) return;
  if (pdo.lengths == 1 || (pdo.lengths == 2 && length != pdo.other_length)) ++pdo.lengths;
  pdo.length_changes.add(at);
  pdo.other_length = pdo.length;
  pdo.length = length;
}

void PdoWatch::judge_times(HeardPdo& pdo, Time at, const Frame& frame, const KnownTpdo& tpdo,
                           const std::optional<Duration>& window) {
  if (tpdo.is_synchronous() && cycle_ != 0 && !pdo.is_asked) judge_cycle(pdo, at, window);
  if (pdo.frames < 2 || !tpdo.is_event_driven()) return;
  // A new value is sent at once, between the periods of the event timer.
  const bool is_told_again = frame == pdo.frame || frame == pdo.frame_before;
  if (is_told_again) pdo.rhythm.hear(at, tpdo.event_timer);
  const Duration interval = at - pdo.latest;
  const Duration inhibited = tpdo.inhibit_time.value_or(Duration::zero());
  // A frame that waited for the bus comes late, and the next one may then follow earlier.
  if (pdo.is_asked || inhibited <= Duration::zero() || interval >= inhibited / 2) return;
  pdo.too_early.add(at);
  pdo.inhibit_time = inhibited;
  pdo.shortest = std::min(pdo.shortest, interval);
}

void PdoWatch::judge_cycle(HeardPdo& pdo, Time at, const std::optional<Duration>& window) {
  pdo.in_cycle = pdo.cycle == cycle_ ? pdo.in_cycle + 1 : 1;
  pdo.cycle = cycle_;
  if (pdo.in_cycle == 2) pdo.twice_in_cycle.add(at);
  const Duration behind = at - sync_;
  if (!window || behind <= *window) return;
  pdo.too_late.add(at);
  pdo.window = *window;
  pdo.latest_in_cycle = std::max(pdo.latest_in_cycle, behind);
}

}  // namespace canvoy::text
