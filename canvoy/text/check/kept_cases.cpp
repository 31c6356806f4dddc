// Non-volatile parameters: store and restore (CiA 301, 7.5.2.13 and 7.5.2.14). The cases change
// what is stored, and need permission.
#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint32_t load_signature = 0x6461'6F6C;  ///< "load"
constexpr std::uint32_t on_command = 1;                ///< bit 0 of 1010h and 1011h
/// Heartbeat producer times, in ms: two of them are not the default.
constexpr std::uint32_t periods[] = {1234, 4321, 2345};

/// A device with a heartbeat producer time that is stored and restored.
class Keeper {
 public:
  explicit Keeper(Bench& bench)
      : bench_(bench), group_(storage_group(bench)), default_(period().value_or(0)) {}

  /// Reason why nothing can be stored, or why it cannot be restored.
  std::optional<Verdict> cannot();
  std::optional<std::uint32_t> period() {
    return bench_.number(object_index::heartbeat_producer, 0);
  }
  /// A period that is neither the default nor `other`.
  std::uint32_t new_period(std::uint32_t other = 0) const {
    for (const std::uint32_t each : periods) {
      if (each != default_ && each != other) return each;
    }
    return 0;
  }
  std::uint32_t default_period() const { return default_; }

  // Each function returns what failed.

  std::optional<Verdict> set(std::uint32_t ms) {
    const Reply done = bench_.write(object_index::heartbeat_producer, 0, ms, 2);
    return done ? std::nullopt : std::optional(cannot_set("1017h", done));
  }
  std::optional<Verdict> save() { return sign(object_index::store_parameters, save_signature); }
  std::optional<Verdict> load() { return sign(object_index::restore_parameters, load_signature); }
  std::optional<Verdict> reset() { return reset_node(bench_); }
  std::optional<Verdict> expect(std::uint32_t ms, std::string_view when);
  /// Restores all defaults, with nothing stored; then reads the default.
  std::optional<Verdict> begin_anew();

 private:
  std::optional<Verdict> sign(std::uint16_t index, std::uint32_t signature);

  Bench& bench_;
  std::uint8_t group_;
  std::uint32_t default_;
};

std::optional<Verdict> Keeper::cannot() {
  if (!bench_.options().stores) return not_applicable("what is stored is tried with --stores only");
  for (const std::uint16_t index :
       {object_index::store_parameters, object_index::restore_parameters}) {
    const std::string place = text::object_text(index, group_);
    const auto ability = bench_.number(index, group_);
    if (!ability) return not_applicable(fmt::format("the device has no {}", place));
    if ((*ability & on_command) == 0) {
      return not_applicable(fmt::format("{} is {:08X}h: not on command", place, *ability));
    }
  }
  if (!period()) return not_applicable("the device has no 1017h");
  return begin_anew();
}

std::optional<Verdict> Keeper::sign(std::uint16_t index, std::uint32_t signature) {
  bench_.note_stored(group_);
  const Reply done = bench_.write(index, group_, signature, 4);
  if (done) return std::nullopt;
  return failed(
      fmt::format("{} = {:08X}h: {}", text::object_text(index, group_), signature, done.text()));
}

std::optional<Verdict> Keeper::expect(std::uint32_t ms, std::string_view when) {
  const auto now = period();
  if (now == ms) return std::nullopt;
  return failed(fmt::format("{} 1017h is {} in place of {}", when,
                            now ? std::to_string(*now) : std::string("not read"), ms));
}

std::optional<Verdict> Keeper::begin_anew() {
  if (auto wrong = load()) return wrong;
  if (auto wrong = reset()) return wrong;
  default_ = period().value_or(0);
  return std::nullopt;
}

/// Runs the steps until one fails; afterwards the defaults are stored.
template <class Steps>
Verdict try_keeping(Bench& bench, Steps steps) {
  Keeper keeper(bench);
  if (const auto cannot = keeper.cannot()) return *cannot;
  const std::optional<Verdict> wrong = steps(keeper);
  const std::optional<Verdict> left = keeper.begin_anew();
  if (wrong) return *wrong;
  return left ? *left : passed();
}

template <class... Steps>
std::optional<Verdict> first_wrong(Steps... steps) {
  std::optional<Verdict> wrong;
  static_cast<void>(((wrong = steps()).has_value() || ...));
  return wrong;
}

Verdict judge_stored(Bench& bench) {
  return try_keeping(bench, [](Keeper& keeper) {
    const std::uint32_t ms = keeper.new_period();
    return first_wrong([&] { return keeper.set(ms); }, [&] { return keeper.save(); },
                       [&] { return keeper.reset(); },
                       [&] { return keeper.expect(ms, "after the reset"); });
  });
}
Verdict judge_not_stored(Bench& bench) {
  return try_keeping(bench, [](Keeper& keeper) {
    const std::uint32_t stored = keeper.new_period();
    const std::uint32_t set_later = keeper.new_period(stored);
    return first_wrong([&] { return keeper.set(stored); }, [&] { return keeper.save(); },
                       [&] { return keeper.set(set_later); }, [&] { return keeper.reset(); },
                       [&] { return keeper.expect(stored, "after the reset"); });
  });
}
Verdict judge_restored(Bench& bench) {
  return try_keeping(bench, [](Keeper& keeper) {
    const std::uint32_t ms = keeper.new_period();
    return first_wrong([&] { return keeper.set(ms); }, [&] { return keeper.save(); },
                       [&] { return keeper.reset(); }, [&] { return keeper.load(); },
                       [&] { return keeper.reset(); },
                       [&] { return keeper.expect(keeper.default_period(), "after the reset"); });
  });
}
Verdict judge_restored_later(Bench& bench) {
  return try_keeping(bench, [](Keeper& keeper) {
    const std::uint32_t ms = keeper.new_period();
    return first_wrong([&] { return keeper.set(ms); }, [&] { return keeper.save(); },
                       [&] { return keeper.load(); },
                       [&] { return keeper.expect(ms, "before the reset"); });
  });
}

constexpr CaseRow kept_rows[] = {
    {"store-04", "CiA 301, 7.5.2.13", "what is stored is there after a reset",
     "1017h; 1010h = 6576 6173h; NMT 81h", "1017h as it was stored", judge_stored},
    {"store-05", "CiA 301, 7.5.2.13", "what is not stored is gone after a reset",
     "1017h; 1010h = 6576 6173h; 1017h; NMT 81h", "1017h as it was stored", judge_not_stored},
    {"store-06", "CiA 301, 7.5.2.14", "defaults that are restored are there after a reset",
     "1017h; 1010h = 6576 6173h; 1011h = 6461 6F6Ch; NMT 81h", "1017h as by default",
     judge_restored},
    {"store-07", "CiA 301, 7.5.2.14", "defaults are not restored before a reset",
     "1017h; 1010h = 6576 6173h; 1011h = 6461 6F6Ch", "1017h as it was", judge_restored_later},
};

}  // namespace

std::uint8_t storage_group(Bench& bench) {
  constexpr std::uint8_t all = 1;
  constexpr std::uint8_t communication = 2;
  const bool is_apart = bench.has(object_index::store_parameters, communication) &&
                        bench.has(object_index::restore_parameters, communication);
  return is_apart ? communication : all;
}

void add_kept_cases(TestCases& cases) {
  add_rows(cases, Group::store, kept_rows);
}

}  // namespace canvoy::conformance
