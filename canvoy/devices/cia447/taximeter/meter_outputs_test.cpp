// Commands of a taximeter to other devices, at the wire: it is node 5, its tariff display node 6
// (requests on 656h, answers on 5D6h: facts 2.2), its printer node 3.
#include "canvoy/devices/cia447/taximeter/meter_outputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "canvoy/devices/cia447/kit/car_bench_test.hpp"
#include "canvoy/devices/cia447/printer/printer_unit.hpp"

namespace canvoy::cia447::meter_outputs_test {
namespace {

class Outputs {
 public:
  explicit Outputs(const MeterOutputs::Settings& wanted)
      : settings(wanted), bench(only_unit<PrinterKind>, [this](Environment& environment) {
          environment.watch(callback<&Outputs::made>(*this));
        }) {
    bench.cable.run_for(100ms);
    bench.cable.clear();
  }
  ~Outputs() { outputs.reset(); }  // before the bench, as it uses the network of the bench
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Requests of this node to that one.
  std::string last_to(NodeId node) {
    const std::string frame = bench.cable.last(sdo_request(5, node));
    return frame.substr(frame.find('#') + 1);
  }
  void answer(NodeId node, const std::string& data) {
    char id[8];
    std::snprintf(id, sizeof id, "%03X#", static_cast<unsigned>(sdo_response(5, node)));
    bench.cable.send(id + data);
  }
  /// All but heartbeats.
  std::ptrdiff_t frames() const {
    return std::ranges::count_if(bench.cable.heard,
                                 [](const Cable::Heard& heard) { return heard.frame.id != 0x705; });
  }

  MeterOutputs::Settings settings;
  std::optional<MeterOutputs> outputs;
  CarBench bench;

 private:
  void made(CarNetwork& network, Node& /*node*/) { outputs.emplace(network, settings); }
};

constexpr TaximeterDisplay vacant = {.state = Taximeter::for_hire, .trip = {.level = {'1', 'A'}}};

// 4.2.16.7: four bits a lamp, lamp 1 is the taxi light and lamp 2 that of a vacant taxi; Fh leaves
// a lamp as it is.
TEST(MeterOutputsWire, TheSignIsToldLampsAndThenTheLevel) {
  Outputs meter({.sign = 6});
  meter.outputs->show(vacant);
  meter.bench.cable.run_for(0s);
  EXPECT_EQ(meter.last_to(6), "23 06 61 00 11 FF FF FF");
  meter.answer(6, "60 06 61 00 00 00 00 00");
  EXPECT_EQ(meter.last_to(6), "2B D3 60 00 31 41 00 00");
  meter.answer(6, "60 D3 60 00 00 00 00 00");
  meter.bench.cable.clear();
  TaximeterDisplay hired = vacant;
  hired.state = Taximeter::hired;
  meter.outputs->show(hired);
  meter.bench.cable.run_for(0s);
  EXPECT_EQ(meter.last_to(6), "23 06 61 00 01 FF FF FF") << "the taxi light alone";
}

TEST(MeterOutputsWire, ASignThatRefusesIsToldAgain) {
  Outputs meter({.sign = 6});
  meter.outputs->show(vacant);
  meter.bench.cable.run_for(0s);
  meter.answer(6, "80 06 61 00 22 00 00 08");
  meter.bench.cable.clear();
  meter.bench.cable.run_for(1999ms);
  EXPECT_EQ(meter.last_to(6), "");
  meter.bench.cable.run_for(1ms);
  EXPECT_EQ(meter.last_to(6), "23 06 61 00 11 FF FF FF");
}

TEST(MeterOutputsWire, AReceiptIsPrinted) {
  Outputs meter({.printer = 3});
  meter.outputs->print("EUR\n");
  meter.bench.cable.run_for(0s);
  EXPECT_EQ(meter.last_to(3), "23 EB 60 00 45 55 52 0A");
  EXPECT_TRUE(meter.outputs->is_printing());
  meter.answer(3, "60 EB 60 00 00 00 00 00");
  EXPECT_FALSE(meter.outputs->is_printing());
  EXPECT_EQ(meter.outputs->printed(), 1u);
}

/// A receipt may wait for paper without limit, and a sign that lost its power for a moment for its
/// lights (4.2.16.7): it gets them again every 10 s.
TEST(MeterOutputsWire, TheSignIsRenewedWhileAReceiptWaits) {
  for (const NodeId printer : {NodeId{3}, NodeId{0}}) {
    Outputs meter({.printer = printer, .sign = 6});
    meter.outputs->print("EUR\n");
    meter.outputs->show(vacant);
    meter.bench.cable.run_for(0s);
    ASSERT_EQ(meter.last_to(6), "23 06 61 00 11 FF FF FF");
    meter.answer(6, "60 06 61 00 00 00 00 00");
    meter.answer(6, "60 D3 60 00 00 00 00 00");
    meter.bench.cable.clear();
    for (int second = 1; second < 10; ++second) {
      meter.answer(3, "80 EB 60 00 22 00 00 08");
      meter.bench.cable.send("706#05");
      meter.bench.cable.run_for(1s);
    }
    EXPECT_EQ(meter.last_to(6), "");
    meter.answer(3, "80 EB 60 00 22 00 00 08");
    meter.bench.cable.run_for(1s);
    EXPECT_EQ(meter.last_to(6), "23 06 61 00 11 FF FF FF");
  }
}

TEST(MeterOutputsWire, WhoIsNotThereIsToldNothing) {
  Outputs none({});
  none.outputs->show(vacant);
  none.outputs->print("EUR\n");
  none.bench.cable.run_for(1min);
  EXPECT_EQ(none.frames(), 0);
  EXPECT_EQ(none.outputs->printed(), 0u);
}

}  // namespace
}  // namespace canvoy::cia447::meter_outputs_test
