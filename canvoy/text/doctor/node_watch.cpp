#include "canvoy/text/doctor/node_watch.hpp"

#include <algorithm>

#include "canvoy/canopen/protocol/little_endian.hpp"

namespace canvoy::text {

void NodeWatch::reset(Time at, NodeId node) {
  if (node != 0) {
    nodes_.at(node).reset_at = at;
    return;
  }
  for (Node& each : nodes_) each.reset_at = at;
}

bool NodeWatch::is_asked(Time at, NodeId node) const {
  const Time reset_at = nodes_.at(node).reset_at;
  return reset_at != never && at - reset_at <= boot_most;
}

void NodeWatch::emergency(Time at, NodeId node, const Frame& frame) {
  Node& each = nodes_.at(node);
  Time& oldest = each.latest.at(each.heard.emergencies.count % storm_least);
  const bool is_storm = each.heard.emergencies.count >= storm_least && at - oldest <= storm_time;
  oldest = at;
  each.heard.emergencies.add(at);
  each.heard.error_code = load<std::uint16_t>(frame.data.data());
  if (is_storm) each.heard.storm.add(at);
  if (each.heard.error_code == 0) return;
  each.heard.errors.add(at);
  std::vector<std::uint16_t>& codes = each.heard.codes;
  const bool is_known = std::ranges::find(codes, each.heard.error_code) != codes.end();
  if (!is_known && codes.size() < codes_most) codes.push_back(each.heard.error_code);
}

}  // namespace canvoy::text
