// The objects of a profile, from its data: mandatory ones of a virtual device exist, with their
// type and access, and with values that the profile defines.
#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/profiles/model/virtual_device.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint16_t application_first = 0x2000;

/// An object of a profile, and its virtual device.
struct Ruled {
  const Profile* profile;
  const ObjectInfo* object;
  std::uint16_t above = 0;  ///< for a profile with several blocks: offset from the first block

  std::uint16_t index() const { return static_cast<std::uint16_t>(object->index + above); }
};

/// The virtual device in 1000h; null if it names none, or several.
const VirtualDeviceInfo* virtual_device_of(Bench& bench, const Profile& profile) {
  const auto type = bench.number(object_index::device_type, 0);
  if (!type || profile.device_type_of == nullptr) return nullptr;
  const VirtualDeviceInfo* found = nullptr;
  for (const VirtualDeviceInfo& each : profile.virtual_devices) {
    if (profile.device_type_of(each) != *type) continue;
    if (found != nullptr) return nullptr;
    found = &each;
  }
  return found;
}

/// The rule for the object: from its virtual device, or from the object itself.
struct Claim {
  const VirtualDeviceInfo* device = nullptr;
  const DeviceObject* as = nullptr;
  bool is_mandatory = false;
};
Claim claim_of(Bench& bench, const Ruled& ruled) {
  Claim claim;
  claim.device = virtual_device_of(bench, *ruled.profile);
  if (claim.device != nullptr) {
    claim.as = detail::find_device_object(*claim.device, ruled.object->index);
    claim.is_mandatory = claim.as != nullptr && claim.as->category == Category::mandatory;
  } else {
    claim.is_mandatory =
        ruled.profile->virtual_devices.empty() && ruled.object->category == Category::mandatory;
  }
  return claim;
}

/// For several equal objects and entries, the first one is used.
std::vector<const EntryInfo*> entries_of(const ObjectInfo& object) {
  std::vector<const EntryInfo*> entries;
  for (const EntryInfo& entry : object.entries()) entries.push_back(&entry);
  return entries;
}

Verdict judge_there(Bench& bench, const Ruled& ruled) {
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  if (!claim.is_mandatory) {
    if (claim.device == nullptr && !ruled.profile->virtual_devices.empty()) {
      return not_applicable("1000h names no single virtual device");
    }
    return not_applicable("it need not be there");
  }
  for (const EntryInfo* entry : entries_of(*ruled.object)) {
    const bool must_be = entry->category == Category::mandatory && entry->sub_first <= 1;
    if (!must_be) continue;
    const Reply reply = bench.read(index, entry->sub_first);
    if (reply.is_absent() || reply.kind == Reply::Kind::silent) {
      return failed(
          fmt::format("{}: {}", text::object_text(index, entry->sub_first), reply.text()));
    }
  }
  return passed();
}

Verdict judge_type(Bench& bench, const Ruled& ruled) {
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo* entry : entries_of(*ruled.object)) {
    const unsigned length = byte_length(entry->type);
    if (length == 0) continue;
    const Reply reply = bench.read(index, entry->sub_first);
    if (reply.is_absent() && entry->sub_first <= 1) return not_applicable("it is not there");
    if (!reply) continue;
    ++tried;
    if (reply.value.size() == length) continue;
    return failed(fmt::format("{} has {} bytes in place of {}",
                              text::object_text(index, entry->sub_first), reply.value.size(),
                              length));
  }
  return tried == 0 ? not_applicable("it has no value of one length that can be read") : passed();
}

Access access_of_claim(const Claim& claim, const ObjectInfo& object, const EntryInfo& entry) {
  constexpr DeviceObject by_itself{};
  const DeviceObject& as = claim.as != nullptr ? *claim.as : by_itself;
  return detail::access_of(detail::part_of(object, object.index, as, {}), entry);
}

/// An optional object may exist because the device receives it from another: it is then writable.
bool may_consume(const Claim& claim, const ObjectInfo& object, const EntryInfo& entry) {
  if (claim.is_mandatory) return false;
  const Part part = detail::part_of(object, object.index, {}, {}).consumed();
  return allows(detail::access_of(part, entry), Access::sdo_write);
}

/// Only the value that was read is written.
Verdict judge_access(Bench& bench, const Ruled& ruled) {
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo* entry : entries_of(*ruled.object)) {
    if (entry->or_const || (entry->access_by_device && claim.as == nullptr)) continue;
    if (entry->consumer_access != Access::none && claim.as == nullptr) continue;
    const Access access = access_of_claim(claim, *ruled.object, *entry);
    const std::uint8_t sub = entry->sub_first;
    const Reply value = bench.read(index, sub);
    if (value.is_absent()) continue;
    ++tried;
    const bool may_read = allows(access, Access::sdo_read);
    if (may_read == value.has_aborted(AbortCode::write_only)) {
      return failed(fmt::format("{} is to be {}: {}", text::object_text(index, sub),
                                may_read ? "read" : "write only", value.text()));
    }
    if (!may_read || allows(access, Access::sdo_write) || !value || value.value.empty()) continue;
    if (may_consume(claim, *ruled.object, *entry)) continue;
    const Reply written = bench.write(index, sub, value.value);
    if (!written.has_aborted(AbortCode::read_only)) {
      return failed(fmt::format("{} is read only, and is written: {}",
                                text::object_text(index, sub), written.text()));
    }
  }
  return tried == 0 ? not_applicable("it is not there, or its access is the device's choice")
                    : passed();
}

/// The value of an entry, or of a field in it.
bool is_known(const ValueInfo& value, std::int64_t number, unsigned bits, bool has_sign) {
  const NamedValue* const named = find_name(value, number, bits, has_sign);
  if (named != nullptr) return named->meaning != Meaning::reserved;
  if (value.limits.kind != Limits::Kind::absolute) return true;
  return number >= value.limits.low && number <= value.limits.high;
}

/// Readable values are not reserved, and not out of range.
Verdict judge_value(Bench& bench, const Ruled& ruled) {
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo* entry : entries_of(*ruled.object)) {
    const unsigned bits = bit_length(entry->type);
    if (!is_integer(entry->type) || bits == 0 || !entry->fields.empty()) continue;
    const Reply reply = bench.read(index, entry->sub_first);
    if (!reply || reply.value.size() != byte_length(entry->type)) continue;
    ++tried;
    const std::int64_t number = number_of(reply.number(), bits, is_signed(entry->type));
    if (is_known(entry->value, number, bits, is_signed(entry->type))) continue;
    return failed(fmt::format("{} is {}, which is reserved or out of its range",
                              text::object_text(index, entry->sub_first), number));
  }
  return tried == 0 ? not_applicable("it has no number that can be read") : passed();
}

bool is_refusal_of_value(const Reply& reply) {
  return reply.has_aborted(AbortCode::value_range) ||
         reply.has_aborted(AbortCode::value_too_high) ||
         reply.has_aborted(AbortCode::value_too_low);
}

/// One beyond each end of an absolute range.
Verdict judge_range(Bench& bench, const Ruled& ruled) {
  if (!bench.options().moves) return not_applicable("objects are written with --moves only");
  const Claim claim = claim_of(bench, ruled);
  const std::uint16_t index = ruled.index();
  std::size_t tried = 0;
  for (const EntryInfo* entry : entries_of(*ruled.object)) {
    const Limits& limits = entry->value.limits;
    const bool is_limited =
        limits.kind == Limits::Kind::absolute && is_integer(entry->type) && entry->fields.empty();
    if (!is_limited || !bench.has(index, entry->sub_first)) continue;
    if (!allows(access_of_claim(claim, *ruled.object, *entry), Access::rw)) continue;
    const unsigned bits = bit_length(entry->type);
    const NumberRange all = range_of_type(bits, is_signed(entry->type));
    for (const std::int64_t beyond : {limits.low - 1, limits.high + 1}) {
      if (!all.contains(beyond)) continue;
      if (find_name(entry->value, beyond, bits, is_signed(entry->type)) != nullptr) continue;
      const Reply done = bench.set(index, entry->sub_first, static_cast<std::uint64_t>(beyond),
                                   byte_length(entry->type));
      // A refusal because of the present state gives no information on the range.
      if (done.has_aborted(AbortCode::local_control) || done.has_aborted(AbortCode::device_state) ||
          done.has_aborted(AbortCode::read_only)) {
        continue;
      }
      ++tried;
      if (is_refusal_of_value(done)) continue;
      return failed(fmt::format("{} = {}: {}", text::object_text(index, entry->sub_first), beyond,
                                done.text()));
    }
  }
  return tried == 0 ? not_applicable("it has no range that can be tried") : passed();
}

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
  const unsigned blocks = ruled.object->once ? 1 : ruled.profile->block_count;
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
    {"range", "takes nothing beyond its range", "one less and one more", "0609 0030h to 0032h",
     judge_range},
};

/// True if this row has something to judge, for any device.
bool applies(const ProfileRow& row, const ObjectInfo& object) {
  const auto entries = object.entries();
  if (row.judge == judge_range) {
    return std::ranges::any_of(entries, [](const EntryInfo& each) {
      return each.value.limits.kind == Limits::Kind::absolute && is_integer(each.type) &&
             each.fields.empty() && allows(each.access, Access::rw);
    });
  }
  if (row.judge == judge_value) {
    return std::ranges::any_of(entries, [](const EntryInfo& each) {
      return is_integer(each.type) && each.fields.empty() &&
             (!each.value.names.empty() || each.value.limits.kind == Limits::Kind::absolute);
    });
  }
  if (row.judge == judge_type) {
    return std::ranges::any_of(entries,
                               [](const EntryInfo& each) { return byte_length(each.type) != 0; });
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
    if (row.judge == judge_there || !applies(row, *ruled.object)) continue;
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

void add_profile_cases(TestCases& cases, const Profile& profile) {
  for (const ObjectInfo* object : profile.objects) {
    if (object->index < application_first) continue;
    for (const ProfileRow& row : profile_rows) {
      if (!applies(row, *object)) continue;
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

}  // namespace canvoy::conformance
