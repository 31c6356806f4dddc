// Keys of a device of a car in a network file: whether it is played, and the identity of a real
// one.
//
//     SettingTable<TaxiRun> printer{"printer", "", played_in_car<TaxiRun>(3)};
//     check_identities(file, run, names);
#pragma once

#include <algorithm>
#include <span>

#include "canvoy/profiles/cia447/network.hpp"
#include "canvoy/tools/play/world_file.hpp"
#include "canvoy/worlds/car/real_identity.hpp"

namespace canvoy::tools {

/// `vendor = 0x2F0`: a part of the identity (1018h) of the real device at the place `id`.
template <class Run>
Setting<Run> identity_setting(NodeId id, std::size_t part, std::string key, std::string help) {
  const auto identity_in = [id](auto& identities) {
    return std::ranges::find(identities, id, &car::RealIdentity::id);
  };
  return {.key = key,
          .takes = "a whole number",
          .help = std::move(help),
          .take =
              [=](TomlTable& table, Run& run) {
                std::uint32_t value = 0;
                table.take(key, value);
                if (!table.has(key)) return;
                auto& identities = run.network.identities;
                auto found = identity_in(identities);
                if (found == identities.end()) found = identities.insert(found, {.id = id});
                found->identity.address.parts.at(part) = value;
                found->identity.known.at(part) = true;
              },
          .value =
              [=](const Run& run) {
                const auto found = identity_in(run.network.identities);
                const bool is_known =
                    found != run.network.identities.end() && found->identity.known.at(part);
                return is_known ? fmt::format("{}", found->identity.address.parts.at(part)) : "";
              }};
}

/// Keys of the device with this node-ID. The gateway has a fixed node-ID.
template <class Run>
std::vector<Setting<Run>> played_in_car(NodeId id) {
  constexpr NodeId first = cia447::gateway_node_id + 1;
  if (id == cia447::gateway_node_id) return {played<Run>(id, true)};
  const auto help = [id](const char* text) { return id == first ? text : ""; };
  return {played<Run>(id),
          identity_setting<Run>(id, LssAddress::vendor, "vendor",
                                help("of a real one, as 1018h has it; without vendor, product and "
                                     "serial it is whoever provides the virtual device")),
          identity_setting<Run>(id, LssAddress::product, "product", help("the same")),
          identity_setting<Run>(id, LssAddress::serial, "serial", help("the same"))};
}

/// True if no device matches both: a part that both have differs.
inline bool are_apart(const LssPattern& one, const LssPattern& other) {
  for (std::size_t part = 0; part < one.known.size(); ++part) {
    const bool both = one.known[part] && other.known[part];
    if (both && one.address.parts[part] != other.address.parts[part]) return true;
  }
  return false;
}

/// Checks that identities are given only for devices that are not played, and that no device
/// matches two of them. `names` are the tables of nodes from 1 on.
template <class Run>
void check_identities(const TomlTable& file, const Run& run,
                      std::span<const std::string_view> names) {
  const auto& all = run.network.identities;
  const auto is_real = [&run](NodeId id) {
    return std::ranges::find(run.network.real, id) != run.network.real.end();
  };
  if (!all.empty() && is_real(cia447::gateway_node_id)) {
    file.refuse(
        fmt::format("[{}] is real, and gives node-IDs by itself: vendor, product and serial "
                    "are for the one that is played",
                    names.front()));
  }
  const auto name = [names](const car::RealIdentity& of) { return names[of.id - std::size_t{1}]; };
  for (const car::RealIdentity& each : all) {
    if (!is_real(each.id)) {
      file.refuse(
          fmt::format("[{}] is played here: vendor, product and serial are those of a real "
                      "one, write played = false",
                      name(each)));
    }
    for (const car::RealIdentity& other : all) {
      if (other.id >= each.id || are_apart(each.identity, other.identity)) continue;
      file.refuse(fmt::format("one device may be both [{}] and [{}]: give each its serial",
                              name(other), name(each)));
    }
  }
}

}  // namespace canvoy::tools
