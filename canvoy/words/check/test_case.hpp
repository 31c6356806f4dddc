// One case of a conformance test: by which clause, what it sends, what it expects, and what came of
// it.
//
//     for (const TestCase& each : all_cases(device)) print(each.id, each.title, each.clause);
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/words/check/line.hpp"

namespace canvoy::conformance {

class Bench;

/// The classes of a test plan, in the order in which they are tried.
enum class Group : std::uint8_t {
  sheet,
  sdo,
  dictionary,
  nmt,
  heartbeat,
  emergency,
  pdo,
  sync,
  guarding,
  store,
  profile
};
/// How many there are.
inline constexpr std::size_t group_count = 11;
/// `SDO`, `heartbeat`
std::string_view group_name(Group group);

/// How a case ends.
enum class Outcome : std::uint8_t { passed, failed, not_applicable };
/// `PASS`, `FAIL`, `n/a`
std::string_view outcome_name(Outcome outcome);

/// What a case has found.
struct Verdict {
  /// How it ended.
  Outcome outcome = Outcome::passed;
  std::string why = {};  ///< what came in place of what was expected, or why it does not apply
};
/// As the clause wants it.
inline Verdict passed() {
  return {};
}
/// With what came in place of what the clause wants.
inline Verdict failed(std::string why) {
  return {Outcome::failed, std::move(why)};
}
/// With the reason why the clause says nothing of this device.
inline Verdict not_applicable(std::string why) {
  return {Outcome::not_applicable, std::move(why)};
}

/// What is tried, and by which clause.
struct TestCase {
  std::string id;                        ///< `sdo-04`; of a profile `447-3-6052-type`
  Group group = Group::sdo;              ///< its class
  std::string clause;                    ///< `CiA 301, 7.2.4.3.6`
  std::string title;                     ///< what is judged
  std::string sends;                     ///< in a few words, or as bytes
  std::string expects;                   ///< the same
  std::function<Verdict(Bench&)> judge;  ///< tries it
};
/// In the order in which they are tried.
using TestCases = std::vector<TestCase>;

/// A case that was tried.
struct TestResult {
  const TestCase* test = nullptr;  ///< what was tried; never null
  Verdict verdict = {};            ///< how it ended
  std::vector<Heard> frames = {};  ///< of a failure, both ways: the last of them
  Duration took{};                 ///< by the time of the line
};

}  // namespace canvoy::conformance
