#include "canvoy/formats/provisions_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/profiles/model/provisions.hpp"
#include "canvoy/profiles/registry.hpp"

namespace canvoy::formats {

namespace {

using Json = nlohmann::ordered_json;

void fill(Json& line, const BitRateProvision& rate) {
  line["kbit_per_second"] = rate.kilobits_per_second;
  line["category"] = category_name(rate.category);
}
void fill(Json& line, const IndexRangeProvision& range) {
  line["index"] = hex(range.first, 4);
  line["index_last"] = hex(range.last, 4);
  line["owner"] = range.owner;
}
void fill(Json& line, const ConfigurationProvision& configuration) {
  line["name"] = configuration.name;
  line["devices"] = Json::array();
  for (const ConfiguredDevice& device : configuration.devices) {
    line["devices"].push_back({{"code", hex(device.code, 2)},
                               {"class", device.device_class},
                               {"subclass", device.subclass}});
  }
}
void fill(Json& line, const AbortProvision& abort) {
  line["index"] = hex(abort.index, 4);
  line["sub"] = hex(abort.sub, 2);
  line["code"] = hex(static_cast<std::uint32_t>(abort.code), 8);
  line["when"] = abort.when;
}
void fill(Json& line, const FailureProvision& failure) {
  line["failure"] = failure.failure;
}
void fill(Json& line, const RuleProvision& rule) {
  line["subject"] = rule.subject;
  line["rule"] = rule.rule;
}
void fill(Json& line, const CodingProvision& coding) {
  line["index"] = hex(coding.index, 4);
  line["sub"] = hex(coding.sub, 2);
  line["selector"] = hex(coding.selector, 4);
  line["selected"] = hex(static_cast<std::uint64_t>(coding.selected), 2);
  line["content"] = coding.content;
  line["coding"] = coding.coding;
}
void fill(Json& line, const CommandProvision& command) {
  constexpr std::uint16_t one_byte_max = 0xFF;
  line["index"] = hex(command.index, 4);
  line["sub"] = hex(command.sub, 2);
  line["selector"] = hex(command.selector, 4);
  line["selected"] = hex(static_cast<std::uint64_t>(command.first), 2);
  line["selected_last"] = hex(static_cast<std::uint64_t>(command.last), 2);
  line["bytes"] = hex(command.bytes, command.bytes > one_byte_max ? 4 : 2);
  line["command"] = command.command;
}

}  // namespace

void write_provisions_json(const Profile& profile,
                           const std::function<void(const std::string& line)>& write) {
  if (profile.provisions == nullptr) return;
  const auto write_all = [&](const char* kind, const auto& provisions) {
    for (const auto& each : provisions) {
      Json line = {{"kind", kind}, {"profile", short_name(profile)}};
      fill(line, each);
      line["clause"] = each.clause;
      write(line.dump());
    }
  };
  const Provisions& all = *profile.provisions;
  write_all("bit_rate", all.bit_rates);
  write_all("index_range", all.index_ranges);
  write_all("configuration", all.configurations);
  write_all("abort", all.aborts);
  write_all("failure", all.failures);
  write_all("rule", all.rules);
  write_all("coding", all.codings);
  write_all("command", all.commands);
}

}  // namespace canvoy::formats
