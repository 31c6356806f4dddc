#include "canvoy/text/check/bench/case_rows.hpp"

#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint16_t consumed_ms = 100;
/// Time from the last heartbeat; an emergency after more than twice the allowed time does not
/// count.
constexpr Duration until_emergency = 400ms;

}  // namespace

void add_rows(TestCases& cases, Group group, std::span<const CaseRow> rows) {
  for (const CaseRow& row : rows) {
    cases.push_back({std::string(row.id), group, std::string(row.clause), std::string(row.title),
                     std::string(row.sends), std::string(row.expects), row.judge});
  }
}

NodeId played_node(const Bench& bench) {
  return bench.node() == node_id_max ? node_id_max - 1 : node_id_max;
}

std::uint32_t emergency_id(Bench& bench) {
  const std::uint32_t usual = can_id::emergency + bench.node();
  return bench.number(object_index::cob_id_emergency, 0).value_or(usual) & Frame::id_max;
}

void send_heartbeat(Bench& bench) {
  bench.send(Frame::data_frame(can_id::error_control + played_node(bench),
                               {static_cast<std::uint8_t>(NmtState::operational)}));
}

LostHeartbeat lose_heartbeat(Bench& bench) {
  const std::uint32_t watched = std::uint32_t{played_node(bench)} << 16 | consumed_ms;
  const Reply done = bench.set(object_index::heartbeat_consumers, 1, watched, 4);
  if (!done) return {cannot_set("1016h:01h", done), {}};
  const std::uint32_t id = emergency_id(bench);
  bench.drain();
  send_heartbeat(bench);
  return {{}, bench.await(id, until_emergency)};
}

std::optional<Verdict> reset_node(Bench& bench) {
  constexpr Duration boot_max = 5s;
  constexpr Duration after_boot_up = 20ms;
  bench.drain();
  bench.command(NmtCommand::reset_node);
  const Time until = bench.now() + boot_max;
  while (bench.now() < until && !bench.is_broken()) {
    const auto came = bench.await(can_id::error_control + bench.node(), until - bench.now());
    if (!came) break;
    if (came->frame.is_remote() || came->frame.length != 1 || came->frame.data[0] != 0) continue;
    bench.listen(after_boot_up);
    return std::nullopt;
  }
  return failed("no boot-up message within 5 s");
}

Verdict cannot_set(std::string_view object, const Reply& reply) {
  if (reply.is_absent()) return not_applicable(fmt::format("the device has no {}", object));
  std::string why = fmt::format("{} is not written: {}", object, reply.text());
  return reply.kind == Reply::Kind::aborted ? not_applicable(std::move(why))
                                            : failed(std::move(why));
}

Verdict refusal(const Reply& reply, std::string_view taken) {
  if (reply) return failed(std::string(taken));
  return reply.kind == Reply::Kind::aborted ? passed() : failed(reply.text());
}

}  // namespace canvoy::conformance
