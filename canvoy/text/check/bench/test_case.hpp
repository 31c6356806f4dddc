// One case of a conformance test: its clause, what it sends and expects, and its result.
//
//     for (const TestCase& each : all_cases(device)) print(each.id, each.title, each.clause);
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/text/check/bench/line.hpp"

namespace canvoy::conformance {

class Bench;

/// Groups of a test plan, in the order of execution.
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
  lss,
  manager,
  profile,
  behaviour
};
/// Number of groups.
inline constexpr std::size_t group_count = 14;
/// Name of a group: `SDO`, `heartbeat`.
std::string_view group_name(Group group);

/// Outcome of a case.
enum class Outcome : std::uint8_t { passed, failed, not_applicable };
/// Name of an outcome: `PASS`, `FAIL`, `n/a`.
std::string_view outcome_name(Outcome outcome);

/// Result of a case.
struct Verdict {
  /// Outcome of the case.
  Outcome outcome = Outcome::passed;
  std::string why = {};  ///< the unexpected result, or why the case does not apply
};
/// The result meets the clause.
inline Verdict passed() {
  return {};
}
/// The result violates the clause; `why` gives what came instead.
inline Verdict failed(std::string why) {
  return {Outcome::failed, std::move(why)};
}
/// The clause does not apply to this device; `why` gives the reason.
inline Verdict not_applicable(std::string why) {
  return {Outcome::not_applicable, std::move(why)};
}

/// A test case.
struct TestCase {
  std::string id;                        ///< `sdo-04`; of a profile `447-3-6052-type`
  Group group = Group::sdo;              ///< group of the case
  std::string clause;                    ///< `CiA 301, 7.2.4.3.6`
  std::string title;                     ///< what is tested
  std::string sends;                     ///< in a few words, or as bytes
  std::string expects;                   ///< in a few words, or as bytes
  std::function<Verdict(Bench&)> judge;  ///< runs the case
};
/// In the order of execution.
using TestCases = std::vector<TestCase>;

/// The result of an executed case.
struct TestResult {
  const TestCase* test = nullptr;  ///< the case; never null
  Verdict verdict = {};            ///< result of the case
  std::vector<Heard> frames = {};  ///< of a failure: the last frames, in both directions
  Duration took{};                 ///< duration by the clock of the line
};

}  // namespace canvoy::conformance
