// The objects of a profile, from its data: mandatory ones of a virtual device exist, with their
// type and access, and with values that the profile defines.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/check/profile_rule.hpp"

namespace canvoy::conformance {

namespace {

using JudgeRuled = Verdict (*)(Bench&, const Ruled&);

struct ProfileRow {
  std::string_view id;
  std::string_view title;
  std::string_view sends;
  std::string_view expects;
  JudgeRuled judge;
};

/// In each block in which the device has the object (lift 1 to 8 of CiA 417); without one, in the
/// first block.
Verdict judge_in_blocks(Bench& bench, Ruled ruled, JudgeRuled judge) {
  const bool is_once = ruled.object->once || ruled.is_communication();
  const unsigned blocks = is_once ? 1 : ruled.profile->block_count;
  std::optional<Verdict> verdict;
  for (unsigned block = 0; block < blocks; ++block) {
    ruled.above = static_cast<std::uint16_t>(block * ruled.profile->block_pitch);
    if (!bench.has(ruled.index())) continue;
    Verdict here = judge(bench, ruled);
    if (here.outcome == Outcome::failed) return here;
    if (!verdict || here.outcome == Outcome::passed) verdict = here;
  }
  ruled.above = 0;
  return verdict ? *verdict : judge(bench, ruled);
}

constexpr ProfileRow profile_rows[] = {
    {"there", "is there where the virtual device must have it", "uploads", "no 0602 0000h",
     judge_there},
    {"type", "has the length of its type", "uploads", "as many bytes", judge_type},
    {"access", "is read and written as the profile says", "uploads; downloads of what was read",
     "0601 0001h, 0601 0002h where one may not", judge_access},
    {"value", "is nothing that is reserved", "uploads", "a value that the profile knows",
     judge_value},
    {"fields", "has nothing reserved in its bits", "uploads",
     "reserved bits as the profile prints them, and codes that it knows", judge_fields},
    {"range", "takes nothing beyond its range", "one less and one more", "0609 0030h to 0032h",
     judge_range},
    {"sentinel", "takes its code for \"no value\"", "a download of the code", "no abort",
     judge_sentinel},
    {"default", "has its default after a reset", "NMT 81h; uploads", "the printed default",
     judge_default},
};

template <class Test>
bool has_entry(const ObjectInfo& object, Test test) {
  return std::ranges::any_of(object.entries(), test);
}

/// True if some device must have the object.
bool is_mandatory_somewhere(const Profile& profile, const ObjectInfo& object) {
  const bool is_by_itself =
      profile.virtual_devices.empty() || Ruled{&profile, &object}.is_communication();
  if (is_by_itself) return object.category == Category::mandatory;
  return std::ranges::any_of(profile.virtual_devices, [&](const VirtualDeviceInfo& device) {
    const DeviceObject* const as = detail::find_device_object(device, object.index);
    return as != nullptr && as->category == Category::mandatory;
  });
}

/// True if this row has something to judge, for any device: a case that cannot fail is none.
bool applies(const ProfileRow& row, const Profile& profile, const ObjectInfo& object) {
  if (row.judge == judge_there) return is_mandatory_somewhere(profile, object);
  if (row.judge == judge_access) {
    const bool names_device = profile.device_type_of != nullptr;
    return has_entry(object, [names_device](const EntryInfo& each) {
      return has_access_rule(each) && (names_device || !has_access_by_device(each));
    });
  }
  if (row.judge == judge_range) return has_entry(object, has_range);
  if (row.judge == judge_default) return has_entry(object, has_default_after_reset);
  if (row.judge == judge_sentinel) {
    return has_entry(object, [](const EntryInfo& each) { return sentinel_of(each).has_value(); });
  }
  if (row.judge == judge_fields) {
    return has_entry(object, [](const EntryInfo& each) {
      return std::ranges::any_of(each.fields, has_reserved_values);
    });
  }
  if (row.judge == judge_value) return has_entry(object, has_unknown_values);
  if (row.judge == judge_type) {
    return has_entry(object, [](const EntryInfo& each) { return byte_length(each.type) != 0; });
  }
  return true;
}

std::string clause_of(const Profile& profile, const ObjectInfo& object) {
  if (object.clause.empty()) return std::string(profile.name);
  return fmt::format("{}, {}", profile.name, object.clause);
}

/// All rules of an object, if the device has it: the first violation.
Verdict judge_as_described(Bench& bench, const Ruled& ruled) {
  std::size_t judged = 0;
  for (const ProfileRow& row : profile_rows) {
    if (row.judge == judge_there || row.judge == judge_default) continue;
    if (!applies(row, *ruled.profile, *ruled.object)) continue;
    Verdict verdict = row.judge(bench, ruled);
    if (verdict.outcome == Outcome::failed) return verdict;
    if (verdict.outcome == Outcome::passed) ++judged;
  }
  return judged == 0 ? not_applicable("it is not there") : passed();
}

/// The program runs: 1F51h:01h = 01h.
std::optional<Verdict> cannot_download(Bench& bench) {
  if (!bench.has(cia302::program_control_object.index, 1)) {
    return not_applicable("the device has no 1F51h:01h");
  }
  constexpr std::uint32_t runs = 1;
  if (bench.number(cia302::program_control_object.index, 1) == runs) return std::nullopt;
  return not_applicable("its program does not run");
}

Verdict judge_download_while_it_runs(Bench& bench) {
  if (const auto cannot = cannot_download(bench)) return *cannot;
  constexpr std::uint8_t program[] = {1, 2, 3, 4, 5, 6, 7, 8};
  const Reply done = bench.write(cia302::program_data_object.index, 1, program);
  if (done.kind == Reply::Kind::aborted) return passed();
  return failed(fmt::format("1F50h:01h = 8 bytes: {}", done.text()));
}

Verdict judge_program_command(Bench& bench) {
  if (const auto cannot = cannot_download(bench)) return *cannot;
  for (const unsigned command : {0x05U, 0x7FU}) {
    const Reply done = bench.write(cia302::program_control_object.index, 1, command, 1);
    if (done.kind != Reply::Kind::aborted) {
      return failed(fmt::format("1F51h:01h = {:02X}h: {}", command, done.text()));
    }
  }
  constexpr std::uint32_t runs = 1;
  const auto now = bench.number(cia302::program_control_object.index, 1);
  return now == runs ? passed() : failed("1F51h:01h has changed");
}

constexpr CaseRow program_rows[] = {
    {"302-program-01", "CiA 302-3, 1F50h", "a program that runs is not overwritten",
     "1F50h:01h = eight bytes", "an abort", judge_download_while_it_runs},
    {"302-program-02", "CiA 302-3, 1F51h", "a command that is reserved is refused",
     "1F51h:01h = 05h, 7Fh", "an abort; 1F51h:01h = 01h", judge_program_command},
};

/// 1000h of a profile that gives its bits a meaning and does not describe the object.
void add_device_type_case(TestCases& cases, const Profile& profile) {
  const bool is_described = find_object(profile, object_index::device_type) != nullptr;
  const bool is_ruled = std::ranges::any_of(profile.device_type, has_reserved_values);
  if (is_described || !is_ruled) return;
  auto object = std::make_shared<ObjectInfo>(cia301::device_type_object);
  object->entry.fields = profile.device_type;
  cases.push_back({fmt::format("{}-1000-fields", short_name(profile)), Group::profile,
                   std::string(profile.name), "1000h Device type has nothing reserved in its bits",
                   "an upload", "codes that the profile knows", [object, &profile](Bench& bench) {
                     return judge_fields(bench, {&profile, object.get()});
                   }});
}

}  // namespace

void add_manager_cases(TestCases& cases) {
  for (const ObjectInfo* object : cia302::profile.objects) {
    const Ruled ruled{&cia302::profile, object};
    cases.push_back(
        {fmt::format("302-{:04X}", object->index), Group::manager,
         clause_of(cia302::profile, *object),
         fmt::format("{:04X}h {}, where the device has it", object->index, object->name),
         "uploads; downloads of what was read, where it is read only",
         "its length, access and values",
         [ruled](Bench& bench) { return judge_as_described(bench, ruled); }});
  }
  add_rows(cases, Group::manager, program_rows);
}

namespace {

/// The rows that reset the device, or the others.
void add_rows_of(TestCases& cases, const Profile& profile, bool is_of_resets) {
  for (const ObjectInfo* object : profile.objects) {
    for (const ProfileRow& row : profile_rows) {
      const bool resets = row.judge == judge_default;
      if (resets != is_of_resets || !applies(row, profile, *object)) continue;
      const Ruled ruled{&profile, object};
      cases.push_back(
          {fmt::format("{}-{:04X}-{}", short_name(profile), object->index, row.id), Group::profile,
           clause_of(profile, *object),
           fmt::format("{:04X}h {} {}", object->index, object->name, row.title),
           std::string(row.sends), std::string(row.expects),
           [ruled, &row](Bench& bench) { return judge_in_blocks(bench, ruled, row.judge); }});
    }
  }
}

}  // namespace

void add_profile_cases(TestCases& cases, const Profile& profile) {
  add_device_type_case(cases, profile);
  add_rows_of(cases, profile, false);
}

void add_profile_reset_cases(TestCases& cases, const Profile& profile) {
  add_rows_of(cases, profile, true);
}

}  // namespace canvoy::conformance
