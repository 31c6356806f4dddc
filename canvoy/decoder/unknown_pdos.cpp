#include "canvoy/decoder/unknown_pdos.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <span>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::decoder {

namespace {

bool is_known(const Network& network, NodeId node) {
  return network.profile(node).number != base_profile().number;
}

/// How well a profile explains frames.
struct Fit {
  const Profile* profile = nullptr;
  std::uint64_t frames = 0;   ///< that could be PDOs
  std::uint64_t decoded = 0;  ///< of these, with a content of this length
  std::set<std::uint32_t> can_ids = {};
  std::uint64_t fitting = 0;  ///< of these, with this length
  std::set<std::uint32_t> fitting_can_ids = {};

  bool is_good() const {
    return static_cast<double>(decoded) >=
               UnknownPdos::explained_min * static_cast<double>(frames) &&
           can_ids.size() >= UnknownPdos::can_ids_min;
  }
  /// True if it is hardly better than another one, or nodes of both may be there.
  bool is_close_to(const Fit& other) const {
    constexpr double related_max = 0.25;  // of a profile that is built on the other
    const bool is_related = other.profile->base == profile || profile->base == other.profile;
    const double most = is_related ? related_max : UnknownPdos::others_max;
    const auto is_share = [most](auto part, auto whole) {
      return static_cast<double>(part) > most * static_cast<double>(whole);
    };
    return is_share(other.fitting, decoded) &&
           is_share(other.fitting_can_ids.size(), can_ids.size());
  }
};

/// True if the frame has a content, all of it.
bool fits(const Decoded& decoded) {
  return decoded.pdo != nullptr && !decoded.values.empty() &&
         !decoded.marks.has(Mark::wrong_length);
}

/// A multiplexed PDO of eight bytes fits always: it is explained if it has an object.
bool explains(const Decoded& decoded) {
  return decoded.pdo->multiplexed == MpdoKind::no || decoded.values.front().object != nullptr;
}

}  // namespace

void UnknownPdos::add(const Frame& frame) {
  if (!frame.is_plain() || frame.id > Frame::id_max || frame.length > Frame::length_max) return;
  Kind& kind = kinds_.at(frame.id).at(frame.length);
  if (kind.frames++ == 0) kind.first = frame;
}

std::vector<UnknownPdos::Kind> UnknownPdos::kinds_of_unknown(const Network& network) const {
  std::vector<Kind> kinds;
  for (std::uint32_t can_id = 0; can_id <= Frame::id_max; ++can_id) {
    const Kinds* of_id = kinds_.find(can_id);
    if (of_id == nullptr || network.pdo(can_id) != nullptr || network.sdo(can_id)) continue;
    if (is_known(network, static_cast<NodeId>(can_id & node_id_max))) continue;
    std::ranges::copy_if(*of_id, std::back_inserter(kinds),
                         [](const Kind& kind) { return kind.frames != 0; });
  }
  return kinds;
}

UnknownPdos::Count UnknownPdos::count(const Network& network) const {
  Count count;
  for (const Kind& kind : kinds_of_unknown(network)) count.frames += kind.frames;
  for (NodeId node = node_id_min; node <= node_id_max; ++node) {
    count.is_any_node_known = count.is_any_node_known || is_known(network, node);
  }
  return count;
}

const Profile* UnknownPdos::guess(const Network& network) {
  const std::vector<Kind> kinds = kinds_of_unknown(network);
  Asked now{.generation = network.generation(), .kinds = kinds.size()};
  for (const Kind& kind : kinds) now.frames += kind.frames;
  const bool is_as_before = now.generation == asked_.generation && now.kinds == asked_.kinds &&
                            now.frames - asked_.frames <= asked_.frames / 8;
  if (is_as_before) return guess_;
  asked_ = now;
  return guess_ = explain(kinds, network);
}

const Profile* UnknownPdos::explain(const std::vector<Kind>& kinds, const Network& network) {
  std::vector<Fit> tried;
  for (const Profile* profile : all_profiles()) {
    if (profile->number == base_profile().number) continue;
    Decoder decoder;
    decoder.network().assume_profile(network.reading_of(*profile));
    Fit fit{.profile = profile};
    for (const Kind& kind : kinds) {
      const Decoded& decoded = decoder.decode(kind.first);
      // An SDO channel that only this profile has speaks neither for it nor against it.
      if (decoded.service != Decoded::Service::other && decoded.service != Decoded::Service::pdo)
        continue;
      fit.frames += kind.frames;
      if (!fits(decoded)) continue;
      fit.fitting += kind.frames;
      fit.fitting_can_ids.insert(kind.first.id);
      if (!explains(decoded)) continue;
      fit.decoded += kind.frames;
      fit.can_ids.insert(kind.first.id);
    }
    tried.push_back(std::move(fit));
  }
  const auto best = std::ranges::max_element(tried, {}, &Fit::decoded);
  const bool is_alone = std::ranges::none_of(tried, [&best](const Fit& other) {
    return other.profile != best->profile && best->is_close_to(other);
  });
  return best->is_good() && is_alone ? best->profile : nullptr;
}

}  // namespace canvoy::decoder
