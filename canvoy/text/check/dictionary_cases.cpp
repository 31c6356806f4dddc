// The object dictionary of a device against its data sheet (CiA 301, 7.4; CiA 306).
#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/dictionary.hpp"
#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/formats/sheet/sheet_check.hpp"
#include "canvoy/formats/sheet/sheet_value.hpp"
#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

using formats::DataSheet;
using formats::SheetEntry;

struct Place {
  std::uint16_t index;
  std::uint8_t sub;
  const SheetEntry* entry;

  std::string text() const { return text::object_text(index, sub); }
};

std::vector<Place> places_of(const DataSheet& sheet) {
  std::vector<Place> places;
  for (const auto& [index, object] : sheet.objects) {
    if (object.is_variable()) places.push_back({index, 0, &object.own});
    for (const auto& [sub, entry] : object.subs) places.push_back({index, sub, &entry});
  }
  return places;
}

/// Entries with a side effect of reading or writing, values that change by themselves, or that a
/// device may keep private: no plain values.
bool is_action(std::uint16_t index) {
  namespace at = object_index;
  return index == at::error_history || index == at::store_parameters ||
         index == at::restore_parameters || (index >= 0x1F50 && index <= 0x1F5F) ||
         (index >= 0x1F82 && index <= 0x1F83) ||
         (index >= at::dcf && index <= at::configure_slave) || index == at::store_eds;
}
bool is_communication(std::uint16_t index) {
  return index >= object_index::communication_first && index <= object_index::communication_last;
}

bool may_read(const Place& place) {
  const auto access = formats::said_access(*place.entry);
  return access && allows(access->by_sdo, Access::sdo_read);
}
bool may_write(const Place& place) {
  const auto access = formats::said_access(*place.entry);
  return access && allows(access->by_sdo, Access::sdo_write);
}

/// The first of a list of errors, and their number.
class Complaints {
 public:
  void add(std::string text) {
    if (count_++ == 0) first_ = std::move(text);
  }
  void tried() { ++tried_; }
  bool has_any() const { return count_ != 0; }
  Verdict verdict(std::string_view none) const {
    if (count_ > 1) return failed(fmt::format("{}, and {} more", first_, count_ - 1));
    if (count_ == 1) return failed(first_);
    return tried_ == 0 ? not_applicable(std::string(none)) : passed();
  }

 private:
  std::string first_;
  std::size_t count_ = 0;
  std::size_t tried_ = 0;
};

using JudgePlace = void (*)(Bench&, const Place&, Complaints&);

/// Checks each entry of the data sheet.
Verdict judge_places(Bench& bench, JudgePlace judge, std::string_view none) {
  const DataSheet* sheet = bench.options().sheet;
  if (sheet == nullptr) return not_applicable("no data sheet is given: --eds FILE");
  Complaints complaints;
  for (const Place& place : places_of(*sheet)) {
    if (bench.is_broken()) break;
    judge(bench, place, complaints);
    if (complaints.has_any()) bench.hold();
  }
  return complaints.verdict(none);
}

void judge_presence(Bench& bench, const Place& place, Complaints& complaints) {
  complaints.tried();
  const Reply reply = bench.read(place.index, place.sub);
  if (reply.is_absent() || reply.kind == Reply::Kind::silent) {
    complaints.add(fmt::format("{}: {}", place.text(), reply.text()));
  }
}

void judge_reading(Bench& bench, const Place& place, Complaints& complaints) {
  if (!may_read(place) || is_action(place.index)) return;
  complaints.tried();
  const Reply reply = bench.read(place.index, place.sub);
  if (reply.has_aborted(AbortCode::write_only) ||
      reply.has_aborted(AbortCode::unsupported_access)) {
    complaints.add(fmt::format("{} is to be read: {}", place.text(), reply.text()));
  }
}

void judge_write_only(Bench& bench, const Place& place, Complaints& complaints) {
  if (may_read(place) || !may_write(place)) return;
  complaints.tried();
  const Reply reply = bench.read(place.index, place.sub);
  if (reply || !reply.has_aborted(AbortCode::write_only)) {
    complaints.add(fmt::format("{} is write only, and is read: {}", place.text(), reply.text()));
  }
}

/// Writes the present value: if it is accepted, nothing has changed.
void judge_read_only(Bench& bench, const Place& place, Complaints& complaints) {
  if (may_write(place) || !may_read(place)) return;
  const Reply value = bench.read(place.index, place.sub);
  if (!value || value.value.empty()) return;
  complaints.tried();
  const Reply reply = bench.write(place.index, place.sub, value.value);
  if (!reply.has_aborted(AbortCode::read_only)) {
    complaints.add(fmt::format("{} is read only, and is written: {}", place.text(), reply.text()));
  }
}

void judge_length(Bench& bench, const Place& place, Complaints& complaints) {
  const auto type = formats::sheet_type(place.entry->data_type);
  const unsigned length = type ? byte_length(*type) : 0;
  if (!may_read(place) || length == 0) return;
  const Reply value = bench.read(place.index, place.sub);
  if (!value) return;
  complaints.tried();
  if (value.value.size() != length) {
    complaints.add(
        fmt::format("{} has {} bytes in place of {}", place.text(), value.value.size(), length));
  }
}

/// Constants, and values set by the manufacturer alone: the device type and its identity.
void judge_sheet_default(Bench& bench, const Place& place, Complaints& complaints) {
  namespace at = object_index;
  const bool is_identity = place.index == at::identity && place.sub != 4;
  const bool is_fixed = place.entry->access == "const" || place.index == at::device_type;
  const auto type = formats::sheet_type(place.entry->data_type);
  const bool is_said = !place.entry->default_value.empty() && type && byte_length(*type) != 0;
  if (!(is_identity || is_fixed) || !is_said || !may_read(place)) return;
  const auto wanted = formats::sheet_bytes(*type, place.entry->default_value, bench.node());
  const Reply value = bench.read(place.index, place.sub);
  if (!wanted || !value) return;
  complaints.tried();
  if (value.value != *wanted) {
    complaints.add(fmt::format("{} is {}, and by the data sheet {}", place.text(), value.text(),
                               text::bytes_text(*wanted)));
  }
}

void judge_own_value(Bench& bench, const Place& place, Complaints& complaints) {
  if (!may_write(place) || !may_read(place) || is_action(place.index)) return;
  if (!is_communication(place.index)) return;
  const Reply value = bench.read(place.index, place.sub);
  if (!value || value.value.empty()) return;
  complaints.tried();
  const Reply reply = bench.write(place.index, place.sub, value.value);
  if (reply.has_aborted(AbortCode::read_only) || reply.is_absent() ||
      reply.kind == Reply::Kind::silent) {
    complaints.add(fmt::format("{} is to be written: {}", place.text(), reply.text()));
  }
}

/// Writes one below the low limit and one above the high limit.
void judge_limits(Bench& bench, const Place& place, Complaints& complaints) {
  const auto type = formats::sheet_type(place.entry->data_type);
  if (!type || !is_integer(*type) || !may_write(place) || is_action(place.index)) return;
  if (!is_communication(place.index) && !bench.options().moves) return;
  const auto try_beyond = [&](const std::string& limit, std::int64_t step) {
    const auto number = limit.empty() ? std::nullopt : formats::sheet_number(limit);
    if (!number) return;
    const std::int64_t beyond = number->at(bench.node()) + step;
    const auto bytes =
        formats::sheet_bytes(*type, formats::sheet_number_text(beyond, *type), bench.node());
    if (!bytes || (beyond < 0 && !is_signed(*type))) return;
    complaints.tried();
    const Reply reply = bench.set(place.index, place.sub, load_unsigned(*bytes), bytes->size());
    if (reply) {
      complaints.add(fmt::format("{} takes {}, beyond its limit {}", place.text(), beyond, limit));
    } else if (reply.kind != Reply::Kind::aborted) {
      complaints.add(fmt::format("{} = {}: {}", place.text(), beyond, reply.text()));
    }
  };
  try_beyond(place.entry->low_limit, -1);
  try_beyond(place.entry->high_limit, 1);
}

/// Sub-index 00h of an object with several sub-indices.
Verdict judge_highest_sub(Bench& bench) {
  const DataSheet* sheet = bench.options().sheet;
  if (sheet == nullptr) return not_applicable("no data sheet is given: --eds FILE");
  Complaints complaints;
  for (const auto& [index, object] : sheet->objects) {
    const bool is_mapping =
        index >= object_index::rpdo_mapping && index < 0x1C00 &&
        (index < object_index::tpdo_parameter || index >= object_index::tpdo_mapping);
    if (object.is_variable() || is_mapping || index == object_index::error_history) continue;
    const Reply value = bench.read(index, 0);
    if (!value || value.value.size() != 1) continue;
    const auto top = std::ranges::find_if(object.subs.rbegin(), object.subs.rend(),
                                          [](const auto& each) { return each.first != 0xFF; });
    const bool may_be_less = object.subs.contains(0) && formats::is_writable(object.subs.at(0));
    if (top == object.subs.rend() || may_be_less) continue;
    complaints.tried();
    if (value.value[0] != top->first) {
      complaints.add(fmt::format("{} is {}, and the highest sub-index {}",
                                 text::object_text(index, 0), value.value[0], top->first));
    }
  }
  return complaints.verdict("no object has several entries");
}

/// Objects of the communication profile that the data sheet does not have.
Verdict judge_hidden(Bench& bench) {
  const DataSheet* sheet = bench.options().sheet;
  if (sheet == nullptr) return not_applicable("no data sheet is given: --eds FILE");
  Complaints complaints;
  for (std::uint16_t index = object_index::communication_first; index <= 0x102A; ++index) {
    if (sheet->objects.contains(index)) continue;
    complaints.tried();
    const Reply reply = bench.read(index, 0);
    if (reply) complaints.add(fmt::format("{:04X}h is there, and not in the data sheet", index));
    if (reply.kind == Reply::Kind::silent)
      complaints.add(fmt::format("{:04X}h: {}", index, reply.text()));
  }
  return complaints.verdict("the data sheet has all objects");
}

/// Objects of each device: device type, error register, and identity (CiA 301, 7.5.2).
Verdict judge_mandatory(Bench& bench) {
  struct Mandatory {
    std::uint16_t index;
    std::uint8_t sub;
    std::size_t bytes;
  };
  constexpr Mandatory mandatory[] = {
      {0x1000, 0, 4}, {0x1001, 0, 1}, {0x1018, 0, 1}, {0x1018, 1, 4}};
  Complaints complaints;
  for (const Mandatory& each : mandatory) {
    const Reply value = bench.read(each.index, each.sub);
    complaints.tried();
    if (value && value.value.size() == each.bytes) continue;
    complaints.add(fmt::format("{} is {}", text::object_text(each.index, each.sub), value.text()));
  }
  return complaints.verdict("");
}

Verdict judge_sheet(Bench& bench) {
  const DataSheet* sheet = bench.options().sheet;
  if (sheet == nullptr) return not_applicable("no data sheet is given: --eds FILE");
  formats::Findings findings;
  formats::check_sheet(*sheet, nullptr, findings);
  Complaints complaints;
  complaints.tried();
  for (const formats::Finding& each : findings) {
    if (each.weight != formats::Finding::Weight::error) continue;
    complaints.add(fmt::format("[{}] {}", each.section, each.text));
  }
  return complaints.verdict("");
}

struct PlaceRow {
  std::string_view id;
  std::string_view clause;
  std::string_view title;
  std::string_view expects;
  JudgePlace judge;
  std::string_view none;  ///< reason if no entry applies
};

constexpr PlaceRow place_rows[] = {
    {"dictionary-02", "CiA 306", "each entry of the data sheet is there",
     "no 0602 0000h, 0609 0011h", judge_presence, "the data sheet has no entries"},
    {"dictionary-03", "CiA 301, 7.4.3", "what the data sheet lets be read is read",
     "no 0601 0000h, 0601 0001h", judge_reading, "no entry can be read"},
    {"dictionary-04", "CiA 301, 7.4.3", "what is write only is not read", "0601 0001h",
     judge_write_only, "no entry is write only"},
    {"dictionary-05", "CiA 301, 7.4.3", "what is read only is not written", "0601 0002h",
     judge_read_only, "no entry is read only"},
    {"dictionary-06", "CiA 301, 7.4.7", "values have the length of their type", "that many bytes",
     judge_length, "no entry has a type of one length"},
    {"dictionary-07", "CiA 306", "constants and the identity are as the data sheet says",
     "its default values", judge_sheet_default, "the data sheet gives no constant a value"},
    {"dictionary-08", "CiA 301, 7.4.3", "parameters of communication can be written",
     "no 0601 0002h to its own value", judge_own_value, "no such parameter can be written"},
    {"dictionary-09", "CiA 306", "values beyond the limits of the data sheet are refused",
     "an abort", judge_limits, "no entry that may be written has limits"},
};

}  // namespace

void add_sheet_cases(TestCases& cases) {
  cases.push_back({"eds-01", Group::sheet, "CiA 306", "the data sheet is one", "nothing",
                   "no error in it", judge_sheet});
}

void add_dictionary_cases(TestCases& cases) {
  const auto add = [&cases](std::string id, std::string clause, std::string title,
                            std::string sends, std::string expects,
                            std::function<Verdict(Bench&)> judge) {
    cases.push_back({std::move(id), Group::dictionary, std::move(clause), std::move(title),
                     std::move(sends), std::move(expects), std::move(judge)});
  };
  add("dictionary-01", "CiA 301, 7.5.2", "1000h, 1001h and 1018h are there", "SDO uploads",
      "values of 4, 1, 1 and 4 bytes", judge_mandatory);
  for (const PlaceRow& row : place_rows) {
    add(std::string(row.id), std::string(row.clause), std::string(row.title),
        "an SDO transfer for each entry", std::string(row.expects),
        [&row](Bench& bench) { return judge_places(bench, row.judge, row.none); });
  }
  add("dictionary-10", "CiA 301, 7.4.4", "sub-index 00h is the highest sub-index",
      "an upload of each", "the highest sub-index of the data sheet", judge_highest_sub);
  add("dictionary-11", "CiA 306", "1000h to 102Ah has no object that the data sheet has not",
      "an upload of each that it has not", "an abort", judge_hidden);
}

}  // namespace canvoy::conformance
