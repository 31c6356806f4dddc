#include "canvoy/tools/node/ask_options.hpp"

#include "canvoy/tools/argument/duration_argument.hpp"
#include "canvoy/tools/argument/profile_argument.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/sheet/sheet_file.hpp"

namespace canvoy::tools {

void AskOptions::add_bus(Verb& command) {
  command.add({
      {"bus", bus, bus_text, required},
  });
}

void AskOptions::add_node(Verb& command, const char* text) {
  constexpr const char* usual = "10, 0x0A, 0Ah, or its name in the file of --network";
  command.add({
      {"node", node, text == nullptr ? usual : text, required},
  });
}

void AskOptions::add_any_node(Verb& command) {
  add_node(
      command,
      "10, 0x0A, 0Ah, its name in the file of --network, or 2:7 for node 7 of network 2 behind "
      "another");
  takes_remote = true;
  remote.add_to(command);
}

void AskOptions::add_time_out(Verb& command) {
  command.add({
      {"--timeout", time_out, answer_time_text, answer_time_rules},
  });
}

void AskOptions::add_profile(Verb& command) {
  command.add_taken(
      "--profile", [this](const std::string& text) { describe(parse_profile(text).number); },
      "419, 417-4 (default: what the node's 1000h says)");
  command.add_taken(
      "--eds",
      [this](const std::string& path) {
        formats::Findings findings;
        sheet = std::make_shared<decoder::SheetProfile>(read_sheet_file(path, findings));
        describe(ProfileChoice(sheet->profile()));
      },
      "its data sheet (EDS, DCF, XDD, XDC), with the names and types of its own objects");
}

void AskOptions::describe(const ProfileChoice& chosen) {
  if (profile.number != 0 || profile.sheet != nullptr) {
    throw UsageError("give either --profile or --eds, once");
  }
  profile = chosen;
}

void AskOptions::add_json(Verb& command) {
  command.add({
      {"--json", json, "one JSON object a line"},
  });
}

RemotePlace AskOptions::place() const {
  return takes_remote ? parse_remote_place(node) : RemotePlace{.node = parse_node_id(node)};
}

NodeId AskOptions::node_id() const {
  return place().node;
}

Duration AskOptions::time_out_of(Duration usual) const {
  return parse_duration_argument(time_out, usual);
}

Session& AskOptions::open(Sessions& sessions) const {
  Session& session = sessions.open(bus, answer_time());
  const std::uint16_t network = takes_remote ? place().network : 0;
  if (network == 0) {
    session.reach_bus();
    return session;
  }
  RemoteSettings settings;
  settings.network = network;
  settings.indication = static_cast<std::uint8_t>(remote.indication);
  session.reach_behind(parse_node_id(remote.through), settings);
  return session;
}

}  // namespace canvoy::tools
