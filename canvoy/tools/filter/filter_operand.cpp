#include "canvoy/tools/filter/filter_operand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/tools/argument/node_argument.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/filter/filter_literal.hpp"

namespace canvoy::tools {

namespace {

[[noreturn]] void refuse(const FilterClause& clause, const FilterPhrase& phrase,
                         std::string_view problem) {
  throw FilterError(clause.filter, phrase.position, problem);
}

bool is_equation(const FilterClause& clause) {
  return clause.comparison == FilterTokenKind::equal ||
         clause.comparison == FilterTokenKind::unequal;
}

void want_equation(const FilterClause& clause, std::string_view example) {
  if (is_equation(clause)) return;
  refuse(clause, clause.subject, fmt::format("write {}", example));
}

/// Numbers in order, read by `parse`.
template <class Parse>
FilterRanges ranges_of(const FilterClause& clause, FilterRange all, const Parse& parse) {
  FilterRanges made;
  for (const FilterOperand& operand : clause.operands) {
    const std::int64_t first = parse(operand.first);
    const std::int64_t last = operand.last ? parse(*operand.last) : first;
    if (last < first) refuse(clause, operand.first, "the range ends before it begins");
    if (is_equation(clause)) {
      made.add({first, last});
    } else if (operand.last || clause.operands.size() > 1) {
      refuse(clause, operand.first, "one value is expected behind < and >");
    } else if (clause.comparison == FilterTokenKind::less ||
               clause.comparison == FilterTokenKind::less_or_equal) {
      made.add({all.low, clause.comparison == FilterTokenKind::less ? first - 1 : first});
    } else {
      made.add({clause.comparison == FilterTokenKind::greater ? first + 1 : first, all.high});
    }
  }
  if (made.empty()) refuse(clause, clause.subject, fmt::format("'{}' is never so", clause.text));
  return made;
}

std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
  std::uint32_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, number, 16);
  if (error != std::errc{} || last != end) return std::nullopt;
  return number;
}

/// `0x1F`, `1Fh`: the digits; nothing: not marked as hexadecimal.
std::optional<std::string_view> hexadecimal_digits(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) return text.substr(2);
  if (text.ends_with('h') || text.ends_with('H')) return text.substr(0, text.size() - 1);
  return std::nullopt;
}

std::int64_t node_of(const FilterClause& clause, const FilterPhrase& phrase) {
  std::optional<std::uint32_t> node;
  if (const auto digits = hexadecimal_digits(phrase.text)) {
    node = hexadecimal(*digits);
  } else {
    std::uint32_t number = 0;
    const char* const end = phrase.text.data() + phrase.text.size();
    const auto [last, error] = std::from_chars(phrase.text.data(), end, number);
    if (error == std::errc{} && last == end) node = number;
  }
  if (node && is_node_id(*node)) return *node;
  const std::vector<NamedNode> named = nodes_called(phrase.text);
  if (named.size() == 1) return named.front().id;
  if (!named.empty()) {
    refuse(clause, phrase, fmt::format("'{}' is several: {}", phrase.text, choices_text(named)));
  }
  refuse(clause, phrase, fmt::format("'{}' is no node-ID: 1 to 127, or 01h to 7Fh", phrase.text));
}

std::int64_t can_id_of(const FilterClause& clause, const FilterPhrase& phrase) {
  constexpr std::size_t digits_of_29_bits = 8;
  const std::string_view text = phrase.text;
  const std::string_view digits = hexadecimal_digits(text).value_or(text);
  const auto id = hexadecimal(digits);
  if (!id || *id > Frame::extended_id_max) {
    refuse(
        clause, phrase,
        fmt::format("'{}' is no CAN-ID: three hexadecimal digits to 7FF, eight to 1FFFFFFF", text));
  }
  const bool is_extended = digits.size() == digits_of_29_bits || *id > Frame::id_max;
  return is_extended ? *id + filter_extended_id : *id;
}

FilterCondition of_buses(const FilterClause& clause) {
  want_equation(clause, "bus=can0, or bus=can0,can1");
  FilterCondition made{.by = FilterBy::bus};
  for (const FilterOperand& operand : clause.operands) {
    if (operand.last) refuse(clause, operand.first, "buses have no order: write bus=can0,can1");
    made.names.push_back(operand.first.text);
  }
  return made;
}

FilterCondition of_nodes(const FilterClause& clause) {
  if (clause.operands.empty()) refuse(clause, clause.subject, "write node=5, or node=5..10");
  const FilterRange all{1, node_id_max};
  return {.by = FilterBy::node, .ranges = ranges_of(clause, all, [&](const FilterPhrase& phrase) {
                                  return node_of(clause, phrase);
                                })};
}

/// The identifiers that are as the first number in the bits of the second, `180:780`, as candump
/// chooses them: a range for each value of the bits between those that are compared. With no bit,
/// `0:0`, they are all of its length.
void add_masked(FilterRanges& made, const FilterClause& clause, const FilterPhrase& phrase) {
  constexpr int free_bits_max = 8;
  const std::size_t colon = phrase.text.find(':');
  const std::int64_t id =
      can_id_of(clause, {.position = phrase.position, .text = phrase.text.substr(0, colon)});
  const auto mask = hexadecimal(std::string_view(phrase.text).substr(colon + 1));
  if (!is_equation(clause) || !mask) refuse(clause, phrase, "a mask is written id=180:780");
  const std::int64_t length = id >= filter_extended_id ? filter_extended_id : 0;
  const std::uint32_t all = length != 0 ? Frame::extended_id_max : Frame::id_max;
  const std::uint32_t compared = *mask & all;
  const std::uint32_t below = compared == 0 ? all : (compared & (~compared + 1)) - 1;
  const std::uint32_t between = all & ~compared & ~below;
  if (std::popcount(between) > free_bits_max) {
    refuse(clause, phrase, "the mask leaves out too many bits between those that it has");
  }
  const std::int64_t first = length + (id & static_cast<std::int64_t>(compared));
  std::uint32_t bits = 0;
  do {
    made.add({first + bits, first + bits + below});
    bits = (bits - between) & between;
  } while (bits != 0);
}

FilterCondition of_can_ids(const FilterClause& clause) {
  if (clause.operands.empty()) refuse(clause, clause.subject, "write id=18A, or id=180..1FF");
  const FilterRange all{0, filter_extended_id + Frame::extended_id_max};
  FilterCondition made{.by = FilterBy::can_id};
  FilterClause plain = clause;
  std::erase_if(plain.operands, [](const FilterOperand& operand) {
    return operand.first.text.find(':') != std::string::npos;
  });
  if (!plain.operands.empty()) {
    made.ranges = ranges_of(plain, all,
                            [&](const FilterPhrase& phrase) { return can_id_of(clause, phrase); });
  }
  for (const FilterOperand& operand : clause.operands) {
    if (operand.first.text.find(':') != std::string::npos) {
      add_masked(made.ranges, clause, operand.first);
    }
  }
  return made;
}

/// `18A`, `0x18A`, `0000018A`, and as candump chooses them `180:780`: with as many digits as an
/// identifier has, and one that is no letter.
bool is_can_id(std::string_view text) {
  constexpr std::size_t standard = 3;
  constexpr std::size_t extended = 8;
  std::string_view id = text.substr(0, text.find(':'));
  const bool has_prefix = id.starts_with("0x") || id.starts_with("0X");
  if (has_prefix) id.remove_prefix(2);
  const bool has_length =
      id.size() == standard || id.size() == extended || (has_prefix && id.size() < standard);
  constexpr std::string_view decimals = "0123456789";
  return has_length && id.find_first_of(decimals) != std::string_view::npos &&
         id.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

/// True if it is the name of a service, without its number.
bool is_of_service(const std::string& plain) {
  return std::ranges::any_of(filter_services(), [&](const std::string& service) {
    return has_name_but_for_numbers(plain_name(service), plain);
  });
}

FilterCondition of_services(const FilterClause& clause) {
  want_equation(clause, "service=SDO, or service=EMCY,heartbeat");
  FilterCondition made{.by = FilterBy::service};
  for (const FilterOperand& operand : clause.operands) {
    const std::string plain = plain_name(operand.first.text);
    if (operand.last || plain.empty() || !is_of_service(plain)) {
      refuse(clause, operand.first,
             fmt::format("no service is called '{}'{}", operand.first.text,
                         did_you_mean(operand.first.text, filter_services())));
    }
    made.names.push_back(plain);
  }
  return made;
}

FilterCondition of_texts(const FilterClause& clause) {
  want_equation(clause, "text=bus-off");
  FilterCondition made{.by = FilterBy::text};
  for (const FilterOperand& operand : clause.operands) {
    const std::string plain = plain_name(operand.first.text);
    if (operand.last || plain.empty()) refuse(clause, operand.first, "write text=bus-off");
    made.names.push_back(plain);
  }
  return made;
}

FilterCondition of_marks(const FilterClause& clause) {
  FilterCondition made{.by = FilterBy::marks};
  if (clause.operands.empty()) return made;
  want_equation(clause, "marks, or marks=reserved");
  std::vector<std::string> known;
  known.reserve(decoder::all_marks.size());
  for (const decoder::Mark mark : decoder::all_marks) known.emplace_back(decoder::mark_name(mark));
  for (const FilterOperand& operand : clause.operands) {
    const std::string plain = plain_name(operand.first.text);
    const auto* const mark = std::ranges::find_if(decoder::all_marks, [&](decoder::Mark candidate) {
      return plain_name(decoder::mark_name(candidate)) == plain;
    });
    if (operand.last || mark == decoder::all_marks.end()) {
      refuse(clause, operand.first,
             fmt::format("no mark is called '{}'{}", operand.first.text,
                         did_you_mean(operand.first.text, known)));
    }
    made.marks.push_back(*mark);
  }
  return made;
}

FilterCondition of_times(const FilterClause& clause) {
  if (clause.operands.empty()) refuse(clause, clause.subject, "write time>10s, or time=10s..1min");
  const auto read = [&](const FilterPhrase& phrase) {
    const auto point = parse_filter_time(phrase.text);
    if (!point) {
      refuse(
          clause, phrase,
          fmt::format("'{}' is no time: 10s or 1h30min from the first frame on, or as lines have "
                      "it: 1700000000.5, or 2026-11-21 12:00:00",
                      phrase.text));
    }
    return *point;
  };
  const bool is_since_first = read(clause.operands.front().first).is_since_first;
  const auto parse = [&](const FilterPhrase& phrase) {
    const FilterTime point = read(phrase);
    if (point.is_since_first != is_since_first) {
      refuse(clause, phrase, "a span from the first frame on and a point in time are mixed");
    }
    return point.time.count();
  };
  return {.by = is_since_first ? FilterBy::since_first : FilterBy::time,
          .ranges = ranges_of(clause, FilterRange{}, parse)};
}

/// For objects: a name may be followed by several alternatives.
FilterCondition of_object(const FilterClause& clause, const FilterPhrase& phrase,
                          const FilterNames& names) {
  FilterCondition made{.by = FilterBy::value};
  made.value = FilterValue(filter_object(clause, phrase, names));
  return made;
}

/// True for the services that a bare word names: `SDO` is both of its services.
bool is_bare_service(const std::string& plain) {
  constexpr std::array<std::string_view, 5> kinds = {"sdo", "tpdo", "rpdo", "guarding", "pdo"};
  if (std::ranges::find(kinds, plain) != kinds.end()) return true;
  return std::ranges::any_of(filter_services(), [&](const std::string& service) {
    return is_name_but_for_numbers(plain_name(service), plain);
  });
}

FilterCondition of_bare_word(const FilterClause& clause, const FilterNames& names) {
  const std::string plain = plain_name(clause.subject.text);
  const bool is_of_frames = !clause.subject.is_quoted && is_can_id(clause.subject.text) &&
                            names.find({.name = plain}).empty();
  if (is_of_frames) {
    FilterClause equation = clause;
    equation.comparison = FilterTokenKind::equal;
    equation.operands = {{clause.subject, std::nullopt}};
    return of_can_ids(equation);
  }
  if (clause.subject.is_quoted || !is_bare_service(plain)) {
    return of_object(clause, clause.subject, names);
  }
  FilterCondition made{.by = FilterBy::service, .names = {plain}};
  return made;
}

/// Compares values of an object, or only finds them if the filter has just its name.
FilterCondition of_values(const FilterClause& clause, const FilterNames& names) {
  if (clause.comparison == FilterTokenKind::end) return of_bare_word(clause, names);
  FilterCondition made = of_object(clause, clause.subject, names);
  compare(made.value, clause, names);
  return made;
}

FilterCondition of_any_object(const FilterClause& clause, const FilterNames& names) {
  want_equation(clause, "object=temperature, or object=6010");
  if (clause.operands.size() != 1) {
    refuse(clause, clause.operands[1].first, "write object=A or object=B");
  }
  const FilterOperand& operand = clause.operands.front();
  if (!operand.last) return of_object(clause, operand.first, names);
  FilterCondition made{.by = FilterBy::value};
  made.value = FilterValue(filter_objects(clause, operand));
  return made;
}

FilterCondition of_subject(const FilterClause& clause, const FilterNames& names) {
  const std::string subject = clause.subject.is_quoted ? "" : plain_name(clause.subject.text);
  const bool compares = clause.comparison != FilterTokenKind::end;
  if (subject == "marks" || subject == "mark") return of_marks(clause);
  if (subject == "bus") return of_buses(clause);
  if (subject == "node") return of_nodes(clause);
  if (subject == "id" || subject == "can id") return of_can_ids(clause);
  if (subject == "service") return of_services(clause);
  if (subject == "text" && compares) return of_texts(clause);
  if (subject == "object") return of_any_object(clause, names);
  if (subject == "time" && compares) return of_times(clause);
  return of_values(clause, names);
}

}  // namespace

FilterCondition understand(const FilterClause& clause, const FilterNames& names) {
  FilterCondition made = of_subject(clause, names);
  made.written = clause.text;
  return made;
}

std::vector<std::string> filter_services() {
  return {"NMT",
          "SYNC",
          "TIME",
          "EMCY",
          "TPDO#",
          "RPDO#",
          "PDO",
          "SDO request",
          "SDO response",
          "boot-up",
          "heartbeat",
          "error control",
          "LSS",
          "guarding request",
          "guarding answer",
          "SDO manager",
          "flying master",
          "sleep",
          "ISO-TP",
          "29-bit frame",
          "error frame",
          "other"};
}

}  // namespace canvoy::tools
