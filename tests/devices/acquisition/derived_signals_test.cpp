#include "devices/acquisition/derived_signals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::devices {
namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

std::vector<StreamLayout::Column> motor() {
    return {{"current.a", "A"}, {"current.b", "A"}, {"speed", "rad/s"}};
}

std::shared_ptr<const StreamLayout> layoutOf(const std::vector<std::string>& names) {
    auto layout = std::make_shared<StreamLayout>();
    for (const std::string& name : names) {
        layout->columns.push_back({name, "A"});
    }
    return layout;
}

SampleBlock block(const std::shared_ptr<const StreamLayout>& layout, std::vector<double> values) {
    SampleBlock made;
    made.layout = layout;
    for (std::size_t row = 0; row < values.size() / layout->columns.size(); ++row) {
        made.time_s.push_back(0.001 * static_cast<double>(row));
    }
    made.values = std::move(values);
    return made;
}

/// What a history is given for a block.
struct Written {
    std::shared_ptr<const StreamLayout> layout;
    std::vector<double> values; ///< row by row

    double value(std::size_t row, std::size_t column) const {
        return values[row * layout->columns.size() + column];
    }
};

Written with(DerivedSignals& signals, const SampleBlock& rows, BlockColumns columns = {}) {
    signals.addTo(columns, rows);
    Written written{columns.layout ? columns.layout : rows.layout, {}};
    for (std::size_t row = 0; row < rows.rows(); ++row) {
        for (const ColumnSource& source : columns.sources(rows)) {
            written.values.push_back(source.values[row * source.stride]);
        }
    }
    return written;
}

TEST(DerivedSignalsTest, addAColumnOfWhatTheExpressionSays) {
    DerivedSignals signals;
    signals.set({{"power", "current.a^2 + current.b^2", "A^2"}}, motor());
    const Written written =
        with(signals, block(layoutOf({"current.a", "speed", "current.b"}), {3.0, 7.0, 4.0, 1.0, 7.0, 0.5}));
    ASSERT_EQ(written.layout->columns.size(), 4U);
    EXPECT_EQ(written.layout->columns[3].name, "power");
    EXPECT_EQ(written.layout->columns[3].unit, "A^2");
    EXPECT_EQ(written.values, (std::vector<double>{3.0, 7.0, 4.0, 25.0, 1.0, 7.0, 0.5, 1.25}));
}

TEST(DerivedSignalsTest, blocksOfOneStreamKeepOneLayout) {
    DerivedSignals signals;
    signals.set({{"double", "2*speed", ""}}, motor());
    const auto layout = layoutOf({"speed"});
    const auto first = with(signals, block(layout, {1.0})).layout;
    EXPECT_EQ(with(signals, block(layout, {2.0})).layout, first);
    // Another stream with other columns; then the first again.
    EXPECT_EQ(with(signals, block(layoutOf({"current.a", "speed"}), {1.0, 5.0})).values.back(), 10.0);
    EXPECT_EQ(with(signals, block(layout, {3.0})).values.back(), 6.0);
}

TEST(DerivedSignalsTest, aBlockWithoutItsSourcesStaysAsItIs) {
    DerivedSignals signals;
    signals.set({{"double", "2*speed", ""}}, motor());
    const auto layout = layoutOf({"current.a"});
    EXPECT_EQ(with(signals, block(layout, {1.0})).layout, layout);
}

TEST(DerivedSignalsTest, whatIsNoNumberIsABreak) {
    DerivedSignals signals;
    signals.set({{"root", "sqrt(speed)", "1"}, {"inverse", "1/speed", ""}}, motor());
    const Written written = with(signals, block(layoutOf({"speed"}), {4.0, -1.0, 0.0, NaN}));
    EXPECT_EQ(written.value(0, 1), 2.0);
    EXPECT_EQ(written.value(0, 2), 0.25);
    EXPECT_TRUE(std::isnan(written.value(1, 1)));
    EXPECT_TRUE(std::isnan(written.value(2, 2)));
    EXPECT_TRUE(std::isnan(written.value(3, 1)));
}

TEST(DerivedSignalsTest, areComputedOfWhatIsShownAndNotOfWhatIsHidden) {
    DerivedSignals signals;
    signals.set({{"error", "reference - position", "rad"}}, {{"reference", "rad"}, {"position", "rad"}});
    const SampleBlock rows = block(layoutOf({"reference", "position"}), {0.0, 1.0, 3.0, 1.5});
    BlockColumns columns;
    columns.replaced[0] = {NaN, 3.0};
    const Written written = with(signals, rows, columns);
    EXPECT_TRUE(std::isnan(written.value(0, 0)));
    EXPECT_TRUE(std::isnan(written.value(0, 2)));
    EXPECT_EQ(written.value(1, 2), 1.5);
    EXPECT_EQ(rows.value(0, 0), 0.0);
}

TEST(DerivedSignalsTest, functionsAndPiAreThere) {
    DerivedSignals signals;
    signals.set({{"angle", "atan2(current.b, current.a) * 180 / pi", ""}}, motor());
    const Written written = with(signals, block(layoutOf({"current.a", "current.b"}), {0.0, 2.0}));
    EXPECT_NEAR(written.values.back(), 90.0, 1e-12);
}

TEST(DerivedSignalsTest, sayWhatTheyNeed) {
    const auto derivation = deriveSignal({"power", "current.a*current.a + current.b", "W"}, motor());
    ASSERT_TRUE(derivation);
    EXPECT_EQ(derivation->sources, (std::vector<std::string>{"current.a", "current.b"}));
    DerivedSignals signals;
    signals.set({{"power", "current.a*current.a + current.b", "W"}, {"wrong", "torque", ""}}, motor());
    ASSERT_EQ(signals.computed().size(), 1U); // the other waits
    EXPECT_EQ(signals.computed()[0].signal.unit, "W");
    EXPECT_EQ(signals.computed()[0].sources, derivation->sources);
}

TEST(DerivedSignalsTest, whatIsWrongIsRefusedWithItsPlace) {
    const auto said = [](const char* name, const char* expression) {
        const auto checked = deriveSignal({name, expression, "1"}, motor());
        return checked ? std::string() : checked.error().message;
    };
    EXPECT_EQ(said("x", "speed + * 2"), "column 9 of the expression: unexpected '*'");
    EXPECT_EQ(said("x", "2*(speed"), "column 9 of the expression: missing )");
    EXPECT_EQ(said("x", "2*"), "column 3 of the expression: unexpected end");
    EXPECT_EQ(said("x", "2*torque"), "column 3 of the expression: unknown signal 'torque'");
    EXPECT_EQ(said("x", "current.a + current"), "column 13 of the expression: unknown signal 'current'");
    EXPECT_NE(said("x", "2*3").find("contains no signal"), std::string::npos);
    EXPECT_NE(said("speed", "current.a").find("taken"), std::string::npos);
    EXPECT_NE(said("2x", "speed").find("not a valid signal name"), std::string::npos);
    EXPECT_NE(said("a b", "speed").find("not a valid signal name"), std::string::npos);
    EXPECT_FALSE(said("x", "").empty());
    EXPECT_FALSE(said("x", "sin()").empty());
    EXPECT_FALSE(said("x", "atan2(speed)").empty());
    EXPECT_FALSE(said("x", "speed current.a").empty());
    EXPECT_EQ(said("x", "speed = 3"), "column 7 of the expression: = is not an operator");
    EXPECT_NE(said("x", "speed, current.a").find("several"), std::string::npos);
    EXPECT_TRUE(said("x", "(speed >= 3) == (current.a != 1)").empty());
    EXPECT_EQ(said("x", "2*\u00b5 + speed"), "column 3 of the expression: unexpected 'µ + speed'");
    EXPECT_EQ(said("x", "speed > 1 ? 2"), "column 11 of the expression: missing :");
    EXPECT_EQ(said("x", (std::string(1000, ' ') + "speed").c_str()),
              "the expression has more than 1000 characters");
}

TEST(DerivedSignalsTest, columnsOfARecordingStayDifferent) {
    const auto said = [](const char* name, const char* unit) {
        const auto checked = deriveSignal({name, "2*speed", unit}, motor());
        return checked ? std::string() : checked.error().message;
    };
    EXPECT_EQ(said("current_a", "A"), "the name 'current_a' is taken"); // both are current_a_A
    EXPECT_EQ(said("current_a_A", ""), "");                             // in rad/s: current_a_A_rad_s
    EXPECT_EQ(said("current_a_A", "1"), "the name 'current_a_A' is taken");
    EXPECT_EQ(said("time", "s"), "the name 'time' is taken");
    EXPECT_EQ(said("current_a", "rad"), "");
}

TEST(DerivedSignalsTest, theUnitFollowsOrIsAskedFor) {
    const auto unit = [](const char* expression) {
        const auto derivation = deriveSignal({"x", expression, ""}, motor());
        return derivation ? derivation->unit : derivation.error().message;
    };
    EXPECT_EQ(unit("sqrt(current.a^2 + current.b^2)"), "A");
    EXPECT_EQ(unit("current.a^2 + current.b^2"), "A^2");
    EXPECT_EQ(unit("current.a/current.b"), "1");
    EXPECT_EQ(unit("speed + current.a"), "the unit of the expression cannot be determined");
}

TEST(DerivedSignalsTest, oneIsWrittenOnALine) {
    const auto plain = parseDerivedSignal(" field = sqrt(a^2+b^2) ");
    ASSERT_TRUE(plain);
    EXPECT_EQ(*plain, (DerivedSignal{"field", "sqrt(a^2+b^2)", ""}));
    const auto withUnit = parseDerivedSignal("fast [1] = speed == 3");
    ASSERT_TRUE(withUnit);
    EXPECT_EQ(*withUnit, (DerivedSignal{"fast", "speed == 3", "1"}));
    for (const char* wrong : {"", "x", "x =", "= speed", "[A] = speed"}) {
        EXPECT_FALSE(parseDerivedSignal(wrong)) << wrong;
    }
}

TEST(DerivedSignalsTest, aRecordingGetsColumnsAndLaterOnesUseEarlierOnes) {
    Recording recording;
    recording.layout = layoutOf({"current.a", "current.b"});
    recording.time_s = {0.0, 0.1};
    recording.values = {3.0, 4.0, NaN, 1.0};
    const auto longer =
        withDerived(recording, {{"square", "current.a^2 + current.b^2", ""}, {"length", "sqrt(square)", ""}});
    ASSERT_TRUE(longer);
    ASSERT_EQ(longer->layout->columns.size(), 4U);
    EXPECT_EQ(longer->layout->columns[2].unit, "A^2");
    EXPECT_EQ(longer->layout->columns[3].unit, "A");
    EXPECT_EQ(longer->column("length")[0], 5.0);
    EXPECT_TRUE(std::isnan(longer->column("length")[1]));
    EXPECT_EQ(longer->column("current.b"), (std::vector<double>{4.0, 1.0}));
    const auto wrong = withDerived(recording, {{"x", "hall.a", ""}});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().message, "x: column 1 of the expression: unknown signal 'hall.a'");
}

} // namespace
} // namespace halbench::devices
