// Parameters and mappings that PDOs accept and refuse (CiA 301, 7.5.2.35 to 7.5.2.38): the same for
// both directions.
#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/bench/own_pdo.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

using JudgePdo = Verdict (*)(Bench&, const OwnPdo&);

std::string place(std::uint16_t index, std::uint8_t sub) {
  return text::object_text(index, sub);
}

Verdict judge_count(Bench& bench, const OwnPdo& pdo) {
  const auto highest = bench.number(pdo.parameter, 0);
  const unsigned most = 6;
  if (!highest || *highest < 2 || *highest > most) {
    return failed(fmt::format("{} is {}", place(pdo.parameter, 0), highest.value_or(0)));
  }
  return bench.has(pdo.parameter, static_cast<std::uint8_t>(*highest))
             ? passed()
             : failed(fmt::format("{} is {}, and that sub-index is not there",
                                  place(pdo.parameter, 0), *highest));
}

Verdict judge_switch(Bench& bench, const OwnPdo& pdo) {
  if (auto cannot = disable(bench, pdo)) return *cannot;
  const auto off = bench.number(pdo.parameter, 1);
  if (!off || (*off & CobId::bit31) == 0) return failed("bit 31 is not set behind it");
  const std::uint32_t wanted = (pdo.cob_id & CobId::bit30) | pdo.can_id;
  const Reply done = bench.set(pdo.parameter, 1, wanted, 4);
  if (!done) return failed(fmt::format("{:08X}h is not taken: {}", wanted, done.text()));
  return bench.number(pdo.parameter, 1) == wanted ? passed() : failed("it is not what was written");
}

Verdict judge_moved_while_valid(Bench& bench, const OwnPdo& pdo) {
  if (auto cannot = arrange(bench, pdo, {.type = 1})) return *cannot;
  const std::uint32_t other = (pdo.cob_id & CobId::bit30) | (pdo.can_id + 8);
  const Reply done = bench.set(pdo.parameter, 1, other, 4);
  return refusal(done, "another CAN-ID is taken while it is valid");
}

Verdict judge_reserved_type(Bench& bench, const OwnPdo& pdo) {
  if (auto cannot = disable(bench, pdo)) return *cannot;
  const bool sends = pdo.way == PdoWay::transmit;
  const unsigned last = sends ? 251 : 253;
  for (const unsigned type : {241U, 245U, last}) {
    const Reply done = bench.set(pdo.parameter, 2, type, 1);
    if (done) return failed(fmt::format("type {} is taken", type));
    if (!done.has_aborted(AbortCode::value_range)) {
      if (done.has_aborted(AbortCode::read_only)) {
        return not_applicable("the transmission type cannot be written");
      }
      return failed(fmt::format("type {}: {}", type, done.text()));
    }
  }
  return passed();
}

/// Sub-index 04h of a TPDO is reserved and does not exist; that of an RPDO is a compatibility
/// entry, which a device may have as a value.
Verdict judge_reserved_entry(Bench& bench, const OwnPdo& pdo) {
  const Reply done = bench.read(pdo.parameter, 4);
  if (done.is_absent()) return passed();
  if (done && pdo.way == PdoWay::receive) return passed();
  return done ? failed(fmt::format("{} is read: {}", place(pdo.parameter, 4), done.text()))
              : failed(fmt::format("{}: {}", place(pdo.parameter, 4), done.text()));
}

Verdict judge_inhibit_while_valid(Bench& bench, const OwnPdo& pdo) {
  if (!bench.has(pdo.parameter, 3)) return not_applicable("it has no inhibit time");
  if (auto cannot = arrange(bench, pdo, {.type = 1})) return *cannot;
  const auto before = bench.number(pdo.parameter, 3).value_or(0);
  const Reply done = bench.set(pdo.parameter, 3, before + 1, 2);
  return refusal(done, "it is taken while the PDO is valid");
}

/// Prepares a change of the mapping: the PDO invalid, and nothing mapped.
std::optional<Verdict> open_mapping(Bench& bench, const OwnPdo& pdo) {
  if (auto cannot = disable(bench, pdo)) return cannot;
  const Reply done = bench.set(pdo.mapping, 0, 0, 1);
  if (!done) return cannot_set(place(pdo.mapping, 0), done);
  return std::nullopt;
}

Verdict judge_mapped_again(Bench& bench, const OwnPdo& pdo) {
  if (auto cannot = open_mapping(bench, pdo)) return *cannot;
  for (std::size_t i = 0; i < pdo.mapped.size(); ++i) {
    const auto sub = static_cast<std::uint8_t>(i + 1);
    const Reply done = bench.write(pdo.mapping, sub, pdo.mapped[i], 4);
    if (done.has_aborted(AbortCode::read_only)) return not_applicable("its entries are constant");
    if (!done) return failed(fmt::format("{}: {}", place(pdo.mapping, sub), done.text()));
  }
  const Reply done = bench.set(pdo.mapping, 0, pdo.mapped.size(), 1);
  if (!done) return failed(fmt::format("{}: {}", place(pdo.mapping, 0), done.text()));
  return bench.number(pdo.mapping, 0) == pdo.mapped.size() ? passed()
                                                           : failed("the number is not kept");
}

Verdict judge_mapped_while_valid(Bench& bench, const OwnPdo& pdo) {
  if (auto cannot = arrange(bench, pdo, {.type = 1})) return *cannot;
  const Reply done = bench.set(pdo.mapping, 0, 0, 1);
  return refusal(done, "the mapping is changed while it is valid");
}

/// Refused when it is written, or when the number of entries is written.
Verdict judge_refused(Bench& bench, const OwnPdo& pdo, std::uint32_t entry) {
  if (auto cannot = open_mapping(bench, pdo)) return *cannot;
  const Reply done = bench.set(pdo.mapping, 1, entry, 4);
  if (done.has_aborted(AbortCode::read_only)) return not_applicable("its entries are constant");
  const Reply counted = done ? bench.set(pdo.mapping, 0, 1, 1) : done;
  if (counted) return failed(fmt::format("{:08X}h is mapped", entry));
  if (counted.has_aborted(AbortCode::no_object) || counted.has_aborted(AbortCode::not_mappable)) {
    return passed();
  }
  return failed(fmt::format("{:08X}h: {}", entry, counted.text()));
}

Verdict judge_no_object(Bench& bench, const OwnPdo& pdo) {
  return judge_refused(bench, pdo, 0x0FFF'0020);
}
Verdict judge_not_mappable(Bench& bench, const OwnPdo& pdo) {
  return judge_refused(bench, pdo, 0x1000'0020);
}

/// Maps the first entry repeatedly, until the PDO is longer than eight bytes.
Verdict judge_too_long(Bench& bench, const OwnPdo& pdo) {
  const unsigned bits = pdo.mapped.front() & 0xFF;
  const unsigned count = 64 / bits + 1;
  if (bits == 0 || count > 64) return not_applicable("64 of its first entry are not too long");
  if (auto cannot = open_mapping(bench, pdo)) return *cannot;
  for (unsigned i = 1; i <= count; ++i) {
    const Reply done = bench.set(pdo.mapping, static_cast<std::uint8_t>(i), pdo.mapped.front(), 4);
    if (done.has_aborted(AbortCode::pdo_length)) return passed();
    if (!done) return cannot_set(place(pdo.mapping, static_cast<std::uint8_t>(i)), done);
  }
  const Reply done = bench.set(pdo.mapping, 0, count, 1);
  if (done.has_aborted(AbortCode::pdo_length)) return passed();
  return done ? failed(fmt::format("{} bits are mapped", bits * count))
              : failed(fmt::format("{} bits are mapped: {}", bits * count, done.text()));
}

struct PdoRow {
  std::string_view id;
  std::string_view title;
  std::string_view sends;
  std::string_view expects;
  JudgePdo judge;
  bool is_of_mapping = false;
  bool is_of_both = true;  ///< false: TPDOs only
};

constexpr PdoRow pdo_rows[] = {
    {"01", "sub-index 00h is the highest", "an upload", "2 to 6, and that sub-index is there",
     judge_count},
    {"02", "it is made invalid, and valid with another CAN-ID",
     "sub-index 01h with bit 31, without", "both are taken", judge_switch},
    {"03", "its CAN-ID does not change while it is valid", "sub-index 01h with another CAN-ID",
     "an abort", judge_moved_while_valid},
    {"04", "types that are reserved are refused", "sub-index 02h = 241, 245, 251 (RPDO: 253)",
     "0609 0030h", judge_reserved_type},
    {"05", "sub-index 04h is free", "an upload", "0609 0011h (of an RPDO: or a value)",
     judge_reserved_entry},
    {"06", "its inhibit time does not change while it is valid", "sub-index 03h", "an abort",
     judge_inhibit_while_valid, false, false},
    {"07", "it is mapped as it was", "sub-index 00h = 0, the entries, their number",
     "all are taken", judge_mapped_again, true},
    {"08", "its mapping does not change while it is valid", "sub-index 00h = 0", "an abort",
     judge_mapped_while_valid, true},
    {"09", "what is not there is not mapped", "0FFF 0020h", "0602 0000h or 0604 0041h",
     judge_no_object, true},
    {"10", "what no PDO may carry is not mapped", "1000 0020h", "0604 0041h or 0602 0000h",
     judge_not_mappable, true},
    {"11", "no more than eight bytes are mapped", "the first entry, until it is too long",
     "0604 0042h", judge_too_long, true},
};

void add_way(TestCases& cases, PdoWay way) {
  const bool sends = way == PdoWay::transmit;
  for (const PdoRow& row : pdo_rows) {
    if (!sends && !row.is_of_both) continue;
    const std::string_view clause = row.is_of_mapping
                                        ? (sends ? "CiA 301, 7.5.2.38" : "CiA 301, 7.5.2.36")
                                        : (sends ? "CiA 301, 7.5.2.37" : "CiA 301, 7.5.2.35");
    cases.push_back({fmt::format("{}-{}", sends ? "tpdo" : "rpdo", row.id), Group::pdo,
                     std::string(clause), fmt::format("{}: {}", sends ? "TPDO" : "RPDO", row.title),
                     std::string(row.sends), std::string(row.expects), [way, &row](Bench& bench) {
                       const auto pdo = find_pdo(bench, way);
                       if (!pdo) return not_applicable("the device has none that carries anything");
                       return row.judge(bench, *pdo);
                     }});
  }
}

}  // namespace

void add_pdo_parameter_cases(TestCases& cases) {
  add_way(cases, PdoWay::receive);
  add_way(cases, PdoWay::transmit);
}

}  // namespace canvoy::conformance
