#include "canvoy/text/check/bench/own_pdo.hpp"

#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

/// Further ones are ignored.
constexpr unsigned pdos_max = 32;
constexpr unsigned entries_max = 64;

}  // namespace

std::size_t OwnPdo::bits() const {
  std::size_t sum = 0;
  for (const std::uint32_t entry : mapped) sum += entry & 0xFF;
  return sum;
}

std::optional<OwnPdo> find_pdo(Bench& bench, PdoWay way) {
  const bool sends = way == PdoWay::transmit;
  OwnPdo pdo{.way = way, .can_id = sends ? tpdo_test_id : rpdo_test_id};
  for (unsigned i = 0; i < pdos_max && !bench.is_broken(); ++i) {
    pdo.parameter = static_cast<std::uint16_t>(
        (sends ? object_index::tpdo_parameter : object_index::rpdo_parameter) + i);
    pdo.mapping = static_cast<std::uint16_t>(
        (sends ? object_index::tpdo_mapping : object_index::rpdo_mapping) + i);
    if (!bench.has(pdo.parameter, 1)) continue;
    const auto cob_id = bench.number(pdo.parameter, 1);
    const auto count = bench.number(pdo.mapping, 0);
    if (!cob_id || !count || *count == 0 || *count > entries_max) continue;
    pdo.cob_id = *cob_id;
    pdo.mapped.clear();
    for (unsigned sub = 1; sub <= *count; ++sub) {
      pdo.mapped.push_back(bench.number(pdo.mapping, static_cast<std::uint8_t>(sub)).value_or(0));
    }
    if (pdo.bits() != 0 && pdo.bits() <= 64) return pdo;
  }
  return std::nullopt;
}

std::optional<Verdict> disable(Bench& bench, const OwnPdo& pdo) {
  const Reply done = bench.set(pdo.parameter, 1, pdo.cob_id | CobId::bit31, 4);
  if (done) return std::nullopt;
  return cannot_set(text::object_text(pdo.parameter, 1), done);
}

std::optional<Verdict> arrange(Bench& bench, const OwnPdo& pdo, const Sending& sending) {
  if (auto cannot = disable(bench, pdo)) return cannot;
  Reply done = bench.set(pdo.parameter, 2, sending.type, 1);
  if (!done) return cannot_set(text::object_text(pdo.parameter, 2), done);
  if (sending.inhibit_100us != 0) {
    done = bench.set(pdo.parameter, 3, sending.inhibit_100us, 2);
    if (!done) return cannot_set(text::object_text(pdo.parameter, 3), done);
  }
  if (sending.event_ms != 0) {
    done = bench.set(pdo.parameter, 5, sending.event_ms, 2);
    if (!done) return cannot_set(text::object_text(pdo.parameter, 5), done);
  }
  done = bench.set(pdo.parameter, 1, (pdo.cob_id & CobId::bit30) | pdo.can_id, 4);
  if (!done) return cannot_set(text::object_text(pdo.parameter, 1), done);
  return std::nullopt;
}

}  // namespace canvoy::conformance
