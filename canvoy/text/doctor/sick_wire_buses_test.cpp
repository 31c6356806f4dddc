// Buses with faults of cables, terminations and bit rates.
#include "canvoy/text/doctor/testing/sick_buses.hpp"

namespace canvoy::sick {

namespace {

std::unique_ptr<Clinic> dead() {
  auto clinic = std::make_unique<Clinic>();
  clinic->beat(clinic->add(), 1);
  clinic->bus().power(0, false);
  return clinic;
}

/// The cable is cut from the start after one of the five nodes; what is after the cut is on the
/// side of the doctor. The last of those is the client, which is added last and sends nothing at
/// that time.
std::unique_ptr<Clinic> cut_behind_all() {
  auto clinic = std::make_unique<Clinic>();
  for (NodeId node = 1; node <= 3; ++node) {
    const ControllerId controller = clinic->add();
    clinic->beat(controller, node);
  }
  clinic->at({}, [at = clinic.get()] { at->bus().cut_cable(2); });
  return clinic;
}

std::unique_ptr<Clinic> alone(std::uint32_t bit_rate, unsigned cut_off) {
  auto clinic = std::make_unique<Clinic>(SimulatedBusOptions{.bit_rate = bit_rate});
  for (unsigned node = 1; node <= cut_off + 1; ++node) {
    const ControllerId controller = clinic->add();
    clinic->beat(controller, static_cast<NodeId>(node));
  }
  if (cut_off != 0) {
    const auto place = static_cast<ControllerId>(cut_off - 1);
    clinic->at({}, [at = clinic.get(), place] { at->bus().cut_cable(place); });
  }
  return clinic;
}

std::unique_ptr<Clinic> misreading(NodeId who, double share) {
  auto clinic = std::make_unique<Clinic>();
  for (NodeId node = 1; node <= 5; ++node) {
    clinic->add_healthy(node, {.misread_probability = node == who ? share : 0.0});
  }
  return clinic;
}

/// Destroys some of the frames of one node.
std::unique_ptr<Clinic> bad_sender(NodeId who, unsigned bit, Duration period) {
  auto clinic = healthy();
  const auto controller = static_cast<ControllerId>(who == 1 ? 0 : who);
  // Frames of two CAN-IDs, in alternation.
  for (const std::uint32_t function : {can_id::tpdo1 + 0x100U, can_id::tpdo1 + 0x200U}) {
    clinic->every(period, function == 0x280 ? 3ms : 3ms + period / 2,
                  [at = clinic.get(), controller, who, bit, function] {
                    at->bus().disturb(1, bit);
                    at->bus().send(controller, Frame::data_frame(function + who, {1, 2}));
                  });
  }
  return clinic;
}

std::unique_ptr<Clinic> busy(std::uint32_t bit_rate, std::uint16_t id, Duration from,
                             Duration length) {
  auto clinic = healthy({.bit_rate = bit_rate});
  const ControllerId babbler = clinic->add();
  const Frame frame = Frame::data_frame(id, {0, 0, 0, 0, 0, 0, 0, 0});
  clinic->at(from, [at = clinic.get(), babbler, frame] { at->bus().babble(babbler, frame); });
  clinic->at(from + length, [at = clinic.get(), babbler] { at->bus().stop_babbling(babbler); });
  return clinic;
}

std::unique_ptr<Clinic> lost(Duration at, const char* why) {
  auto clinic = healthy();
  clinic->lose(at, why);
  return clinic;
}

}  // namespace

std::vector<SickBusRow> wire_rows() {
  using enum FindingKind;
  return {
      {"NobodyIsThere", no_traffic, 0, 0, [] { return std::make_unique<Clinic>(); }},
      {"NoNodeHasPower", no_traffic, 0, 0, dead},
      {"CableIsCutBeforeTheDoctor", no_traffic, 0, 0, cut_behind_all},
      {"TheAdapterIsPulledOut", lost_bus, 0, 0, [] { return lost(25s, "can0 has gone"); }},
      {"TheInterfaceIsTakenDownAtTheEnd", lost_bus, 0, 0,
       [] { return lost(59s, "can0: the interface is down"); }},
      {"TheServerEndsAtTheStart", lost_bus, 0, 0,
       [] { return lost(3s, "lab:28700: the connection has ended"); }},
      {"ListensAtTwiceTheRate", wrong_bit_rate, 0, 0, [] { return healthy({}, 250'000); }},
      {"ListensAtAFifthOfTheRate", wrong_bit_rate, 0, 0, [] { return healthy({}, 25'000); }},
      {"ListensTooFastToAFastBus", wrong_bit_rate, 0, 0,
       [] { return healthy({.bit_rate = 500'000}, 1'000'000); }},
      {"OneNodeAlone", not_acknowledged, 0, 0, [] { return alone(125'000, 0); }},
      {"OneNodeAloneOnAFastBus", not_acknowledged, 0, 0, [] { return alone(500'000, 0); }},
      {"OneNodeCutOff", not_acknowledged, 0, 0, [] { return alone(125'000, 3); }},
      {"AFiftiethOfTheFramesIsDestroyed", bus_errors, 0, 0,
       [] { return healthy({.faults = {.frame_error_probability = 0.02}}); }},
      {"ATenthOfTheFramesIsDestroyed", bus_errors, 0, 0,
       [] { return healthy({.faults = {.frame_error_probability = 0.1}, .seed = 2}); }},
      {"ABitInTenThousandIsDisturbed", bus_errors, 0, 0,
       [] { return healthy({.faults = {.bit_error_rate = 1e-4}, .seed = 3}); }},
      {"ANodeMisreadsATwentieth", errors_at_node, 3, 0, [] { return misreading(3, 0.05); }},
      {"ANodeMisreadsAFifth", errors_at_node, 5, 0, [] { return misreading(5, 0.2); }},
      {"ANodeSendsWhatOthersCannotRead", errors_at_node, 4, 0,
       [] { return bad_sender(4, 20, 400ms); }},
      {"ANodeSendsABadStartOfFrame", errors_at_node, 2, 0, [] { return bad_sender(2, 3, 900ms); }},
      {"ABabblerOfLowPriority", load_peak, 0, 0, [] { return busy(125'000, 0x7A0, 20s, 3s); }},
      {"ABabblerOnAFastBus", load_peak, 0, 0, [] { return busy(500'000, 0x7A1, 40s, 2s); }},
      {"ABabblerForAMoment", load_peak, 0, 0, [] { return busy(250'000, 0x7B0, 10s, 1900ms); }},
  };
}

}  // namespace canvoy::sick

namespace canvoy {

const std::vector<SickBusRow>& sick_buses() {
  static const std::vector<SickBusRow> all = [] {
    std::vector<SickBusRow> rows = sick::wire_rows();
    for (const auto& more :
         {sick::node_rows(), sick::pdo_rows(), sick::value_rows(), sick::other_rows()}) {
      rows.insert(rows.end(), more.begin(), more.end());
    }
    return rows;
  }();
  return all;
}

}  // namespace canvoy
