#include "canvoy/formats/signals/signal_html.hpp"

#include <fmt/format.h>

#include "canvoy/formats/plain_text.hpp"

namespace canvoy::formats {

namespace {

constexpr std::string_view html_style =
    "body{font:14px/1.4 sans-serif;margin:2em auto;max-width:75em;padding:0 1em}"
    "table{border-collapse:collapse;width:100%;margin:.5em 0 2em}"
    "th,td{border-bottom:1px solid #ccc;padding:.2em .6em;text-align:left;vertical-align:top}"
    "th{position:sticky;top:0;background:#eee}td.n{white-space:nowrap;font-family:monospace}"
    "@media print{body{margin:0;max-width:none}th{position:static}}";

std::string html_states(const Signal& signal) {
  std::string text;
  for (const SignalState& state : signal.states) {
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : "<br>", state.number, markup_text(state.name));
  }
  return text;
}

/// `0.125 °C`, `0.5 % − 10`; empty for a plain number.
std::string html_scale(const Signal& signal) {
  if (signal.factor == 1 && signal.offset == 0) return markup_text(signal.unit);
  std::string text = fmt::format("{} {}", signal.factor, markup_text(signal.unit));
  if (signal.offset != 0) text += fmt::format(" from {} on", signal.offset);
  return text;
}

std::string html_limits(const Signal& signal) {
  return signal.limits ? fmt::format("{} to {}", signal.limits->first, signal.limits->second) : "";
}

void append_names(std::string& text, const char* what, const std::vector<std::string>& names) {
  if (names.empty()) return;
  text += fmt::format("{}: ", what);
  for (const std::string& name : names) {
    text += fmt::format("{}{}", &name == &names.front() ? "" : ", ", markup_text(name));
  }
  text += "<br>";
}

void append_message(std::string& text, const SignalMessage& message) {
  text += fmt::format("<h3 id=\"m{0:03X}\">{0:03X}h {1}</h3>\n<p>", message.can_id,
                      markup_text(message.name));
  append_names(text, "sent by", message.senders);
  append_names(text, "received by", message.receivers);
  text += fmt::format("{} bytes. {}</p>\n", message.length, markup_text(message.comment));
  text += "<table><tr><th>bits<th>object<th>signal<th>unit and step<th>range<th>states</tr>\n";
  for (const Signal& signal : message.signals) {
    const std::string object =
        signal.index == 0 ? "" : fmt::format("{:04X}h:{:02X}h", signal.index, signal.sub);
    text += fmt::format("<tr><td class=n>{}..{}<td class=n>{}<td>{}<td>{}<td>{}<td>{}</tr>\n",
                        signal.first_bit, signal.first_bit + signal.bits - 1, object,
                        markup_text(signal.name), html_scale(signal), html_limits(signal),
                        html_states(signal));
  }
  text += "</table>\n";
}

void append_line(std::string& text, const DictionaryLine& line) {
  text += fmt::format("<tr><td class=n>{:04X}h:{:02X}h<td>{}<td class=n>{}<td>{}{}<td>{}<td>",
                      line.index, line.sub, markup_text(line.name), markup_text(line.type),
                      markup_text(line.access), line.may_be_mapped ? ", PDO" : "",
                      markup_text(line.value.empty() ? line.initial : line.value));
  const bool is_plain = line.fields.size() == 1 && line.fields.front().name == line.name;
  for (const Signal& field : line.fields) {
    if (!is_plain) {
      text += fmt::format("<b>{}</b> (bits {}..{}) ", markup_text(field.name), field.first_bit,
                          field.first_bit + field.bits - 1);
    }
    text += html_scale(field);
    if (field.limits) text += ' ' + html_limits(field);
    if (!field.states.empty()) text += "<br>" + html_states(field);
    text += "<br>";
  }
  text += fmt::format("<td>{}</tr>\n", markup_text(line.clause));
}

}  // namespace

std::string write_signal_html(const SignalTable& table, const std::string& title) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=en><meta "
      "charset=utf-8><title>{0}</title><style>{1}</style>\n<h1>{0}</h1>\n",
      markup_text(title), html_style);
  text += "<h2>Nodes</h2>\n<table><tr><th>node-ID<th>name<th>product<th>profile</tr>\n";
  for (const SignalNode& node : table.nodes) {
    text +=
        fmt::format("<tr><td>{}<td><a href=\"#n{}\">{}</a><td>{}<td>{}</tr>\n", node.id, node.id,
                    markup_text(node.name), markup_text(node.product), markup_text(node.profile));
  }
  text += "</table>\n<h2>Messages</h2>\n";
  for (const SignalMessage& message : table.messages) append_message(text, message);
  for (const SignalNode& node : table.nodes) {
    text += fmt::format("<h2 id=n{}>Dictionary of {}, node {}</h2>\n", node.id,
                        markup_text(node.name), node.id);
    text += "<table><tr><th>object<th>name<th>type<th>access<th>value<th>meaning<th>clause</tr>\n";
    for (const DictionaryLine& line : node.dictionary) append_line(text, line);
    text += "</table>\n";
  }
  return text + "</html>\n";
}

}  // namespace canvoy::formats
