#include "canvoy/text/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/check/kept_settings.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::string_view group_names[] = {
    "data sheet", "SDO",      "object dictionary", "NMT", "heartbeat", "emergency", "PDO",
    "SYNC",       "guarding", "store and CAN-IDs", "LSS", "CiA 302",   "profile",   "behaviour"};
static_assert(std::size(group_names) == group_count);

/// Time in which a device enters a commanded state.
constexpr Duration settling = 20ms;
/// Time in which a disturbed device is back, after its boot-up.
constexpr Duration recovery = 3s;

void note_lost(Report& report, const std::vector<std::string>& objects) {
  for (const std::string& object : objects) {
    report.notes.push_back(fmt::format("{} could not be put back", object));
  }
}

}  // namespace

std::string_view group_name(Group group) {
  return group_names[static_cast<std::size_t>(group)];
}

std::string_view outcome_name(Outcome outcome) {
  constexpr std::string_view names[] = {"PASS", "FAIL", "n/a"};
  return names[static_cast<std::size_t>(outcome)];
}

std::size_t Report::count(Outcome outcome) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      results, [outcome](const TestResult& each) { return each.verdict.outcome == outcome; }));
}

TestCases all_cases(const Profile* profile) {
  TestCases cases;
  add_sheet_cases(cases);
  add_sdo_cases(cases);
  add_dictionary_cases(cases);
  add_nmt_cases(cases);
  add_heartbeat_cases(cases);
  add_emergency_cases(cases);
  add_pdo_parameter_cases(cases);
  add_pdo_sending_cases(cases);
  add_sync_cases(cases);
  add_guarding_cases(cases);
  add_store_cases(cases);
  add_kept_cases(cases);
  add_lss_cases(cases);
  add_manager_cases(cases);
  add_master_cases(cases);
  if (profile != nullptr) {
    add_profile_cases(cases, *profile);
    add_profile_pdo_cases(cases, *profile);
    add_profile_reset_cases(cases, *profile);
    add_behaviour_cases(cases, *profile);
  }
  return cases;
}

bool is_selected(const TestCase& test, std::string_view only) {
  return test.id.starts_with(only) || group_name(test.group) == only;
}

Check::Check(Line line, NodeId node, const BenchOptions& options)
    : bench_(std::move(line), node, options) {}

void Check::identify(Report& report) {
  namespace index = object_index;
  Identity& device = report.device;
  device.node = bench_.node();
  const Reply type = bench_.read(index::device_type, 0);
  // An abort, or an invalid message, is an answer too: a device is present.
  report.has_answered = type.kind != Reply::Kind::silent;
  if (!report.has_answered) return;
  if (type && type.value.size() == 4)
    device.device_type = static_cast<std::uint32_t>(type.number());
  device.vendor = bench_.number(index::identity, 1);
  device.product = bench_.number(index::identity, 2);
  device.revision = bench_.number(index::identity, 3);
  device.serial = bench_.number(index::identity, 4);
  const Reply name = bench_.read(index::device_name, 0);
  if (name) device.name = formats::plain_text(std::string(name.value.begin(), name.value.end()));
}

/// After a case: pre-operational, with the previous values, and answering.
bool Check::comes_back() {
  for (const Duration wait : {settling, recovery}) {
    bench_.command(NmtCommand::enter_pre_operational);
    bench_.listen(wait);
    if (bench_.read(object_index::device_type, 0).kind != Reply::Kind::silent) return true;
  }
  return false;
}

TestResult Check::try_case(const TestCase& test) {
  const Time begin = bench_.now();
  bench_.forget();
  if (!lost_since_.empty()) {
    return {
        &test, not_applicable(fmt::format("the device is silent since {}", lost_since_)), {}, {}};
  }
  TestResult result{&test, test.judge(bench_), {}, {}};
  if (bench_.is_broken()) {
    result.verdict = not_applicable("the bus takes no frames, or the test was interrupted");
    return result;
  }
  if (result.verdict.outcome == Outcome::failed) {
    result.frames.assign(bench_.frames().begin(), bench_.frames().end());
  }
  if (comes_back()) {
    bench_.restore();
  } else if (!bench_.is_broken()) {
    lost_since_ = test.id;
    if (result.verdict.outcome != Outcome::failed) {
      result.verdict = failed("the device does not answer any more");
      result.frames.assign(bench_.frames().begin(), bench_.frames().end());
    }
  }
  result.took = bench_.now() - begin;
  return result;
}

Report Check::run(const std::function<void(const TestResult&)>& tell, std::string_view only) {
  Report report;
  identify(report);
  if (!report.has_answered) return report;
  std::optional<NmtState> state = bench_.state();
  if (!state && bench_.watch_state()) state = bench_.state();
  bench_.restore();
  if (bench_.is_broken()) {
    // No case was run yet, and no state was changed.
    bench_.go_on();
    bench_.restore();
    note_lost(report, bench_.unrestored());
    return report;
  }
  bench_.command(NmtCommand::enter_pre_operational);
  bench_.listen(settling);
  KeptSettings kept;
  kept.read(bench_);
  report.cases = all_cases(bench_.options().profile);
  report.results.reserve(report.cases.size());
  for (const TestCase& test : report.cases) {
    if (!is_selected(test, only)) continue;
    report.results.push_back(try_case(test));
    if (bench_.is_broken()) break;
    if (tell) tell(report.results.back());
  }
  report.is_whole = !bench_.is_broken();
  if (!lost_since_.empty()) {
    report.notes.push_back(fmt::format(
        "the device does not answer since {}: the cases behind it were not tried", lost_since_));
  }
  bench_.go_on();
  if (!report.is_whole && !bench_.is_broken()) {
    comes_back();
    bench_.restore();
  }
  finish(report, kept, state);
  return report;
}

/// Restores what a case has stored or deleted.
void Check::store_again(std::uint8_t group, std::vector<std::string>& lost) {
  constexpr std::uint16_t at = object_index::store_parameters;
  if (!bench_.write(at, group, save_signature, 4)) lost.push_back(text::object_text(at, group));
}

void Check::finish(Report& report, KeptSettings& kept, std::optional<NmtState> state) {
  std::vector<std::string> lost = bench_.unrestored();
  if (!bench_.is_broken() && lost_since_.empty()) {
    // What a case could not restore may be possible at this point.
    lost = kept.put_back(bench_);
    if (const auto group = bench_.stored()) store_again(*group, lost);
  }
  if (state == NmtState::operational) bench_.command(NmtCommand::start);
  if (state == NmtState::stopped) bench_.command(NmtCommand::stop);
  if (!state) report.notes.emplace_back("its NMT state was not known: it is pre-operational now");
  note_lost(report, lost);
}

}  // namespace canvoy::conformance
