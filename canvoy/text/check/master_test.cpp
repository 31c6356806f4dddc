// An NMT master and configuration manager of this project passes, and one with a defect is found by
// the cases that concern it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/manager/master_node.hpp"
#include "canvoy/profiles/cia301.hpp"
#include "canvoy/profiles/cia302.hpp"
#include "canvoy/profiles/model/layout.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"

namespace canvoy::conformance::master_test {
namespace {

constexpr auto master_device =
    describe(cia301::device_type(0), cia301::error_register_object, cia301::identity({}),
             cia301::heartbeat_consumers(1), cia301::heartbeat_producer(0),
             cia301::error_behavior(), cia302::nmt_master(), cia302::configuration());
constexpr auto master_layout = lay_out_device<master_device>();

/// 1F22h of the one slave, as a tool stores it.
class StoredDcf {
 public:
  explicit StoredDcf(Node& node) {
    domain_.open_read = decltype(Domain::open_read)::to<&StoredDcf::open_read>(*this);
    domain_.read = decltype(Domain::read)::to<&StoredDcf::read>(*this);
    domain_.open_write = decltype(Domain::open_write)::to<&StoredDcf::open_write>(*this);
    domain_.write = decltype(Domain::write)::to<&StoredDcf::write>(*this);
    domain_.close_write = decltype(Domain::close_write)::to<&StoredDcf::close_write>(*this);
    hook_.first = hook_.last = 0x1F22;
    hook_.domain = &domain_;
    node.dictionary().attach(hook_);
  }

 private:
  using Bytes = std::vector<std::uint8_t>;

  Result<std::uint32_t> open_read(const Entry& /*entry*/) {
    if (content_.empty()) return AbortCode::no_data;
    return static_cast<std::uint32_t>(content_.size());
  }
  Result<std::size_t> read(const Entry& /*entry*/, std::uint32_t offset,
                           std::span<std::uint8_t> bytes) {
    std::ranges::copy(std::span(content_).subspan(offset, bytes.size()), bytes.begin());
    return bytes.size();
  }
  AbortCode open_write(const Entry& /*entry*/, std::uint32_t /*size*/) {
    arriving_.clear();
    return AbortCode::none;
  }
  AbortCode write(const Entry& /*entry*/, std::span<const std::uint8_t> bytes) {
    arriving_.insert(arriving_.end(), bytes.begin(), bytes.end());
    return AbortCode::none;
  }
  AbortCode close_write(const Entry& /*entry*/, bool complete) {
    if (complete) content_ = arriving_;
    return AbortCode::none;
  }

  Bytes content_;
  Bytes arriving_;
  Domain domain_;
  Hook hook_;
};

struct MasterOnBench {
  MasterOnBench() {
    BootHooks hooks;
    configurations.serve(hooks);
    master.boot_manager().use(hooks);
    on_line.start(master.node());
  }
  Report check() {
    Check check(on_line.line(), 1, {});
    return check.run({}, "302-");
  }

  NodeOnLine on_line;
  MasterNode<master_layout, MasterSize{.slots = 2, .own_routes = 2}> master{on_line.port(), 1};
  ConfigurationManager::Worker workers[2] = {ConfigurationManager::Worker(master.node()),
                                             ConfigurationManager::Worker(master.node())};
  ConfigurationManager configurations{master.node(), workers};
  StoredDcf stored{master.node()};
};

TEST(Master, OfOursPasses) {
  MasterOnBench sut;
  const Report report = sut.check();
  ASSERT_TRUE(report.is_whole);
  EXPECT_THAT(failures(report), ::testing::IsEmpty());
  for (const TestResult& each : report.results) {
    const bool is_flow = each.test->id.find("-0") != std::string::npos;
    if (!is_flow || each.test->id.starts_with("302-program")) continue;
    EXPECT_EQ(each.verdict.outcome, Outcome::passed) << each.test->id << ": " << each.verdict.why;
  }
  EXPECT_THAT(report.notes, ::testing::IsEmpty());
  EXPECT_EQ(sut.master.dictionary().number(0x1F81, 127), 0U) << "as it was";
}

constexpr std::uint32_t to_slave = 0x67F;
Way with_value_0(std::string_view name, std::string_view found_by, std::uint16_t index) {
  return {name, {found_by}, {}, [index](Middle& middle, Frame& frame) {
            if (is_download(middle, frame, index)) store(&frame.data[4], std::uint32_t{0});
            return true;
          }};
}

std::vector<Way> master_ways() {
  return {
      from_device(
          "it asks no slave what it is", {"302-boot-01", "302-configure-03"},
          [](Middle&, Frame& frame) { return frame.id != to_slave || frame.data[0] != 0x40; }),
      to_device("it starts nodes that are no slaves", {"302-boot-02"},
                [](Middle& middle, Frame& frame) {
                  if (is_download(middle, frame, 0x1F81)) middle.count = frame.data[4];
                  if (frame.id == 0x77F && middle.count == 0) middle.add(can_id::nmt, {0x01, 127});
                  return true;
                }),
      with_value_0("it starts a slave of any device type", "302-boot-03", 0x1F84),
      with_value_0("it starts a slave of any vendor", "302-boot-04", 0x1F85),
      to_device("it starts slaves whatever bit 3 says", {"302-boot-05"},
                [](Middle& middle, Frame& frame) {
                  if (is_download(middle, frame, 0x1F80)) frame.data[4] &= 0xF7;
                  return true;
                }),
      from_device("it resets the communication of a slave in place of the slave",
                  {"302-request-01"},
                  [](Middle&, Frame& frame) {
                    if (frame.id == can_id::nmt && frame.data[0] == 0x81) frame.data[0] = 0x82;
                    return true;
                  }),
      to_device("it says that it configures, and does not", {"302-configure-01"},
                [](Middle& middle, Frame& frame) {
                  if (!is_download(middle, frame, 0x1F25) || frame.data[4] != 'c') return true;
                  middle.add(middle.answers(), {0x60, 0x25, 0x1F, 127, 0, 0, 0, 0});
                  return false;
                }),
      to_device("it takes any signature", {"302-configure-02"},
                [](Middle& middle, Frame& frame) {
                  if (is_download(middle, frame, 0x1F25))
                    store(&frame.data[4], std::uint32_t{0x666E'6F63});
                  return true;
                }),
      from_device("what it writes to a slave is lost", {"302-configure-01", "302-configure-03"},
                  [](Middle&, Frame& frame) {
                    return frame.id != to_slave || (frame.data[0] & 0xE0) != 0x20;
                  }),
  };
}

TEST(Master, ThatIsBrokenIsFound) {
  for (const Way& way : master_ways()) {
    MasterOnBench sut;
    Middle middle(sut.on_line);
    apply(sut.on_line, middle, way);
    EXPECT_THAT(failures(sut.check()), ::testing::UnorderedElementsAreArray(way.found_by))
        << way.name;
  }
}

}  // namespace
}  // namespace canvoy::conformance::master_test

namespace canvoy::conformance {

std::vector<Way> master_ways() {
  return master_test::master_ways();
}

}  // namespace canvoy::conformance
