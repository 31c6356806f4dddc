#include "canvoy/tools/log/plot_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace canvoy::tools {
namespace plot_series_test {

TEST(PlotSeries, ItKeepsThePeakOfAYearInAsMuchRoomAsASecondTakes) {
  PlotSeries series("level", "%");
  for (int i = 0; i < 1'000'000; ++i) series.add(i * 31.5, i == 123'456 ? 99 : 1);
  const auto spans = series.spans();
  EXPECT_LE(spans.size(), 2048U);
  const auto peak = std::ranges::max_element(spans, {}, &PlotSeries::Span::most);
  EXPECT_EQ(peak->most, 99);
  EXPECT_EQ(peak->least, 1);
  EXPECT_NEAR(peak->time, 123'456 * 31.5, 31.5 * 1'000'000 / 1000);
}

TEST(PlotSeries, ATimeThatGoesBackAndNoNumberDoNoHarm) {
  PlotSeries series("level", "%");
  series.add(10, 1);
  series.add(5, 2);
  series.add(11, std::numeric_limits<double>::quiet_NaN());
  ASSERT_EQ(series.spans().size(), 1U);
  EXPECT_EQ(series.spans()[0].most, 2);
}

TEST(PlotSeries, MarksAreRoundNumbers) {
  const PlotAxis axis = plot_axis(20.3, 59.1, 5);
  EXPECT_EQ(axis.low, 20);
  EXPECT_EQ(axis.high, 60);
  EXPECT_EQ(axis.marks, (std::vector<double>{20, 30, 40, 50, 60}));
  const PlotAxis flat = plot_axis(5, 5, 5);
  EXPECT_LT(flat.low, 5);
  EXPECT_GT(flat.high, 5);
}

TEST(PlotSeries, ValuesOfOneUnitShareADiagram) {
  const std::vector<PlotSeries> series = {{"a", "V"}, {"b", "A"}, {"c", "V"}};
  const auto panels = plot_panels(series);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].size(), 2U);
}

TEST(PlotText, ALineRisesFromTheLowestDotToTheHighest) {
  PlotSeries series("a", "V");
  series.add(0, 0);
  series.add(1, 10);
  const std::string text = plot_text(std::vector{series}, 30, 10);
  EXPECT_TRUE(text.starts_with("a, V\n"));
  EXPECT_NE(text.find("       10 "), std::string::npos);
  // The last two dots are at the top of the right edge: U+2809.
  EXPECT_NE(text.find("\xE2\xA0\x89\n"), std::string::npos) << text;
}

}  // namespace plot_series_test
}  // namespace canvoy::tools
