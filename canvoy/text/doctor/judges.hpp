// Judges for the rows of finding.hpp: each adds the findings of its kind.
#pragma once

#include "canvoy/text/doctor/finding.hpp"
#include "canvoy/text/doctor/observed.hpp"

namespace canvoy::text {

/// A time with few digits: `1.5 s`, `12.3 ms`, `250 us`.
std::string short_time(Duration time);
/// A count in words: `once`, `twice`, `12 times`.
std::string times_text(std::uint64_t count);

/// A finding of what was counted; node 0: not of a single node.
Finding found(FindingKind kind, NodeId node, const Tally& seen, std::string what);

// The wire

/// No frame and no error frame was heard.
void judge_no_traffic(const Observed& bus, Findings& findings);
/// Error frames were heard, but no frame; not reported if not_acknowledged is.
void judge_wrong_bit_rate(const Observed& bus, Findings& findings);
/// At least half of the error frames, and at least 5, report a missing acknowledgement.
void judge_not_acknowledged(const Observed& bus, Findings& findings);
/// At least 5 error frames, and at least one per 1000 frames, that concern no single node or
/// CAN-ID.
void judge_bus_errors(const Observed& bus, Findings& findings);
/// As many error frames as for bus_errors that concern the frames of one node, or of all nodes but
/// one.
void judge_errors_at_node(const Observed& bus, Findings& findings);
/// Frames took more than TrafficWatch::load_most of a second.
void judge_load_peak(const Observed& bus, Findings& findings);
/// The connection to the bus was lost.
void judge_lost_bus(const Observed& bus, Findings& findings);
/// No frame was heard for TrafficWatch::silence_least or longer.
void judge_silence(const Observed& bus, Findings& findings);
/// The CAN-ID with nearly all errors, though others have most of the frames.
std::optional<std::uint16_t> struck_id(const Observed& bus);

// Nodes

/// Heartbeats, states, SDO answers or errors indicate two devices with one node-ID.
void judge_node_id_twice(const Observed& bus, Findings& findings);
/// A gap is longer than a consumer allows (1016h), or than 2.5 periods if no consumer is known.
void judge_heartbeat_missing(const Observed& bus, Findings& findings);
/// Two or more heartbeats were late by more than a quarter of the period and 20 ms, but not
/// missing.
void judge_heartbeat_late(const Observed& bus, Findings& findings);
/// At least a fifth of the last intervals (10 or more) deviate from the period by a fifth or more.
void judge_heartbeat_jitter(const Observed& bus, Findings& findings);
/// A node has restarted without an NMT command.
void judge_unexpected_boot_up(const Observed& bus, Findings& findings);
/// A node has sent more than NodeWatch::storm_least emergencies in NodeWatch::storm_time.
void judge_emergency_storm(const Observed& bus, Findings& findings);
/// A node has reported an error by emergency. Omitted if it is a storm; errors of communication
/// (8100h to 82FFh) are omitted if another finding explains them.
void judge_reported_error(const Observed& bus, Findings& findings);
/// An active node has left SDO requests unanswered.
void judge_sdo_time_out(const Observed& bus, Findings& findings);
/// An SDO answer took SdoWatch::slow_from or longer.
void judge_sdo_slow(const Observed& bus, Findings& findings);

// What nodes send

/// Lengths, rhythms, cycles, parameters or errors indicate two devices that send
/// one CAN-ID.
void judge_cob_id_twice(const Observed& bus, Findings& findings);
/// Rhythms, counters (1019h) or 1005h indicate two producers of SYNC.
void judge_sync_twice(const Observed& bus, Findings& findings);
/// A device with synchronous PDOs has another CAN-ID in 1005h, or the period of SYNC differs from
/// that of its producer (1006h).
void judge_sync_differs(const Observed& bus, Findings& findings);
/// The length of a PDO differed from its mapping.
void judge_pdo_length(const Observed& bus, Findings& findings);
/// A synchronous PDO came after the window (1007h), at least 3 times.
void judge_sync_window(const Observed& bus, Findings& findings);
/// A PDO was repeated before half of its inhibit time, at least 3 times.
void judge_inhibit_time(const Observed& bus, Findings& findings);
/// A value was reserved or out of range; one finding for each entry.
void judge_reserved_value(const Observed& bus, Findings& findings);
/// A value reported a fault; one finding for each entry.
void judge_failed_value(const Observed& bus, Findings& findings);
/// Messages violated CiA 301 or a profile; one finding for each node and mark.
void judge_against_protocol(const Observed& bus, Findings& findings);
/// A device differs from its data sheet; one finding for each node.
void judge_sheet_differs(const Observed& bus, Findings& findings);

}  // namespace canvoy::text
