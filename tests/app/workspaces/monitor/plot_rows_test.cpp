#include "app/workspaces/monitor/plot_rows.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

void append(control::SampleHistory& history, std::vector<StreamLayout::Column> columns, double begin_s,
            double period_s, std::size_t rows, double offset) {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = std::move(columns);
    layout->period_s = period_s;
    SampleBlock block;
    block.layout = layout;
    for (std::size_t row = 0; row < rows; ++row) {
        block.time_s.push_back(begin_s + static_cast<double>(row) * period_s);
        for (std::size_t column = 0; column < layout->columns.size(); ++column) {
            block.values.push_back(offset + static_cast<double>(row) / 3.0 +
                                   100.0 * static_cast<double>(column));
        }
    }
    history.append(block);
}

widgets::PlotSpec plotOf(const std::vector<std::string>& signals, double factor = 1.0) {
    widgets::PlotSpec plot;
    for (const std::string& name : signals) {
        widgets::PlotCurve curve;
        curve.signal = name;
        curve.label = QString::fromStdString(name).toUpper();
        curve.unit = QStringLiteral("mT");
        curve.factor = factor;
        plot.curves.push_back(curve);
    }
    return plot;
}

TEST(PlotRows, areTheSamplesOfTheStretchWithBothEndsInTheOrderOfThePlots) {
    control::SampleHistory history(std::size_t{1} << 24);
    append(history, {{"a", "T"}, {"b", "A"}, {"c", "V"}}, 0.0, 0.001, 1000, 0.0);
    const auto rows = plotRows({plotOf({"c"}), plotOf({"a", "c"})}, history, {0.1, 0.2});
    ASSERT_TRUE(rows) << rows.error().message;
    ASSERT_EQ(rows->rows(), 101U);
    ASSERT_EQ(rows->layout->columns.size(), 2U); // c once, b not at all
    EXPECT_EQ(rows->layout->columns[0].name, "c");
    EXPECT_EQ(rows->layout->columns[1].unit, "T");
    EXPECT_DOUBLE_EQ(rows->layout->period_s, 0.001);
    for (std::size_t i = 0; i < rows->rows(); ++i) {
        const auto row = static_cast<double>(100 + i);
        EXPECT_EQ(rows->time_s[i], row * 0.001);
        EXPECT_EQ(rows->values[2 * i], row / 3.0 + 200.0); // every digit
        EXPECT_EQ(rows->values[2 * i + 1], row / 3.0);
    }
}

TEST(PlotRows, aSignalThatCameLaterHasNoValueBefore) {
    control::SampleHistory history(std::size_t{1} << 24);
    append(history, {{"a", "T"}}, 0.0, 0.01, 100, 0.0);
    append(history, {{"a", "T"}, {"b", "A"}}, 1.0, 0.01, 100, 5.0);
    const auto rows = plotRows({plotOf({"a", "b"})}, history, {0.985, 1.015});
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->rows(), 3U); // 0.99, 1.00, 1.01
    EXPECT_TRUE(std::isnan(rows->values[1]));
    EXPECT_EQ(rows->values[3], 105.0);
    EXPECT_EQ(rows->values[2], 5.0);
}

TEST(PlotRows, refusesNothingAndTooMuch) {
    control::SampleHistory history(std::size_t{1} << 24);
    EXPECT_EQ(plotRows({plotOf({"a"})}, history, {0.0, 1.0}).error().code, ErrorCode::OutOfRange);
    append(history, {{"a", "T"}}, 0.0, 0.001, 1000, 0.0);
    EXPECT_EQ(plotRows({plotOf({"a"})}, history, {5.0, 6.0}).error().code, ErrorCode::OutOfRange);
    const auto much = plotRows({plotOf({"a"})}, history, {0.0, 1.0}, 999);
    ASSERT_FALSE(much);
    EXPECT_NE(much.error().message.find("1000 values"), std::string::npos) << much.error().message;
}

TEST(PlotRows, theTableHasNamesUnitsAndValuesAsShown) {
    control::SampleHistory history(std::size_t{1} << 24);
    append(history, {{"a", "T"}}, 0.0, 0.5, 3, 0.25);
    const std::vector<widgets::PlotSpec> plots{plotOf({"a"}, 1000.0)};
    const auto rows = plotRows(plots, history, {0.0, 0.6});
    ASSERT_TRUE(rows);
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(plotTable(*rows, plots), "time\tA\ns\tmT\n0\t250\n0.5\t583.333333333333\n");
    QLocale::setDefault(QLocale(QLocale::German));
    EXPECT_TRUE(plotTable(*rows, plots).contains("0,5\t583,333333333333"));
    QLocale::setDefault(QLocale::c());
}

} // namespace
} // namespace halbench::app
