// Code that takes or supplies the data of a transfer may end that transfer: by cancelling it, or by
// stopping its node. Then it has ended, once, and stays so (CiA 301, 7.2.4).
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/sdo/sdo_queue.hpp"
#include "canvoy/canopen/testing/sdo_client_node.hpp"
#include "canvoy/canopen/testing/sdo_server_node.hpp"

namespace canvoy::sdo_own_end_test {
namespace {

enum class End { cancelled, stopped };

/// A client with a sink and a supply that end the transfer, and then report success, or failure.
class SdoClientOwnEnd : public SdoClientNode {
 protected:
  AbortCode take(std::span<const std::uint8_t>) {
    bring_about();
    return answered;
  }
  Result<std::size_t> give(std::span<std::uint8_t> piece) {
    bring_about();
    if (answered != AbortCode::none) return answered;
    return piece.size();
  }
  void bring_about() {
    if (end == End::cancelled) return sut.cancel();
    wire.node.receive(wire_frame("000#02 01"), wire.now);
  }

  void upload_until(SdoTransfer transfer, const std::vector<std::string>& answers) {
    in_each_way([&] {
      sut.choose(transfer);
      const auto sink = SdoClient::Sink::to<&SdoClientOwnEnd::take>(*this);
      EXPECT_EQ(sut.upload(5, 0x2008, 0, sink, on_done), AbortCode::none);
      expect_end_after(answers);
    });
  }
  void download_until(SdoTransfer transfer, const std::vector<std::string>& answers) {
    in_each_way([&] {
      sut.choose(transfer);
      const auto supply = SdoClient::Supply::to<&SdoClientOwnEnd::give>(*this);
      EXPECT_EQ(sut.download(5, 0x2008, 0, supply, 24, on_done), AbortCode::none);
      expect_end_after(answers);
    });
  }

 private:
  template <class Transfer>
  void in_each_way(Transfer transfer) {
    for (const End way : {End::cancelled, End::stopped}) {
      for (const AbortCode code : {AbortCode::none, AbortCode::hardware}) {
        SCOPED_TRACE(way == End::cancelled ? "cancelled" : "stopped");
        end = way;
        answered = code;
        transfer();
        wire.receive("000#80 01");
      }
    }
  }
  void expect_end_after(const std::vector<std::string>& answers) {
    for (const std::string& answer : answers) {
      EXPECT_TRUE(sut.busy());
      wire.sent.clear();
      wire.receive("585#" + answer);
    }
    EXPECT_FALSE(sut.busy());
    if (end == End::cancelled) {
      wire.expect({"605#80 08 20 00 00 00 00 08"});
    } else {
      wire.expect({});
      expect_failed(SdoEnd::cancelled(AbortCode::device_state));
    }
    wire.run_for(10s);
    wire.expect({});
    EXPECT_EQ(calls, 0);
  }

  std::array<std::uint8_t, SdoBlockClient::buffer_size> buffer_{};
  SdoBlockClient blocks_{sut, buffer_};
  End end = End::cancelled;
  AbortCode answered = AbortCode::none;
};

TEST_F(SdoClientOwnEnd, OfAnExpeditedUpload) {
  upload_until(SdoTransfer::segmented, {"4B 08 20 00 34 12 00 00"});
}

TEST_F(SdoClientOwnEnd, OfASegmentedUpload) {
  upload_until(SdoTransfer::segmented, {"40 08 20 00 00 00 00 00", "00 01 02 03 04 05 06 07"});
  upload_until(SdoTransfer::segmented, {"40 08 20 00 00 00 00 00", "01 01 02 03 04 05 06 07"});
}

TEST_F(SdoClientOwnEnd, OfABlockUploadInMidBlockAtItsEndAndAtTheEndOfAll) {
  upload_until(SdoTransfer::block,
               {"C0 08 20 00 00 00 00 00", "01 01 02 03 04 05 06 07", "02 08 09 0A 0B 0C 0D 0E"});
  upload_until(SdoTransfer::block,
               {"C0 08 20 00 00 00 00 00", "01 01 02 03 04 05 06 07", "82 08 09 0A 0B 0C 0D 0E"});
  upload_until(SdoTransfer::block,
               {"C0 08 20 00 00 00 00 00", "81 01 02 03 04 05 06 07", "C1 00 00 00 00 00 00 00"});
}

TEST_F(SdoClientOwnEnd, OfASegmentedDownload) {
  download_until(SdoTransfer::segmented, {"60 08 20 00 00 00 00 00"});
}

TEST_F(SdoClientOwnEnd, OfABlockDownload) {
  download_until(SdoTransfer::block, {"A0 08 20 00 7F 00 00 00"});
  download_until(SdoTransfer::block, {"A0 08 20 00 01 00 00 00"});
}

/// One worker, so that the next request begins during the call of the sink or supply of the first.
class SdoQueueOwnEnd : public testing::Test {
 protected:
  SdoQueueOwnEnd() {
    wire.boot();
    first.sink = SdoClient::Sink::to<&SdoQueueOwnEnd::take>(*this);
    first.supply = SdoClient::Supply::to<&SdoQueueOwnEnd::give>(*this);
  }
  AbortCode take(std::span<const std::uint8_t>) {
    sut.cancel(first);
    return AbortCode::hardware;
  }
  Result<std::size_t> give(std::span<std::uint8_t> piece) {
    sut.cancel(first);
    return piece.size();
  }

  WireNode wire{sdo_objects(), 1};
  SdoWorkers<1> workers{wire.node};
  SdoQueue sut{wire.node, workers.all()};
  std::array<std::uint8_t, 2> bytes{0x34, 0x12};
  SdoRequest first{.server = 5, .index = 0x2008};
  SdoRequest second{.server = 5, .index = 0x2002, .destination = bytes, .value = bytes};
};

TEST_F(SdoQueueOwnEnd, ASinkThatTakesItsRequestBackDoesNotDisturbTheNext) {
  for (const char* answer : {"43 08 20 00 01 02 03 04", "40 08 20 00 00 00 00 00"}) {
    EXPECT_TRUE(sut.upload(first));
    EXPECT_TRUE(sut.upload(second));
    wire.receive(std::string("585#") + answer);
    if (first.state() == SdoRequest::State::active) wire.receive("585#01 01 02 03 04 05 06 07");
    EXPECT_EQ(first.state(), SdoRequest::State::idle);
    EXPECT_EQ(second.state(), SdoRequest::State::active);
    wire.sent.clear();
    wire.receive("585#4B 02 20 00 78 56 00 00");
    wire.expect({});
    EXPECT_EQ(second.outcome().abort(), AbortCode::none);
    EXPECT_EQ(bytes[0], 0x78);
    EXPECT_TRUE(sut.idle());
  }
}

TEST_F(SdoQueueOwnEnd, ASupplyThatTakesItsRequestBackDoesNotDisturbTheNext) {
  EXPECT_TRUE(sut.download(first));
  EXPECT_TRUE(sut.download(second));
  wire.sent.clear();
  wire.receive("585#60 08 20 00 00 00 00 00");
  wire.expect({"605#80 08 20 00 00 00 00 08", "605#2B 02 20 00 34 12 00 00"});
  wire.receive("585#60 02 20 00 00 00 00 00");
  EXPECT_EQ(second.outcome().abort(), AbortCode::none);
  EXPECT_EQ(*second.outcome(), 2U);
  EXPECT_TRUE(sut.idle());
}

/// A server with a domain that stops or resets its node when it is read or written.
class SdoServerOwnEnd : public SdoServerNode {
 protected:
  SdoServerOwnEnd() {
    hook_.first = hook_.last = 0x2033;
    hook_.domain = &domain_;
    domain_.open_read = decltype(Domain::open_read)::to<&SdoServerOwnEnd::open>(*this);
    domain_.read = decltype(Domain::read)::to<&SdoServerOwnEnd::read>(*this);
    domain_.open_write = decltype(Domain::open_write)::to<&SdoServerOwnEnd::open_write>(*this);
    domain_.write = decltype(Domain::write)::to<&SdoServerOwnEnd::write>(*this);
    domain_.close_write = decltype(Domain::close_write)::to<&SdoServerOwnEnd::close>(*this);
    wire.node.dictionary().attach(hook_);
    refreshed_.first = 0x2002;
    refreshed_.last = 0x2008;
    refreshed_.before_read = decltype(Hook::before_read)::to<&SdoServerOwnEnd::refresh>(*this);
    wire.node.dictionary().attach(refreshed_);
  }
  Result<std::uint32_t> open(const Entry&) {
    if (ends_when_opened) bring_about();
    return 24U;
  }
  AbortCode refresh(const Entry&) {
    bring_about();
    return AbortCode::none;
  }
  Result<std::size_t> read(const Entry&, std::uint32_t, std::span<std::uint8_t> piece) {
    EXPECT_FALSE(ends_when_opened);
    bring_about();
    return piece.size();
  }
  AbortCode open_write(const Entry&, std::uint32_t) {
    ++open_writes;
    if (ends_when_opened) bring_about();
    return AbortCode::none;
  }
  AbortCode write(const Entry&, std::span<const std::uint8_t>) {
    EXPECT_FALSE(ends_when_opened);
    bring_about();
    return AbortCode::none;
  }
  AbortCode close(const Entry&, bool complete) {
    EXPECT_FALSE(complete);
    --open_writes;
    return AbortCode::none;
  }
  void bring_about() { wire.node.receive(wire_frame(command), wire.now); }
  /// The last request has no effect except the messages of the node when it boots.
  void expect_end_after(const std::vector<std::string>& requests) {
    for (const bool is_reset : {false, true}) {
      command = is_reset ? "000#82 05" : "000#02 05";
      for (const std::string& request : requests) {
        wire.sent.clear();
        wire.receive("605#" + request);
      }
      EXPECT_FALSE(sut.busy());
      EXPECT_EQ(open_writes, 0);
      wire.expect(is_reset ? std::vector<std::string>{"705#00"} : std::vector<std::string>{});
      wire.receive("000#80 05");
      wire.run_for(10s);
      wire.expect({});
      expect_alive();
    }
  }

 private:
  SdoBlockServer blocks_{sut};
  Domain domain_;
  Hook hook_;
  Hook refreshed_;
  const char* command = "";

 protected:
  bool ends_when_opened = false;
  int open_writes = 0;  ///< not closed yet
};

TEST_F(SdoServerOwnEnd, OfAnUploadAndADownloadThatAreOnlyBeingOpened) {
  ends_when_opened = true;
  expect_end_after({"40 33 20 00 00 00 00 00"});
  expect_end_after({"A0 33 20 00 7F 00 00 00"});
  expect_end_after({"20 33 20 00 00 00 00 00"});
  expect_end_after({"23 33 20 00 01 02 03 04"});
  expect_end_after({"C0 33 20 00 00 00 00 00"});
}

TEST_F(SdoServerOwnEnd, OfAnUploadOfAValueThatIsRefreshedFirst) {
  expect_end_after({"40 02 20 00 00 00 00 00"});
  expect_end_after({"40 08 20 00 00 00 00 00"});
  expect_end_after({"A0 08 20 00 7F 00 00 00"});
}

TEST_F(SdoServerOwnEnd, OfAnExpeditedDownloadOfADomain) {
  expect_end_after({"23 33 20 00 01 02 03 04"});
}

TEST_F(SdoServerOwnEnd, OfASegmentedDownload) {
  expect_end_after({"20 33 20 00 00 00 00 00", "00 01 02 03 04 05 06 07"});
  expect_end_after({"20 33 20 00 00 00 00 00", "01 01 02 03 04 05 06 07"});
}

TEST_F(SdoServerOwnEnd, OfASegmentedUpload) {
  expect_end_after({"40 33 20 00 00 00 00 00", "60 00 00 00 00 00 00 00"});
}

TEST_F(SdoServerOwnEnd, OfABlockDownloadAtTheEndOfABlockAndOfAll) {
  expect_end_after(
      {"C0 33 20 00 00 00 00 00", "01 01 02 03 04 05 06 07", "82 08 09 0A 0B 0C 0D 0E"});
  expect_end_after(
      {"C0 33 20 00 00 00 00 00", "81 01 02 03 04 05 06 07", "C1 00 00 00 00 00 00 00"});
}

TEST_F(SdoServerOwnEnd, OfABlockUpload) {
  expect_end_after({"A0 33 20 00 7F 00 00 00", "A3 00 00 00 00 00 00 00"});
}

}  // namespace
}  // namespace canvoy::sdo_own_end_test
