#include "canvoy/tools/load/load_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "canvoy/text/json_line.hpp"

namespace canvoy::tools {

namespace {

double ms(timing::Nanoseconds time) {
  return std::chrono::duration<double, std::milli>(time).count();
}
double seconds(timing::Nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

double percent_of(const LoadedBus& bus, const LoadedMessage& message) {
  return message.bits_per_second / bus.bit_rate * 100;
}

/// Counts characters, not bytes.
std::string clipped_to(const std::string& text, std::size_t most) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
    if (begins && count++ == most) return text.substr(0, i);
  }
  return text;
}

/// A property that messages share, the heaviest first.
struct Part {
  std::string name;
  double percent = 0;
  std::size_t messages = 0;
};
template <class NameOf>
std::vector<Part> parts_of(const LoadedBus& bus, NameOf name_of) {
  std::map<std::string, Part> parts;
  for (const LoadedMessage& each : bus.messages) {
    Part& part = parts[name_of(each)];
    part.percent += percent_of(bus, each);
    ++part.messages;
  }
  std::vector<Part> sorted;
  for (auto& [name, part] : parts) {
    part.name = name;
    sorted.push_back(part);
  }
  std::ranges::stable_sort(sorted, std::greater{}, &Part::percent);
  return sorted;
}
std::vector<Part> nodes_of(const LoadedBus& bus) {
  return parts_of(bus, [](const LoadedMessage& each) {
    return each.node == 0 ? std::string("-") : fmt::format("{}", each.node);
  });
}
std::vector<Part> services_of(const LoadedBus& bus) {
  return parts_of(bus, [](const LoadedMessage& each) { return each.service; });
}

std::string_view verdict(const timing::Response& response) {
  if (!response.is_bounded) return "none";
  return response.meets_deadline ? "met" : "LATE";
}

std::string message_line(const LoadedBus& bus, const LoadedMessage& message,
                         const timing::Response& response) {
  const std::string time =
      response.is_bounded ? fmt::format("{:.3f}", ms(response.time)) : "no bound";
  return fmt::format("{:<8} {:<15} {} {:>9.2f} {:>8.2f} {:>6.2f} {:>9} {:>9.2f} {}\n",
                     id_text(message.timing), clipped_to(title(message), 15), message.bytes,
                     ms(message.timing.period), ms(message.timing.jitter + message.timing.ahead),
                     percent_of(bus, message), time, ms(message.timing.deadline),
                     verdict(response));
}

std::string head_text(const LoadedBus& bus) {
  std::string text = fmt::format("{} at {:g} kbit/s", bus.name, bus.bit_rate / 1e3);
  if (bus.heard != Duration{}) {
    std::uint64_t frames = 0;
    for (const LoadedMessage& each : bus.messages) frames += each.frames;
    text += fmt::format(", {} frame{} heard in {:.3f} s", frames, frames == 1 ? "" : "s",
                        seconds(bus.heard));
  }
  const timing::ErrorModel& errors = bus.errors;
  if (errors.at_once != 0 || errors.each != Duration{})
    text += fmt::format(", {} error{} at once", std::max(errors.at_once, 1U),
                        errors.at_once > 1 ? "s" : "");
  if (errors.each != Duration{}) text += fmt::format(" and one each {:g} ms", ms(errors.each));
  return text + "\n";
}

std::string parts_text(const LoadedBus& bus) {
  const std::vector<Part> nodes = nodes_of(bus);
  const std::vector<Part> services = services_of(bus);
  std::string text = fmt::format("\n{:<6} {:>9} {:>7}    {:<18} {:>9} {:>7}\n", "node", "messages",
                                 "load %", "service", "messages", "load %");
  for (std::size_t i = 0; i < std::max(nodes.size(), services.size()); ++i) {
    std::string line;
    if (i < nodes.size())
      line =
          fmt::format("{:<6} {:>9} {:>7.2f}", nodes[i].name, nodes[i].messages, nodes[i].percent);
    if (i < services.size())
      line = fmt::format("{:<24}    {:<18} {:>9} {:>7.2f}", line, services[i].name,
                         services[i].messages, services[i].percent);
    text += line + "\n";
  }
  return text;
}

std::string verdict_text(const LoadedBus& bus, const LoadResult& result) {
  std::string text = fmt::format("\nload {:.2f} %, with all stuff bits {:.2f} %; ",
                                 result.load * 100, result.worst * 100);
  const std::size_t count = bus.messages.size();
  text += result.late == 0 ? fmt::format("{} of {} deadlines are met\n", count, count)
                           : fmt::format("{} of {} deadlines are missed\n", result.late, count);
  if (!result.breakdown) {
    text +=
        result.responses.empty() ? "" : "breakdown: none; a deadline is too short at any period\n";
  } else {
    text += fmt::format("breakdown at {:.1f} %, with periods {:.3f} times as long\n",
                        result.breakdown->utilisation * 100, result.breakdown->scale);
  }
  if (bus.heard != Duration{} && result.load > 1)
    text += fmt::format(
        "that is more than a bus carries: is {:g} kbit/s its bit rate, and is it one bus?\n",
        bus.bit_rate / 1e3);
  if (bus.error_frames != 0)
    text +=
        fmt::format("{} error frames were heard: --errors and --error-each tell what they cost\n",
                    bus.error_frames);
  for (const std::string& each : bus.left_out) text += fmt::format("not counted: {}\n", each);
  return text;
}

void append_parts(std::string& text, const LoadedBus& bus, std::string_view key,
                  const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    text::JsonLine json(text);
    json.begin_object();
    json.key("bus").text(bus.name);
    json.key(key).text(part.name);
    json.key("messages").number(std::uint64_t{part.messages});
    json.key("load_percent").number(part.percent);
    json.end_object();
    text += '\n';
  }
}

void append_message(std::string& text, const LoadedBus& bus, const LoadedMessage& message,
                    const timing::Response& response) {
  const timing::BusMessage& timing = message.timing;
  text::JsonLine json(text);
  json.begin_object();
  json.key("bus").text(bus.name);
  json.key("id").text(id_text(timing));
  if (!message.name.empty()) json.key("name").text(message.name);
  json.key("service").text(message.service);
  if (message.timing.is_remote) json.key("remote").truth(true);
  if (message.node != 0) json.key("node").number(std::int64_t{message.node});
  json.key("bytes").number(std::uint64_t{message.bytes});
  json.key("bits_max").number(std::uint64_t{timing.bits});
  if (bus.heard != Duration{}) json.key("frames").number(message.frames);
  json.key("load_percent").number(percent_of(bus, message));
  json.key("period_s").number(seconds(timing.period));
  json.key("jitter_s").number(seconds(timing.jitter));
  json.key("ahead_s").number(seconds(timing.ahead));
  json.key("distance_s").number(seconds(timing.distance));
  if (timing.offset) json.key("offset_s").number(seconds(*timing.offset));
  json.key("blocking_s").number(seconds(response.blocking));
  if (response.is_bounded) {
    json.key("response_s").number(seconds(response.time));
    json.key("instances").number(std::uint64_t{response.instances});
  }
  json.key("deadline_s").number(seconds(timing.deadline));
  json.key("met").truth(response.meets_deadline);
  json.end_object();
  text += '\n';
}

}  // namespace

std::vector<std::size_t> by_priority(const LoadedBus& bus) {
  std::vector<std::size_t> order(bus.messages.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return timing::priority(bus.messages[i].timing); });
  return order;
}

LoadResult result_of(const LoadedBus& bus) {
  const timing::BusModel model = model_of(bus);
  LoadResult result{.responses = timing::response_times(model),
                    .worst = timing::utilisation(model),
                    .breakdown = timing::breakdown(model)};
  for (const LoadedMessage& each : bus.messages) result.load += each.bits_per_second / bus.bit_rate;
  result.late = static_cast<std::size_t>(
      std::ranges::count(result.responses, false, &timing::Response::meets_deadline));
  return result;
}

std::string table_text(const LoadedBus& bus, const LoadResult& result) {
  std::string text = head_text(bus);
  text += fmt::format("{:<8} {:<15} {} {:>9} {:>8} {:>6} {:>9} {:>9}\n", "CAN-ID", "service", "B",
                      "period ms", "jitter", "load %", "response", "deadline");
  for (const std::size_t i : by_priority(bus))
    text += message_line(bus, bus.messages[i], result.responses[i]);
  return text + parts_text(bus) + verdict_text(bus, result);
}

std::string json_text(const LoadedBus& bus, const LoadResult& result) {
  std::string text;
  for (std::size_t i = 0; i < bus.messages.size(); ++i)
    append_message(text, bus, bus.messages[i], result.responses[i]);
  append_parts(text, bus, "of_node", nodes_of(bus));
  append_parts(text, bus, "of_service", services_of(bus));
  text::JsonLine json(text);
  json.begin_object();
  json.key("bus").text(bus.name);
  json.key("bit_rate").number(bus.bit_rate);
  if (bus.heard != Duration{}) json.key("heard_s").number(seconds(bus.heard));
  json.key("error_frames").number(bus.error_frames);
  json.key("load_percent").number(result.load * 100);
  json.key("load_max_percent").number(result.worst * 100);
  json.key("messages").number(std::uint64_t{bus.messages.size()});
  json.key("late").number(std::uint64_t{result.late});
  if (result.breakdown) {
    json.key("breakdown_percent").number(result.breakdown->utilisation * 100);
    json.key("breakdown_scale").number(result.breakdown->scale);
  }
  json.key("left_out").begin_list();
  for (const std::string& each : bus.left_out) json.text(each);
  json.end_list();
  json.end_object();
  return text + '\n';
}

}  // namespace canvoy::tools
