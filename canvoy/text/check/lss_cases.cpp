// LSS (CiA 305) of a device that answers to its LSS address: the four entries of 1018h. Only this
// device is switched to configuration; afterwards all are switched to waiting, their initial state.
// Commands that would change the node-ID or the bit rate are not sent.
#include <fmt/format.h>

#include <array>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/canopen/lss/lss.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/formats/eds/data_sheet.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

using lss::Command;

constexpr Duration lss_answer_max = 1s;
/// Time after which no answer comes.
constexpr Duration lss_silence = 200ms;

void tell_lss(Bench& bench, Command command, std::array<std::uint8_t, 7> data = {}) {
  std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(command)};
  std::copy(data.begin(), data.end(), bytes.begin() + 1);
  bench.send(Frame::data_frame(can_id::lss_request, bytes));
}

void tell_lss(Bench& bench, Command command, std::uint32_t number) {
  std::array<std::uint8_t, 7> data{};
  store(data.data(), number);
  tell_lss(bench, command, data);
}

/// The next answer with this command specifier.
std::optional<Frame> lss_answer(Bench& bench, Command command, Duration wait = lss_answer_max) {
  const Time until = bench.now() + wait;
  while (!bench.is_broken()) {
    const auto came = bench.await(can_id::lss_response, until - bench.now());
    if (!came) return std::nullopt;
    if (came->frame.is_plain() && came->frame.length == 8 &&
        came->frame.data[0] == static_cast<std::uint8_t>(command)) {
      return came->frame;
    }
  }
  return std::nullopt;
}

/// 1018h:01h to 04h; nothing if one is missing.
std::optional<std::array<std::uint32_t, 4>> lss_address(Bench& bench) {
  std::array<std::uint32_t, 4> address{};
  for (std::size_t i = 0; i < address.size(); ++i) {
    const auto part = bench.number(object_index::identity, static_cast<std::uint8_t>(i + 1));
    if (!part) return std::nullopt;
    address[i] = *part;
  }
  return address;
}

/// Switches the device with this address to configuration; true if it confirms.
bool select_by(Bench& bench, const std::array<std::uint32_t, 4>& address,
               Duration wait = lss_answer_max) {
  bench.drain();
  auto command = static_cast<std::uint8_t>(Command::select_vendor);
  for (const std::uint32_t part : address) tell_lss(bench, static_cast<Command>(command++), part);
  return lss_answer(bench, Command::selected, wait).has_value();
}

/// True if the data sheet gives LSS support.
bool claims_lss(const Bench& bench) {
  const formats::DataSheet* const sheet = bench.options().sheet;
  return sheet != nullptr && sheet->text("DeviceInfo", "LSS_Supported") == "1";
}

/// Keeps the device in configuration during its lifetime, then switches all to waiting.
class LssSession {
 public:
  explicit LssSession(Bench& bench) : bench_(bench) {
    const auto found = lss_address(bench);
    if (!found) {
      cannot_ = not_applicable("1018h has not all four entries");
      return;
    }
    address = *found;
    if (select_by(bench, address)) return;
    cannot_ = not_applicable("it does not answer to its LSS address");
  }
  ~LssSession() { tell_lss(bench_, Command::switch_global); }
  LssSession(const LssSession&) = delete;
  LssSession& operator=(const LssSession&) = delete;

  /// Reason if there is none.
  const std::optional<Verdict>& cannot() const { return cannot_; }

  std::array<std::uint32_t, 4> address{};  ///< of the device

 private:
  Bench& bench_;
  std::optional<Verdict> cannot_;
};

/// This case judges whether the device answers.
Verdict judge_selected(Bench& bench) {
  const LssSession session(bench);
  if (session.cannot() && claims_lss(bench)) {
    return failed(
        fmt::format("the data sheet says that it answers LSS: {}", session.cannot()->why));
  }
  return session.cannot().value_or(passed());
}

/// One more in each part, in sequence.
Verdict judge_other_address(Bench& bench) {
  std::array<std::uint32_t, 4> address{};
  {
    const LssSession session(bench);
    if (session.cannot()) return *session.cannot();
    address = session.address;
  }
  for (std::uint32_t& part : address) {
    ++part;
    if (select_by(bench, address, lss_silence)) {
      tell_lss(bench, Command::switch_global);
      return failed("it answers to another address");
    }
    --part;
  }
  return passed();
}

Verdict judge_inquired(Bench& bench, Command command, std::size_t part) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  tell_lss(bench, command);
  const auto answer = lss_answer(bench, command);
  if (!answer) return failed("no answer");
  const auto came = load<std::uint32_t>(&answer->data[1]);
  if (came == session.address[part]) return passed();
  return failed(
      fmt::format("{:08X}h, and 1018h:{:02X}h is {:08X}h", came, part + 1, session.address[part]));
}
Verdict judge_vendor(Bench& bench) {
  return judge_inquired(bench, Command::inquire_vendor, 0);
}
Verdict judge_product(Bench& bench) {
  return judge_inquired(bench, Command::inquire_product, 1);
}
Verdict judge_revision(Bench& bench) {
  return judge_inquired(bench, Command::inquire_revision, 2);
}
Verdict judge_serial(Bench& bench) {
  return judge_inquired(bench, Command::inquire_serial, 3);
}

Verdict judge_node_id(Bench& bench) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  tell_lss(bench, Command::inquire_node_id);
  const auto answer = lss_answer(bench, Command::inquire_node_id);
  if (!answer) return failed("no answer");
  return answer->data[1] == bench.node() ? passed()
                                         : failed(fmt::format("node-ID {}", answer->data[1]));
}

/// Error code 1 of `configure`, and the same node-ID as before.
Verdict judge_refused(Bench& bench, Command command, std::array<std::uint8_t, 7> data) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  tell_lss(bench, command, data);
  const auto answer = lss_answer(bench, command);
  if (!answer) return failed("no answer");
  if (answer->data[1] == LssError::none) return failed("it is taken");
  tell_lss(bench, Command::inquire_node_id);
  const auto now = lss_answer(bench, Command::inquire_node_id);
  return now && now->data[1] == bench.node() ? passed() : failed("its node-ID is another one now");
}
Verdict judge_node_id_128(Bench& bench) {
  return judge_refused(bench, Command::configure_node_id, {128});
}
Verdict judge_node_id_0(Bench& bench) {
  return judge_refused(bench, Command::configure_node_id, {0});
}
Verdict judge_bit_rate(Bench& bench) {
  return judge_refused(bench, Command::configure_bit_timing, {0, lss_bit_timing::reserved});
}

Verdict judge_own_node_id(Bench& bench) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  tell_lss(bench, Command::configure_node_id, std::uint32_t{bench.node()});
  const auto answer = lss_answer(bench, Command::configure_node_id);
  if (!answer) return failed("no answer");
  return answer->data[1] == LssError::none ? passed()
                                           : failed(fmt::format("error {}", answer->data[1]));
}

/// No answer in configuration, or in waiting.
Verdict judge_unanswered(Bench& bench, bool in_configuration, const Frame& frame) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  if (!in_configuration) tell_lss(bench, Command::switch_global);
  bench.listen(lss_silence);
  bench.send(frame);
  const auto came = bench.await(can_id::lss_response, lss_silence);
  if (!came) return passed();
  return failed(fmt::format("{} comes", text::bytes_text(came->frame.payload())));
}
Verdict judge_waiting(Bench& bench) {
  return judge_unanswered(bench, false,
                          Frame::data_frame(can_id::lss_request, {0x5E, 0, 0, 0, 0, 0, 0, 0}));
}
Verdict judge_short(Bench& bench) {
  return judge_unanswered(bench, true,
                          Frame::data_frame(can_id::lss_request, {0x5E, 0, 0, 0, 0, 0, 0}));
}
Verdict judge_unknown(Bench& bench) {
  return judge_unanswered(bench, true,
                          Frame::data_frame(can_id::lss_request, {0x7F, 0, 0, 0, 0, 0, 0, 0}));
}
Verdict judge_unconfigured(Bench& bench) {
  return judge_unanswered(bench, false,
                          Frame::data_frame(can_id::lss_request, {0x4C, 0, 0, 0, 0, 0, 0, 0}));
}
Verdict judge_fastscan(Bench& bench) {
  return judge_unanswered(bench, false,
                          Frame::data_frame(can_id::lss_request, {0x51, 0, 0, 0, 0, 0x80, 0, 0}));
}

/// The six frames of `identify remote slaves`, with ranges that include the device, or do not.
Verdict judge_identified(Bench& bench, std::uint32_t off, bool is_wanted) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  tell_lss(bench, Command::switch_global);
  bench.listen(lss_silence);
  const auto& [vendor, product, revision, serial] = session.address;
  tell_lss(bench, Command::identify_vendor, vendor);
  tell_lss(bench, Command::identify_product, product);
  tell_lss(bench, Command::identify_revision_low, revision);
  tell_lss(bench, Command::identify_revision_high, revision);
  tell_lss(bench, Command::identify_serial_low, serial + off);
  tell_lss(bench, Command::identify_serial_high, serial + off);
  const bool came =
      lss_answer(bench, Command::identified, is_wanted ? lss_answer_max : lss_silence).has_value();
  if (came == is_wanted) return passed();
  return failed(came ? "it answers to other serial numbers" : "no answer");
}
Verdict judge_identified_itself(Bench& bench) {
  return judge_identified(bench, 0, true);
}
Verdict judge_identified_other(Bench& bench) {
  return judge_identified(bench, 1, false);
}

Verdict judge_sdo_in_configuration(Bench& bench) {
  const LssSession session(bench);
  if (session.cannot()) return *session.cannot();
  return bench.has_services_by_sdo() ? passed() : failed("SDO is not served");
}

Verdict judge_lss_in_stopped(Bench& bench) {
  const auto address = lss_address(bench);
  if (const LssSession session(bench); session.cannot()) return *session.cannot();
  bench.listen(lss_silence);
  bench.command(NmtCommand::stop);
  bench.listen(20ms);
  const bool came = address && select_by(bench, *address);
  tell_lss(bench, Command::switch_global);
  return came ? passed() : failed("no answer in stopped");
}

constexpr std::string_view to_itself = "40h to 43h with 1018h";
constexpr CaseRow lss_rows[] = {
    {"lss-01", "CiA 305, switch state selective", "it answers to its LSS address", to_itself, "44h",
     judge_selected},
    {"lss-02", "CiA 305, switch state selective", "it does not answer to another LSS address",
     "40h to 43h, one part one more", "none", judge_other_address},
    {"lss-03", "CiA 305, inquire identity vendor-ID", "it tells its vendor-ID", "5Ah", "1018h:01h",
     judge_vendor},
    {"lss-04", "CiA 305, inquire identity product code", "it tells its product code", "5Bh",
     "1018h:02h", judge_product},
    {"lss-05", "CiA 305, inquire identity revision number", "it tells its revision number", "5Ch",
     "1018h:03h", judge_revision},
    {"lss-06", "CiA 305, inquire identity serial number", "it tells its serial number", "5Dh",
     "1018h:04h", judge_serial},
    {"lss-07", "CiA 305, inquire node-ID", "it tells its node-ID", "5Eh", "the node-ID",
     judge_node_id},
    {"lss-08", "CiA 305, configure node-ID", "node-ID 128 is refused", "11h 80h",
     "an error code; the same node-ID", judge_node_id_128},
    {"lss-09", "CiA 305, configure node-ID", "node-ID 0 is refused", "11h 00h",
     "an error code; the same node-ID", judge_node_id_0},
    {"lss-10", "CiA 305, configure node-ID", "its own node-ID is taken", "11h with the node-ID",
     "error code 0", judge_own_node_id},
    {"lss-11", "CiA 305, configure bit timing", "a reserved bit timing is refused", "13h 00h 05h",
     "an error code", judge_bit_rate},
    {"lss-12", "CiA 305, switch state global", "in waiting it answers no inquiry", "04h 00h; 5Eh",
     "none", judge_waiting},
    {"lss-13", "CiA 305, protocols", "a message that is too short is not answered",
     "5Eh in seven bytes", "none", judge_short},
    {"lss-14", "CiA 305, protocols", "a command that there is not is not answered", "7Fh", "none",
     judge_unknown},
    {"lss-15", "CiA 305, identify non-configured remote slave",
     "a configured device is none that is not configured", "4Ch", "none", judge_unconfigured},
    {"lss-16", "CiA 305, fastscan", "a configured device takes no part in fastscan", "51h 80h",
     "none", judge_fastscan},
    {"lss-17", "CiA 305, identify remote slave", "it is found by its address",
     "46h to 4Bh, with 1018h", "4Fh", judge_identified_itself},
    {"lss-18", "CiA 305, identify remote slave", "it is not found by another serial number",
     "46h to 4Bh, the serial number one more", "none", judge_identified_other},
    {"lss-19", "CiA 305, state machine", "SDO is served in configuration", "40h to 43h; an upload",
     "an answer", judge_sdo_in_configuration},
    {"lss-20", "CiA 305, state machine", "LSS is served in stopped", "NMT 02h; 40h to 43h", "44h",
     judge_lss_in_stopped},
};

}  // namespace

void add_lss_cases(TestCases& cases) {
  add_rows(cases, Group::lss, lss_rows);
}

}  // namespace canvoy::conformance
