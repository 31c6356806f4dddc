#include "canvoy/devices/cia417/kit/lift_number.hpp"

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/pdo/pdo_mapping.hpp"
#include "canvoy/canopen/pdo/pdo_parameter.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/profiles/cia417/pdos.hpp"

namespace canvoy::cia417 {

namespace {

// Objects of lift 1 with other indices in another lift: those that do not belong to the physical
// device, and the parameters of its pre-defined PDOs. Those of virtual sensors follow the last
// lift.

constexpr unsigned objects_first = 0x6100;
constexpr unsigned objects_of_lifts = lift_count * block_pitch;
constexpr unsigned pdo_numbers = 0x200;
constexpr unsigned pdo_first = 0x102;  ///< 1502h
constexpr unsigned pdo_end = 0x181;    ///< 1581h

/// The lift to which an index belongs, and its distance from lift to lift; 0 if it belongs to none.
struct Block {
  unsigned lift = 0;
  unsigned pitch = 0;
};
Block block_of_index(unsigned index) {
  if (index >= 0x6000 && index < 0x6000 + objects_of_lifts) {
    const unsigned offset = index - 0x6000;
    const bool is_of_device = offset % block_pitch < objects_first - 0x6000;
    return {is_of_device ? 0 : offset / block_pitch + 1, block_pitch};
  }
  const unsigned number = index % pdo_numbers;
  const bool is_pdo = index >= object_index::rpdo_parameter &&
                      index <= object_index::tpdo_mapping_last && number >= pdo_first &&
                      number < pdo_end;
  return {is_pdo ? (number - pdo_first) / lift_pdo_pitch + 1 : 0, lift_pdo_pitch};
}

unsigned lift_of(std::uint64_t lifts) {
  return static_cast<unsigned>(std::countr_zero(lifts)) + 1;
}
/// The lift for which a device of one lift was laid out.
unsigned lift_in_tables(const Dictionary& dictionary) {
  return lift_of(lifts_of(dictionary.tables()));
}
unsigned written_lift(const Dictionary& dictionary) {
  return lift_of(dictionary.number(lift_number_object.index, 0));
}

/// Index in lift `to` of the object that has `index` in its block.
std::uint16_t moved(unsigned index, const Block& block, unsigned to) {
  return static_cast<std::uint16_t>(index + (to - block.lift) * block.pitch);
}

}  // namespace

unsigned present_lift(const Dictionary& dictionary, unsigned lift) {
  return dictionary.tables().index_in_tables == nullptr ? lift : written_lift(dictionary);
}

std::uint16_t index_of_lift_in_tables(const Dictionary& dictionary, std::uint16_t index,
                                      unsigned lift) {
  const Block block = block_of_index(index);
  if (block.lift == 0) return index;
  const unsigned present = written_lift(dictionary);
  if (block.lift != present) return 0;
  return moved(index, block, lift);
}

constexpr AccessHandlers LiftNumber::hook_calls[] = {
    {.first = lift_number_object.index,
     .last = lift_number_object.index,
     .before_write = method<&LiftNumber::before_write>,
     .after_write = method<&LiftNumber::written>}};
constexpr ServiceHandlers LiftNumber::service_calls = {.reset = method<&LiftNumber::reset>,
                                                       .hooks = hook_calls};

LiftNumber::LiftNumber(Node& node, const LiftNumberSettings& settings)
    : node_(node), settings_(settings) {
  node.attach(service_);
}

std::uint8_t LiftNumber::lifts() const {
  return static_cast<std::uint8_t>(node_.dictionary().number(lift_number_object.index, 0));
}

AbortCode LiftNumber::before_write(const Entry&, std::span<const std::uint8_t> value) {
  const std::uint8_t lifts = value[0];
  const bool is_one = std::has_single_bit(lifts);
  if (lifts == 0 || (!is_one && !settings_.several)) return AbortCode::value_range;
  // A call controller has none that belong to a lift.
  const std::uint8_t laid_out = lifts_of(node_.dictionary().tables());
  const bool has_objects = laid_out == 0 || (lifts & ~laid_out) == 0;
  const bool can_have = has_objects || moves() || settings_.changed;
  return can_have ? settings_.refuses() : AbortCode::value_range;
}

void LiftNumber::written(const Entry&, Source) {
  if (moves()) move_pdos(lift_);
  if (settings_.changed) settings_.changed(lifts());
}

/// PDO parameters have their defaults again, which are those of the lift in the tables, or the
/// stored values: of this lift or another, with 6001h or without.
void LiftNumber::reset(ResetScope) {
  Dictionary& dictionary = node_.dictionary();
  const std::uint8_t laid_out = lifts_of(dictionary.tables());
  if (moves() && !std::has_single_bit(lifts())) {
    dictionary.set_number(lift_number_object.index, 0, laid_out);
  }
  if (moves()) move_pdos(lift_of(laid_out));
  if (settings_.changed) settings_.changed(lifts());
}

void LiftNumber::move_pdos(unsigned from) {
  lift_ = static_cast<std::uint8_t>(written_lift(node_.dictionary()));
  for (const ObjectRow& object : node_.dictionary().tables().objects) {
    const unsigned kind = object.index & ~(pdo_numbers - 1);
    if (kind != object_index::rpdo_parameter && kind != object_index::tpdo_parameter) continue;
    for (unsigned i = 0; i < object.count; ++i) {
      move_pdo(static_cast<std::uint16_t>(object.index + i), from);
    }
  }
}

/// Like a master: off, then the new mapping, and on with the new COB-ID. The mapped objects show
/// best to which lift the parameters belong.
void LiftNumber::move_pdo(std::uint16_t parameter, unsigned from) {
  const auto record = static_cast<std::uint16_t>(parameter + pdo_numbers);
  if (const unsigned mapped = mapped_lift(record); mapped != 0) from = mapped;
  const Result<Entry> cob_id = node_.dictionary().find(parameter, pdo_sub::cob_id);
  if (!cob_id || from == lift_) return;
  const std::uint32_t wanted = moved_cob_id(*cob_id, from);
  set_cob_id(*cob_id, wanted | CobId::bit31);
  move_mapping(record, from);
  set_cob_id(*cob_id, wanted);
}

/// The lift of the first object in a mapping record that belongs to one; 0: none.
unsigned LiftNumber::mapped_lift(std::uint16_t record) const {
  for (std::uint8_t sub = 1; sub <= pdo_values_max; ++sub) {
    const unsigned index = node_.dictionary().word(record, sub) >> 16;
    if (const Block block = block_of_index(index); block.lift != 0) return block.lift;
  }
  return 0;
}

/// A COB-ID that was configured stays.
std::uint32_t LiftNumber::moved_cob_id(const Entry& entry, unsigned from) const {
  const std::uint32_t present = entry.word();
  const unsigned steps = from - lift_in_tables(node_.dictionary());
  const CobId predefined{static_cast<std::uint32_t>(node_.dictionary().default_number(entry)) +
                         steps * lift_pdo_pitch};
  const bool is_predefined =
      block_of_index(entry.index).lift != 0 && CobId{present}.can_id() == predefined.can_id();
  return is_predefined ? present + (lift_ - from) * lift_pdo_pitch : present;
}

void LiftNumber::set_cob_id(const Entry& entry, std::uint32_t raw) {
  Dictionary& dictionary = node_.dictionary();
  dictionary.set_number(entry.index, entry.sub, raw);
  dictionary.announce(entry, Source::application);
}

void LiftNumber::move_mapping(std::uint16_t record, unsigned from) {
  Dictionary& dictionary = node_.dictionary();
  for (std::uint8_t sub = 1; sub <= pdo_values_max; ++sub) {
    const std::uint32_t mapped = dictionary.word(record, sub);
    const Block block = block_of_index(mapped >> 16);
    if (block.lift != from) continue;
    const std::uint32_t index = moved(mapped >> 16, block, lift_);
    dictionary.set_number(record, sub, index << 16 | (mapped & 0xFFFF));
  }
}

}  // namespace canvoy::cia417
