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
/// Neither a frame nor an error frame was heard.
void judge_no_traffic(const Observed& bus, Findings& findings);
/// Error frames were heard, and not one frame; not where not_acknowledged tells why.
void judge_wrong_bit_rate(const Observed& bus, Findings& findings);
/// Half of the error frames or more, of 5 at least, say that nobody acknowledges.
void judge_not_acknowledged(const Observed& bus, Findings& findings);
/// 5 error frames or more, and one or more in 1000 frames, that strike no single node or CAN-ID.
void judge_bus_errors(const Observed& bus, Findings& findings);
/// Error frames, as many as for bus_errors, that strike the frames of one node, or those of all but
/// one.
void judge_errors_at_node(const Observed& bus, Findings& findings);
/// Frames took more than TrafficWatch::load_most of a second.
void judge_load_peak(const Observed& bus, Findings& findings);
/// Nobody spoke for TrafficWatch::silence_least or longer.
void judge_silence(const Observed& bus, Findings& findings);
/// The CAN-ID that nearly all errors strike, though others have most of the frames.
std::optional<std::uint16_t> struck_id(const Observed& bus);

// Nodes.
/// Heartbeats, states, SDO answers or errors show two devices with one node-ID.
void judge_node_id_twice(const Observed& bus, Findings& findings);
/// A gap is longer than a consumer allows (1016h), or than 2.5 periods where none is known.
void judge_heartbeat_missing(const Observed& bus, Findings& findings);
/// Two heartbeats or more were late by over a quarter of the period and 20 ms, and not yet missing.
void judge_heartbeat_late(const Observed& bus, Findings& findings);
/// A fifth or more of the latest intervals, of 10 at least, is a fifth or more off the period.
void judge_heartbeat_jitter(const Observed& bus, Findings& findings);
/// A node has started anew, and no NMT command has asked for it.
void judge_unexpected_boot_up(const Observed& bus, Findings& findings);
/// A node has sent more than NodeWatch::storm_least emergencies in NodeWatch::storm_time.
void judge_emergency_storm(const Observed& bus, Findings& findings);
/// A node has told an error by emergency. Left out where it is a storm, and errors of communication
/// (8100h to 82FFh) where another finding tells what they come from.
void judge_reported_error(const Observed& bus, Findings& findings);
/// A node that is there has left SDO requests without answer.
void judge_sdo_time_out(const Observed& bus, Findings& findings);
/// An SDO answer took SdoWatch::slow_from or longer.
void judge_sdo_slow(const Observed& bus, Findings& findings);

// What they send.
/// Lengths, rhythms, cycles, parameters or errors show two devices that send one CAN-ID.
void judge_cob_id_twice(const Observed& bus, Findings& findings);
/// A PDO had another length than its mapping says.
void judge_pdo_length(const Observed& bus, Findings& findings);
/// A synchronous PDO came behind the window (1007h), 3 times or more.
void judge_sync_window(const Observed& bus, Findings& findings);
/// A PDO came again before half of its inhibit time was over, 3 times or more.
void judge_inhibit_time(const Observed& bus, Findings& findings);
/// A value was reserved or out of range; one finding for each entry.
void judge_reserved_value(const Observed& bus, Findings& findings);
/// A value said that something is broken; one finding for each entry.
void judge_failed_value(const Observed& bus, Findings& findings);
/// Messages were against CiA 301 or a profile; one finding for each node and mark.
void judge_against_protocol(const Observed& bus, Findings& findings);
/// A device is not what its data sheet says; one finding for each node.
void judge_sheet_differs(const Observed& bus, Findings& findings);

}  // namespace canvoy::words
