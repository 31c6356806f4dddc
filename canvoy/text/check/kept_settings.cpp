#include "canvoy/text/check/kept_settings.hpp"

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

namespace index = object_index;

/// A producer of SYNC starts with 1005h: it comes last.
constexpr std::uint16_t plain_objects[] = {
    index::sync_counter_overflow, index::sync_period,
    index::sync_window,           index::guard_time,
    index::life_time_factor,      index::cob_id_time,
    index::cob_id_emergency,      index::emergency_inhibit_time,
    index::heartbeat_producer,    index::cob_id_sync};
constexpr std::uint16_t pdos_kept = 32;
constexpr std::uint8_t entries_kept = 64;

}  // namespace

void KeptSettings::keep(Bench& bench, std::vector<Setting>& settings, std::uint16_t index,
                        std::uint8_t sub) {
  const Reply reply = bench.read(index, sub);
  if (reply && !reply.value.empty()) settings.push_back({index, sub, reply.value});
}

void KeptSettings::read(Bench& bench) {
  for (const std::uint16_t object : plain_objects) keep(bench, plain_, object, 0);
  for (const std::uint16_t list : {index::heartbeat_consumers, index::error_behaviour}) {
    const auto count = std::min(bench.number(list, 0).value_or(0), std::uint32_t{node_id_max});
    for (std::uint8_t sub = 1; sub <= count; ++sub) keep(bench, plain_, list, sub);
  }
  for (std::uint16_t i = 0; i < pdos_kept; ++i) {
    read_pdo(bench, static_cast<std::uint16_t>(index::rpdo_parameter + i),
             static_cast<std::uint16_t>(index::rpdo_mapping + i));
    read_pdo(bench, static_cast<std::uint16_t>(index::tpdo_parameter + i),
             static_cast<std::uint16_t>(index::tpdo_mapping + i));
  }
}

void KeptSettings::read_pdo(Bench& bench, std::uint16_t parameter, std::uint16_t mapping) {
  const Reply cob_id = bench.read(parameter, 1);
  if (!cob_id || cob_id.value.size() != 4) return;
  Pdo pdo{{parameter, 1, cob_id.value}, {}, {}};
  for (const int sub : {2, 3, 5, 6}) {
    keep(bench, pdo.parameters, parameter, static_cast<std::uint8_t>(sub));
  }
  const auto count = bench.number(mapping, 0).value_or(0);
  for (std::uint8_t sub = 0; sub <= count && sub <= entries_kept; ++sub) {
    keep(bench, pdo.mapping, mapping, sub);
  }
  pdos_.push_back(std::move(pdo));
}

bool KeptSettings::is_as_it_was(Bench& bench, const Setting& setting) {
  const Reply reply = bench.read(setting.index, setting.sub);
  return reply && reply.value == setting.value;
}

/// The number of entries is written before them and after them.
bool KeptSettings::map_again(Bench& bench, const std::vector<Setting>& mapping) {
  if (std::ranges::all_of(mapping,
                          [&](const Setting& each) { return is_as_it_was(bench, each); })) {
    return true;
  }
  bool is_done = static_cast<bool>(bench.write(mapping.front().index, 0, 0, 1));
  for (std::size_t i = 1; i < mapping.size(); ++i) {
    is_done &= static_cast<bool>(bench.write(mapping[i].index, mapping[i].sub, mapping[i].value));
  }
  return is_done && bench.write(mapping.front().index, 0, mapping.front().value);
}

bool KeptSettings::put_back(Bench& bench, const Pdo& pdo) {
  std::vector<Setting> all = pdo.parameters;
  all.insert(all.end(), pdo.mapping.begin(), pdo.mapping.end());
  all.push_back(pdo.cob_id);
  if (std::ranges::all_of(all, [&](const Setting& each) { return is_as_it_was(bench, each); })) {
    return true;
  }
  const auto now = bench.number(pdo.cob_id.index, 1);
  if (!now || !bench.write(pdo.cob_id.index, 1, *now | CobId::bit31, 4)) return false;
  bool is_done = map_again(bench, pdo.mapping);
  for (const Setting& each : pdo.parameters) {
    if (is_as_it_was(bench, each)) continue;
    is_done &= static_cast<bool>(bench.write(each.index, each.sub, each.value));
  }
  return bench.write(pdo.cob_id.index, 1, pdo.cob_id.value) && is_done;
}

std::vector<std::string> KeptSettings::put_back(Bench& bench) {
  std::vector<std::string> lost;
  for (const Setting& each : plain_) {
    if (is_as_it_was(bench, each) || bench.write(each.index, each.sub, each.value)) continue;
    lost.push_back(text::object_text(each.index, each.sub));
  }
  for (const Pdo& each : pdos_) {
    if (!put_back(bench, each)) lost.push_back(text::object_text(each.cob_id.index, 1));
  }
  return lost;
}

}  // namespace canvoy::conformance
