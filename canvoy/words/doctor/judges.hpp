// What the rows of finding.hpp look for: each adds what there is of its kind.
#pragma once

#include "canvoy/words/doctor/finding.hpp"
#include "canvoy/words/doctor/observed.hpp"

namespace canvoy::words {

/// `1.5 s`, `12.3 ms`, `250 us`: with as many digits as people look at.
std::string short_time(Duration time);
/// `once`, `twice`, `12 times`
std::string times_text(std::uint64_t count);

// The wire.
void judge_no_traffic(const Observed& bus, Findings& findings);
void judge_wrong_bit_rate(const Observed& bus, Findings& findings);
void judge_not_acknowledged(const Observed& bus, Findings& findings);
void judge_bus_errors(const Observed& bus, Findings& findings);
void judge_errors_at_node(const Observed& bus, Findings& findings);
void judge_load_peak(const Observed& bus, Findings& findings);
void judge_silence(const Observed& bus, Findings& findings);
/// The CAN-ID that nearly all errors strike, though others have most of the frames.
std::optional<std::uint16_t> struck_id(const Observed& bus);

// Nodes.
void judge_node_id_twice(const Observed& bus, Findings& findings);
void judge_heartbeat_missing(const Observed& bus, Findings& findings);
void judge_heartbeat_late(const Observed& bus, Findings& findings);
void judge_heartbeat_jitter(const Observed& bus, Findings& findings);
void judge_unexpected_boot_up(const Observed& bus, Findings& findings);
void judge_emergency_storm(const Observed& bus, Findings& findings);
void judge_sdo_time_out(const Observed& bus, Findings& findings);
void judge_sdo_slow(const Observed& bus, Findings& findings);

// What they send.
void judge_cob_id_twice(const Observed& bus, Findings& findings);
void judge_pdo_length(const Observed& bus, Findings& findings);
void judge_sync_window(const Observed& bus, Findings& findings);
void judge_inhibit_time(const Observed& bus, Findings& findings);
void judge_reserved_value(const Observed& bus, Findings& findings);
void judge_failed_value(const Observed& bus, Findings& findings);
void judge_against_protocol(const Observed& bus, Findings& findings);
void judge_sheet_differs(const Observed& bus, Findings& findings);

}  // namespace canvoy::words
