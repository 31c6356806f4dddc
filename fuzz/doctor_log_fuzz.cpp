// Arbitrary bytes as the log that a doctor reads: its findings belong to the log, with valid nodes
// and CAN-IDs, and its memory stays bounded.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "canvoy/formats/trace/trace.hpp"
#include "canvoy/text/doctor/doctor.hpp"
#include "canvoy/text/doctor/report_text.hpp"
#include "fuzz/require.hpp"

namespace {

using canvoy::Time;
using canvoy::formats::TraceFrame;
using canvoy::formats::TraceRead;
using canvoy::formats::TraceReader;
using canvoy::fuzz::require;
using canvoy::text::Doctor;
using canvoy::text::Finding;
using canvoy::text::Findings;
using canvoy::text::Observed;

constexpr std::size_t buses_max = 4;
constexpr std::size_t pdo_ids = 0x6DF - 0x181 + 1;

void check(const Finding& finding, const Observed& bus) {
  require(finding.node <= canvoy::node_id_max);
  require(finding.can_id.value_or(0) <= canvoy::Frame::id_max);
  require(finding.count != 0 || !finding.what.empty());
  require(finding.first <= finding.last && finding.last <= bus.end);
  require(!canvoy::text::finding_row(finding.kind).name.empty());
}

void check_report(std::string_view name, const Doctor& doctor, const Findings& findings) {
  const Observed& bus = doctor.observed();
  require(bus.pdos.pdos().size() <= pdo_ids);
  const std::string json = canvoy::text::report_json(name, bus, findings);
  const auto lines = static_cast<std::size_t>(std::ranges::count(json, '\n'));
  require(lines == findings.size() + 1);
  require(!canvoy::text::report_text(name, bus, findings).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  canvoy::host::Result<TraceReader> reader = TraceReader::of(content);
  if (!reader) return 0;
  std::map<std::string, Doctor, std::less<>> doctors;
  Time last{};
  TraceFrame heard;
  for (TraceRead read; (read = reader->next(heard)) != TraceRead::end;) {
    if (read != TraceRead::frame) continue;
    last = std::max(last, heard.time);
    auto found = doctors.find(heard.channel);
    if (found == doctors.end() && doctors.size() < buses_max) {
      found = doctors.try_emplace(std::string(heard.channel), canvoy::text::DoctorOptions{125'000})
                  .first;
    }
    if (found != doctors.end()) found->second.hear(heard.time, heard.frame);
  }
  for (auto& [name, doctor] : doctors) {
    const Findings findings = doctor.findings(last);
    for (const Finding& finding : findings) check(finding, doctor.observed());
    check_report("can0", doctor, findings);
  }
  return 0;
}
