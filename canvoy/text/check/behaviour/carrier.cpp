#include "canvoy/text/check/behaviour/carrier.hpp"

#include <algorithm>
#include <set>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/model/profile_pdo.hpp"

namespace canvoy::conformance {

namespace {

namespace index = object_index;

constexpr std::uint16_t pdos_looked_at = 32;
constexpr unsigned mapped_max = 64;
constexpr unsigned first_event_type = 254;

/// Numbers from 0 on.
std::set<std::uint16_t> numbers_to_look_at(const Profile* profile, PdoWay way) {
  std::set<std::uint16_t> numbers;
  for (std::uint16_t i = 0; i < pdos_looked_at; ++i) numbers.insert(i);
  if (profile == nullptr) return numbers;
  const auto direction =
      way == PdoWay::transmit ? PdoInfo::Direction::transmit : PdoInfo::Direction::receive;
  for_each_pdo(*profile, [&](const PdoInfo& pdo) {
    if (pdo.direction != direction || pdo.number == 0) return;
    for (unsigned n = pdo.number; n <= std::max(pdo.number, pdo.last_number); ++n) {
      numbers.insert(static_cast<std::uint16_t>(n - 1));
    }
  });
  return numbers;
}

std::optional<Carrier> carrier_at(Bench& bench, PdoWay way, std::uint16_t number,
                                  std::uint32_t wanted) {
  const bool sends = way == PdoWay::transmit;
  Carrier carrier;
  OwnPdo& pdo = carrier.pdo;
  pdo.way = way;
  pdo.parameter =
      static_cast<std::uint16_t>((sends ? index::tpdo_parameter : index::rpdo_parameter) + number);
  pdo.mapping =
      static_cast<std::uint16_t>((sends ? index::tpdo_mapping : index::rpdo_mapping) + number);
  if (!bench.has(pdo.parameter, 1)) return std::nullopt;
  const auto count = bench.number(pdo.mapping, 0).value_or(0);
  if (count == 0 || count > mapped_max) return std::nullopt;
  for (unsigned sub = 1; sub <= count; ++sub) {
    const std::uint32_t entry =
        bench.number(pdo.mapping, static_cast<std::uint8_t>(sub)).value_or(0);
    if (entry >> 8 == wanted) {
      carrier.first_bit = static_cast<unsigned>(pdo.bits());
      carrier.bits = entry & 0xFF;
    }
    pdo.mapped.push_back(entry);
  }
  const bool fits = carrier.bits != 0 && carrier.bits <= 64 && pdo.bits() <= 64;
  if (!fits) return std::nullopt;
  pdo.cob_id = bench.number(pdo.parameter, 1).value_or(CobId::bit31);
  return carrier;
}

}  // namespace

std::optional<std::uint64_t> Carrier::value_in(const Frame& frame) const {
  if (frame.length * 8U < first_bit + bits) return std::nullopt;
  const auto all = load<std::uint64_t>(frame.data.data());
  return all >> first_bit & low_bits(bits);
}

void Carrier::put_into(std::span<std::uint8_t, 8> bytes, std::uint64_t value) const {
  auto all = load<std::uint64_t>(bytes.data());
  all &= ~(low_bits(bits) << first_bit);
  all |= (value & low_bits(bits)) << first_bit;
  store(bytes.data(), all);
}

std::optional<Carrier> find_carrier(Bench& bench, PdoWay way, const Place& place) {
  const std::uint32_t wanted = std::uint32_t{place.index()} << 8 | place.sub;
  for (const std::uint16_t number : numbers_to_look_at(bench.options().profile, way)) {
    if (bench.is_broken()) break;
    if (auto found = carrier_at(bench, way, number, wanted)) return found;
  }
  return std::nullopt;
}

std::optional<Verdict> make_ready(Bench& bench, Carrier& carrier, std::uint32_t own_id) {
  const CobId cob_id{carrier.pdo.cob_id};
  const auto type = bench.number(carrier.pdo.parameter, 2);
  carrier.pdo.can_id = carrier.pdo.cob_id & Frame::id_max;
  if (cob_id.valid() && type.value_or(0) >= first_event_type) return std::nullopt;
  carrier.pdo.can_id = own_id;
  return arrange(bench, carrier.pdo, {.type = type >= first_event_type ? *type : 255});
}

}  // namespace canvoy::conformance
