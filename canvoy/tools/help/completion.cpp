#include "canvoy/tools/help/completion.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/device/catalogue/device_catalogue.hpp"
#include "canvoy/tools/device/hand/hand_order.hpp"
#include "canvoy/tools/device/hand_list.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

/// Meaning of the words before the last one.
struct Line {
  const Verb* verb;
  std::vector<std::string> places = {};     ///< words at the positions so far
  std::optional<OptionInfo> awaiting = {};  ///< an option with a value that comes next
};

bool is_named(const OptionInfo& option, std::string_view name) {
  return std::ranges::find(option.names, name) != option.names.end();
}

std::optional<OptionInfo> option_named(const Verb& innermost, std::string_view name) {
  for (const Verb* verb = &innermost; verb != nullptr; verb = verb->parent()) {
    for (const OptionInfo& option : verb->options()) {
      if (is_named(option, name)) return option;
    }
  }
  return std::nullopt;
}

const Verb* verb_named(const Verb& above, const std::string& word) {
  for (const std::unique_ptr<Verb>& verb : above.verbs()) {
    if (verb->name() == word) return verb.get();
  }
  return nullptr;
}

Line read_line(const Verb& app, const Words& words) {
  Line line{&app};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string& word = words[i];
    if (line.awaiting) {
      if (is_named(*line.awaiting, "--network")) use_network_file(word);
      line.awaiting.reset();
    } else if (word.starts_with('-')) {
      const std::optional<OptionInfo> option = option_named(*line.verb, word);
      if (option && option->takes_value) line.awaiting = option;
    } else if (const Verb* verb = verb_named(*line.verb, word)) {
      line.verb = verb;
    } else {
      line.places.push_back(word);
    }
  }
  return line;
}

// -- what there is

/// Network interfaces that are CAN controllers (ARPHRD_CAN).
Words bus_words() {
  Words words;
  std::error_code error;
  for (const auto& each : std::filesystem::directory_iterator("/sys/class/net", error)) {
    unsigned type = 0;
    constexpr unsigned can = 280;
    if (std::ifstream(each.path() / "type") >> type && type == can) {
      words.push_back(each.path().filename().string());
    }
  }
  words.insert(words.end(), {"udp:", "tcp:"});
  return words;
}

Words node_words() {
  Words words;
  for (const NamedNode& node : named_nodes()) {
    std::string& name = words.emplace_back(node.name);
    std::ranges::replace(name, ' ', '_');
  }
  for (const NamedNode& node : named_nodes()) words.push_back(std::to_string(node.id));
  return words;
}

/// `battery_parameters:ah_capacity`: without blanks, which would need quotes in a shell.
std::string typed_name(std::string name) {
  const std::size_t comma = name.find(", ");
  if (comma != std::string::npos) name.replace(comma, 2, ":");
  std::ranges::replace(name, ' ', '_');
  return name;
}

Words object_words() {
  std::set<std::string> names;
  for (const Profile* profile : all_profiles()) {
    for (const ObjectInfo* object : profile->objects) {
      for (const EntryInfo& entry : object->entries()) {
        const std::string name = typed_name(described_name(*object, entry));
        const bool is_typed = name.find_first_of("#()'\",;&") == std::string::npos;
        const bool is_value = entry.sub_first != 0 || object->entries().size() == 1;
        if (is_typed && is_value) names.insert(name);
      }
    }
  }
  return {names.begin(), names.end()};
}

/// The names of values of the object.
Words value_words(const Line& line) {
  constexpr std::size_t object_place = 2;
  if (line.places.size() <= object_place) return {};
  Words words;
  for (const Profile* profile : all_profiles()) {
    const auto address = find_address(*profile, line.places[object_place]);
    if (!address || address->entry == nullptr) continue;
    const FieldInfo* only = only_field(*address->entry);
    const ValueInfo& value = only != nullptr ? only->value : address->entry->value;
    for (const NamedValue& named : value.names) {
      if (named.meaning != Meaning::reserved)
        words.emplace_back(typed_name(std::string(named.name)));
    }
  }
  return words;
}

Words device_words(const Line& line) {
  Words words = all_device_names();
  if (line.places.empty()) return words;
  const Words buses = bus_words();
  words.insert(words.end(), buses.begin(), buses.end());
  words.emplace_back("sim");
  return words;
}

/// As accepted by `--profile`: 419, 447-3.
Words profile_words() {
  constexpr std::string_view organisation = "CiA ";
  Words words;
  for (const Profile* profile : all_profiles()) {
    std::string_view name = profile->name;
    if (name.starts_with(organisation)) name.remove_prefix(organisation.size());
    words.emplace_back(name);
  }
  return words;
}

/// Hands of the devices in the line.
Words hand_words(const Line& line, bool sets) {
  Words words;
  for (const std::string& place : line.places) {
    if (find_any_device_kind(place) == nullptr) continue;
    const std::vector<DeviceHand> hands = device_hands(place);
    const HandTable table = {place, hands};
    for (std::string& word : hand_completions({&table, 1}, sets)) words.push_back(std::move(word));
  }
  return words;
}

/// Values of an option with a few words.
Words option_values(const Line& line) {
  const OptionInfo& option = *line.awaiting;
  if (is_named(option, "--press")) return hand_words(line, false);
  if (is_named(option, "--set")) return hand_words(line, true);
  if (is_named(option, "--colour")) return {"auto", "always", "never"};
  if (is_named(option, "--by")) return {"object", "frame", "node"};
  return is_named(option, "--profile") ? profile_words() : Words{};
}

/// By the name of the argument in the help.
Words place_words(const Line& line, const std::string& place) {
  const auto fixed = [](Words words) {
    return [words = std::move(words)](const Line&) { return words; };
  };
  static const std::map<std::string, std::function<Words(const Line&)>> known = {
      {"bus", [](const Line&) { return bus_words(); }},
      {"source", [](const Line&) { return bus_words(); }},
      {"node", [](const Line&) { return node_words(); }},
      {"object", [](const Line&) { return object_words(); }},
      {"condition", [](const Line&) { return object_words(); }},
      {"value", value_words},
      {"device", device_words},
      {"profile", [](const Line&) { return profile_words(); }},
      {"format", fixed({"dbc", "csv", "html"})},
      {"state",
       fixed({"operational", "stopped", "pre-operational", "reset-node", "reset-communication"})},
      {"group", fixed({"all", "communication", "application"})},
      {"pdo", fixed({"rpdo1", "rpdo2", "rpdo3", "rpdo4", "tpdo1", "tpdo2", "tpdo3", "tpdo4"})},
      {"command", fixed({"scan", "inquire", "set-node-id", "set-bit-rate", "activate", "store",
                         "identify", "switch"})},
  };
  const auto found = known.find(place);
  return found == known.end() ? Words{} : found->second(line);
}

std::optional<OptionInfo> next_place(const Line& line) {
  std::vector<OptionInfo> places = line.verb->options();
  std::erase_if(places, [](const OptionInfo& option) { return !option.is_place; });
  if (line.places.size() < places.size()) return places[line.places.size()];
  // Only the last argument may take several words.
  if (places.empty() || !places.back().takes_several) return std::nullopt;
  return places.back();
}

Words subverb_texts(const Verb& above) {
  Words words;
  for (const std::unique_ptr<Verb>& verb : above.verbs()) {
    if (!verb->is_hidden()) words.push_back(verb->name());
  }
  return words;
}

Words option_words(const Verb& innermost) {
  Words words;
  for (const Verb* verb = &innermost; verb != nullptr; verb = verb->parent()) {
    for (const OptionInfo& option : verb->options()) {
      words.insert(words.end(), option.names.begin(), option.names.end());
    }
  }
  return words;
}

Words candidates(const Line& line, const std::string& typed) {
  if (line.awaiting) return option_values(line);
  if (typed.starts_with('-')) return option_words(*line.verb);
  Words words = subverb_texts(*line.verb);
  if (!words.empty()) return words;
  const std::optional<OptionInfo> place = next_place(line);
  return place ? place_words(line, place->name) : words;
}

char folded(char c) {
  return c == '-' ? '_' : static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

bool begins_with(const std::string& word, const std::string& typed) {
  return word.size() >= typed.size() &&
         std::equal(typed.begin(), typed.end(), word.begin(),
                    [](char a, char b) { return folded(a) == folded(b); });
}

}  // namespace

std::vector<std::string> completions(const Verb& app, const std::vector<std::string>& words) {
  const std::string typed = words.empty() ? "" : words.back();
  Words found = candidates(read_line(app, words), typed);
  std::erase_if(found, [&typed](const std::string& word) { return !begins_with(word, typed); });
  std::ranges::sort(found);
  const auto twins = std::ranges::unique(found);
  found.erase(twins.begin(), twins.end());
  return found;
}

}  // namespace canvoy::tools
