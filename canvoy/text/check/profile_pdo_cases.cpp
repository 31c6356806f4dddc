// The predefined PDOs of a profile: for each one that a device has, its CAN-ID, transmission type
// and content.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint16_t last_dummy = 0x0007;
constexpr unsigned entries_mapped_max = 64;

/// One PDO of a profile, with a copy of its mapping.
struct Printed {
  PdoInfo info;
  std::vector<std::uint32_t> mapping;
};
/// PDOs that are one message: of all lifts, or of one number.
using Message = std::vector<Printed>;

/// A PDO of the device.
struct Present {
  std::uint16_t parameter;
  std::uint32_t cob_id;
  std::uint32_t type;
  std::vector<std::uint32_t> mapping;
};

bool sends(const PdoInfo& pdo) {
  return pdo.direction == PdoInfo::Direction::transmit;
}
std::uint16_t parameter_of(const PdoInfo& pdo, unsigned number) {
  const unsigned first = sends(pdo) ? object_index::tpdo_parameter : object_index::rpdo_parameter;
  return static_cast<std::uint16_t>(first + number - 1);
}
bool is_dummy(std::uint32_t mapped) {
  return mapped >> 16 <= last_dummy;
}

std::optional<Present> find_present(Bench& bench, const PdoInfo& pdo, unsigned number) {
  constexpr unsigned to_mapping = 0x200;
  Present present{.parameter = parameter_of(pdo, number), .cob_id = 0, .type = 0, .mapping = {}};
  const auto mapping = static_cast<std::uint16_t>(present.parameter + to_mapping);
  if (!bench.has(present.parameter, 1)) return std::nullopt;
  present.cob_id = bench.number(present.parameter, 1).value_or(CobId::bit31);
  present.type = bench.number(present.parameter, 2).value_or(0);
  const auto count = bench.number(mapping, 0).value_or(0);
  if (count > entries_mapped_max) return std::nullopt;
  for (unsigned sub = 1; sub <= count; ++sub) {
    present.mapping.push_back(bench.number(mapping, static_cast<std::uint8_t>(sub)).value_or(0));
  }
  return present;
}

/// A PDO of this number without any entry of the profile is a different one.
bool is_the_one(const Printed& printed, const Present& present) {
  return std::ranges::any_of(present.mapping, [&](std::uint32_t mapped) {
    return !is_dummy(mapped) && std::ranges::find(printed.mapping, mapped) != printed.mapping.end();
  });
}

/// Entries in order; a device may omit missing entries or map them to a dummy.
bool carries_in_order(const Printed& printed, const Present& present) {
  auto place = printed.mapping.begin();
  for (const std::uint32_t mapped : present.mapping) {
    if (is_dummy(mapped)) continue;
    place = std::find(place, printed.mapping.end(), mapped);
    if (place == printed.mapping.end()) return false;
    ++place;
  }
  return true;
}

/// Public sources for part 3 of CiA 417 leave some CAN-IDs open.
bool has_certain_can_id(const PdoInfo& pdo) {
  const bool is_printed = (pdo.cob_id & CobId::bit31) == 0 || pdo.plus_node_id;
  const auto says = [&pdo](std::string_view words) {
    return pdo.condition.find(words) != std::string_view::npos;
  };
  return is_printed && !says("inferred") && !says("from one source");
}

/// For another part of the profile, which is not available, only event-driven transmission is
/// required.
bool is_type_as_printed(const PdoInfo& pdo, std::uint32_t type) {
  const bool is_of_other_part = pdo.clause.starts_with("CiA ");
  const auto is_of_events = [](std::uint32_t each) {
    return each <= 0xFF && is_event_driven(static_cast<std::uint8_t>(each));
  };
  return type == pdo.transmission_type ||
         (is_of_other_part && is_of_events(type) && is_of_events(pdo.transmission_type));
}

/// The error; empty: none. A PDO that is switched off may have any CAN-ID.
std::string complaint(Bench& bench, const Printed& printed, const Present& present,
                      unsigned position) {
  const PdoInfo& pdo = printed.info;
  const std::string record = text::object_text(present.parameter, 1);
  if (!carries_in_order(printed, present)) {
    return fmt::format("{:04X}h maps other entries, or in another order",
                       present.parameter + 0x200);
  }
  const unsigned added = pdo.plus_node_id ? bench.node() : 0U;
  const std::uint32_t can_id = (pdo.cob_id & Frame::id_max) + added + position;
  const bool is_valid = CobId{present.cob_id}.valid();
  if (has_certain_can_id(pdo) && is_valid && (present.cob_id & Frame::id_max) != can_id) {
    return fmt::format("{} is {:08X}h in place of {:03X}h", record, present.cob_id, can_id);
  }
  if (!is_type_as_printed(pdo, present.type)) {
    return fmt::format("{} is {} in place of {}", text::object_text(present.parameter, 2),
                       present.type, pdo.transmission_type);
  }
  return {};
}

/// Several PDOs of one number are alternatives: a device has one of them.
Verdict judge_message(Bench& bench, const Message& message) {
  std::map<std::uint16_t, std::string> found;
  for (const Printed& printed : message) {
    const unsigned last = std::max(printed.info.number, printed.info.last_number);
    for (unsigned number = printed.info.number; number <= last; ++number) {
      const auto present = find_present(bench, printed.info, number);
      if (!present || !is_the_one(printed, *present)) continue;
      const std::string wrong = complaint(bench, printed, *present, number - printed.info.number);
      const auto [place, is_new] = found.try_emplace(present->parameter, wrong);
      if (!is_new && wrong.empty()) place->second.clear();
    }
  }
  if (found.empty()) return not_applicable("the device has no such PDO");
  for (const auto& [parameter, wrong] : found) {
    if (!wrong.empty()) return failed(wrong);
  }
  return passed();
}

std::string clause_of(const Profile& profile, const PdoInfo& pdo) {
  if (pdo.clause.starts_with("CiA ")) return std::string(pdo.clause);
  return pdo.clause.empty() ? std::string(profile.name)
                            : fmt::format("{}, {}", profile.name, pdo.clause);
}

/// `tpdo-65`; for a message with its own number for each lift, that of the first. Another message
/// with the same number, of other virtual devices, is `tpdo-65b`.
std::string name_of(const PdoInfo& pdo, std::map<std::string, unsigned>& used) {
  const std::string name = fmt::format("{}-{}", sends(pdo) ? "tpdo" : "rpdo", pdo.number);
  const unsigned before = used[name]++;
  return before == 0 ? name : name + static_cast<char>('a' + before);
}

}  // namespace

void add_profile_pdo_cases(TestCases& cases, const Profile& profile) {
  std::vector<std::pair<std::string, Message>> messages;
  for_each_pdo(profile, [&](const PdoInfo& pdo) {
    if (pdo.number == 0 || pdo.multiplexed != MpdoKind::no || pdo.mapping.empty()) return;
    const std::string key =
        fmt::format("{} {}", sends(pdo) ? "t" : "r",
                    pdo.name.empty() ? std::to_string(pdo.number) : std::string(pdo.name));
    auto place = std::ranges::find(messages, key, &std::pair<std::string, Message>::first);
    if (place == messages.end()) place = messages.insert(place, {key, {}});
    place->second.push_back({pdo, {pdo.mapping.begin(), pdo.mapping.end()}});
    place->second.back().info.mapping = {};
  });
  std::map<std::string, unsigned> used;
  for (auto& [key, message] : messages) {
    const PdoInfo& pdo = message.front().info;
    const std::string what = pdo.name.empty() ? std::string() : fmt::format(" ({})", pdo.name);
    const std::string clause = clause_of(profile, pdo);
    const std::string name = name_of(pdo, used);
    cases.push_back(
        {fmt::format("{}-{}", short_name(profile), name), Group::profile, clause,
         fmt::format("{} {}{} is as the profile prints it", sends(pdo) ? "TPDO" : "RPDO",
                     pdo.number, what),
         "uploads", "its CAN-ID while it is valid, transmission type and mapping",
         [message = std::move(message)](Bench& bench) { return judge_message(bench, message); }});
  }
}

}  // namespace canvoy::conformance
