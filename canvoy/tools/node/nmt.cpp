// canvoy nmt BUS NODE STATE: commands nodes to an NMT state, and checks it by their heartbeats (CiA
// 301, 7.3.2 and 7.2.8).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>

#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/cli/spelling.hpp"
#include "canvoy/tools/node/ask_options.hpp"
#include "canvoy/tools/node/ask_verbs.hpp"

namespace canvoy::tools {

namespace {

struct NmtOptions : AskOptions {
  std::string state = {};
  bool unchecked = false;
};

/// A reset ends with the boot-up message, the state of which is initialisation.
struct NmtWord {
  std::string_view name;
  NmtCommand command;
  NmtState state;
};
constexpr auto nmt_words = std::to_array<NmtWord>({
    {"operational", NmtCommand::start, NmtState::operational},
    {"stopped", NmtCommand::stop, NmtState::stopped},
    {"pre-operational", NmtCommand::enter_pre_operational, NmtState::pre_operational},
    {"reset-node", NmtCommand::reset_node, NmtState::initialisation},
    {"reset-communication", NmtCommand::reset_communication, NmtState::initialisation},
    {"start", NmtCommand::start, NmtState::operational},
    {"stop", NmtCommand::stop, NmtState::stopped},
    {"preop", NmtCommand::enter_pre_operational, NmtState::pre_operational},
    {"reset-comm", NmtCommand::reset_communication, NmtState::initialisation},
    {"reset-com", NmtCommand::reset_communication, NmtState::initialisation},
    {"reset-application", NmtCommand::reset_node, NmtState::initialisation},
});
constexpr Duration nmt_time_out = 2s;

const NmtWord* find_nmt_word(std::string_view text) {
  const auto* found = std::ranges::find_if(
      nmt_words, [text](const NmtWord& word) { return same_name(word.name, text); });
  return found == nmt_words.end() ? nullptr : found;
}

const NmtWord& parse_nmt_state(std::string_view text) {
  if (const NmtWord* const found = find_nmt_word(text)) return *found;
  std::vector<std::string> names;
  names.reserve(nmt_words.size());
  for (const NmtWord& word : nmt_words) names.emplace_back(word.name);
  throw UsageError(
      fmt::format("'{}' is no NMT state: operational (or start), stopped (stop), pre-operational "
                  "(preop), reset-node or reset-communication{}",
                  text, did_you_mean(text, names)));
}

/// `all`, or 0 as on the bus (CiA 301, 7.2.8.3.1.1).
bool is_all(std::string_view node) {
  return same_name(node, "all") || node == "0";
}

/// The states that nodes report after the command.
class NmtWatch {
 public:
  NmtWatch(Session& session, NodeId node, const NmtWord& wanted)
      : session_(session), node_(node), wanted_(wanted) {
    session.hear([this](const host::BusFrame& heard) { hear(heard); });
  }
  ~NmtWatch() { session_.hear({}); }
  NmtWatch(const NmtWatch&) = delete;
  NmtWatch& operator=(const NmtWatch&) = delete;

  /// For one node until it arrives; for all nodes the whole time.
  void wait(Duration length) {
    const Time end = session_.loop().now() + length;
    while (!is_reached() && session_.loop().now() < end) {
      session_.run_for(end - session_.loop().now());
    }
  }
  bool is_reached() const { return node_ != 0 && reached_.contains(node_); }
  const std::map<NodeId, NmtState>& said() const { return said_; }
  bool has_reached(NodeId node) const { return reached_.contains(node); }

 private:
  void hear(const host::BusFrame& heard) {
    const Frame& frame = heard.frame;
    const bool is_heartbeat = frame.is_plain() && frame.length == 1 &&
                              frame.id > can_id::error_control && frame.id <= 0x77F;
    if (frame.is_plain() && frame.id == can_id::nmt) is_sent_ = true;
    if (!is_heartbeat || !is_sent_) return;
    const auto id = static_cast<NodeId>(frame.id - can_id::error_control);
    if (node_ != 0 && id != node_) return;
    const auto state = static_cast<NmtState>(frame.data[0] & ~nmt_toggle);
    said_[id] = state;
    // An earlier heartbeat may have waited for the bus: the last one counts.
    if (state == wanted_.state) {
      reached_.insert(id);
    } else if (wanted_.state != NmtState::initialisation) {
      reached_.erase(id);
    }
    if (is_reached()) session_.loop().stop();
  }

  static constexpr unsigned nmt_toggle = guarding_toggle_bit;

  Session& session_;
  NodeId node_;
  const NmtWord& wanted_;
  bool is_sent_ = false;
  std::map<NodeId, NmtState> said_;
  std::set<NodeId> reached_;
};

std::string reached_text(const NmtWord& wanted, bool reached, NmtState said) {
  if (wanted.state == NmtState::initialisation) {
    return reached ? "has booted" : "has not booted";
  }
  return fmt::format("is {}{}", reached ? "" : "still ", text::nmt_state_text(said));
}

void report_nmt(const NmtOptions& options, NodeId node, NmtState state, std::string_view text) {
  if (!options.json) {
    fmt::print("{} {}\n", text::node_text(node), text);
    return;
  }
  std::string line;
  text::JsonLine json(line);
  json.begin_object();
  json.key("event").text("nmt-state");
  json.key("node").number(node);
  json.key("state").text(text::nmt_state_text(state));
  json.key("text").text(text);
  json.end_object();
  fmt::print("{}\n", line);
}

[[noreturn]] void refuse_silence(NodeId node, Duration length) {
  throw Failure(fmt::format(
      "{} within {}: whether the state was reached is not known; give 1017h a heartbeat time, or "
      "--unchecked",
      node == 0 ? "no heartbeat of any node" : "no heartbeat of " + text::node_text(node),
      text::duration_text(length)));
}

int command_nodes(const NmtOptions& options, Sessions& sessions) {
  const NodeId node = is_all(options.node) ? NodeId{0} : options.node_id();
  const NmtWord& wanted = parse_nmt_state(options.state);
  const Duration length = options.time_out_of(nmt_time_out);
  Session& session = sessions.open(options.bus, {length, length});
  const Frame frame =
      Frame::data_frame(can_id::nmt, {static_cast<std::uint8_t>(wanted.command), node});
  if (options.unchecked) {
    session.send(frame);
    return exit_done;
  }
  NmtWatch watch(session, node, wanted);
  session.send(frame);
  watch.wait(length);
  if (watch.said().empty()) refuse_silence(node, length);
  bool all = true;
  for (const auto& [id, state] : watch.said()) {
    const bool reached = watch.has_reached(id);
    report_nmt(options, id, state, reached_text(wanted, reached, state));
    all = all && reached;
  }
  return all ? exit_done : exit_failed;
}

}  // namespace

bool is_nmt_word(std::string_view word) {
  return find_nmt_word(word) != nullptr;
}

void add_nmt(Verb& app, Sessions& sessions) {
  const auto options = std::make_shared<NmtOptions>();
  Verb& command = app.add_verb(
      "nmt", "Start, stop or reset nodes, and see by their heartbeats that it was done");
  options->add_bus(command);
  options->add_node(command, "10, 0x0A, 0Ah, its name in the file of --network, or all");
  command.add({
      {"state", options->state,
       "operational, stopped, pre-operational, reset-node, reset-communication", required},
      {"--timeout", options->time_out,
       "how long heartbeats are waited for; of all nodes, listened to (default 2s)"},
      {"--unchecked", options->unchecked, "only send the command"},
  });
  options->add_json(command);
  command.add_examples(
      "  canvoy nmt can0 10 operational\n"
      "  canvoy nmt can0 0Ah pre-operational --json\n"
      "  canvoy nmt can0 all start --timeout 1500ms\n"
      "  canvoy nmt can0 10 reset-communication\n"
      "  canvoy nmt can0 10 stop --unchecked");
  command.runs([options, &sessions] { return command_nodes(*options, sessions); });
}

}  // namespace canvoy::tools
