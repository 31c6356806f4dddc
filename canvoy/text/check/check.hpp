// A conformance test of one device: all applicable cases in order, and their results.
//
//     Check check(line, 5, {.sheet = &sheet});
//     const Report report = check.run([](const TestResult& result) { print(result); });
//     report.count(Outcome::failed);
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canvoy/text/check/bench/bench.hpp"
#include "canvoy/text/check/bench/test_case.hpp"

namespace canvoy::conformance {

class KeptSettings;

/// Identity of the tested device.
struct Identity {
  /// Node-ID, 1 to 127.
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

/// Results of a test.
struct Report {
  /// Identity of the tested device.
  Identity device = {};
  TestCases cases = {};  ///< the cases that the results point to
  /// In the order of the cases.
  std::vector<TestResult> results = {};
  std::vector<std::string> notes = {};  ///< for example, entries that were not restored
  bool has_answered = false;            ///< false: no case was run
  bool is_whole = false;                ///< false: the bus failed, or the test was interrupted

  /// Number of cases with this outcome.
  std::size_t count(Outcome outcome) const;
};

/// All cases of CiA 301, and those from the data of a profile (null: none).
TestCases all_cases(const Profile* profile);

/// True for the cases with an id that begins with `only`, or in the group of that name.
bool is_selected(const TestCase& test, std::string_view only);

class Check {
 public:
  /// Tests the device with this node-ID, 1 to 127; what `options` refers to must outlive this.
  Check(Line line, NodeId node, const BenchOptions& options);
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;

  /// Runs all cases, or those that `only` selects; reports each result as it comes. NMT commands go
  /// to the device alone. Restores the initial NMT state if it is known.
  Report run(const std::function<void(const TestResult&)>& tell = {}, std::string_view only = {});

 private:
  void identify(Report& report);
  TestResult try_case(const TestCase& test);
  bool comes_back();
  void store_again(std::uint8_t group, std::vector<std::string>& lost);
  void finish(Report& report, KeptSettings& kept, std::optional<NmtState> state);

  Bench bench_;
  std::string lost_since_;
};

}  // namespace canvoy::conformance
