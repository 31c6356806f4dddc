#include "canvoy/tools/load/message_list.hpp"

#include <fmt/format.h>

#include "canvoy/can/frame.hpp"
#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

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
