// The predefined PDOs of a profile: for each one that a device has, its CAN-ID, transmission type
// and content.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint16_t last_dummy = 0x0007;
constexpr unsigned entries_mapped_max = 64;
constexpr unsigned to_mapping = 0x200;
// Sub-index 00h of the mapping of a multiplexed PDO.
constexpr unsigned source_mpdo = 0xFE;
constexpr unsigned destination_mpdo = 0xFF;

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

/// True if another part of the profile, which is not available, prints the PDO.
bool is_of_other_part(const PdoInfo& pdo) {
  return pdo.clause.starts_with("CiA ");
}

/// For another part of the profile, only event-driven transmission is required.
bool is_type_as_printed(const PdoInfo& pdo, std::uint32_t type) {
  const auto is_of_events = [](std::uint32_t each) {
    return each <= 0xFF && is_event_driven(static_cast<std::uint8_t>(each));
  };
  return type == pdo.transmission_type ||
         (is_of_other_part(pdo) && is_of_events(type) && is_of_events(pdo.transmission_type));
}

/// A PDO of the device that is one of the profile's.
struct Found {
  const Printed& printed;
  const Present& present;
  unsigned position;  ///< among several of one shape
};

// What is wrong; empty: nothing.

/// A PDO that is switched off may have any CAN-ID.
std::string find_wrong_can_id(Bench& bench, const Found& found) {
  const PdoInfo& pdo = found.printed.info;
  const CobId is{found.present.cob_id};
  if (!has_certain_can_id(pdo) || !is.valid()) return {};
  const unsigned added = pdo.plus_node_id ? bench.node() : 0U;
  const std::uint32_t can_id = (pdo.cob_id & Frame::id_max) + added + found.position;
  if ((found.present.cob_id & Frame::id_max) == can_id) return {};
  return fmt::format("{} is {:08X}h in place of {:03X}h",
                     text::object_text(found.present.parameter, 1), found.present.cob_id, can_id);
}

std::string find_wrong_type(Bench& /*bench*/, const Found& found) {
  if (is_type_as_printed(found.printed.info, found.present.type)) return {};
  return fmt::format("{} is {} in place of {}", text::object_text(found.present.parameter, 2),
                     found.present.type, found.printed.info.transmission_type);
}

std::string find_wrong_mapping(Bench& /*bench*/, const Found& found) {
  if (carries_in_order(found.printed, found.present)) return {};
  return fmt::format("{:04X}h maps other entries, or in another order",
                     found.present.parameter + to_mapping);
}

using FindWrong = std::string (*)(Bench&, const Found&);

/// Several PDOs of one number are alternatives: a device has one of them.
Verdict judge_message(Bench& bench, const Message& message, FindWrong find_wrong) {
  std::map<std::uint16_t, std::string> found;
  for (const Printed& printed : message) {
    const unsigned last = std::max(printed.info.number, printed.info.last_number);
    for (unsigned number = printed.info.number; number <= last; ++number) {
      const auto present = find_present(bench, printed.info, number);
      if (!present || !is_the_one(printed, *present)) continue;
      const std::string wrong =
          find_wrong(bench, {printed, *present, number - printed.info.number});
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

/// True if the PDO waits for its COB-ID: bit 31 is printed as set by default. In another part of
/// the profile, which is not available, bit 31 stands for a COB-ID that is not known.
bool is_off_by_default(const PdoInfo& pdo) {
  const bool is_printed = !is_of_other_part(pdo);
  return is_printed && (pdo.cob_id & CobId::bit31) != 0 && pdo.number != 0;
}

/// A device that may have stored another COB-ID is not judged by one that is valid.
Verdict judge_off(Bench& bench, const Message& message) {
  const Printed& printed = message.front();
  if (!find_present(bench, printed.info, printed.info.number)) {
    return not_applicable("the device has no such PDO");
  }
  if (reset_node(bench)) return not_applicable(no_boot_up);
  const auto present = find_present(bench, printed.info, printed.info.number);
  if (!present || !is_the_one(printed, *present)) {
    return not_applicable("the device has another PDO of this number");
  }
  if (!CobId{present->cob_id}.valid()) return passed();
  if (bench.has(object_index::store_parameters)) {
    return not_applicable("it is valid, which the device may have stored (1010h)");
  }
  return failed(fmt::format("{} is {:08X}h after a reset, without bit 31",
                            text::object_text(present->parameter, 1), present->cob_id));
}

/// Multiplexed by the destination or by the source: sub-index 00h of its mapping (CiA 301,
/// 7.2.2.5). A PDO with another CAN-ID than the printed one is a different one of this number.
Verdict judge_multiplexed(Bench& bench, const PdoInfo& pdo) {
  const std::uint16_t parameter = parameter_of(pdo, pdo.number);
  const auto cob_id = bench.number(parameter, 1);
  if (!cob_id) return not_applicable("the device has no such PDO");
  const unsigned added = pdo.plus_node_id ? bench.node() : 0U;
  const bool is_printed_id = (*cob_id & Frame::id_max) == (pdo.cob_id & Frame::id_max) + added;
  if (CobId{*cob_id}.valid() && !is_printed_id) {
    return not_applicable("the device has another PDO of this number");
  }
  const auto mapping = static_cast<std::uint16_t>(parameter + to_mapping);
  const unsigned wanted = pdo.multiplexed == MpdoKind::destination ? destination_mpdo : source_mpdo;
  const auto is = bench.number(mapping, 0);
  if (is == wanted) return passed();
  if (!CobId{*cob_id}.valid()) return not_applicable("it is switched off");
  return failed(fmt::format("{} is {} in place of {:02X}h", text::object_text(mapping, 0),
                            is ? fmt::format("{:02X}h", *is) : std::string("not read"), wanted));
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

struct ProfilePdoRow {
  std::string_view id;
  std::string_view title;
  std::string_view expects;
  FindWrong find_wrong;
};
constexpr ProfilePdoRow profile_pdo_rows[] = {
    {"can-id", "has its CAN-ID", "the CAN-ID while it is valid", find_wrong_can_id},
    {"type", "has its transmission type", "the transmission type", find_wrong_type},
    {"mapping", "carries its entries", "its entries in their order; dummies between them",
     find_wrong_mapping},
};

/// Cases of one message; `name` is `419-tpdo-1`, `what` is `TPDO 1`. Those that reset the device
/// are added to `resets`.
void add_message(TestCases& cases, TestCases& resets, const std::string& name,
                 const std::string& what, const std::string& clause, const Message& message) {
  const auto any = [&message](auto test) {
    return std::ranges::any_of(message, [&test](const Printed& each) { return test(each.info); });
  };
  const auto shared = std::make_shared<const Message>(message);
  for (const ProfilePdoRow& row : profile_pdo_rows) {
    if (row.find_wrong == find_wrong_can_id && !any(has_certain_can_id)) continue;
    cases.push_back(
        {fmt::format("{}-{}", name, row.id), Group::profile, clause,
         fmt::format("{} {}", what, row.title), "uploads", std::string(row.expects),
         [shared, &row](Bench& bench) { return judge_message(bench, *shared, row.find_wrong); }});
  }
  if (message.size() == 1 && any(is_off_by_default) && !any(has_certain_can_id)) {
    resets.push_back({name + "-off", Group::profile, clause,
                      what + " waits for its COB-ID behind a reset", "NMT 81h; an upload",
                      "bit 31 of its COB-ID",
                      [shared](Bench& bench) { return judge_off(bench, *shared); }});
  }
}

void add_multiplexed(TestCases& cases, const std::string& name, const std::string& what,
                     const std::string& clause, const PdoInfo& pdo) {
  cases.push_back({name + "-mpdo", Group::profile, clause,
                   what + " is multiplexed as the profile prints it", "uploads",
                   pdo.multiplexed == MpdoKind::destination
                       ? "sub-index 00h of its mapping is FFh (by the destination)"
                       : "sub-index 00h of its mapping is FEh (by the source)",
                   [pdo](Bench& bench) { return judge_multiplexed(bench, pdo); }});
}

/// The PDOs of a profile as messages, and the multiplexed ones.
struct Messages {
  std::vector<std::pair<std::string, Message>> plain;
  std::vector<PdoInfo> multiplexed;
};
Messages messages_of(const Profile& profile) {
  Messages all;
  for_each_pdo(profile, [&all](const PdoInfo& pdo) {
    if (pdo.number == 0) return;
    if (pdo.multiplexed != MpdoKind::no) return all.multiplexed.push_back(pdo);
    if (pdo.mapping.empty()) return;
    const std::string key =
        fmt::format("{} {}", sends(pdo) ? "t" : "r",
                    pdo.name.empty() ? std::to_string(pdo.number) : std::string(pdo.name));
    auto place = std::ranges::find(all.plain, key, &std::pair<std::string, Message>::first);
    if (place == all.plain.end()) place = all.plain.insert(place, {key, {}});
    place->second.push_back({pdo, {pdo.mapping.begin(), pdo.mapping.end()}});
    place->second.back().info.mapping = {};
  });
  return all;
}

}  // namespace

void add_profile_pdo_cases(TestCases& cases, const Profile& profile) {
  const Messages messages = messages_of(profile);
  TestCases resets;
  std::map<std::string, unsigned> used;
  const auto name = [&](const PdoInfo& pdo) {
    return fmt::format("{}-{}", short_name(profile), name_of(pdo, used));
  };
  const auto what = [](const PdoInfo& pdo) {
    const std::string named = pdo.name.empty() ? std::string() : fmt::format(" ({})", pdo.name);
    return fmt::format("{} {}{}", sends(pdo) ? "TPDO" : "RPDO", pdo.number, named);
  };
  for (const auto& [key, message] : messages.plain) {
    const PdoInfo& pdo = message.front().info;
    add_message(cases, resets, name(pdo), what(pdo), clause_of(profile, pdo), message);
  }
  for (const PdoInfo& pdo : messages.multiplexed) {
    add_multiplexed(cases, name(pdo), what(pdo), clause_of(profile, pdo), pdo);
  }
  cases.insert(cases.end(), resets.begin(), resets.end());
}

}  // namespace canvoy::conformance
