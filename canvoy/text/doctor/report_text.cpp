#include "canvoy/text/doctor/report_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/text/doctor/judges.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/wrapped_text.hpp"

namespace canvoy::text {

namespace {

double seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e6;
}

std::string counted(std::uint64_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string head_text(std::string_view bus, const Observed& observed) {
  std::string text = fmt::format(
      "{}: {} of {} in {:.1f} s", bus, counted(observed.traffic.frames(), "frame"),
      counted(observed.traffic.nodes(), "node"), seconds(observed.end - observed.begin));
  const std::uint64_t errors = observed.errors.errors().count;
  if (errors != 0) text += fmt::format(", {}", counted(errors, "error frame"));
  return text;
}

/// Heartbeats and time-outs of several seconds are not seen in less.
constexpr Duration short_listening = 10s;

std::string healthy_text(Duration listened) {
  if (listened >= short_listening) return "healthy: nothing is wrong as far as it shows";
  return fmt::format(
      "healthy as far as it shows, but {:.1f} s are short: what comes once in some seconds, and "
      "what stays away, shows in a minute",
      seconds(listened));
}

std::size_t count_of(const Findings& findings, Severity severity) {
  return static_cast<std::size_t>(std::ranges::count_if(findings, [severity](const Finding& each) {
    return finding_row(each.kind).severity == severity;
  }));
}

std::string when_text(const Finding& finding, Time begin) {
  if (finding.count < 1 || finding.last <= finding.first) {
    return fmt::format("at {:.3f} s", seconds(finding.first - begin));
  }
  return fmt::format("from {:.3f} s to {:.3f} s", seconds(finding.first - begin),
                     seconds(finding.last - begin));
}

}  // namespace

std::string report_text(std::string_view bus, const Observed& observed, const Findings& findings,
                        std::size_t columns) {
  std::string lines;
  append_wrapped(lines, "", head_text(bus, observed), columns);
  for (const Finding& finding : findings) {
    const FindingRow& row = finding_row(finding.kind);
    lines += '\n';
    std::string title = fmt::format("{} ({})", row.title, row.name);
    if (finding.can_id) title += fmt::format(": {:03X}h", *finding.can_id);
    if (finding.node != 0) {
      title += fmt::format("{}{}", finding.can_id ? " of " : ": ", node_text(finding.node));
    }
    append_wrapped(lines, fmt::format("{}: ", severity_name(row.severity)), title, columns);
    append_wrapped(lines, "  what   ", finding.what, columns);
    append_wrapped(lines, "  when   ", when_text(finding, observed.begin), columns);
    append_wrapped(lines, "  why    ", row.why, columns);
    append_wrapped(lines, "  check  ", row.check, columns);
    append_wrapped(lines, "  do     ", row.cure, columns);
  }
  if (!findings.empty()) lines += '\n';
  const std::size_t errors = count_of(findings, Severity::error);
  const std::size_t warnings = count_of(findings, Severity::warning);
  append_wrapped(lines, "",
                 errors + warnings == 0 ? healthy_text(observed.end - observed.begin)
                                        : fmt::format("{}, {}", counted(errors, "error"),
                                                      counted(warnings, "warning")),
                 columns);
  return lines;
}

std::string report_json(std::string_view bus, const Observed& observed, const Findings& findings) {
  std::string lines;
  for (const Finding& finding : findings) {
    const FindingRow& row = finding_row(finding.kind);
    JsonLine json(lines);
    json.begin_object();
    json.key("bus").text(bus);
    json.key("severity").text(severity_name(row.severity));
    json.key("kind").text(row.name);
    json.key("title").text(row.title);
    if (finding.node != 0) json.key("node").number(std::int64_t{finding.node});
    if (finding.can_id) json.key("id").text(fmt::format("{:03X}", *finding.can_id));
    json.key("count").number(finding.count);
    json.key("first_s").number(seconds(finding.first - observed.begin));
    json.key("last_s").number(seconds(finding.last - observed.begin));
    json.key("what").text(finding.what);
    json.key("why").text(row.why);
    json.key("check").text(row.check);
    json.key("do").text(row.cure);
    json.end_object();
    lines += '\n';
  }
  JsonLine json(lines);
  json.begin_object();
  json.key("bus").text(bus);
  json.key("seconds").number(seconds(observed.end - observed.begin));
  json.key("frames").number(observed.traffic.frames());
  json.key("error_frames").number(observed.errors.errors().count);
  json.key("nodes").number(std::uint64_t{observed.traffic.nodes()});
  json.key("errors").number(std::uint64_t{count_of(findings, Severity::error)});
  json.key("warnings").number(std::uint64_t{count_of(findings, Severity::warning)});
  json.end_object();
  lines += '\n';
  return lines;
}

std::optional<Severity> worst_of(const Findings& findings) {
  std::optional<Severity> worst;
  for (const Finding& finding : findings) {
    const Severity severity = finding_row(finding.kind).severity;
    if (!worst || severity > *worst) worst = severity;
  }
  return worst;
}

}  // namespace canvoy::text
