#include "canvoy/tools/node/typed_options.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "canvoy/formats/trace/trace_format.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/argument/bus_argument.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"
#include "canvoy/tools/node/word_order.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

bool is_duration(std::string_view word) {
  return parse_duration(word).has_value();
}

bool is_type(std::string_view word) {
  return parse_type(word).has_value();
}

/// What others call an option or a place, without dashes and in small letters.
struct OtherSpellings {
  std::string_view meant;                  ///< an option without its first dashes, or a place
  std::string_view typed;                  ///< separated by blanks
  std::string_view in_front = {};          ///< of the value: `id=`
  bool (*of)(std::string_view) = nullptr;  ///< only of such a value
};
/// Of several meanings of a word, a verb has the first one that it knows.
constexpr auto other_spellings = std::to_array<OtherSpellings>({
    {"bus", "c i", "", names_bus},
    {"source", "c i", "", names_bus},
    {"count", "n c limit head max num number frames"},
    {"node-id", "n", "", is_small_number},
    {"node", "n", "", is_small_number},
    {"source", "f", "", formats::names_trace},
    {"log", "f", "", formats::names_trace},
    {"filter", "f y"},
    {"filter", "from since start begin", "time>=", is_duration},
    {"filter", "to until end", "time<=", is_duration},
    {"filter", "ids cobid", "id="},
    {"node-id", "id"},
    {"filter", "id canid", "id="},
    {"filter", "service", "service="},
    {"filter", "object", "object="},
    {"filter", "bus", "bus="},
    {"json", "j"},
    {"out", "o w write output outfile to format"},
    {"what", "node"},
    {"to", "o out output"},
    {"log", "i r file infile input"},
    {"source", "file"},
    {"in", "i input"},
    {"type", "t", "", is_type},
    {"for", "t", "", is_duration},
    {"for", "d duration time seconds"},
    {"every", "period interval cycle cycletime"},
    {"watch", "period interval every"},
    {"bit-rate", "baud baudrate"},
    {"node-id", "node"},
    {"node", "nodeid"},
    {"store", "save"},
    {"web", "p port"},
    {"listen", "p port"},
    {"loop", "repeat"},
    {"diff", "dryrun"},
    {"object", "index"},
    {"bus", "interface channel"},
    {"source", "interface channel"},
});

/// A number, or `2:7` behind another network; names are not told from other words.
bool is_node(std::string_view word) {
  const std::size_t colon = word.find(':');
  const bool is_remote = colon != std::string_view::npos && is_small_number(word.substr(0, colon));
  return word == "all" || is_remote || find_node_id(word).has_value();
}
bool is_pdo(std::string_view word) {
  const std::string_view kind = word.substr(0, 4);
  return (kind == "tpdo" || kind == "rpdo") && is_small_number(word.substr(4));
}
bool is_log(std::string_view word) {
  std::error_code none;
  return word == "-" || formats::names_trace(word) || std::filesystem::exists(word, none);
}
Words parts_of(std::string_view list) {
  Words parts;
  while (true) {
    const std::size_t comma = list.find(',');
    parts.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    list.remove_prefix(comma + 1);
  }
}
/// `1000,1001`, `temperature,voltage`; a sub-index behind a comma is shorter, and buses are no
/// list.
bool is_list_of_names(std::string_view word) {
  constexpr std::size_t name_min = 3;
  const bool is_text = word.find_first_of(" ='\"#") != std::string_view::npos;
  return word.find(',') != std::string_view::npos && !is_text && !names_bus(word) &&
         std::ranges::all_of(parts_of(word),
                             [](const std::string& part) { return part.size() >= name_min; });
}
bool is_table(std::string_view word) {
  return word == "dbc" || word == "csv" || word == "html";
}

/// Places whose words are told from others by their form.
struct PlaceForm {
  std::string_view place;
  bool (*fits)(std::string_view word);
};
constexpr auto place_forms = std::to_array<PlaceForm>({{"bus", names_bus},
                                                       {"node", is_node},
                                                       {"state", is_nmt_word},
                                                       {"pdo", is_pdo},
                                                       {"log", is_log},
                                                       {"format", is_table}});

/// `--Bit_Rate` as `bitrate`.
std::string plain_option(std::string_view word) {
  std::string plain;
  for (const char c : word) {
    if (c == '-' || c == '_') continue;
    plain += in_lower_case(c);
  }
  return plain;
}

bool is_option(std::string_view word) {
  constexpr std::string_view digits = "0123456789.";
  return word.size() > 1 && word.front() == '-' && digits.find(word[1]) == std::string_view::npos;
}

bool is_file_name(std::string_view word) {
  const std::size_t dot = word.rfind('.');
  return dot != std::string_view::npos && dot + 1 < word.size() &&
         word.find_first_not_of("0123456789", dot + 1) != std::string_view::npos;
}

/// What verbs write, and read no log or data sheet from.
bool is_picture_or_table(std::string_view word) {
  constexpr auto endings =
      std::to_array<std::string_view>({".svg", ".png", ".dbc", ".csv", ".html"});
  return std::ranges::any_of(endings,
                             [word](std::string_view ending) { return word.ends_with(ending); });
}

/// `10x` as 10, where a factor is meant.
std::string without_times(const std::string& value) {
  std::string_view number = value;
  if (number.starts_with('x')) number.remove_prefix(1);
  if (number.ends_with('x')) number.remove_suffix(1);
  const bool is_number = number.find_first_of("123456789") != std::string_view::npos &&
                         number.find_first_not_of("0123456789.") == std::string_view::npos;
  return is_number ? std::string(number) : value;
}

bool is_port(std::string_view value) {
  return !value.empty() && value.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Names of fields of Wireshark as ours: `canopen.node_id == 10` as `node == 10`.
std::string without_fields_of_wireshark(std::string filter) {
  constexpr auto fields = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"canopen.node_id", "node"}, {"canopen.cob_id", "id"}, {"can.id", "id"}});
  for (const auto& [typed, meant] : fields) {
    for (std::size_t at = 0; (at = filter.find(typed, at)) != std::string::npos;) {
      filter.replace(at, typed.size(), meant);
    }
  }
  return filter;
}

/// `node 10 and service EMCY` as `node=10 and service=EMCY`.
std::string with_signs(const std::string& filter) {
  constexpr auto fields =
      std::to_array<std::string_view>({"node", "id", "object", "service", "bus", "time"});
  constexpr auto others = std::to_array<std::string_view>({"and", "or", "not", "in"});
  const auto is_in = [](const auto& list, std::string_view word) {
    return std::ranges::find(list, word) != list.end();
  };
  std::string made;
  std::string_view rest = filter;
  std::string_view before;
  while (!rest.empty()) {
    const std::size_t length = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, length);
    const bool is_value = !word.empty() && word.find_first_of("=<>!()") == std::string_view::npos &&
                          !is_in(others, word);
    if (!made.empty()) made += is_value && is_in(fields, before) ? '=' : ' ';
    made += word;
    before = word;
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return made;
}

/// The words of a verb, told apart.
class TypedOptions {
 public:
  TypedOptions(const Words& words, const Verb& verb, std::size_t begin) {
    for (const Verb* each = &verb; each != nullptr; each = each->parent()) {
      for (OptionInfo& option : each->options()) {
        (option.is_place && each == &verb ? places_ : options_).push_back(std::move(option));
      }
    }
    words_.assign(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(begin));
    Words rest(words.begin() + static_cast<std::ptrdiff_t>(begin), words.end());
    for (std::size_t at = 0; at < rest.size();) at = take(rest, at);
  }

  /// Nothing where the verb understands all of it as it is.
  std::optional<Words> meant() {
    claim_further_words();
    part_lists();
    const bool is_ordered = named_.empty() && order_by_form();
    if (!is_changed_ || !place_named_words()) return std::nullopt;
    words_.insert(words_.end(), loose_.begin(), loose_.end());
    words_.insert(words_.end(), said_.begin(), said_.end());
    if (is_ordered) order_words(words_);
    return words_;
  }

  /// Of words that shall be options alone.
  FrontFit fit() const {
    if (has_unknown_ || misses_value_ || !loose_.empty()) return FrontFit::none;
    const bool may_be_place = has_other_spelling_ && (!named_.empty() || is_place("node"));
    return may_be_place ? FrontFit::other : FrontFit::known;
  }

 private:
  const OptionInfo* find_option(std::string_view name) const {
    const auto found = std::ranges::find_if(options_, [name](const OptionInfo& option) {
      const bool is_out =
          name == "-o" && std::ranges::find(option.names, "--out") != option.names.end();
      return is_out || std::ranges::find(option.names, name) != option.names.end();
    });
    return found == options_.end() ? nullptr : &*found;
  }
  const OptionInfo* find_plain(const std::string& plain) const {
    const OptionInfo* found = nullptr;
    for (const OptionInfo& option : options_) {
      for (const std::string& name : option.names) {
        if (plain_option(name) == plain) found = &option;
      }
    }
    return found;
  }
  bool is_place(std::string_view name) const {
    return std::ranges::find(places_, name, &OptionInfo::name) != places_.end();
  }

  /// Takes the word there, and its values; returns the place of the next.
  std::size_t take(const Words& rest, std::size_t at) {
    const std::string& word = rest[at];
    if (!is_option(word)) {
      loose_.push_back(word);
      return at + 1;
    }
    const std::size_t sign = word.find('=');
    const std::string name = word.substr(0, sign);
    if (name == "-h" || find_option(name) != nullptr) {
      const OptionInfo* const option = find_option(name);
      said_.push_back(word);
      return sign == std::string::npos ? take_values(option, rest, at + 1) : at + 1;
    }
    std::optional<std::string> value;
    if (sign != std::string::npos) value = word.substr(sign + 1);
    const bool has_next = at + 1 < rest.size() && !is_option(rest[at + 1]);
    if (!value && has_next) value = rest[at + 1];
    return take_unknown(rest, at, value, sign == std::string::npos);
  }

  /// Several values have one form: `--eds 9=pump.eds night.log` is followed by a log.
  std::size_t take_values(const OptionInfo* option, const Words& rest, std::size_t at) {
    if (option == nullptr || option->is_flag) return at;
    const bool is_last = at == rest.size() || is_option(rest[at]);
    misses_value_ = misses_value_ || (is_last && option->takes_value);
    const bool is_pair = at < rest.size() && rest[at].find('=') != std::string::npos;
    do {
      if (at == rest.size() || is_option(rest[at])) return at;
      if (is_pair && rest[at].find('=') == std::string::npos) {
        is_changed_ = true;
        return at;
      }
      said_.push_back(value_of(option->name, rest[at++]));
    } while (option->takes_several);
    return at;
  }

  std::size_t take_unknown(const Words& rest, std::size_t at,
                           const std::optional<std::string>& value, bool is_behind) {
    has_other_spelling_ = true;
    const std::string plain = plain_option(rest[at]).substr(0, plain_option(rest[at]).find('='));
    const std::size_t next = at + (value && is_behind ? 2 : 1);
    for (const std::string& place : {plain, plain + 's'}) {
      if (plain.size() < 2 || !is_place(place) || !value) continue;
      name_place(place, *value);
      return next;
    }
    if (const OptionInfo* const option = find_plain(plain); option != nullptr && plain.size() > 1) {
      return take_as(*option, "", value, at, next);
    }
    if (plain == "sub" || plain == "subindex") {
      const auto object = named_.find("object");
      if (object != named_.end() && value) {
        object->second += ':' + *value;
        return next;
      }
      if (value && !loose_.empty() && (is_place("object") || is_place("objects"))) {
        is_changed_ = true;
        loose_.back() += ':' + *value;
        return next;
      }
    }
    // `--format json` as `--json`.
    const bool is_form = value && (*value == "json" || *value == "csv") &&
                         (plain.ends_with("format") || plain == "f" || plain == "output");
    if (is_form && find_option("--" + *value) != nullptr) {
      is_changed_ = true;
      said_.push_back("--" + *value);
      return next;
    }
    for (const OtherSpellings& each : other_spellings) {
      if (!is_listed(plain, each.typed) || (each.of != nullptr && !(value && each.of(*value))))
        continue;
      const OptionInfo* const option = find_plain(plain_option(each.meant));
      if (option != nullptr) return take_as(*option, each.in_front, value, at, next);
      if (!is_place(each.meant) || !value) continue;
      name_place(each.meant, *value);
      return next;
    }
    // The line is refused: a value is no file to be written.
    const auto first = rest.begin() + static_cast<std::ptrdiff_t>(at);
    said_.insert(said_.end(), first, first + static_cast<std::ptrdiff_t>(next - at));
    has_unknown_ = true;
    return next;
  }

  /// Returns the place of the next word.
  std::size_t take_as(const OptionInfo& option, std::string_view in_front,
                      const std::optional<std::string>& value, std::size_t at, std::size_t next) {
    is_changed_ = true;
    said_.push_back(option.names.front());
    if (option.is_flag) return at + 1;
    misses_value_ = misses_value_ || (!value && option.takes_value);
    if (value) said_.push_back(std::string(in_front) + value_of(option.name, *value));
    return next;
  }

  /// A value as the option has it.
  std::string value_of(std::string_view option, const std::string& typed) {
    std::string value = typed;
    if (option == "--speed") value = without_times(typed);
    if (option == "--listen" && is_port(typed)) value = "127.0.0.1:" + typed;
    if (option == "--filter") value = with_signs(without_fields_of_wireshark(typed));
    is_changed_ = is_changed_ || value != typed;
    return value;
  }

  void name_place(std::string_view place, const std::string& value) {
    is_changed_ = true;
    named_[std::string(place)] = value;
  }

  /// A duration, or a file, where the verb has no place for a further word.
  void claim_further_words() {
    const bool takes_any = std::ranges::any_of(places_, &OptionInfo::takes_several);
    claim_filter(takes_any);
    const std::size_t room = places_.size() - named_.size();
    if (loose_.size() <= room && !takes_any) return;
    for (std::size_t at = loose_.size(); at-- > room;) {
      const std::string option = claimed_by(loose_[at]);
      if (option.empty() || (takes_any && !is_picture_or_table(loose_[at]))) continue;
      is_changed_ = true;
      said_.insert(said_.end(), {option, loose_[at]});
      loose_.erase(loose_.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
  /// `monitor can0 node=10`: what stands behind the one place is the filter.
  void claim_filter(bool takes_any) {
    const bool has_room = takes_any || places_.size() != 1 || loose_.size() < 2;
    if (has_room || has_unknown_ || find_option("--filter") == nullptr || is_said("--filter"))
      return;
    std::string filter;
    for (std::size_t at = 1; at < loose_.size(); ++at) {
      if (!claimed_by(loose_[at]).empty()) return;
      filter += (at == 1 ? "" : " ") + loose_[at];
    }
    is_changed_ = true;
    said_.insert(said_.end(), {"--filter", value_of("--filter", filter)});
    loose_.resize(1);
  }
  std::string claimed_by(const std::string& word) const {
    constexpr auto of_time = std::to_array<const char*>({"--for", "--every", "--timeout"});
    if (parse_duration(word)) {
      for (const char* option : of_time) {
        if (find_option(option) != nullptr) return is_said(option) ? "" : option;
      }
    }
    return is_file_name(word) && find_option("--out") != nullptr && !is_said("--out") ? "--out"
                                                                                      : "";
  }
  bool is_said(std::string_view option) const {
    return std::ranges::find(said_, option) != said_.end();
  }

  /// `1000,1001` where several objects may stand: each of them.
  void part_lists() {
    if (places_.empty() || !places_.back().takes_several) return;
    Words parted;
    for (std::size_t at = 0; at < loose_.size(); ++at) {
      const bool is_list = at + 1 >= places_.size() && is_list_of_names(loose_[at]);
      const Words parts = is_list ? parts_of(loose_[at]) : Words{loose_[at]};
      is_changed_ = is_changed_ || is_list;
      parted.insert(parted.end(), parts.begin(), parts.end());
    }
    loose_ = std::move(parted);
  }

  /// `configure can0 battery.dcf 10`: where a word has not the form of its place, and all of them
  /// fit in one other order alone, that is meant. Where a second word might be the node, none is;
  /// nor where it is a number that no node has, or nodes may have names.
  bool order_by_form() {
    constexpr std::size_t words_max = 6;
    const bool is_left = places_.empty() || loose_.size() > words_max || fits(loose_);
    if (is_left || may_have_names() || has_mistyped_node()) return false;
    std::vector<std::size_t> order(loose_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::optional<Words> found;
    while (std::ranges::next_permutation(order).found) {
      Words tried;
      for (const std::size_t at : order) tried.push_back(loose_[at]);
      if (!fits(tried)) continue;
      if (found && formed(*found) != formed(tried)) return false;
      if (!found) found = std::move(tried);
    }
    if (!found) return false;
    loose_ = *std::move(found);
    is_changed_ = true;
    return true;
  }
  bool may_have_names() const {
    const char* const file = std::getenv("CANVOY_NETWORK");
    return (file != nullptr && *file != '\0') || is_said("--network");
  }
  /// `write can0 200 1017 10` has no other node than 200.
  bool has_mistyped_node() const {
    for (std::size_t at = 0; at < loose_.size(); ++at) {
      const PlaceForm* const form = form_at(at);
      const bool is_node_place = form != nullptr && form->fits == is_node;
      if (is_node_place && is_small_number(loose_[at]) && !is_node(loose_[at])) return true;
    }
    return false;
  }
  /// The form of the place at which a word stands; null: any word may stand there.
  const PlaceForm* form_at(std::size_t at) const {
    const auto* const form = std::ranges::find(
        place_forms, places_[std::min(at, places_.size() - 1)].name, &PlaceForm::place);
    return form == place_forms.end() ? nullptr : form;
  }
  bool fits(const Words& words) const {
    for (std::size_t at = 0; at < words.size(); ++at) {
      const PlaceForm* const form = form_at(at);
      if (form != nullptr && !form->fits(words[at])) return false;
    }
    return true;
  }
  /// The words at places that have a form.
  Words formed(const Words& words) const {
    Words made;
    for (std::size_t at = 0; at < words.size(); ++at) {
      if (form_at(at) != nullptr) made.push_back(words[at]);
    }
    return made;
  }

  /// Puts the words in the order of the places; false if one is missing before another.
  bool place_named_words() {
    if (named_.empty()) return true;
    Words ordered;
    std::size_t next = 0;
    for (const OptionInfo& place : places_) {
      const auto named = named_.find(place.name);
      if (named != named_.end()) {
        // Behind what else may stand there.
        while (place.takes_several && next < loose_.size()) ordered.push_back(loose_[next++]);
        ordered.push_back(named->second);
      } else if (next < loose_.size()) {
        ordered.push_back(loose_[next++]);
      } else if (place.is_required) {
        return false;
      }
    }
    ordered.insert(ordered.end(), loose_.begin() + static_cast<std::ptrdiff_t>(next), loose_.end());
    loose_ = std::move(ordered);
    return true;
  }

  std::vector<OptionInfo> options_;
  std::vector<OptionInfo> places_;
  Words words_;                               ///< the verb, and verbs below it
  Words loose_;                               ///< words without an option
  Words said_;                                ///< options with their values
  std::map<std::string, std::string> named_;  ///< words of places, by their names
  bool is_changed_ = false;
  bool has_unknown_ = false;  ///< an option that the verb will refuse
  bool misses_value_ = false;
  bool has_other_spelling_ = false;
};

/// The verb below with this name.
const Verb* verb_below(const Verb& verb, const std::string& name) {
  const auto found = std::ranges::find_if(
      verb.verbs(), [&name](const std::unique_ptr<Verb>& each) { return each->name() == name; });
  return found == verb.verbs().end() ? nullptr : found->get();
}

/// The innermost verb that the words begin with, and the number of words of its name.
struct Innermost {
  const Verb* verb;
  std::size_t count = 0;
};
Innermost innermost(const Words& words, const Verb& line) {
  Innermost found{&line};
  while (found.count < words.size()) {
    const Verb* const below = verb_below(*found.verb, words[found.count]);
    if (below == nullptr) break;
    found.verb = below;
    ++found.count;
  }
  return found;
}

}  // namespace

std::vector<std::string> with_known_options(std::vector<std::string> words, const Verb& line) {
  const Innermost found = innermost(words, line);
  if (found.count == 0) return words;
  std::optional<Words> meant = TypedOptions(words, *found.verb, found.count).meant();
  return meant ? *std::move(meant) : words;
}

FrontFit fit_of_front(const Words& front, const Words& words, const Verb& line) {
  const Innermost found = innermost(words, line);
  return found.count == 0 ? FrontFit::none : TypedOptions(front, *found.verb, 0).fit();
}

}  // namespace canvoy::tools
