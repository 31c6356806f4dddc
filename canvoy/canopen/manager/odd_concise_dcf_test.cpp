// Concise DCFs (CiA 302-3: 1F22h) that the configuration manager in node 1 cannot read.
#include <gtest/gtest.h>

#include <algorithm>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/configuration_manager.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/concise_dcf_bytes.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::odd_concise_dcf_test {
namespace {

constexpr auto layout = lay_out(
    std::to_array<ObjectRow>(
        {{.index = 0x1F22, .entry_count = 2}, {.index = 0x1F25, .entry_count = 2}}),
    std::to_array<EntryRow>(
        {{.access = Access::const_, .initial = 127},
         {.sub_first = 1, .sub_last = 127, .type = DataType::domain, .access = Access::rw},
         {.access = Access::const_, .initial = 128},
         {.sub_first = 1, .sub_last = 128, .type = DataType::unsigned32, .access = Access::wo}}));

const std::vector<std::uint8_t> for_6 = concise_dcf({{0x2000, 3, {0x08}}});

using Kind = ConfigurationOutcome::Kind;

/// A concise DCF that is not as it should be, from the second time on that it is opened.
struct OddDcf : WireNode {
  OddDcf() : WireNode(layout.tables(), 1) {
    domain.open_read = decltype(Domain::open_read)::to<&OddDcf::open>(*this);
    domain.read = decltype(Domain::read)::to<&OddDcf::read>(*this);
    hook.first = hook.last = 0x1F22;
    hook.domain = &domain;
    node.dictionary().attach(hook);
    sut.on_done(ConfigurationManager::Done::to<&OddDcf::done>(*this));
    boot();
  }
  Result<std::uint32_t> open(const Entry&) { return opened++ == 0 ? size : size_later; }
  Result<std::size_t> read(const Entry&, std::uint32_t offset, std::span<std::uint8_t> bytes) {
    if (fails) return AbortCode::hardware;
    std::copy_n(for_6.begin() + offset, bytes.size(), bytes.begin());
    return bytes.size() - (is_short ? 1 : 0);
  }
  void done(NodeId, const ConfigurationOutcome& result) { outcome = result; }
  ConfigurationOutcome update() {
    EXPECT_EQ(sut.update(6), AbortCode::none);
    settle();
    expect({});
    return outcome;
  }

  SdoServer server{node, 0, {}};
  Domain domain;
  Hook hook;
  ConfigurationManager::Worker workers[1] = {ConfigurationManager::Worker(node)};
  ConfigurationManager sut{node, workers, 500ms};
  ConfigurationOutcome outcome;
  Result<std::uint32_t> size = static_cast<std::uint32_t>(for_6.size());
  Result<std::uint32_t> size_later = size;
  int opened = 0;
  bool fails = false;
  bool is_short = false;
};

TEST(OddConciseDcf, HasFailedWhereItCannotBeRead) {
  OddDcf unopened;
  unopened.size = AbortCode::hardware;
  EXPECT_EQ(unopened.update().end.abort(), AbortCode::hardware);
  OddDcf later;
  later.size_later = AbortCode::hardware;
  EXPECT_EQ(later.update().end.abort(), AbortCode::hardware);
  OddDcf unreadable;
  unreadable.fails = true;
  EXPECT_EQ(unreadable.update().end.abort(), AbortCode::hardware);
  OddDcf cut;
  cut.is_short = true;
  EXPECT_EQ(cut.update().end.abort(), AbortCode::length_too_low);
  OddDcf endless;
  endless.size = Domain::size_unknown;
  EXPECT_EQ(endless.update().end.abort(), AbortCode::internal_incompatible);
  for (const OddDcf* each : {&unopened, &later, &unreadable, &cut, &endless}) {
    EXPECT_EQ(each->outcome.kind, Kind::failed);
  }
}

TEST(OddConciseDcf, IsNoneWithoutContent) {
  OddDcf empty;
  empty.size = std::uint32_t{0};
  EXPECT_EQ(empty.update().kind, Kind::nothing_known);
  OddDcf unopenable;
  unopenable.domain.open_read = {};
  EXPECT_EQ(unopenable.update().kind, Kind::nothing_known);
  OddDcf unreadable;
  unreadable.domain.read = {};
  EXPECT_EQ(unreadable.update().kind, Kind::nothing_known);
  OddDcf nothing;
  nothing.hook.domain = nullptr;
  EXPECT_EQ(nothing.update().kind, Kind::nothing_known);
  // 1F25h: there is nothing to be configured.
  empty.opened = 0;
  for (OddDcf* each : {&empty, &nothing}) {
    each->receive("601#23 25 1F 06 63 6F 6E 66");
    each->expect({"581#80 25 1F 06 24 00 00 08"});
  }
}

}  // namespace
}  // namespace canvoy::odd_concise_dcf_test
