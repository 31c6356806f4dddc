// An NMT master and a configuration manager with a slave that the test plays (CiA 302-2 and 302-3;
// the texts are not available: expected values are those on which public sources agree).
#include <fmt/format.h>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/text/check/bench/case_rows.hpp"
#include "canvoy/text/check/case_lists.hpp"
#include "canvoy/text/check/slave_partner.hpp"
#include "canvoy/text/text.hpp"

namespace canvoy::conformance {

namespace {

constexpr std::uint16_t startup = cia302::nmt_startup_object.index;
constexpr std::uint16_t assignment = cia302::slave_assignment_object.index;
constexpr std::uint16_t request_nmt = cia302::request_nmt_object.index;
constexpr std::uint16_t expected_type = cia302::expected_device_type_object.index;
constexpr std::uint16_t expected_vendor = cia302::expected_vendor_object.index;
constexpr std::uint16_t concise_dcf = cia302::concise_dcf_object.index;
constexpr std::uint16_t configure = cia302::configure_object.index;

constexpr std::uint32_t is_master = 0x01;  ///< 1F80h
constexpr std::uint32_t does_not_start_slaves = 0x08;
constexpr std::uint32_t booted_slave = 0x05;           ///< 1F81h: a slave that is booted
constexpr std::uint32_t conf_signature = 0x666E'6F63;  ///< "conf"
/// Time for a master; no clause gives one.
constexpr Duration start_max = 5s;
constexpr Duration long_enough = 2s;

/// Reason why no case applies.
std::optional<Verdict> cannot_boot(Bench& bench) {
  const auto is = bench.number(startup, 0);
  if (!is) return not_applicable("the device has no 1F80h");
  if ((*is & is_master) == 0) return not_applicable("1F80h says that it is no NMT master");
  if (!bench.has(assignment, played_node(bench))) {
    return not_applicable(
        fmt::format("the device has no {}", text::object_text(assignment, played_node(bench))));
  }
  return std::nullopt;
}

/// Values of the master with which the slave boots; `value` of an object is for the slave.
struct Given {
  std::uint16_t index;
  std::uint32_t value;
};
std::optional<Verdict> give(Bench& bench, const SlavePartner& slave,
                            std::initializer_list<Given> values) {
  for (const Given& each : values) {
    const std::uint8_t sub = each.index == startup ? std::uint8_t{0} : slave.node();
    const Reply done = bench.set(each.index, sub, each.value, 4);
    if (!done) return cannot_set(text::object_text(each.index, sub), done);
  }
  return std::nullopt;
}

Verdict judge_boots(Bench& bench) {
  if (const auto cannot = cannot_boot(bench)) return *cannot;
  SlavePartner slave(bench);
  if (const auto cannot = give(bench, slave, {{assignment, booted_slave}})) return *cannot;
  slave.boot_up();
  const bool is_started = slave.wait_for(NmtCommand::start, start_max);
  if (!slave.was_identified()) return failed("its 1000h is not read");
  return is_started ? passed() : failed("it is not started within 5 s");
}

/// A slave that boots with these values is not started.
Verdict judge_not_started(Bench& bench, std::initializer_list<Given> values) {
  if (const auto cannot = cannot_boot(bench)) return *cannot;
  SlavePartner slave(bench);
  if (const auto cannot = give(bench, slave, values)) return *cannot;
  slave.boot_up();
  if (!slave.wait_for(NmtCommand::start, long_enough)) return passed();
  return failed("it is started");
}
Verdict judge_stranger(Bench& bench) {
  return judge_not_started(bench, {{assignment, 0}});
}
Verdict judge_other_type(Bench& bench) {
  return judge_not_started(
      bench, {{expected_type, SlavePartner::device_type + 1}, {assignment, booted_slave}});
}
Verdict judge_other_vendor(Bench& bench) {
  return judge_not_started(
      bench, {{expected_vendor, SlavePartner::vendor + 1}, {assignment, booted_slave}});
}
Verdict judge_does_not_start(Bench& bench) {
  const std::uint32_t is = bench.number(startup, 0).value_or(0);
  return judge_not_started(bench,
                           {{startup, is | does_not_start_slaves}, {assignment, booted_slave}});
}

Verdict judge_requests(Bench& bench) {
  if (const auto cannot = cannot_boot(bench)) return *cannot;
  struct Request {
    std::uint8_t written;
    NmtCommand command;
  };
  constexpr Request requests[] = {{5, NmtCommand::start},
                                  {4, NmtCommand::stop},
                                  {127, NmtCommand::enter_pre_operational},
                                  {6, NmtCommand::reset_node},
                                  {7, NmtCommand::reset_communication}};
  for (const Request& each : requests) {
    SlavePartner slave(bench);
    const std::string place = text::object_text(request_nmt, slave.node());
    const Reply done = bench.write(request_nmt, slave.node(), each.written, 1);
    if (!done) return cannot_set(place, done);
    if (slave.wait_for(each.command, long_enough)) continue;
    return failed(fmt::format("{} = {}: NMT {:02X}h does not come", place, each.written,
                              static_cast<unsigned>(each.command)));
  }
  return passed();
}

/// 1F22h for a slave: a heartbeat every 500 ms (1017h).
constexpr std::uint8_t one_entry[] = {1, 0, 0, 0, 0x17, 0x10, 0, 2, 0, 0, 0, 0xF4, 0x01};
constexpr std::uint8_t no_entry[] = {0, 0, 0, 0};
const SlavePartner::Written heartbeat_of_500_ms = {0x1017, 0, {0xF4, 0x01}};

/// Sets the entry of 1F22h for the slave during its lifetime.
class StoredDcf {
 public:
  StoredDcf(Bench& bench, NodeId slave) : bench_(bench), slave_(slave) {
    const Reply done = bench.write(concise_dcf, slave, one_entry);
    if (!done) cannot_ = cannot_set(text::object_text(concise_dcf, slave), done);
  }
  ~StoredDcf() {
    if (!cannot_) bench_.write(concise_dcf, slave_, no_entry);
  }
  StoredDcf(const StoredDcf&) = delete;
  StoredDcf& operator=(const StoredDcf&) = delete;

  const std::optional<Verdict>& cannot() const { return cannot_; }

 private:
  Bench& bench_;
  NodeId slave_;
  std::optional<Verdict> cannot_;
};

bool has_dcf(Bench& bench) {
  return bench.has(concise_dcf, 0) && bench.has(configure, 0);
}
bool is_configured(const SlavePartner& slave) {
  return slave.written().size() == 1 && slave.written().front() == heartbeat_of_500_ms;
}

Verdict judge_configures(Bench& bench) {
  if (!has_dcf(bench)) return not_applicable("the device has no 1F22h and 1F25h");
  SlavePartner slave(bench);
  const StoredDcf dcf(bench, slave.node());
  if (dcf.cannot()) return *dcf.cannot();
  const Reply done = bench.write(configure, slave.node(), conf_signature, 4);
  if (!done) return failed(fmt::format("1F25h = 666E 6F63h: {}", done.text()));
  bench.listen(long_enough);
  if (is_configured(slave)) return passed();
  return failed(fmt::format("{} entries are written to the slave in place of 1017h = 500",
                            slave.written().size()));
}

Verdict judge_other_signature(Bench& bench) {
  if (!has_dcf(bench)) return not_applicable("the device has no 1F22h and 1F25h");
  SlavePartner slave(bench);
  const StoredDcf dcf(bench, slave.node());
  if (dcf.cannot()) return *dcf.cannot();
  const Reply done = bench.write(configure, slave.node(), save_signature, 4);
  bench.listen(long_enough);
  if (!slave.written().empty()) return failed("the slave is configured");
  return refusal(done, "1F25h takes another signature");
}

Verdict judge_configures_at_boot(Bench& bench) {
  if (const auto cannot = cannot_boot(bench)) return *cannot;
  if (!has_dcf(bench)) return not_applicable("the device has no 1F22h and 1F25h");
  SlavePartner slave(bench);
  const StoredDcf dcf(bench, slave.node());
  if (dcf.cannot()) return *dcf.cannot();
  if (const auto cannot = give(bench, slave, {{assignment, booted_slave}})) return *cannot;
  slave.boot_up();
  if (!slave.wait_for(NmtCommand::start, start_max)) return failed("it is not started within 5 s");
  return is_configured(slave) ? passed() : failed("it is started without its configuration");
}

constexpr std::string_view slave_boots = "1F81h = 05h of the slave; its boot-up message";
constexpr CaseRow master_rows[] = {
    {"302-boot-01", "CiA 302-2, 1F81h", "a slave that boots is asked what it is, and started",
     slave_boots, "an upload of its 1000h; NMT 01h", judge_boots},
    {"302-boot-02", "CiA 302-2, 1F81h", "a node that is no slave is not started",
     "1F81h = 00h of the node; its boot-up message", "no NMT 01h", judge_stranger},
    {"302-boot-03", "CiA 302-2, 1F84h", "a slave of another device type is not started",
     "1F84h is not its 1000h; its boot-up message", "no NMT 01h", judge_other_type},
    {"302-boot-04", "CiA 302-2, 1F85h", "a slave of another vendor is not started",
     "1F85h is not its 1018h:01h; its boot-up message", "no NMT 01h", judge_other_vendor},
    {"302-boot-05", "CiA 302-2, 1F80h", "with bit 3 of 1F80h slaves are not started",
     "1F80h, bit 3; the boot-up message of a slave", "no NMT 01h", judge_does_not_start},
    {"302-request-01", "CiA 302-2, 1F82h", "NMT commands are sent on request",
     "1F82h = 5, 4, 127, 6, 7 of the slave", "NMT 01h, 02h, 80h, 81h, 82h", judge_requests},
    {"302-configure-01", "CiA 302-3, 1F22h", "a slave is configured by its concise DCF",
     "1F22h with 1017h = 500; 1F25h = 666E 6F63h", "a download of 1017h", judge_configures},
    {"302-configure-02", "CiA 302-3, 1F25h", "without its signature no slave is configured",
     "1F22h with 1017h = 500; 1F25h = 6576 6173h", "an abort; no download", judge_other_signature},
    {"302-configure-03", "CiA 302-3, 1F22h", "a slave is configured before it is started",
     "1F22h with 1017h = 500; 1F81h = 05h; its boot-up message", "a download of 1017h; NMT 01h",
     judge_configures_at_boot},
};

}  // namespace

void add_master_cases(TestCases& cases) {
  add_rows(cases, Group::manager, master_rows);
}

}  // namespace canvoy::conformance
