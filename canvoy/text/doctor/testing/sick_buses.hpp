// Buses with one fault each, as rows of a table. For tests only.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "canvoy/text/doctor/testing/clinic.hpp"

namespace canvoy {

struct SickBusRow {
  const char* name;
  text::FindingKind kind;
  NodeId node;           ///< 0: none
  std::uint16_t can_id;  ///< 0: none
  std::function<std::unique_ptr<Clinic>()> make;
  Duration time = 60s;  ///< of listening
};

namespace sick {

using text::FindingKind;

/// The node with the fault, beside the healthy ones.
inline constexpr NodeId sick_node = 9;

/// A bus with the healthy nodes 1 to 5.
inline std::unique_ptr<Clinic> healthy(const SimulatedBusOptions& options = {},
                                       std::uint32_t listens_at = 0) {
  auto clinic = std::make_unique<Clinic>(options, listens_at);
  for (NodeId node = 1; node <= 5; ++node) clinic->add_healthy(node);
  return clinic;
}
inline Frame pdo(NodeId node, std::initializer_list<std::uint8_t> bytes) {
  return Frame::data_frame(can_id::tpdo1 + node, bytes);
}
inline Frame state_of(NodeId node, std::uint8_t state) {
  return Frame::data_frame(can_id::error_control + node, {state});
}
/// Sends an SDO answer with an entry of up to four bytes: 4Fh, 4Bh or 43h, and the entry.
inline void tells(Clinic& clinic, ControllerId who, NodeId node, Duration at, std::uint16_t index,
                  std::uint8_t sub, unsigned bytes, std::uint32_t value) {
  const std::array<char, 8> text = {static_cast<char>(0x43U | (4U - bytes) << 2U),
                                    static_cast<char>(index),
                                    static_cast<char>(index >> 8U),
                                    static_cast<char>(sub),
                                    static_cast<char>(value),
                                    static_cast<char>(value >> 8U),
                                    static_cast<char>(value >> 16U),
                                    static_cast<char>(value >> 24U)};
  clinic.answer(who, node, at, text.data());
}

std::vector<SickBusRow> wire_rows();
std::vector<SickBusRow> node_rows();
std::vector<SickBusRow> pdo_rows();
std::vector<SickBusRow> value_rows();
std::vector<SickBusRow> other_rows();

}  // namespace sick

const std::vector<SickBusRow>& sick_buses();

}  // namespace canvoy
