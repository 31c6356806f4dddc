#include "canvoy/tools/node/word_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/sim/duration_text.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/argument/unit_argument.hpp"
#include "canvoy/tools/argument/value_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"

namespace canvoy::tools {

namespace {

using Words = std::vector<std::string>;

/// `0x1017` and `1017h` as `1017`; empty if it is no index.
std::string index_digits(std::string_view word) {
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h') || word.ends_with('H')) word.remove_suffix(1);
  constexpr std::size_t digits = 4;
  const bool is_index = word.size() == digits &&
                        word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_index ? std::string(word) : std::string();
}

/// Like index_digits(), but for a sub-index: `0`, `01h`, `0x1F`.
std::string sub_digits(std::string_view word) {
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h') || word.ends_with('H')) word.remove_suffix(1);
  const bool is_sub = !word.empty() && word.size() <= 2 &&
                      word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  return is_sub ? std::string(word) : std::string();
}

/// Joins index and sub-index at `at` and after it into one word.
bool join_index(Words& words, std::size_t at) {
  const std::string index = index_digits(words.at(at));
  const std::string sub = sub_digits(words.at(at + 1));
  if (index.empty() || sub.empty()) return false;
  words[at] = index + ':' + sub;
  erase_words(words, at + 1);
  return true;
}

constexpr std::size_t node_at = 2;
constexpr std::size_t object_at = 3;

/// `reset node`, `reset comm` and the like as one word, and the node in front of it.
void order_nmt(Words& words) {
  for (std::size_t at = node_at; at < count_places(words); ++at) {
    const std::string joined = words[at] + '-' + words[at + 1];
    if (!is_nmt_word(joined)) continue;
    words[at] = joined;
    erase_words(words, at + 1);
  }
  if (count_places(words) != object_at) return;
  if (is_nmt_word(words[node_at]) && !is_nmt_word(words[object_at])) {
    std::swap(words[node_at], words[object_at]);
  }
}

void order_lss(Words& words) {
  if (count_places(words) < 2) return;
  // `set node 20`, `get node` and `conf bitrate 250` as one word.
  for (const std::string_view first : {"set", "get", "conf", "configure", "inquire"}) {
    if (words[2] != first || count_places(words) < 3 || is_small_number(words[3])) continue;
    words[2] += '-' + words[3];
    erase_words(words, 3);
  }
  struct OtherCommand {
    std::string_view typed;
    std::string_view meant;
  };
  constexpr auto others = std::to_array<OtherCommand>({{"fastscan", "scan"},
                                                       {"lssfastscan", "scan"},
                                                       {"find", "scan"},
                                                       {"bitrate", "set-bit-rate"},
                                                       {"baudrate", "set-bit-rate"},
                                                       {"baud", "set-bit-rate"},
                                                       {"setbitrate", "set-bit-rate"},
                                                       {"setbaudrate", "set-bit-rate"},
                                                       {"setbaud", "set-bit-rate"},
                                                       {"confbitrate", "set-bit-rate"},
                                                       {"configurebitrate", "set-bit-rate"},
                                                       {"node", "set-node-id"},
                                                       {"nodeid", "set-node-id"},
                                                       {"setnode", "set-node-id"},
                                                       {"setid", "set-node-id"},
                                                       {"confnode", "set-node-id"},
                                                       {"configurenodeid", "set-node-id"},
                                                       {"get", "inquire"},
                                                       {"getnode", "inquire"},
                                                       {"getnodeid", "inquire"},
                                                       {"inquirenodeid", "inquire"},
                                                       {"identity", "inquire"},
                                                       {"save", "store"}});
  for (const OtherCommand& other : others) {
    if (same_name(words[2], other.typed)) words[2] = other.meant;
  }
}

/// `u16` behind an object, as in the commands of CiA 309-3, is its type.
void take_type(Words& words) {
  // The one word behind an object to write is its value.
  const bool is_value = words.front() == "write" && count_places(words) == object_at + 1;
  for (std::size_t at = object_at + 1; !is_value && at <= count_places(words); ++at) {
    if (!parse_type(words[at]) || words[at].size() < 2) continue;
    words.insert(words.end(), {"--type", words[at]});
    return erase_words(words, at);
  }
}

/// `1017=500` and `1017 = 500` as `1017 500`; `500 ms` as one value.
void join_value(Words& words) {
  const std::size_t sign = words[object_at].find('=');
  if (count_places(words) == object_at && sign != std::string::npos) {
    words.insert(words.begin() + object_at + 1, words[object_at].substr(sign + 1));
    words[object_at].resize(sign);
  }
  if (count_places(words) > object_at + 1 && words[object_at + 1] == "=") {
    erase_words(words, object_at + 1);
  }
  const std::size_t last = count_places(words);
  const bool has_unit = last > object_at + 1 && find_filter_unit(words[last]) &&
                        words[last].find_first_of("0123456789") == std::string::npos;
  if (!has_unit) return;
  words[last - 1] += ' ' + words[last];
  erase_words(words, last);
}

void order_object(Words& words) {
  const std::string verb = words.front();
  if (count_places(words) < object_at) return;
  if (verb != "expect") take_type(words);
  if (verb == "write") join_value(words);
  const std::size_t with_sub = verb == "read" ? object_at + 1 : object_at + 2;
  if (verb != "expect" && count_places(words) == with_sub) join_index(words, object_at);
  for (std::size_t at = object_at; at <= count_places(words); ++at) {
    const std::string index = index_digits(words[at]);
    if (!index.empty() && words[at].size() > index.size()) words[at] = index;
    if (verb != "read") break;
  }
}

/// `tpdo 1` as `tpdo1`.
void join_pdo(Words& words) {
  if (count_places(words) <= object_at || !is_small_number(words[object_at + 1])) return;
  if (!same_name(words[object_at], "tpdo") && !same_name(words[object_at], "rpdo")) return;
  words[object_at] += words[object_at + 1];
  erase_words(words, object_at + 1);
}

/// `123`, `0x123`, `123h` with three or eight digits; empty: no identifier.
std::string can_id_digits(std::string_view word) {
  constexpr std::size_t standard = 3;
  constexpr std::size_t extended = 8;
  if (word.starts_with("0x") || word.starts_with("0X")) word.remove_prefix(2);
  if (word.ends_with('h')) word.remove_suffix(1);
  const bool is_number = !word.empty() && word.size() <= extended &&
                         word.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  if (!is_number) return {};
  const bool is_standard = word.size() < standard || (word.size() == standard && word[0] < '8');
  return std::string((is_standard ? standard : extended) - word.size(), '0') + std::string(word);
}

/// `60A 40 18 10` and `60A 401810` as `60A#401810`, `0x60A#40` as `60A#40`.
void join_frame(Words& words) {
  const std::size_t last = count_places(words);
  if (last < node_at) return;
  const std::size_t sign = words[node_at].find('#');
  if (sign != std::string::npos) {
    for (std::size_t at = node_at; at <= last; ++at) {
      if (words[at].starts_with("0x")) words[at].erase(0, 2);
    }
    return;
  }
  const std::string id = can_id_digits(words[node_at]);
  if (id.empty() || last == node_at) return;
  std::string bytes;
  for (std::size_t at = object_at; at <= last; ++at) {
    std::string digits = words[at].starts_with("0x") ? words[at].substr(2) : words[at];
    if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) return;
    if (digits.size() == 1) digits.insert(0, 1, '0');
    bytes += digits;
  }
  const bool may_be_length =
      words[object_at] == std::to_string(last - object_at) && last > object_at;
  if (may_be_length) {
    throw UsageError(fmt::format("is {1} the length? canvoy send {0} {2}#{3}, or {2}#{4}", words[1],
                                 words[object_at], id, bytes.substr(2), bytes));
  }
  words[node_at] = id + '#' + bytes;
  erase_words(words, object_at, last + 1 - object_at);
}

/// Bytes behind the error register are those of `--data`.
void join_emergency(Words& words) {
  constexpr std::size_t data_at = 5;
  const std::size_t last = count_places(words);
  if (last < data_at) return;
  std::string bytes;
  for (std::size_t at = data_at; at <= last; ++at) {
    if (sub_digits(words[at]).empty()) return;
    if (!bytes.empty()) bytes += ' ';
    bytes +=
        sub_digits(words[at]).size() == 1 ? '0' + sub_digits(words[at]) : sub_digits(words[at]);
  }
  erase_words(words, data_at, last + 1 - data_at);
  words.insert(words.end(), {"--data", bytes});
}

/// `wait can0 10 heartbeat`: the node stands where other verbs have it.
void use_node_in_filter(Words& words) {
  if (count_places(words) < object_at || !find_node_id(words[node_at])) return;
  if (parse_duration(words[node_at] + words[object_at])) return;
  words[node_at].insert(0, "node=");
  words.insert(words.begin() + object_at, "and");
}

}  // namespace

void erase_words(Words& words, std::size_t at, std::size_t count) {
  const auto first = words.begin() + static_cast<std::ptrdiff_t>(at);
  words.erase(first, first + static_cast<std::ptrdiff_t>(count));
}

std::optional<std::string> take_option(Words& words, std::initializer_list<std::string_view> names,
                                       bool (*is_value)(std::string_view)) {
  for (std::size_t at = 1; at + 1 < words.size(); ++at) {
    if (std::ranges::find(names, words[at]) == names.end() || !is_value(words[at + 1])) continue;
    std::string value = words[at + 1];
    erase_words(words, at, 2);
    return value;
  }
  return std::nullopt;
}

std::size_t count_places(const Words& words) {
  const auto option = std::find_if(words.begin() + 1, words.end(), [](const std::string& word) {
    return word.size() > 1 && word.starts_with('-');
  });
  return static_cast<std::size_t>(option - words.begin()) - 1;
}

bool is_small_number(std::string_view word) {
  return !word.empty() && word.size() <= 3 &&
         word.find_first_not_of("0123456789") == std::string_view::npos;
}

void order_words(Words& words) {
  const std::string verb = words.front();  // words are inserted below
  if (verb == "nmt") order_nmt(words);
  if (verb == "lss") order_lss(words);
  if (verb == "read" || verb == "write" || verb == "expect") order_object(words);
  if (verb == "pdo") join_pdo(words);
  if (verb == "send") join_frame(words);
  if (verb == "emcy") join_emergency(words);
  if (verb == "wait") use_node_in_filter(words);
}

}  // namespace canvoy::tools
