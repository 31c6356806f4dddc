#include "canvoy/text/doctor/finding.hpp"

#include <array>
#include <cstddef>

#include "canvoy/text/doctor/judges.hpp"

namespace canvoy::text {

// Named, so that sources compiled together with this one do not see `error`.
namespace finding_table {

using enum FindingKind;
using enum Severity;

constexpr auto rows = std::to_array<FindingRow>({
    {lost_bus, "lost-bus", error, "the connection to the bus was lost",
     "What came meanwhile was not heard, and what is said here does not count for it.",
     "Is the interface up (ip -details link), its adapter plugged in? Does the server run that the "
     "address names?",
     "Bring the connection back, then listen again.", judge_lost_bus},
    {no_traffic, "no-traffic", error, "nothing is heard",
     "Without frames no device works with another one; heartbeats alone would be some each second.",
     "Is the power on? With a multimeter, CAN_H and CAN_L against ground: some 2.5 V each on a bus "
     "that is idle. Is it the right interface, is it up (ip -details link), is the plug in?",
     "Switch the devices on, or mend the cable to this place; then listen again. Devices that wait "
     "for a master or for LSS may be silent: canvoy scan asks.",
     judge_no_traffic},
    {wrong_bit_rate, "wrong-bit-rate", error, "only error frames: another bit rate",
     "A controller with another bit rate understands nothing, and one that is not in listen-only "
     "mode destroys the frames of all others.",
     "Listen with each of the usual bit rates: 125, 250, 500, 1000, 50, 20, 10 kbit/s. If none is "
     "right, look with an oscilloscope for the shortest bit, and for CAN_H and CAN_L exchanged.",
     "Set the bit rate of this interface to that of the bus, or that of the device that differs "
     "(by LSS, a switch or its object) to the others'.",
     judge_wrong_bit_rate},
    {not_acknowledged, "not-acknowledged", error, "one node is alone, or alone with its bit rate",
     "A frame that nobody acknowledges is sent again and again, and its sender says nothing else.",
     "Are other devices switched on, on this piece of cable, and not in listen-only mode? Have "
     "they the same bit rate? Measure the cable for a break.",
     "Connect or switch on a second device with the same bit rate; a break in the cable leaves "
     "its piece alone in the same way.",
     judge_not_acknowledged},
    {bus_errors, "bus-errors", error, "many error frames: termination or cable",
     "Each destroyed frame is sent again: the bus is slower, nodes get error-passive, and then "
     "leave it (bus-off).",
     "Switched off, 60 ohms between CAN_H and CAN_L: 120 ohms say that one termination is missing, "
     "40 that there is one too many. Are stubs short, is the cable as long as its bit rate allows, "
     "is the shield on ground at one end?",
     "120 ohms at both ends of the cable and nowhere else; shorten stubs; halve the bus until the "
     "errors go away.",
     judge_bus_errors},
    {errors_at_node, "errors-at-node", error, "error frames because of one node",
     "What one node cannot read or send rightly is destroyed for all; in the end it is bus-off.",
     "Unplug the node: do the errors go away? Look at its plug, its stub, its ground and its "
     "transceiver, and at its bit timing (sample point, clock).",
     "Mend its connection or exchange the device; set its sample point to that of the others.",
     judge_errors_at_node},
    {node_id_twice, "node-id-twice", error, "two devices have one node-ID",
     "Both answer each SDO request, send the same CAN-IDs, and follow commands that are meant for "
     "one; who watches over the node does not see that one of them is gone.",
     "Unplug one of the devices that could have this node-ID: does the node go on? With canvoy lss "
     "scan, or by 1018h of each of them alone, see which they are.",
     "Give one of them another node-ID, by its switches or by canvoy lss, and start it anew.",
     judge_node_id_twice},
    {cob_id_twice, "cob-id-twice", error, "two devices send one CAN-ID",
     "Receivers take the one for the other; where both begin at once, each destroys the other's "
     "frame, until one of them is bus-off (CiA 301, 7.3.3: a COB-ID has one producer).",
     "Read 1800h:01h to 19FFh:01h of all nodes (canvoy doctor --ask does), and compare them.",
     "Give one of the PDOs a CAN-ID of its own: 1800h:01h and those after it, while it is "
     "switched off by bit 31.",
     judge_cob_id_twice},
    {sync_twice, "sync-twice", error, "two devices send SYNC",
     "Cycles are cut into two: synchronous PDOs are sent and taken at wrong moments, and a drive "
     "moves unevenly (CiA 301, 7.2.5: one producer).",
     "Read 1005h of all nodes (canvoy doctor --ask does): bit 30 says that a device produces SYNC. "
     "Unplug one of them: does it come evenly then?",
     "Let one device produce it: 1006h = 0, then 1005h without bit 30, in each other one; store "
     "it (1010h).",
     judge_sync_twice},
    {heartbeat_missing, "heartbeat-missing", error, "heartbeats are missing",
     "Who watches over the node takes it for lost, and brings the machine into its safe state "
     "(CiA 301, 7.2.8.3.2.2).",
     "Is the node switched on, has it started anew, is it bus-off? Compare 1017h of the node with "
     "1016h of those that watch it: 1016h is to be the longer one.",
     "Mend power or cable of the node; or choose 1016h at least twice as long as 1017h.",
     judge_heartbeat_missing},
    {pdo_length, "pdo-length", error, "a PDO has another length than its mapping",
     "A receiver drops a PDO that is too short, with emergency 8210h (CiA 301, 7.2.2); one that "
     "is too long is read as if it were right.",
     "Read 1A00h and those after it of the sender, and compare them with what the receiver has in "
     "1600h and after. Is the data sheet that of this version?",
     "Map the same objects at both ends, and store it (1010h); give canvoy the right sheet.",
     judge_pdo_length},
    {sync_window, "sync-window", error, "synchronous PDOs come behind the window",
     "What comes behind the window (1007h) belongs to no cycle: it may be dropped (CiA 301, "
     "7.5.2.7), and a control loop works with old values.",
     "How long does the node take behind SYNC, and which frames go before it? canvoy stats shows "
     "the load. Compare 1006h, 1007h and the count of synchronous PDOs.",
     "Lengthen 1007h, if the cycle allows; else fewer or later cycles, a higher priority of this "
     "PDO, or a higher bit rate.",
     judge_sync_window},
    {sync_differs, "sync-differs", error, "a device goes by another SYNC",
     "Its synchronous PDOs are never sent, or in another cycle than those of the others.",
     "Compare 1005h and 1006h of all nodes (canvoy doctor --ask reads them) with what is heard.",
     "Write the CAN-ID of SYNC to 1005h, and the period of the producer to 1006h; store it "
     "(1010h).",
     judge_sync_differs},
    {sheet_differs, "sheet-differs", error, "a device is not what its data sheet says",
     "Configuration by this sheet writes what the device does not have, or reads it wrongly.",
     "Which revision is it (1018h:03h, 100Ah), and of which is the sheet? canvoy eds check, and "
     "canvoy eds diff with the right one.",
     "Take the sheet of this revision, or update the device.", judge_sheet_differs},
    {heartbeat_late, "heartbeat-late", warning, "heartbeats come late",
     "A little later, and who watches over the node takes it for lost.",
     "Is the bus busy when they are late (canvoy stats), or the node itself? Compare with 1017h.",
     "Choose 1017h shorter or 1016h longer; keep the node's firmware from waiting.",
     judge_heartbeat_late},
    {heartbeat_jitter, "heartbeat-jitter", warning, "heartbeats are uneven",
     "A timer that others get in the way of will sooner or later be too late.",
     "Is the interface that listens the cause (a USB adapter without time stamps)? Then all nodes "
     "are uneven. Else look at the load, and at what else the node does.",
     "Keep the node's firmware from waiting; a lower load, or a listener with time stamps.",
     judge_heartbeat_jitter},
    {unexpected_boot_up, "unexpected-boot-up", warning, "a node has started by itself",
     "It has lost its state and what was not stored, and waits until somebody starts it.",
     "Is its voltage steady, above all when motors start? Does a watchdog reset it? Read 1003h.",
     "Mend its power; store its configuration (1010h); let the master boot it again.",
     judge_unexpected_boot_up},
    {sdo_time_out, "sdo-time-out", warning, "a node leaves SDO requests without answer",
     "What was to be configured or read is not; a master waits, or takes the node for lost.",
     "Ask it alone: canvoy read BUS NODE 1000. Is it stopped (then it has no SDO), busy, or does "
     "it have its SDO server elsewhere (1200h)?",
     "Bring it into pre-operational; give the client a longer time-out; one client at a time.",
     judge_sdo_time_out},
    {sdo_slow, "sdo-slow", warning, "a node is slow to answer SDO",
     "Clients wait for half a second to some seconds: a slower day, and they give up.",
     "Which object is it? One that is stored may take long, 1000h may not.",
     "Give clients of this node a longer time-out; keep its firmware from waiting.",
     judge_sdo_slow},
    {inhibit_time, "inhibit-time", warning, "a PDO ignores its inhibit time",
     "The inhibit time keeps a PDO from filling the bus: those of lower priority come late "
     "(CiA 301, 7.5.2.37).",
     "Read 1800h:03h (and those after it): it counts 100 us. Was it written while the PDO was "
     "switched on? Some devices then keep the old one.",
     "Switch the PDO off (bit 31 of its COB-ID), write the inhibit time, and switch it on again.",
     judge_inhibit_time},
    {load_peak, "load-peak", warning, "the bus is too busy at times",
     "Frames of low priority wait, heartbeats among them, and synchronous PDOs miss their window.",
     "canvoy stats LOG --bit-rate shows what each CAN-ID takes.",
     "Longer inhibit times and event timers for those that send most; fewer synchronous PDOs; a "
     "higher bit rate.",
     judge_load_peak},
    {emergency_storm, "emergency-storm", warning, "a node sends emergencies without end",
     "They have a high priority, and fill the bus; the one that matters is not seen.",
     "Read 1001h and 1003h of the node; what the code means is above. A contact that bounces "
     "looks so.",
     "Mend what it tells; set its inhibit time for emergencies (1015h).", judge_emergency_storm},
    {reserved_value, "reserved-value", warning, "a value that nobody may send",
     "Who receives it has no rule for it, and may do anything.",
     "canvoy monitor --filter marks shows the frames. Is it the profile of this device, and is the "
     "mapping the one that is known here?",
     "Ask the maker of the device for a correction; say the right profile or sheet.",
     judge_reserved_value},
    {failed_value, "failed-value", warning, "a device says that something is broken",
     "There is no value, and who needs it works with none or with an old one.",
     "Look at the sensor and its cable; read 1001h and 1003h.", "Mend or exchange the sensor.",
     judge_failed_value},
    {against_protocol, "against-protocol", warning, "messages are against the protocol",
     "It may work with this partner, and not with the next one.",
     "canvoy decode LOG --filter marks shows the frames.",
     "Ask the maker of the device for a correction; is there one client at a time?",
     judge_against_protocol},
    {reported_error, "reported-error", warning, "a device reports an error",
     "The device knows what is wrong with it, and may have left its work (CiA 301, 7.2.7).",
     "Read 1001h, and the list of its latest errors, 1003h.",
     "Mend what the code tells; what is beyond the code is in the manual of the device.",
     judge_reported_error},
    {silence, "silence", note, "nobody spoke for a while",
     "A bus may sleep; one that loses its power looks the same.",
     "Was it switched off, or told to sleep?", "Nothing, if it was meant.", judge_silence},
});

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (static_cast<std::size_t>(rows[i].kind) != i) return false;
    if (i != 0 && rows[i].severity > rows[i - 1].severity) return false;
  }
  return true;
}
static_assert(are_in_order(), "a kind is the number of its row, and the worst come first");

}  // namespace finding_table

std::string_view severity_name(Severity severity) {
  constexpr std::array<std::string_view, 3> names = {"note", "warning", "error"};
  return names.at(static_cast<std::size_t>(severity));
}

std::span<const FindingRow> finding_rows() {
  return finding_table::rows;
}

const FindingRow& finding_row(FindingKind kind) {
  return finding_table::rows.at(static_cast<std::size_t>(kind));
}

}  // namespace canvoy::text
