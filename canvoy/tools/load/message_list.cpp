#include "canvoy/tools/load/message_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "canvoy/can/frame.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/sim/duration_text.hpp"
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

namespace {

constexpr Duration time_max = 24h;

/// 0 or more, in the notation of other times.
void take_from_zero(TomlTable& table, std::string_view key, Duration& to) {
  std::string text;
  table.take(key, text);
  if (text.empty()) return;
  const std::optional<Duration> duration = parse_duration(text);
  if (!duration || *duration > time_max) {
    table.refuse(key, fmt::format(R"('{}' is no time up to 24h: write a number and {}, as "30ms")",
                                  text, duration_units));
  }
  to = *duration;
}

void take_id(TomlTable& table, timing::BusMessage& message) {
  if (!table.has("id")) table.refuse("a message needs its id, as id = 0x185");
  table.take("id", message.id, {0, Frame::extended_id_max});
  message.is_extended = message.id > Frame::id_max;
  table.take("extended", message.is_extended);
  if (!message.is_extended && message.id > Frame::id_max)
    table.refuse("extended", "the identifier has more than 11 bits");
}

/// Its interval: the period, the event time, or the inhibit time.
void take_period(TomlTable& table, timing::BusMessage& message) {
  Duration event{};
  Duration inhibit{};
  take_from_zero(table, "period", message.period);
  take_from_zero(table, "event", event);
  take_from_zero(table, "inhibit", inhibit);
  if (message.period != Duration{}) {
    if (event != Duration{}) table.refuse("event", "say either this or the period");
    if (inhibit > message.period) table.refuse("inhibit", "is longer than the period");
    message.distance = inhibit;
    return;
  }
  message.period = inhibit != Duration{} ? inhibit : event;
  if (message.period == Duration{}) {
    table.refuse(R"(say how often it comes: period = "10ms", or its event or inhibit time)");
  }
}

LoadedMessage message_of(TomlTable& table) {
  LoadedMessage message;
  timing::BusMessage& timing = message.timing;
  take_id(table, timing);
  table.take("name", message.name);
  table.take("node", message.node, {1, node_id_max});
  table.take("remote", timing.is_remote);
  if (!table.has("bytes")) table.refuse("a message needs its bytes, as bytes = 8");
  table.take("bytes", message.bytes, {0, Frame::length_max});
  take_period(table, timing);
  take_from_zero(table, "jitter", timing.jitter);
  take_from_zero(table, "ahead", timing.ahead);
  if (table.has("offset")) {
    timing.offset.emplace();
    take_from_zero(table, "offset", *timing.offset);
    if (*timing.offset >= timing.period) table.refuse("offset", "is not below the period");
    if (timing.ahead != Duration{} || timing.distance != Duration{})
      table.refuse("offset", "what has a place behind SYNC has neither ahead nor inhibit");
  }
  table.take("deadline", timing.deadline);
  if (timing.deadline > time_max) table.refuse("deadline", "is more than 24h");
  table.finish();
  complete(message);
  return message;
}

}  // namespace

bool is_message_list(const TomlTable& file) {
  return file.has("message");
}

LoadedBus read_message_list(TomlTable& file, const std::string& name) {
  LoadedBus bus{.name = name};
  file.take("bit_rate", bus.bit_rate, {1000, 1'000'000});
  TomlTable errors = file.table("errors");
  errors.take("at_once", bus.errors.at_once, {0, 1000});
  errors.take("each", bus.errors.each);
  errors.finish();
  std::vector<LoadedMessage> messages;
  for (TomlTable& each : file.tables("message")) messages.push_back(message_of(each));
  file.finish();
  add_messages(bus, std::move(messages));
  return bus;
}

void read_deadlines(TomlTable& file, std::vector<LoadedBus>& buses) {
  for (TomlTable& each : file.tables("deadline")) {
    timing::BusMessage wanted;
    take_id(each, wanted);
    std::string on;
    each.take("bus", on);
    each.take("deadline", wanted.deadline);
    if (wanted.deadline == Duration{}) each.refuse(R"(say the deadline, as deadline = "5ms")");
    each.finish();
    bool is_sent = false;
    for (LoadedBus& bus : buses) {
      if (!on.empty() && bus.name != on) continue;
      for (LoadedMessage& message : bus.messages) {
        if (message.timing.id != wanted.id || message.timing.is_extended != wanted.is_extended)
          continue;
        message.timing.deadline = wanted.deadline;
        is_sent = true;
      }
    }
    if (!is_sent) each.refuse("id", fmt::format("nobody sends {}h", id_text(wanted)));
  }
  file.finish();
}

}  // namespace canvoy::tools
