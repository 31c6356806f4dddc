#include "canvoy/tools/load/sheet_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/timing/response_time.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

constexpr std::uint32_t is_off = 1U << 31;  // of a PDO and of EMCY
constexpr std::uint32_t is_extended_id = 1U << 29;
constexpr std::uint32_t produces_sync = 1U << 30;
constexpr std::uint8_t synchronous_last = 240;
constexpr std::uint8_t event_first = 254;
constexpr Duration inhibit_step = 100us;

/// A TPDO that waits for SYNC, or SYNC itself.
struct BehindSync {
  LoadedMessage message;
  unsigned of_syncs = 0;  ///< every this number of SYNCs
};

std::optional<std::uint32_t> number_at(const DescribedNode& node, unsigned index, unsigned sub) {
  const formats::SheetEntry* entry = node.sheet.find(index, sub);
  if (entry == nullptr) return std::nullopt;
  const std::string& text = entry->value.empty() ? entry->default_value : entry->value;
  const auto number = formats::sheet_number(text);
  if (!number) return std::nullopt;
  return static_cast<std::uint32_t>(number->at(node.id));
}
std::uint32_t number_or_zero(const DescribedNode& node, unsigned index, unsigned sub) {
  return number_at(node, index, sub).value_or(0);
}

/// A message with a COB-ID of this node.
LoadedMessage made(const DescribedNode& node, std::uint32_t cob_id, unsigned bytes,
                   std::string service) {
  LoadedMessage message{.bytes = bytes, .service = std::move(service), .node = node.id};
  message.timing.is_extended = (cob_id & is_extended_id) != 0;
  message.timing.id =
      cob_id & (message.timing.is_extended ? Frame::extended_id_max : Frame::id_max);
  return message;
}

/// The messages of the nodes of one bus.
class Gathering {
 public:
  explicit Gathering(LoadedBus& bus) : bus_(&bus) {}

  void look_at(const DescribedNode& node) {
    look_at_sync(node);
    for (const auto& [index, object] : node.sheet.objects) {
      if (index >= object_index::tpdo_parameter && index <= object_index::tpdo_parameter_last)
        look_at_tpdo(node, index);
    }
    const Duration heartbeat =
        std::chrono::milliseconds(number_or_zero(node, object_index::heartbeat_producer, 0));
    if (heartbeat != Duration{}) {
      constexpr std::uint32_t error_control = 0x700;
      add(made(node, error_control + node.id, 1, "heartbeat"), heartbeat);
    }
    look_at_emergency(node);
  }

  void finish() {
    place_behind_sync();
    add_messages(*bus_, std::move(messages_));
  }

 private:
  void add(LoadedMessage message, Duration period) {
    message.timing.period = period;
    complete(message);
    messages_.push_back(std::move(message));
  }

  void look_at_sync(const DescribedNode& node) {
    const std::uint32_t cob_id = number_or_zero(node, object_index::cob_id_sync, 0);
    const Duration period{number_or_zero(node, object_index::sync_period, 0)};
    if ((cob_id & produces_sync) == 0 || period == Duration{}) return;
    const bool counts = number_or_zero(node, object_index::sync_counter_overflow, 0) > 1;
    LoadedMessage sync = made(node, cob_id, counts ? 1 : 0, "SYNC");
    sync.timing.offset = Duration{};
    add(sync, period);
    sync_ = messages_.back();
  }

  void look_at_tpdo(const DescribedNode& node, unsigned index) {
    const auto cob_id = number_at(node, index, 1);
    if (!cob_id || (*cob_id & is_off) != 0) return;
    const unsigned number = index - object_index::tpdo_parameter;
    unsigned bits = 0;
    const unsigned mapping = object_index::tpdo_mapping + number;
    const std::uint32_t mapped = std::min(number_or_zero(node, mapping, 0), 64U);
    for (unsigned sub = 1; sub <= mapped; ++sub) bits += number_or_zero(node, mapping, sub) & 0xFF;
    if (bits == 0) return;  // empty, and not sent
    LoadedMessage message =
        made(node, *cob_id, std::min((bits + 7) / 8, 8U), fmt::format("TPDO{}", number + 1));
    const std::uint32_t type = number_at(node, index, 2).value_or(0xFF);
    if (type <= synchronous_last) {
      behind_sync_.push_back({std::move(message), std::max<unsigned>(type, 1)});
      return;
    }
    if (type < event_first) return leave_out(message, "is sent on request");
    const Duration inhibit = number_or_zero(node, index, 3) * inhibit_step;
    const Duration event = std::chrono::milliseconds(number_or_zero(node, index, 5));
    if (inhibit == Duration{} && event == Duration{})
      return leave_out(message, "has neither inhibit nor event time");
    add(std::move(message), inhibit != Duration{} ? inhibit : event);
  }

  void look_at_emergency(const DescribedNode& node) {
    const auto cob_id = number_at(node, object_index::cob_id_emergency, 0);
    if (!cob_id || (*cob_id & is_off) != 0) return;
    LoadedMessage message = made(node, *cob_id, 8, "EMCY");
    const Duration inhibit =
        number_or_zero(node, object_index::emergency_inhibit_time, 0) * inhibit_step;
    if (inhibit == Duration{}) return leave_out(message, "has no inhibit time");
    add(std::move(message), inhibit);
  }

  void leave_out(const LoadedMessage& message, std::string_view why) {
    bus_->left_out.push_back(
        fmt::format("{}h, {}, {}", id_text(message.timing), title(message), why));
  }

  void place_behind_sync() {
    if (behind_sync_.empty()) return;
    if (!sync_) sync_ = sync_of_bus();
    if (!sync_) {
      for (const BehindSync& each : behind_sync_)
        leave_out(each.message, "waits for a SYNC that nobody sends");
      return;
    }
    // TPDOs with a higher priority than SYNC delay it.
    std::ranges::stable_partition(behind_sync_,
                                  [&](const BehindSync& each) { return is_before_sync(each); });
    for (BehindSync& each : behind_sync_) {
      timing::BusMessage& timing = each.message.timing;
      if (!is_before_sync(each)) {
        if (sync_->timing.offset) timing.offset = Duration{};
        timing.jitter = sync_delay();
      }
      add(std::move(each.message), each.of_syncs * sync_->timing.period);
    }
  }
  /// SYNC of a message that is already on the bus.
  std::optional<LoadedMessage> sync_of_bus() const {
    const auto found = std::ranges::find(bus_->messages, "SYNC", &LoadedMessage::service);
    return found == bus_->messages.end() ? std::nullopt : std::optional(*found);
  }
  bool is_before_sync(const BehindSync& each) const {
    return each.message.timing.id < sync_->timing.id;
  }

  /// Time from its event to its reception by all, with all other messages.
  Duration sync_delay() {
    if (sync_delay_) return *sync_delay_;
    LoadedBus all = *bus_;
    add_messages(all, messages_);
    std::vector<LoadedMessage> behind;
    for (const BehindSync& each : behind_sync_) {
      if (is_before_sync(each)) continue;
      behind.push_back(each.message);
      behind.back().timing.period = each.of_syncs * sync_->timing.period;
      complete(behind.back());
    }
    add_messages(all, std::move(behind));
    const auto responses = timing::response_times(model_of(all));
    const auto sync = std::ranges::find(all.messages, sync_->timing.id,
                                        [](const LoadedMessage& each) { return each.timing.id; });
    const auto& response =
        responses[static_cast<std::size_t>(std::distance(all.messages.begin(), sync))];
    // Without a bound, the bus is full, and messages after SYNC have no bound either.
    sync_delay_ =
        response.is_bounded ? std::chrono::ceil<Duration>(response.time) : sync_->timing.period;
    return *sync_delay_;
  }

  LoadedBus* bus_;
  std::vector<LoadedMessage> messages_;
  std::vector<BehindSync> behind_sync_;
  std::optional<LoadedMessage> sync_;
  std::optional<Duration> sync_delay_;
};

}  // namespace

void add_sheet_messages(LoadedBus& bus, const std::vector<DescribedNode>& nodes) {
  Gathering gathering(bus);
  for (const DescribedNode& node : nodes) gathering.look_at(node);
  gathering.finish();
}

}  // namespace canvoy::tools
