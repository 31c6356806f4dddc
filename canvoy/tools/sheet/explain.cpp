// canvoy explain CODE...: meanings of a number of CANopen; canvoy search WORD...: objects of all
// profiles by parts of their names.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <set>

#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/unit.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/value_text.hpp"
#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

namespace {

struct ExplainOptions {
  std::vector<std::string> words = {};
  bool json = false;
};

/// A possible kind of a number, and its meaning.
struct Explanation {
  std::string kind;
  std::string text;
};
using Explanations = std::vector<Explanation>;

/// `0x06090011`, `0609 0011h`, `8130h`: hexadecimal digits, up to 8.
struct Code {
  std::uint32_t number = 0;
  std::size_t digits = 0;
};
std::optional<Code> parse_code(std::string text) {
  if (text.starts_with("0x") || text.starts_with("0X")) text.erase(0, 2);
  if (text.ends_with('h') || text.ends_with('H')) text.pop_back();
  std::erase(text, ' ');
  Code code{.digits = text.size()};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, code.number, 16);
  constexpr std::size_t digits_max = 8;
  const bool is_code = error == std::errc{} && end == last && code.digits <= digits_max;
  return is_code ? std::optional(code) : std::nullopt;
}

std::vector<const Profile*> searched_profiles() {
  std::vector<const Profile*> profiles(all_profiles().begin(), all_profiles().end());
  profiles.push_back(&cia302::profile);
  return profiles;
}

void explain_emergency(std::uint16_t code, Explanations& explanations) {
  std::set<std::string_view> told;
  for (const Profile* profile : searched_profiles()) {
    for (const ErrorCodeInfo& error : profile->error_codes) {
      if (error.code != code || !told.insert(error.text).second) continue;
      std::string text(error.text);
      if (!error.description.empty()) text.append("; ").append(error.description);
      explanations.push_back({fmt::format("emergency code ({})", profile->name), std::move(text)});
    }
  }
  constexpr std::uint16_t class_first = 0x1000;
  if (told.empty() && (code >= class_first || code == 0)) {
    explanations.push_back({"emergency code", std::string(text::emergency_text(code))});
  }
}

std::string unit_text(const EntryInfo& entry) {
  if (entry.value.unit == Unit::none) return {};
  return fmt::format(" [{}]", symbol(entry.value.unit));
}

void explain_object(std::uint16_t index, Explanations& explanations) {
  for (const Profile* profile : searched_profiles()) {
    const ObjectInfo* const object = find_object(*profile, index);
    if (object == nullptr) continue;
    std::string text = text::object_text(index, 0).substr(0, 5) + ' ' + std::string(object->name);
    if (object->subs.empty()) text += unit_text(object->entry);
    text += fmt::format("; canvoy profile {} {:04X} has more", short_name(*profile), index);
    explanations.push_back({fmt::format("object ({})", profile->name), std::move(text)});
  }
}

/// A CAN-ID that the pre-defined connection set does not use is told where nothing else is meant.
void explain_can_id(std::uint32_t id, bool is_meant, Explanations& explanations) {
  text::FrameDecoder decoder;
  const text::FrameWords& words = decoder.decode(Frame::data_frame(id, {}));
  const bool is_used = words.service != "other" && !words.service.empty();
  if (!is_used && !is_meant) return;
  std::string text(is_used ? words.service : "of no service");
  if (words.node != 0) text += " of " + text::node_text(words.node);
  explanations.push_back({"CAN-ID, as pre-defined", std::move(text)});
}

/// Bits of the error register, and states of a heartbeat.
void explain_byte(std::uint8_t byte, Explanations& explanations) {
  const std::string_view state = text::nmt_state_text(static_cast<NmtState>(byte));
  const bool is_state = byte == 0 || byte == 4 || byte == 5 || byte == 0x7F;
  if (is_state) explanations.push_back({"NMT state", std::string(state)});
  const auto address = find_address(base_profile(), "1001");
  if (address && address->entry != nullptr) {
    const std::uint8_t bytes[] = {byte};
    explanations.push_back({"error register (1001h)", text::value_text(address->entry, bytes)});
  }
  if (byte >= 1 && byte <= node_id_max)
    explanations.push_back({"node-ID", text::node_text(static_cast<NodeId>(byte))});
}

/// `100` to `127`
void explain_decimal_node(const std::string& text, Explanations& explanations) {
  unsigned number = 0;
  const char* const last = text.data() + text.size();
  const bool is_decimal = std::from_chars(text.data(), last, number).ptr == last;
  if (!is_decimal || text.front() == '0' || number > node_id_max) return;
  explanations.push_back({"node-ID, decimal", text::node_text(static_cast<NodeId>(number))});
}

/// `operational`
void explain_state(const std::string& text, Explanations& explanations) {
  for (const NmtState state :
       {NmtState::stopped, NmtState::operational, NmtState::pre_operational}) {
    if (!same_name(text::nmt_state_text(state), text)) continue;
    explanations.push_back(
        {"NMT state", fmt::format("{:02X}h in a heartbeat; canvoy nmt can0 10 {} "
                                  "commands it",
                                  static_cast<unsigned>(state), text)});
  }
}

Explanations explain(const std::string& text) {
  Explanations explanations;
  explain_state(text, explanations);
  const std::optional<Code> code = parse_code(text);
  if (!code) return explanations;
  constexpr std::size_t abort_digits = 8;
  if (code->digits == abort_digits) {
    explanations.push_back(
        {"SDO abort code", text::abort_text(static_cast<AbortCode>(code->number))});
  } else if (code->digits == 4) {
    explain_emergency(static_cast<std::uint16_t>(code->number), explanations);
    explain_object(static_cast<std::uint16_t>(code->number), explanations);
  } else if (code->digits == 3 && code->number <= Frame::id_max) {
    explain_decimal_node(text, explanations);
    explain_can_id(code->number, explanations.empty(), explanations);
  } else if (code->digits <= 2) {
    explain_can_id(code->number, false, explanations);
    explain_byte(static_cast<std::uint8_t>(code->number), explanations);
  }
  return explanations;
}

void print_explanation(const ExplainOptions& options, const std::string& word,
                       const Explanation& explanation) {
  if (!options.json) {
    fmt::print("{}  {}: {}\n", word, explanation.kind, explanation.text);
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("code").text(word);
  json.key("kind").text(explanation.kind);
  json.key("text").text(explanation.text);
  json.end_object();
  fmt::print("{}\n", line);
}

int explain_codes(const ExplainOptions& options) {
  for (const std::string& word : options.words) {
    const Explanations explanations = explain(word);
    if (explanations.empty()) {
      throw UsageError(fmt::format(
          "'{}' is no code: give an SDO abort code (06090011), an emergency code (8130), a CAN-ID "
          "(18A), an object (1017), a state or error register (7F); canvoy search {} looks for "
          "names",
          word, word));
    }
    for (const Explanation& explanation : explanations)
      print_explanation(options, word, explanation);
  }
  return exit_done;
}

// -- search

struct FoundObject {
  const Profile* profile;
  const ObjectInfo* object;
  const EntryInfo* entry;
};

bool has_all(std::string_view name, const std::vector<std::string>& words) {
  const std::string plain = plain_name(name);
  return std::ranges::all_of(
      words, [&](const std::string& word) { return has_name(plain, plain_name(word)); });
}

std::vector<FoundObject> search_objects(const std::vector<std::string>& words) {
  std::vector<FoundObject> found;
  for (const Profile* profile : searched_profiles()) {
    for (const ObjectInfo* object : profile->objects) {
      for (const EntryInfo& entry : object->entries()) {
        const bool is_count = entry.sub_first == 0 && object->entries().size() > 1;
        if (!is_count && has_all(described_name(*object, entry), words)) {
          found.push_back({profile, object, &entry});
        }
      }
    }
  }
  // Values before what says how they are transmitted.
  constexpr std::uint16_t communication_last = 0x1FFF;
  std::ranges::stable_sort(
      found, {}, [](const FoundObject& each) { return each.object->index <= communication_last; });
  return found;
}

void print_found(const ExplainOptions& options, const FoundObject& found) {
  const std::string name = described_name(*found.object, *found.entry);
  const std::string place = text::object_text(found.object->index, found.entry->sub_first);
  if (!options.json) {
    fmt::print("{:<11} {}  {}{}\n", found.profile->name, place, name, unit_text(*found.entry));
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("profile").text(found.profile->name);
  json.key("index").text(fmt::format("{:04X}", found.object->index));
  json.key("sub").text(fmt::format("{:02X}", found.entry->sub_first));
  json.key("name").text(name);
  if (found.entry->value.unit != Unit::none) {
    json.key("unit").text(symbol(found.entry->value.unit));
  }
  json.end_object();
  fmt::print("{}\n", line);
}

int search_objects(const ExplainOptions& options) {
  const std::vector<FoundObject> found = search_objects(options.words);
  for (const FoundObject& each : found) print_found(options, each);
  if (!found.empty()) return exit_done;
  throw Failure("no object of any profile has these words in its name: try a part of one, as temp");
}

}  // namespace

void add_explain(Verb& app) {
  const auto options = std::make_shared<ExplainOptions>();
  Verb& command = app.add_verb(
      "explain", "Say what a number means: abort and emergency codes, CAN-IDs, states, objects");
  command.add({
      {"code", options->words,
       "hexadecimal: 06090011 (SDO abort), 8130 (emergency, or an object), 18A (CAN-ID), 7F "
       "(state, "
       "error register); or several",
       required},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy explain 06090011\n"
      "  canvoy explain 8130\n"
      "  canvoy explain 18A 7F --json");
  command.runs([options] { return explain_codes(*options); });
}

void add_search(Verb& app) {
  const auto options = std::make_shared<ExplainOptions>();
  Verb& command = app.add_verb("search", "Find objects of all profiles by words of their names");
  command.add({
      {"word", options->words, "a part of the name, in any case; several: all of them", required},
      {"--json", options->json, "one JSON object a line"},
  });
  command.add_examples(
      "  canvoy search temperature\n"
      "  canvoy search battery voltage --json");
  command.runs([options] { return search_objects(*options); });
}

}  // namespace canvoy::tools
