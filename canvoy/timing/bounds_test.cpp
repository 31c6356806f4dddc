// The analysis against the simulated bus, on random sets of messages: CANVOY_SETS=1000 sets their
// number (`make response-times`).
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "canvoy/timing/testing/message_sets.hpp"

namespace canvoy::timing::bounds_test {
namespace {

/// Null: the short version.
const char* said_sets() {
  return std::getenv("CANVOY_SETS");
}
std::uint64_t set_count() {
  return said_sets() == nullptr ? 20 : std::strtoull(said_sets(), nullptr, 10);
}

/// Totals over all sets.
struct Tally {
  std::size_t messages = 0;
  std::size_t unbounded = 0;
  std::size_t with_several = 0;  ///< sets with more than one relevant instance
  double least = 1;              ///< part of the bound that was reached

  /// Prints the totals of a campaign.
  void print(const char* what) const {
    if (said_sets() == nullptr) return;
    std::printf(
        "%s: %zu messages, %zu with several instances in the busy period, %zu without a "
        "bound; each bound was reached to %.3f %% at least\n",
        what, messages, with_several, unbounded, 100 * least);
  }
};

/// Plays each message of a set at its critical instants.
void look_at(const MessageSet& set, Tally& tally) {
  const std::vector<Response> bounds = response_times(set.model);
  for (std::size_t own = 0; own < bounds.size(); ++own) {
    ++tally.messages;
    if (!bounds[own].is_bounded) {
      ++tally.unbounded;
      continue;
    }
    if (bounds[own].instances > 1) ++tally.with_several;
    const Nanoseconds seen = longest_at_critical_instants(set, own, bounds[own]);
    ASSERT_LE(seen, bounds[own].time) << "message " << own;
    tally.least = std::min(tally.least, static_cast<double>(seen.count()) /
                                            static_cast<double>(bounds[own].time.count()));
  }
}

TEST(Bounds, AreReachedAtCriticalInstants) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= set_count(); ++seed) {
    Random random(seed);
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(look_at(message_set(random), tally));
  }
  tally.print("at critical instants");
  EXPECT_GE(tally.least, 0.98);
  EXPECT_GT(tally.with_several, tally.messages / 20);
  EXPECT_LT(tally.unbounded, tally.messages / 20);
}

TEST(Bounds, BehindSyncAreReachedAtOneOfItsPlaces) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= set_count(); ++seed) {
    Random random(seed);
    SCOPED_TRACE(seed);
    MessageSet set = message_set(random);
    put_behind_sync(set, random);
    if (utilisation(set.model) > 0.97) continue;
    ASSERT_NO_FATAL_FAILURE(look_at(set, tally));
  }
  tally.print("behind SYNC");
  EXPECT_GT(tally.messages, set_count());
  EXPECT_GE(tally.least, 0.98);
}

TEST(Bounds, HoldForWhatComesByChance) {
  for (std::uint64_t seed = 1; seed <= set_count(); ++seed) {
    Random random(seed);
    MessageSet set = message_set(random);
    if (random.below(2) == 0) put_behind_sync(set, random);
    const std::vector<Response> bounds = response_times(set.model);
    if (std::ranges::any_of(bounds, [](const Response& each) { return !each.is_bounded; }))
      continue;
    const std::vector<Duration> seen = longest_by_chance(set, random, 4);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      ASSERT_LE(seen[k], bounds[k].time) << "seed " << seed << " message " << k;
    }
  }
}

TEST(Bounds, HoldWithErrorsAtTheCriticalInstant) {
  for (std::uint64_t seed = 1; seed <= set_count(); ++seed) {
    Random random(seed);
    MessageSet set = message_set(random);
    set.model.errors.at_once = 1 + random.below(5);
    const std::vector<Response> bounds = response_times(set.model);
    for (std::size_t own = 0; own < bounds.size(); ++own) {
      if (!bounds[own].is_bounded) continue;
      const Nanoseconds seen =
          longest_at_critical_instants(set, own, bounds[own], set.model.errors.at_once);
      ASSERT_LE(seen, bounds[own].time) << "seed " << seed << " message " << own;
    }
  }
}

}  // namespace
}  // namespace canvoy::timing::bounds_test
