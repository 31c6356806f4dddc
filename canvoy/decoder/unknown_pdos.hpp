// PDOs whose content is unknown, and the profile that would explain them: a hint for a listener to
// nodes that have not told their device type (1000h). A decoder does not use it.
//
//     UnknownPdos unknown;
//     if (words.is_unknown_pdo) unknown.add(frame);
//     const UnknownPdos::Count count = unknown.count(network);
//     if (const Profile* profile = unknown.guess(network)) show(profile->name);
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canvoy/can/frame.hpp"
#include "canvoy/decoder/by_can_id.hpp"
#include "canvoy/decoder/network.hpp"

namespace canvoy::decoder {

/// Memory: 4 KiB, and 216 bytes for each CAN-ID that was added.
class UnknownPdos {
 public:
  /// Counts a data frame with 11 bits of CAN-ID whose content was unknown. Constant.
  void add(const Frame& frame);

  /// What is not decoded, by what is known now.
  struct Count {
    std::uint64_t frames = 0;        ///< of nodes whose profile is still unknown
    bool is_any_node_known = false;  ///< the profile of some node is known
  };
  /// The frames that a profile would tell more of: those whose CAN-ID still has no plan, and whose
  /// node has no profile (its node-ID by the pre-defined connection set, CiA 301, 7.3.3).
  Count count(const Network& network) const;

  /// The one profile that explains nearly all of these frames, by their CAN-IDs and lengths, and
  /// clearly more of them than any other: at least `explained_min` of them, on `can_ids_min`
  /// CAN-IDs, and no other has `others_max` of that, in frames and in CAN-IDs. One that is
  /// built on another needs a quarter of it only. Null: there is none.
  /// Takes some milliseconds where the network has learned since the last call, or frames of
  /// another kind have come, or an eighth more.
  const Profile* guess(const Network& network);
  /// Share of the frames that a profile has to explain, 0 to 1.
  static constexpr double explained_min = 0.95;
  /// Share of that which no other profile may exceed, 0 to 1.
  static constexpr double others_max = 0.6;
  /// Number of CAN-IDs that a profile has to explain.
  static constexpr std::size_t can_ids_min = 3;

 private:
  /// Frames with one CAN-ID and length.
  struct Kind {
    std::uint64_t frames = 0;
    Frame first;  ///< one of them
  };
  using Kinds = std::array<Kind, Frame::length_max + 1>;

  /// The state of which guess() was asked.
  struct Asked {
    std::uint32_t generation = 0;  ///< of the network; 0: never asked
    std::size_t kinds = 0;
    std::uint64_t frames = 0;
  };

  std::vector<Kind> kinds_of_unknown(const Network& network) const;
  static const Profile* explain(const std::vector<Kind>& kinds, const Network& network);

  ByCanId<Kinds> kinds_;
  Asked asked_;
  const Profile* guess_ = nullptr;
};

}  // namespace canvoy::decoder
