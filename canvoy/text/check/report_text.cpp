#include "canvoy/text/check/report_text.hpp"

#include <fmt/format.h>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/formats/plain_text.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/text/frame_line.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/text/wrapped_text.hpp"

namespace canvoy::conformance {

namespace {

using text::append_wrapped;

std::size_t count_in(const Report& report, Group group, Outcome outcome) {
  std::size_t count = 0;
  for (const TestResult& each : report.results) {
    if (each.test->group == group && each.verdict.outcome == outcome) ++count;
  }
  return count;
}

std::string device_text(const Identity& device) {
  std::string text = text::node_text(device.node);
  if (!device.name.empty()) text += fmt::format(", {}", device.name);
  const auto add = [&text](std::string_view what, const std::optional<std::uint32_t>& number) {
    if (number) text += fmt::format(", {} {:08X}h", what, *number);
  };
  add("device type", device.device_type);
  add("vendor-ID", device.vendor);
  add("product code", device.product);
  add("revision", device.revision);
  add("serial number", device.serial);
  return text;
}

std::string bus_text(const ReportHead& head) {
  if (head.bit_rate == 0) return head.bus;
  return fmt::format("{}, {} kbit/s", head.bus, head.bit_rate / 1000);
}

std::string verdict_line(const Report& report) {
  const std::size_t wrong = report.count(Outcome::failed);
  const std::size_t right = report.count(Outcome::passed);
  std::string text =
      fmt::format("{}: {} of {} cases passed, {} failed, {} do not apply",
                  wrong == 0 && report.is_whole ? "PASS" : "FAIL", right, report.results.size(),
                  wrong, report.count(Outcome::not_applicable));
  if (!report.is_whole) text += "; the test is not whole: the bus takes no frames";
  return text;
}

/// Rows of the head of a report: label and text.
std::vector<std::pair<std::string, std::string>> head_rows(const ReportHead& head,
                                                           const Report& report) {
  return {{"device", device_text(report.device)},
          {"bus", bus_text(head)},
          {"data sheet", head.sheet.empty() ? "none: --eds FILE" : head.sheet},
          {"profile", head.profile.empty() ? "none that is known" : head.profile},
          {"written", head.moves ? "objects of communication and application (--moves)"
                                 : "objects of communication only"},
          {"tried", fmt::format("{}, canvoy {}", head.date, head.version)}};
}

void append_cell(std::string& page, std::string_view text) {
  page += "<td>";
  page += formats::markup_text(text);
  page += "</td>";
}

void append_result_row(std::string& page, const TestResult& result) {
  const TestCase& test = *result.test;
  constexpr std::string_view classes[] = {"pass", "fail", "none"};
  page += fmt::format(R"(<tr id="{}" class="{}">)", test.id,
                      classes[static_cast<std::size_t>(result.verdict.outcome)]);
  append_cell(page, outcome_name(result.verdict.outcome));
  for (const std::string* text :
       {&test.id, &test.title, &test.clause, &test.sends, &test.expects, &result.verdict.why}) {
    append_cell(page, *text);
  }
  page += "</tr>\n";
  if (result.frames.empty()) return;
  page += "<tr><td></td><td colspan=\"6\"><pre>";
  for (const std::string& line : frame_lines(result, 120)) {
    page += formats::markup_text(line);
    page += '\n';
  }
  page += "</pre></td></tr>\n";
}

/// The failed cases with links to their rows: of hundreds of rows, they are wanted first.
void append_failures(std::string& page, const Report& report) {
  if (report.count(Outcome::failed) == 0) return;
  page += "<h2>Failed</h2>\n<ul>\n";
  for (const TestResult& each : report.results) {
    if (each.verdict.outcome != Outcome::failed) continue;
    page +=
        fmt::format("<li><a href=\"#{0}\">{0}</a> {1}: {2}</li>\n", each.test->id,
                    formats::markup_text(each.test->title), formats::markup_text(each.verdict.why));
  }
  page += "</ul>\n";
}

constexpr std::string_view html_head =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
    "<meta name=\"viewport\" content=\"width=device-width\"><title>Conformance test</title>\n"
    "<style>body{font:15px/1.4 sans-serif;margin:2em auto;max-width:75em;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #ccc;padding:.2em .5em;"
    "text-align:left;vertical-align:top}pre{margin:0;overflow:auto;font-size:13px}"
    ".pass td:first-child{color:#060}.fail td:first-child{color:#b00;font-weight:bold}"
    ".none{color:#666}tr[id]>td:nth-child(2){white-space:nowrap}</style></head><body>\n";

void append_identity(text::JsonLine& json, const Identity& device) {
  json.key("node").number(unsigned{device.node});
  if (!device.name.empty()) json.key("name").text(device.name);
  const auto add = [&json](std::string_view key, const std::optional<std::uint32_t>& number) {
    if (number) json.key(key).text(fmt::format("{:08X}", *number));
  };
  add("device_type", device.device_type);
  add("vendor", device.vendor);
  add("product", device.product);
  add("revision", device.revision);
  add("serial", device.serial);
}

void append_case(text::JsonLine& json, const TestCase& test) {
  json.key("case").text(test.id);
  json.key("class").text(group_name(test.group));
  json.key("title").text(test.title);
  json.key("clause").text(test.clause);
  json.key("sends").text(test.sends);
  json.key("expects").text(test.expects);
}

}  // namespace

std::vector<std::string> frame_lines(const TestResult& result, std::size_t columns) {
  std::vector<std::string> lines;
  if (result.frames.empty()) return lines;
  text::FrameDecoder decoder;
  const Time first = result.frames.front().time;
  for (const Heard& each : result.frames) {
    const FrameText text(each.frame);
    const text::FrameWords& said = decoder.decode(each.frame);
    std::string line;
    text::append_narrow_line(line, {each.time - first, {}, text.view()}, said, said.text, columns);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string result_text(const TestResult& result) {
  const TestCase& test = *result.test;
  std::string text;
  append_wrapped(text, fmt::format("{} {} ", outcome_name(result.verdict.outcome), test.id),
                 test.title, report_columns);
  if (result.verdict.outcome == Outcome::not_applicable) {
    append_wrapped(text, "     ", result.verdict.why, report_columns);
  }
  if (result.verdict.outcome != Outcome::failed) return text;
  append_wrapped(text, "     clause   ", test.clause, report_columns);
  append_wrapped(text, "     sends    ", test.sends, report_columns);
  append_wrapped(text, "     expects  ", test.expects, report_columns);
  append_wrapped(text, "     came     ", result.verdict.why, report_columns);
  // The last ones are the most informative.
  constexpr std::size_t shown = 8;
  std::vector<std::string> lines = frame_lines(result, report_columns - 5);
  const std::size_t skipped = lines.size() > shown ? lines.size() - shown : 0;
  for (std::size_t i = skipped; i < lines.size(); ++i) {
    std::string_view rest = lines[i];
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      text += fmt::format("     {}\n", rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return text;
}

std::string summary_text(const ReportHead& head, const Report& report) {
  std::string text;
  for (const auto& [what, is] : head_rows(head, report)) {
    append_wrapped(text, fmt::format("{:<12}", what), is, report_columns);
  }
  text += fmt::format("\n{:<20} {:>5} {:>5} {:>5}\n", "class", "PASS", "FAIL", "n/a");
  for (std::size_t i = 0; i < group_count; ++i) {
    const auto group = static_cast<Group>(i);
    const std::size_t right = count_in(report, group, Outcome::passed);
    const std::size_t wrong = count_in(report, group, Outcome::failed);
    const std::size_t none = count_in(report, group, Outcome::not_applicable);
    if (right + wrong + none == 0) continue;
    text += fmt::format("{:<20} {:>5} {:>5} {:>5}\n", group_name(group), right, wrong, none);
  }
  text += '\n';
  for (const std::string& note : report.notes) append_wrapped(text, "note: ", note, report_columns);
  append_wrapped(text, "", verdict_line(report), report_columns);
  return text;
}

std::string list_text(const TestCases& cases) {
  std::string text;
  for (const TestCase& test : cases) {
    append_wrapped(text, fmt::format("{:<16} ", test.id), test.title, report_columns);
    append_wrapped(text, "                 clause   ", test.clause, report_columns);
    append_wrapped(text, "                 sends    ", test.sends, report_columns);
    append_wrapped(text, "                 expects  ", test.expects, report_columns);
  }
  return text;
}

std::string list_json(const TestCases& cases) {
  std::string lines;
  for (const TestCase& test : cases) {
    text::JsonLine json(lines);
    json.begin_object();
    append_case(json, test);
    json.end_object();
    lines += '\n';
  }
  return lines;
}

std::string report_json(const ReportHead& head, const Report& report) {
  std::string lines;
  for (const TestResult& result : report.results) {
    text::JsonLine json(lines);
    json.begin_object();
    append_case(json, *result.test);
    json.key("verdict").text(outcome_name(result.verdict.outcome));
    if (!result.verdict.why.empty()) json.key("why").text(result.verdict.why);
    json.key("seconds").number(static_cast<double>(result.took.count()) / 1e6);
    if (!result.frames.empty()) {
      json.key("frames").begin_list();
      for (const std::string& line : frame_lines(result, 1000)) json.text(line);
      json.end_list();
    }
    json.end_object();
    lines += '\n';
  }
  text::JsonLine json(lines);
  json.begin_object();
  append_identity(json, report.device);
  json.key("bus").text(head.bus);
  json.key("bit_rate").number(head.bit_rate);
  json.key("sheet").text(head.sheet);
  json.key("profile").text(head.profile);
  json.key("version").text(head.version);
  json.key("date").text(head.date);
  json.key("moves").truth(head.moves);
  json.key("passed").number(std::uint64_t{report.count(Outcome::passed)});
  json.key("failed").number(std::uint64_t{report.count(Outcome::failed)});
  json.key("not_applicable").number(std::uint64_t{report.count(Outcome::not_applicable)});
  json.key("whole").truth(report.is_whole);
  json.key("notes").begin_list();
  for (const std::string& note : report.notes) json.text(note);
  json.end_list();
  json.end_object();
  lines += '\n';
  return lines;
}

std::string report_html(const ReportHead& head, const Report& report) {
  std::string page(html_head);
  page += "<h1>Conformance test</h1>\n<p><strong>";
  page += formats::markup_text(verdict_line(report));
  page += "</strong></p>\n<table>\n";
  for (const auto& [what, is] : head_rows(head, report)) {
    page += "<tr><th>";
    page += formats::markup_text(what);
    page += "</th>";
    append_cell(page, is);
    page += "</tr>\n";
  }
  page += "</table>\n";
  for (const std::string& note : report.notes) {
    page += "<p>";
    page += formats::markup_text(note);
    page += "</p>\n";
  }
  append_failures(page, report);
  for (std::size_t i = 0; i < group_count; ++i) {
    const auto group = static_cast<Group>(i);
    const std::size_t wrong = count_in(report, group, Outcome::failed);
    const std::size_t right = count_in(report, group, Outcome::passed);
    const std::size_t none = count_in(report, group, Outcome::not_applicable);
    if (right + wrong + none == 0) continue;
    page += fmt::format("<h2>{}: {} passed, {} failed, {} do not apply</h2>\n<table>\n",
                        group_name(group), right, wrong, none);
    page +=
        "<tr><th></th><th>case</th><th>what is judged</th><th>clause</th><th>sends</th>"
        "<th>expects</th><th>came</th></tr>\n";
    for (const TestResult& each : report.results) {
      if (each.test->group == group) append_result_row(page, each);
    }
    page += "</table>\n";
  }
  page += "</body></html>\n";
  return page;
}

}  // namespace canvoy::conformance
