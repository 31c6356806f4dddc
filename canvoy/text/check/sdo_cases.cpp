// SDO by bytes (CiA 301, 7.2.4). The objects are those of every device, and 1017h, which is usually
// writable.
#include <fmt/format.h>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/canopen/sdo/crc16.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/check/sdo_script.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::string_view initiate_download = "CiA 301, 7.2.4.3.3";
constexpr std::string_view download_segment = "CiA 301, 7.2.4.3.4";
constexpr std::string_view initiate_upload = "CiA 301, 7.2.4.3.6";
constexpr std::string_view upload_segment = "CiA 301, 7.2.4.3.7";
constexpr std::string_view block_download = "CiA 301, 7.2.4.3.9";
constexpr std::string_view block_upload = "CiA 301, 7.2.4.3.13";
constexpr std::string_view abort_transfer = "CiA 301, 7.2.4.3.17";

enum class Needs : std::uint8_t {
  nothing,
  writing,   ///< 1017h, that can be written
  segments,  ///< 1008h, of more than four bytes
};

struct ScriptRow {
  std::string_view id;
  std::string_view clause;
  std::string_view title;
  std::string_view script;
  Needs needs = Needs::nothing;
};

constexpr ScriptRow script_rows[] = {
    {"sdo-01", initiate_upload, "four bytes are read in one frame", "40 00 10 00 > 43/42 00 10 00"},
    {"sdo-02", initiate_upload, "one byte is read in one frame", "40 01 10 00 > 4F/42 01 10 00"},
    {"sdo-03", initiate_upload, "an entry of a record is read by its sub-index",
     "40 18 10 01 > 43/42 18 10 01"},
    {"sdo-04", abort_transfer, "an object that is not there is not read",
     "40 FF 0F 00 > 80 FF 0F 00 00 00 02 06"},
    {"sdo-05", abort_transfer, "a sub-index that a record does not have is not read",
     "40 18 10 FE > 80 18 10 FE 11 00 09 06"},
    {"sdo-06", abort_transfer, "a sub-index that a variable does not have is not read",
     "40 00 10 01 > 80 00 10 01 11 00 09 06"},
    {"sdo-07", abort_transfer, "an object that is not there is not written",
     "23 FF 0F 00 > 80 FF 0F 00 00 00 02 06"},
    {"sdo-08", abort_transfer, "a sub-index that is not there is not written",
     "23 18 10 FE > 80 18 10 FE 11 00 09 06"},
    {"sdo-09", abort_transfer, "what is read only is not written",
     "23 00 10 00 > 80 00 10 00 02 00 01 06"},
    {"sdo-10", abort_transfer, "what is read only is not written in segments",
     "21 00 10 00 04 > 80 00 10 00 02 00 01 06"},
    {"sdo-11", abort_transfer, "a command that there is not is refused",
     "E0 00 10 00 > 80 ?? ?? ?? 01 00 04 05"},
    {"sdo-12", upload_segment, "a segment is not read where no transfer is under way",
     "60 > 80 ?? ?? ?? 01 00 04 05"},
    {"sdo-13", download_segment, "a segment is not written where no transfer is under way",
     "00 > 80 ?? ?? ?? 01 00 04 05"},
    {"sdo-14", abort_transfer, "an abort is not answered", "80 00 10 00 00 00 00 08 > nothing"},
    {"sdo-15", initiate_download, "a value is written in one frame, and is there",
     "2B 17 10 00 NL NH > 60 17 10 00; 40 17 10 00 > 4B/42 17 10 00 NL NH", Needs::writing},
    {"sdo-16", initiate_download, "a value is written in one frame without its size",
     "22 17 10 00 VL VH > 60 17 10 00", Needs::writing},
    {"sdo-17", abort_transfer, "a value with too many bytes is refused",
     "23 17 10 00 VL VH > 80 17 10 00 10/12 00 07 06", Needs::writing},
    {"sdo-18", abort_transfer, "a value with too few bytes is refused",
     "2F 17 10 00 VL > 80 17 10 00 10/13 00 07 06", Needs::writing},
    {"sdo-19", download_segment, "a short value is written in a segment, and is there",
     "21 17 10 00 02 > 60 17 10 00; 0B NL NH > 20; 40 17 10 00 > 4B/42 17 10 00 NL NH",
     Needs::writing},
    {"sdo-20", download_segment, "a toggle bit that is wrong ends writing",
     "21 17 10 00 02 > 60 17 10 00; 1B VL VH > 80 17 10 00 00 00 03 05", Needs::writing},
    {"sdo-21", abort_transfer, "an abort by the client ends writing",
     "21 17 10 00 02 > 60 17 10 00; 80 17 10 00 00 00 00 08 > nothing; "
     "0B VL VH > 80 ?? ?? ?? 01 00 04 05",
     Needs::writing},
    {"sdo-22", upload_segment, "a toggle bit that is wrong ends reading",
     "40 08 10 00 > 41/40 08 10 00; 70 > 80 08 10 00 00 00 03 05", Needs::segments},
    {"sdo-23", abort_transfer, "an abort by the client ends reading",
     "40 08 10 00 > 41/40 08 10 00; 80 08 10 00 00 00 00 08 > nothing; "
     "60 > 80 ?? ?? ?? 01 00 04 05",
     Needs::segments},
};

/// The value of 1017h; or the reason why a case with it does not apply.
std::optional<std::uint16_t> writable_value(Bench& bench, std::string& why) {
  const Reply value = bench.read(object_index::heartbeat_producer, 0);
  if (!value || value.value.size() != 2) {
    why = fmt::format("1017h is read as {}", value.text());
    return std::nullopt;
  }
  const auto number = static_cast<std::uint16_t>(value.number());
  const Reply written = bench.set(object_index::heartbeat_producer, 0, number, 2);
  if (written) return number;
  why = fmt::format("1017h is written: {}", written.text());
  return std::nullopt;
}

Verdict judge_row(Bench& bench, const ScriptRow& row) {
  std::uint16_t value = 0;
  if (row.needs == Needs::writing) {
    std::string why;
    const auto own = writable_value(bench, why);
    if (!own) return not_applicable(why);
    value = *own;
  }
  if (row.needs == Needs::segments) {
    const Reply name = bench.read(object_index::device_name, 0);
    if (!name) return not_applicable(fmt::format("1008h is read: {}", name.text()));
    if (name.value.size() <= 4) return not_applicable("1008h has no more than four bytes");
  }
  return judge_script(bench, row.script, value);
}

Verdict judge_segmented_upload(Bench& bench) {
  const auto answer = bench.ask(Bytes{0x40, 0x08, 0x10, 0x00});
  if (!answer) return failed("to 40 08 10 00 came nothing");
  if (answer->data[0] == 0x80) return not_applicable("1008h cannot be read");
  if ((answer->data[0] & 2) != 0) return not_applicable("1008h has no more than four bytes");
  const bool has_size = (answer->data[0] & 1) != 0;
  const auto size = load<std::uint32_t>(&answer->data[4]);
  std::size_t read = 0;
  for (unsigned toggle = 0; read <= 10'000; toggle ^= 0x10) {
    const auto segment = bench.ask(Bytes{static_cast<std::uint8_t>(0x60 | toggle)});
    if (!segment) return failed(fmt::format("no segment behind byte {}", read));
    const unsigned command = segment->data[0];
    if ((command & 0xF0) != toggle) {
      return failed(fmt::format("a segment begins with {:02X}: not with toggle bit {}", command,
                                toggle >> 4));
    }
    read += 7 - (command >> 1 & 7);
    if ((command & 1) == 0) continue;
    if (!has_size || size == read) return passed();
    return failed(fmt::format("{} bytes are announced, and {} come", size, read));
  }
  return failed("the value does not end");
}

bool has_no_blocks(const Frame& answer) {
  return answer.data[0] == 0x80 && load<std::uint32_t>(&answer.data[4]) ==
                                       static_cast<std::uint32_t>(AbortCode::command_specifier);
}

/// 1000h in one block: initiate, start, a segment, its acknowledgement, the end (CiA 301,
/// 7.2.4.3.13 to 7.2.4.3.15).
Verdict judge_block_upload(Bench& bench) {
  const auto begun = bench.ask(Bytes{0xA4, 0x00, 0x10, 0x00, 0x7F, 0x00});
  if (!begun) return failed("to A4 00 10 00 7F came nothing");
  if (has_no_blocks(*begun)) return not_applicable("the device has no block transfer");
  if ((begun->data[0] & 0xF9) != 0xC0) {
    return failed(fmt::format("to A4 00 10 00 7F came {}", text::bytes_text(begun->payload())));
  }
  const auto segment = bench.ask(Bytes{0xA3});
  if (!segment || segment->data[0] != 0x81) return failed("no last segment with number 1 came");
  const auto end = bench.ask(Bytes{0xA2, 0x01, 0x7F});
  if (!end || (end->data[0] & 0xE3) != 0xC1) return failed("the block is not ended by C1h");
  bench.send(Frame::data_frame(can_id::sdo_request + bench.node(), {0xA1, 0, 0, 0, 0, 0, 0, 0}));
  if ((end->data[0] >> 2 & 7) != 3) return failed("four bytes leave three unused in the segment");
  const bool has_crc = (begun->data[0] & 4) != 0;
  const std::uint16_t told = load<std::uint16_t>(&end->data[1]);
  const std::uint16_t crc = crc16(std::span(segment->data).subspan(1, 4));
  if (has_crc && told != crc) {
    return failed(fmt::format("the checksum is {:04X}h in place of {:04X}h", told, crc));
  }
  const Reply plain = bench.read(object_index::device_type, 0);
  return plain && std::equal(plain.value.begin(), plain.value.end(), segment->data.begin() + 1)
             ? passed()
             : failed("the block has another value than the same object read in one frame");
}

Verdict judge_block_size(Bench& bench) {
  const auto answer = bench.ask(Bytes{0xA0, 0x00, 0x10, 0x00, 0x00, 0x00});
  if (!answer) return failed("to A0 00 10 00 00 came nothing");
  if (has_no_blocks(*answer)) return not_applicable("the device has no block transfer");
  if (answer->data[0] == 0x80 && load<std::uint32_t>(&answer->data[4]) == 0x0504'0002) {
    return passed();
  }
  return failed(
      fmt::format("a block of 0 segments is answered {}", text::bytes_text(answer->payload())));
}

/// 1017h in one block, with its present value (CiA 301, 7.2.4.3.9 to 7.2.4.3.11).
Verdict judge_block_download(Bench& bench) {
  std::string why;
  const auto value = writable_value(bench, why);
  if (!value) return not_applicable(why);
  const auto other = static_cast<std::uint16_t>(*value ^ 1U);
  const std::uint8_t bytes[] = {static_cast<std::uint8_t>(other),
                                static_cast<std::uint8_t>(other >> 8)};
  const auto begun = bench.ask(Bytes{0xC6, 0x17, 0x10, 0x00, 0x02});
  if (!begun) return failed("to C6 17 10 00 02 came nothing");
  if (has_no_blocks(*begun)) return not_applicable("the device has no block transfer");
  if ((begun->data[0] & 0xFB) != 0xA0 || begun->data[4] == 0) {
    return failed(fmt::format("to C6 17 10 00 02 came {}", text::bytes_text(begun->payload())));
  }
  const auto taken = bench.ask(Bytes{0x81, bytes[0], bytes[1]});
  if (!taken || taken->data[0] != 0xA2 || taken->data[1] != 1) {
    return failed("the segment is not confirmed by A2 01");
  }
  const std::uint16_t crc = crc16(bytes);
  const auto end =
      bench.ask(Bytes{0xD5, static_cast<std::uint8_t>(crc), static_cast<std::uint8_t>(crc >> 8)});
  if (!end || end->data[0] != 0xA1) return failed("the end is not confirmed by A1");
  return bench.number(object_index::heartbeat_producer, 0) == other
             ? passed()
             : failed("1017h has not the value that was written");
}

/// 1017h in one block, with one wrong bit in the checksum.
Verdict judge_block_checksum(Bench& bench) {
  std::string why;
  const auto value = writable_value(bench, why);
  if (!value) return not_applicable(why);
  const std::uint8_t bytes[] = {static_cast<std::uint8_t>(*value),
                                static_cast<std::uint8_t>(*value >> 8)};
  const auto begun = bench.ask(Bytes{0xC6, 0x17, 0x10, 0x00, 0x02});
  if (!begun) return failed("to C6 17 10 00 02 came nothing");
  if (has_no_blocks(*begun)) return not_applicable("the device has no block transfer");
  bench.ask(Bytes{0x81, bytes[0], bytes[1]});
  const auto crc = static_cast<std::uint16_t>(crc16(bytes) ^ 1U);
  const auto end =
      bench.ask(Bytes{0xD5, static_cast<std::uint8_t>(crc), static_cast<std::uint8_t>(crc >> 8)});
  if ((begun->data[0] & 4) == 0) return not_applicable("the device has no checksums");
  if (end && end->data[0] == 0x80 && load<std::uint32_t>(&end->data[4]) == 0x0504'0004) {
    return passed();
  }
  return failed(fmt::format("a wrong checksum is answered {}",
                            end ? text::bytes_text(end->payload()) : "by nothing"));
}

/// Frames that are no requests.
Verdict judge_silence(Bench& bench, const Frame& frame) {
  bench.drain();
  bench.send(frame);
  const auto came = bench.await(can_id::sdo_response + bench.node(), 100ms);
  if (!came) return passed();
  return failed(fmt::format("{} came", text::bytes_text(came->frame.payload())));
}

Verdict judge_other_node(Bench& bench) {
  const auto next = static_cast<NodeId>(bench.node() == node_id_max ? 1 : bench.node() + 1);
  for (const NodeId other : {next, NodeId{0}}) {
    Verdict verdict = judge_silence(
        bench, Frame::data_frame(can_id::sdo_request + other, {0x40, 0, 0x10, 0, 0, 0, 0, 0}));
    if (verdict.outcome != Outcome::passed) return verdict;
  }
  return passed();
}

Verdict judge_remote(Bench& bench) {
  return judge_silence(bench, Frame::remote_frame(can_id::sdo_request + bench.node(), 8));
}

Verdict judge_one_answer(Bench& bench) {
  if (!bench.ask(Bytes{0x40, 0x00, 0x10, 0x00})) return failed("to 40 00 10 00 came nothing");
  const auto second = bench.await(can_id::sdo_response + bench.node(), 100ms);
  return second ? failed("a second answer came") : passed();
}

constexpr CaseRow sdo_rows[] = {
    {"sdo-24", upload_segment, "a long value is read in segments, in turns with toggle bit 0 and 1",
     "40 08 10 00; 60, 70, 60 ...", "as many bytes as announced, a mark at the last segment",
     judge_segmented_upload},
    {"sdo-25", block_upload, "an object is read in a block", "A4 00 10 00 7F; A3; A2 01 7F; A1",
     "C0 to C6; 81 and the value; C1 or CD with its checksum", judge_block_upload},
    {"sdo-26", block_upload, "a block of no segments is refused", "A0 00 10 00 00",
     "80 with 0504 0002h", judge_block_size},
    {"sdo-27", block_download, "an object is written in a block",
     "C6 17 10 00 02; 81 and the value; D5 with its checksum", "A0 or A4; A2 01; A1",
     judge_block_download},
    {"sdo-28", "CiA 301, 7.2.4.3.16", "a block with a wrong checksum is refused",
     "C6 17 10 00 02; 81 and the value; D5 with a wrong checksum", "80 with 0504 0004h",
     judge_block_checksum},
    {"sdo-29", "CiA 301, 7.3.3", "a request to another node is not answered",
     "40 00 10 00 to the next node-ID, and to 600h", "nothing from this node", judge_other_node},
    {"sdo-30", "CiA 301, 7.2.4.3", "a remote frame is not answered",
     "a remote frame, 600h + node-ID", "nothing", judge_remote},
    {"sdo-31", "CiA 301, 7.2.4.3", "a request has one answer", "40 00 10 00", "one frame",
     judge_one_answer},
};

}  // namespace

void add_sdo_cases(TestCases& cases) {
  for (const ScriptRow& row : script_rows) {
    cases.push_back({std::string(row.id), Group::sdo, std::string(row.clause),
                     std::string(row.title), sent_of(row.script), expected_of(row.script),
                     [&row](Bench& bench) { return judge_row(bench, row); }});
  }
  add_rows(cases, Group::sdo, sdo_rows);
}

}  // namespace canvoy::conformance
