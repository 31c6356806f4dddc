// A conformance test of one device: all cases that there are for it, in their order, and what came
// of each.
//
//     Check check(line, 5, {.sheet = &sheet});
//     const Report report = check.run([](const TestResult& result) { print(result); });
//     report.count(Outcome::failed);
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canvoy/words/check/bench.hpp"
#include "canvoy/words/check/test_case.hpp"

namespace canvoy::conformance {

class KeptSettings;

/// Who was tried.
struct Identity {
  /// 1 to 127.
  NodeId node = 0;
  std::optional<std::uint32_t> device_type = {};  ///< 1000h
  std::optional<std::uint32_t> vendor = {};       ///< 1018h:01h
  /// 1018h:02h.
  std::optional<std::uint32_t> product = {};
  /// 1018h:03h.
  std::optional<std::uint32_t> revision = {};
  /// 1018h:04h.
  std::optional<std::uint32_t> serial = {};
  std::string name = {};  ///< 1008h
};

/// What came of a test.
struct Report {
  /// Who was tried.
  Identity device = {};
  TestCases cases = {};  ///< to which the results point
  /// In the order of the cases.
  std::vector<TestResult> results = {};
  std::vector<std::string> notes = {};  ///< what could not be put back, and the like
  bool has_answered = false;            ///< false: nothing was tried
  bool is_whole = false;                ///< false: the bus broke, or somebody interrupted it

  /// How many cases ended so.
  std::size_t count(Outcome outcome) const;
};

/// All cases of CiA 301, and those that a profile's data give (null: none).
TestCases all_cases(const Profile* profile);

class Check {
 public:
  /// Of the device with this node-ID, 1 to 127; what `options` refers to must outlive this.
  Check(Line line, NodeId node, const BenchOptions& options);
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;

  /// Tries all of them, or those whose id begins with `only`; tells each as it ends. NMT commands
  /// go to the device alone. It ends in the state in which it began, where that can be known.
  Report run(const std::function<void(const TestResult&)>& tell = {}, std::string_view only = {});

 private:
  void identify(Report& report);
  TestResult try_case(const TestCase& test);
  bool comes_back();
  void finish(Report& report, KeptSettings& kept, std::optional<NmtState> state);

  Bench bench_;
  std::string lost_since_;
};

}  // namespace canvoy::conformance
