#include "canvoy/tools/player/act.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "canvoy/canopen/protocol/nmt.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

struct ActCommand {
  std::string_view word;
  NmtCommand command;
};
constexpr std::array act_commands = {
    ActCommand{"start", NmtCommand::start}, ActCommand{"stop", NmtCommand::stop},
    ActCommand{"enter-pre-operational", NmtCommand::enter_pre_operational},
    ActCommand{"reset-node", NmtCommand::reset_node},
    ActCommand{"reset-communication", NmtCommand::reset_communication}};

constexpr unsigned floor_max = 254;

[[noreturn]] void refuse(std::string_view text, std::string_view why) {
  throw UsageError(fmt::format("act '{}': {}; write it as one of {}", text, why, act_forms));
}

/// The words of an act, each taken once.
class ActWords {
 public:
  explicit ActWords(std::string_view text) : text_(text) {
    const std::size_t mark = text.rfind('@');
    if (mark == std::string_view::npos) refuse(text, "it has no time");
    const std::optional<Duration> at = parse_duration(text.substr(mark + 1));
    if (!at) refuse(text, fmt::format("'{}' is no time", text.substr(mark + 1)));
    at_ = Time{} + *at;
    std::string_view rest = text.substr(0, mark);
    kind_ = next(rest);
    while (!rest.empty()) {
      const std::string_view word = next(rest);
      const std::size_t equals = word.find('=');
      if (equals == std::string_view::npos) refuse(text, fmt::format("'{}' has no =", word));
      if (!words_.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
        refuse(text, fmt::format("'{}' is there twice", word.substr(0, equals)));
    }
  }

  Time at() const { return at_; }
  std::string_view kind() const { return kind_; }
  std::string_view take(std::string_view name) {
    const auto found = words_.find(name);
    if (found == words_.end()) refuse(text_, fmt::format("it has no {}=", name));
    const std::string_view value = found->second;
    words_.erase(found);
    return value;
  }
  unsigned number(std::string_view name, unsigned least, unsigned most) {
    return number_of(name, take(name), least, most, 10);
  }
  unsigned number_of(std::string_view name, std::string_view digits, unsigned least, unsigned most,
                     int base) const {
    unsigned value = 0;
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    const bool is_one = error == std::errc{} && stop == digits.data() + digits.size();
    if (!is_one || value < least || value > most)
      refuse(text_, fmt::format("'{}' is no {}", digits, name));
    return value;
  }
  void finish() const {
    if (!words_.empty()) refuse(text_, fmt::format("'{}' is not known", words_.begin()->first));
  }

 private:
  static std::string_view next(std::string_view& rest) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return word;
  }

  std::string_view text_;
  std::string_view kind_;
  Time at_{};
  std::map<std::string_view, std::string_view> words_;
};

void take_object(ActWords& words, BusRequest& request) {
  constexpr int base = 16;
  const std::string_view object = words.take("object");
  const std::size_t slash = std::min(object.find('/'), object.size());
  const std::string_view sub = slash == object.size() ? "0" : object.substr(slash + 1);
  request.index = static_cast<std::uint16_t>(
      words.number_of("object", object.substr(0, slash), 1, 0xFFFF, base));
  request.sub = static_cast<std::uint8_t>(words.number_of("object", sub, 0, 0xFF, base));
}

SdoRequests::Bytes take_bytes(ActWords& words) {
  constexpr int base = 16;
  std::string_view digits = words.take("bytes");
  SdoRequests::Bytes bytes;
  for (; !digits.empty(); digits.remove_prefix(std::min<std::size_t>(2, digits.size()))) {
    const std::string_view byte = digits.substr(0, 2);
    if (byte.size() != 2) words.number_of("whole byte", "", 0, 0, base);
    bytes.push_back(static_cast<std::uint8_t>(words.number_of("bytes", byte, 0, 0xFF, base)));
  }
  return bytes;
}

BusRequest take_request(std::string_view text, ActWords& words) {
  using Kind = BusRequest::Kind;
  BusRequest request{.bus = std::string(words.take("bus"))};
  if (words.kind() == "nmt") {
    request.kind = Kind::nmt;
    request.node = static_cast<NodeId>(words.number("node", 0, node_id_max));
    const std::string_view command = words.take("command");
    const auto* const found = std::ranges::find(act_commands, command, &ActCommand::word);
    if (found == act_commands.end()) refuse(text, fmt::format("'{}' is no command", command));
    request.bytes = {static_cast<std::uint8_t>(found->command)};
    return request;
  }
  request.kind = words.kind() == "read" ? Kind::read : Kind::write;
  request.node = static_cast<NodeId>(words.number("node", 1, node_id_max));
  take_object(words, request);
  if (request.kind == Kind::write) request.bytes = take_bytes(words);
  return request;
}

std::string request_text(const BusRequest& request) {
  using Kind = BusRequest::Kind;
  const std::string place = fmt::format("bus={}:node={}", request.bus, request.node);
  if (request.kind == Kind::nmt) {
    const auto* const found = std::ranges::find(
        act_commands, static_cast<NmtCommand>(request.bytes.at(0)), &ActCommand::command);
    return fmt::format("nmt:{}:command={}", place, found->word);
  }
  const std::string object = fmt::format("object={:04X}/{:02X}", request.index, request.sub);
  if (request.kind == Kind::read) return fmt::format("read:{}:{}", place, object);
  return fmt::format("write:{}:{}:bytes={:02X}", place, object, fmt::join(request.bytes, ""));
}

}  // namespace

std::string act_text(const Act& act) {
  const std::string what = act.request ? request_text(*act.request)
                                       : fmt::format("visit:from={}:to={}", act.from, act.to);
  return what + "@" + written(act.at - Time{});
}

Act parse_act(std::string_view text) {
  ActWords words(text);
  Act act{.at = words.at()};
  if (words.kind() == "visit") {
    act.from = words.number("from", 1, floor_max);
    act.to = words.number("to", 1, floor_max);
  } else if (words.kind() == "read" || words.kind() == "write" || words.kind() == "nmt") {
    act.request = take_request(text, words);
  } else {
    refuse(text, fmt::format("'{}' is not known", words.kind()));
  }
  words.finish();
  return act;
}

std::vector<Act> parse_acts(const std::vector<std::string>& texts) {
  std::vector<Act> acts;
  acts.reserve(texts.size());
  for (const std::string& text : texts) acts.push_back(parse_act(text));
  std::ranges::stable_sort(acts, {}, &Act::at);
  return acts;
}

}  // namespace canvoy::tools
