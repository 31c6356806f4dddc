// The lift number of a physical device (6001h): a bit for each of its lifts (CiA 417-4, 4.2.2).
//
//     constexpr auto layout = in_any_lift(lay_out_device<my_load_unit>());
//     DeviceNode<layout> device(port, 13);
//     LiftNumber lift_number(device.node(), {});   // 6001h = 04h: 6480h stands at 7480h
//
// Objects of lift n are (n - 1) * 0800h above those of lift 1, and its pre-defined PDOs have
// numbers and CAN-IDs (n - 1) * 10h above. With `in_any_lift`, a device of one lift changes to the
// lift of 6001h as soon as that is written, in any NMT state: the clause requires no reset. Inside
// the device, the dictionary keeps the lift for which it was laid out. SDO, PDO mapping and MPDO
// find the objects at their indices on the bus, and PDO parameters follow. A COB-ID that is not the
// pre-defined one is kept.
//
// A device of one lift refuses more than one bit, and a device of several lifts (a gateway, a group
// controller) refuses bits of lifts for which it has no objects: with 0609 0030h, since the clause
// names no code. A device of one lift that is laid out without `in_any_lift` also refuses another
// lift; with `changed`, it takes the number, and its owner builds it again.
#pragma once

#include <bit>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/node/node.hpp"
#include "canvoy/devices/cia417/virtual_io/virtual_io.hpp"
#include "canvoy/profiles/cia417/physical.hpp"

namespace canvoy::cia417 {

/// What a device has to do with several lifts.
struct LiftNumberSettings {
  bool several = false;  ///< it belongs to several lifts
  /// Abort code if the number may not change at present.
  Callback<AbortCode()> refuses = {};
  /// Called when the lift number was written, or restored by a reset; `lifts` has a bit for each
  /// lift.
  Callback<void(std::uint8_t lifts)> changed = {};
};

/// The lifts of which a dictionary has objects: a bit for each. Linear in the number of objects.
constexpr std::uint8_t lifts_of(const DictionaryTables& tables) {
  unsigned lifts = 0;
  for (const ObjectRow& object : tables.objects) {
    for (unsigned lift = 1; lift <= lift_count; ++lift) {
      const unsigned block = 0x6000 + (lift - 1) * block_pitch;
      const bool is_in_block =
          object.index<block + block_pitch&& unsigned{object.index} + object.count> block + 0x100;
      if (is_in_block) lifts |= lift_bit(lift);
    }
  }
  return static_cast<std::uint8_t>(lifts);
}

/// The present lift of a device that was laid out for `lift`.
unsigned present_lift(const Dictionary& dictionary, unsigned lift);

/// Index in the tables, in a device laid out for `lift`, of the object that has `index` on the bus;
/// 0 if there is none.
std::uint16_t index_of_lift_in_tables(const Dictionary& dictionary, std::uint16_t index,
                                      unsigned lift);

namespace detail {

/// Called for each look-up: the lift of the tables is not searched for.
template <unsigned lift>
std::uint16_t index_in_tables(const Dictionary& dictionary, std::uint16_t index) {
  return index_of_lift_in_tables(dictionary, index, lift);
}
inline constexpr decltype(DictionaryTables::index_in_tables) index_in_tables_of_lift[] = {
    index_in_tables<1>, index_in_tables<2>, index_in_tables<3>, index_in_tables<4>,
    index_in_tables<5>, index_in_tables<6>, index_in_tables<7>, index_in_tables<8>};

}  // namespace detail

/// The layout of a device of one lift that can change to any other lift by 6001h.
template <class Layout>
constexpr Layout in_any_lift(Layout layout) {
  const unsigned lifts = lifts_of(layout.tables());
  if (lifts == 0 || (lifts & (lifts - 1)) != 0) {
    canvoy::detail::description_is_wrong("a device of one lift goes to another one");
  }
  const auto lift = static_cast<std::size_t>(std::countr_zero(lifts));
  layout.index_in_tables = detail::index_in_tables_of_lift[lift];
  return layout;
}

class LiftNumber {
 public:
  /// `node` has 6001h, and must outlive this.
  LiftNumber(Node& node, const LiftNumberSettings& settings);
  LiftNumber(const LiftNumber&) = delete;
  LiftNumber& operator=(const LiftNumber&) = delete;

  /// The value of 6001h: a bit for each lift.
  std::uint8_t lifts() const;

 private:
  void reset(ResetScope scope);
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value);
  void written(const Entry& entry, Source source);
  bool moves() const { return node_.dictionary().tables().index_in_tables != nullptr; }
  void move_pdos(unsigned from);
  void move_pdo(std::uint16_t parameter, unsigned from);
  unsigned mapped_lift(std::uint16_t record) const;
  std::uint32_t moved_cob_id(const Entry& entry, unsigned from) const;
  void set_cob_id(const Entry& entry, std::uint32_t raw);
  void move_mapping(std::uint16_t record, unsigned from);

  static const AccessHandlers hook_calls[1];
  static const ServiceHandlers service_calls;
  Node& node_;
  LiftNumberSettings settings_;
  std::uint8_t lift_ = 0;  ///< present lift of the PDOs of a device that can change its lift
  HandlerBinding service_{&service_calls, this};
};

}  // namespace canvoy::cia417
