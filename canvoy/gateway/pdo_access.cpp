#include "canvoy/gateway/pdo_access.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::gateway {

namespace {

constexpr unsigned pdo_bits_max = pdo_bytes_max * 8;
constexpr std::uint8_t on_request = 253;
constexpr std::uint8_t event_driven = 255;

/// The objects of one direction.
struct Objects {
  std::uint16_t parameter;
  std::uint16_t mapping;
  std::uint16_t values;
};
constexpr Objects objects_of(PdoDirection direction, std::uint16_t number) {
  const auto offset = static_cast<std::uint16_t>(number - 1);
  const bool receive = direction == PdoDirection::receive;
  const auto at = [offset](std::uint16_t first) {
    return static_cast<std::uint16_t>(first + offset);
  };
  return {at(receive ? object_index::rpdo_parameter : object_index::tpdo_parameter),
          at(receive ? object_index::rpdo_mapping : object_index::tpdo_mapping),
          at(receive ? PdoStorage::rpdo_first : PdoStorage::tpdo_first)};
}

constexpr bool fits(std::uint64_t value, unsigned bits) {
  return bits >= 64 || value >> bits == 0;
}

}  // namespace

constexpr ServiceHandlers PdoAccess::service_calls = {.reset = method<&PdoAccess::reset>};

PdoAccess::PdoAccess(GatewayDevice& device, std::uint16_t net, Received received)
    : device_(device), net_(net), received_(std::move(received)) {
  device_.node().attach(service_);
  device_.rpdos().received = callback<&PdoAccess::received>(*this);
}

PdoAccess::~PdoAccess() {
  device_.node().timers().disarm(timer_);
}

void PdoAccess::reset(ResetScope) {
  fail_all(Answer::failed(ErrorCode::internal_state));
  rpdos_.clear();
  tpdos_.clear();
}

/// Each value gets the next free entry of its length.
std::vector<PdoAccess::Slot> PdoAccess::slots_for(const std::vector<DataType>& mapped) {
  std::vector<Slot> slots;
  for (const DataType type : mapped) {
    const auto bits = static_cast<std::uint8_t>(bit_length(type));
    const auto* const room = std::ranges::find(PdoStorage::rooms, bits, &PdoStorage::Room::bits);
    if (room == PdoStorage::rooms.end()) return {};
    const auto used = std::ranges::count(slots, bits, &Slot::bits);
    slots.push_back({static_cast<std::uint8_t>(room->sub_first + used), bits});
  }
  return slots;
}

bool PdoAccess::is_in_use(const Pdos& pdos, std::uint16_t number, std::uint32_t can_id) const {
  return std::ranges::any_of(pdos, [&](const auto& entry) {
    const CobId other{entry.second.cob_id};
    return entry.first != number && other.valid() && other.can_id() == can_id;
  });
}

AbortCode PdoAccess::write_number(std::uint16_t index, std::uint8_t sub, std::uint64_t number) {
  Dictionary& dictionary = device_.dictionary();
  const canvoy::Result<Entry> entry = dictionary.find(index, sub);
  if (!entry) return entry.abort();
  std::array<std::uint8_t, 8> bytes{};
  store(bytes.data(), number);
  return dictionary.write(*entry, std::span(bytes).first(entry->row->capacity), Source::sdo);
}

Answer PdoAccess::set(PdoDirection direction, std::uint16_t number, const PdoSetup& setup) {
  if (device_.node().state() == NmtState::initialisation) {
    return Answer::failed(ErrorCode::internal_state);
  }
  const auto bits = std::transform_reduce(setup.mapped.begin(), setup.mapped.end(), 0U,
                                          std::plus<>(), bit_length);
  if (bits > pdo_bits_max) return Answer::failed(ErrorCode::pdo_length);
  const CobId cob_id{setup.cob_id};
  const bool in_use =
      is_in_use(rpdos_, direction == PdoDirection::receive ? number : 0, cob_id.can_id()) ||
      is_in_use(tpdos_, direction == PdoDirection::transmit ? number : 0, cob_id.can_id());
  if (cob_id.valid() && in_use) return Answer::failed(ErrorCode::pdo_in_use);

  Pdo pdo{setup.cob_id, setup.transmission_type == on_request, slots_for(setup.mapped)};
  Pdos& pdos = direction == PdoDirection::receive ? rpdos_ : tpdos_;
  pdos.erase(number);
  const AbortCode refused = apply(direction, number, setup, pdo.slots);
  if (refused != AbortCode::none) return Answer::failed(refused);
  if (cob_id.valid()) pdos.emplace(number, std::move(pdo));
  return Answer::ok();
}

/// A PDO without a mapping is not active, and so is not sent.
AbortCode PdoAccess::check_cob_id(std::uint16_t parameter, std::uint32_t cob_id) {
  const AbortCode refused = write_number(parameter, 1, cob_id);
  return refused != AbortCode::none ? refused : write_number(parameter, 1, cob_id | CobId::bit31);
}

/// In the order of CiA 301: an RPDO becomes valid last, a TPDO when it is written (CiA 301,
/// 7.5.2.36).
AbortCode PdoAccess::apply(PdoDirection direction, std::uint16_t number, const PdoSetup& setup,
                           std::span<const Slot> slots) {
  const Objects objects = objects_of(direction, number);
  AbortCode refused = AbortCode::none;
  const auto then_write = [&](std::uint16_t index, std::uint8_t sub, std::uint64_t value) {
    if (refused == AbortCode::none) refused = write_number(index, sub, value);
  };
  const std::uint64_t present = device_.dictionary().number(objects.parameter, 1);
  then_write(objects.parameter, 1, present | CobId::bit31);
  then_write(objects.mapping, 0, 0);
  if (refused == AbortCode::none) refused = check_cob_id(objects.parameter, setup.cob_id);
  // The requesting side decides whether an RPDO is requested: it takes effect on reception.
  const bool asked_for =
      direction == PdoDirection::receive && setup.transmission_type == on_request;
  then_write(objects.parameter, 2, asked_for ? event_driven : setup.transmission_type);
  if (direction == PdoDirection::transmit) {
    then_write(objects.parameter, 3, setup.inhibit_ms * 10ULL);
    then_write(objects.parameter, 5, setup.event_ms);
    then_write(objects.parameter, 6, setup.sync_start);
  }
  if (refused == AbortCode::none) refused = map(direction, number, slots);
  if (direction == PdoDirection::receive) then_write(objects.parameter, 1, setup.cob_id);
  return refused;
}

AbortCode PdoAccess::map(PdoDirection direction, std::uint16_t number,
                         std::span<const Slot> slots) {
  const Objects objects = objects_of(direction, number);
  std::uint8_t sub = 0;
  for (const Slot& slot : slots) {
    const std::uint64_t mapped =
        std::uint64_t{objects.values} << 16 | std::uint64_t{slot.sub} << 8 | slot.bits;
    const AbortCode refused = write_number(objects.mapping, ++sub, mapped);
    if (refused != AbortCode::none) return refused;
  }
  return write_number(objects.mapping, 0, slots.size());
}

std::vector<std::uint64_t> PdoAccess::values_of(std::uint16_t number, const Pdo& pdo) const {
  std::vector<std::uint64_t> values;
  values.reserve(pdo.slots.size());
  for (const Slot& slot : pdo.slots) {
    values.push_back(
        device_.dictionary().number(objects_of(PdoDirection::receive, number).values, slot.sub));
  }
  return values;
}

Answer PdoAccess::values_answer(std::uint16_t number, const Pdo& pdo) const {
  return Answer::value(pdo_text(net_, number, values_of(number, pdo)));
}

void PdoAccess::begin_read(Operation& operation, Duration time_out) {
  const auto number = static_cast<std::uint16_t>(operation.request.numbers.at(0));
  const auto found = rpdos_.find(number);
  if (found == rpdos_.end()) {
    operation.answer = Answer::failed(ErrorCode::internal_state);
  } else if (found->second.on_request) {
    // On some buses the values arrive during the request.
    readings_.push_back({&operation, device_.node().now() + time_out});
    if (device_.rpdos().request(number)) return arm();
    cancel(operation);
    operation.answer = Answer::failed(ErrorCode::internal_state);
  } else {
    operation.answer = found->second.used ? values_answer(number, found->second)
                                          : Answer::failed(ErrorCode::internal_state);
  }
}

Answer PdoAccess::write(std::uint16_t number, std::span<const std::uint64_t> values) {
  const auto found = tpdos_.find(number);
  if (found == tpdos_.end()) return Answer::failed(ErrorCode::internal_state);
  Pdo& pdo = found->second;
  const std::vector<Slot>& slots = pdo.slots;
  if (values.size() > slots.size()) return Answer::failed(ErrorCode::pdo_length);
  if (values.size() < slots.size()) return Answer::failed(ErrorCode::syntax);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (!fits(values[i], slots[i].bits)) return Answer::failed(ErrorCode::syntax);
  }
  const Objects objects = objects_of(PdoDirection::transmit, number);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    device_.dictionary().set_number(objects.values, slots[i].sub, values[i]);
  }
  if (!std::exchange(pdo.used, true)) {
    // It becomes active, and sends its first values by itself.
    const AbortCode refused = write_number(objects.parameter, 1, pdo.cob_id);
    return refused == AbortCode::none ? Answer::ok() : Answer::failed(refused);
  }
  // For types without events, the next SYNC or request sends the values.
  device_.tpdos().trigger(number);
  return Answer::ok();
}

void PdoAccess::received(std::uint16_t number) {
  const auto found = rpdos_.find(number);
  if (found == rpdos_.end()) return;
  found->second.used = true;
  std::erase_if(readings_, [&](const Reading& reading) {
    if (reading.operation->request.numbers.at(0) != number) return false;
    reading.operation->answer = values_answer(number, found->second);
    return true;
  });
  received_(number, values_of(number, found->second));
}

bool PdoAccess::cancel(Operation& operation) {
  return std::erase_if(readings_, [&](const Reading& reading) {
           return reading.operation == &operation;
         }) != 0;
}

void PdoAccess::fail_all(const Answer& answer) {
  for (const Reading& reading : readings_) reading.operation->answer = answer;
  readings_.clear();
}

void PdoAccess::arm() {
  const auto first = std::ranges::min_element(readings_, {}, &Reading::until);
  device_.node().timers().arm(timer_, first == readings_.end() ? never : first->until);
}

void PdoAccess::expired(Time now) {
  std::erase_if(readings_, [now](const Reading& reading) {
    if (reading.until > now) return false;
    reading.operation->answer = Answer::failed(ErrorCode::time_out);
    return true;
  });
  arm();
}

}  // namespace canvoy::gateway
