#include "canvoy/text/service_words.hpp"

#include <array>
#include <string_view>

#include "canvoy/canopen/manager/dynamic_sdo.hpp"
#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/text/car_text.hpp"
#include "canvoy/text/message_text.hpp"

namespace canvoy::text {

namespace {

/// Services with a node, by function code (CAN-ID without node-ID).
constexpr std::array<std::string_view, 16> service_names = {
    "",      "EMCY",  "",      "TPDO1",        "RPDO1",       "TPDO2", "RPDO2",         "TPDO3",
    "RPDO3", "TPDO4", "RPDO4", "SDO response", "SDO request", "",      "error control", ""};

constexpr std::array<std::string_view, 4> error_control_services = {
    "boot-up", "heartbeat", "guarding request", "guarding answer"};

}  // namespace

FrameWords service_of(std::uint32_t id) {
  if (id == can_id::nmt) return {.service = "NMT"};
  if (id == can_id::sync) return {.service = "SYNC"};
  if (id == can_id::time) return {.service = "TIME"};
  if (id == can_id::lss_response || id == can_id::lss_request) return {.service = "LSS"};
  if (id == can_id::dynamic_sdo_request) return {.service = "SDO manager"};
  if (is_flying_master(id)) return {.service = "flying master"};
  const std::string_view service = service_names[id >> 7];
  const auto node = static_cast<NodeId>(id & node_id_max);
  if (service.empty() || node == 0) return {.service = "other"};
  return {.service = service, .node = node};
}

std::string pdo_service(const decoder::PdoPlan& plan) {
  const char* direction = plan.direction == PdoInfo::Direction::transmit ? "TPDO" : "RPDO";
  return plan.number == 0 ? "PDO" : direction + std::to_string(plan.number);
}

std::vector<PossibleWords> possible_words(const decoder::Network& network, std::uint32_t id) {
  const FrameWords usual = service_of(id);
  std::vector<PossibleWords> all = {{std::string(usual.service), usual.node}};
  if (id > can_id::error_control && usual.node != 0) {
    for (const std::string_view service : error_control_services) {
      all.push_back({std::string(service), usual.node});
    }
  }
  if (const auto route = network.sdo(id)) {
    const char* const service = route->is_request ? "SDO request" : "SDO response";
    all.push_back({service, route->server, route->client});
  } else if (const decoder::PdoPlan* plan = network.pdo(id)) {
    all.push_back({pdo_service(*plan), plan->node});
  }
  if (!network.has_car()) return all;
  if (is_sleep_message(id)) all.push_back({"sleep", sleeping_node(id)});
  if (const NodeId node = iso_tp_node(id); node != 0) all.push_back({"ISO-TP", node});
  return all;
}

}  // namespace canvoy::text
